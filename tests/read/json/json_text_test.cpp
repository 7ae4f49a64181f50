// JSON text: its pieces are read as one, and places are found in them.
#include "read/json/json_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcb {
namespace {

std::string read_whole(const JsonText::Pieces& pieces) {
  JsonText text(pieces);
  std::string read;
  for (JsonText::Iterator at(text); !(at == JsonText::Iterator()); ++at) read += *at;
  return read;
}

TEST(JsonText, pieces_are_read_as_one_text) {
  EXPECT_EQ(read_whole({"[", "1,2", "]"}), "[1,2]");
  EXPECT_EQ(read_whole({"[", "", "]"}), "[]");
  EXPECT_EQ(read_whole({"", "1"}), "1");
  EXPECT_EQ(read_whole({"12"}), "12");
  EXPECT_EQ(read_whole({}), "");
}

TEST(JsonText, bytes_are_found_in_their_piece) {
  const std::string keys = "1,2";
  const JsonText text({"[", keys, "]"});
  EXPECT_EQ(text.size(), 5U);
  EXPECT_EQ(text.byte(1), keys.data());
  EXPECT_EQ(text.byte(3), keys.data() + 2);
  EXPECT_EQ(*text.byte(4), ']');
  EXPECT_EQ(text.byte(5), text.byte(4) + 1) << "the end";
  EXPECT_EQ(text.byte(9), text.byte(4) + 1);
}

TEST(JsonText, the_rest_begins_after_blanks_and_goes_on_in_the_next_piece) {
  const std::string keys = "1 , 2 ";
  const JsonText text({"[", keys, "]"});
  EXPECT_EQ(text.rest(keys.data()), "1 , 2 ");
  EXPECT_EQ(text.rest(keys.data() + 1), ", 2 ");
  EXPECT_EQ(text.rest(keys.data() + 5), "]");
  EXPECT_EQ(text.rest(text.byte(7) + 1), "");
}

}  // namespace
}  // namespace tcb
