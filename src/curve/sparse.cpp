// Sparse channels: where keys lack some positions, each channel goes through its own keys, and all are joined again.
#include "curve/sparse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.hpp"

namespace tcb {
namespace {

using spline::Cubic;
using spline::DoubleDouble;
using spline::Segments;

/// All keys in one, the context of a closed curve before them.
Keys whole(const LinkedKeys& linked) {
  Keys all = linked.context.value_or(Keys{});
  while (const std::optional<Keys> block = linked.keys()) spline::append(all, *block, 0, block->size());
  return all;
}

/// One channel of a curve.
class Channel {
 public:
  /// `first` and `last`: the keys between which the curve is; on a closed one, others come round before and after.
  Channel(const Keys& keys, std::size_t channel, const Rules& rules, std::size_t first, std::size_t last) {
    Rules own = rules;
    own.metric.clear();
    for (auto* end : {&own.start, &own.end}) {
      if (!end->velocity.empty()) end->velocity = {end->velocity[channel]};
    }
    spline::Window<double> window{own_keys(keys, channel, first, last), true, true, true};
    if (first > 0 && window.keys.size() > 0) go_round(window, keys.times[last] - keys.times[first]);
    any_ = window.keys.size() > 0;
    if (any_) segments_ = spline::segments(window, own);
  }

  bool any() const { return any_; }

  /// The cubic from one key of the curve to the next. Requires: calls go forward.
  Cubic<double> between(const Time& from, const Time& to) {
    while (next_ + 1 < segments_.size() && segments_.times[next_ + 1] <= from) ++next_;
    const Cubic<double>& x = segments_[next_][0];
    const bool before = to <= segments_.times[next_], behind = segments_.times[next_ + 1] <= from;
    if (!before && !behind) return spline::part(x, segments_.times[next_], segments_.times[next_ + 1], from, to);
    const double rest = before ? x.p0 : x.p1;
    return spline::cubic<double>(rest, rest, DoubleDouble(0), DoubleDouble(0));
  }

 private:
  static Keys own_keys(const Keys& keys, std::size_t channel, std::size_t first, std::size_t last) {
    Keys own;
    own.channels = 1;
    own.common_tcb = keys.common_tcb;
    const std::size_t end = first > 0 ? last : last + 1;  // on a closed curve the last key is the first one again
    for (std::size_t i = first; i < end; ++i) {
      const double position = keys.position(i)[channel];
      if (std::isnan(position)) continue;
      own.times.push_back(keys.times[i]);
      own.positions.push_back(position);
      if (!keys.tcbs.empty()) own.tcbs.push_back(keys.tcbs[i]);
    }
    return own;
  }

  /// On a closed curve, the last keys come before the first, and the first after the last.
  static void go_round(spline::Window<double>& window, const Time& period) {
    const Keys own = window.keys;
    const std::size_t size = own.size();
    Keys round;
    const auto add = [&](std::size_t key, const Time& by) {
      spline::append(round, own, key, key + 1);
      round.times.back() = round.times.back() + by;
    };
    for (const std::size_t back : {std::size_t{2}, std::size_t{1}}) {
      add((2 * size - back) % size, back > size ? -(period + period) : -period);
    }
    spline::append(round, own, 0, size);
    for (const std::size_t on : {std::size_t{0}, std::size_t{1}}) {
      add(on % size, on >= size ? period + period : period);
    }
    window = {std::move(round), false, false, true};
  }

  Segments<double> segments_;
  std::size_t next_ = 0;
  bool any_ = false;
};

}  // namespace

Source<SegmentBlock> sparse_stretches(const LinkedKeys& linked, const Rules& rules, bool measured,
                                      const std::vector<std::string>& channels) {
  const bool closed = linked.context.has_value();
  const Keys keys = whole(linked);
  const std::size_t first = closed ? 1 : 0, last = keys.size() - (closed ? 2 : 1);
  std::vector<Channel> lanes;
  for (std::size_t i = 0; i < keys.channels; ++i) {
    lanes.emplace_back(keys, i, rules, first, last);
    if (lanes.back().any()) continue;
    throw Error(Exit::data, fmt::format("{}: no key has a number; expected one at least; fill one in, or leave the "
                                        "column out with --columns",
                                        channels[i]));
  }
  SegmentBlock block{{keys.channels, {}, {}, {}}, {}, true, closed};
  for (std::size_t key = first; key <= last; ++key) {
    block.segments.times.push_back(keys.times[key]);
    for (std::size_t i = 0; i < keys.channels && key < last; ++i) {
      block.segments.cubics.push_back(lanes[i].between(keys.times[key], keys.times[key + 1]));
    }
  }
  if (first == last) block.segments = spline::constant_segment(keys);
  if (measured) measure(block, rules);
  return [block = std::optional(std::move(block))]() mutable { return std::exchange(block, std::nullopt); };
}

}  // namespace tcb
