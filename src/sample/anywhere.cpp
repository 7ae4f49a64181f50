// Anywhere: locators of rows in any order, at times that may be outside the curve, or at arc lengths.
#include "sample/anywhere.hpp"

#include "option_names.hpp"
#include "sample/errors.hpp"

namespace tcb {

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

}  // namespace tcb
