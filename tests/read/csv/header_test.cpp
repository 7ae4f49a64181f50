// Header of delimited text: names and roles of the columns.
#include "read/csv/csv_reader.hpp"

#include <gmock/gmock.h>

#include "read/csv/splitter.hpp"
#include "read/reading.hpp"

namespace tcb {
namespace {

InputOptions with_header(bool header) {
  InputOptions options;
  options.delimited.header = header;
  return options;
}

TEST(Header, a_header_gives_the_roles) {
  EXPECT_EQ(read("x,T,t,y,B,C\n1,.5,0,2,.25,-1\n3,0,1,4,0,0\n"), "t x y\n2: 0 1 2 [0.5 -1 0.25]\n3: 1 3 4\n");
  EXPECT_EQ(read("Frame,Bias,\"a,b\"\n0,1,2\n1,0,3\n"), "Frame a,b\n2: 0 2 [0 0 1]\n3: 1 3\n");
}

TEST(Header, without_a_header_time_comes_first) {
  EXPECT_EQ(read("0,1,2\n1,3,4\n"), "(t x y)\n1: 0 1 2\n2: 1 3 4\n");
  EXPECT_EQ(read("0 1 2 3 4\n"), "(t p1 p2 p3 p4)\n1: 0 1 2 3 4\n");
}

TEST(Header, the_first_record_is_a_header_if_a_cell_in_it_is_not_a_number) {
  EXPECT_EQ(read("1,t\n2,3\n"), "t 1\n2: 3 2\n");
  EXPECT_EQ(read("0,inf\n1,2\n"),
            "f:1:3: error: x: \"inf\" is not a finite double; expected less than 1.8e308 in size; correct the cell");
  EXPECT_EQ(read("0,NA\n1,2\n"),
            "f:1:3: error: x: found \"NA\"; expected a number; fill it in, or give --missing skip-row or "
            "break");
}

TEST(Header, a_first_record_of_text_and_numbers_without_a_known_name_is_an_error) {
  EXPECT_EQ(read("0,1x\n1,2\n"),
            "f:1:1: error: the first record has both text, \"1x\", and a number, \"0\"; expected only names or only "
            "numbers; give "
            "--header if they are names, --no-header if they are not");
  EXPECT_EQ(read("t,2019,2020\n0,1,2\n"), "t 2019 2020\n2: 0 1 2\n") << "years are names where there is a known one";
  EXPECT_EQ(read("a,2019\n0,1\n", with_columns("time=a")), "a 2019\n2: 0 1\n") << "or a requested one";
}

TEST(Header, carriage_returns_alone_end_no_lines) {
  EXPECT_EQ(read("t,x\r0,1\r1,2\r"),
            "f:1:1: error: the input is a single line that contains carriage returns; expected a line for "
            "each key; change them to line feeds, as in tr '\\r' '\\n' <FILE | tcbsample");
}

TEST(Header, a_header_may_be_forced_or_denied) {
  InputOptions options = with_columns("time=1");
  options.delimited.header = true;
  EXPECT_EQ(read("10,20\n0,1\n", options), "10 20\n2: 0 1\n");
  EXPECT_EQ(read("0,1\nx,2\n", with_header(false)),
            "f:2:1: error: t: \"x\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell, or give "
            "--comment x if such lines are no keys");
  EXPECT_EQ(read("#t,a\n0,1\n", with_header(false)), "(t x)\n2: 0 1\n");
}

TEST(Header, a_comment_above_the_first_row_with_a_name_for_each_cell_is_the_header) {
  EXPECT_EQ(read("# ground truth\n# timestamp tx ty tz\n0 1 2 3\n"), "timestamp tx ty tz\n3: 0 1 2 3\n");
  EXPECT_EQ(read("#timestamp,\"p x\",tension\r\n0,1,.5\r\n"), "timestamp p x\n2: 0 1 [0.5 0 0]\n");
  EXPECT_EQ(read("# made by hand\n0,1\n"), "(t x)\n2: 0 1\n") << "one name for two cells is a remark";
  EXPECT_EQ(read("# a,b\nt,x\n0,1\n"), "t x\n3: 0 1\n") << "a header that is none of comments comes first";
}

TEST(Header, a_comment_with_a_blank_line_below_is_not_directly_above) {
  EXPECT_EQ(read("# t,a\n\n0,1\n"), "(t x)\n3: 0 1\n");
}

TEST(Header, columns_are_requested_by_name_or_number) {
  EXPECT_EQ(read("t,frame,a,b\n9,0,1,2\n", with_columns("time=frame,position=4:a")), "frame b a\n2: 0 2 1\n");
  EXPECT_EQ(read("1,2,0\n", with_columns("time=3")), "(t x y)\n1: 0 1 2\n");
  EXPECT_EQ(read("t,k,x\n0,.5,1\n", with_columns("tension=K")), "t x\n2: 0 1 [0.5 0 0]\n");
}

TEST(Header, columns_of_text_are_ignored_and_one_cell_that_is_missing_makes_no_text) {
  EXPECT_EQ(
      read("t,label,x\n0,one,1\n1,2,2\n2,3,3\n"),
      "f:2:3: error: label: \"one\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell, or "
      "give it to --na, along with --missing, if it stands for a missing number, --columns ignore=label to leave "
      "the column out, or "
      "--group label if it tells curves apart")
      << "of two rows, one is a number";
  EXPECT_EQ(read("t,label,x\n0,one,1\n1,two,2\n"), "t x\n2: 0 1\n3: 1 2\n");
  EXPECT_EQ(read("t,x\n0,\n1,2\n"),
            "f:2:3: error: x: found an empty cell; expected a number; fill it in, or give --missing "
            "skip-row or break");
}

TEST(Header, names_may_be_quoted_from_the_first_on) {
  EXPECT_EQ(read("\"t\",\"x\"\n0,1\n1,2\n"), "t x\n2: 0 1\n3: 1 2\n");
}

TEST(Header, an_input_without_keys_is_an_error) {
  for (const char* text : {"", "\n \n", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(read(text), "f: error: the input is empty; expected a row for each key; see --help") << text;
  }
  EXPECT_EQ(read("# t,x\n"),
            "f: error: all lines begin with \"#\", as comments do; expected a row for each key; give --comment none if "
            "they are keys");
  EXPECT_EQ(read("\nt,x\n"), "f:2:1: error: no row follows the header; expected a row for each key; see --help");
}

TEST(Header, missing_columns_are_errors) {
  EXPECT_EQ(read("0\n1\n"),
            "f:1: error: there is no position column; expected at least one column of numbers besides the time; give "
            "--parameter uniform if the only column is a position");
  EXPECT_EQ(read("t,x\n0,1\n", with_columns("position=y")),
            "f:1: error: --columns: there is no column \"y\"; expected one of t, x");
}

TEST(Header, the_chunks_after_the_header_begin_with_the_first_key) {
  const Dialect dialect;
  Source<Chunk> chunks = split_delimited(pieces("\n# c\nt,x\n\n0,1\n1,2\n2,3\n3,4\n", 4), dialect);
  std::vector<Chunk> rest;
  const DelimitedHead head = read_head(chunks, dialect, {}, rest);
  std::string text;
  for (const Chunk& chunk : rest) text += chunk.text;
  EXPECT_THAT(text, testing::StartsWith("0,1\n1,2\n"));
  EXPECT_EQ(rest[0].line, 5U);
  EXPECT_EQ(shown_key(parse_delimited(rest[0], head), 0), "5: 0 1\n");
}

TEST(Header, two_columns_of_one_name_are_an_error_unless_they_are_chosen_by_number) {
  EXPECT_EQ(read("t,x,x\n0,1,2\n"),
            "f:1: error: two columns are called \"x\"; expected different names; rename one, or give --columns "
            "position=2:3,time=1 for columns by number");
  EXPECT_EQ(read("t,x,x\n0,1,2\n", with_columns("position=3")), "t x\n2: 0 2\n");
}

TEST(Header, a_column_without_a_name_and_without_cells_is_ignored) {
  EXPECT_EQ(read("t,x,\n0,1,\n1,2,\n"), "t x\n2: 0 1\n3: 1 2\n");
}

}  // namespace
}  // namespace tcb
