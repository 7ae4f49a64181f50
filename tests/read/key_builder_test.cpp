// Key builder: which records become keys, what they leave out, and what a missing cell does.
#include "read/key_builder.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace tcb {
namespace {

using testing::ElementsAre;

const Columns columns = find_columns(std::vector<std::string>{"id", "t", "x", "y", "tension", "label"},
                                     {false, true, true, true, true, false},
                                     std::vector<RoleRequest>{{Role::group, {"id"}}, {Role::carry, {"label"}}});

/// Adds a key with this time; its x is missing where `has_x` is false.
void add(KeyBuilder& keys, double time, bool has_x = true) {
  keys.begin_key();
  keys.set_text(columns.cells[0], "\"a");
  keys.set_time(Time(time));
  if (has_x) keys.number(columns.cells[2]) = 10 * time;
  if (!has_x && !keys.miss(columns.cells[2])) {
    keys.add_fault(data_error("x: found an empty cell").at({"", 1, 1}));
  }
  keys.number(columns.cells[3]) = 20 * time;
  if (keys.end_key()) keys.set_position(static_cast<std::uint64_t>(time), 1);
}

KeyBlock three(Missing missing) {
  KeyBuilder keys(columns, {.tcb = spline::Tcb<double>{0.5, 0, 0}, .missing = missing});
  add(keys, 1);
  add(keys, 2, false);
  add(keys, 3);
  return keys.finish();
}

TEST(KeyBuilder, cells_become_numbers_and_texts_by_their_roles) {
  KeyBuilder keys(columns, {.tcb = spline::Tcb<double>{0.5, 0, 0}});
  keys.begin_key();
  keys.number(columns.cells[4]) = -1;
  keys.set_text(columns.cells[5], "\"label");
  keys.set_text(columns.cells[0], "7");
  EXPECT_TRUE(keys.end_key());
  keys.set_position(3, 4);
  add(keys, 2);
  const KeyBlock block = keys.finish();
  ASSERT_EQ(block.size(), 2U);
  ASSERT_EQ(block.keys.tcbs.size(), 2U);
  EXPECT_EQ(block.keys.tcbs[0].tension, -1);
  EXPECT_EQ(block.keys.tcbs[1].tension, 0.5) << "the common one";
  EXPECT_TRUE(block.keys.eases.empty());
  EXPECT_EQ(block.text(0, 0), "7");
  EXPECT_EQ(block.text(0, 1), "\"label");
  EXPECT_EQ(block.text(1, 1), "") << "the texts of one key are not those of the next";
  EXPECT_TRUE(std::isnan(block.keys.positions[0]));
  EXPECT_EQ(block.text_positions.lines, (std::vector<std::uint64_t>{3, 2}));
}

TEST(KeyBuilder, channels_without_tension_of_their_own_have_the_common_one) {
  const Columns with_own = find_columns(std::vector<std::string>{"t", "x", "tension_y", "y", "tension", "bias_x"},
                                        std::vector<bool>(6, true), {});
  KeyRules rules{.tcb = spline::Tcb<double>{0.5, 0.25, 0.125}};
  rules.keeps_decimals = true;
  KeyBuilder keys(with_own, rules);
  const auto set = [&](std::size_t cell, double value, const char* decimal) {
    keys.number(with_own.cells[cell]) = value;
    keys.take_decimal(with_own.cells[cell], decimal);
  };
  keys.begin_key();
  set(2, 1, "1.0");
  set(4, -1, "-1.0");
  EXPECT_TRUE(keys.end_key());
  keys.set_position(1, 1);
  const KeyBlock block = keys.finish();
  ASSERT_EQ(block.keys.tcbs.size(), 2U);
  EXPECT_EQ(block.keys.tcb(0, 0), (spline::Tcb<double>{-1, 0.25, 0.125}));
  EXPECT_EQ(block.keys.tcb(0, 1), (spline::Tcb<double>{1, 0.25, 0.125}));
  EXPECT_EQ(block.decimals[NumberOfKey::of_channel(NumberOfKey::tension_of, 0, 2)], "-1.0");
  EXPECT_EQ(block.decimals[NumberOfKey::of_channel(NumberOfKey::tension_of, 1, 2)], "1.0");
  EXPECT_EQ(block.decimals[NumberOfKey::of_channel(NumberOfKey::bias_of, 0, 2)], "");
}

TEST(KeyBuilder, a_missing_number_is_a_fault_or_is_skipped_or_breaks_the_curve) {
  EXPECT_EQ(three(Missing::error).faults.errors.size(), 1U);
  EXPECT_EQ(three(Missing::error).size(), 2U);
  const KeyBlock rows = three(Missing::skip_row);
  EXPECT_EQ(rows.faults.skipped, 1U);
  EXPECT_THAT(rows.keys.positions, ElementsAre(10, 20, 30, 60));
  const KeyBlock cells = three(Missing::skip_cell);
  EXPECT_EQ(cells.faults.skipped, 0U);
  EXPECT_TRUE(std::isnan(cells.keys.positions[2]));
  EXPECT_EQ(cells.keys.positions[3], 40);
  const KeyBlock breaks = three(Missing::break_curve);
  EXPECT_EQ(breaks.size(), 3U);
  EXPECT_THAT(breaks.breaks.gaps, ElementsAre(1));
}

TEST(KeyBuilder, a_time_cannot_be_skipped_alone_and_a_group_only_with_its_row) {
  const auto may_miss = [](std::size_t cell, Missing missing) {
    KeyBuilder keys(columns, {{}, missing});
    keys.begin_key();
    return keys.miss(columns.cells[cell]);
  };
  EXPECT_FALSE(may_miss(1, Missing::skip_cell));
  EXPECT_TRUE(may_miss(1, Missing::break_curve));
  EXPECT_FALSE(may_miss(0, Missing::skip_cell));
  EXPECT_FALSE(may_miss(0, Missing::break_curve));
  EXPECT_TRUE(may_miss(0, Missing::skip_row));
  EXPECT_TRUE(may_miss(5, Missing::error)) << "a label may be empty";
}

TEST(KeyBuilder, decimals_are_kept_as_written) {
  KeyBuilder keys(columns, {.keeps_decimals = true});
  keys.begin_key();
  keys.take_decimal(columns.cells[3], "0.10");
  EXPECT_TRUE(keys.end_key());
  keys.set_position(1, 1);
  const KeyBlock block = keys.finish();
  ASSERT_EQ(block.decimals.size(), NumberOfKey::position + 2U);
  EXPECT_EQ(block.decimals[NumberOfKey::position + 1], "0.10");
  EXPECT_EQ(block.decimals[NumberOfKey::time], "");
}

TEST(KeyBuilder, breaks_are_before_the_next_key_that_is_kept) {
  KeyBuilder keys(columns, {{}, Missing::skip_row});
  add(keys, 1);
  keys.break_curve();
  add(keys, 2, false);
  add(keys, 3);
  keys.break_curve();
  const KeyBlock block = keys.finish("keys");
  EXPECT_THAT(block.breaks.before, ElementsAre(1));
  EXPECT_TRUE(block.breaks.at_end);
  EXPECT_EQ(block.text_positions.path, "keys");
}

TEST(KeyBuilder, a_key_that_is_not_ended_is_dropped) {
  KeyBuilder keys(columns, {});
  keys.begin_key();
  add(keys, 1);
  keys.begin_key();
  EXPECT_THAT(keys.finish().keys.positions, ElementsAre(10, 20));
}

TEST(KeyBuilder, there_is_a_limit_to_faults) {
  KeyBuilder keys(columns, {});
  for (std::size_t i = 0; i < most_faults + 10; ++i) add(keys, static_cast<double>(i), false);
  EXPECT_TRUE(keys.is_full());
  EXPECT_EQ(keys.finish().faults.errors.size(), most_faults);
}

}  // namespace
}  // namespace tcb
