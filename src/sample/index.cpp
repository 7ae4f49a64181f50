// Random access to a curve: its segments by number, time or arc length, and rows in any order, also outside it.
#include "sample/index.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "numbers/decimal_time.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

/// Rows in blocks; `find` gives the number of a row's segment. Neighbouring rows on one segment are located together.
Source<SampleBlock> blocks(std::shared_ptr<const CurveIndex> curve, std::uint64_t rows,
                           std::function<std::uint64_t(std::uint64_t)> find) {
  return [curve = std::move(curve), rows, find = std::move(find),
          row = std::uint64_t{0}]() mutable -> std::optional<SampleBlock> {
    if (row == rows) return std::nullopt;
    SampleBlock block{curve, {}, row == 0};
    const std::uint64_t end = row + std::min(SampleBlock::most_rows, rows - row);
    for (; row < end; ++row) {
      const std::uint64_t number = find(row);
      if (block.parts.empty() || block.parts.back().segment.number != number) {
        block.parts.push_back({curve->segment(number), row, row});
      }
      block.parts.back().last = row + 1;
    }
    return block;
  };
}

}  // namespace

std::vector<Time> with_keys(const std::vector<Time>& times, const CurveIndex& curve, const Time& from, const Time& to) {
  const Time near = times.size() > 1 ? (times[1] - times[0]) * Time(1e-9) : Time(0.0);
  std::vector<Time> merged;
  std::size_t next = 0;
  for (std::uint64_t i = 0; i <= curve.size(); ++i) {
    const Time key = i < curve.size() ? curve.segment(i).start : curve.segment(i - 1).end;
    if (key < from - near || key > to + near) continue;
    for (; next < times.size() && times[next] < key - near; ++next) merged.push_back(times[next]);
    while (next < times.size() && times[next] <= key + near) ++next;
    merged.push_back(key);
  }
  merged.insert(merged.end(), times.begin() + static_cast<std::ptrdiff_t>(next), times.end());
  return merged;
}

CurveIndex::CurveIndex(const Source<SegmentBlock>& segments, CurveChannels channels)
    : first_numbers_{0}, s_{DoubleDouble()}, s_error_{0}, channels_(std::move(channels)) {
  while (std::optional<SegmentBlock> block = segments()) {
    const std::size_t size = block->segments.size();
    if (size == 0) continue;
    for (std::size_t i = 0; i < size; ++i) {
      s_error_.push_back(s_error_.back() + (block->lengths.empty() ? 0 : block->lengths[i].error));
      s_.push_back(block->lengths.empty() ? DoubleDouble() : s_.back() + DoubleDouble(block->lengths[i].value));
    }
    for (const Time& time : block->segments.times) decimals_ = std::max(decimals_, decimals_of(time));
    first_numbers_.push_back(first_numbers_.back() + size);
    blocks_.push_back(std::move(*block));
  }
  const CurveSegment first = segment(0);
  const CurveSegment last = segment(size() - 1);
  for (std::size_t i = 0; i < first.rotations.size(); ++i) {
    turns_.push_back(last.rotations[i].at({1, 0}) * spline::conjugate(first.rotations[i].at({0, -1})));
  }
  for (std::size_t i = 0; i < first.cubics.size(); ++i) cycle_.push_back(last.cubics[i].p1 - first.cubics[i].p0);
}

CurveSegment CurveIndex::segment(std::uint64_t number) const {
  const auto after = std::ranges::upper_bound(first_numbers_, number);
  const auto index = static_cast<std::size_t>(after - first_numbers_.begin() - 1);
  const spline::Segments<double>& segments = blocks_[index].segments;
  const std::size_t i = number - first_numbers_[index];
  const bool last = number + 1 == size();
  const bool closes = last && blocks_.back().closes;
  return {segments.times[i],
          segments.times[i + 1],
          s_[number],
          s_[number + 1],
          segments[i],
          channels_.metric,
          last,
          segments.warp(i),
          cycle_,
          number,
          s_error_[number + 1],
          closes ? 0 : number + 1,
          decimals_,
          segments.rotations_of(i),
          channels_.rotations,
          channels_.angles,
          turns_};
}

std::uint64_t CurveIndex::find_time(const Time& t, bool left) const {
  return segment_at_time(
      size(), [this](std::uint64_t number) { return segment(number).end; }, t, left);
}

std::uint64_t CurveIndex::find_length(const Time& s, bool left) const {
  const auto before = [&](const DoubleDouble& end) { return Time(end.hi) < s; };
  const auto found = std::partition_point(s_.begin() + 1, s_.end(), before);
  const auto number = std::min(static_cast<std::uint64_t>(found - s_.begin()), size()) - 1;
  const bool at_end = number + 1 < size() && Time(s_[number + 1].hi) == s && s_[number].hi != s_[number + 1].hi;
  return number + (at_end && !left ? 1 : 0);
}

Source<SampleBlock> look_up(const std::shared_ptr<const CurveIndex>& curve,
                            const std::shared_ptr<const AnywhereInTime>& rows, bool left) {
  const std::uint64_t size = rows->size();
  return blocks(curve, size,
                [curve, rows, left](std::uint64_t row) { return curve->find_time(rows->on_curve(row), left); });
}

Source<SampleBlock> look_up(const std::shared_ptr<const CurveIndex>& curve,
                            const std::shared_ptr<const AnywhereInLength>& rows, bool left) {
  const std::uint64_t size = rows->size();
  return blocks(curve, size,
                [curve, rows, left](std::uint64_t row) { return curve->find_length(rows->on_curve(row), left); });
}

}  // namespace tcb
