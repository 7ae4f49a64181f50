// Frame times: times of frames in seconds with the digits that doubles omit.
#pragma once

#include <optional>

#include "numbers/rational.hpp"

namespace tcb {

/// The times of frames at a rate. Keys and rows have doubles as their times; one that is the double nearest to a frame
/// is that frame, so that differences of times are taken before they are rounded. Frames may have three decimals.
class FrameTimes {
 public:
  explicit FrameTimes(const Rational& rate);

  /// The exact time of the frame to which this double is nearest; nothing where it is none.
  std::optional<Rational> exact(const Time& time) const;

  /// The same frames with a new origin, so that the digits of elapsed() do not depend on how far from 0 the frames are.
  FrameTimes from(const Time& origin) const;

  /// The exact time since the origin as a double-double; without an origin since 0, or if that is no frame.
  Time elapsed(const Time& time) const;

  /// The double with this time since the origin.
  Time time(const Time& elapsed) const;

 private:
  std::optional<double> number(const Time& time) const;
  Time time_of(double number) const;

  // A second has ticks_ / seconds_ of the smallest parts of frames.
  double ticks_ = 0, seconds_ = 0;  ///< whole numbers; 0: too large
  double origin_ = 0;               ///< the number of the part of a frame
};

}  // namespace tcb
