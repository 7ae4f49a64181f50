// Delimited text: header and roles, keys and their lines, every refusal with its place, in pieces of any size.
#include "input/csv/key_parser.hpp"

#include <gmock/gmock.h>

#include <random>

#include "input/reading.hpp"

namespace tcb {
namespace {

InputOptions with_header(bool header) {
  InputOptions options;
  options.header = header;
  return options;
}

TEST(Csv, a_header_gives_the_roles) {
  EXPECT_EQ(read("x,T,t,y,B,C\n1,.5,0,2,.25,-1\n3,0,1,4,0,0\n"), "t x y\n2: 0 1 2 [0.5 -1 0.25]\n3: 1 3 4\n");
  EXPECT_EQ(read("Frame,Bias,\"a,b\"\n0,1,2\n1,0,3\n"), "Frame a,b\n2: 0 2 [0 0 1]\n3: 1 3\n");
}

TEST(Csv, without_a_header_time_comes_first) {
  EXPECT_EQ(read("0,1,2\n1,3,4\n"), "(t x y)\n1: 0 1 2\n2: 1 3 4\n");
  EXPECT_EQ(read("0 1 2 3 4\n"), "(t p1 p2 p3 p4)\n1: 0 1 2 3 4\n");
}

TEST(Csv, the_first_record_is_a_header_if_a_cell_in_it_is_no_number) {
  EXPECT_EQ(read("1,t\n2,3\n"), "t 1\n2: 3 2\n");
  EXPECT_EQ(read("0,inf\n1,2\n"),
            "f:1:3: error: x: \"inf\" is not a finite double; expected less than 1.8e308 in size; correct the cell");
  EXPECT_EQ(read("0,NA\n1,2\n"),
            "f:1:3: error: x: \"NA\" where a number was expected; fill it in, or give --missing skip-row, skip-cell or "
            "break");
}

TEST(Csv, a_first_record_of_text_and_numbers_without_a_known_name_is_refused) {
  EXPECT_EQ(
      read("0,1x\n1,2\n"),
      "f:1:1: error: the first record has text, \"1x\", and a number, \"0\"; expected names or numbers alone; give "
      "--header if they are names, --no-header if they are not");
  EXPECT_EQ(read("t,2019,2020\n0,1,2\n"), "t 2019 2020\n2: 0 1 2\n") << "years are names beside a known one";
  EXPECT_EQ(read("a,2019\n0,1\n", with_columns("time=a")), "a 2019\n2: 0 1\n") << "or beside one asked for";
}

TEST(Csv, carriage_returns_alone_end_no_lines) {
  EXPECT_EQ(
      read("t,x\r0,1\r1,2\r"),
      "f:1:1: error: no keys: there is one line, with carriage returns in it; expected a line for each key; change "
      "them to line feeds, for example with tr");
}

TEST(Csv, a_header_may_be_forced_or_denied) {
  InputOptions options = with_columns("time=1");
  options.header = true;
  EXPECT_EQ(read("10,20\n0,1\n", options), "10 20\n2: 0 1\n");
  EXPECT_EQ(read("0,1\nx,2\n", with_header(false)),
            "f:2:1: error: t: \"x\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(read("#t,a\n0,1\n", with_header(false)), "(t x)\n2: 0 1\n");
}

TEST(Csv, a_comment_above_the_first_row_with_a_name_for_each_cell_is_the_header) {
  EXPECT_EQ(read("# ground truth\n# timestamp tx ty tz\n0 1 2 3\n"), "timestamp tx ty tz\n3: 0 1 2 3\n");
  EXPECT_EQ(read("#timestamp,\"p x\",T\r\n0,1,.5\r\n"), "timestamp p x\n2: 0 1 [0.5 0 0]\n");
  EXPECT_EQ(read("# made by hand\n0,1\n"), "(t x)\n2: 0 1\n") << "one name for two cells is a remark";
  EXPECT_EQ(read("# a,b\nt,x\n0,1\n"), "t x\n3: 0 1\n") << "a header that is none of comments comes first";
}

TEST(Csv, a_comment_with_a_blank_line_below_is_not_directly_above) {
  EXPECT_EQ(read("# t,a\n\n0,1\n"), "(t x)\n3: 0 1\n");
}

TEST(Csv, columns_are_asked_for_by_name_or_number) {
  EXPECT_EQ(read("t,frame,a,b\n9,0,1,2\n", with_columns("time=frame,position=4:a")), "frame b a\n2: 0 2 1\n");
  EXPECT_EQ(read("1,2,0\n", with_columns("time=3")), "(t x y)\n1: 0 1 2\n");
  EXPECT_EQ(read("t,k,x\n0,.5,1\n", with_columns("tension=K")), "t x\n2: 0 1 [0.5 0 0]\n");
}

TEST(Csv, columns_of_text_are_left_out_and_one_cell_that_is_missing_makes_no_text) {
  EXPECT_EQ(read("t,label,x\n0,one,1\n1,2,2\n2,three,3\n"),
            "f:2:3: error: label: \"one\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
            "f:4:3: error: label: \"three\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell")
      << "of two rows, one is a number";
  EXPECT_EQ(read("t,label,x\n0,one,1\n1,two,2\n"), "t x\n2: 0 1\n3: 1 2\n");
  EXPECT_EQ(read("t,x\n0,\n1,2\n"),
            "f:2:3: error: x: an empty cell where a number was expected; fill it in, or give --missing skip-row, "
            "skip-cell or break");
}

TEST(Csv, the_delimiter_is_found_or_given) {
  for (const char* text : {"t,x y\n0,1\n", "t\tx y\n0\t1\n", "t;x y\n0;1\n"}) EXPECT_EQ(read(text), "t x y\n2: 0 1\n");
  EXPECT_EQ(read("t  x\n 0\t1 \n"), "t x\n2: 0 1\n");
  InputOptions pipe;
  pipe.delimiter = '|';
  EXPECT_EQ(read("t|a,b\n0|1\n", pipe), "t a,b\n2: 0 1\n");
}

TEST(Csv, names_may_be_quoted_from_the_first_on) {
  EXPECT_EQ(read("\"t\",\"x\"\n0,1\n1,2\n"), "t x\n2: 0 1\n3: 1 2\n");
}

TEST(Csv, numbers_may_be_quoted) { EXPECT_EQ(read("t,x\n\"0\",\"1.5\"\n"), "t x\n2: 0 1.5\n"); }

TEST(Csv, keys_that_carry_no_tcb_have_the_given_one) {
  InputOptions options;
  options.tcb = {1, 2, 3};
  EXPECT_EQ(read("t,x\n0,1\n", options), "t x\n2: 0 1 [1 2 3]\n");
  EXPECT_EQ(read("t,x,C\n0,1,0\n", options), "t x\n2: 0 1 [1 0 3]\n");
}

TEST(Csv, whole_times_beyond_2_to_53_are_exact) {
  EXPECT_EQ(read("t,x\n1403636579763555584,1\n1403636579763555585,2\n"),
            "t x\n2: 1403636579763555584 1\n3: 1403636579763555585 2\n");
}

TEST(Csv, comments_blank_lines_and_line_ends_change_nothing_but_the_lines) {
  EXPECT_EQ(read("# c\r\n\r\nt,x\r\n# d\r\n0,1\r\n \r\n1,2"), "t x\n5: 0 1\n7: 1 2\n");
  InputOptions options;
  options.comment = "//";
  EXPECT_EQ(read("// c\nt,#\n0,1\n//\n", options), "t #\n3: 0 1\n");
}

TEST(Csv, a_cell_that_is_no_number_is_refused_at_its_character) {
  EXPECT_EQ(read("name,t,x\né,0,1\né,1,o.5\n"),
            "f:3:5: error: x: \"o.5\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(read("name,t,x\na,0,1\n\"é\nü\",1,0x1\n"),
            "f:4:6: error: x: \"0x1\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(read("t,x,T\n0,1,0\n1,1,-\n"),
            "f:3:5: error: tension: \"-\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(
      read("t,x,C,B\n0,1,0,0\n1,1,c,0\n"),
      "f:3:5: error: continuity: \"c\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(
      read("t,x,C,B\n0,1,0,0\n1,1,0,1e999\n"),
      "f:3:7: error: bias: \"1e999\" is not a finite double; expected less than 1.8e308 in size; correct the cell");
  EXPECT_EQ(read("frame,x\n0,1\nNaN,1\n"),
            "f:3:1: error: frame: \"NaN\" where a number was expected; fill it in, or give --missing skip-row, "
            "skip-cell or break");
}

TEST(Csv, a_tiny_number_is_not_too_large) { EXPECT_EQ(read("t,x\n0,1e-400\n1,2\n"), "t x\n2: 0 0\n3: 1 2\n"); }

TEST(Csv, long_text_is_cut_between_characters_in_messages) {
  const std::string start(39, 'a');
  EXPECT_EQ(
      read("t,x\n0,1\n1," + start + "éb\n"),
      "f:3:3: error: x: \"" + start + "…\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
}

TEST(Csv, rows_of_another_length_are_refused) {
  const std::string remedy = "; complete or correct the row, or give the delimiter with -d";
  EXPECT_EQ(read("t,x\n0,1\n1,2,3\n"), "f:3:5: error: a row of 3 cells; expected 2 as in the rows above" + remedy);
  EXPECT_EQ(read("t,x\n0,1\n1\n"), "f:3:1: error: a row of 1 cell; expected 2 as in the rows above" + remedy);
  EXPECT_EQ(read("t,x\n\n0,1,2\n"),
            "f:3:1: error: the first row has 3 where the header has 2; expected the same number; correct one of them, "
            "or give the "
            "delimiter with -d");
}

TEST(Csv, one_cell_is_not_called_cells) {
  EXPECT_EQ(read("t,x\n0\n"),
            "f:2:1: error: the first row has 1 where the header has 2; expected the same number; correct one of them, "
            "or give the "
            "delimiter with -d");
}

TEST(Csv, an_input_without_keys_is_refused) {
  for (const char* text : {"", "\n \n", "# t,x\n", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(read(text), "f: error: no keys: the input is empty; expected a row for each key; see --help") << text;
  }
  EXPECT_EQ(read("\nt,x\n"),
            "f:2:1: error: no keys: there is a header and no row; expected a row for each key; see --help");
}

TEST(Csv, columns_that_are_missing_are_refused) {
  EXPECT_EQ(read("0\n1\n"),
            "f:1: error: no position column; expected at least one column of numbers beside the time; name it with "
            "--columns position=NAME");
  EXPECT_EQ(read("t,x\n0,1\n", with_columns("position=y")),
            "f:1: error: no column \"y\"; the columns are t, x; correct --columns");
}

TEST(Csv, the_head_leaves_chunks_that_begin_with_the_first_key) {
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

// The law: what is read does not depend on how the bytes arrive.
void expect_same_in_pieces(const std::string& text) {
  const std::string whole = read(text);
  for (std::size_t piece = 1; piece < text.size(); ++piece) {
    ASSERT_EQ(read(text, {}, piece), whole) << text << " in pieces of " << piece;
  }
}

TEST(Csv, missing_numbers_are_treated_as_asked_for) {
  InputOptions options;
  const std::string text = "t,x,y,T\n0,1,2,0.5\n1,,NA,\n2,3,null,1\n";
  options.missing = Missing::skip_row;
  EXPECT_EQ(read(text, options), "t x y\n2: 0 1 2 [0.5 0 0]\n");
  options.missing = Missing::skip_cell;
  options.tcb = {0.25, 0, 0};
  EXPECT_EQ(read(text, options), "t x y\n2: 0 1 2 [0.5 0 0]\n3: 1 nan nan [0.25 0 0]\n4: 2 3 nan [1 0 0]\n");
  EXPECT_EQ(
      read("t,x\n0,1\n,2\n", options),
      "f:3:1: error: t: an empty cell where a number was expected; fill it in, or give --missing skip-row, skip-cell "
      "or break")
      << "a time cannot be skipped alone";
}

TEST(Csv, texts_of_groups_and_labels_go_with_the_keys) {
  EXPECT_EQ(read("id,t,x,l\n7,0,1,\"a \"\"b\"\"\"\n-07,1,2,\n", with_columns("group=id,carry=l")),
            "t x\n2: 0 1 <7> <\"a \"b\">\n3: 1 2 <\"-07> <\">\n")
      << "a whole number is no string";
  EXPECT_EQ(
      read("t,x,l\n0,1,\xFC\n", with_columns("carry=l")),
      "f:2:5: error: \"\\xFC\": the byte FC is no UTF-8; expected UTF-8; convert the text, for example with iconv");
}

TEST(Csv, faults_do_not_end_the_reading) {
  EXPECT_EQ(read("t,x\n0,o\n1,2,3\n2,1\np,q\n"),
            "f:2:3: error: x: \"o\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
            "f:3:5: error: a row of 3 cells; expected 2 as in the rows above; complete or correct the row, or give the "
            "delimiter with -d\n"
            "f:5:1: error: t: \"p\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
            "f:5:3: error: x: \"q\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
}

TEST(Csv, two_columns_of_one_name_are_refused_unless_they_are_chosen_by_number) {
  EXPECT_EQ(read("t,x,x\n0,1,2\n"),
            "f:1: error: two columns are called \"x\"; expected different names; rename one, or choose by number with "
            "--columns");
  EXPECT_EQ(read("t,x,x\n0,1,2\n", with_columns("position=3")), "t x\n2: 0 2\n");
}

TEST(Csv, a_column_without_a_name_and_without_cells_is_left_out) {
  EXPECT_EQ(read("t,x,\n0,1,\n1,2,\n"), "t x\n2: 0 1\n3: 1 2\n");
}

TEST(Csv, pieces_of_any_size_give_the_same_keys_or_the_same_error) {
  for (const char* text :
       {"# t x\n> one\n0 1\n\n1 2\n> two\n2 3\n", "#a\n\n#t,x\n#\n0,1\n", "#a\n#t,x\n0,1\n", "#t,x\n\n0,1\n",
        "t,x\n0,1\n1,2\n", "\xEF\xBB\xBFt;x\r\n0;1\r\n\r\n1;2", "#t,x\n0,1\n1,2\n", "0\t1\n1\t2\n# c\n2\t3\n",
        "t,x,l\n0,1,\"a\nb\"\n1,2,\"c\"\"\n\n\"\n2,3,d", "t,x\n0,1\né,2\n", "t,x\n0,1\n1,\"2\n3,4\n",
        "t,l,x\n0,\"a\nü\" z,1\n", "t,x\n0,1\n1\n2,3\n", "t,x\n", "", "\n\n", "t,x\n0,1"}) {
    expect_same_in_pieces(text);
  }
}

TEST(Csv, the_delimiter_does_not_depend_on_where_a_comment_was_cut) {
  expect_same_in_pieces("# by hand\n0;1\n1;2\n");
  expect_same_in_pieces("\n\nt x\n0 1\n1 2\n");
}

/// Text with what delimited text may have, and the keys that it means.
class RandomCsv {
 public:
  explicit RandomCsv(std::uint64_t seed) : random_(seed) {
    const char delimiter = ",;\t"[draw(3)];
    const std::string end = draw(2) != 0 ? "\r\n" : "\n";
    add(fmt::format("t{0}x{0}label{1}", delimiter, end));
    expected = "t x\n";
    for (std::uint64_t row = 0, rows = 1 + draw(7); row < rows; ++row) {
      while (draw(3) == 0) add((draw(2) != 0 ? "# 5\"" : " ") + end);
      expected += fmt::format("{}: {} {}\n", line_, row, row * 2);
      add(fmt::format("{}{}{}{}{}", row, delimiter, row * 2, delimiter, label(delimiter)) +
          (row + 1 == rows && draw(2) != 0 ? "" : end));
    }
  }
  std::string text, expected;

 private:
  std::uint64_t draw(std::uint64_t below) { return random_() % below; }
  void add(const std::string& more) {
    text += more;
    line_ += static_cast<std::uint64_t>(std::ranges::count(more, '\n'));
  }
  std::string label(char delimiter) {
    if (draw(2) != 0) return "abc";
    std::string quoted = "\"l";
    const std::string parts[] = {"a", "\"\"", "\n", "\r\n", "#", std::string(1, delimiter), "é"};
    while (draw(5) != 0) quoted += parts[draw(7)];
    return quoted + '"';
  }
  std::mt19937_64 random_;
  std::uint64_t line_ = 1;
};

TEST(Csv, what_stands_before_a_nul_is_read_first) {
  using namespace std::string_literals;
  for (const std::size_t piece : {std::size_t{1}, std::size_t{5}, std::string::npos}) {
    EXPECT_EQ(
        read("t,x\n0,1\n1,a\n2,\0"s, {}, piece),
        "f:3:3: error: x: \"a\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
        "f:4:3: error: a NUL byte; expected text in UTF-8; convert the input, for example with iconv -f UTF-16 -t "
        "UTF-8");
  }
}

TEST(Csv, random_texts_give_their_keys_in_pieces_of_any_size) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const RandomCsv csv(seed);
    for (const std::size_t piece :
         {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{7}, std::string::npos}) {
      ASSERT_EQ(read(csv.text, {}, piece), csv.expected) << csv.text << " in pieces of " << piece;
    }
  }
}

}  // namespace
}  // namespace tcb
