// The inverse of arc length: where on a segment a given length is reached.
//
// The derivative of the length being the speed itself, a step of third order (Halley's) needs no more than the
// length at a guess. For a few samples the guess is improved step by step. For many on one panel, lengths are
// worked out once at its nodes; from the nearest node a cubic gives a guess good to some six
// digits, a rule of few points its length, and one step the place.
// Source: J. F. Traub, "Iterative methods for the solution of equations", 1964, section 5.2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "spline/arc_length.hpp"

namespace tcb::spline {

template <class S>
class ArcInverse {
 public:
  using W = working_t<S>;

  /// `step` is about how far apart the lengths are that will be asked for; 0: it will be one or two in all.
  /// Requires: `arc` outlives it.
  ArcInverse(const ArcLength<S>& arc, const S& step) : arc_(arc) {
    const S worth_a_table = step / arc.speed().unit() * S(4);
    tables_.resize(arc.panels().size());
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      const Panel& panel = arc.panels()[i];
      if (step > S(0) && panel.length > worth_a_table) tables_[i] = table(panel);
    }
  }

  /// The first place at which a length is reached. `s` is that from the start, `rest` the length from there
  /// to the end. Requires: 0 <= s <= total. Promises: right to some units in the last place of the total.
  Local<S> at(const W& s, const W& rest) const {
    const S& unit = arc_.speed().unit();
    if (s <= W(0) || unit == S(0)) return {S(0), S(-1)};
    if (rest <= W(0)) return {S(1), S(0)};
    const auto& panels = arc_.panels();
    if (panels.empty()) return {narrow<S>(s / (s + rest)), narrow<S>(-(rest / (s + rest)))};
    const W wanted = s * W(S(1) / unit);
    const auto after = std::upper_bound(panels.begin() + 1, panels.end(), wanted,
                                        [](const W& length, const Panel& panel) { return length <= panel.before; });
    const auto i = static_cast<std::size_t>(after - panels.begin() - 1);
    const Panel& panel = panels[i];
    const S into = std::min(narrow<S>(wanted - panel.before), panel.length);
    const S v = tables_[i].is_made ? look_up(panel, tables_[i], into) : search(panel, into);
    return panel.half == 0 ? Local<S>{v, v - S(1)} : Local<S>{S(1) + v, v};
  }

 private:
  using Panel = typename ArcLength<S>::Panel;
  static constexpr std::size_t points = 16;

  /// The ends and the nodes of a panel: places, lengths up to them, and 1 / speed.
  struct Table {
    std::array<S, points + 2> v, length, pace;
    bool is_made = false;
  };

  Table table(const Panel& panel) const {
    const auto& rule = gauss_rule<S, points>();
    const auto& cumulative = cumulative_rule<S, points>();
    const S width = panel.end - panel.begin;
    Table result;
    std::array<S, points> nodes;
    for (std::size_t i = 0; i < points; ++i) nodes[i] = panel.begin + width * rule.node[i];
    const auto speeds = arc_.speed()(panel.half, nodes);
    result.v.front() = panel.begin;
    result.length.front() = S(0);
    result.pace.front() = S(1) / arc_.speed()(panel.half, panel.begin);
    std::array<S, points> lengths{};
    for (std::size_t j = 0; j < points; ++j) {
      for (std::size_t i = 0; i < points; ++i) lengths[i] += cumulative[j][i] * speeds[j];
    }
    for (std::size_t i = 0; i < points; ++i) {
      result.v[i + 1] = nodes[i];
      result.length[i + 1] = lengths[i] * width;
      result.pace[i + 1] = S(1) / speeds[i];
    }
    result.v.back() = panel.end;
    result.length.back() = panel.length;
    result.pace.back() = S(1) / arc_.speed()(panel.half, panel.end);
    result.is_made = true;
    return result;
  }

  /// A step from v, where the length is short of the wanted one by `missing`, and how far it goes at first order.
  struct Step {
    S v, first_order, bend;
  };
  Step step(const Panel& panel, const S& v, const S& missing) const {
    const S speed = arc_.speed()(panel.half, v);
    const S newton = missing / speed;
    const S bend = newton * arc_.speed().growth(panel.half, v) / (speed * speed);
    return {v + (newton - newton * bend * S(0.5)), newton, bend};
  }

  /// After a step this small, what is left is its third power: less than rounding.
  static bool is_last(const Step& step, const S& width) {
    using std::abs;
    return abs(step.first_order) <= width * S(0x1p-18) && abs(step.bend) <= S(0x1p-18);
  }

  S look_up(const Panel& panel, const Table& table, const S& into) const {
    std::size_t i = 1;  // counted, not searched: no branch to guess
    for (std::size_t k = 1; k <= points; ++k) i += table.length[k] <= into ? 1 : 0;
    const S l = table.length[i] - table.length[i - 1];
    const S t = (into - table.length[i - 1]) / l;
    const S chord = table.v[i] - table.v[i - 1];
    const S out = table.pace[i - 1] * l - chord;
    const S in = table.pace[i] * l - chord;
    const S guess = table.v[i - 1] + t * (chord + (S(1) - t) * ((S(1) - t) * out - t * in));
    if (!(guess >= table.v[i - 1] && guess <= table.v[i])) return search(panel, into);
    const S missing = into - table.length[i - 1] - gauss_sum<8>(arc_.speed(), panel.half, table.v[i - 1], guess);
    const Step last = step(panel, guess, missing);
    return is_last(last, panel.end - panel.begin) ? std::clamp(last.v, panel.begin, panel.end) : search(panel, into);
  }

  /// Steps that stay between bounds, each from the place before.
  S search(const Panel& panel, const S& into) const {
    const S width = panel.end - panel.begin;
    S low = panel.begin, high = panel.end;
    S v = low + width * (into / panel.length);
    S from = low, reached(0);
    for (int i = 0; i < 2 * std::numeric_limits<S>::digits; ++i) {
      reached += v >= from ? gauss_sum<points>(arc_.speed(), panel.half, from, v)
                           : -gauss_sum<points>(arc_.speed(), panel.half, v, from);
      from = v;
      const S missing = into - reached;
      (missing > S(0) ? low : high) = v;
      const Step next = step(panel, v, missing);
      if (is_last(next, width)) return std::clamp(next.v, panel.begin, panel.end);
      v = low < next.v && next.v < high ? next.v : low + (high - low) * S(0.5);
      if (v <= low || v >= high) break;
    }
    return v;
  }

  const ArcLength<S>& arc_;
  std::vector<Table> tables_;
};

}  // namespace tcb::spline
