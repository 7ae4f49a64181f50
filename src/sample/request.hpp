// Requests for samples, as exact numbers; modes and end policies.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "numbers/frame_times.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "sample/pace.hpp"
#include "tcb/spline/key.hpp"
#include "text/suggest.hpp"

namespace tcb {

enum class Mode {
  step,
  count,
  intervals,  ///< of equal time, also of closed curves: pictures without a sampling option
  per_segment,
  at,
  arc_step,
  arc_count,
  arc_at,
  tolerance,
  emit,
};

/// Where the last rows are if the steps do not meet the end.
enum class EndPolicy { drop, keep, fit, fit_down, fit_up };

/// Every end policy by name; the first is the default.
inline constexpr auto end_policies = std::to_array<Named<EndPolicy>>({{"drop", EndPolicy::drop},
                                                                      {"keep", EndPolicy::keep},
                                                                      {"fit", EndPolicy::fit},
                                                                      {"fit-down", EndPolicy::fit_down},
                                                                      {"fit-up", EndPolicy::fit_up}});

/// How far the curve may be from its rows: from the polyline through them, and rotations from the arcs between them.
struct CurveTolerance {
  double distance = std::numeric_limits<double>::infinity();
  double angle = std::numeric_limits<double>::infinity();  ///< in radians
  bool limits_distance() const { return distance < std::numeric_limits<double>::infinity(); }
  bool limits_angle() const { return angle < std::numeric_limits<double>::infinity(); }
};

/// Which numbers of a request are seconds; the others are in the unit of the times.
struct InSeconds {
  bool step = false, from = false, to = false, places = false;
  bool has_duration = false;  ///< one has a unit of its own, as in 30min, and is not that of a rate
  bool any() const { return step || from || to || places; }
};

struct SamplingRequest {
  Mode mode = Mode::step;
  Rational step;                     ///< time or arc length between rows: step, arc_step
  bool is_rate = false;              ///< the step is that of a rate: step
  InSeconds in_seconds;              ///< the numbers that are seconds, where the unit of the times is known
  std::string rate_as_decimal;       ///< such as "29.97", where the rate is 30000/1001; else empty
  std::uint64_t count = 0;           ///< rows, or intervals between them: intervals, per_segment
  std::vector<Rational> places;      ///< times or arc lengths: at, arc_at
  std::string range_like_clock;      ///< a range of places that might be a time of day, such as "10:20:30"; else empty
  CurveTolerance tolerance;          ///< tolerance
  std::optional<Rational> from, to;  ///< where to begin and end, in time, or in arc length for the arc modes
  EndPolicy end = EndPolicy::drop;   ///< step, arc_step
  bool keys = false;                 ///< every key is a row too
  bool from_left = true;             ///< a row at a key is on the segment before it, not on the one after
  std::uint64_t max_rows = 1'000'000'000;
  std::optional<Pace> pace = {};          ///< of rows at times, which are then placed by arc length
  std::optional<FrameTimes> frames = {};  ///< where the times of the keys are frames in seconds

  Rational zero = 0;  ///< which was subtracted from times, for messages

  /// Of a part of a curve that gaps divide: rows at steps are on the grid of this time, the first one of the curve, and
  /// a range that leaves the part is no error.
  std::optional<Rational> origin = {};
  /// Of such a part: its first or last rows may be outside of its keys, where the curve is extended.
  bool reaches_before = false, reaches_after = false;

  /// The exact times of keys by their rounded times, where keys have more digits than these.
  std::shared_ptr<const std::map<Time, Rational>> key_times = {};

  /// The side of a key on whose segment a row there is.
  spline::Side side() const { return from_left ? spline::Side::left : spline::Side::right; }

  /// Converts the numbers that are seconds, if a second has so many units of the times.
  void convert_seconds(const Rational& units);

  /// The exact time of a key: that in key_times, a decimal, or a frame in seconds.
  Rational exact(const Time& time) const;
};

/// What is known of a curve before its samples are placed.
struct Extent {
  Time first;
  std::optional<Time> last;      ///< needed where needs_end(request)
  std::optional<double> length;  ///< needed where needs_end(request) and by_length(mode)
  bool closed = false;           ///< counted rows do not repeat the first
  int decimals = 0;              ///< of the times, if they have more digits than doubles; else 0
  std::size_t last_moving = 0;   ///< the last segment that is longer than 0, if that is known, and not the first
};

/// Samples are placed by arc length, so every segment has to be measured.
constexpr bool by_length(Mode mode) {
  return mode == Mode::arc_step || mode == Mode::arc_count || mode == Mode::arc_at;
}

/// So it is for rows at times that move along the curve at a pace.
inline bool by_length(const SamplingRequest& request) { return by_length(request.mode) || request.pace.has_value(); }

/// The rows of a segment do not depend on the other segments.
constexpr bool by_segment(Mode mode) { return mode == Mode::per_segment || mode == Mode::emit; }

/// Samples may be before the first key or after the last one.
inline bool may_leave_curve(const SamplingRequest& request) {
  if (request.pace) return false;
  const bool has_range = request.from.has_value() || request.to.has_value();
  const bool is_inside = by_length(request.mode) || by_segment(request.mode) || request.mode == Mode::tolerance;
  return request.mode == Mode::at || (has_range && !is_inside);
}

/// The curve's last key, or its length, must be known before the first row.
inline bool needs_end(const SamplingRequest& request) {
  const bool steps = request.mode == Mode::step || request.mode == Mode::arc_step;
  const bool fits = request.end != EndPolicy::drop && request.end != EndPolicy::keep;
  return !(steps || by_segment(request.mode)) || (steps && fits);
}

}  // namespace tcb
