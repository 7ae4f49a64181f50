// Lengths in balls: lengths and their inverse are held by their balls, against 80 digits, also where the speed is zero
// or nearly so.
#include "exact/ball_length.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "exact/floats.hpp"

namespace tcb {
namespace {

using ExactLength = Float<80>;

ExactLength middle_of_length(const Ball& ball) { return ExactLength(ball.middle().hi) + ExactLength(ball.middle().lo); }

void expect_length_held(const ExactLength& number, const Ball& ball, const char* what) {
  EXPECT_LE(ExactLength(abs(number - middle_of_length(ball))), ExactLength(ball.radius()) + ExactLength("1e-60"))
      << what << " " << ball.middle().hi << " by " << static_cast<double>(ExactLength(number - middle_of_length(ball)));
}

/// A segment at a scalar: from 0 to p1, with the local tangents `out` and `in`, in each channel.
struct Channel {
  double p1, out, in;
};
template <class S>
std::vector<spline::Cubic<S>> segment(const std::vector<Channel>& channels) {
  std::vector<spline::Cubic<S>> cubics;
  for (const auto& [p1, out, in] : channels) {
    cubics.push_back(spline::cubic<S>(S(0), S(p1), S(p1), S(out), S(in)));
  }
  return cubics;
}

void expect_lengths(const std::vector<Channel>& channels, double largest_radius, std::mt19937_64& random) {
  const auto in_balls = segment<Ball>(channels);
  const auto exact = segment<ExactLength>(channels);
  spline::SegmentLength<Ball> balls;
  balls.assign(in_balls, {});
  const spline::ArcLength<ExactLength> arc(exact, {});
  const Ball total = balls.total().value;
  expect_length_held(arc.total().value, total, "length");
  EXPECT_LE(total.radius(), largest_radius * total.middle().hi);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 6; ++i) {
    const double u = unit(random);
    const spline::LocalParameter<Ball> at{Ball(u), Ball(u) - Ball(1.0)};
    expect_length_held(arc.to({ExactLength(u), ExactLength(u) - 1}).value, balls.to(at).value, "length to");
    const Ball s = Ball(unit(random) * total.middle().hi);
    spline::LocalParameter<Ball> place;
    try {
      balls.places(Ball(), total, {&s, 1}, {&place, 1});
    } catch (const Undecided&) {
      continue;
    }
    const ExactLength where =
        spline::ArcInverse<ExactLength>(arc, ExactLength(0), arc.total().value).at(middle_of_length(s)).u;
    expect_length_held(where, place.u, "place");
  }
}

TEST(BallLength, holds_lengths_and_places) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> number(0, 2);
  const auto channels = [&](std::size_t count) {
    std::vector<Channel> result(count);
    for (auto& [p1, out, in] : result) p1 = number(random), out = number(random), in = number(random);
    return result;
  };
  for (int i = 0; i < 12 && !HasFailure(); ++i) {
    expect_lengths(channels(1 + static_cast<std::size_t>(i) % 3), i % 3 == 0 ? 1 : 0x1p-70, random);
  }
}

TEST(BallLength, holds_those_of_cusps_and_rests) {
  std::mt19937_64 random(2);
  expect_lengths({{3, 0, 0}}, 0x1p-80, random);                       // from rest to rest
  expect_lengths({{3, 0, 1}, {4, 0, -2}}, 0x1p-80, random);           // from rest
  expect_lengths({{1, 1, 1}, {2, 2, 2}}, 0x1p-80, random);            // a straight line at constant speed
  expect_lengths({{1, 0, 3}, {2, 0, 6}}, 0x1p-80, random);            // u^3
  expect_lengths({{0, 1, -1}}, 0x1p-60, random);                      // there and back
  expect_lengths({{1, 4, 4}, {0, -2, 2}}, 0x1p-60, random);           // a loop
  expect_lengths({{0, 1, -1}, {1e-6, 1e-6, 1e-6}}, 0x1p-60, random);  // nearly a reversal
}

TEST(BallLength, of_a_point_is_zero) {
  const auto point = segment<Ball>({{0, 0, 0}});
  spline::SegmentLength<Ball> balls;
  balls.assign(point, {});
  EXPECT_TRUE(balls.total().value.is_zero());
}

}  // namespace
}  // namespace tcb
