// Pace: at which arc length of a curve a row is at its time, and how fast it moves there.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

/// The time of a row, and the first two derivatives of its arc length by that time.
template <class S>
struct MotionOf {
  spline::Time<S> time{};
  S speed{0}, acceleration{0};
};
using Motion = MotionOf<double>;

/// The rows of a profile, whose distances from the first key are arc lengths, or parts of the length of the curve.
struct PaceProfile {
  struct Row {
    Motion motion;
    double distance = 0;
  };
  std::vector<Row> rows = {};
  bool are_parts = false;
  TimeNotation notation = TimeNotation::seconds;  ///< of its times
  std::optional<TimeUnit> unit = {};              ///< of these, if it is known
  double largest = 0;                             ///< distance of a key
  TextPosition largest_place = {};                ///< of that key
};

/// A part of the length, and its derivatives by time.
template <class S>
struct PacePart {
  S distance{0}, speed{0}, acceleration{0};
};

/// The part of the length after a part of the duration, and the derivatives by that, where the speed rises from 0 in
/// the part `rise` of the duration, and falls to 0 in the part `fall`. The speed in a ramp is V (3 w^2 - 2 w^3), where
/// w is the part of the ramp, and V between the ramps. Requires: 0 <= time <= 1.
template <class S>
PacePart<S> part_of_length(const S& time, const S& rise, const S& fall) {
  const S top = S(1) / (S(1) - (rise + fall) / S(2)), left = S(1) - time;
  const bool rises = time < rise;
  if (!rises && !(left < fall)) return {top * (time - rise / S(2)), top, S(0)};
  const S duration = rises ? rise : fall, w = (rises ? time : left) / duration, w2 = w * w, w3 = w2 * w;
  const S way = top * duration * (w3 - w3 * w / S(2)), change = top / duration * S(6) * (w - w2);
  const S speed = top * (S(3) * w2 - S(2) * w3);
  return {rises ? way : S(1) - way, speed, rises ? change : -change};
}

/// How fast rows move along the curve: at a constant speed but for two ramps, or by a profile.
struct Pace {
  Rational rise = 0, fall = 0;  ///< the parts of the duration in which the speed rises from 0, and falls to 0
  std::shared_ptr<const PaceProfile> profile = nullptr;  ///< instead

  bool is_constant() const { return rise == 0 && fall == 0; }
  /// The largest speed, if length and duration are 1.
  Rational top_speed() const { return 1 / (1 - (rise + fall) / 2); }

  /// The part of the length at a time from the first key to the last one, as exactly as the scalar holds it. Requires:
  /// no profile.
  template <class S>
  PacePart<S> at(const Rational& time, const Rational& first, const Rational& last) const;
};

}  // namespace tcb
