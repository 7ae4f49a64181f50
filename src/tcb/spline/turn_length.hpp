// Turn length: the angle in radians that rotations turn through on a segment, and its inverse.
//
// It is the integral of the angular speed by Gauss-Legendre rules on panels, which are halved until the rule on a panel
// agrees with the rule on its halves. The inverse is found by Newton's method between bounds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/detail/panel.hpp"
#include "tcb/spline/detail/quadrature.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb::spline {

/// The angle on one segment; that of several rotations is the root of the sum of squares of their angular speeds,
/// integrated.
template <class S>
class TurnLength {
 public:
  using W = working_t<S>;

  void assign(std::span<const RotationSegment<S>> rotations) {
    rotations_.assign(rotations.begin(), rotations.end());
    panels_.clear();
    sum_ = disagreements_ = S(0);
    const S whole = integral(S(0), S(1));
    tolerance_ = S(8) * std::numeric_limits<S>::epsilon() * std::max(whole, S(1));
    refine({S(0), S(1), whole, S(0)}, most_halvings);
    total_ = {sum_, tolerance_ * S(panels_.size()) + disagreements_};
  }

  const Length<S>& total() const { return total_; }

  /// From the start to a place. Promises: within a few roundings of max(angle, 1).
  Length<S> to(const LocalParameter<S>& place) const {
    if (place.w == S(0)) return total_;
    auto panel = panels_.begin();
    while (panel + 1 != panels_.end() && (panel + 1)->begin <= place.u) ++panel;
    return {panel->before + integral(panel->begin, place.u), total_.error};
  }

  /// The places at which the curve has these lengths, where the whole curve has `start` at the start of the segment.
  void places(const W& start, std::span<const W> lengths, std::span<LocalParameter<S>> places) const {
    for (std::size_t i = 0; i < lengths.size(); ++i) places[i] = place(start, lengths[i]);
  }
  LocalParameter<S> place(const W& start, const W& length) const { return place_of(high_part<S>(W(length - start))); }

 private:
  static constexpr int most_halvings = std::max(24, std::numeric_limits<S>::digits / 2);
  static constexpr std::size_t most_panels = 1 << 14;  ///< more do not make a sum of more digits

  struct Part {
    S begin, width, length;
    S before;  ///< the angle up to its start
  };

  S speed(const S& u) const {
    using std::sqrt;
    S square(0);
    for (const RotationSegment<S>& rotation : rotations_) {
      const auto [x, y, z] = rotation.rate({u, u - S(1)});
      square = square + (x * x + (y * y + z * z));
    }
    return sqrt(square);
  }

  S integral(const S& begin, const S& end) const {
    const auto& rule = gauss_rule<S, most_points<S>>();
    const S width = end - begin;
    std::array<S, most_points<S>> terms;
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = rule.weight[i] * speed(begin + width * rule.node[i]);
    return sum_in_pairs(terms) * width;
  }

  void refine(const Part& part, int halvings) {
    using std::abs;
    const S half = part.width / S(2), middle = part.begin + half;
    const Part left{part.begin, half, integral(part.begin, middle), S(0)};
    const Part right{middle, half, integral(middle, part.begin + part.width), S(0)};
    const S disagreement = abs(left.length + right.length - part.length);
    const bool is_full = panels_.size() >= most_panels;
    if (halvings == 0 || is_full || !(disagreement > tolerance_)) {
      if (is_full) disagreements_ += disagreement;
      for (Part accepted : {left, right}) {
        accepted.before = sum_;
        sum_ = sum_ + accepted.length;
        panels_.push_back(accepted);
      }
      return;
    }
    refine(left, halvings - 1);
    refine(right, halvings - 1);
  }

  LocalParameter<S> place_of(const S& length) const {
    using std::abs;
    if (length <= S(0)) return {S(0), S(-1)};
    if (length >= total_.value) return {S(1), S(0)};
    auto panel = panels_.begin();
    while (panel + 1 != panels_.end() && (panel + 1)->before < length) ++panel;
    const S into = length - panel->before, epsilon = std::numeric_limits<S>::epsilon();
    S low = panel->begin, high = panel->begin + panel->width;
    S u = panel->length > S(0) ? S(low + panel->width * std::min(S(into / panel->length), S(1))) : low;
    for (int step = 0; step < std::numeric_limits<S>::digits; ++step) {
      const S excess = integral(panel->begin, u) - into, slope = speed(u);
      (excess > S(0) ? high : low) = u;
      S next = slope > S(0) ? S(u - excess / slope) : low;
      if (!(next > low && next < high)) next = (low + high) / S(2);
      const bool is_settled = abs(next - u) <= S(2) * epsilon * u;
      u = next;
      if (is_settled) break;
    }
    return {u, u - S(1)};
  }

  std::vector<RotationSegment<S>> rotations_;
  std::vector<Part> panels_;
  S sum_{}, tolerance_{};
  S disagreements_{};  ///< of rules with their halves, where there are too many panels
  Length<S> total_;
};

}  // namespace tcb::spline
