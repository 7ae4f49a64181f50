// Tokenizer: records, their cells and text positions, and why a cell is not a number.
#include "read/csv/tokenizer.hpp"

#include <gmock/gmock.h>

#include "read/csv/records.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
TEST(Tokenizer, lines_end_in_lf_or_crlf_and_the_last_may_lack_it) {
  const RecordTexts expected{{"0", "1"}, {"2", "3"}};
  for (const char* text : {"0,1\n2,3\n", "0,1\r\n2,3\r\n", "0,1\n2,3", "0,1\r\n2,3\r", "0,1\r\n2,3"}) {
    EXPECT_EQ(table(text), expected) << text;
  }
}

TEST(Tokenizer, cells_of_any_length_end_at_any_delimiter) {
  for (const char delimiter : {',', ';', '\x7F', '\x80', '\xA7', '\xFF', '\1'}) {
    Dialect dialect;
    dialect.delimiter = delimiter;
    for (std::size_t first = 0; first < 20; ++first) {
      for (std::size_t second = 1; second < 20; ++second) {
        const std::vector<std::string> row{std::string(first, 'a'), std::string(second, '-')};
        const std::string text = row[0] + delimiter + row[1];
        EXPECT_EQ(table(text + '\n' + text, dialect), (RecordTexts{row, row})) << int{delimiter};
      }
    }
  }
}

TEST(Tokenizer, blanks_around_cells_are_dropped_and_those_inside_kept) {
  EXPECT_EQ(table(" a b ,\tc\t, \n"), (RecordTexts{{"a b", "c", ""}}));
}

TEST(Tokenizer, empty_cells_may_be_at_either_end_and_between) {
  EXPECT_EQ(table(",\n"), (RecordTexts{{"", ""}}));
  EXPECT_EQ(table(",1,,2,\r\n"), (RecordTexts{{"", "1", "", "2", ""}}));
  EXPECT_EQ(table("\t1\t\t2\t\n", {'\t', "#"}), (RecordTexts{{"", "1", "", "2", ""}}));
}

TEST(Tokenizer, a_record_of_too_many_cells_is_skipped) {
  const Chunk chunk{std::string(most_cells - 1, ',') + "\n" + std::string(most_cells, ',') + "\n1,2\n"};
  const Dialect dialect;
  Tokenizer tokenizer(chunk, dialect);
  std::vector<std::string_view> cells;
  EXPECT_TRUE(tokenizer.next(cells));
  EXPECT_EQ(cells.size(), most_cells);
  EXPECT_EQ(error_of([&] { tokenizer.next(cells); }),
            "f:2:1: error: the record has more than 1048576 cells; expected at most 1048576; correct the row, or give "
            "the delimiter with --delimiter");
  EXPECT_TRUE(tokenizer.next(cells));
  EXPECT_THAT(cells, ElementsAre("1", "2"));
}

TEST(Tokenizer, runs_of_blanks_and_tabs_count_as_one_delimiter) {
  EXPECT_EQ(table("  1 \t  2\t3 \r\n4 5 6", {' ', "#"}), (RecordTexts{{"1", "2", "3"}, {"4", "5", "6"}}));
}

TEST(Tokenizer, either_blank_delimits_after_a_quoted_cell) {
  const Dialect blanks{' ', "#"};
  EXPECT_EQ(table("\"0\"\t1 \"2\" \t3\n", blanks), (RecordTexts{{"\"0\"", "1", "\"2\"", "3"}}));
  EXPECT_EQ(chunks("\"a\"\tb\t\"\n\"\n1\n", 1, blanks).size(), 2U) << "a line end within quotes ends nothing";
}

TEST(Tokenizer, quoted_cells_hold_delimiters_line_ends_and_doubled_quotes) {
  EXPECT_EQ(table("\"a,b\",\"c\r\nd\" , \"e\"\"f\"\n1,2,3\n"),
            (RecordTexts{{"\"a,b\"", "\"c\r\nd\"", "\"e\"\"f\""}, {"1", "2", "3"}}));
  EXPECT_EQ(table("\"a b\" \"#c\"", {' ', "#"}), (RecordTexts{{"\"a b\"", "\"#c\""}}));
}

TEST(Tokenizer, a_quote_inside_a_cell_is_a_character) { EXPECT_EQ(table("5\",6\n"), (RecordTexts{{"5\"", "6"}})); }

TEST(Tokenizer, quotes_are_removed) {
  EXPECT_EQ(unquoted("\"a,\"\"b\"\"\""), "a,\"b\"");
  EXPECT_EQ(unquoted("\"\""), "");
  EXPECT_EQ(unquoted("a\"b"), "a\"b");
  EXPECT_EQ(unquoted("\""), "\"");
}

TEST(Tokenizer, comments_and_blank_lines_are_skipped) {
  EXPECT_EQ(table("# c\n\n \t \r\n0,1\n  # 2,3\r\n4,5\n#"), (RecordTexts{{"0", "1"}, {"4", "5"}}));
  EXPECT_EQ(table("// c\n#0,1\n", {',', "//"}), (RecordTexts{{"#0", "1"}}));
  EXPECT_EQ(table("#0,1\n", {',', ""}), (RecordTexts{{"#0", "1"}})) << "no comments at all";
  EXPECT_EQ(table("0,1 # 2\n"), (RecordTexts{{"0", "1 # 2"}})) << "a comment is a line of its own";
}

TEST(Tokenizer, the_comments_above_a_record_are_kept) {
  const Chunk chunk{"# none\n\n# one\n# two\n0,1\n2,3\n"};
  const Dialect dialect;
  Tokenizer tokenizer(chunk, dialect);
  std::vector<std::string_view> cells;
  ASSERT_TRUE(tokenizer.next(cells));
  EXPECT_EQ(tokenizer.comment(), "# one\n# two");
  ASSERT_TRUE(tokenizer.next(cells));
  EXPECT_EQ(tokenizer.comment(), "");
}

TEST(Tokenizer, lines_offsets_and_positions_count_from_the_chunk) {
  const std::string text = "\n0,\"a\r\né\",é , b\r\n# c\n1,2\n";
  const Chunk chunk{text, 10};
  const Dialect dialect;
  Tokenizer tokenizer(chunk, dialect);
  std::vector<std::string_view> cells;
  ASSERT_TRUE(tokenizer.next(cells));
  EXPECT_EQ(tokenizer.line(), 11U);
  EXPECT_EQ(tokenizer.offset(), 1U);
  ASSERT_EQ(cells.size(), 4U);
  const auto position = [&](std::size_t cell) {
    const TextPosition at = tokenizer.position(cells[cell]);
    return fmt::format("{}:{}", at.line, at.column);
  };
  EXPECT_EQ(position(0), "11:1");
  EXPECT_EQ(position(1), "11:3");
  EXPECT_EQ(position(2), "12:4") << "é and its quote and delimiter are three characters";
  EXPECT_EQ(position(3), "12:8");
  ASSERT_TRUE(tokenizer.next(cells));
  EXPECT_EQ(tokenizer.line(), 14U);
  EXPECT_EQ(tokenizer.offset(), text.find("1,2"));
  EXPECT_EQ(position(1), "14:3");
  EXPECT_FALSE(tokenizer.next(cells));
}

TEST(Tokenizer, misplaced_quotes_are_errors_at_their_position) {
  EXPECT_EQ(error_of([] { table("0,1\né,\"2\n3"); }),
            "f:2:3: error: a quoted cell is not closed; expected \" at its end");
  EXPECT_EQ(
      error_of([] { table("é,\"a\" b\n"); }),
      "f:1:7: error: text follows a quoted cell; expected the delimiter or the end of the line; double the quotes "
      "inside a cell");
}

TEST(InvalidNumber, has_the_error_with_its_remedy) {
  const auto expect = [](std::string_view cell, char decimal, const std::string& words) {
    EXPECT_THAT(why_not_number("x", cell, {decimal}).message(), testing::HasSubstr(words)) << cell;
  };
  expect("0,5", '.', "give --decimal , if this is a decimal comma");
  expect("0,500", '.', "give --decimal , if this is a decimal comma");
  expect("1,234", '.', "give --thousands , if the comma divides thousands, or --decimal , if");
  expect("1234,567.8", '.', "correct the cell");
  expect("1.5", ',', "or give --decimal .");
  expect("1,5e999", ',', "is not a finite double");
  expect("1 2", '.', "expected one number in each cell");
  expect("-1,234,567.8", '.', "or give --thousands ,");
  expect("1.234,5", '.', "or give --decimal , --thousands .");
  expect("1.234,5", ',', "or give --decimal , --thousands .");
  expect("1 234", '.', "or give --thousands space");
  expect("1'234,5", '.', "or give --decimal , --thousands apostrophe");
  expect("0x1F", '.', "correct the cell");
}

}  // namespace
}  // namespace tcb
