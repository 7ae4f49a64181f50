// A point of the curve at any scalar, and the fields of its row.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "exact/golden_curve.hpp"
#include "exact/rounding.hpp"
#include "tcb/spline/derivatives.hpp"

namespace tcb {

/// How a time outside the curve relates to one inside, as Outside says it in doubles.
template <class S>
struct GoldenOutside {
  S cycles{0}, beyond{0};
  bool holds = false, backward = false;
};

/// Where a row is.
template <class S>
struct Spot {
  std::size_t segment = 0;
  spline::LocalParameter<S> at;
  S passed{};  ///< the fraction of the segment's duration
  S t{};
  std::optional<S> s = std::nullopt;  ///< where it was asked for
  GoldenOutside<S> outside = {};
  bool at_start = false, at_end = false;  ///< of the segment, exactly
};

template <class S>
class GoldenPoint {
 public:
  GoldenPoint(GoldenCurve<S>& curve, Spot<S> spot)
      : curve_(curve), segment_(curve.segment(spot.segment)), spot_(std::move(spot)) {
    set_motion();
  }

  void append_time(std::vector<Value>& row) const { add(row, spot_.t); }
  void append_position(std::vector<Value>& row) const {
    for (std::size_t i = 0; i < segment_.cubics.size(); ++i) {
      S position = spline::position(segment_.cubics[i], spot_.at);
      if (spot_.outside.beyond != S(0)) position += motion_.velocity[i] * spot_.outside.beyond;
      if (spot_.outside.cycles != S(0)) position += spot_.outside.cycles * curve_.cycle(i);
      add_in_channel(row, position, curve_.is_zero(i));
    }
  }
  void append_velocity(std::vector<Value>& row) const { add_all(row, motion_.velocity); }
  void append_acceleration(std::vector<Value>& row) const { add_all(row, motion_.acceleration); }
  void append_jerk(std::vector<Value>& row) const { add_all(row, motion_.jerk); }
  void append_segment(std::vector<Value>& row) const { row.push_back({Rational(spot_.segment)}); }
  void append_u(std::vector<Value>& row) const { add(row, spot_.passed); }
  void append_key(std::vector<Value>& row) const {
    const bool comes_round = spot_.segment + 1 == curve_.size() && curve_.is_closed();
    if (spot_.at_start) return row.push_back({Rational(spot_.segment)});
    if (spot_.at_end) return row.push_back({Rational(comes_round ? 0 : spot_.segment + 1)});
    row.push_back({0, false, true});
  }
  void append_speed(std::vector<Value>& row) const { add_root(row, square(velocity())); }
  void append_tangent(std::vector<Value>& row) const;
  void append_curvature(std::vector<Value>& row) const;
  void append_torsion(std::vector<Value>& row) const;
  void append_length(std::vector<Value>& row) const;

 private:
  using Picked = spline::MetricView<S>;

  void set_motion();
  Picked velocity() const { return {motion_.velocity, curve_.metric()}; }
  Picked acceleration() const { return {motion_.acceleration, curve_.metric()}; }

  /// Numbers that exactly are zero come out as such a part of the curve's size, or less: they were worked out from
  /// positions, and at a place that near a cusp may be right to half the digits only.
  S doubt() const {
    if constexpr (!spline::has_roots<S>) {
      return S(0);
    } else {
      return curve_.extent() * sqrt(sqrt(std::numeric_limits<S>::epsilon()));
    }
  }
  bool moves() const {
    const S least = doubt() * rate_;
    return square(velocity()) > least * least;
  }
  bool bends() const;

  static void add(std::vector<Value>& row, const S& value) { row.push_back({rational_of(value)}); }
  /// Where it comes out as zero, which need not be certain, it may be what is left of large numbers.
  static void add_in_channel(std::vector<Value>& row, const S& value, bool certainly_zero) {
    row.push_back({rational_of(value), false, false, spline::has_roots<S> && value == S(0) && !certainly_zero});
  }
  void add_all(std::vector<Value>& row, const std::vector<S>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) add_in_channel(row, values[i], curve_.is_still(i));
  }
  /// The root of a square, with a sign.
  static void add_root(std::vector<Value>& row, const S& square, bool negative = false) {
    if constexpr (!spline::has_roots<S>) {
      row.push_back({negative ? Rational(-square) : square, true});
    } else {
      const S root = sqrt(square);
      add(row, negative ? S(-root) : root);
    }
  }
  /// What is not defined where a number is zero, and what is zero where another is: that one as it was worked out.
  static void add_empty(std::vector<Value>& row, const S& zero) { row.push_back({0, false, true, zero != S(0)}); }
  static void add_zero(std::vector<Value>& row, const S& zero) { row.push_back({0, false, false, zero != S(0)}); }

  GoldenCurve<S>& curve_;
  const GoldenSegment<S>& segment_;
  Spot<S> spot_;
  spline::Derivatives<S> motion_;
  S rate_{}, bend_{};  ///< from derivatives by u to those by time
};

template <class S>
void GoldenPoint<S>::set_motion() {
  const std::size_t channels = segment_.cubics.size();
  const auto& outside = spot_.outside;
  if (outside.holds || segment_.start == segment_.end) {
    motion_.velocity = motion_.acceleration = motion_.jerk = std::vector<S>(channels, S(0));
    return;
  }
  const S duration = segment_.end - segment_.start;
  rate_ = segment_.warp.first_derivative(spot_.passed) / duration;
  bend_ = segment_.warp.second_derivative(spot_.passed) / (duration * duration);
  spline::set_derivatives<S>(motion_, segment_.cubics, spot_.at, segment_.warp, spot_.passed,
                             segment_.end - segment_.start);
  if (outside.beyond != S(0)) motion_.acceleration = motion_.jerk = std::vector<S>(channels, S(0));
  if (!outside.backward) return;
  for (auto* odd : {&motion_.velocity, &motion_.jerk}) {
    for (S& value : *odd) value = -value;
  }
}

template <class S>
bool GoldenPoint<S>::bends() const {
  const S v2 = square(velocity()), a2 = square(acceleration());
  const S noise = doubt() * rate_, bend_noise = doubt() * (rate_ * rate_ + abs(bend_));
  return wedge_square(velocity(), acceleration()) > S(2) * (noise * noise * a2 + bend_noise * bend_noise * v2);
}

template <class S>
void GoldenPoint<S>::append_tangent(std::vector<Value>& row) const {
  const S v2 = moves() ? square(velocity()) : S(0);
  for (const S& value : motion_.velocity) {
    if (v2 == S(0)) {
      add_empty(row, square(velocity()));
    } else {
      add_root(row, value * value / v2, value < S(0));
    }
  }
}

template <class S>
void GoldenPoint<S>::append_curvature(std::vector<Value>& row) const {
  if (!moves()) return add_empty(row, square(velocity()));
  if (!bends()) return add_zero(row, wedge_square(velocity(), acceleration()));
  const S v2 = square(velocity());
  add_root(row, wedge_square(velocity(), acceleration()) / (v2 * v2 * v2));
}

template <class S>
void GoldenPoint<S>::append_torsion(std::vector<Value>& row) const {
  if (!moves()) return add_empty(row, square(velocity()));
  if (!bends()) return add_empty(row, wedge_square(velocity(), acceleration()));
  const Picked v = velocity(), a = acceleration(), j(motion_.jerk, curve_.metric());
  const S area2 = wedge_square(v, a);
  if (v.size() < 3) return add(row, S(0));
  if (v.size() == 3) return add(row, minor3(v, a, j, 0, 1, 2) / area2);
  add_root(row, wedge_square(v, a, j) / (area2 * area2));
}

template <class S>
void GoldenPoint<S>::append_length(std::vector<Value>& row) const {
  if constexpr (spline::has_roots<S>) {
    if (spot_.s) return add(row, *spot_.s);
    const S before = curve_.length_to(spot_.segment);
    if (spot_.at_start) return add(row, before);
    if (spot_.at_end) return add(row, curve_.length_to(spot_.segment + 1));
    add(row, before + curve_.arc(spot_.segment).to(spot_.at).value);
  } else {
    row.push_back({0});  // for floats to say
  }
}

/// A field of a row at any scalar.
template <class S>
struct Quantity {
  std::string_view name;
  bool rational;  ///< on a curve of rational numbers it is rational at rational times, or the root of a rational
  void (GoldenPoint<S>::*append)(std::vector<Value>& row) const;
};

/// The fields by the names that fields() gives them; what has no row here has no golden value.
template <class S>
inline constexpr std::array quantities{
    Quantity<S>{"time", true, &GoldenPoint<S>::append_time},
    Quantity<S>{"position", true, &GoldenPoint<S>::append_position},
    Quantity<S>{"s", false, &GoldenPoint<S>::append_length},
    Quantity<S>{"velocity", true, &GoldenPoint<S>::append_velocity},
    Quantity<S>{"acceleration", true, &GoldenPoint<S>::append_acceleration},
    Quantity<S>{"jerk", true, &GoldenPoint<S>::append_jerk},
    Quantity<S>{"speed", true, &GoldenPoint<S>::append_speed},
    Quantity<S>{"tangent", true, &GoldenPoint<S>::append_tangent},
    Quantity<S>{"curvature", true, &GoldenPoint<S>::append_curvature},
    Quantity<S>{"torsion", true, &GoldenPoint<S>::append_torsion},
    Quantity<S>{"segment", true, &GoldenPoint<S>::append_segment},
    Quantity<S>{"u", true, &GoldenPoint<S>::append_u},
    Quantity<S>{"key", true, &GoldenPoint<S>::append_key},
};

}  // namespace tcb
