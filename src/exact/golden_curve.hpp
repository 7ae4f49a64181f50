// The curve at any scalar: its segments, their times and their lengths, each worked out when it is asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "exact/exact_keys.hpp"
#include "exact/scalar.hpp"
#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/arc_length.hpp"

namespace tcb {

/// A segment between two keys of the curve.
template <class S>
struct GoldenSegment {
  S start, end;
  std::vector<spline::Cubic<S>> cubics;
  spline::Warp<S> warp = {};
  std::optional<spline::ArcLength<S>> arc = {};
};

template <class S>
class GoldenCurve {
 public:
  /// Requires: `exact` outlives it.
  explicit GoldenCurve(const ExactCurve& exact) : exact_(exact), rules_{exact.rules.tangents, {}, {}, {}, {}} {
    const auto at_scalar = [](const spline::EndChoice<Rational>& from) {
      spline::EndChoice<S> to{from.rule, {}};
      for (const Rational& value : from.velocity) to.velocity.push_back(scalar_of<S>(value));
      return to;
    };
    rules_.start = at_scalar(exact.rules.start);
    rules_.end = at_scalar(exact.rules.end);
    rules_.equal_speed = exact.rules.equal_speed;
    rules_.metric = exact.rules.metric;
    set_times();
    set_lanes();
    Rational extent = 0;
    are_zero_.assign(exact.keys.channels, true);
    are_still_.assign(exact.keys.channels, true);
    for (std::size_t i = 0; i < exact.keys.positions.size(); ++i) {
      const std::size_t channel = i % exact.keys.channels;
      const Rational distance = abs(exact.keys.positions[i] - exact.keys.positions[channel]);
      if (extent < distance) extent = distance;
      if (distance != 0) are_still_[channel] = false;
      if (exact.keys.positions[i] != 0) are_zero_[channel] = false;
    }
    extent_ = scalar_of<S>(extent);
  }

  /// How many segments there are: one at least.
  std::size_t size() const { return times_.size() - 1; }
  const S& time(std::size_t key) const { return times_[key]; }

  const GoldenSegment<S>& segment(std::size_t number) {
    constexpr std::size_t most_kept = 64;
    if (const auto found = segments_.find(number); found != segments_.end()) return found->second;
    if (segments_.size() == most_kept) segments_.clear();
    return segments_.emplace(number, made(number)).first->second;
  }

  const spline::ArcLength<S>& arc(std::size_t number) {
    auto& arc = const_cast<GoldenSegment<S>&>(segment(number)).arc;
    if (!arc) arc.emplace(segment(number).cubics, rules_.metric);
    return *arc;
  }

  /// The length from the curve's first key to the one with this number, 0 to size().
  const S& length_to(std::size_t key) {
    if (lengths_.empty()) lengths_.push_back(S(0));
    for (std::size_t i = lengths_.size(); i <= key; ++i) {
      lengths_.push_back(lengths_.back() + spline::ArcLength<S>(made(i - 1).cubics, rules_.metric).total().value);
    }
    return lengths_[key];
  }
  const S& length() { return length_to(size()); }

  /// Last key - first key in a channel.
  S cycle(std::size_t channel) const {
    const auto& keys = lanes_[lanes_.size() == 1 ? 0 : channel].keys;
    const std::size_t last = is_closed() ? keys.front() : keys.back();
    return scalar_of<S>(exact_.keys.position(last)[channel] - exact_.keys.position(keys.front())[channel]);
  }

  /// All keys have the same position in a channel, or even 0.
  bool is_still(std::size_t channel) const { return are_still_[channel] && !has_velocities(); }
  bool is_zero(std::size_t channel) const { return are_zero_[channel] && !has_velocities(); }

  /// How far a key lies from the first one in a channel, at most.
  const S& extent() const { return extent_; }

  std::span<const std::size_t> metric() const { return rules_.metric; }
  bool is_closed() const { return exact_.closed; }

 private:
  /// Channels with the keys that they go through, by their numbers.
  struct Lane {
    std::size_t channel, channels;
    std::vector<std::size_t> keys;
  };

  /// Of its ends: they move it where its keys do not.
  bool has_velocities() const { return !rules_.start.velocity.empty() || !rules_.end.velocity.empty(); }

  void set_times();
  void set_lanes();
  S distance(std::size_t from, std::size_t to) const;
  GoldenSegment<S> made(std::size_t number) const;
  /// The segments that are known by the keys around a lane's segment, and its own number among them.
  spline::Segments<S> segments_of(const Lane& lane, std::ptrdiff_t number) const;
  std::vector<spline::Cubic<S>> cubics_between(const Lane& lane, std::size_t number, spline::Warp<S>& warp) const;
  S time_on(const Lane& lane, std::ptrdiff_t number) const;
  void append_key(spline::Keys<S>& to, const Lane& lane, std::ptrdiff_t number) const;
  spline::CurveRules<S> rules_of(const Lane& lane) const;

  /// A number of a lane's key, which on a closed curve may lie before its first or behind its last: how often it went
  /// round, and which key it is.
  static std::pair<std::ptrdiff_t, std::size_t> wrapped(const Lane& lane, std::ptrdiff_t number) {
    const auto keys = static_cast<std::ptrdiff_t>(lane.keys.size());
    const std::ptrdiff_t rest = (number % keys + keys) % keys;
    return {(number - rest) / keys, lane.keys[static_cast<std::size_t>(rest)]};
  }

  const ExactCurve& exact_;
  spline::CurveRules<S> rules_;
  std::vector<S> times_;  ///< of the keys, and of the first one come round
  std::vector<Lane> lanes_;
  std::map<std::size_t, GoldenSegment<S>> segments_;
  std::vector<S> lengths_;
  S extent_{};
  std::vector<bool> are_zero_, are_still_;  ///< of each channel
};

template <class S>
S GoldenCurve<S>::distance(std::size_t from, std::size_t to) const {
  if constexpr (spline::has_roots<S>) {
    return tcb::distance<S>(exact_.keys.position(from), exact_.keys.position(to), rules_.metric, *exact_.exponent);
  } else {
    return S(0);  // nobody asks: such a curve is not rational
  }
}

template <class S>
void GoldenCurve<S>::set_times() {
  const std::size_t keys = exact_.keys.size();
  for (std::size_t i = 0; i < keys; ++i) {
    if (!exact_.exponent) times_.push_back(scalar_of<S>(exact_.keys.times[i]));
    if (exact_.exponent) times_.push_back(i == 0 ? S(0) : times_.back() + distance(i - 1, i));
  }
  if (exact_.end) times_.push_back(scalar_of<S>(*exact_.end));
  if (exact_.closed && !exact_.end) times_.push_back(times_.back() + distance(keys - 1, 0));
  if (times_.size() == 1) times_.push_back(times_[0]);
}

template <class S>
void GoldenCurve<S>::set_lanes() {
  const std::size_t channels = exact_.keys.channels;
  const bool apart = !exact_.missing.empty();
  for (std::size_t i = 0; i < (apart ? channels : 1); ++i) {
    Lane lane{i, apart ? 1 : channels, {}};
    for (std::size_t key = 0; key < exact_.keys.size(); ++key) {
      if (!apart || !exact_.missing[key * channels + i]) lane.keys.push_back(key);
    }
    lanes_.push_back(std::move(lane));
  }
}

template <class S>
S GoldenCurve<S>::time_on(const Lane& lane, std::ptrdiff_t number) const {
  const auto [rounds, key] = wrapped(lane, number);
  return rounds == 0 ? times_[key] : times_[key] + S(static_cast<int>(rounds)) * (times_.back() - times_.front());
}

template <class S>
void GoldenCurve<S>::append_key(spline::Keys<S>& to, const Lane& lane, std::ptrdiff_t number) const {
  const std::size_t key = wrapped(lane, number).second;
  const spline::Tcb<Rational>& tcb = exact_.keys.tcb(key);
  to.times.push_back(time_on(lane, number));
  to.tcbs.push_back({scalar_of<S>(tcb.tension), scalar_of<S>(tcb.continuity), scalar_of<S>(tcb.bias)});
  for (const Rational& p : exact_.keys.position(key).subspan(lane.channel, lane.channels)) {
    to.positions.push_back(scalar_of<S>(p));
  }
  if (exact_.keys.eases.empty()) return;
  const spline::Ease<Rational>& ease = exact_.keys.eases[key];
  to.eases.push_back({scalar_of<S>(ease.in), scalar_of<S>(ease.out)});
}

/// A lane of its own has all to itself.
template <class S>
spline::CurveRules<S> GoldenCurve<S>::rules_of(const Lane& lane) const {
  spline::CurveRules<S> own = rules_;
  if (lanes_.size() == 1) return own;
  own.metric.clear();
  for (auto* end : {&own.start, &own.end}) {
    if (!end->velocity.empty()) end->velocity = {end->velocity[lane.channel]};
  }
  return own;
}

template <class S>
spline::Segments<S> GoldenCurve<S>::segments_of(const Lane& lane, std::ptrdiff_t number) const {
  const auto last = static_cast<std::ptrdiff_t>(lane.keys.size()) - 1;
  const bool starts = !exact_.closed && number == 0, ends = !exact_.closed && number + 1 >= last;
  spline::Window<S> window{{}, starts, ends, true};
  window.keys.channels = lane.channels;
  const std::ptrdiff_t first_key = starts ? 0 : number - 1;
  const std::ptrdiff_t last_key = ends ? last : number + 2;
  for (std::ptrdiff_t key = first_key; key <= last_key; ++key) append_key(window.keys, lane, key);
  return spline::segments(window, rules_of(lane));
}

template <class S>
std::vector<spline::Cubic<S>> GoldenCurve<S>::cubics_between(const Lane& lane, std::size_t number,
                                                             spline::Warp<S>& warp) const {
  const auto behind = std::ranges::upper_bound(lane.keys, number);
  const std::ptrdiff_t own = behind - lane.keys.begin() - 1;
  const auto last = static_cast<std::ptrdiff_t>(lane.keys.size()) - 1;
  if (!exact_.closed && (own < 0 || own >= last)) {
    const S rest = scalar_of<S>(exact_.keys.position(lane.keys[own < 0 ? 0 : lane.keys.size() - 1])[lane.channel]);
    if (lanes_.size() > 1) return {spline::cubic<S>(rest, rest, S(0), S(0))};
  }
  const spline::Segments<S> segments = segments_of(lane, own);
  warp = segments.warp(0);
  std::vector<spline::Cubic<S>> cubics;
  for (const spline::Cubic<S>& cubic : segments[0]) {
    cubics.push_back(lanes_.size() == 1 ? cubic
                                        : spline::part(cubic, time_on(lane, own), time_on(lane, own + 1),
                                                       times_[number], times_[number + 1]));
  }
  return cubics;
}

template <class S>
GoldenSegment<S> GoldenCurve<S>::made(std::size_t number) const {
  GoldenSegment<S> segment{times_[number], times_[number + 1], {}};
  for (const Lane& lane : lanes_) {
    const auto cubics = cubics_between(lane, number, segment.warp);
    segment.cubics.insert(segment.cubics.end(), cubics.begin(), cubics.end());
  }
  return segment;
}

}  // namespace tcb
