// Anywhere: rows in any order on a kept curve, at times that may be outside it, or at arc lengths.
#include "sample/anywhere.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "option_names.hpp"

namespace tcb {
namespace {

/// Rows in blocks; `find` gives the number of a row's segment. Neighbouring rows on one segment are located together.
Source<SampleBlock> blocks(std::shared_ptr<const ShownCurve> curve, std::uint64_t rows, spline::Side side,
                           std::function<std::uint64_t(std::uint64_t)> find) {
  return [curve = std::move(curve), rows, side, find = std::move(find),
          row = std::uint64_t{0}]() mutable -> std::optional<SampleBlock> {
    if (row == rows) return std::nullopt;
    SampleBlock block{curve, {}, row == 0};
    const std::uint64_t end = row + std::min(SampleBlock::most_rows, rows - row);
    for (; row < end; ++row) {
      const std::uint64_t number = find(row);
      if (block.parts.empty() || block.parts.back().segment.number != number) {
        block.parts.push_back({curve->segment(number), row, row});
        block.parts.back().segment.side = side;
      }
      block.parts.back().last = row + 1;
    }
    return block;
  };
}

}  // namespace

Time AnywhereInTime::on_curve(std::uint64_t row) const {
  const Time t = place_of(row);
  using enum Extrapolation;
  if (t < first_ && rules_.before == error) require_not_before(option::at, exact_time(t), first_key(first_));
  if (t > last_ && rules_.after == error) require_not_after(option::at, exact_time(t), last_key(last_));
  return outside(t).t;
}

/// Where times are frames, the time on the curve is a double, as all are.
Outside AnywhereInTime::outside(const Time& t) const {
  if (!frames_) return map_to_curve<double>(rules_, first_, last_, t);
  Outside outside =
      map_to_curve<double>(rules_, frames_->elapsed(first_), frames_->elapsed(last_), frames_->elapsed(t));
  outside.t = frames_->time(outside.t);
  return outside;
}

void AnywhereInTime::locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last,
                            Located& located) const {
  const spline::TimeMap<double> locate = segment.time_map();
  located.outside.clear();
  bool all_on_curve = true;
  fill(located, first, last, [&](std::uint64_t row) -> Sample {
    const Time t = place_of(row);
    all_on_curve = all_on_curve && t >= first_ && t <= last_;
    located.outside.push_back(outside(t));
    return {t, locate(segment.precise(located.outside.back().t))};
  });
  if (all_on_curve) located.outside.clear();
}

Time AnywhereInLength::on_curve(std::uint64_t row) const {
  const Time s = place_of(row);
  if (s < Time(0.0)) require_not_before(option::arc_at, exact_time(s), curve_start());
  if (s > Time(length_)) require_not_after(option::arc_at, exact_time(s), curve_length(length_));
  return s;
}

void AnywhereInLength::locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last,
                              Located& located) const {
  located.coordinates.clear();
  for (std::uint64_t row = first; row != last; ++row) located.coordinates.push_back(place_of(row));
  locate_lengths(segment, located);
}

Source<SampleBlock> look_up(const std::shared_ptr<const ShownCurve>& curve,
                            const std::shared_ptr<const AnywhereInTime>& rows, spline::Side side) {
  return blocks(curve, rows->size(), side,
                [curve, rows, side](std::uint64_t row) { return curve->curve().find_time(rows->on_curve(row), side); });
}

Source<SampleBlock> look_up(const std::shared_ptr<const ShownCurve>& curve,
                            const std::shared_ptr<const AnywhereInLength>& rows, spline::Side side) {
  return blocks(curve, rows->size(), side, [curve, rows, side](std::uint64_t row) {
    return curve->curve().find_length(rows->on_curve(row), side);
  });
}

}  // namespace tcb
