// Records: their cells and places, and chunks of whole records however the bytes arrive.
#include "input/csv/records.hpp"

#include <gmock/gmock.h>

#include "input/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using Table = std::vector<std::vector<std::string>>;

Table table(const std::string& text, const Dialect& dialect = {}) {
  const Chunk chunk{text};
  Records records(chunk, dialect);
  Table rows;
  for (std::vector<std::string_view> cells; records.next(cells);) {
    rows.emplace_back(cells.begin(), cells.end());
  }
  return rows;
}

/// The chunks of a text that arrives in pieces of this size.
std::vector<Chunk> chunks(const std::string& text, std::size_t piece, const Dialect& dialect = {}) {
  const auto source = split_delimited(pieces(text, piece), dialect);
  std::vector<Chunk> all;
  while (auto chunk = source()) all.push_back(std::move(*chunk));
  return all;
}

TEST(Records, lines_end_in_lf_or_crlf_and_the_last_may_not_end) {
  const Table expected{{"0", "1"}, {"2", "3"}};
  for (const char* text : {"0,1\n2,3\n", "0,1\r\n2,3\r\n", "0,1\n2,3", "0,1\r\n2,3\r", "0,1\r\n2,3"}) {
    EXPECT_EQ(table(text), expected) << text;
  }
}

TEST(Records, cells_of_any_length_end_at_any_delimiter) {
  for (const char delimiter : {',', ';', '\x7F', '\x80', '\xA7', '\xFF', '\1'}) {
    Dialect dialect;
    dialect.delimiter = delimiter;
    for (std::size_t first = 0; first < 20; ++first) {
      for (std::size_t second = 1; second < 20; ++second) {
        const std::vector<std::string> row{std::string(first, 'a'), std::string(second, '-')};
        const std::string text = row[0] + delimiter + row[1];
        EXPECT_EQ(table(text + '\n' + text, dialect), (Table{row, row})) << int{delimiter};
      }
    }
  }
}

TEST(Records, blanks_around_cells_are_dropped_and_those_inside_kept) {
  EXPECT_EQ(table(" a b ,\tc\t, \n"), (Table{{"a b", "c", ""}}));
}

TEST(Records, empty_cells_stand_at_either_end_and_between) {
  EXPECT_EQ(table(",\n"), (Table{{"", ""}}));
  EXPECT_EQ(table(",1,,2,\r\n"), (Table{{"", "1", "", "2", ""}}));
  EXPECT_EQ(table("\t1\t\t2\t\n", {'\t', "#"}), (Table{{"", "1", "", "2", ""}}));
}

TEST(Records, a_record_of_too_many_cells_is_passed_over) {
  const Chunk chunk{std::string(most_cells - 1, ',') + "\n" + std::string(most_cells, ',') + "\n1,2\n"};
  const Dialect dialect;
  Records records(chunk, dialect);
  std::vector<std::string_view> cells;
  EXPECT_TRUE(records.next(cells));
  EXPECT_EQ(cells.size(), most_cells);
  EXPECT_EQ(error_of([&] { records.next(cells); }),
            "f:2:1: error: a record of more than 1048576 cells; expected fewer; correct the row, or give the delimiter "
            "with -d");
  EXPECT_TRUE(records.next(cells));
  EXPECT_THAT(cells, ElementsAre("1", "2"));
}

TEST(Records, runs_of_blanks_and_tabs_count_as_one_delimiter) {
  EXPECT_EQ(table("  1 \t  2\t3 \r\n4 5 6", {' ', "#"}), (Table{{"1", "2", "3"}, {"4", "5", "6"}}));
}

TEST(Records, either_blank_delimits_behind_a_quoted_cell) {
  const Dialect blanks{' ', "#"};
  EXPECT_EQ(table("\"0\"\t1 \"2\" \t3\n", blanks), (Table{{"\"0\"", "1", "\"2\"", "3"}}));
  EXPECT_EQ(chunks("\"a\"\tb\t\"\n\"\n1\n", 1, blanks).size(), 2U) << "a line end within quotes ends nothing";
}

TEST(Records, quoted_cells_hold_delimiters_line_ends_and_doubled_quotes) {
  EXPECT_EQ(table("\"a,b\",\"c\r\nd\" , \"e\"\"f\"\n1,2,3\n"),
            (Table{{"\"a,b\"", "\"c\r\nd\"", "\"e\"\"f\""}, {"1", "2", "3"}}));
  EXPECT_EQ(table("\"a b\" \"#c\"", {' ', "#"}), (Table{{"\"a b\"", "\"#c\""}}));
}

TEST(Records, a_quote_inside_a_cell_is_a_character) { EXPECT_EQ(table("5\",6\n"), (Table{{"5\"", "6"}})); }

TEST(Records, quotes_are_taken_off) {
  EXPECT_EQ(unquoted("\"a,\"\"b\"\"\""), "a,\"b\"");
  EXPECT_EQ(unquoted("\"\""), "");
  EXPECT_EQ(unquoted("a\"b"), "a\"b");
  EXPECT_EQ(unquoted("\""), "\"");
}

TEST(Records, comments_and_blank_lines_are_skipped) {
  EXPECT_EQ(table("# c\n\n \t \r\n0,1\n  # 2,3\r\n4,5\n#"), (Table{{"0", "1"}, {"4", "5"}}));
  EXPECT_EQ(table("// c\n#0,1\n", {',', "//"}), (Table{{"#0", "1"}}));
  EXPECT_EQ(table("#0,1\n", {',', ""}), (Table{{"#0", "1"}})) << "no comments at all";
  EXPECT_EQ(table("0,1 # 2\n"), (Table{{"0", "1 # 2"}})) << "a comment is a line of its own";
}

TEST(Records, the_last_comment_skipped_is_at_hand) {
  const Chunk chunk{"# one\n# two\n0,1\n2,3\n"};
  const Dialect dialect;
  Records records(chunk, dialect);
  std::vector<std::string_view> cells;
  ASSERT_TRUE(records.next(cells));
  EXPECT_EQ(records.comment(), "# two");
  ASSERT_TRUE(records.next(cells));
  EXPECT_EQ(records.comment(), "");
}

TEST(Records, lines_offsets_and_places_count_from_the_chunk) {
  const std::string text = "\n0,\"a\r\né\",é , b\r\n# c\n1,2\n";
  const Chunk chunk{text, 10};
  const Dialect dialect;
  Records records(chunk, dialect);
  std::vector<std::string_view> cells;
  ASSERT_TRUE(records.next(cells));
  EXPECT_EQ(records.line(), 11U);
  EXPECT_EQ(records.offset(), 1U);
  ASSERT_EQ(cells.size(), 4U);
  const auto place = [&](std::size_t cell) {
    const TextPosition at = records.place(cells[cell]);
    return fmt::format("{}:{}", at.line, at.column);
  };
  EXPECT_EQ(place(0), "11:1");
  EXPECT_EQ(place(1), "11:3");
  EXPECT_EQ(place(2), "12:4") << "é and its quote and delimiter are three characters";
  EXPECT_EQ(place(3), "12:8");
  ASSERT_TRUE(records.next(cells));
  EXPECT_EQ(records.line(), 14U);
  EXPECT_EQ(records.offset(), text.find("1,2"));
  EXPECT_EQ(place(1), "14:3");
  EXPECT_FALSE(records.next(cells));
}

TEST(Records, quotes_out_of_place_are_refused_where_they_stand) {
  EXPECT_EQ(error_of([] { table("0,1\né,\"2\n3"); }),
            "f:2:3: error: a quoted cell is not closed; expected \" at its end; add it");
  EXPECT_EQ(error_of([] { table("é,\"a\" b\n"); }),
            "f:1:7: error: text after a quoted cell; expected the delimiter or the line's end; double the quotes "
            "inside a cell");
}

std::vector<std::string> texts_of(const std::vector<Chunk>& chunks) {
  std::vector<std::string> texts;
  for (const Chunk& chunk : chunks) texts.push_back(chunk.text);
  return texts;
}

const char* const texts[] = {"0,1\n2,3\n",          "0,1\r\n2,3",        "\"a\nb\",1\n\"c\"\"\n\",2\n",
                             "# it\"s\n0,1\n2,3\n", "\n\n0,1\n#\n\n2,3", "0,\"\"\n1,\"a\r\n\r\nb\"\r\n"};

TEST(SplitDelimited, chunks_are_the_text_cut_between_records_with_their_first_lines) {
  for (const std::string text : texts) {
    const Table whole = table(text);
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      std::string joined;
      Table rows;
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

TEST(SplitDelimited, quotes_behind_a_quoted_cell_open_no_cell) {
  for (const std::string line : {"\"\"a,\"", "\"a\"b,\"c", "\"a\" \r,\"", "\"a\" b\"", "\"\" \"\",\""}) {
    const std::string text = line + "\n1,2\n3,4\n";
    EXPECT_THAT(texts_of(chunks(text, 1)), testing::ElementsAre(line + "\n", "1,2\n", "3,4\n")) << text;
  }
}

TEST(SplitDelimited, a_record_is_handed_on_as_soon_as_its_line_ends) {
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
  EXPECT_EQ(arriving.size(), 2U) << "nothing more was asked for";
  EXPECT_EQ(source()->text, "2,3\n");
  EXPECT_FALSE(source());
}

// Splitting and parsing have to agree on which quotes mean something.
TEST(SplitDelimited, a_quote_in_an_indented_comment_means_nothing) {
  const std::string text = "  # 5\" tall\n0,\"a\nb\"\n1,c\n";
  Table rows;
  EXPECT_EQ(error_of([&] {
              for (const Chunk& chunk : chunks(text, std::string::npos)) {
                for (auto& row : table(chunk.text)) rows.push_back(std::move(row));
              }
            }),
            "no error");
  EXPECT_EQ(rows, table(text));
}

TEST(SplitDelimited, a_quote_inside_a_cell_means_nothing) {
  const std::string text = "0,5\"\n1,\"a\nb\"\n2,c\n";
  Table rows;
  EXPECT_EQ(error_of([&] {
              for (const Chunk& chunk : chunks(text, std::string::npos)) {
                for (auto& row : table(chunk.text)) rows.push_back(std::move(row));
              }
            }),
            "no error");
  EXPECT_EQ(rows, table(text));
}

TEST(SplitDelimited, a_quote_left_open_is_refused_at_64_mib) {
  const auto endless = [first = true]() mutable -> std::optional<std::string> {
    return std::exchange(first, false) ? "0,1\n\"" : std::string(16U << 20U, '\n');
  };
  EXPECT_EQ(
      error_of([&] {
        const auto source = split_delimited(endless, {});
        while (source()) {
        }
      }),
      "f:2:1: error: a record of more than 64 MiB; expected a line for each key; break the lines, or close a quote "
      "that was left open");
}

}  // namespace
}  // namespace tcb
