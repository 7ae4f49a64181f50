// Kept curve: a curve with random access to its segments, and how rows show its channels.
#include "sample/kept_curve.hpp"

#include <algorithm>
#include <utility>

#include "numbers/decimal_time.hpp"
#include "sample/build.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb {

KeptCurve::KeptCurve(spline::Curve<double> curve, CurveChannels channels, const Extent& extent,
                     const Extrapolations& extrapolations)
    : curve_(std::make_shared<const spline::Curve<double>>(std::move(curve))),
      channels_(std::move(channels)),
      extent_(extent),
      extrapolations_(extrapolations) {
  for (const Time& time : curve_->times()) decimals_ = std::max(decimals_, decimals_of(time));
  const spline::Segment<double> first = curve_->segment(0), last = curve_->segment(curve_->segment_count() - 1);
  for (std::size_t i = 0; i < first.rotations.size(); ++i) {
    turns_.push_back(last.rotations[i].at({1, 0}) * spline::conjugate(first.rotations[i].at({0, -1})));
  }
  for (std::size_t i = 0; i < first.cubics.size(); ++i) cycle_.push_back(last.cubics[i].p1 - first.cubics[i].p0);
}

KeptCurve StreamedCurve::kept(const CurveChannels& channels, const Extrapolations& extrapolation, bool measured) const {
  const std::size_t count = extent.closed ? keys.size() : std::max<std::size_t>(keys.size() - 1, 1);
  spline::Curve<double> curve(rules, extent.closed, count);
  const Source<SegmentBlock> all = segments(measured);
  while (std::optional<SegmentBlock> block = all()) curve.append(std::move(block->segments), block->lengths);
  return {std::move(curve), channels, extent, extrapolation};
}

double KeptCurve::length() const { return curve_->length().value; }

std::uint64_t KeptCurve::size() const { return curve_->segment_count(); }

CurveSegment KeptCurve::segment(std::uint64_t number) const {
  const spline::Segment<double> segment = curve_->segment(number);
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
          last && curve_->is_closed() ? 0 : number + 1,
          decimals_,
          segment.rotations,
          channels_.rotations,
          channels_.angles,
          turns_,
          channels_.frames ? &*channels_.frames : nullptr};
}

}  // namespace tcb
