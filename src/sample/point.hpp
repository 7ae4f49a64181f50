// A point of a curve at any scalar: position, derivatives, speed, tangent, curvature, torsion, arc length, key.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "sample/curve_segment.hpp"
#include "sample/pace.hpp"
#include "tcb/spline/derivatives.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segment_length.hpp"

namespace tcb {

/// A quantity of a point, if it is defined.
template <class S>
struct Quantity {
  S value{0};
  bool defined = true;
  bool root = false;  ///< it is the root of the value, with its sign
};

template <class S>
class PathShape;

/// A sample on its segment, and the quantities there, each computed once, on demand. It refers to both.
template <class S>
class Point {
 public:
  /// Assigns another segment; a sample on it must follow. `arc`: its lengths, if they are known.
  void set(const CurveSegmentOf<S>& segment, const spline::SegmentLength<S>* arc = nullptr) {
    segment_ = &segment;
    in_rotations_.clear();
    if (!segment.rotation_columns.empty()) {
      in_rotations_ = spline::in_rotations(segment.rotation_columns, segment.cubics.size());
    }
    known_arc_ = arc;
    has_arc_ = false;
  }
  /// `outside`: the relation of its time to a time on the curve; null: it is on the curve.
  void set(const SampleOf<S>& sample, const OutsideOf<S>* outside) {
    sample_ = &sample;
    outside_ = outside;
    has_derivatives_ = false;
    has_moved_ = false;
    motion_ = nullptr;
    shape_.reset();
  }
  /// How the row moves along the curve, after its sample was set; null: as the curve does.
  void set_motion(const MotionOf<S>* motion) { motion_ = motion; }
  /// The end of the piece that begins at the sample; null: there is none.
  void set_end(const SampleOf<S>* end) { end_ = end; }

  const CurveSegmentOf<S>& segment() const { return *segment_; }
  bool is_in_rotation(std::size_t channel) const { return !in_rotations_.empty() && in_rotations_[channel]; }
  const SampleOf<S>& sample() const { return *sample_; }
  const SampleOf<S>& end() const { return *end_; }
  const OutsideOf<S>* outside() const { return outside_; }
  bool at_start() const { return sample_->at.u == S(0); }
  bool at_end() const { return sample_->at.w == S(0); }

  /// The elapsed fraction of the segment's duration, and the part of its ease there.
  S u() const {
    const auto& at = sample_->at;
    if (at_start() || at_end()) return at.u;
    if constexpr (spline::has_roots<S>) {
      if (std::is_same_v<S, double> || sample_->s) return spline::high_part<S>(segment_->warp.inverse(at));
    }
    // The inverse of a warp has roots, so exact scalars prefer the time, from which the place was computed.
    const spline::Time<S>& t = outside_ == nullptr ? sample_->t : outside_->t;
    return spline::high_part<S>((t - segment_->start) / (segment_->end - segment_->start));
  }

  spline::EasePart part() const {
    const CurveSegmentOf<S>& segment = *segment_;
    if (!segment.warp.has_ease()) return spline::EasePart::middle;
    if (sample_->part) return *sample_->part;
    if (sample_->s || at_start() || at_end()) return segment.warp.part(sample_->at, segment.side);
    using W = spline::working_t<S>;
    const spline::Time<S> t = segment.precise(outside_ == nullptr ? sample_->t : outside_->t);
    return segment.warp.part(W(t - segment.precise(segment.start)), W(segment.precise(segment.end) - t),
                             W(segment.duration()), segment.side);
  }

  /// One component. Outside the curve the end is extended by its velocity, or moved by whole cycles.
  S position(std::size_t channel) {
    S position = spline::position(segment_->cubics[channel], sample_->at);
    if (outside_ == nullptr) return position;
    const S beyond = spline::high_part<S>(outside_->beyond);
    if (beyond != S(0)) position += derivatives().velocity[channel] * beyond;
    if (outside_->cycles != S(0)) position += outside_->cycles * segment_->cycle[channel];
    return position;
  }

  /// A rotation. Outside the curve, `linear` keeps turning at the rate of the end, `offset` adds the turn of the whole
  /// curve once per period, and `repeat` negates the quaternion in odd periods where its sign would jump.
  spline::Quaternion<S> rotation(std::size_t index) const {
    const spline::Quaternion<S> q = segment_->rotations[index].at(sample_->at);
    if (outside_ == nullptr) return q;
    const S beyond = spline::high_part<S>(outside_->beyond);
    if (beyond != S(0)) {
      const auto rate = rate_on_curve(index);
      const S half = beyond / S(2);
      return spline::normalized(spline::exponential<S>({rate[0] * half, rate[1] * half, rate[2] * half}) * q);
    }
    if (outside_->odd && segment_->turns[index].w < S(0)) return -q;
    return outside_->cycles == S(0) ? q : spline::normalized(turn_of_cycles(index) * q);
  }

  /// The velocity and acceleration of the row. At a pace, with the curve X at its arc length s, they are X' s' and
  /// X'' s'^2 + X' s''.
  const std::vector<S>& row_velocity() { return motion_ == nullptr ? derivatives().velocity : moved().velocity; }
  const std::vector<S>& row_acceleration() {
    return motion_ == nullptr ? derivatives().acceleration : moved().acceleration;
  }
  /// At a pace they are not where the curve rests, unless the row does.
  bool has_row_velocity() { return motion_ == nullptr || has_direction() || motion_->speed == 0; }
  bool has_row_acceleration() {
    return motion_ == nullptr || has_direction() || (motion_->speed == 0 && motion_->acceleration == 0);
  }

  /// The angular velocity of a rotation, in the frame in which it is given, per unit of time.
  spline::Vector3<S> angular_velocity(std::size_t index) {
    if (motion_ != nullptr) {  // the rate by u, times s' / (ds/du)
      const S factor = has_direction() ? motion_->speed / local_speed_ : S(0);
      const auto rate = segment_->rotations[index].rate(sample_->at);
      return {rate[0] * factor, rate[1] * factor, rate[2] * factor};
    }
    if (segment_->start == segment_->end || (outside_ != nullptr && outside_->holds)) return {S(0), S(0), S(0)};
    const spline::Vector3<S> rate = rate_on_curve(index);
    if (outside_ == nullptr) return rate;
    if (outside_->backward) return {-rate[0], -rate[1], -rate[2]};
    if (outside_->cycles == S(0)) return rate;
    const spline::Quaternion<S> turn = turn_of_cycles(index);
    const auto turned = turn * spline::Quaternion<S>{rate[0], rate[1], rate[2], S(0)} * spline::conjugate(turn);
    return {turned.x, turned.y, turned.z};
  }

  const spline::Derivatives<S>& derivatives() {
    if (!has_derivatives_) set_derivatives();
    has_derivatives_ = true;  // only now: some scalars throw
    return derivatives_;
  }

  /// From the curve's first key.
  S length() {
    if constexpr (spline::has_roots<S>) {
      using W = spline::working_t<S>;
      if (sample_->s) return *sample_->s;
      if (at_start()) return spline::high_part<S>(segment_->s_start);
      if (at_end()) return spline::high_part<S>(segment_->s_end);
      return spline::high_part<S>(segment_->s_start + W(arc().to(sample_->at).value));
    } else {
      return S(0);  // lengths are not rational
    }
  }

  Quantity<S> key() const {
    if (at_start()) return {static_cast<S>(static_cast<double>(segment_->number))};
    if (at_end()) return {static_cast<S>(static_cast<double>(segment_->end_key))};
    return {S(0), false};
  }

  // Over the metric channels:
  Quantity<S> speed() {
    using std::abs;
    return motion_ == nullptr ? shape_.speed(*this) : Quantity<S>{S(abs(motion_->speed))};
  }
  Quantity<S> tangent(std::size_t channel) { return shape_.tangent(*this, channel); }
  Quantity<S> curvature() { return shape_.curvature(*this); }
  Quantity<S> torsion() { return shape_.torsion(*this); }

 private:
  const spline::SegmentLength<S>& arc() {
    if (known_arc_ != nullptr) return *known_arc_;
    if (!has_arc_) arc_.assign(segment_->cubics, segment_->metric);
    has_arc_ = true;  // only now: some scalars throw
    return arc_;
  }

  /// Whether the curve moves at the place of a row, so that its direction is known there.
  bool has_direction() {
    (void)moved();
    return local_speed_ > S(0);
  }

  const spline::Derivatives<S>& moved() {
    if constexpr (spline::has_roots<S>) {
      if (!std::exchange(has_moved_, true)) set_moved();
    }
    return moved_;
  }

  void set_moved() {
    spline::set_derivatives<S>(moved_, segment_->cubics, sample_->at, {}, S(0), S(1));
    const spline::MetricView<S> v(moved_.velocity, segment_->metric), a(moved_.acceleration, segment_->metric);
    local_speed_ = local_speed();
    const bool moves = local_speed_ > S(0);
    S along(0);
    for (std::size_t i = 0; i < v.size() && moves; ++i) along += v[i] / local_speed_ * a[i];
    using std::abs, std::ldexp;
    const S unit = ldexp(S(1), 52 - std::numeric_limits<S>::digits);  // of the noise at this scalar
    const S noise =
        moves ? S((moved_.acceleration_noise + moved_.velocity_noise / local_speed_ * abs(along)) * unit) : S(0);
    const S ratio = moves ? S(motion_->speed / local_speed_) : S(0);
    for (std::size_t i = 0; i < moved_.velocity.size(); ++i) {
      const S direction = moves ? S(moved_.velocity[i] / local_speed_) : S(0);
      const S turning = moved_.acceleration[i] - direction * along;
      const S across = abs(turning) > noise ? turning : S(0);  // of a straight path
      moved_.velocity[i] = direction * motion_->speed + S(0);  // a zero is not negative
      moved_.acceleration[i] = across * ratio * ratio + direction * motion_->acceleration + S(0);
    }
  }

  /// The length of the velocity by u; 0 where the curve rests: for doubles within the noise, for other scalars at a key
  /// whose tangent is the error of a 0.
  S local_speed() const {
    if constexpr (std::is_same_v<S, double>) {
      const auto shape = spline::shape(moved_, segment_->metric);
      return shape.moves ? shape.speed : 0;
    } else {
      using std::abs, std::ldexp;
      const S speed = spline::in_units(moved_, segment_->metric, [&](const auto& in, const spline::Units& units) {
        return S(ldexp(spline::norm<S>({in.velocity, segment_->metric}), units.v));
      });
      S terms(0);
      for (const spline::Cubic<S>& x : segment_->cubics) terms += abs(x.out) + abs(x.in) + abs(x.c) + abs(x.d);
      const bool rests = (at_start() || at_end()) && !(speed > ldexp(terms, 16 - std::numeric_limits<S>::digits));
      return rests ? S(0) : speed;
    }
  }

  void set_derivatives() {
    const bool holds = outside_ != nullptr && outside_->holds;
    const auto zero = std::size_t{segment_->cubics.size()};
    if (holds || segment_->start == segment_->end) {
      derivatives_.velocity.assign(zero, S(0));
      derivatives_.acceleration.assign(zero, S(0));
      derivatives_.jerk.assign(zero, S(0));
      derivatives_.velocity_noise = derivatives_.acceleration_noise = S(0);
      return;
    }
    spline::set_derivatives<S>(derivatives_, segment_->cubics, sample_->at, segment_->warp, u(),
                               spline::high_part<S>(segment_->duration()), part());
    if (outside_ == nullptr) return;
    if (spline::high_part<S>(outside_->beyond) != S(0)) {
      derivatives_.acceleration.assign(zero, S(0));
      derivatives_.jerk.assign(zero, S(0));
    }
    if (!outside_->backward) return;
    for (auto* odd : {&derivatives_.velocity, &derivatives_.jerk}) {
      for (S& value : *odd) value = -value;
    }
  }

  spline::Vector3<S> rate_on_curve(std::size_t rotation) const {
    const S du = segment_->warp.first_derivative(u(), part()) / spline::high_part<S>(segment_->duration());
    const auto rate = segment_->rotations[rotation].rate(sample_->at);
    return {rate[0] * du, rate[1] * du, rate[2] * du};
  }
  /// The turn of the whole curve, once per period.
  spline::Quaternion<S> turn_of_cycles(std::size_t rotation) const {
    const auto turn = spline::logarithm(segment_->turns[rotation]);
    const S& count = outside_->cycles;
    return spline::exponential<S>({turn[0] * count, turn[1] * count, turn[2] * count});
  }

  const CurveSegmentOf<S>* segment_ = nullptr;
  std::vector<bool> in_rotations_;  ///< its channels; empty: it has no rotations
  const SampleOf<S>* sample_ = nullptr;
  const SampleOf<S>* end_ = nullptr;
  const OutsideOf<S>* outside_ = nullptr;
  const MotionOf<S>* motion_ = nullptr;
  const spline::SegmentLength<S>* known_arc_ = nullptr;
  spline::SegmentLength<S> arc_;
  bool has_arc_ = false;
  spline::Derivatives<S> derivatives_;
  bool has_derivatives_ = false;
  spline::Derivatives<S> moved_;  ///< of the row at a pace
  S local_speed_{};               ///< of the curve by u, 0 where it rests
  bool has_moved_ = false;
  PathShape<S> shape_;
};

/// The derivatives at a point without its ease, of which curvature and torsion are the same: near a rest nothing
/// cancels. Outside the curve, where it is extended, it has no ease. `memory` holds them.
template <class S>
const spline::Derivatives<S>& without_ease(Point<S>& point, spline::Derivatives<S>& memory) {
  const CurveSegmentOf<S>& segment = point.segment();
  const bool extended = point.outside() != nullptr && point.outside()->beyond != spline::Time<S>(0);
  if (segment.warp.is_identity() || extended) return point.derivatives();
  spline::set_derivatives<S>(memory, segment.cubics, point.sample().at, {}, S(0),
                             spline::high_part<S>(segment.duration()));
  return memory;
}

/// The shape of the path in doubles: values within the bounds on rounding of spline::shape are 0.
template <>
class PathShape<double> {
 public:
  void reset() { shape_.reset(); }

  Quantity<double> speed(Point<double>& point) { return {shape(point).speed}; }
  Quantity<double> tangent(Point<double>& point, std::size_t channel) {
    const auto& known = shape(point);
    if (!known.moves) return {0, false};
    return {point.derivatives().velocity[channel] / known.speed};
  }
  Quantity<double> curvature(Point<double>& point) {
    if (!shape(point).moves) return {0, false};
    const spline::Derivatives<double>& plain = without_ease(point, memory_);
    if (&plain != &memory_) return quantity(shape(point).curvature);
    return quantity(spline::shape(plain, point.segment().metric).curvature);
  }
  Quantity<double> torsion(Point<double>& point) {
    if (!shape(point).moves) return {0, false};
    return quantity(spline::torsion(without_ease(point, memory_), point.segment().metric));
  }

 private:
  static Quantity<double> quantity(const std::optional<double>& value) {
    return {value.value_or(0), value.has_value()};
  }
  const spline::Shape<double>& shape(Point<double>& point) {
    if (!shape_) shape_ = spline::shape(point.derivatives(), point.segment().metric);
    return *shape_;
  }

  std::optional<spline::Shape<double>> shape_;
  spline::Derivatives<double> memory_;
};

/// The shape of the path at other scalars, for those without roots as roots of numbers. With roots, products in |v ^ a|
/// that agree in two thirds of their digits are equal. Double-doubles leave that open, as they do what squares beyond
/// their range are, and give no number.
template <class S>
class PathShape {
 public:
  void reset() {}

  Quantity<S> speed(Point<S>& point) const { return root(square_of(velocity(point))); }
  Quantity<S> tangent(Point<S>& point, std::size_t channel) const {
    const S v2 = square_of(velocity(point));
    if (v2 == S(0)) return {S(0), false};
    const S& v = point.derivatives().velocity[channel];
    if constexpr (spline::has_roots<S>) {
      return {v / spline::square_root(v2)};
    } else {
      return {v < S(0) ? S(-(v * v / v2)) : S(v * v / v2), true, true};
    }
  }

  Quantity<S> curvature(Point<S>& point) {
    if (square_of(velocity(point)) == S(0)) return {S(0), false};
    const auto& [velocity, acceleration, jerk, n1, n2] = without_ease(point, memory_);
    const View v(velocity, point.segment().metric), a(acceleration, point.segment().metric);
    const S area2 = square_of_area(v, a), v2 = square_of(v);
    return root(area2 / (v2 * v2 * v2));
  }

  Quantity<S> torsion(Point<S>& point) {
    if (square_of(velocity(point)) == S(0)) return {S(0), false};
    const auto& [velocity, acceleration, jerk, n1, n2] = without_ease(point, memory_);
    const std::span<const std::size_t> metric = point.segment().metric;
    const View v(velocity, metric), a(acceleration, metric), j(jerk, metric);
    const S area2 = square_of_area(v, a);
    if (area2 == S(0)) return {S(0), false};
    if (v.size() < 3) return {S(S(0) / area2)};
    if (v.size() == 3) return {minor3(v, a, j, 0, 1, 2) / area2};
    return root(wedge_square(v, a, j) / (area2 * area2));
  }

 private:
  using View = spline::MetricView<S>;

  static View velocity(Point<S>& point) { return {point.derivatives().velocity, point.segment().metric}; }
  static constexpr bool is_double_double = std::is_same_v<S, spline::DoubleDouble>;

  /// The square of a number, or no number.
  static S in_range(const S& square) {
    if constexpr (is_double_double) {
      const bool is_out = square.hi != 0 && !(square.hi > 0x1p-900 && square.hi < 0x1p900);
      if (is_out) return std::numeric_limits<S>::quiet_NaN();
    }
    return square;
  }

  /// |v|^2
  static S square_of(const View& v) {
    if constexpr (is_double_double) {
      for (std::size_t i = 0; i < v.size(); ++i) {
        if (v[i].hi != 0) {
          const S sum = square(v);
          return sum.hi == 0 ? S(std::numeric_limits<double>::quiet_NaN()) : in_range(sum);
        }
      }
    }
    return square(v);
  }

  /// |v ^ a|^2
  static S square_of_area(const View& v, const View& a) {
    if constexpr (!spline::has_roots<S>) {
      return wedge_square(v, a);
    } else {
      using std::abs, std::ldexp;
      const S rounding = ldexp(S(1), -std::numeric_limits<S>::digits * 2 / 3);
      S sum(0);
      for (std::size_t i = 0; i < v.size(); ++i) {
        for (std::size_t k = i + 1; k < v.size(); ++k) {
          const S first = v[i] * a[k], second = v[k] * a[i], minor = first - second;
          const bool is_equal = abs(minor) <= rounding * (abs(first) + abs(second));
          if (is_equal && is_double_double && minor != S(0)) return std::numeric_limits<S>::quiet_NaN();
          if (!is_equal) sum += minor * minor;
        }
      }
      return in_range(sum);
    }
  }

  static Quantity<S> root(const S& square) {
    if constexpr (spline::has_roots<S>) {
      return {spline::square_root(square)};
    } else {
      return {square, true, true};
    }
  }

  spline::Derivatives<S> memory_;
};

}  // namespace tcb
