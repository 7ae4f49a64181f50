// Segments with their place on the curve, and samples on them, at any scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "numbers/decimal_time.hpp"
#include "sample/extrapolation.hpp"
#include "schema/curve_channels.hpp"
#include "tcb/spline/ease.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

/// A segment of a curve. Lengths are 0 if the curve is not measured. The spans belong to the curve.
template <class S>
struct CurveSegmentOf {
  spline::Time<S> start, end;                ///< times of its two keys
  spline::working_t<S> s_start, s_end;       ///< arc lengths of its two keys, from the curve's first
  std::span<const spline::Cubic<S>> cubics;  ///< one per channel
  std::span<const std::size_t> metric;       ///< the channels of lengths and speeds; empty: all
  bool last = false;                         ///< the curve ends here
  spline::Warp<S> warp = {};                 ///< of its local parameter
  std::span<const S> cycle = {};             ///< last key - first key, one per channel; empty if it is not needed
  std::uint64_t number = 0;                  ///< of the segment, from 0
  double s_error = 0;                        ///< bound on the error of s_end
  std::uint64_t end_key = number + 1;        ///< of the key at its end, 0 if a closed curve has returned
  int decimals = 0;                          ///< of the times on it, if they have more digits than doubles; else 0
  std::span<const spline::RotationSegment<S>> rotations = {};
  std::span<const RotationColumns> rotation_columns = {};  ///< those of each
  std::span<const AngleColumn> angles = {};
  std::span<const spline::Quaternion<S>> turns = {};  ///< last key times the inverse of the first, where cycle is given

  const FrameTimes* frames = nullptr;       ///< where times are frames in seconds
  spline::Side side = spline::Side::right;  ///< of a place between two parts of the ease, that on which a row there is

  /// A time with the digits that a double omits; where times are frames, from an origin of their own.
  spline::Time<S> precise(const spline::Time<S>& t) const {
    if constexpr (std::is_same_v<S, double>) {
      if (frames != nullptr) return frames->elapsed(t);
    }
    return t;
  }
  spline::Time<S> duration() const { return precise(end) - precise(start); }
  /// From precise times to places on the segment.
  spline::TimeMap<S> time_map() const { return {precise(start), precise(end), warp}; }

  /// Null where the channel is no angle.
  const AngleColumn* angle(std::size_t channel) const {
    const auto found = std::ranges::find(angles, channel, &spline::AngleChannel::channel);
    return found == angles.end() ? nullptr : &*found;
  }
};
using CurveSegment = CurveSegmentOf<double>;

/// How many channels count in distances, and the cubic of each.
inline std::size_t metric_size(const CurveSegment& segment) {
  return segment.metric.empty() ? segment.cubics.size() : segment.metric.size();
}
inline const spline::Cubic<double>& metric_cubic(const CurveSegment& segment, std::size_t i) {
  return segment.cubics[segment.metric.empty() ? i : segment.metric[i]];
}

/// The exact time at a local parameter.
inline Time time_on(const CurveSegment& segment, double u) {
  const Time part = segment.warp.inverse({u, u - 1});
  const bool has_decimals = segment.frames != nullptr && segment.frames->are_decimals();
  if (has_decimals) return segment.frames->time(segment.precise(segment.start) + part * segment.duration());
  return segment.start + part * (segment.end - segment.start);
}

/// A sample: its time, its local parameter, and its arc length in the arc modes.
template <class S>
struct SampleOf {
  spline::Time<S> t;
  spline::LocalParameter<S> at;
  std::optional<S> s = std::nullopt;
  std::optional<spline::EasePart> part = std::nullopt;  ///< of the ease, where the scalar may not decide it
};
using Sample = SampleOf<double>;

/// The sample at one end of a segment.
template <class S>
SampleOf<S> sample_at_key(const CurveSegmentOf<S>& segment, bool end) {
  if (end) return {segment.end, {S(1), S(0)}};
  return {segment.start, {S(0), S(-1)}};
}

/// A time that was computed from a place on a segment, rounded once: to a double, beyond 2^53 to a whole number, or to
/// the segment's decimals.
inline Time rounded_time(const Time& t, int decimals) {
  if (decimals > 0) return rounded_to(Rational(t.hi) + Rational(t.lo), decimals);
  constexpr double whole_from = 9007199254740992.0;  // 2^53
  if (std::abs(t.hi) < whole_from) return {t.hi};
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  return spline::DoubleDouble::normalized(t.hi, (t.lo + round_to_whole) - round_to_whole);
}

/// The time at a place on a segment that is `duration` long. Doubles are rounded once; other scalars have more digits.
template <class S>
spline::Time<S> time_at(const CurveSegmentOf<S>& segment, const spline::Time<S>& duration,
                        const spline::LocalParameter<S>& at) {
  const auto rounded = [&](const spline::Time<S>& t) {
    if constexpr (std::is_same_v<S, double>) {
      return rounded_time(segment.frames != nullptr ? segment.frames->time(t) : t, segment.decimals);
    } else {
      return t;
    }
  };
  const spline::Time<S> start = segment.precise(segment.start), end = segment.precise(segment.end);
  if (!segment.warp.is_identity()) return rounded(start + segment.warp.inverse(at) * duration);
  return rounded(at.near_start() ? start + duration * at.u : end + duration * at.w);
}

}  // namespace tcb
