// Rotation of a window: the curve of one rotation between successive keys, with the tangents that the rules give it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "tcb/spline/detail/tangents.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segments.hpp"
#include "tcb/spline/window.hpp"

namespace tcb::spline {

/// The curve of one rotation through the keys of a window.
template <class S>
class RotationOfWindow {
 public:
  using W = working_t<S>;

  /// `rules`: of rotations. Requires: at least two keys.
  RotationOfWindow(const Window<S>& window, const CurveRules<S>& rules, const KeyRotation& rotation)
      : window_(window),
        rules_(rules),
        rotation_(rotation),
        is_linear_(rules.rotation_rules.curve == RotationCurve::components) {
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
    const Window<S> turns = window_of_chords();
    std::vector<W> chords;
    for (const Chord& chord : chords_) chords.insert(chords.end(), chord.begin(), chord.begin() + (is_linear_ ? 4 : 3));
    const Tangents<S> tangents(turns, rules_, std::move(chords));
    std::vector<RotationSegment<S>> result;
    for (std::size_t key = window_.first_key(); key < window_.last_key(); ++key) {
      result.push_back(segment(key, rounded(tangents.outgoing(key)), rounded(tangents.incoming(key + 1))));
    }
    return result;
  }

  bool is_of_components() const { return is_linear_; }

  /// Replaces the cubics of the four numbers between the keys with those of this curve, whose keys have the signs that
  /// join them, also where a closed curve returns to its first key. Requires: is_of_components().
  void set_cubics(std::vector<Cubic<S>>& cubics) const {
    Window<S> turns = window_of_chords();
    const auto number = [&](std::size_t key, std::size_t i) {
      const auto& [x, y, z, w] = keys_[key];
      return std::array{x, y, z, w}[i];
    };
    if constexpr (std::is_same_v<S, double>) keep_given_velocities(turns.keys, number);
    std::vector<W> chords;
    for (std::size_t key = 0; key + 1 < keys_.size(); ++key) {
      for (std::size_t i = 0; i < 4; ++i) chords.push_back(exact_difference(number(key + 1, i), number(key, i)));
    }
    const Tangents<S> tangents(turns, rules_, std::move(chords));
    for (std::size_t key = window_.first_key(); key < window_.last_key(); ++key) {
      Cubic<S>* const of_segment = cubics.data() + (key - window_.first_key()) * window_.keys.channels;
      for (std::size_t i = 0; i < rotation_.channels.size(); ++i) {
        of_segment[rotation_.channels[i]] =
            cubic<S>(number(key, i), number(key + 1, i), tangents.outgoing(key)[i], tangents.incoming(key + 1)[i]);
      }
    }
  }

 private:
  using Chord = std::array<S, 4>;  ///< a logarithm and 0, or the differences of the four numbers

  /// The window with the chords' numbers as channels.
  Window<S> window_of_chords() const {
    Window<S> turns = window_;
    turns.keys.channels = is_linear_ ? 4 : 3;
    turns.keys.positions.assign(keys_.size() * turns.keys.channels, S(0));
    set_velocities(turns.keys);
    if (window_.keys.has_channel_tcbs()) {  // all numbers take those of the first
      turns.keys.tcbs.clear();
      for (std::size_t key = 0; key < keys_.size(); ++key)
        turns.keys.tcbs.push_back(window_.keys.tcb(key, rotation_.channels[0]));
    }
    return turns;
  }

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

  bool has_velocities() const { return !window_.keys.given.empty() && window_.keys.given[rotation_.channels[0]]; }

  /// The velocities of chords, where those of the four numbers are given.
  void set_velocities(Keys<S>& turns) const {
    turns.velocities.clear();
    if (!has_velocities()) return;
    turns.given.assign(turns.channels, true);
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      const Chord in = velocity(key, &Velocity<S>::in), out = velocity(key, &Velocity<S>::out);
      for (std::size_t i = 0; i < turns.channels; ++i) turns.velocities.push_back({in[i], out[i]});
    }
  }
  /// Takes the given velocities as they are, or negated, where those of a key differ from them by rounding alone.
  template <class Number>
  void keep_given_velocities(Keys<S>& turns, const Number& number) const {
    const Keys<S>& keys = window_.keys;
    for (std::size_t key = 0; has_velocities() && key < keys_.size(); ++key) {
      const auto is_given = [&](const S& sign) {
        bool same = true;
        for (std::size_t i = 0; i < 4; ++i) {
          same = same && number(key, i) == sign * keys.position(key)[rotation_.channels[i]];
        }
        return same;
      };
      const S sign(is_given(S(1)) ? 1 : is_given(S(-1)) ? -1 : 0);
      for (std::size_t i = 0; sign != S(0) && i < 4; ++i) {
        const auto& [in, out] = keys.velocities[key * keys.channels + rotation_.channels[i]];
        turns.velocities[key * 4 + i] = {sign * in, sign * out};
      }
    }
  }
  /// The velocity as that of a logarithm (only the turning part), equal for q and -q.
  Chord velocity(std::size_t key, S Velocity<S>::*side) const {
    const auto four = [&](auto number) {
      const auto [x, y, z, w] = rotation_.channels;
      return Quaternion<S>{number(x), number(y), number(z), number(w)};
    };
    const Keys<S>& keys = window_.keys;
    const Quaternion<S> given = four([&](std::size_t i) { return keys.positions[key * keys.channels + i]; });
    const Quaternion<S> v = four([&](std::size_t i) { return keys.velocities[key * keys.channels + i].*side; });
    const S cosine = dot(keys_[key], given);  // times the norm of the given one
    if (is_linear_) return {v.x / cosine, v.y / cosine, v.z / cosine, v.w / cosine};
    const Quaternion<S> turn = conjugate(keys_[key]) * v;
    return {turn.x / cosine, turn.y / cosine, turn.z / cosine, S(0)};
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
    const RotationCurve curve = rules_.rotation_rules.curve;
    if (curve == RotationCurve::slerp) return {RotationCurve::slerp, {from, from, to, to}, whole_turns};
    if (curve == RotationCurve::squad) {
      return {RotationCurve::squad,
              {from, moved(from, half, out, S(-half), chords_[key]), moved(to, half, chords_[key], S(-half), in), to},
              whole_turns};
    }
    Quaternion<S> second = moved(from, third, out, S(0), out), last = moved(to, S(-third), in, S(0), in);
    if (!is_linear_ && !has_velocities() && keys_.size() > 2) {  // as the Python package splines makes its natural ends
      const auto is_natural = [](const EndChoice<S>& end) { return end.rule == EndRule::natural; };
      const Chord& whole = chords_[key];
      if (window_.starts && key == 0 && is_natural(rules_.start)) second = moved(from, half, whole, S(0), whole);
      if (window_.ends && key + 2 == keys_.size() && is_natural(rules_.end))
        last = moved(to, S(-half), whole, S(0), whole);
    }
    return {curve, {from, second, last, to}};
  }

  const Window<S>& window_;
  const CurveRules<S>& rules_;
  const KeyRotation& rotation_;
  bool is_linear_;
  std::vector<Quaternion<S>> keys_;
  std::vector<Chord> chords_;
};

/// Sets all rotation curves of a window, segment by segment, and the cubics of numbers of which they are made.
template <class S>
void set_rotations(Segments<S>& segments, const Window<S>& window, const CurveRules<S>& rules) {
  std::vector<RotationSegment<S>>& result = segments.rotations;
  const std::size_t count = rules.rotations.size();
  const CurveRules<S> own_rules = rules_of_rotations(rules);
  for (std::size_t i = 0; i < count; ++i) {
    const RotationOfWindow<S> rotation(window, own_rules, rules.rotations[i]);
    if (rotation.is_of_components()) rotation.set_cubics(segments.cubics);
    const auto one = rotation.segments();
    result.resize(one.size() * count);
    for (std::size_t segment = 0; segment < one.size(); ++segment) result[segment * count + i] = one[segment];
  }
}

}  // namespace tcb::spline
