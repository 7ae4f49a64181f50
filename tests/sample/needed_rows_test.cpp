// Needed rows: the lower bound is one, at any size, and near the rows that are found.
#include "sample/needed_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sample/tolerance.hpp"

namespace tcb {
namespace {

ShownCurve random_curve(std::mt19937_64& random, std::size_t channels, double size) {
  std::uniform_real_distribution<double> place(-1, 1);
  spline::Keys<double> keys;
  keys.channels = channels;
  for (int i = 0; i < 6; ++i) {
    keys.times.emplace_back(i);
    keys.tcbs.push_back({place(random), place(random), place(random)});
    for (std::size_t c = 0; c < channels; ++c) keys.positions.push_back(place(random) * size);
  }
  return {*spline::Curve<double>::build(keys, {}), {}};
}

TEST(NeededRows, are_never_more_than_the_rows_that_are_enough) {
  std::mt19937_64 random(51);
  for (int round = 0; round < 200; ++round) {
    const double size = std::pow(10, (round % 5 - 2) * 150), tolerance = size * std::pow(10, -round % 5);
    const auto rows = rows_within_tolerance(random_curve(random, 1 + round % 4, size), {tolerance}, 1'000'000);
    EXPECT_LE(rows.least, rows.times.size()) << round;
  }
}

TEST(NeededRows, are_two_thirds_of_the_rows_of_a_small_tolerance) {
  std::mt19937_64 random(52);
  for (int round = 0; round < 20; ++round) {
    const auto rows = rows_within_tolerance(random_curve(random, 1 + round % 4, 1), {1e-5}, 1'000'000);
    EXPECT_LT(static_cast<double>(rows.least), 0.75 * static_cast<double>(rows.times.size())) << round;
    EXPECT_GT(static_cast<double>(rows.least), 0.6 * static_cast<double>(rows.times.size())) << round;
  }
}

TEST(NeededRows, are_two_where_one_chord_is_near) {
  NeededRows straight(0.1), bent(0.1);
  for (int i = 0; i <= 1000; ++i) {
    straight.add({0, 0, {}, {i * 0.01, i * 0.01}});
    bent.add({0, 0, {}, {i * 0.01, i < 500 ? 0.0 : i * 0.01 - 5}});
  }
  EXPECT_EQ(straight.count(), 2U);
  EXPECT_EQ(bent.count(), 3U);
}

}  // namespace
}  // namespace tcb
