// Windows: successive keys with one key of context on either side, their tangents and their segments.
//
// Segment i is complete with the key after its end: its end tangent needs both neighbours. A window is therefore a few
// keys with one key of context on either side, unless the curve starts or ends there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tcb/spline/ease.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rules.hpp"
#include "tcb/spline/segment.hpp"

namespace tcb::spline {

/// Successive keys of one curve, with the key before and the key after those of the segments.
template <class S>
struct Window {
  Keys<S> keys;
  bool starts = true;  ///< the first key is the curve's first, not context
  bool ends = true;    ///< the last key is the curve's last, not context
  bool last = true;    ///< no window follows

  std::size_t first_key() const { return starts ? 0 : 1; }
  std::size_t last_key() const { return keys.size() - (ends ? 1 : 2); }
  bool is_single_key() const { return starts && ends && keys.size() == 1; }
  bool has_segments() const { return keys.size() > (starts ? 1U : 2U) + (ends ? 0U : 1U); }
};

/// Cuts a stream of keys into windows. It keeps three keys, for a curve of any length.
template <class S>
class Linker {
 public:
  /// For an open curve.
  Linker() = default;
  /// For a closed curve: `context` is the key before the first one. The given keys end with the first key
  /// repeated one period later, and one key more.
  explicit Linker(Keys<S> context) : tail_(std::move(context)), starts_(false), closed_(true) {}

  /// The window that these keys complete; it may have no segments yet. `last`: no keys follow.
  Window<S> link(const Keys<S>& block, bool last) {
    Window<S> window{std::move(tail_), starts_, last && !closed_, last};
    append(window.keys, block, 0, block.size());
    tail_ = {};
    if (last) return window;
    if (window.has_segments()) starts_ = false;
    const std::size_t size = window.keys.size();
    append(tail_, window.keys, starts_ || size < 3 ? 0 : size - 3, size);
    return window;
  }

 private:
  Keys<S> tail_;
  bool starts_ = true;
  bool closed_ = false;
};

/// The rule at one end of an open curve.
template <class S>
struct EndChoice {
  EndRule rule = EndRule::half;
  std::vector<S> velocity;  ///< per unit of time, one number per channel, where the rule takes one
};

/// The channels that together are a rotation: those of the numbers x, y, z, w of a quaternion.
using RotationChannels = std::array<std::size_t, 4>;

/// The rules that give the tangents of keys.
template <class S>
struct CurveRules {
  TangentRule tangents = TangentRule::velocity;
  EndChoice<S> start, end;
  bool equal_speed = false;         ///< both tangents of a key get the same speed
  std::vector<std::size_t> metric;  ///< the channels of speeds and lengths; empty: all
  std::vector<RotationChannels> rotations = {};
  RotationCurve rotation_curve = RotationCurve::squad;
};

/// The rules of a product, the same end rule for both ends.
template <class S>
CurveRules<S> rules_of(Preset preset) {
  const PresetRow& row = row_of(preset);
  return {row.tangents, {row.ends, {}}, {row.ends, {}}, false, {}, {}, row.rotation_curve};
}

/// Successive segments. Shapes: one more time than segments; `channels` cubics per segment; one warp per
/// segment, or none if no key has ease.
template <class S>
struct Segments {
  std::size_t channels = 0;
  std::vector<Time<S>> times;
  std::vector<Cubic<S>> cubics;
  std::vector<Warp<S>> warps;

  std::size_t size() const { return times.empty() ? 0 : times.size() - 1; }
  std::span<const Cubic<S>> operator[](std::size_t segment) const {
    return std::span(cubics).subspan(segment * channels, channels);
  }
  Warp<S> warp(std::size_t segment) const { return warps.empty() ? Warp<S>() : warps[segment]; }
};

/// The tangents at the keys of a window, `channels` numbers per key, in local units.
template <class S>
class Tangents {
 public:
  using W = working_t<S>;

  /// Requires: at least two keys. Context keys are left at zero.
  Tangents(const Window<S>& window, const CurveRules<S>& rules) : keys_(window.keys), rules_(rules) {
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
  /// P[key + 1] - P[key] in one channel.
  W chord(std::size_t key, std::size_t channel) const {
    return exact_difference(keys_.position(key + 1)[channel], keys_.position(key)[channel]);
  }

  /// The tangents of a key in the channels [first, last), which have the same tension, continuity and bias.
  void set_interior(std::size_t key, std::size_t first, std::size_t last, const Factors<W>& f, const Tcb<S>& tcb) {
    const W h0 = keys_.times[key] - keys_.times[key - 1];
    const W h1 = keys_.times[key + 1] - keys_.times[key];
    const auto weights = row_of<S>(rules_.tangents).weights({f, W(tcb.continuity), h0, h1});
    for (std::size_t i = first; i < last; ++i) {
      const W d0 = chord(key - 1, i);
      const W d1 = chord(key, i);
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
      W tangent = weights.chord * chord(first, i) + weights.other * others[inner * keys_.channels + i];
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
  std::vector<W> incoming_, outgoing_;
};

/// A single key as a constant segment without duration.
template <class S>
Segments<S> constant_segment(const Keys<S>& keys) {
  Segments<S> result{keys.channels, {keys.times[0], keys.times[0]}, {}, {}};
  for (const S& p : keys.positions) result.cubics.push_back(cubic<S>(p, p, working_t<S>(0), working_t<S>(0)));
  return result;
}

/// The segments of a window. Requires: window.has_segments() or window.is_single_key().
template <class S>
Segments<S> segments(const Window<S>& window, const CurveRules<S>& rules) {
  if (window.is_single_key()) return constant_segment(window.keys);
  const Keys<S>& keys = window.keys;
  const Tangents<S> tangents(window, rules);
  Segments<S> result{keys.channels, {}, {}, {}};
  result.cubics.reserve((window.last_key() - window.first_key()) * keys.channels);
  for (std::size_t key = window.first_key(); key < window.last_key(); ++key) {
    result.times.push_back(keys.times[key]);
    for (std::size_t i = 0; i < keys.channels; ++i) {
      result.cubics.push_back(cubic<S>(keys.position(key)[i], keys.position(key + 1)[i], tangents.outgoing(key)[i],
                                       tangents.incoming(key + 1)[i]));
    }
    if (!keys.eases.empty()) result.warps.emplace_back(keys.eases[key].out, keys.eases[key + 1].in);
  }
  result.times.push_back(keys.times[window.last_key()]);
  return result;
}

}  // namespace tcb::spline
