// Reader: how the format of an input is found, and what may precede its first byte.

#include <gtest/gtest.h>

#include "formats/formats.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/reading.hpp"

namespace tcb {
namespace {

const std::string csv_text = "t,x\n0,1\n";
const std::string csv_keys = "t x\n2: 0 1\n";

TEST(OpenInput, the_file_ending_determines_the_format) {
  EXPECT_EQ(read("t\tx,y\n0\t1\n", {}, 1, "a.b/keys.tsv"), "t x,y\n2: 0 1\n");
  EXPECT_EQ(read("t x,y\n0 1\n", {}, 1, "keys.ssv"), "t x,y\n2: 0 1\n");
  EXPECT_EQ(read("[t,x\n0,1\n", with_columns("time=1"), 1, "keys.csv"), "[t x\n2: 0 1\n") << "no JSON, by its ending";
  EXPECT_EQ(read("{\"t\":0,\"x\":1}\n", {}, 1, "keys.jsonl"), "t x\n1: 0 1\n");
  EXPECT_NE(read(csv_text, {}, 1, "keys.json").find("not JSON"), std::string::npos);
}

TEST(OpenInput, without_an_ending_the_first_byte_that_is_not_blank_does) {
  EXPECT_EQ(read(" \t\r\n [{\"t\":0,\"x\":1}]", {}, 1, "-"), "t x\n2: 0 1\n");
  EXPECT_EQ(read("\n{\"t\":0,\"x\":1}", {}, 1, "keys"), "t x\n2: 0 1\n");
  EXPECT_EQ(read(csv_text, {}, 1, "keys.txt"), csv_keys);
  EXPECT_EQ(read("csv,t\n1,0\n", {}, 1, "csv"), "t csv\n2: 0 1\n") << "a name is no ending";
}

TEST(OpenInput, a_given_format_has_priority) {
  InputOptions options;
  options.format = find_format("csv");
  EXPECT_EQ(read(csv_text, options, 1, "keys.json"), csv_keys);
  options.format = find_format("tsv");
  EXPECT_EQ(read("t\ta,b\n0\t1\n", options, 1, "keys.csv"), "t a,b\n2: 0 1\n");
}

TEST(OpenInput, a_given_delimiter_has_priority_over_the_format) {
  InputOptions options;
  options.delimited.delimiter = ';';
  EXPECT_EQ(read("t;x\n0;1\n", options, 1, "keys.tsv"), "t x\n2: 0 1\n");
}

TEST(OpenInput, a_byte_order_mark_is_not_part_of_the_first_cell) {
  const std::string mark = "\xEF\xBB\xBF";
  for (std::size_t piece = 1; piece < 5; ++piece) {
    EXPECT_EQ(read(mark + csv_text, {}, piece), csv_keys);
    EXPECT_EQ(read(mark + "[{\"t\":0,\"x\":1}]", {}, piece), "t x\n1: 0 1\n");
    EXPECT_EQ(read(mark + "t,x\n\"0\n", {}, piece),
              "f:2:1: error: a quoted cell is not closed; expected \" at its end");
    EXPECT_EQ(read(mark + "0,inf\n1,2\n", {}, piece),
              "f:1:3: error: x: \"inf\" is not a finite double; expected less than 1.8e308 in size; correct the cell")
        << "characters are counted without it";
  }
  EXPECT_NE(read("t," + mark + "x\n0,1\n"), csv_keys) << "it is one only at the beginning";
}

TEST(OpenInput, an_input_shorter_than_a_mark_is_read) {
  EXPECT_EQ(read("7"),
            "f:1: error: there is no position column; expected at least one column of numbers besides the time; give "
            "--parameter uniform if the only column is a position");
}

}  // namespace
}  // namespace tcb
