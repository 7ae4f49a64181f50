// Arc length: the length of a segment, accurate to its last digits, with a bound on the error.
//
// The speed is the square root of a quartic. It is smooth except near the minima of the speed, where it may be zero (a
// cusp, or a reversal) or nearly zero. Each half of a segment is halved until its panels are smooth. A panel that is
// not smooth after a few halvings is cut at the minima of the speed, and then halved until the rule on the panel and
// the rule on its halves agree so closely that further halvings have no effect. A minimum of zero at the end of a panel
// does not reduce the accuracy; near a minimum close to zero, panels are halved until their lengths have no effect.
// Source: P. J. Davis, P. Rabinowitz, "Methods of Numerical Integration", 2.7 and 6.2. No epsilon is absolute: scaling
// by a power of two changes no digit.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tcb/spline/detail/panel.hpp"
#include "tcb/spline/detail/speed.hpp"

namespace tcb::spline {

/// The lengths of one segment. It can be assigned one segment after another, which reuses its memory.
template <class S>
class ArcLength {
 public:
  ArcLength() = default;
  ArcLength(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) { assign(segment, metric); }

  void assign(std::span<const Cubic<S>> segment, std::span<const std::size_t> metric) {
    speed_.assign(segment, metric);
    panels_.clear();
    sum_ = W(0);
    disagreement_ = rough_ = S(0);
    total_ = {};
    const S unit = speed_.unit();
    if (!speed_.is_finite()) total_ = {std::numeric_limits<S>::infinity(), std::numeric_limits<S>::infinity()};
    if (unit == S(0)) return;
    const S epsilon = std::numeric_limits<S>::epsilon();
    if (speed_.is_constant()) {
      const S speed = speed_(0, S(0));
      total_ = {speed * unit, speed * unit * epsilon};
      return;
    }
    for (const Panel<S>& half : make_panels<S>(speed_, {0, S(0), S(0.5)}, {1, S(-0.5), S(0)}))
      add(half, first_halvings);
    const S value = high_part<S>(sum_);
    total_ = {value * unit, (disagreement_ + S(8) * epsilon * (value + S(1))) * unit};
  }

  /// The length of the segment. Promises: accurate to a few units in the last place, and in any case to within `error`;
  /// infinite if a number of the segment is infinite.
  const Length<S>& total() const { return total_; }

  /// From the start to a place. Promises: as total().
  Length<S> to(const LocalParameter<S>& place) const {
    if (place.w == S(0)) return total_;
    if (place.u == S(0)) return {};
    if (speed_.unit() == S(0)) return speed_.is_finite() ? Length<S>{} : total_;
    if (panels_.empty()) return {total_.value * place.u, total_.error};
    const std::size_t half = place.near_start() ? 0 : 1;
    const S v = half == 0 ? place.u : place.w;
    auto panel = panels_.begin();
    while (panel + 1 != panels_.end() && (panel->half < half || panel->middle + panel->width < v)) ++panel;
    const S z = std::clamp((v - panel->middle) / panel->width, S(-1), S(1));
    const W sum = panel->before + panel_sum(*panel, speed_, S(-1), z);
    return {high_part<S>(sum) * speed_.unit(), total_.error};
  }

  /// The panels in order; none if the speed is constant.
  const std::vector<Panel<S>>& panels() const { return panels_; }
  const Speed<S>& speed() const { return speed_; }

 private:
  static constexpr int first_halvings = 3;
  static constexpr int most_halvings = std::max(64, std::numeric_limits<S>::digits);
  using W = working_t<S>;

  /// The length to about one digit, by Simpson's rule on each half.
  S rough_length() const {
    S sum(0);
    for (const std::size_t half : {0U, 1U}) {
      const S shift = half == 0 ? S(0) : S(-0.5);
      const auto speeds = speed_(half, std::array<S, 3>{shift, S(0.25) + shift, S(0.5) + shift});
      sum += (speeds[0] + S(4) * speeds[1] + speeds[2]) / S(12);
    }
    return sum;
  }

  /// Accepts a smooth panel, else adds its halves; after a few halvings it is cut.
  void add(const Panel<S>& panel, int halvings) {
    if (panel.is_smooth()) return accept(panel);
    if (halvings == 0) return cut(panel);
    for (const Panel<S>& half : halves(panel)) add(half, halvings - 1);
  }
  /// Cuts a panel at the minima of the speed, if there are any. An end counts as a minimum where the speed is small.
  void cut(const Panel<S>& panel) {
    if (rough_ == S(0)) rough_ = rough_length();
    const S small = rough_ * S(0x1p-6);
    S from = panel.middle - panel.width;
    const S end = panel.middle + panel.width;
    bool slow = speed_(panel.half, from) < small;
    for (const S& place : slowest_places(speed_, panel.half, from, end)) {
      refine(make_panel<S>(speed_, {panel.half, from, place}), slow, true, most_halvings);
      from = place;
      slow = true;
    }
    refine(make_panel<S>(speed_, {panel.half, from, end}), slow, speed_(panel.half, end) < small, most_halvings);
  }

  /// Accepts a panel that is smooth, or that has a minimum of the speed at an end and on which the rule agrees with the
  /// sum of its halves; else refines its halves.
  void refine(const Panel<S>& panel, bool slow_begin, bool slow_end, int halvings) {
    using std::abs;
    if (panel.is_smooth()) return accept(panel);
    const auto [left, right] = halves(panel);
    if (slow_begin || slow_end || halvings == 0) {
      // Where the speed is almost zero, each further halving may change the sum by as much.
      const S disagreement = abs(rule_sum(left) + rule_sum(right) - rule_sum(panel)) * S(halvings + 1);
      if (disagreement <= std::numeric_limits<S>::epsilon() * S(0.25) * rough_ || halvings == 0) {
        accept(left);
        return accept(right, disagreement);
      }
    }
    refine(left, slow_begin, false, halvings - 1);
    refine(right, false, slow_end, halvings - 1);
  }

  void accept(const Panel<S>& panel, const S& disagreement = S(0)) {
    panels_.push_back(panel);
    panels_.back().length = rule_sum(panel);
    panels_.back().before = sum_;
    sum_ = sum_ + panels_.back().length;
    disagreement_ += disagreement;
  }

  std::array<Panel<S>, 2> halves(const Panel<S>& panel) const {
    return make_panels<S>(speed_, {panel.half, panel.middle - panel.width, panel.middle},
                          {panel.half, panel.middle, panel.middle + panel.width});
  }
  S rule_sum(const Panel<S>& panel) const { return panel_sum(panel, speed_, S(-1), S(1)); }

  Speed<S> speed_;
  std::vector<Panel<S>> panels_;
  W sum_;
  S disagreement_{};  ///< of rules with their halves, times the halvings left, over all panels
  S rough_{};         ///< the length to one digit; 0 until it is needed
  Length<S> total_;
};

}  // namespace tcb::spline
