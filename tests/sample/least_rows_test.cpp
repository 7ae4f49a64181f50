// The lower bound on the rows of a tolerance: never more than there are, and soon more than are allowed.
#include "sample/least_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sample/tolerance.hpp"

namespace tcb {
namespace {

ShownCurve random_curve(std::mt19937_64& random, std::size_t channels) {
  std::uniform_real_distribution<double> place(-1, 1);
  spline::Keys<double> keys;
  keys.channels = channels;
  for (int i = 0; i < 5; ++i) {
    keys.times.emplace_back(i * 1.25);
    keys.tcbs.push_back({place(random), place(random), place(random)});
    for (std::size_t c = 0; c < channels; ++c) keys.positions.push_back(place(random));
  }
  return {*spline::Curve<double>::build(keys), {}};
}

TEST(LeastRows, are_never_more_than_the_rows_that_are_enough) {
  std::mt19937_64 random(20);
  for (int round = 0; round < 60; ++round) {
    const auto curve = random_curve(random, 1 + round % 4);
    const double tolerance = std::pow(10, -1 - round % 4);
    const auto rows = rows_within_tolerance(curve, {tolerance}, 1'000'000).times;
    EXPECT_LE(least_rows(curve, tolerance), static_cast<double>(rows.size()));
  }
}

TEST(LeastRows, grow_like_the_root_of_the_distance) {
  std::mt19937_64 random(21);
  for (std::size_t channels = 1; channels <= 4; ++channels) {
    const auto curve = random_curve(random, channels);
    EXPECT_GT(least_rows(curve, 1e-20), 1e9);
    EXPECT_EQ(least_rows(curve, 100), 2);
  }
}

}  // namespace
}  // namespace tcb
