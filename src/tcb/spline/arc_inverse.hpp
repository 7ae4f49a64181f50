// Arc-length inverse: the place on a segment at which a given length is reached.
//
// On a smooth panel the first estimate of the place z is the polynomial of fifth degree that has the values and the
// first two derivatives of the inverse at both ends. If the length at an estimate z0 is short of the wanted one by m,
// then with q = (ds/dz)^2, d = m / square_root(q) and A, B, C, D = q'/q, q''/(2 q), q'''/(6 q), q''''/(24 q)
//   z = z0 + d + k2 d^2 + k3 d^3 + k4 d^4 + k5 d^5 + O(d^6),
//   k2 = -A/4, k3 = (A^2 - B)/6, k4 = (A (13 B - 7 A^2) - 6 C)/48,
//   k5 = (A^2 (35 A^2 - 94 B) + 57 A C + 26 B^2 - 24 D)/240
// which is the Taylor series of the inverse. Where d is not small enough, more such steps follow, kept between bounds;
// the same steps are used on a panel that is not smooth, from a linear estimate.
// Source: J. F. Traub, "Iterative methods for the solution of equations", 1964, section 5.1.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/double_pair.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

template <class S>
class ArcInverse {
 public:
  using W = working_t<S>;

  /// Lengths are those of the curve: `start` at the start of the segment and `end` at its end; these may have more
  /// digits than the length of `arc`. Requires: `arc` outlives it.
  ArcInverse(const ArcLength<S>& arc, const W& start, const W& end) : arc_(arc), start_(start), total_(end - start) {
    if (arc.speed().unit() != S(0)) scale_ = S(1) / arc.speed().unit();
  }

  /// The first place at which the curve has the length s. Requires: start <= s <= end. Promises: accurate to a few
  /// units in the last place of the segment's length, and independent of the lengths before and with it.
  LocalParameter<S> at(const W& s) {
    LocalParameter<S> place;
    at({&s, 1}, {&place, 1});
    return place;
  }

  /// The places for many lengths; fastest for increasing lengths. Requires: as many places as lengths.
  void at(std::span<const W> lengths, std::span<LocalParameter<S>> places) {
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const W s = lengths[i] - start_;
      if (s <= W(0) || scale_ == S(0)) {
        places[i] = {S(0), S(-1)};
      } else if (s >= total_) {
        places[i] = {S(1), S(0)};
      } else if (arc_.panels().empty()) {
        places[i] = {high_part<S>(s / total_), high_part<S>((s - total_) / total_)};
      } else {
        seek(scaled<S>(s, scale_), places[i]);
      }
    }
    find();
  }

 private:
  static constexpr bool is_double = std::is_same_v<S, double>;

  /// The number of places computed together, which hides the latency of divisions and roots.
  static constexpr std::size_t several = is_double ? 2 : 1;

  /// A place to compute on a smooth panel.
  struct Sought {
    const Panel<S>* panel;
    S into;  ///< the length from the panel's start
    LocalParameter<S>* place;
  };

  /// A step in z from a place towards a length.
  template <class T>
  struct Step {
    T whole;  ///< the step itself, by the series
    T size;   ///< the square of its first order, relative to the distance over which the speed changes
  };

  /// The size of a step after which the error of the series is below rounding.
  inline static const S small = is_double ? S(0x1p-17) : std::numeric_limits<S>::epsilon();

  void seek(const W& wanted, LocalParameter<S>& place) {
    const auto& panels = arc_.panels();
    if (wanted <= panels[panel_].before) panel_ = 0;
    while (panel_ + 1 < panels.size() && wanted > panels[panel_ + 1].before) ++panel_;
    const Panel<S>& panel = panels[panel_];
    const S into = std::min(difference<S>(wanted, panel.before), panel.length);
    if (panel.is_smooth()) {
      if (count_ == several) find();
      sought_[count_++] = {&panel, into, &place};
    } else {
      place = local(panel, settled(panel, into, S(2) * (into / panel.length) - S(1)));
    }
  }

  /// Computes the places of the pending lengths.
  void find() {
    const auto put = [&](const Sought& sought, const S& z, const S& size) {
      *sought.place = local(*sought.panel, size <= small ? z : settled(*sought.panel, sought.into, z));
    };
    if constexpr (is_double) {
      if (count_ == 2) {
        const auto& [first, second] = sought_;
        const Panel<S>& a = *first.panel;
        const Panel<S>& b = *second.panel;
        const auto both = [&](std::size_t i) { return DoublePair(a.square[i], b.square[i]); };
        const Quartic<DoublePair> q{both(0), both(1), both(2), both(3), both(4)};
        const DoublePair width(a.width, b.width), length(a.length, b.length), into(first.into, second.into);
        const auto [z, size] = first_step(q, length / width, into / width);
        put(first, z[0], size[0]);
        put(second, z[1], size[1]);
      }
    }
    if (count_ == 1) {
      const auto& [panel, into, place] = sought_[0];
      const auto [z, size] = first_step(panel->square, S(panel->length / panel->width), S(into / panel->width));
      put(sought_[0], z, size);
    }
    count_ = 0;
  }

  /// The place after steps from z, kept between bounds, until they are small.
  S settled(const Panel<S>& panel, const S& into, S z) const {
    S low(-1), high(1);
    S from = z > S(0) ? high : low;
    S reached = z > S(0) ? panel.length : S(0);
    for (int i = 0; i < 2 * std::numeric_limits<S>::digits; ++i) {
      reached += panel_sum(panel, arc_.speed(), from, z);
      from = z;
      const S missing = into - reached;
      const auto next = step(square_near(panel, arc_.speed(), z), S(missing / panel.width));
      if (next.size <= small) return within_panel(S(z + next.whole));
      (missing > S(0) ? low : high) = z;
      z = low < z + next.whole && z + next.whole < high ? z + next.whole : low + (high - low) * S(0.5);
      if (z <= low || z >= high) break;
    }
    return z;
  }

  // T is a pair of numbers, or one number.
  /// The first estimate for a length from the panel's start and the panel's length, both per width.
  template <class T>
  static T estimate(const Quartic<T>& q, const T& length, const T& into) {
    // As a function of t = into / length it is 2 t - 1 plus terms that give the derivatives at the ends.
    const T even = q[0] + q[2] + q[4], odd = q[1] + q[3];
    const T even_slope = S(2.0) * q[2] + S(4.0) * q[4], odd_slope = q[1] + S(3.0) * q[3];
    const T begin = S(1.0) / (even - odd), end = S(1.0) / (even + odd), square = S(0.25) * (length * length);
    const T t = into / length;
    const T k1 = length * (square_root(T(even - odd)) * begin) - S(2.0);
    const T k2 = square * (even_slope - odd_slope) * (begin * begin);
    const T in = length * (square_root(T(even + odd)) * end) - S(2.0);
    const T in_second = square * (even_slope + odd_slope) * (end * end);  // minus half the second derivative at the end
    const T k3 = -in_second - S(6.0) * k1 - S(4.0) * in - S(3.0) * k2;
    const T k4 = S(8.0) * k1 + S(7.0) * in + S(3.0) * k2 + S(2.0) * in_second;
    const T k5 = -in_second - k2 - S(3.0) * (k1 + in);
    return within_panel(T(S(2.0) * t - S(1.0) + t * (k1 + t * (k2 + t * (k3 + t * (k4 + t * k5))))));
  }

  /// A step from a place with the square q of the speed, for a missing length, per width.
  template <class T>
  static Step<T> step(const Quartic<T>& q, const T& missing) {
    using std::max;
    const T unit = S(1.0) / q[0];
    const T a = q[1] * unit, b = q[2] * unit, c = q[3] * unit, e = q[4] * unit, aa = a * a;
    const T d = missing * (square_root(q[0]) * unit), dd = d * d;
    const T k2 = -S(0.25) * a;
    const T k3 = (aa - b) * (S(1) / S(6));
    const T k4 = (a * (S(13.0) * b - S(7.0) * aa) - S(6.0) * c) * (S(1) / S(48));
    const T k5 =
        (aa * (S(35.0) * aa - S(94.0) * b) + S(57.0) * (a * c) + S(26.0) * (b * b) - S(24.0) * e) * (S(1) / S(240));
    return {d * (S(1.0) + d * (k2 + d * (k3 + d * (k4 + d * k5)))), dd * (S(1.0) + (aa + max(b, T(-b)) + dd * e))};
  }

  /// One step from the estimate, which is nearly always enough.
  template <class T>
  static Step<T> first_step(const Quartic<T>& q, const T& length, const T& into) {
    const T z = estimate(q, length, into);
    const T from = if_positive(z, T(1.0), T(-1.0));
    const T reached = if_positive(z, length, T(0.0)) + root_integral<S, part_points<S>>(q, from, z);
    const auto [whole, size] = step(quartic_about(q, z), T(into - reached));
    return {within_panel(T(z + whole)), size};
  }

  template <class T>
  static T within_panel(const T& z) {
    using std::min, std::max;
    return min(T(1.0), max(T(-1.0), z));
  }
  static LocalParameter<S> local(const Panel<S>& panel, const S& z) {
    const S v = panel.middle + panel.width * z;
    return panel.half == 0 ? LocalParameter<S>{v, v - S(1)} : LocalParameter<S>{S(1) + v, v};
  }

  const ArcLength<S>& arc_;
  W start_, total_;
  S scale_{0};  ///< from lengths to units of the speed
  std::size_t panel_ = 0;
  std::size_t count_ = 0;
  std::array<Sought, several> sought_{};
};

}  // namespace tcb::spline
