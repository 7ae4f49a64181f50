// The inverse of arc length: where on a segment a given length is reached.
//
// On a panel the place z is first guessed from the speeds at the panel's ends. The length at a guess z0 by the rule,
// short of the wanted one by m, gives with q = (ds/dz)^2, d = m / sqrt(q) and A = q'/q, B = q''/(2 q), C = q'''/(6 q)
//   z = z0 + d (1 + d (-A/4 + d (A A/6 - B/6 + d (13 A B/48 - C/8 - 7 A^3/48)))) + O(d^5)
// the Taylor series of the inverse. What is left after a short step, a rule of few points finds.
// Source: J. F. Traub, "Iterative methods for the solution of equations", 1964, section 5.1.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "spline/arc_length.hpp"

namespace tcb::spline {

template <class S>
class ArcInverse {
 public:
  using W = working_t<S>;

  /// `total` is the length of the segment, which may have more digits than that of `arc`.
  /// Requires: `arc` outlives it.
  ArcInverse(const ArcLength<S>& arc, const W& total) : arc_(arc), total_(total) {
    if (arc.speed().unit() != S(0)) scale_ = S(1) / arc.speed().unit();
  }

  /// The first place at which the length from the start is s. Requires: 0 <= s <= total. Promises: right to some units
  /// in the last place of the total, and the same whatever was asked for before; lengths in order are found soonest.
  Local<S> at(const W& s) {
    if (s <= W(0) || scale_ == S(0)) return {S(0), S(-1)};
    if (s >= total_) return {S(1), S(0)};
    if (arc_.panels().empty()) return {narrow<S>(s / total_), narrow<S>((s - total_) / total_)};
    const W wanted = scaled<S>(s, scale_);
    const Panel<S>& panel = panel_at(wanted);
    const S into = std::min(difference<S>(wanted, panel.before), panel.length);
    const S v = panel.middle + panel.width * place(panel, into);
    return panel.half == 0 ? Local<S>{v, v - S(1)} : Local<S>{S(1) + v, v};
  }

 private:
  /// A cubic from length on a panel to place, by the paces (1 / speed) at its ends: a guess.
  struct Guess {
    S out, in;
  };

  const Panel<S>& panel_at(const W& wanted) {
    const auto& panels = arc_.panels();
    const std::size_t before = index_;
    if (wanted <= panels[index_].before) index_ = 0;
    while (index_ + 1 < panels.size() && wanted > panels[index_ + 1].before) ++index_;
    if (index_ != before) guess_.reset();
    return panels[index_];
  }

  /// How far to go from a place for a length that is missing there, and how much the pace changes on the way.
  struct Step {
    S size;   ///< the square of its first order, against that of the distance over which the speed changes
    S whole;  ///< by the series
    S pace;   ///< dz/ds at its end
  };

  static constexpr bool is_double = std::numeric_limits<S>::digits <= 53;

  /// Squares of steps after which the series leaves less than a rounding,
  inline static const S exact = is_double ? S(0x1p-20) : std::numeric_limits<S>::epsilon();
  /// or so little that the pace at the step's end is enough.
  inline static const S near = is_double ? S(0x1p-10) : S(0);

  S guess(const Panel<S>& panel, const S& into);
  S place(const Panel<S>& panel, const S& into);
  Step step(const Panel<S>& panel, const S& z, const S& missing) const;

  const ArcLength<S>& arc_;
  W total_;
  S scale_{0};  ///< from lengths to units of the speed
  std::size_t index_ = 0;
  std::optional<Guess> guess_;
};

template <class S>
S ArcInverse<S>::guess(const Panel<S>& panel, const S& into) {
  using std::sqrt;
  const S t = into / panel.length;
  if (!panel.is_smooth()) return S(2) * t - S(1);
  if (!guess_) {
    const auto& [q0, q1, q2, q3, q4] = panel.square;
    const S even = q0 + q2 + q4, odd = q1 + q3;
    const S scale = panel.length / panel.width;
    guess_ = {scale / sqrt(even - odd) - S(2), scale / sqrt(even + odd) - S(2)};
  }
  return S(2) * t - S(1) + t * (S(1) - t) * ((S(1) - t) * guess_->out - t * guess_->in);
}

template <class S>
typename ArcInverse<S>::Step ArcInverse<S>::step(const Panel<S>& panel, const S& z, const S& missing) const {
  using std::abs, std::sqrt;
  const auto q = square_near(panel, arc_.speed(), z);
  const S unit = S(1) / q[0];
  const S pace = sqrt(q[0]) * unit / panel.width;
  const S a = q[1] * unit, b = q[2] * unit, c = q[3] * unit;
  const S d = missing * pace;
  const S k2 = S(-0.25) * a;
  const S k3 = (a * a - b) * (S(1) / S(6));
  const S k4 = a * (S(13) * b - S(7) * (a * a)) * (S(1) / S(48)) - c * S(0.125);
  const S size = d * d * std::max({S(1), S(a * a), S(abs(b))});
  return {size, d * (S(1) + d * (k2 + d * (k3 + d * k4))),
          pace * (S(1) + d * (S(2) * k2 + d * (S(3) * k3 + d * (S(4) * k4))))};
}

/// Steps that stay between bounds, each from the place before.
template <class S>
S ArcInverse<S>::place(const Panel<S>& panel, const S& into) {
  S low(-1), high(1);
  S z = guess(panel, into);
  if (!(low <= z && z <= high)) z = S(0);
  S from = z > S(0) ? high : low;
  S reached = z > S(0) ? panel.length : S(0);
  for (int i = 0; i < 2 * std::numeric_limits<S>::digits; ++i) {
    reached += panel_sum(panel, arc_.speed(), from, z);
    from = z;
    const S missing = into - reached;
    const Step step = this->step(panel, z, missing);
    const S next = z + step.whole;
    if (step.size <= exact) return std::clamp(next, S(-1), S(1));
    if (step.size <= near && S(-1) <= next && next <= S(1)) {
      const S left = missing - gauss_sum<4>(panel, arc_.speed(), z, next);
      return std::clamp(S(next + left * step.pace), S(-1), S(1));
    }
    (missing > S(0) ? low : high) = z;
    z = low < next && next < high ? next : low + (high - low) * S(0.5);
    if (z <= low || z >= high) break;
  }
  return z;
}

}  // namespace tcb::spline
