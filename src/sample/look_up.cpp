// Look up: rows in any order on a kept curve, also outside it.
#include "sample/look_up.hpp"

#include <algorithm>
#include <functional>
#include <utility>

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
