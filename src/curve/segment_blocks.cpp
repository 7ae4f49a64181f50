// From keys to measured pieces of the curve: checked, linked to segments, and measured where lengths matter.
#include "curve/segment_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

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
