// Delimiter: in the first record, or named by the first line, however the bytes arrive.
#include "read/csv/delimiter.hpp"

#include <gtest/gtest.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

TEST(DelimiterOf, is_the_first_of_tab_semicolon_comma_and_blank_in_the_record) {
  EXPECT_EQ(delimiter_of("a b,c;d\te\n", '.'), '\t');
  EXPECT_EQ(delimiter_of("a b,c;d\n1\t2", '.'), ';');
  EXPECT_EQ(delimiter_of("a b,c\n1;2", '.'), ',');
  EXPECT_EQ(delimiter_of("a b\n1,2", '.'), ' ');
  EXPECT_EQ(delimiter_of("a\n1;2", '.'), ',');
  EXPECT_EQ(delimiter_of("", '.'), std::nullopt);
  EXPECT_EQ(delimiter_of("a;b", '.'), std::nullopt) << "more cells may follow";
  EXPECT_EQ(delimiter_of("\"a\n", '.'), std::nullopt) << "the line end is inside quotes";
  EXPECT_EQ(delimiter_of("\"t\";\"x\"\n0;1\n", '.'), ';');
}

TEST(DelimiterOf, with_a_decimal_comma_the_comma_comes_last) {
  EXPECT_EQ(delimiter_of("0,5 1,5\n", ','), ' ');
  EXPECT_EQ(delimiter_of("0,5;1,5\n", ','), ';');
  EXPECT_EQ(delimiter_of("0,5\n", ','), ',');
}

/// "DELIMITER LINE TEXT" for text in pieces of any size; the text is what was read by then.
std::string found(const std::string& text, const std::string& start, std::uint64_t line) {
  std::string result;
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    const Beginning beginning = find_delimiter(pieces(text, piece), {});
    EXPECT_TRUE(beginning.text.starts_with(start)) << beginning.text << " in pieces of " << piece;
    EXPECT_EQ(beginning.line, line) << text << " in pieces of " << piece;
    const std::string one(1, beginning.delimiter);
    EXPECT_TRUE(result.empty() || result == one) << text << " in pieces of " << piece;
    result = one;
  }
  return result;
}

TEST(FindDelimiter, reads_the_first_record_and_drops_the_lines_before) {
  EXPECT_EQ(found("\n# a\tb\n1;2\n", "# a\tb\n1;2\n", 2), ";");
  EXPECT_EQ(found("# a,b\n\n1;2\n", "1;2\n", 3), ";");
  EXPECT_EQ(found("# a\r\n# b\r\n > c,d\r\n1\t2\r\n", "# b\r\n > c,d\r\n1\t2\r\n", 2), "\t");
  EXPECT_EQ(found("a b", "a b", 1), " ");
}

TEST(NamedDelimiter, is_that_of_a_first_line_of_its_own) {
  const auto named = [](const std::string& text, std::size_t piece, const std::string& rest) {
    Source<std::string> bytes = pieces(text, piece);
    const std::optional<char> delimiter = take_named_delimiter(bytes);
    std::string left;
    while (const auto more = bytes()) left += *more;
    EXPECT_EQ(left, rest) << text << " in pieces of " << piece;
    return delimiter.value_or('?');
  };
  for (const std::size_t piece : {1U, 5U, 6U, 100U}) {
    EXPECT_EQ(named("sep=;\nt;x\n", piece, "t;x\n"), ';');
    EXPECT_EQ(named("SEP=|\r\nt|x\n", piece, "t|x\n"), '|');
    for (const std::string text : {"sep=;", "sep=\nt\n", "sep=;;\nt\n", "sep,x\n", "s", "", "\nsep=;\n"}) {
      EXPECT_EQ(named(text, piece, text), '?') << text;
    }
  }
}

TEST(FindDelimiter, many_lines_before_the_first_record_are_not_kept) {
  int left = 300;
  const Source<std::string> lines = [&]() -> std::optional<std::string> {
    if (--left < 0) return std::nullopt;
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += left == 0 ? "1;2\n" : "#\n";
    return text;
  };
  const Beginning beginning = find_delimiter(lines, {});
  EXPECT_EQ(beginning.line, 299 * 100'000U);
  EXPECT_LT(beginning.text.size(), 1'000'000U);
}

}  // namespace
}  // namespace tcb
