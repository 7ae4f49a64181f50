// Tangents: those of the keys of a window by the rules, and the segments that they make.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/window.hpp"

namespace tcb::spline {

/// The tangents at the keys of a window, `channels` numbers per key, in local units, from the chords between the keys.
template <class S, class Chord = PositionChord<S>>
class Tangents {
 public:
  using W = working_t<S>;

  /// Requires: at least two keys. Context keys are left at zero.
  Tangents(const Window<S>& window, const CurveRules<S>& rules)
      : Tangents(window, rules, {window.keys, rules.angles}) {}
  Tangents(const Window<S>& window, const CurveRules<S>& rules, Chord chord)
      : keys_(window.keys), rules_(rules), chord_(std::move(chord)) {
    incoming_.assign(keys_.size() * keys_.channels, W(0));
    outgoing_ = incoming_;
    const auto common = factors(keys_.common_tcb);
    const bool differ = keys_.has_channel_tcbs();
    const std::size_t alike = differ ? 1 : keys_.channels;  // channels with the same tension, continuity and bias
    for (std::size_t key = 1; key + 1 < keys_.size(); ++key) {
      for (std::size_t i = 0; i < keys_.channels; i += alike) {
        const Tcb<S>& tcb = keys_.tcbs.empty() ? keys_.common_tcb : keys_.tcbs[differ ? key * keys_.channels + i : key];
        set_interior(key, i, i + alike, keys_.tcbs.empty() ? common : factors(tcb), tcb);
      }
      if constexpr (has_roots<S>) {
        if (rules.equal_speed) equalize(key);
      }
    }
    if (window.starts) set_end(0, 1, rules.start);
    if (window.ends) set_end(keys_.size() - 1, keys_.size() - 2, rules.end);
    if (!keys_.velocities.empty()) set_given();
  }

  std::span<const W> incoming(std::size_t key) const {
    return std::span(incoming_).subspan(key * keys_.channels, keys_.channels);
  }
  std::span<const W> outgoing(std::size_t key) const {
    return std::span(outgoing_).subspan(key * keys_.channels, keys_.channels);
  }

 private:
  /// The tangents of a key in the channels [first, last), which have the same tension, continuity and bias.
  void set_interior(std::size_t key, std::size_t first, std::size_t last, const Factors<W>& f, const Tcb<S>& tcb) {
    const W h0 = keys_.times[key] - keys_.times[key - 1];
    const W h1 = keys_.times[key + 1] - keys_.times[key];
    const auto weights = row_of<S>(rules_.tangents).weights({f, W(tcb.continuity), h0, h1});
    for (std::size_t i = first; i < last; ++i) {
      const W d0 = chord_(key - 1, i);
      const W d1 = chord_(key, i);
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
      W tangent = weights.chord * chord_(first, i) + weights.other * others[inner * keys_.channels + i];
      if (!choice.velocity.empty()) tangent = tangent + weights.given * W(choice.velocity[i]);
      tangents[key * keys_.channels + i] = tangent;
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
    const S unit = power_of_two_above(in, out);
    if (unit == S(0)) return;
    const W speed_in = size(in, unit) / (keys_.times[key] - keys_.times[key - 1]);
    const W speed_out = size(out, unit) / (keys_.times[key + 1] - keys_.times[key]);
    const W sum = speed_in + speed_out;
    if (sum == W(0)) return;
    for (W& value : in) value = value * (speed_out + speed_out) / sum;
    for (W& value : out) value = value * (speed_in + speed_in) / sum;
  }

  std::size_t metric_size() const { return rules_.metric.empty() ? keys_.channels : rules_.metric.size(); }
  std::size_t metric(std::size_t i) const { return rules_.metric.empty() ? i : rules_.metric[i]; }

  /// A power of two no smaller than any metric component, so that squares neither overflow nor vanish.
  S power_of_two_above(std::span<const W> in, std::span<const W> out) const {
    using std::abs, std::frexp, std::ldexp;
    S largest(0);
    for (std::size_t i = 0; i < metric_size(); ++i) {
      largest = std::max({largest, S(abs(high_part<S>(in[metric(i)]))), S(abs(high_part<S>(out[metric(i)])))});
    }
    int exponent = 0;
    (void)frexp(largest, &exponent);
    return largest == S(0) ? S(0) : ldexp(S(1), exponent);
  }

  /// The length of a tangent over the metric channels, in the given unit.
  W size(std::span<const W> tangent, const S& unit) const {
    using std::sqrt;
    W sum(0);
    for (std::size_t i = 0; i < metric_size(); ++i) {
      const W component = tangent[metric(i)] / W(unit);
      sum = sum + component * component;
    }
    return sqrt(sum);
  }

  const Keys<S>& keys_;
  const CurveRules<S>& rules_;
  Chord chord_;
  std::vector<W> incoming_, outgoing_;
};

/// The curve of one rotation through the keys of a window.
template <class S>
class RotationOfWindow {
 public:
  using W = working_t<S>;

  /// Requires: at least two keys.
  RotationOfWindow(const Window<S>& window, const CurveRules<S>& rules, const RotationColumns& rotation)
      : window_(window),
        rules_(rules),
        rotation_(rotation),
        is_linear_(rules.rotation_curve == RotationCurve::components) {
    const Keys<S>& keys = window.keys;
    for (std::size_t key = 0; key < keys.size(); ++key) {
      keys_.push_back(rotation_of<S>(keys.position(key), rotation.channels));
    }
    const auto align = [&](std::size_t key, const Quaternion<S>& with) {
      if (dot(keys_[key], with) < S(0)) keys_[key] = -keys_[key];
    };
    if (window.first_key() > 0) align(0, keys_[1] * exponential(turn(0, S(-1))));  // the first key keeps its sign
    for (std::size_t key = window.first_key() + 1; key < keys_.size(); ++key) {
      align(key, keys_[key - 1] * exponential(turn(key - 1)));
    }
    for (std::size_t key = 1; key < keys_.size(); ++key) chords_.push_back(chord(key - 1));
  }

  /// The curves between the keys, segment after segment.
  std::vector<RotationSegment<S>> segments() const {
    Window<S> turns = window_;  // of as many channels as a chord has numbers
    turns.keys.channels = is_linear_ ? 4 : 3;
    turns.keys.positions.assign(keys_.size() * turns.keys.channels, S(0));
    turns.keys.velocities.clear();
    if (window_.keys.has_channel_tcbs()) {
      turns.keys.tcbs.clear();
      for (std::size_t key = 0; key < keys_.size(); ++key)
        turns.keys.tcbs.push_back(window_.keys.tcb(key, rotation_.channels[0]));
    }
    CurveRules<S> rules = rules_;
    rules.metric.clear();
    const Tangents tangents(turns, rules, [&](std::size_t key, std::size_t i) { return W(chords_[key][i]); });
    std::vector<RotationSegment<S>> result;
    for (std::size_t key = window_.first_key(); key < window_.last_key(); ++key) {
      result.push_back(segment(key, rounded(tangents.outgoing(key)), rounded(tangents.incoming(key + 1))));
    }
    return result;
  }

 private:
  using Chord = std::array<S, 4>;  ///< a logarithm and 0, or the differences of the four numbers

  Chord chord(std::size_t key) const {
    const Quaternion<S>&from = keys_[key], &to = keys_[key + 1];
    if (is_linear_) return {to.x - from.x, to.y - from.y, to.z - from.z, to.w - from.w};
    Vector3<S> log = turn(key);
    if (const S half_turns = half_turns_of(log); half_turns > S(1.5)) {
      for (S& number : log) number = number / half_turns;  // up to the first half turn
    } else if (half_turns == S(0)) {
      log = logarithm(conjugate(from) * to);
    }
    return {log[0], log[1], log[2], S(0)};
  }
  /// The given turn from a key to the next one, times a factor; zeros: there is none.
  Vector3<S> turn(std::size_t key, const S& factor = S(1)) const {
    const Keys<S>& keys = window_.keys;
    if (!rotation_.turn || keys.turns.empty()) return {S(0), S(0), S(0)};
    const auto& [x, y, z] = keys.turns[(key + 1) * keys.turns_per_key() + *rotation_.turn];
    return {x * factor, y * factor, z * factor};
  }
  static Chord rounded(std::span<const W> tangent) {
    Chord result{};
    for (std::size_t i = 0; i < tangent.size(); ++i) result[i] = high_part<S>(tangent[i]);
    return result;
  }

  /// a times a chord or tangent plus b times another one, as a turn or a step from a key.
  Quaternion<S> moved(const Quaternion<S>& key, const S& a, const Chord& x, const S& b, const Chord& y) const {
    Chord sum;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a * x[i] + b * y[i];
    if (is_linear_) return key + Quaternion<S>{sum[0], sum[1], sum[2], sum[3]};
    return key * exponential<S>({sum[0], sum[1], sum[2]});
  }

  RotationSegment<S> segment(std::size_t key, const Chord& out, const Chord& in) const {
    const Quaternion<S>&from = keys_[key], &to = keys_[key + 1];
    const S half(0.5), third = S(1) / S(3);
    const Vector3<S> whole_turns = turn(key);
    if (rules_.rotation_curve == RotationCurve::slerp) return {RotationCurve::slerp, {from, from, to, to}, whole_turns};
    if (rules_.rotation_curve == RotationCurve::squad) {
      return {RotationCurve::squad,
              {from, moved(from, half, out, S(-half), chords_[key]), moved(to, half, chords_[key], S(-half), in), to},
              whole_turns};
    }
    Quaternion<S> second = moved(from, third, out, S(0), out), last = moved(to, S(-third), in, S(0), in);
    if (!is_linear_ && keys_.size() > 2) {  // as the Python package splines makes its natural ends
      const auto is_natural = [](const EndChoice<S>& end) { return end.rule == EndRule::natural; };
      const Chord& whole = chords_[key];
      if (window_.starts && key == 0 && is_natural(rules_.start)) second = moved(from, half, whole, S(0), whole);
      if (window_.ends && key + 2 == keys_.size() && is_natural(rules_.end))
        last = moved(to, S(-half), whole, S(0), whole);
    }
    return {rules_.rotation_curve, {from, second, last, to}};
  }

  const Window<S>& window_;
  const CurveRules<S>& rules_;
  const RotationColumns& rotation_;
  bool is_linear_;
  std::vector<Quaternion<S>> keys_;
  std::vector<Chord> chords_;
};

/// The curves of the rotations of a window, those of a segment after those of the one before.
template <class S>
std::vector<RotationSegment<S>> rotation_segments(const Window<S>& window, const CurveRules<S>& rules) {
  std::vector<RotationSegment<S>> result;
  const std::size_t count = rules.rotations.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto one = RotationOfWindow<S>(window, rules, rules.rotations[i]).segments();
    result.resize(one.size() * count);
    for (std::size_t segment = 0; segment < one.size(); ++segment) result[segment * count + i] = one[segment];
  }
  return result;
}

/// The segments of a window. Requires: window.has_segments() or window.is_single_key().
template <class S>
Segments<S> segments(const Window<S>& window, const CurveRules<S>& rules) {
  if (window.is_single_key()) return constant_segment(window.keys, rules);
  const Keys<S>& keys = window.keys;
  const Tangents<S> tangents(window, rules);
  const PositionChord<S> chord{keys, rules.angles};
  Segments<S> result{keys.channels, {}, {}, {}};
  result.angles = rules.angles;
  result.cubics.reserve((window.last_key() - window.first_key()) * keys.channels);
  for (std::size_t key = window.first_key(); key < window.last_key(); ++key) {
    result.times.push_back(keys.times[key]);
    for (std::size_t i = 0; i < keys.channels; ++i) {
      result.cubics.push_back(cubic<S>(keys.position(key)[i], keys.position(key + 1)[i], chord(key, i),
                                       tangents.outgoing(key)[i], tangents.incoming(key + 1)[i]));
    }
    if (!keys.eases.empty()) result.warps.emplace_back(keys.eases[key].out, keys.eases[key + 1].in);
  }
  result.times.push_back(keys.times[window.last_key()]);
  if constexpr (has_roots<S>) {
    result.rotation_columns = rules.rotations;
    result.rotations = rotation_segments(window, rules);
  }
  return result;
}

}  // namespace tcb::spline
