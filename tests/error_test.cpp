// Errors: text with and without a position, and the file name that is added later.
#include "error.hpp"

#include <gtest/gtest.h>

#include "io/terminal.hpp"

namespace tcb {
namespace {

Error error_with(const std::string& message, Exit exit = Exit::data, const TextPosition& position = {}) {
  return Error(exit, message).at(position);
}

TEST(Errors, the_text_has_the_position_as_far_as_it_is_known) {
  EXPECT_EQ(error_text(error_with("wrong", Exit::data, TextPosition{"a.csv", 17, 3})), "a.csv:17:3: error: wrong");
  EXPECT_EQ(error_text(error_with("wrong", Exit::data, TextPosition{"a.csv", 17, 0})), "a.csv:17: error: wrong");
  EXPECT_EQ(error_text(error_with("wrong", Exit::data, TextPosition{"a.csv", 0, 0})), "a.csv: error: wrong");
  EXPECT_EQ(error_text(error_with("wrong", Exit::data, TextPosition{"a.csv", 0, 3})), "a.csv: error: wrong")
      << "no column without a line";
}

TEST(Errors, without_a_file_the_program_is_named) {
  EXPECT_EQ(error_text(error_with("wrong", Exit::usage)), "tcbsample: error: wrong");
  EXPECT_EQ(error_text(error_with("wrong", Exit::data, TextPosition{"", 17, 3})), "tcbsample: error: wrong");
}

TEST(Errors, a_file_is_filled_in_once_and_nothing_else_changes) {
  const Error error = error_with("wrong", Exit::data, {"", 17, 3});
  EXPECT_EQ(error_text(error.in("a.csv")), "a.csv:17:3: error: wrong");
  EXPECT_EQ(error_text(error.in("a.csv").in("b.csv")), "a.csv:17:3: error: wrong");
  EXPECT_EQ(error.in("a.csv").exit(), Exit::data);
  EXPECT_EQ(error_text(error), "tcbsample: error: wrong") << "the error itself stays as it was";
}

TEST(Errors, a_position_is_filled_in_if_there_is_none) {
  const Error error = error_with("wrong");
  EXPECT_EQ(error_text(error.at({"", 17, 3}).in("a.csv")), "a.csv:17:3: error: wrong");
  EXPECT_EQ(error_text(error.in("a.csv").at({"", 17, 3})), "a.csv:17:3: error: wrong");
  EXPECT_EQ(error_text(error.at({"b.csv", 17, 0}).in("a.csv")), "b.csv:17: error: wrong");
  EXPECT_EQ(error_text(error.at({"", 17, 3}).at({"", 1, 1}).in("a.csv")), "a.csv:17:3: error: wrong");
}

TEST(Errors, each_is_one_line) {
  EXPECT_EQ(error_text(error_with("a column \"x\r\n\x1b[1m\x7f\"", Exit::data, {"a\nb", 1, 2})),
            "a\\x0Ab:1:2: error: a column \"x\\x0D\\x0A\\x1B[1m\\x7F\"");
}

TEST(Errors, exit_codes_are_those_of_the_manual) {
  EXPECT_EQ(static_cast<int>(Exit::done), 0);
  EXPECT_EQ(static_cast<int>(Exit::data), 1);
  EXPECT_EQ(static_cast<int>(Exit::usage), 2);
  EXPECT_EQ(static_cast<int>(Exit::interrupted), 130);
  EXPECT_EQ(error_with("wrong", Exit::usage).exit(), Exit::usage);
}

}  // namespace
}  // namespace tcb
