// Exact segments: the segments of a curve as exact numbers, with the angles of rotations as further channels.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exact/ball.hpp"
#include "exact/exact_curve.hpp"
#include "exact/exact_keys.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb::limits {

/// A segment of floats of many digits as rationals.
inline spline::Segments<Rational> rational(const spline::Segments<RealBall>& from) {
  const auto exact = [](const RealBall& x) { return x.middle().rational(); };
  spline::Segments<Rational> to{from.channels, {exact(from.times[0]), exact(from.times[1])}, {}, {}};
  for (const auto& x : from.cubics) {
    const Rational out = exact(x.out), in = exact(x.in), c = exact(x.c) + exact(x.c_low);
    const Rational d = (in - out - 2 * c) / 3;  // so that a rest at the end is one
    to.cubics.push_back({exact(x.p0), out, c, 0, exact(x.p1), in, exact(x.e), exact(x.e_low), d});
  }
  for (const auto& warp : from.warps) {
    if (warp.is_cubic()) {
      to.warps.push_back(spline::Warp<Rational>::cubic(exact(warp.first_derivative(RealBall(0.0), {})),
                                                       exact(warp.first_derivative(RealBall(1.0), {}))));
    } else if (warp.has_ease()) {
      const Rational first = exact(warp.end_of_first_part()), last = exact(warp.start_of_last_part());
      const Rational k = Rational(1) + (first - last) / 2;
      to.warps.emplace_back(first / k, (Rational(1) - last) / k);
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

/// The segments of a curve, one by one. Where these are irrational, they have 400 bits, and for
/// directions so many that those which are equal are known to be so.
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
      const RealPrecision precision(most_bits, true);
      irrational_ = curve_at<RealBall>(plain);
    }
    if (turns) {
      const RealPrecision precision(usual_bits, true);
      turning_ = curve_at<RealBall>(exact);
    }
    of_balls_ = turns ? exact : std::move(plain);
  }

  /// Throws: Undecided where balls do not decide it.
  spline::Segments<Ball> in_balls(std::size_t number) {
    if (resting_) throw Undecided();
    if (!balls_) balls_ = curve_at<Ball>(of_balls_);
    auto segment = balls_->segments(number, number + 1);
    if (!segment.rotations.empty()) add_angles(segment);
    return segment;
  }

  spline::Segments<Rational> operator()(std::size_t number, bool directions) const {
    if (resting_) return *resting_;
    const spline::Segments<Rational> plain = rational_
                                                 ? rational_->segments(number, number + 1)
                                                 : rounded(*irrational_, number, directions ? most_bits : usual_bits);
    if (!turning_) return plain;
    spline::Segments<Rational> all = rounded(*turning_, number, usual_bits);
    all.times = plain.times;
    all.warps = plain.warps;
    const std::vector<bool> are_in_rotations = spline::in_rotations(rotations_, plain.channels);
    for (std::size_t i = 0; i < plain.channels; ++i) {
      if (!are_in_rotations[i]) all.cubics[i] = plain.cubics[i];
    }
    return all;
  }

 private:
  static constexpr int usual_bits = 400, most_bits = 2400;

  static spline::Segments<Rational> rounded(const spline::CurveKeys<RealBall>& curve, std::size_t number, int bits) {
    const RealPrecision precision(bits, true);
    auto segment = curve.segments(number, number + 1);
    if (!segment.rotations.empty()) add_angles(segment);
    return rational(segment);
  }

  std::vector<spline::KeyRotation> rotations_;
  std::optional<spline::Segments<Rational>> resting_;
  ExactCurve of_balls_;
  std::shared_ptr<const spline::CurveKeys<Ball>> balls_;  ///< nothing: not needed before
  std::shared_ptr<const spline::CurveKeys<Rational>> rational_;
  std::shared_ptr<const spline::CurveKeys<RealBall>> irrational_, turning_;
};

}  // namespace tcb::limits
