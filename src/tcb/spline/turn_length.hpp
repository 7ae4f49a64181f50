// Turn length: the angle in radians that rotations turn through on a segment, and its inverse.
//
// It is the integral of the angular speed by Gauss-Legendre rules on panels, which are halved until the rule on a panel
// agrees with the rule on its halves. The inverse is found by Newton's method between bounds.
#pragma once

#include <algorithm>
#include <array>
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
    breaks_.clear();
    for (const RotationSegment<S>& rotation : rotations) {
      for (const S& place : rotation.breaks()) breaks_.push_back(place);
    }
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
  static constexpr std::size_t most_panels = 1 << 11;  ///< more do not make a sum of more digits
  static S same_place() { return S(4096) * std::numeric_limits<S>::epsilon(); }

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

  using Speeds = std::array<S, most_points<S>>;

  /// At the nodes of the rule.
  Speeds speeds(const S& begin, const S& end) const {
    const S width = end - begin;
    Speeds speeds;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      speeds[i] = speed(begin + width * gauss_rule<S, most_points<S>>().node[i]);
    }
    return speeds;
  }
  static S integral(const Speeds& speeds, const S& begin, const S& end) {
    Speeds terms;
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = gauss_rule<S, most_points<S>>().weight[i] * speeds[i];
    return sum_in_pairs(terms) * (end - begin);
  }
  S integral(const S& begin, const S& end) const { return integral(speeds(begin, end), begin, end); }

  /// Accepts the halves of a part on which the rule agrees with the rule on its halves, and the speed at their ends
  /// with that at the nodes; else refines them. A part with a break is divided there.
  void refine(const Part& part, int halvings) {
    using std::abs, std::sqrt;
    const S end = part.begin + part.width;
    for (const S& place : breaks_) {
      if (!(place - part.begin > same_place() && end - place > same_place())) continue;
      refine({part.begin, place - part.begin, integral(part.begin, place), S(0)}, halvings);
      return refine({place, end - place, integral(place, end), S(0)}, halvings);
    }
    const S half = part.width / S(2), middle = part.begin + half;
    const Speeds before = speeds(part.begin, middle), after = speeds(middle, end);
    const Part left{part.begin, half, integral(before, part.begin, middle), S(0)};
    const Part right{middle, half, integral(after, middle, end), S(0)};
    const S disagreement = abs(left.length + right.length - part.length), noise = rounding_errors(part);
    const bool is_full = panels_.size() >= most_panels;
    const auto ends_agree = [&] {  // what the rule misses is about the square of this
      const S gap = std::max(gap_at_ends(before, part.begin, middle), gap_at_ends(after, middle, end));
      return gap * half <= tolerance_ / sqrt(std::numeric_limits<S>::epsilon());
    };
    if (halvings == 0 || is_full || (!(disagreement > tolerance_ + noise) && ends_agree())) {
      if (is_full || noise > S(0)) disagreements_ += disagreement;
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

  /// How far the speed at the ends of a part is from the polynomial through those at the nodes: between an end and the
  /// node next to it the rule sees neither a jump nor a rest. Breaks are ends at which the speed has no value.
  S gap_at_ends(const Speeds& speeds, const S& begin, const S& end) const {
    using std::abs;
    static const Speeds weights = [] {
      const auto& node = gauss_rule<S, most_points<S>>().node;
      Speeds result;
      for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = S(1);
        for (std::size_t k = 0; k < node.size(); ++k) {
          if (k != i) result[i] = result[i] * (node[k] / (node[k] - node[i]));
        }
      }
      return result;
    }();
    S at_begin(0), at_end(0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      at_begin += weights[i] * speeds[i];
      at_end += weights[i] * speeds[speeds.size() - 1 - i];
    }
    const auto gap = [&](const S& place, const S& expected) {
      const auto is_here = [&](const S& other) { return abs(other - place) <= same_place(); };
      return std::ranges::any_of(breaks_, is_here) ? S(0) : S(abs(speed(place) - expected));
    };
    return std::max(gap(begin, at_begin), gap(end, at_end));
  }

  /// Those of the integral over a panel: at a distance from a place where points of the curve are opposite, the speed
  /// has them divided by the square of the distance.
  S rounding_errors(const Part& part) const {
    S sum(0);
    for (const S& place : breaks_) {
      const S away = std::max(S(part.begin - place), S(place - (part.begin + part.width)));
      const S distance = std::max(away, S(0)) + part.width / S(16);  // of the nodes, too
      sum += S(4) * std::numeric_limits<S>::epsilon() * part.width / (distance * distance);
    }
    return sum;
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
  std::vector<S> breaks_;  ///< where the speed is not smooth
  std::vector<Part> panels_;
  S sum_{}, tolerance_{};
  S disagreements_{};  ///< of rules with their halves, where there are too many panels
  Length<S> total_;
};

}  // namespace tcb::spline
