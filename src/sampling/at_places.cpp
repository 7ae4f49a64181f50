// Samples at times or arc lengths in any order, times also outside the curve.
#include "sampling/sampler.hpp"

namespace tcb {

Time AnywhereInTime::on_curve(std::uint64_t row) const {
  const Time t = place(row);
  if (kind_ == Extrapolation::error) {
    if (t < first_) require_not_before(Option::at, exact_time(t), first_key(first_));
    if (t > last_) require_not_after(Option::at, exact_time(t), last_key(last_));
  }
  return map_to_curve<double>(kind_, first_, last_, t).t;
}

void AnywhereInTime::locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last,
                            Located& located) const {
  const spline::TimeMap<double> locate(segment.start, segment.end, segment.warp);
  located.outside.clear();
  fill(located, first, last, [&](std::uint64_t row) -> Sample {
    const Time t = place(row);
    located.outside.push_back(map_to_curve<double>(kind_, first_, last_, t));
    return {t, locate(located.outside.back().t)};
  });
}

Time AnywhereInLength::on_curve(std::uint64_t row) const {
  const Time s = place(row);
  if (s < Time(0.0)) require_not_before(Option::arc_at, exact_time(s), curve_start());
  if (s > Time(length_)) require_not_after(Option::arc_at, exact_time(s), curve_length(length_));
  return s;
}

void AnywhereInLength::locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last,
                              Located& located) const {
  located.coordinates.clear();
  for (std::uint64_t row = first; row != last; ++row) located.coordinates.push_back(place(row));
  locate_lengths(segment, located);
}

}  // namespace tcb
