// Exact segments: the segments of a curve as exact numbers, with the angles of rotations as further channels.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exact/exact_curve.hpp"
#include "exact/exact_keys.hpp"
#include "exact/float_scalar.hpp"
#include "limits/ball.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb::limits {

/// A segment at a scalar as one at another.
template <class To, class From, class Convert>
spline::Segments<To> converted(const spline::Segments<From>& from, const Convert& exact) {
  spline::Segments<To> to{from.channels, {exact(from.times[0]), exact(from.times[1])}, {}, {}};
  const To two(2), three(3);
  for (const auto& x : from.cubics) {
    const To out = exact(x.out), in = exact(x.in), c = exact(x.c);
    const To d = (in - out - two * c) / three;  // so that a rest at the end is one
    to.cubics.push_back({exact(x.p0), out, c, To(0), exact(x.p1), in, exact(x.e), To(0), d});
  }
  for (const auto& warp : from.warps) {
    if (warp.is_cubic()) {
      to.warps.push_back(spline::Warp<To>::cubic(exact(warp.first_derivative(From(0), {})),
                                                 exact(warp.first_derivative(From(1), {}))));
    } else if (warp.has_ease()) {
      const To first = exact(warp.end_of_first_part()), last = exact(warp.start_of_last_part());
      const To k = To(1) + (first - last) / two;
      to.warps.emplace_back(first / k, (To(1) - last) / k);
    } else {
      to.warps.emplace_back();
    }
  }
  return to;
}

/// Segments with a further channel for each rotation: the angle that it turns at a constant rate.
template <class S>
void add_angles(spline::Segments<S>& segments) {
  if (segments.size() == 0) return;
  const spline::Segments<S> before = segments;
  const std::size_t rotations = segments.rotations.size() / segments.size();
  segments.channels += rotations;
  segments.cubics.clear();
  for (std::size_t i = 0; i < before.size(); ++i) {
    segments.cubics.insert(segments.cubics.end(), before[i].begin(), before[i].end());
    for (const spline::RotationSegment<S>& rotation : before.rotations_of(i)) {
      using std::sqrt;
      const auto [x, y, z] = rotation.rate({S(0), S(-1)});
      const S zero(0), rate = sqrt(x * x + (y * y + z * z));
      segments.cubics.push_back({zero, rate, zero, zero, rate, rate, zero, zero, zero});
    }
  }
}

/// The segments of a curve, one by one. Where these are irrational, they have 2400 bits, those of rotations 448.
class ExactSegments {
 public:
  /// `turns`: also the numbers of its rotations, and their angles as further channels.
  ExactSegments(const ExactCurve& exact, bool turns) : rotations_(exact.rules.rotations) {
    ExactCurve plain = exact;
    plain.rules.rotations.clear();
    if (exact.keys.size() == 1) {
      resting_ = spline::constant_segment(plain.keys, plain.rules);
      resting_->channels += rotations_.size();
      resting_->cubics.resize(resting_->channels);
      return;
    }
    if (plain.is_rational()) {
      rational_ = curve_at<Rational>(plain);
    } else {
      irrational_ = curve_at<WidestFloat>(plain);
    }
    if (turns) turning_ = curve_at<LongFloat>(exact);
    of_balls_ = turns ? exact : std::move(plain);
  }

  /// Those of irrational curves have estimated errors. Throws: Undecided where balls do not decide it.
  spline::Segments<Ball> in_balls(std::size_t number) {
    if (resting_) throw Undecided();
    if (rational_ && !turning_) {
      if (!bounded_) bounded_ = curve_at<Bounded>(of_balls_);
      return converted<Ball>(bounded_->segments(number, number + 1), [](const Bounded& x) {
        if (!std::isfinite(x.error)) throw Undecided();
        return Ball(x.value).widened(x.error);
      });
    }
    if (!double_doubles_) double_doubles_ = curve_at<spline::DoubleDouble>(of_balls_);
    auto segment = double_doubles_->segments(number, number + 1);
    if (!segment.rotations.empty()) add_angles(segment);
    double scale = 0;
    for (const auto& x : segment.cubics) {
      for (const auto& part : {x.p0, x.p1, x.out, x.in, x.c, x.d}) scale = std::max(scale, std::abs(part.hi));
    }
    return converted<Ball>(segment, [&](const spline::DoubleDouble& x) {
      return Ball(x).widened(x.hi == 0 ? 0 : 0x1p-88 * std::max(scale, std::abs(x.hi)));
    });
  }

  spline::Segments<Rational> operator()(std::size_t number) const {
    if (resting_) return *resting_;
    const spline::Segments<Rational> plain =
        rational_ ? rational_->segments(number, number + 1) : rounded<2400>(*irrational_, number);
    if (!turning_) return plain;
    spline::Segments<Rational> all = rounded<448>(*turning_, number);
    all.times = plain.times;
    all.warps = plain.warps;
    const std::vector<bool> are_in_rotations = spline::in_rotations(rotations_, plain.channels);
    for (std::size_t i = 0; i < plain.channels; ++i) {
      if (!are_in_rotations[i]) all.cubics[i] = plain.cubics[i];
    }
    return all;
  }

 private:
  template <unsigned bits>
  static spline::Segments<Rational> rounded(const spline::CurveKeys<Float<bits>>& curve, std::size_t number) {
    auto segment = curve.segments(number, number + 1);
    if (!segment.rotations.empty()) add_angles(segment);
    return converted<Rational>(segment, [](const Float<bits>& x) { return rational_of<bits>(x); });
  }

  std::vector<spline::KeyRotation> rotations_;
  std::optional<spline::Segments<Rational>> resting_;
  ExactCurve of_balls_;
  std::shared_ptr<const spline::CurveKeys<Bounded>> bounded_;  ///< these are made when they are needed
  std::shared_ptr<const spline::CurveKeys<spline::DoubleDouble>> double_doubles_;
  std::shared_ptr<const spline::CurveKeys<Rational>> rational_;
  std::shared_ptr<const spline::CurveKeys<WidestFloat>> irrational_;
  std::shared_ptr<const spline::CurveKeys<LongFloat>> turning_;
};

}  // namespace tcb::limits
