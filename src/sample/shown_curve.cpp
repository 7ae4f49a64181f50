// Shown curve: a kept curve, and how rows show its channels.
#include "sample/shown_curve.hpp"

#include <algorithm>
#include <utility>

#include "numbers/decimal_time.hpp"
#include "sample/build.hpp"

namespace tcb {

spline::Curve<double> kept_curve(const Source<SegmentBlock>& segments, const spline::CurveRules<double>& rules,
                                 bool closed, std::size_t count) {
  spline::Curve<double> curve(rules, closed, count);
  while (std::optional<SegmentBlock> block = segments()) curve.append(std::move(block->segments), block->lengths);
  return curve;
}

ShownCurve::ShownCurve(spline::Curve<double> curve, CurveChannels channels)
    : curve_(std::move(curve)), channels_(std::move(channels)) {
  for (const Time& time : curve_.times()) decimals_ = std::max(decimals_, decimals_of(time));
  const spline::Segment<double> first = curve_.segment(0), last = curve_.segment(curve_.segment_count() - 1);
  for (std::size_t i = 0; i < first.rotations.size(); ++i) {
    turns_.push_back(last.rotations[i].at({1, 0}) * spline::conjugate(first.rotations[i].at({0, -1})));
  }
  for (std::size_t i = 0; i < first.cubics.size(); ++i) cycle_.push_back(last.cubics[i].p1 - first.cubics[i].p0);
}

CurveSegment ShownCurve::segment(std::uint64_t number) const {
  const spline::Segment<double> segment = curve_.segment(number);
  const bool last = number + 1 == size();
  return {segment.start,
          segment.end,
          segment.length_start,
          segment.length_end,
          segment.cubics,
          channels_.metric,
          last,
          segment.warp,
          cycle_,
          number,
          segment.length_error,
          last && curve_.is_closed() ? 0 : number + 1,
          decimals_,
          segment.rotations,
          channels_.rotations,
          channels_.angles,
          turns_,
          channels_.frames ? &*channels_.frames : nullptr};
}

}  // namespace tcb
