// Places: rows in any order on a kept curve, at times that may be outside it, or at arc lengths.
#include "sample/places.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "numbers/decimal_time.hpp"
#include "sample/grid.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb {
namespace {

/// Adds the times of keys in [from, to], and drops a time that is closer to a key than a billionth of the first step.
/// T: Time or Rational.
template <class T>
std::vector<T> with_keys(const std::vector<T>& times, std::span<const T> keys, const T& from, const T& to,
                         const T& billionth) {
  const T near = times.size() > 1 ? (times[1] - times[0]) * billionth : T(0.0);
  std::vector<T> merged;
  std::size_t next = 0;
  for (const T& key : keys) {
    if (key < from - near || key > to + near) continue;
    for (; next < times.size() && times[next] < key - near; ++next) merged.push_back(times[next]);
    while (next < times.size() && times[next] <= key + near) ++next;
    merged.push_back(key);
  }
  merged.insert(merged.end(), times.begin() + static_cast<std::ptrdiff_t>(next), times.end());
  return merged;
}

/// The times of a grid that may leave the curve.
std::vector<Time> grid_times(const SamplingRequest& request, const Extent& extent) {
  const Spacing on = spacing(request, extent);
  if (on.rows == 0) return {};
  const bool single = on.grid.step() == 0;
  const int digits = extent.decimals;
  const Time end = nearest_time(*on.end, digits);
  if (!single) require_resolution(on.grid, end, digits);
  const std::uint64_t rows = single ? on.rows : std::min(on.rows, on.grid.rows_through(end, digits));
  std::vector<Time> times;
  for (std::uint64_t row = 0; row < rows; ++row) times.push_back(on.grid.time(row, digits));
  if (request.end == EndPolicy::keep && (times.empty() || times.back() < end)) times.push_back(end);
  return times;
}

std::vector<Rational> exact_grid_times(const SamplingRequest& request, const Extent& extent) {
  const Spacing on = spacing(request, extent);
  if (on.rows == 0) return {};
  const Rational &from = on.grid.start(), &step = on.grid.step(), &to = *on.end;
  const bool is_counted = on.rows != Spacing::unlimited;
  const std::uint64_t rows = is_counted ? on.rows : whole_number(floor((to - from) / step)) + 1;
  std::vector<Rational> times;
  for (std::uint64_t row = 0; row < rows; ++row) times.push_back(from + step * row);
  if (request.end == EndPolicy::keep && times.back() < to) times.push_back(to);
  return times;
}

/// Those of rows at equal parts of each segment.
std::vector<Rational> times_per_segment(const SamplingRequest& request, std::span<const Time> keys) {
  require_rows(Rational(keys.size() - 1) * request.count, request.max_rows);
  std::vector<Rational> times;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const Rational start = request.exact(keys[i]), step = (request.exact(keys[i + 1]) - start) / request.count;
    for (std::uint64_t row = 0; row < request.count; ++row) times.push_back(start + step * row);
  }
  times.push_back(request.exact(keys.back()));
  return times;
}

/// The exact times of rows; nothing where only the rows decide them, or where they are lengths.
std::vector<Rational> exact_times(const SamplingRequest& request, const KeptCurve& curve) {
  const bool merges_computed_keys = request.keys && !request.key_times;
  if (request.mode == Mode::per_segment) return times_per_segment(request, curve.curve().times());
  if (by_length(request.mode) || request.mode == Mode::tolerance || merges_computed_keys) return {};
  const Extent& extent = curve.extent();
  const Rational first = request.exact(extent.first), last = request.exact(*extent.last);
  if (request.mode == Mode::at) {
    for (std::size_t i = 0; request.key_times && i < request.places.size(); ++i) {
      require_extended_to("--at", request.places[i] + request.zero, curve.extrapolations(), first + request.zero,
                          last + request.zero);
    }
    return request.places;
  }
  std::vector<Rational> times = exact_grid_times(request, extent);
  if (!request.keys || times.empty()) return times;
  std::vector<Rational> keys;
  for (const auto& [rounded, exact] : *request.key_times) keys.push_back(exact);
  return with_keys<Rational>(times, keys, request.from.value_or(first), request.to.value_or(last),
                             Rational(1, 1'000'000'000));
}

/// The rows of a request without a pace.
RowPlaces places_by_time(const SamplingRequest& request, const KeptCurve& curve, bool exact) {
  const Extent& extent = curve.extent();
  RowPlaces result{.zero = request.zero};
  if (exact) result.exact = exact_times(request, curve);
  const auto set_rounded = [&](const std::vector<Rational>& places, int digits) {
    std::ranges::transform(places, std::back_inserter(result.places),
                           [digits](const Rational& place) { return nearest_time(place, digits); });
  };
  if (!result.exact.empty()) {
    set_rounded(result.exact, extent.decimals);
    return result;
  }
  if (request.mode == Mode::tolerance) {
    ToleranceRows rows = rows_within_tolerance(curve, request.tolerance, request.max_rows, request.keys);
    result.places = std::move(rows.times);
    if (request.tolerance.limits_distance()) result.least_rows = rows.least;
  } else if (request.mode == Mode::per_segment) {
    set_rounded(times_per_segment(request, curve.curve().times()), extent.decimals);
  } else if (request.places.empty()) {
    result.places = grid_times(request, extent);
  } else {
    set_rounded(request.places, request.mode == Mode::at ? extent.decimals : only_doubles);
  }
  if (!request.keys) return result;
  const auto bound = [&](const std::optional<Rational>& given, const Time& end) {
    return given ? nearest_time(*given, extent.decimals) : end;
  };
  result.places = with_keys(result.places, curve.curve().times(), bound(request.from, extent.first),
                            bound(request.to, *extent.last), Time(1e-9));
  return result;
}

/// Throws: Error (usage) for a request that leaves the curve.
void require_on_curve(const SamplingRequest& request, const Rational& first, const Rational& last) {
  const auto require = [&](std::string_view option, const Rational& time) {
    require_not_before(option, time + request.zero, RangeEnds::of_pieces, first + request.zero);
    require_not_after(option, time + request.zero, RangeEnds::of_pieces, last + request.zero);
  };
  for (const Rational& place : request.places) require("--at", place);
  if (request.from && !request.origin) require("--from", *request.from);
  if (request.to && !request.origin) require("--to", *request.to);
}

/// Moves rows from their times to the arc lengths that the pace has there.
void set_pace(RowPlaces& rows, const SamplingRequest& request, const KeptCurve& curve) {
  const auto exactly = [&](const Time& time) {  // as golden rows have it
    return rows.exact.empty() && !request.frames ? exact_number(time, false) : request.exact(time);
  };
  const Rational first = exactly(curve.extent().first), last = exactly(*curve.extent().last);
  const double length = curve.length();
  for (std::size_t row = 0; row < rows.places.size(); ++row) {
    Time& place = rows.places[row];
    const Rational time = rows.exact.empty() ? exactly(place) : rows.exact[row];
    const PacePart<Time> part = request.pace->at<Time>(time, first, last);
    rows.motions.push_back({place, part.speed.hi * length, part.acceleration.hi * length});
    place = part.distance * Time(length);
  }
  const Rational end = request.to.value_or(last);
  if (request.mode != Mode::step || rows.motions.empty()) return;
  const Time& last_row = rows.motions.back().time;
  if (last_row < nearest_time(end, curve.extent().decimals)) rows.remainder = end - request.exact(last_row);
}

/// Rows at the distances of a profile. Throws: Error (data) for one beyond the curve.
RowPlaces profiled_places(const PaceProfile& profile, const KeptCurve& curve) {
  const double length = curve.length(), scale = profile.are_parts ? length : 1;
  if (!profile.are_parts && profile.largest > length) {
    throw data_error(
        "the arc length {} is beyond the length of the curve, {}; expected lengths up to it; correct the profile, or "
        "give parts of the length, from 0 to 1, in a column called fraction",
        profile.largest, length)
        .at(profile.largest_place);
  }
  RowPlaces result;
  for (const auto& [motion, distance] : profile.rows) {
    result.places.emplace_back(std::clamp(distance * scale, 0.0, length));
    result.motions.push_back({motion.time, motion.speed * scale, motion.acceleration * scale});
  }
  return result;
}

/// Rows at the places of a list: arc lengths, or times, which may be outside the curve.
class AtPlaces : public Locator {
 public:
  AtPlaces(RowPlaces places, bool by_length, const std::shared_ptr<const KeptCurve>& curve)
      : places_(std::move(places.places)),
        exact_(std::move(places.exact)),
        motions_(std::move(places.motions)),
        by_length_(by_length),
        curve_(curve),
        first_(curve->extent().first),
        last_(*curve->extent().last),
        zero_(std::move(places.zero)) {}

  std::uint64_t size() const { return places_.size(); }

  /// The number of the segment of a row. Throws: Error (usage) outside the curve where nothing extends it.
  std::uint64_t segment_of(std::uint64_t row, spline::Side side) const {
    const Time& place = places_[row];
    if (by_length_) {
      const Time length(curve_->length());
      if (place < Time(0.0)) require_not_before("--arc-at", exact_time(place), RangeEnds::of_length, 0);
      if (place > length) require_not_after("--arc-at", exact_time(place), RangeEnds::of_length, exact_time(length));
      return curve_->curve().find_length(place, side);
    }
    if (place < first_ || place > last_) {
      const auto given = [this](const Time& time) { return exact_time(time) + zero_; };
      require_extended_to("--at", given(place), curve_->extrapolations(), given(first_), given(last_));
    }
    return curve_->curve().find_time(outside(place).t, side);
  }

  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override {
    if (by_length_) {
      located.coordinates.assign(places_.begin() + static_cast<std::ptrdiff_t>(first),
                                 places_.begin() + static_cast<std::ptrdiff_t>(last));
      locate_lengths(segment, located);
      if (!motions_.empty()) set_motions(first, last, located);
      return;
    }
    const spline::TimeMap<double> locate = segment.time_map();
    located.outside.clear();
    bool all_on_curve = true;
    fill(located, first, last, [&](std::uint64_t row) -> Sample {
      const Time& t = places_[row];
      all_on_curve = all_on_curve && t >= first_ && t <= last_;
      located.outside.push_back(outside(t));
      return {t, locate(segment.precise(located.outside.back().t))};
    });
    if (all_on_curve) located.outside.clear();
  }

  ExactTimes exact_times(std::uint64_t row, const ExactKeyTimes*) const override {
    return exact_.empty() ? ExactTimes{} : ExactTimes{exact_[row]};
  }

 private:
  void set_motions(std::uint64_t first, std::uint64_t last, Located& located) const {
    located.motions.assign(motions_.begin() + static_cast<std::ptrdiff_t>(first),
                           motions_.begin() + static_cast<std::ptrdiff_t>(last));
    for (std::size_t i = 0; i < located.samples.size(); ++i) located.samples[i].t = located.motions[i].time;
  }

  /// Where times are frames, the time on the curve is a double, as all are.
  Outside outside(const Time& t) const {
    const Extrapolations& rules = curve_->extrapolations();
    const std::optional<FrameTimes>& frames = curve_->frames();
    if (!frames) return map_to_curve<double>(rules, first_, last_, t);
    Outside outside = map_to_curve<double>(rules, frames->elapsed(first_), frames->elapsed(last_), frames->elapsed(t));
    outside.t = frames->time(outside.t);
    return outside;
  }

  std::vector<Time> places_;
  std::vector<Rational> exact_;
  std::vector<Motion> motions_;
  bool by_length_;
  std::shared_ptr<const KeptCurve> curve_;
  Time first_, last_;
  Rational zero_;
};

}  // namespace

void require_extended_to(std::string_view option, const Rational& time, const Extrapolations& rules,
                         const Rational& first, const Rational& last) {
  if (rules.before == Extrapolation::error) require_not_before(option, time, RangeEnds::of_keys, first);
  if (rules.after == Extrapolation::error) require_not_after(option, time, RangeEnds::of_keys, last);
}

RowPlaces row_places(const SamplingRequest& request, const KeptCurve& curve, bool exact) {
  if (!request.places.empty()) require_rows(Rational(request.places.size() - 1), request.max_rows);
  if (!request.pace) return places_by_time(request, curve, exact);
  if (request.pace->profile != nullptr) return profiled_places(*request.pace->profile, curve);
  require_on_curve(request, request.exact(curve.extent().first), request.exact(*curve.extent().last));
  RowPlaces rows = places_by_time(request, curve, exact);
  set_pace(rows, request, curve);
  return rows;
}

/// Neighbouring rows on one segment are located together.
FoundRows find_rows(const std::shared_ptr<const KeptCurve>& curve, RowPlaces places, bool by_length,
                    spline::Side side) {
  const auto rows = std::make_shared<const AtPlaces>(std::move(places), by_length, curve);
  const auto next_block = [curve, rows, side, row = std::uint64_t{0}]() mutable -> std::optional<SampleBlock> {
    if (row == rows->size()) return std::nullopt;
    SampleBlock block{curve, {}, row == 0};
    const std::uint64_t end = row + std::min(SampleBlock::most_rows, rows->size() - row);
    for (; row < end; ++row) {
      const std::uint64_t number = rows->segment_of(row, side);
      if (block.parts.empty() || block.parts.back().segment.number != number) {
        block.parts.push_back({curve->segment(number), row, row});
        block.parts.back().segment.side = side;
      }
      block.parts.back().last = row + 1;
    }
    return block;
  };
  return {next_block, rows};
}

}  // namespace tcb
