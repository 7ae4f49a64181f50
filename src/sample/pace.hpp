// Pace: at which arc length of a curve a row is at its time, and how fast it moves there.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
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
  double largest = 0;               ///< distance of a key
  TextPosition largest_place = {};  ///< of that key
};

/// A part of the length, and its derivatives by time.
struct PacePart {
  Rational distance, speed, acceleration;
};

/// How fast rows move along the curve: at a constant speed but for two ramps, or by a profile.
struct Pace {
  Rational rise = 0, fall = 0;  ///< the parts of the duration in which the speed rises from 0, and falls to 0
  std::shared_ptr<const PaceProfile> profile = nullptr;  ///< instead

  /// The speed in a ramp is V (3 w^2 - 2 w^3), where w is the part of the ramp, and V between the ramps.
  /// Requires: a time from the first key to the last one, and no profile.
  PacePart at(const Rational& time, const Rational& first, const Rational& last) const;
  /// V, if length and duration are 1.
  Rational top_speed() const { return 1 / (1 - (rise + fall) / 2); }

 private:
  PacePart at(const Rational& time) const;
};

}  // namespace tcb
