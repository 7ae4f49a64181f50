// Arc length: how long a segment is, to the last digit, with a bound on the error.
//
// The speed is the root of a quartic. It is smooth but near the minima of the speed, where it may come to
// zero (a cusp, or a reversal) or nearly so. A panel, at first half a segment, is integrated by a
// Gauss-Legendre rule if a bound says that this is right to the last digit. Otherwise it is cut at the minima
// of the speed, and then halved until the rule agrees with itself on both halves. A minimum at which the speed is zero
// does no harm at the end of a panel; one at which it nearly is draws the panels together until what is left cannot
// matter. The length's derivative being the speed itself, the inverse starts from the nodes of a panel, where lengths
// are known, and takes one step of third order.
// Source: P. J. Davis, P. Rabinowitz, "Methods of Numerical Integration", 2.7 and 6.2.
// No epsilon is absolute: scaling by a power of two changes no digit.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "spline/quadrature.hpp"
#include "spline/speed.hpp"

namespace tcb::spline {

/// A length, and a bound on its error.
template <class S>
struct Length {
  S value{};
  S error{};
};

/// The lengths of one segment. It may be set to one segment after another, and keeps its memory.
template <class S>
class ArcLength {
 public:
  ArcLength() = default;
  ArcLength(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) { assign(segment, metric); }

  void assign(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric);

  /// The whole segment. Promises: right to some units in the last place, and to within `error` in any case.
  const Length<S>& total() const { return total_; }

  /// From the start to a place. Promises: as total().
  Length<S> to(const Local<S>& place) const;

  /// Part of a half, short enough for one rule; `before` is the length up to its start. In units of speed().unit().
  struct Panel {
    std::size_t half;
    S begin, end;
    S length;
    working_t<S> before;
  };

  /// The panels in order; none where the speed is constant.
  const std::vector<Panel>& panels() const { return panels_; }
  const Speed<S>& speed() const { return speed_; }

 private:
  static constexpr std::size_t points = 16;
  static constexpr int most_halvings = 64;
  using W = working_t<S>;

  S rule_sum(std::size_t half, const S& begin, const S& end) const;
  S rough_length() const;
  void add_half(std::size_t half, const S& begin, const S& end);
  void add_panel(std::size_t half, const S& begin, const S& end, bool slow_begin, bool slow_end, int halvings);
  void accept(std::size_t half, const S& begin, const S& end, const S& length, const S& disagreement);

  Speed<S> speed_;
  std::vector<Panel> panels_;
  W sum_;
  S disagreement_{};  ///< of rules with their halves, over all panels
  S rough_{};         ///< the length to a digit
  S tolerance_{};     ///< for a single panel
  Length<S> total_;
};

/// The rule's error on this panel is known to be less than rounding.
///
/// With the panel mapped to [-1, 1] and the square of the speed q = sum q[k] z^k about its middle, q has no zero in
/// |z| <= R if the terms behind q[0] sum up to less than it there; then the speed is analytic in the ellipse with
/// foci -1, 1 and half axes' sum rho = R + sqrt(R^2 - 1), is at most sqrt(2 q[0]) in it, and the N-point rule errs by
/// at most 64/15 sqrt(2 q[0]) / (rho^2N - rho^(2N - 2)) times half the panel's width.
/// Source: L. N. Trefethen, "Is Gauss quadrature better than Clenshaw-Curtis?", doi:10.1137/060659831, theorem 4.5.
template <class S>
bool is_smooth(const Speed<S>& speed, std::size_t half, const S& begin, const S& end) {
  using std::abs;
  // For a double and 16 points R = 1.9 gives 2^-55 of the speed; for a scalar with more digits nothing is known.
  if (std::numeric_limits<S>::digits > 53) return false;
  const S radius(1.9);
  const auto q = speed.square_about(half, (begin + end) * S(0.5), (end - begin) * S(0.5));
  return radius * (abs(q[1]) + radius * (abs(q[2]) + radius * (abs(q[3]) + radius * abs(q[4])))) < q[0];
}

template <class S>
S ArcLength<S>::rule_sum(std::size_t half, const S& begin, const S& end) const {
  return gauss_sum<points>(speed_, half, begin, end);
}

/// The length to a digit or so, by Simpson's rule on either half.
template <class S>
S ArcLength<S>::rough_length() const {
  const std::array<S, 3> places{S(0), S(0.25), S(0.5)};
  S sum(0);
  for (const std::size_t half : {0U, 1U}) {
    const S shift = half == 0 ? S(0) : S(-0.5);
    const auto speeds = speed_(half, std::array<S, 3>{places[0] + shift, places[1] + shift, places[2] + shift});
    sum += (speeds[0] + S(4) * speeds[1] + speeds[2]) / S(12);
  }
  return sum;
}

template <class S>
void ArcLength<S>::accept(std::size_t half, const S& begin, const S& end, const S& length, const S& disagreement) {
  panels_.push_back({half, begin, end, length, sum_});
  sum_ = sum_ + W(length);
  disagreement_ += disagreement;
}

/// The panel as it is if its error is known to be small, or if it has the minimum of the speed at an end and the
/// rule agrees with itself on both halves; else cut in halves.
template <class S>
void ArcLength<S>::add_panel(std::size_t half, const S& begin, const S& end, bool slow_begin, bool slow_end,
                             int halvings) {
  using std::abs;
  if (is_smooth(speed_, half, begin, end)) {
    accept(half, begin, end, rule_sum(half, begin, end), S(0));
    return;
  }
  const S middle = begin + (end - begin) * S(0.5);
  const bool knows_smooth = std::numeric_limits<S>::digits <= 53;
  if (slow_begin || slow_end || halvings == 0 || !knows_smooth) {
    const S left = rule_sum(half, begin, middle);
    const S right = rule_sum(half, middle, end);
    const S disagreement = abs(left + right - rule_sum(half, begin, end));
    if (disagreement <= tolerance_ || halvings == 0) {
      accept(half, begin, middle, left, S(0));
      accept(half, middle, end, right, disagreement);
      return;
    }
  }
  add_panel(half, begin, middle, slow_begin, false, halvings - 1);
  add_panel(half, middle, end, false, slow_end, halvings - 1);
}

/// Half a segment: one panel if it is smooth, else cut at the minima of the speed. An end counts as one where the
/// speed is small.
template <class S>
void ArcLength<S>::add_half(std::size_t half, const S& begin, const S& end) {
  if (is_smooth(speed_, half, begin, end)) {
    accept(half, begin, end, rule_sum(half, begin, end), S(0));
    return;
  }
  const S small = rough_ * S(0x1p-6);
  S from = begin;
  bool slow = speed_(half, begin) < small;
  for (const S& place : slowest_places(speed_, half, begin, end)) {
    add_panel(half, from, place, slow, true, most_halvings);
    from = place;
    slow = true;
  }
  add_panel(half, from, end, slow, speed_(half, end) < small, most_halvings);
}

template <class S>
void ArcLength<S>::assign(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) {
  speed_.assign(segment, metric);
  panels_.clear();
  sum_ = W(0);
  disagreement_ = S(0);
  total_ = {};
  const S unit = speed_.unit();
  if (unit == S(0)) return;
  const S epsilon = std::numeric_limits<S>::epsilon();
  if (speed_.is_constant()) {
    const S speed = speed_(0, S(0));
    total_ = {speed * unit, speed * unit * epsilon};
    return;
  }
  const S half(0.5);
  rough_ = rough_length();
  tolerance_ = epsilon * S(0.25) * rough_;
  add_half(0, S(0), half);
  add_half(1, -half, S(0));
  const S value = narrow<S>(sum_);
  total_ = {value * unit, (disagreement_ + S(4) * epsilon * (value + S(1))) * unit};
}

template <class S>
Length<S> ArcLength<S>::to(const Local<S>& place) const {
  if (place.w == S(0)) return total_;
  if (speed_.unit() == S(0) || place.u == S(0)) return {};
  if (panels_.empty()) return {total_.value * place.u, total_.error};
  const std::size_t half = place.near_start() ? 0 : 1;
  const S v = half == 0 ? place.u : place.w;
  auto panel = panels_.begin();
  while (panel + 1 != panels_.end() && (panel->half < half || (panel->half == half && panel->end < v))) ++panel;
  const W sum = panel->before + W(v > panel->begin ? rule_sum(half, panel->begin, v) : S(0));
  return {narrow<S>(sum) * speed_.unit(), total_.error};
}

}  // namespace tcb::spline
