// Tangents at keys: by the rules, from the chords between the keys.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/curve_rules.hpp"
#include "tcb/spline/rules.hpp"
#include "tcb/spline/scalar.hpp"
#include "tcb/spline/window.hpp"

namespace tcb::spline {

/// The factor by which a key's two tangents in a channel are scaled so that the cubics beside it stay between their
/// keys: 1 where each tangent lies between 0 and three times the chord on its side. Otherwise the largest factor that
/// brings both there: a key with one direction keeps it. At doubles it is less by a part of 2^-50, so that no rounding
/// leads beyond. A side without a segment has two zeros.
/// Source: F. N. Fritsch, R. E. Carlson, "Monotone piecewise cubic interpolation", doi:10.1137/0717021, section 3.
template <class S>
working_t<S> overshoot_factor(const working_t<S>& in, const working_t<S>& chord_before, const working_t<S>& out,
                              const working_t<S>& chord_after) {
  using W = working_t<S>;
  const auto size = [](const W& value) { return value < W(0) ? -value : value; };
  W margin(0), room(1);
  if constexpr (std::is_same_v<S, double>) {
    margin = W(0x1p-90) * (size(chord_before) + size(chord_after));  // rounding errors of double-doubles, which are 0
    room = W(1) - W(0x1p-50);
  }
  W factor(1);
  const auto limit = [&](const W& tangent, const W& chord) {
    if (size(tangent) <= margin) return;
    const W most = W(3) * chord;
    if (tangent < W(0) ? !(chord < W(0)) : !(chord > W(0))) {
      factor = W(0);
    } else if (size(tangent) > size(most) + margin) {
      const W needed = most / tangent * room;
      if (needed < factor) factor = needed;
    }
  };
  limit(in, chord_before);
  limit(out, chord_after);
  return factor;
}

/// The differences between the positions of each key and the next one, `channels` numbers per key but the last; those
/// of angles are less than half a turn.
template <class S>
std::vector<working_t<S>> chords_of(const Keys<S>& keys, const std::vector<AngleChannel>& angles) {
  std::vector<working_t<S>> chords;
  chords.reserve(keys.positions.size());
  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    const auto from = keys.position(key), to = keys.position(key + 1);
    for (std::size_t i = 0; i < keys.channels; ++i) chords.push_back(exact_difference(to[i], from[i]));
    for (const AngleChannel& angle : angles) {
      auto& chord = chords[key * keys.channels + angle.channel];
      chord = chord - nearest_turns<S>(chord, angle.degrees);
    }
  }
  return chords;
}

/// The tangents at the keys of a window, `channels` numbers per key, in local units, from the chords between the keys.
template <class S>
class Tangents {
 public:
  using W = working_t<S>;

  /// Requires: at least two keys. Context keys are left at zero.
  Tangents(const Window<S>& window, const CurveRules<S>& rules)
      : Tangents(window, rules, chords_of(window.keys, rules.angles)) {}
  /// With other chords than those of the positions, `channels` numbers per key but the last.
  Tangents(const Window<S>& window, const CurveRules<S>& rules, std::vector<W> chords)
      : keys_(window.keys), rules_(rules), chords_(std::move(chords)), metric_(speed_metric()) {
    incoming_.assign(keys_.size() * keys_.channels, W(0));
    outgoing_ = incoming_;
    const auto common = factors(keys_.common_tcb);
    const bool is_linear = rules.tangents == TangentRule::linear;  // which has neither ends nor speeds of its own
    const EndChoice<S> chord_end{EndRule::chord, {}};
    const bool differ = keys_.has_channel_tcbs();
    const std::size_t alike = differ ? 1 : keys_.channels;  // channels with the same tension, continuity and bias
    for (std::size_t key = 1; key + 1 < keys_.size(); ++key) {
      for (std::size_t i = 0; i < keys_.channels; i += alike) {
        const Tcb<S>& tcb = keys_.tcbs.empty() ? keys_.common_tcb : keys_.tcbs[differ ? key * keys_.channels + i : key];
        set_interior(key, i, i + alike, keys_.tcbs.empty() ? common : factors(tcb), tcb);
      }
      if constexpr (has_roots<S>) {
        if (rules.equal_speed && !is_linear) equalize(key);
      }
    }
    if (window.starts) set_end(0, 1, is_linear ? chord_end : rules.start);
    if (window.ends) set_end(keys_.size() - 1, keys_.size() - 2, is_linear ? chord_end : rules.end);
    if (!keys_.velocities.empty()) set_given();
    if (rules.no_overshoot) limit(window);
  }

  /// The chord from a key to the next one.
  std::span<const W> chord(std::size_t key) const {
    return std::span(chords_).subspan(key * keys_.channels, keys_.channels);
  }
  std::span<const W> incoming(std::size_t key) const {
    return std::span(incoming_).subspan(key * keys_.channels, keys_.channels);
  }
  std::span<const W> outgoing(std::size_t key) const {
    return std::span(outgoing_).subspan(key * keys_.channels, keys_.channels);
  }

  /// How many tangents of the segment after a key were scaled so that it does not overshoot.
  std::size_t limited(std::size_t key) const {
    if (limited_.empty()) return 0;
    const auto first = limited_.begin() + static_cast<std::ptrdiff_t>(key * keys_.channels);
    return static_cast<std::size_t>(std::count(first, first + static_cast<std::ptrdiff_t>(2 * keys_.channels), true));
  }

 private:
  /// The tangents of a key in the channels [first, last), which have the same tension, continuity and bias.
  void set_interior(std::size_t key, std::size_t first, std::size_t last, const Factors<W>& f, const Tcb<S>& tcb) {
    const W h0 = keys_.times[key] - keys_.times[key - 1];
    const W h1 = keys_.times[key + 1] - keys_.times[key];
    const auto weights = row_of<S>(rules_.tangents).weights({f, W(tcb.continuity), h0, h1});
    for (std::size_t i = first; i < last; ++i) {
      const W d0 = chord(key - 1)[i];
      const W d1 = chord(key)[i];
      incoming_[key * keys_.channels + i] = weights.in0 * d0 + weights.in1 * d1;
      outgoing_[key * keys_.channels + i] = weights.out0 * d0 + weights.out1 * d1;
    }
  }

  /// The outer tangent of the end segment, at `key`, whose only neighbour is `inner`.
  void set_end(std::size_t key, std::size_t inner, const EndChoice<S>& choice) {
    const bool at_start = key < inner;
    const std::size_t first = std::min(key, inner);
    const auto weights_of = [&](const Tcb<S>& tcb) {
      const auto f = factors(tcb);
      return row_of<S>(choice.rule)
          .weights({at_start ? f.b : f.c, at_start ? f.a : f.d, W(tcb.tension),
                    keys_.times[first + 1] - keys_.times[first], keys_.size() == 2});
    };
    const bool differ = keys_.has_channel_tcbs();
    auto weights = weights_of(keys_.tcb(key));
    auto& tangents = at_start ? outgoing_ : incoming_;
    const auto& others = at_start ? incoming_ : outgoing_;
    for (std::size_t i = 0; i < keys_.channels; ++i) {
      if (differ) weights = weights_of(keys_.tcb(key, i));
      W tangent = weights.chord * chord(first)[i] + weights.other * others[inner * keys_.channels + i];
      if (!choice.velocity.empty()) tangent = tangent + weights.given * W(choice.velocity[i]);
      tangents[key * keys_.channels + i] = tangent;
    }
  }

  /// Scales the tangents by which a channel would leave the range of two neighbouring keys.
  void limit(const Window<S>& window) {
    limited_.assign(outgoing_.size(), false);
    for (std::size_t key = window.first_key(); key <= window.last_key(); ++key) {
      const bool has_before = key > 0, has_after = key + 1 < keys_.size();
      for (std::size_t i = 0; i < keys_.channels; ++i) {
        W &in = incoming_[key * keys_.channels + i], &out = outgoing_[key * keys_.channels + i];
        const W factor = overshoot_factor<S>(has_before ? in : W(0), has_before ? chord(key - 1)[i] : W(0),
                                             has_after ? out : W(0), has_after ? chord(key)[i] : W(0));
        if (factor == W(1)) continue;
        limited_[key * keys_.channels + i] = true;
        in = in * factor;
        out = out * factor;
      }
    }
  }

  /// The tangents of channels with given velocities: the velocity times the duration of the segment.
  void set_given() {
    for (std::size_t i = 0; i < keys_.velocities.size(); ++i) {
      const std::size_t key = i / keys_.channels;
      if (!keys_.given[i % keys_.channels]) continue;
      const auto duration = [&](std::size_t from) { return W(keys_.times[from + 1] - keys_.times[from]); };
      if (key > 0) incoming_[i] = duration(key - 1) * W(keys_.velocities[i].in);
      if (key + 1 < keys_.size()) outgoing_[i] = duration(key) * W(keys_.velocities[i].out);
    }
  }

  /// Gives both tangents of a key the harmonic mean of their speeds, per unit of time.
  /// Source: D. Eberly, "Kochanek-Bartels Cubic Splines (TCB Splines)", equations 12 and 13.
  void equalize(std::size_t key) {
    const std::span in = std::span(incoming_).subspan(key * keys_.channels, keys_.channels);
    const std::span out = std::span(outgoing_).subspan(key * keys_.channels, keys_.channels);
    const S unit_in = power_of_two_above(in), unit_out = power_of_two_above(out), unit = std::max(unit_in, unit_out);
    if (unit == S(0)) return;
    const W speed_in = size(in, unit_in) / (keys_.times[key] - keys_.times[key - 1]) * W(unit_in / unit);
    const W speed_out = size(out, unit_out) / (keys_.times[key + 1] - keys_.times[key]) * W(unit_out / unit);
    const W sum = speed_in + speed_out;
    if (sum == W(0)) return;
    for (W& value : in) value = value * (speed_out + speed_out) / sum;
    for (W& value : out) value = value * (speed_in + speed_in) / sum;
  }

  /// The channels of equal speed. Empty: all.
  std::vector<std::size_t> speed_metric() const {
    return rules_.equal_speed ? metric_of(rules_, keys_.channels) : std::vector<std::size_t>{};
  }
  std::size_t metric_size() const { return metric_.empty() ? keys_.channels : metric_.size(); }
  std::size_t metric(std::size_t i) const { return metric_.empty() ? i : metric_[i]; }

  /// A power of two no smaller than any metric component, so that squares neither overflow nor vanish.
  S power_of_two_above(std::span<const W> tangent) const {
    using std::abs, std::frexp, std::ldexp;
    S largest(0);
    for (std::size_t i = 0; i < metric_size(); ++i) {
      largest = std::max(largest, S(abs(high_part<S>(tangent[metric(i)]))));
    }
    int exponent = 0;
    (void)frexp(largest, &exponent);
    return largest == S(0) ? S(0) : ldexp(S(1), exponent);
  }

  /// The length of a tangent over the metric channels, in the given unit, which is 0 for a length of 0.
  W size(std::span<const W> tangent, const S& unit) const {
    if (unit == S(0)) return W(0);
    W sum(0);
    for (std::size_t i = 0; i < metric_size(); ++i) {
      const W component = tangent[metric(i)] / W(unit);
      sum = sum + component * component;
    }
    return square_root(sum);
  }

  const Keys<S>& keys_;
  const CurveRules<S>& rules_;
  std::vector<W> chords_;
  std::vector<std::size_t> metric_;  ///< of equal speed; empty: all channels
  std::vector<W> incoming_, outgoing_;
  std::vector<bool> limited_ = {};  ///< of each key and channel; empty: none are
};

}  // namespace tcb::spline
