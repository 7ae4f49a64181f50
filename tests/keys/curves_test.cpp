// Curves: where one ends and the next begins, the texts of groups, and the faults of all curves in one error.
#include "keys/curves.hpp"

#include <gtest/gtest.h>

#include "keys.hpp"

namespace tcb {
namespace {

Input input_of(const std::string& lines, std::size_t size, std::vector<std::string> groups = {}) {
  Input input;
  input.timed = input.may_break = true;
  input.groups = std::move(groups);
  input.keys = keys_of(lines, size);
  return input;
}

/// The curves as "GROUP( KEYS)"; of each at most `most` blocks are read.
std::string curves_of(const Input& input, const CurveOptions& options = {}, int most = 1000) {
  Curves curves(input, options, false);
  std::string out;
  while (const auto curve = curves.next()) {
    for (const std::string& text : curve->group) out += text;
    int left = most;
    out += "(" + shown_keys([&]() { return left-- > 0 ? curve->keys() : std::nullopt; }) + ")";
  }
  return out;
}

TEST(Curves, an_input_without_breaks_is_one_curve) {
  for (std::size_t size = 1; size < 4; ++size)
    EXPECT_EQ(curves_of(input_of("0 1\n1 2\n2 3\n", size)), "( 1:1 2:2 3:3)");
}

TEST(Curves, breaks_and_gaps_and_equal_times_begin_curves) {
  for (std::size_t size = 1; size < 6; ++size) {
    EXPECT_EQ(curves_of(input_of("0 1\n/\n0 2\ngap 1\n1 3\n1 4\n", size), {Duplicates::break_curve, false}),
              "( 1:1)( 3:2)( 5:3)( 6:4)");
  }
}

TEST(Curves, keys_of_a_curve_that_were_not_read_are_passed_over) {
  EXPECT_EQ(curves_of(input_of("0 1\n1 2\n2 3\n/\n0 4\n1 5\n", 1), {}, 1), "( 1:1)( 5:4)");
}

TEST(Curves, texts_identify_groups) {
  EXPECT_EQ(curves_of(input_of("0 1 b x\n0 2 a x\n1 3 b x\n", 2, {"g", "h"})), "bx( 1:1 3:3)ax( 2:2)");
}

TEST(Curves, an_input_without_keys_is_a_curve_without_keys) { EXPECT_EQ(curves_of(input_of("", 1)), "()"); }

TEST(Curves, an_input_that_cannot_break_is_not_read_to_its_end) {
  Input input = input_of("0 1\n1 2\n", 1);
  input.may_break = false;
  int asked = 0;
  input.keys = [&asked, keys = input.keys] {
    ++asked;
    return keys();
  };
  Curves curves(input, {}, false);
  (void)curves.next()->keys();
  EXPECT_FALSE(curves.next().has_value());
  EXPECT_EQ(asked, 1);
}

TEST(Curves, faults_of_all_curves_are_one_error_in_the_order_of_their_lines) {
  EXPECT_EQ(refusal_of([] { curves_of(input_of("0 1 a\n5 2 b\n0 3 a\n4 4 b\n", 2, {"g"})); }),
            "f:3: error: time 0 repeats the time 0 in line 1; expected times that increase; take one of them out, or "
            "give --duplicates first, last or break\n"
            "f:4: error: time 4 is less than the time 5 in line 2; expected times that increase; sort the rows by "
            "time, or give --sort");
}

TEST(Curves, sorting_without_times_is_refused) {
  Input input = input_of("0 1\n", 1);
  input.timed = false;
  EXPECT_EQ(refusal_of([&] {
              Curves(input, {Duplicates::error, true}, false);
            }),
            "f: error: --sort orders rows by time, and there is no time column; take it out, or name the column with "
            "--columns time=NAME");
}

}  // namespace
}  // namespace tcb
