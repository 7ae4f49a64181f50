// From keys to measured pieces of the curve: checked, linked to segments, and measured where lengths matter.
#include "pieces.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "error.hpp"
#include "format/number.hpp"
#include "spline/arc_length.hpp"

namespace tcb {
namespace {

using spline::Time;

std::string text(const Time<double>& time) {
  std::string out;
  format::append_time(out, time);
  return out;
}

/// A key's time, and its line.
struct Row {
  Time<double> time;
  std::uint64_t line;
};

void require_increase(const Row& before, const Row& row) {
  if (before.time < row.time) return;
  const bool equal = before.time == row.time;
  throw Error(Exit::data, Place{"", row.line, 0},
              fmt::format("time {} {} the time {} in line {}; expected times that increase; {}", text(row.time),
                          equal ? "repeats" : "is less than", text(before.time), before.line,
                          equal ? "take one of the rows out" : "sort the rows by time"));
}

Stretch measure(const spline::Window<double>& window, const CurvePlan& plan, bool measured) {
  Stretch stretch{{}, {}, window.ends};
  if (!window.has_segments()) return stretch;
  stretch.segments = spline::segments(window, plan.rules);
  for (std::size_t i = 0; measured && i < stretch.segments.size(); ++i) {
    stretch.lengths.push_back(spline::length(spline::Speed<double>(stretch.segments[i], plan.metric)));
  }
  return stretch;
}

/// Windows of the keys, as they become known.
Source<spline::Window<double>> windows(Source<Keys> keys) {
  return [keys = std::move(keys), linker = spline::Linker<double>(),
          ended = false]() mutable -> std::optional<spline::Window<double>> {
    if (ended) return std::nullopt;
    std::optional<Keys> block = keys();
    ended = !block;
    return linker.link(block.value_or(Keys{}), ended);
  };
}

}  // namespace

Source<Keys> increasing(Source<format::KeyBlock> blocks) {
  return [blocks = std::move(blocks), before = std::optional<Row>(),
          count = std::size_t{0}]() mutable -> std::optional<Keys> {
    std::optional<format::KeyBlock> block = blocks();
    if (!block && count < 2) {
      throw Error(Exit::data,
                  fmt::format("only {} {}; a curve needs two at least; add keys", count, count == 1 ? "key" : "keys"));
    }
    if (!block) return std::nullopt;
    for (std::size_t i = 0; i < block->keys.size(); ++i) {
      const Row row{block->keys.times[i], block->lines[i]};
      if (before) require_increase(*before, row);
      before = row;
    }
    count += block->keys.size();
    return std::move(block->keys);
  };
}

Source<Stretch> stretches(Source<Keys> keys, const CurvePlan& plan, bool measured) {
  return ordered_map(windows(std::move(keys)), [plan, measured](const spline::Window<double>& window) {
    return measure(window, plan, measured);
  });
}

KeptKeys::KeptKeys(const Source<Keys>& keys) : blocks_(std::make_shared<std::vector<Keys>>()) {
  while (std::optional<Keys> block = keys()) {
    if (block->size() > 0) blocks_->push_back(std::move(*block));
  }
}

Source<Keys> KeptKeys::source() const {
  return [blocks = blocks_, next = std::size_t{0}]() mutable {
    return next < blocks->size() ? std::optional((*blocks)[next++]) : std::nullopt;
  };
}

double total_length(const Source<Stretch>& measured) {
  spline::Twice sum;
  while (const std::optional<Stretch> stretch = measured()) {
    for (const double length : stretch->lengths) sum = sum + length;
  }
  return sum.hi;
}

}  // namespace tcb
