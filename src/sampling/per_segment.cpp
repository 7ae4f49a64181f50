// Samples at equal intervals within every segment: the inbetweens of the paper.
#include "sampling/per_segment.hpp"

#include "sampling/bounds.hpp"

namespace tcb {

Run PerSegment::place(const CurveSegment& piece) {
  require_rows(Rational(piece.number + 1) * intervals_, max_rows_, !piece.last);
  const Rational start = exact_time(piece.start);
  const Grid grid(start, (exact_time(piece.end) - start) / intervals_);
  if (piece.start < piece.end) require_resolution(grid, piece.end);
  return {1, intervals_, true, piece.last};
}

void PerSegment::locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  const spline::TimeMap<double> locate(piece.start, piece.end, piece.warp);
  const Rational start = exact_time(piece.start);
  const Rational step = (exact_time(piece.end) - start) / intervals_;
  fill(located, first, last, [&](std::uint64_t row) -> Sample {
    if (row == Row::at_key) return {piece.start, {0, -1}};
    if (row == Row::at_end) return {piece.end, {1, 0}};
    const Time t = nearest_time(start + step * row);
    return {t, locate(t)};
  });
}

}  // namespace tcb
