// From keys to measured pieces of the curve: checked, linked to segments, and measured where lengths matter.
#include "curve/segment_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "tcb/spline/scalar.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

void require_ease(const spline::Ease<double>& ease, std::uint64_t line) {
  for (const auto& [name, value] : {std::pair{"ease_in", ease.in}, std::pair{"ease_out", ease.out}}) {
    if (value >= 0 && value <= 1) continue;
    throw Error(Exit::data, TextPosition{"", line, 0},
                fmt::format("{} is {}; expected 0 to 1; correct it, or give --no-ease", name, value));
  }
}

[[noreturn]] void refuse_lost_step(std::uint64_t line, double step, double time) {
  throw Error(
      Exit::data, TextPosition{"", line, 0},
      fmt::format("the distance makes a step of {} that is lost beside the time {}; expected times that doubles "
                  "tell apart; give --parameter a smaller exponent",
                  step, time));
}

[[noreturn]] void refuse_tangents(const DoubleDouble& start, const DoubleDouble& end) {
  throw Error(Exit::data, fmt::format("the curve from time {} to {} has tangents beyond the range of doubles; expected "
                                      "less than 1.8e308 in size; scale the keys down",
                                      time_text(start), time_text(end)));
}

SegmentBlock stretch_of(const spline::Window<double>& window, const Rules& rules, bool measured) {
  SegmentBlock block{{}, {}, window.last, window.last && !window.ends};
  if (!window.has_segments() && !window.is_single_key()) return block;
  block.segments = spline::segments(window, rules);
  if (measured) measure(block, rules);
  return block;
}

/// The same keys in blocks of keys_at_once.
Source<Keys> in_small_blocks(Source<Keys> keys) {
  return [keys = std::move(keys), block = Keys(), next = std::size_t{0}]() mutable -> std::optional<Keys> {
    if (next == block.size()) {
      std::optional<Keys> more = keys();
      if (!more || more->size() <= keys_at_once) return more;
      block = std::move(*more);
      next = 0;
    }
    const std::size_t first = next;
    next = std::min(first + keys_at_once, block.size());
    Keys part;
    spline::append(part, block, first, next);
    return part;
  };
}

/// Windows of an open curve, as they become known.
Source<spline::Window<double>> open_windows(Source<Keys> keys) {
  return [keys = std::move(keys), linker = spline::Linker<double>(),
          ended = false]() mutable -> std::optional<spline::Window<double>> {
    if (ended) return std::nullopt;
    std::optional<Keys> block = keys();
    ended = !block;
    return linker.link(block.value_or(Keys{}), ended);
  };
}

/// Windows of a closed curve, whose keys are all there: the last block is known as such.
Source<spline::Window<double>> closed_windows(Source<Keys> keys, Keys context) {
  return [keys = std::move(keys), linker = spline::Linker<double>(std::move(context)), block = std::optional<Keys>(),
          started = false]() mutable -> std::optional<spline::Window<double>> {
    if (!std::exchange(started, true)) block = keys();
    if (!block) return std::nullopt;
    std::optional<Keys> next = keys();
    const Keys current = *std::exchange(block, std::move(next));
    return linker.link(current, !block);
  };
}

}  // namespace

double parameter_step(std::span<const double> a, std::span<const double> b, double exponent,
                      std::span<const std::size_t> metric) {
  if (exponent == 0) return 1;
  const std::size_t channels = metric.empty() ? a.size() : metric.size();
  double largest = 0;
  for (std::size_t i = 0; i < channels; ++i) {
    const std::size_t channel = metric.empty() ? i : metric[i];
    largest = std::max(largest, std::abs(b[channel] - a[channel]));
  }
  if (largest == 0) return 0;
  int unit = 0;
  (void)std::frexp(largest, &unit);
  --unit;  // 2^unit is a double even where the next power of two is none
  DoubleDouble sum;
  for (std::size_t i = 0; i < channels; ++i) {
    const std::size_t channel = metric.empty() ? i : metric[i];
    const DoubleDouble step = DoubleDouble(std::ldexp(b[channel], -unit)) - DoubleDouble(std::ldexp(a[channel], -unit));
    sum = sum + step * step;
  }
  return (spline::power(spline::sqrt(sum), exponent) * spline::power(DoubleDouble(std::ldexp(1.0, unit)), exponent)).hi;
}

Source<KeyBlock> parameterized(Source<KeyBlock> blocks, double exponent, std::vector<std::size_t> metric) {
  return [blocks = std::move(blocks), exponent, metric = std::move(metric), before = std::vector<double>(),
          line = std::uint64_t{0}, time = DoubleDouble()]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block) return std::nullopt;
    Keys& keys = block->keys;
    const std::size_t count = block->lines.size();
    keys.times.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto position = keys.position(i);
      const double step = before.empty() ? 0 : parameter_step(before, position, exponent, metric);
      if (!before.empty() && step == 0) {
        throw Error(
            Exit::data, TextPosition{"", block->lines[i], 0},
            fmt::format("the position repeats that in line {}; distances make the times, and here there is none; "
                        "take one of the rows out, or give --parameter uniform",
                        line));
      }
      const double earlier = time.hi;
      time = time + DoubleDouble(step);
      if (!before.empty() && time.hi == earlier) refuse_lost_step(block->lines[i], step, time.hi);
      keys.times.emplace_back(time.hi);
      before.assign(position.begin(), position.end());
      line = block->lines[i];
    }
    return block;
  };
}

Source<KeyBlock> checked(Source<KeyBlock> blocks, std::size_t least) {
  return [blocks = std::move(blocks), least, count = std::size_t{0},
          line = std::uint64_t{0}]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block && count < least) {
      throw Error(Exit::data, TextPosition{"", line, 0},
                  fmt::format("only {} {}; a curve needs two at least; add keys", count, count == 1 ? "key" : "keys"));
    }
    if (!block) return std::nullopt;
    for (std::size_t i = 0; i < block->keys.eases.size(); ++i) require_ease(block->keys.eases[i], block->lines[i]);
    if (count == 0 && block->keys.size() > 0) line = block->lines[0];
    count += block->keys.size();
    return block;
  };
}

void measure(SegmentBlock& block, const Rules& rules) {
  spline::ArcLength<double> arc;
  block.lengths.reserve(block.segments.size());
  for (std::size_t i = 0; i < block.segments.size(); ++i) {
    arc.assign(block.segments[i], rules.metric);
    if (!std::isfinite(arc.total().value)) refuse_tangents(block.segments.times[i], block.segments.times[i + 1]);
    block.lengths.push_back(arc.total());
  }
}

Source<SegmentBlock> segment_blocks(LinkedKeys keys, const Rules& rules, bool measured, unsigned threads) {
  keys.keys = in_small_blocks(std::move(keys.keys));
  auto windows = keys.context ? closed_windows(std::move(keys.keys), std::move(*keys.context))
                              : open_windows(std::move(keys.keys));
  const auto link = [rules, measured](const spline::Window<double>& window) {
    return stretch_of(window, rules, measured);
  };
  return ordered_map(std::move(windows), link, threads);
}

void require_length(const DoubleDouble& length, const Time& end) {
  if (std::isfinite(length.hi)) return;
  throw Error(Exit::data,
              fmt::format("up to time {} the curve is longer than doubles reach; expected less than 1.8e308; "
                          "scale the keys down",
                          time_text(end)));
}

Lengths all_lengths(const Source<SegmentBlock>& measured) {
  Lengths lengths;
  DoubleDouble sum;
  while (const std::optional<SegmentBlock> block = measured()) {
    for (std::size_t i = 0; i < block->lengths.size(); ++i) {
      lengths.push_back(block->lengths[i]);
      sum = sum + DoubleDouble(lengths.back().value);
      require_length(sum, block->segments.times[i + 1]);
    }
  }
  return lengths;
}

double total_length(const Lengths& lengths) {
  DoubleDouble sum;
  for (const auto& length : lengths) sum = sum + DoubleDouble(length.value);
  return sum.hi;
}

Source<SegmentBlock> with_lengths(Source<SegmentBlock> segment_blocks, Lengths lengths) {
  return [segment_blocks = std::move(segment_blocks), lengths = std::move(lengths),
          next = std::ptrdiff_t{0}]() mutable -> std::optional<SegmentBlock> {
    std::optional<SegmentBlock> block = segment_blocks();
    if (!block) return std::nullopt;
    const auto begin = lengths.begin() + next;
    next += static_cast<std::ptrdiff_t>(block->segments.size());
    block->lengths.assign(begin, lengths.begin() + next);
    return block;
  };
}

}  // namespace tcb
