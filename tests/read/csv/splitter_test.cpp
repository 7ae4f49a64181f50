// Splitter: the delimiter, and chunks of whole records, however the bytes arrive.
#include "read/csv/splitter.hpp"

#include <gmock/gmock.h>

#include "read/csv/records.hpp"

namespace tcb {
namespace {

std::vector<std::string> texts_of(const std::vector<Chunk>& chunks) {
  std::vector<std::string> texts;
  for (const Chunk& chunk : chunks) texts.push_back(chunk.text);
  return texts;
}

const char* const texts[] = {"0,1\n2,3\n",          "0,1\r\n2,3",        "\"a\nb\",1\n\"c\"\"\n\",2\n",
                             "# it\"s\n0,1\n2,3\n", "\n\n0,1\n#\n\n2,3", "0,\"\"\n1,\"a\r\n\r\nb\"\r\n"};

TEST(SplitDelimited, chunks_are_the_text_cut_between_records_with_their_first_lines) {
  for (const std::string text : texts) {
    const RecordTexts whole = table(text);
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      std::string joined;
      RecordTexts rows;
      for (const Chunk& chunk : chunks(text, piece)) {
        EXPECT_EQ(chunk.line, 1U + static_cast<std::uint64_t>(std::ranges::count(joined, '\n'))) << text;
        joined += chunk.text;
        for (auto& row : table(chunk.text)) rows.push_back(std::move(row));
      }
      EXPECT_EQ(joined, text);
      EXPECT_EQ(rows, whole) << text << " in pieces of " << piece;
    }
  }
}

TEST(SplitDelimited, quotes_after_a_quoted_cell_open_no_cell) {
  for (const std::string line : {"\"\"a,\"", "\"a\"b,\"c", "\"a\" \r,\"", "\"a\" b\"", "\"\" \"\",\""}) {
    const std::string text = line + "\n1,2\n3,4\n";
    EXPECT_THAT(texts_of(chunks(text, 1)), testing::ElementsAre(line + "\n", "1,2\n", "3,4\n")) << text;
  }
}

TEST(SplitDelimited, a_record_is_passed_on_as_soon_as_its_line_ends) {
  std::vector<std::string> arriving{"3\n", "2,", "0,1\n"};
  const auto source = split_delimited(
      [&]() -> std::optional<std::string> {
        if (arriving.empty()) return std::nullopt;
        std::string piece = arriving.back();
        arriving.pop_back();
        return piece;
      },
      {});
  EXPECT_EQ(source()->text, "0,1\n");
  EXPECT_EQ(arriving.size(), 2U) << "nothing more was pulled";
  EXPECT_EQ(source()->text, "2,3\n");
  EXPECT_FALSE(source());
}

// Splitting and parsing have to agree on which quotes mean something.
TEST(SplitDelimited, a_quote_in_an_indented_comment_or_inside_a_cell_has_no_effect) {
  for (const std::string text : {"  # 5\" tall\n0,\"a\nb\"\n1,c\n", "0,5\"\n1,\"a\nb\"\n2,c\n"}) {
    RecordTexts rows;
    EXPECT_EQ(error_of([&] {
                for (const Chunk& chunk : chunks(text, std::string::npos)) {
                  for (auto& row : table(chunk.text)) rows.push_back(std::move(row));
                }
              }),
              "no error");
    EXPECT_EQ(rows, table(text));
  }
}

TEST(SplitDelimited, a_quote_left_open_is_an_error_at_64_mib) {
  const auto endless = [first = true]() mutable -> std::optional<std::string> {
    return std::exchange(first, false) ? "0,1\n\"" : std::string(16U << 20U, '\n');
  };
  EXPECT_EQ(
      error_of([&] {
        const auto source = split_delimited(endless, {});
        while (source()) {
        }
      }),
      "f:2:1: error: a record has more than 64 MiB; expected a line for each key; break the lines, or close a quote "
      "that was left open");
}

TEST(DelimiterOf, is_the_first_of_tab_semicolon_comma_and_blank_in_the_record) {
  EXPECT_EQ(delimiter_of("a b,c;d\te\n", '.'), '\t');
  EXPECT_EQ(delimiter_of("a b,c;d\n1\t2", '.'), ';');
  EXPECT_EQ(delimiter_of("a b,c\n1;2", '.'), ',');
  EXPECT_EQ(delimiter_of("a b\n1,2", '.'), ' ');
  EXPECT_EQ(delimiter_of("a b|c d\n1,2", '.'), '|');
  EXPECT_EQ(delimiter_of("| a | b |\n", '.'), '|');
  EXPECT_EQ(delimiter_of("t |v|\n", '.'), ' ') << "bars of a name";
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
    const Beginning beginning = find_delimiter(pieces(text, piece), {}, {});
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
  EXPECT_EQ(found("# a\r\n# b\r\n > c,d\r\n1\t2\r\n", "# a\r\n# b\r\n > c,d\r\n1\t2\r\n", 1), "\t");
  EXPECT_EQ(found("# a\n# b\n# c\n1\t2\n", "# b\n# c\n1\t2\n", 2), "\t");
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
  const Beginning beginning = find_delimiter(lines, {}, {});
  EXPECT_EQ(beginning.line, 299 * 100'000U - 1) << "two are kept";
  EXPECT_LT(beginning.text.size(), 1'000'000U);
}

}  // namespace
}  // namespace tcb
