// Order: keys without gaps, equal and decreasing times, and curves that break off.
#include "keys/order.hpp"

#include <gtest/gtest.h>

#include "keys.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

/// The result of f for blocks of any size, or what differs.
template <class F>
std::string in_any_blocks(F f) {
  const std::string whole = f(std::size_t{100});
  for (std::size_t size = 1; size < 8; ++size) EXPECT_EQ(f(size), whole) << "in blocks of " << size;
  return whole;
}

std::string ordered(const std::string& lines, Duplicates duplicates) {
  return in_any_blocks([&](std::size_t size) { return shown_keys(in_order(keys_of(lines, size), duplicates)); });
}

std::string gapless(const std::string& lines) {
  return in_any_blocks([&](std::size_t size) { return shown_keys(without_gaps(keys_of(lines, size))); });
}

TEST(WithoutGaps, a_gap_leaves_a_break_between_keys_and_none_at_the_ends) {
  EXPECT_EQ(gapless("0 1\ngap 1\n2 3\n3 4\n"), " 1:1 / 3:3 4:4");
  EXPECT_EQ(gapless("gap 0\n1 2\ngap 2\ngap 3\n4 5\ngap 5\n"), " 2:2 / 5:5");
  EXPECT_EQ(gapless("0 1\n/\n1 2\n/\ngap 2\n3 4\n"), " 1:1 / 3:2 / 6:4");
  EXPECT_EQ(gapless("/\n0 1\n1 2\n"), " 2:1 3:2");
}

TEST(InOrder, increasing_times_stay_as_they_are) {
  for (const auto& [name, value] : duplicates_names)
    EXPECT_EQ(ordered("0 1\n1 2\n3 3\n", value), " 1:1 2:2 3:3") << name;
}

TEST(InOrder, equal_times_are_refused_or_one_is_kept_or_a_curve_begins) {
  const std::string keys = "0 1\n1 2\n1 3\n1 4\n2 5\n";
  const std::string remedy =
      "; expected increasing times; remove one of the keys, or give --duplicates first, last or break]";
  EXPECT_EQ(in_any_blocks([&](std::size_t size) {
              std::string all = shown_keys(in_order(keys_of(keys, size), Duplicates::error));
              return all.substr(all.find("[f:3"), all.find(']') - all.find("[f:3") + 1);
            }),
            "[f:3: error: time 1 repeats the time 1 on line 2" + remedy);
  EXPECT_EQ(ordered(keys, Duplicates::first), " 1:1 2:2 5:5");
  EXPECT_EQ(ordered(keys, Duplicates::last), " 1:1 4:4 5:5");
  EXPECT_EQ(ordered(keys, Duplicates::break_curve), " 1:1 2:2 / 3:3 / 4:4 5:5");
}

TEST(InOrder, times_may_decrease_after_a_break) {
  for (const auto& [name, value] : duplicates_names) {
    EXPECT_EQ(ordered("5 1\n/\n5 2\n/\n1 3\n2 4\n", value), " 1:1 / 3:2 / 5:3 6:4") << name;
  }
}

TEST(InOrder, the_last_of_equal_times_begins_the_curve_that_the_first_began) {
  EXPECT_EQ(ordered("0 1\n/\n5 2\n5 3\n6 4\n", Duplicates::last), " 1:1 / 4:3 5:4");
  EXPECT_EQ(ordered("0 1\n0 2\n", Duplicates::last), " 2:2");
}

TEST(InOrder, decreasing_times_are_refused_each_with_the_previous_key) {
  const OrderRemedies by_place{true, "NUMBER"};
  const std::string all = shown_keys(in_order(keys_of("0 1\n2 2\n1.5 3\n1 4\n3 5\n", 5), Duplicates::first, by_place));
  const std::string remedy = "; expected increasing times; give ";
  const std::string unnamed =
      remedy +
      "--parameter uniform if the first column is no time, --columns time=NUMBER if another one is, --group NUMBER if "
      "a column tells curves apart, or --sort if the keys are of one curve]";
  EXPECT_EQ(all, " 1:1 2:2 3:3 4:4 5:5 [f:3: error: time 1.5 is less than the time 2 on line 2" + unnamed +
                     " [f:4: error: time 1 is less than the time 1.5 on line 3" + unnamed);
  const std::string named = shown_keys(in_order(keys_of("2 2\n1 3\n", 5), Duplicates::first));
  EXPECT_EQ(named, " 1:2 2:3 [f:2: error: time 1 is less than the time 2 on line 1" + remedy + "--sort]");
}

TEST(InOrder, keys_of_json_are_named_by_their_path) {
  const Source<KeyBlock> blocks = [done = false]() mutable -> std::optional<KeyBlock> {
    if (std::exchange(done, true)) return std::nullopt;
    KeyBlock block{{1, {3.0, 3.0}, {0, 1}, {}, {}, {}}, {{1, 1}}};
    block.text_positions.path = "curves[2].keys";
    block.text_positions.numbers = {7, 8};
    return block;
  };
  EXPECT_EQ(shown_keys(in_order(blocks, Duplicates::error)),
            " 1:0 [f:1: error: curves[2].keys[8]: time 3 repeats the time 3 of curves[2].keys[7]; expected increasing "
            "times; remove one of the keys, or give --duplicates first, last or break]");
}

TEST(PastMidnight, days_are_added_up_to_the_next_break) {
  const auto times = [](TimeNotation notation) {
    return in_any_blocks([&](std::size_t size) {
      std::uint64_t midnights = 0;
      const std::string keys = "86399 1\n1 2\n50000 3\n2 4\n/\n86399 5\n43200 6\n0 7\n";
      const auto blocks = past_midnight(without_gaps(keys_of(keys, size)), notation, 25, midnights);
      std::string text;
      while (const std::optional<KeyBlock> block = blocks()) {
        for (const Time& time : block->keys.times) text += time_text(time) + " ";
      }
      return text + "passed " + std::to_string(midnights);
    });
  };
  EXPECT_EQ(times(TimeNotation::clock), "86399 86401 136400 172802 86399 43200 0 passed 2");
  EXPECT_EQ(times(TimeNotation::smpte), "86399 86401 136400 172802 86399 43200 0 passed 2");
  EXPECT_EQ(times(TimeNotation::seconds), "86399 1 50000 2 86399 43200 0 passed 0");
}

}  // namespace
}  // namespace tcb
