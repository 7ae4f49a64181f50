// Layouts: the exact text of rows in each format, and names that need quotes.
#include "write/layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "formats/formats.hpp"
#include "read/csv/tokenizer.hpp"
#include "read/reading.hpp"
#include "write/output_format.hpp"

namespace tcb {

namespace {

void append(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
            const std::vector<Cell>& cells, bool first = true) {
  std::vector<PrintedColumn> printed;
  for (const OutputColumn& column : columns) printed.push_back({column.kind, printed.size()});
  append_rows(out, layout, printed, {{cells}, columns.size()}, {}, first);
}

TEST(OutputFormat, each_layout_writes_what_its_format_reads) {
  const std::vector<OutputColumn> columns{{"t", CellKind::time}, {"the x", CellKind::real}};
  for (const Format& format : formats()) {
    const bool has_names = format.offers(offer::marks) || format.is_json;
    if (!format.can_read() || !format.can_write() || !has_names) continue;
    const Layout layout = format.output->layout(columns, {format.delimiter}, true);
    std::string text = layout.head;
    append(text, layout, columns, {Cell(0), Cell(0.1), Cell(1), Cell(-2)});
    text += layout.tail + layout.end;
    InputOptions options;
    options.format = &format;
    const std::string keys = read(text, options);
    EXPECT_TRUE(keys.starts_with("t the x\n")) << keys;
    EXPECT_NE(keys.find(": 0 0.1\n"), std::string::npos) << keys;
    EXPECT_NE(keys.find(": 1 -2\n"), std::string::npos) << keys;
  }
}

const std::vector<OutputColumn> npy_columns{{"t", CellKind::time}, {"x", CellKind::real}, {"key", CellKind::whole}};

/// Eight bytes, the lowest first, as a double.
double number_at(const std::string& bytes, std::size_t number) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[number * 8 + i]);
  return std::bit_cast<double>(bits);
}

TEST(Npy, the_head_has_the_same_size_for_any_number_of_rows) {
  for (const std::uint64_t rows : {std::uint64_t{0}, std::uint64_t{1}, std::numeric_limits<std::uint64_t>::max()}) {
    const std::string head = find_format("npy")->output->counted_head(3, rows);
    ASSERT_EQ(head.size(), 128U);
    EXPECT_EQ(head.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
    EXPECT_EQ(head.back(), '\n');
    EXPECT_NE(head.find("'shape': (" + std::to_string(rows) + ", 3), }"), std::string::npos) << head;
  }
}

TEST(Npy, cells_are_the_bytes_of_doubles_and_nan_where_not_defined) {
  std::string bytes;
  append(bytes, npy_layout(npy_columns), npy_columns,
         {Cell(0.1), Cell(-0.0), Cell(7), Cell(1), empty_cell, empty_cell});
  ASSERT_EQ(bytes.size(), 48U);
  EXPECT_EQ(number_at(bytes, 0), 0.1);
  EXPECT_TRUE(std::signbit(number_at(bytes, 1)));
  EXPECT_EQ(number_at(bytes, 2), 7);
  EXPECT_TRUE(std::isnan(number_at(bytes, 4)));
  EXPECT_TRUE(std::isnan(number_at(bytes, 5)));
}

TEST(Npy, a_time_beyond_doubles_is_refused) {
  std::string bytes;
  const auto append_time = [&](const Cell& time) {
    append(bytes, npy_layout(npy_columns), npy_columns, {time, Cell(0), Cell(0)});
  };
  append_time({9007199254740992.0, 0});
  EXPECT_EQ(number_at(bytes, 0), 9007199254740992.0);
  EXPECT_THROW(append_time({9007199254740992.0, 1}), Error);
}

const std::vector<OutputColumn> columns{{"t", CellKind::time}, {"x", CellKind::real}, {"n", CellKind::whole}};
const std::vector<Cell> two_rows{Cell(0), Cell(0.1), Cell(3), {9007199254740992.0, 1}, Cell(-1e300), Cell(4)};

Layout layout_of(std::string_view format, const std::vector<OutputColumn>& of) {
  return find_format(format)->output->layout(of, {}, true);
}

/// All of an output: head, the rows in one go or one after another, tail.
std::string output(const Layout& layout, const std::vector<OutputColumn>& of, const std::vector<Cell>& cells) {
  std::string text = layout.head;
  append(text, layout, of, cells);
  return text + (cells.empty() ? layout.no_rows : layout.tail) + layout.end;
}

TEST(Layout, delimited_rows) {
  EXPECT_EQ(output(delimited_layout(columns, {','}, true), columns, two_rows),
            "t,x,n\n0,0.1,3\n9007199254740993,-1e+300,4\n");
  EXPECT_EQ(output(delimited_layout(columns, {'\t'}, false), columns, two_rows),
            "0\t0.1\t3\n9007199254740993\t-1e+300\t4\n");
}

TEST(Layout, json_rows) {
  EXPECT_EQ(output(layout_of("json", columns), columns, two_rows),
            "[\n{\"t\":0,\"x\":0.1,\"n\":3},\n{\"t\":9007199254740993,\"x\":-1e+300,\"n\":4}\n]\n");
  EXPECT_EQ(output(layout_of("jsonl", columns), columns, two_rows),
            "{\"t\":0,\"x\":0.1,\"n\":3}\n{\"t\":9007199254740993,\"x\":-1e+300,\"n\":4}\n");
}

TEST(Layout, an_output_without_rows_is_complete) {
  EXPECT_EQ(output(delimited_layout(columns, {','}, true), columns, {}), "t,x,n\n");
  EXPECT_EQ(output(layout_of("jsonl", columns), columns, {}), "");
  EXPECT_TRUE(nlohmann::json::parse(output(layout_of("json", columns), columns, {})).empty());
}

TEST(Layout, rows_in_several_calls_are_the_rows_in_one) {
  for (const Layout& layout :
       {delimited_layout(columns, {';'}, true), layout_of("json", columns), layout_of("jsonl", columns)}) {
    std::string in_one, in_two;
    append(in_one, layout, columns, two_rows);
    append(in_two, layout, columns, {two_rows.begin(), two_rows.begin() + 3});
    append(in_two, layout, columns, {two_rows.begin() + 3, two_rows.end()}, false);
    EXPECT_EQ(in_two, in_one);
  }
}

TEST(Layout, names_are_quoted_only_where_it_is_necessary) {
  const auto head = [](const std::string& name, char delimiter) {
    return delimited_layout({{name}}, {delimiter}, true).head;
  };
  EXPECT_EQ(head("p x [m]", ','), "p x [m]\n");
  EXPECT_EQ(head("p x", ' '), "\"p x\"\n");
  EXPECT_EQ(head("a\tb", ' '), "\"a\tb\"\n");
  EXPECT_EQ(head("a,b", ','), "\"a,b\"\n");
  EXPECT_EQ(head("a,b", ';'), "a,b\n");
  EXPECT_EQ(head("5\" \n", ','), "\"5\"\" \n\"\n");
}

const char* const odd_names[] = {"a,b", "a;b", "a\tb", "a b", "\"", "\"a\"", "a\"\"b", "a\nb", "a\r\nb", "é", "a\\b"};

TEST(Layout, delimited_names_read_back) {
  for (const char delimiter : {',', ';', '\t', ' '}) {
    const Dialect dialect{delimiter, ""};
    for (const std::string name : odd_names) {
      const Chunk chunk{delimited_layout({{"t"}, {name}}, {delimiter}, true).head};
      Tokenizer tokenizer(chunk, dialect);
      std::vector<std::string_view> cells;
      ASSERT_TRUE(tokenizer.next(cells));
      ASSERT_EQ(cells.size(), 2U) << chunk.text;
      EXPECT_EQ(unquoted(cells[1]), name);
      EXPECT_FALSE(tokenizer.next(cells));
    }
  }
}

TEST(Layout, json_names_read_back) {
  for (const std::string name : {"a\"b", "\\", "\\\"", "a\nb", "\t", "é", "\x01\x1F", "a/b"}) {
    const std::vector<OutputColumn> one{{name}};
    const auto row = nlohmann::json::parse(output(layout_of("jsonl", one), one, {Cell(1)}));
    EXPECT_EQ(row.begin().key(), name);
  }
}

}  // namespace

}  // namespace tcb
