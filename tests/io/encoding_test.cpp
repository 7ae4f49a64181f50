// Encodings: text in parts of any size becomes UTF-8, and other bytes are refused.
#include "io/encoding.hpp"

#include <gtest/gtest.h>

#include <string>

#include "error.hpp"

namespace tcb {
namespace {

using namespace std::string_literals;

/// The text of bytes with a mark, in parts of a size.
Source<std::string> in_parts(const std::string& bytes, std::size_t size) {
  return in_utf8(
      [&bytes, size, at = std::size_t{0}]() mutable -> std::optional<std::string> {
        if (at >= bytes.size()) return std::nullopt;
        return bytes.substr(std::exchange(at, at + size), size);
      },
      encoding_of_mark(bytes));
}

std::string converted(const std::string& bytes, std::size_t size) {
  const auto source = in_parts(bytes, size);
  std::string text;
  while (const auto part = source()) text += *part;
  return text;
}

TEST(Encoding, follows_from_the_mark) {
  EXPECT_EQ(encoding_of_mark("\xFF\xFEt\0"s), Encoding::utf16);
  EXPECT_EQ(encoding_of_mark("\xFE\xFF\0t"s), Encoding::utf16);
  EXPECT_EQ(encoding_of_mark("\xFF\xFE\0\0"s), Encoding::utf32);
  EXPECT_EQ(encoding_of_mark("\0\0\xFE\xFF"s), Encoding::utf32);
  EXPECT_EQ(encoding_of_mark("\xEF\xBB\xBFt"), Encoding::utf8);
}

TEST(Encoding, parts_of_any_size_give_the_same_text) {
  // U+20AC, and U+1D11E as a pair of surrogates.
  const std::string low = "\xFF\xFEt\0\xAC\x20\x34\xD8\x1E\xDD\n\0"s, high = "\xFE\xFF\0t\x20\xAC\xD8\x34\xDD\x1E\0\n"s;
  for (std::size_t size = 1; size < 15; ++size) {
    EXPECT_EQ(converted(low, size), "t\u20AC\U0001D11E\n") << size;
    EXPECT_EQ(converted(high, size), "t\u20AC\U0001D11E\n") << size;
  }
}

TEST(Encoding, other_bytes_are_refused) {
  EXPECT_THROW(converted("\xFF\xFEt"s, 8), Error);
  EXPECT_THROW(converted("\xFF\xFE\x1E\xDD\x1E\xDD"s, 8), Error);
}

TEST(Encoding, the_text_before_other_bytes_comes_first) {
  const std::string bytes = "\xFF\xFEt\0\n\0\x1E\xDD\x1E\xDD"s;  // a surrogate without its first half
  for (std::size_t size = 1; size < 12; ++size) {
    std::string text;
    const auto source = in_parts(bytes, size);
    const auto read = [&] {
      while (const auto part = source()) text += *part;
    };
    EXPECT_THROW(read(), Error) << size;
    EXPECT_EQ(text, "t\n") << size;
  }
}

TEST(Encoding, texts_of_spreadsheets_are_windows_1252) {
  EXPECT_EQ(in_utf8("H\xF6he \x80", Encoding::windows_1252), "H\u00F6he \u20AC");
  EXPECT_FALSE(in_utf8("\x81", Encoding::windows_1252));  // which has no character there
}

}  // namespace
}  // namespace tcb
