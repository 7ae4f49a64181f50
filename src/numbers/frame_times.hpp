// Frame times: the exact times that the texts of times name, with the digits that doubles omit.
#pragma once

#include <optional>

#include "numbers/decimal_time.hpp"
#include "numbers/rational.hpp"

namespace tcb {

/// The exact times of keys and rows whose own times are doubles: those of frames at a rate, or decimals, as dates and
/// clock times have them. A double that is the nearest one to a frame is that frame, and one that is not, or where
/// there are no frames, its shortest decimal where times are decimals. Differences of times are taken before they are
/// rounded. Frames may have three decimals.
class FrameTimes {
 public:
  /// `start`: the time of frame 0.
  explicit FrameTimes(const Rational& rate, const Rational& start = 0);

  /// The times of frames that are decimals.
  static FrameTimes decimals();

  /// The exact time of a frame, or of a decimal; nothing where this time is neither.
  std::optional<Rational> exact(const Time& time) const;

  bool are_decimals() const { return are_decimals_; }

  /// These times, less `zero`.
  FrameTimes less(const Rational& zero) const;

  /// These times with a new origin, so that the digits of elapsed() do not depend on how far from 0 they are.
  FrameTimes from(const Time& origin) const;

  /// The exact time since the origin as a double-double; without an origin since 0, or if that is no frame.
  Time elapsed(const Time& time) const;

  /// The double with this time since the origin; of decimals the double-double.
  Time time(const Time& elapsed) const;

  /// The time of a key, which elapsed() was given.
  Time key_time(const Time& elapsed) const;

 private:
  FrameTimes() = default;

  void set_start(const Rational& start);
  std::optional<double> number(const Time& time) const;
  Time since_start(double number) const;

  // A second has ticks_ / seconds_ of the smallest parts of frames.
  double ticks_ = 0, seconds_ = 0;  ///< whole numbers; 0: too large, or there are no frames
  Rational start_ = 0;              ///< of frame 0
  Time near_start_;
  double origin_ = 0;  ///< the number of the part of a frame
  bool are_decimals_ = false;
  Time decimal_origin_;
  LongDecimal named_origin_;  ///< the same
};

}  // namespace tcb
