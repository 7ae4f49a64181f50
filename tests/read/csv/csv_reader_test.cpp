// Reader of delimited text: keys and their lines, every error with its position, in pieces of any size.
#include "read/csv/csv_reader.hpp"

#include <gmock/gmock.h>

#include <random>

#include "read/reading.hpp"

namespace tcb {
namespace {

TEST(Csv, numbers_may_be_quoted) { EXPECT_EQ(read("t,x\n\"0\",\"1.5\"\n"), "t x\n2: 0 1.5\n"); }

TEST(Csv, keys_without_tcb_have_the_given_one) {
  InputOptions options;
  options.keys.tcb = {1, 2, 3};
  EXPECT_EQ(read("t,x\n0,1\n", options), "t x\n2: 0 1 [1 2 3]\n");
  EXPECT_EQ(read("t,x,continuity\n0,1,0\n", options), "t x\n2: 0 1 [1 0 3]\n");
}

TEST(Csv, whole_times_beyond_2_to_53_are_exact) {
  EXPECT_EQ(read("t,x\n1403636579763555584,1\n1403636579763555585,2\n"),
            "t x\n2: 1403636579763555584 1\n3: 1403636579763555585 2\n");
}

TEST(Csv, comments_blank_lines_and_line_ends_change_nothing_but_the_lines) {
  EXPECT_EQ(read("# c\r\n\r\nt,x\r\n# d\r\n0,1\r\n \r\n1,2"), "t x\n5: 0 1\n7: 1 2\n");
  InputOptions options;
  options.delimited.comment = "//";
  EXPECT_EQ(read("// c\nt,#\n0,1\n//\n", options), "t #\n3: 0 1\n");
}

TEST(Csv, a_cell_that_is_not_a_number_is_an_error_at_its_character) {
  EXPECT_EQ(read("name,t,x\né,0,1\né,1,o.5\n"),
            "f:3:5: error: x: \"o.5\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(read("name,t,x\na,0,1\n\"é\nü\",1,0x1\n"),
            "f:4:6: error: x: \"0x1\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
  EXPECT_EQ(
      read("t,x,tension\n0,1,0\n1,1,+\n"),
      "f:3:5: error: tension: \"+\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell, or "
      "give it to --na, along with --missing, if it stands for a missing number, --columns ignore=3 to leave the "
      "column out, or --group 3 if "
      "it tells curves apart");
  EXPECT_EQ(read("t,x,continuity,bias\n0,1,0,0\n1,1,0,1e999\n"),
            "f:3:7: error: bias: \"1e999\" is not a finite double; expected less than 1.8e308 in size; correct "
            "the cell");
  EXPECT_EQ(read("frame,x\n0,1\nNaN,1\n"),
            "f:3:1: error: frame: found \"NaN\"; expected a time; fill it in, or give --missing skip-row or break");
}

TEST(Csv, a_tiny_number_is_not_too_large) { EXPECT_EQ(read("t,x\n0,1e-400\n1,2\n"), "t x\n2: 0 0\n3: 1 2\n"); }

TEST(Csv, long_text_is_cut_between_characters_in_messages) {
  const std::string start(39, 'a');
  EXPECT_EQ(
      read("t,x\n0,1\n1," + start + "éb\n"),
      "f:3:3: error: x: \"" + start + "…\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell");
}

TEST(Csv, rows_of_another_length_are_errors) {
  const std::string remedy = "; complete or correct the row, or give the delimiter with --delimiter";
  EXPECT_EQ(
      read("t,x\n0,1\n1,2,3\n"),
      "f:3:5: error: the number of cells in the row is 3, but 2 in the rows above; expected the same number" + remedy);
  EXPECT_EQ(
      read("t,x\n0,1\n1\n"),
      "f:3:1: error: the number of cells in the row is 1, but 2 in the rows above; expected the same number" + remedy);
  EXPECT_EQ(read("t,x\n\n0,1,2\n"),
            "f:3:1: error: the number of cells in the first row is 3, but 2 in the header; expected the same number; "
            "add a name to the header if the first cells name the rows, or correct line 1 or line 3");
}

// The result does not depend on how the bytes arrive.
void expect_same_in_pieces(const std::string& text) {
  const std::string whole = read(text);
  for (std::size_t piece = 1; piece < text.size(); ++piece) {
    ASSERT_EQ(read(text, {}, piece), whole) << text << " in pieces of " << piece;
  }
}

TEST(Csv, keys_have_the_texts_of_groups_and_labels) {
  EXPECT_EQ(read("id,t,x,l\n7,0,1,\"a \"\"b\"\"\"\n-07,1,2,\n", with_columns("group=id,carry=l")),
            "t x\n2: 0 1 <7> <\"a \"b\">\n3: 1 2 <\"-07> <\">\n")
      << "a whole number is no string";
  EXPECT_EQ(read("t,x,l\n0,1,\xFC\n", with_columns("carry=l")),
            "f:2:5: error: \"\\xFC\" has the byte FC, which is not UTF-8; expected UTF-8; convert the text, as in "
            "iconv -f WINDOWS-1252 -t UTF-8 <FILE | tcbsample");
}

TEST(Csv, faults_do_not_end_the_reading) {
  EXPECT_EQ(read("t,x\n0,o\n1,2,3\n2,1\np,q\n"),
            "f:2:3: error: x: \"o\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
            "f:3:5: error: the number of cells in the row is 3, but 2 in the rows above; expected the same number; "
            "complete or correct the row, or give the delimiter with --delimiter\n"
            "f:5:1: error: t: \"p\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell, or give "
            "--comment p if such lines are no keys (2 errors of this kind, the last in line 5)");
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

TEST(Csv, the_text_before_a_nul_is_read_first) {
  using namespace std::string_literals;
  for (const std::size_t piece : {std::size_t{1}, std::size_t{5}, std::string::npos}) {
    EXPECT_EQ(read("t,x\n0,1\n1,a\n2,\0"s, {}, piece),
              "f:3:3: error: x: \"a\" is not a number; expected a decimal such as -1.5 or 2e3; correct the cell\n"
              "f:4:3: error: this is a NUL byte; expected text in UTF-8; if it is text, remove such "
              "bytes");
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
