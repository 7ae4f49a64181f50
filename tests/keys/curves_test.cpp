// Curves: where one ends and the next begins, the texts of groups, and the faults of all curves in one error.
#include "keys/curves.hpp"

#include <gtest/gtest.h>

#include "keys.hpp"

namespace tcb {

namespace {

/// Keys and their meaning.
struct MeantKeys {
  Schema schema;
  InputKeys keys;
};

MeantKeys meant_keys(const std::string& lines, std::size_t size, std::vector<std::string> groups = {}) {
  MeantKeys meant;
  meant.schema.time.is_given = meant.keys.traits.may_break = true;
  meant.schema.groups = std::move(groups);
  meant.keys.blocks = keys_of(lines, size);
  return meant;
}

/// The curves as "GROUP( KEYS)"; of each at most `most` blocks are read.
std::string curves_of(const MeantKeys& meant, const CurveOptions& options = {}, int most = 1000) {
  Curves curves(meant.schema, meant.keys, options);
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
    EXPECT_EQ(curves_of(meant_keys("0 1\n1 2\n2 3\n", size)), "( 1:1 2:2 3:3)");
}

TEST(Curves, breaks_and_gaps_and_equal_times_begin_curves) {
  for (std::size_t size = 1; size < 6; ++size) {
    EXPECT_EQ(curves_of(meant_keys("0 1\n/\n0 2\ngap 1\n1 3\n1 4\n", size), {Duplicates::break_curve, false}),
              "( 1:1)( 3:2)( 5:3)( 6:4)");
  }
}

TEST(Curves, unread_keys_of_a_curve_are_skipped) {
  EXPECT_EQ(curves_of(meant_keys("0 1\n1 2\n2 3\n/\n0 4\n1 5\n", 1), {}, 1), "( 1:1)( 5:4)");
}

TEST(Curves, texts_identify_groups) {
  EXPECT_EQ(curves_of(meant_keys("0 1 b x\n0 2 a x\n1 3 b x\n", 2, {"g", "h"})), "bx( 1:1 3:3)ax( 2:2)");
}

TEST(Curves, an_input_without_keys_is_a_curve_without_keys) { EXPECT_EQ(curves_of(meant_keys("", 1)), "()"); }

TEST(Curves, an_input_that_cannot_break_is_not_read_to_its_end) {
  MeantKeys meant = meant_keys("0 1\n1 2\n", 1);
  meant.keys.traits.may_break = false;
  int asked = 0;
  meant.keys.blocks = [&asked, blocks = meant.keys.blocks] {
    ++asked;
    return blocks();
  };
  Curves curves(meant.schema, meant.keys, {});
  (void)curves.next()->keys();
  EXPECT_FALSE(curves.next().has_value());
  EXPECT_EQ(asked, 1);
}

TEST(Curves, faults_of_all_curves_are_one_error_in_the_order_of_their_lines) {
  EXPECT_EQ(refusal_of([] { curves_of(meant_keys("0 1 a\n5 2 b\n0 3 a\n4 4 b\n", 2, {"g"})); }),
            "f:3: error: time 0 repeats the time 0 on line 1; expected increasing times; remove one of the keys, or "
            "give --duplicates first, last or break\n"
            "f:4: error: time 4 is less than the time 5 on line 2; expected increasing times; give --sort");
}

TEST(Curves, keys_in_any_order_stay_in_that_of_the_input) {
  EXPECT_EQ(curves_of(meant_keys("1 1\n0 2\n1 3\n", 2), {.any_order = true}), "( 1:1 2:2 3:3)");
}

TEST(Curves, sorting_without_times_is_refused) {
  MeantKeys meant = meant_keys("0 1\n", 1);
  meant.schema.time.is_given = false;
  EXPECT_EQ(refusal_of([&] {
              Curves(meant.schema, meant.keys, {Duplicates::error, true});
            }),
            "f: error: --sort orders rows by time, but there is no time column; remove it, or name the column with "
            "--columns time=NAME");
}

}  // namespace

}  // namespace tcb
