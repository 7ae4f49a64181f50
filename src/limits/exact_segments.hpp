// Exact segments: the segments of a curve as bounded and as exact numbers, with the angles of rotations as further
// channels.
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
#include "numbers/rational.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb::limits {

/// Segments at a scalar as ones at another. The numbers of a segment are converted with their unit, the largest of
/// them.
template <class To, class From, class Convert>
spline::Segments<To> converted(const spline::Segments<From>& from, const Convert& convert) {
  spline::Segments<To> to{from.channels, {}, {}, {}};
  const From zero(0), one(1);
  for (const From& time : from.times) to.times.push_back(convert(time, time));
  for (std::size_t i = 0; i < from.size(); ++i) {
    From unit = zero;
    for (const spline::Cubic<From>& x : from[i]) {
      for (const From& part : {x.p0, x.p1, x.out, x.in, x.c}) unit = std::max(unit, part < zero ? -part : part);
    }
    for (const spline::Cubic<From>& x : from[i]) {
      const auto number = [&](const From& part) { return convert(part, unit); };
      to.cubics.push_back({number(x.p0), number(x.out), number(x.c), To(0), number(x.p1), number(x.in), number(x.e),
                           To(0), number(x.d)});
    }
  }
  for (const auto& warp : from.warps) {
    if (warp.is_cubic()) {
      to.warps.push_back(spline::Warp<To>::cubic(convert(warp.first_derivative(zero, {}), one),
                                                 convert(warp.first_derivative(one, {}), one)));
    } else if (warp.has_ease()) {
      const To first = convert(warp.end_of_first_part(), one), last = convert(warp.start_of_last_part(), one);
      const To k = To(1) + (first - last) / To(2);
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
      const auto [x, y, z] = rotation.rate({S(0), S(-1)});
      const S zero(0), rate = spline::square_root(x * x + (y * y + z * z));
      segments.cubics.push_back({zero, rate, zero, zero, rate, rate, zero, zero, zero});
    }
  }
}

/// The segments of a curve with bounded errors, and exactly.
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
      irrational_ = curve_at<LongFloat>(plain);
    }
    if (turns) turning_ = curve_at<LongFloat>(exact);
    if (is_rational()) {
      bounded_ = curve_at<Bounded>(plain);
    } else {
      double_doubles_ = curve_at<spline::DoubleDouble>(turns ? exact : plain);
    }
  }

  /// Otherwise they have the bits of floats, and bounded ones estimated errors.
  bool is_rational() const { return rational_ && !turning_; }
  std::size_t size() const { return resting_ ? 1 : bounded_ ? bounded_->size() : double_doubles_->size(); }

  /// Nothing where there are only exact ones.
  std::optional<spline::Segments<Bounded>> bounded(std::size_t first, std::size_t to) const {
    if (resting_) return std::nullopt;
    if (bounded_) return bounded_->segments(first, to);
    auto segments = double_doubles_->segments(first, to);
    if (!segments.rotations.empty()) add_angles(segments);
    using Number = spline::DoubleDouble;
    return converted<Bounded>(segments, [](const Number& x, const Number& unit) {
      return Bounded(x, x.hi == 0 ? 0 : 0x1p-88 * std::max(std::abs(unit.hi), std::abs(x.hi)));
    });
  }

  spline::Segments<Rational> operator()(std::size_t number) const {
    if (resting_) return *resting_;
    const spline::Segments<Rational> plain =
        rational_ ? rational_->segments(number, number + 1) : rounded(*irrational_, number);
    if (!turning_) return plain;
    spline::Segments<Rational> all = rounded(*turning_, number);
    all.times = plain.times;
    all.warps = plain.warps;
    const std::vector<bool> are_in_rotations = spline::in_rotations(rotations_, plain.channels);
    for (std::size_t i = 0; i < plain.channels; ++i) {
      if (!are_in_rotations[i]) all.cubics[i] = plain.cubics[i];
    }
    return all;
  }

 private:
  static spline::Segments<Rational> rounded(const spline::CurveKeys<LongFloat>& curve, std::size_t number) {
    auto segment = curve.segments(number, number + 1);
    if (!segment.rotations.empty()) add_angles(segment);
    return converted<Rational>(segment, [](const LongFloat& x, const LongFloat&) { return rational_of<448>(x); });
  }

  std::vector<spline::KeyRotation> rotations_;
  std::optional<spline::Segments<Rational>> resting_;
  std::shared_ptr<const spline::CurveKeys<Bounded>> bounded_;
  std::shared_ptr<const spline::CurveKeys<spline::DoubleDouble>> double_doubles_;
  std::shared_ptr<const spline::CurveKeys<Rational>> rational_;
  std::shared_ptr<const spline::CurveKeys<LongFloat>> irrational_, turning_;
};

}  // namespace tcb::limits
