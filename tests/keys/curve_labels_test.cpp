// Curve labels: the column that distinguishes curves.
#include "keys/order.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

/// Keys with a mark and a channel each.
KeyBlock labelled_block(const std::vector<double>& times, const std::vector<std::size_t>& marks,
                        const std::vector<double>& positions) {
  KeyBlock block;
  block.keys.channels = 1;
  for (std::size_t i = 0; i < times.size(); ++i) {
    block.keys.times.push_back(Time(times[i]));
    block.keys.positions.push_back(positions[i]);
    block.text_positions.lines.push_back(i + 1);
  }
  block.marks = marks;
  return block;
}

TEST(CurveLabels, a_column_distinguishes_curves_if_times_increase_for_each_of_its_values) {
  const CurveLabels labels{{{"name", true}}, {}};
  const std::vector<double> positions(4);
  EXPECT_EQ(labels.distinguishing(labelled_block({0, 0, 1, 1}, {7, 8, 7, 8}, positions), true), "name");
  EXPECT_EQ(labels.distinguishing(labelled_block({0, 2, 1, 3}, {7, 7, 8, 8}, positions), true), "name");
  EXPECT_EQ(labels.distinguishing(labelled_block({0, 2, 1, 3}, {7, 7, 7, 8}, positions), true), "");
  EXPECT_EQ(labels.distinguishing(labelled_block({0, 2, 1, 3}, {5, 6, 7, 8}, positions), true), "") << "one each";
  EXPECT_EQ(labels.distinguishing(labelled_block({0, 1, 2, 3}, {7, 7, 7, 7}, positions), true), "") << "one for all";
}

TEST(CurveLabels, numbers_count_if_they_are_whole_and_called_so) {
  const std::vector<double> times{0, 0, 1, 1};
  EXPECT_EQ((CurveLabels{{}, {"track_id"}}).distinguishing(labelled_block(times, {}, {7, 8, 7, 8}), false), "track_id");
  EXPECT_EQ((CurveLabels{{}, {"track_id"}}).distinguishing(labelled_block(times, {}, {7, 8, 7, 8}), true), "");
  EXPECT_EQ((CurveLabels{{}, {"track_id"}}).distinguishing(labelled_block(times, {}, {7.5, 8, 7.5, 8}), false), "");
  EXPECT_EQ((CurveLabels{{}, {"level"}}).distinguishing(labelled_block(times, {}, {7, 8, 7, 8}), false), "");
  const CurveLabels unused{{{"id", false}}, {}};
  EXPECT_EQ(unused.distinguishing(labelled_block(times, {7, 8, 7, 8}, {0, 0, 0, 0}), false), "id");
}

}  // namespace
}  // namespace tcb
