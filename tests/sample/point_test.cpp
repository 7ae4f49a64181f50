// Points: the same template at doubles and at floats of many digits gives the same numbers, up to rounding.
#include "sample/point.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "exact/float_scalar.hpp"

namespace tcb {
namespace {

/// A segment from time 1 to 3 with three channels, at a scalar.
template <class S>
class Arc {
 public:
  explicit Arc(const std::array<double, 12>& numbers) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t k) { return S(numbers[4 * i + k]); };
      cubics_.push_back(spline::cubic<S>(at(0), at(1), at(2), at(3)));
      cycle_.push_back(at(1));
    }
    segment_ = {S(1), S(3), S(0), S(0), cubics_, {}, true, {}, cycle_, 4};
  }
  /// At a time on the segment.
  Point<S>& at(double t, const OutsideOf<S>& outside = {}) {
    sample_ = {S(t), spline::TimeMap<S>(segment_.start, segment_.end)(S(t))};
    outside_ = outside;
    outside_.t = S(t);
    point_.set(segment_);
    point_.set(sample_, &outside_);
    return point_;
  }

 private:
  std::vector<spline::Cubic<S>> cubics_;
  std::vector<S> cycle_;
  CurveSegmentOf<S> segment_;
  SampleOf<S> sample_;
  OutsideOf<S> outside_;
  Point<S> point_;
};

template <class S>
double value(const Quantity<S>& quantity) {
  EXPECT_TRUE(quantity.defined);
  return static_cast<double>(quantity.value);
}

TEST(Point, doubles_and_floats_of_many_digits_agree) {
  using Fine = Float<136>;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-4, 4);
  for (int i = 0; i < 50; ++i) {
    std::array<double, 12> numbers{};
    for (double& one : numbers) one = number(random);
    Arc<double> rough(numbers);
    Arc<Fine> fine(numbers);
    for (const double t : {1.0, 1.25, 2.75, 3.0}) {
      Point<double>& a = rough.at(t);
      Point<Fine>& b = fine.at(t);
      EXPECT_EQ(a.u(), static_cast<double>(b.u()));
      EXPECT_NEAR(a.position(2), static_cast<double>(b.position(2)), 1e-14);
      EXPECT_NEAR(a.length(), static_cast<double>(b.length()), 1e-13);
      EXPECT_NEAR(value(a.speed()), value(b.speed()), 1e-13);
      EXPECT_NEAR(value(a.tangent(0)), value(b.tangent(0)), 1e-13);
      EXPECT_NEAR(value(a.curvature()) / value(b.curvature()), 1, 1e-10);
      EXPECT_NEAR(value(a.torsion()) / value(b.torsion()), 1, 1e-8);
    }
  }
}

TEST(Point, outside_the_curve_it_continues_repeats_or_holds) {
  Arc<double> arc({0, 6, 2, 2, 1, 1, 0, 0, 0, 3, 3, 3});
  OutsideOf<double> linear;
  linear.beyond = 0.5;
  EXPECT_EQ(arc.at(3, linear).position(0), 6 + 0.5 * 1);
  EXPECT_EQ(arc.at(3, linear).derivatives().acceleration[0], 0);
  OutsideOf<double> offset;
  offset.cycles = -2;
  EXPECT_EQ(arc.at(1, offset).position(0), -12);
  OutsideOf<double> backward;
  backward.backward = true;
  EXPECT_EQ(arc.at(1, backward).derivatives().velocity[2], -1.5);
  OutsideOf<double> hold;
  hold.holds = true;
  EXPECT_EQ(value(arc.at(3, hold).speed()), 0);
  EXPECT_FALSE(arc.at(3, hold).tangent(0).defined);
}

TEST(Point, keys_have_numbers_and_other_points_none) {
  Arc<double> arc({0, 6, 2, 2, 1, 1, 0, 0, 0, 3, 3, 3});
  EXPECT_EQ(value(arc.at(1).key()), 4);
  EXPECT_EQ(value(arc.at(3).key()), 5);
  EXPECT_FALSE(arc.at(2).key().defined);
}

}  // namespace
}  // namespace tcb
