// The exact grid: row j stands at start + j step, rounded once. It serves times and arc lengths alike.
//
// Counts follow from the same rule: a row is at or before T if its rounded place is.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "text/rational.hpp"

namespace tcb {

class Grid {
 public:
  /// Requires: step >= 0; a step of 0 makes sense for a single row only.
  Grid(const Rational& start, const Rational& step);

  /// start + j step, rounded once.
  Time time(std::uint64_t j) const;

  /// Puts the times of the rows from first to before last in the place of others.
  void set_times(std::uint64_t first, std::uint64_t last, std::vector<Time>& times) const;

  /// How many rows stand before t, and how many at or before it. Requires: step > 0.
  std::uint64_t rows_before(const Time& t) const;
  std::uint64_t rows_through(const Time& t) const;

  /// Row 0 and row 1 differ, and so do neighbouring rows at t.
  bool resolves(const Time& t) const;

  /// About how many rows stand up to t, to a few units in the last place.
  double rough_rows(const Time& t) const { return ((t - near_start_) / near_step_).hi + 1; }

  const Rational& start() const { return start_; }
  const Rational& step() const { return step_; }
  const Time& first() const { return first_time_; }  ///< row 0
  bool is_single() const { return is_single_; }      ///< the step is 0

 private:
  /// The time of a row in twice the precision, or those of two rows.
  template <class D>
  spline::DoubleDoubleOf<D> near_time(const D& row) const;

  /// How far that may be off.
  template <class D>
  D doubt(const D& near) const;

  /// How many rows stand before t, where none is so near to it that rounding could decide.
  std::optional<std::uint64_t> rows_if_clear(const Time& t) const;

  /// A row number that is right or a little off, for the exact search to start from.
  std::uint64_t estimate(const Time& t) const;

  Rational start_, step_;
  Time first_time_;
  bool is_single_;
  std::uint64_t double_rows_ = 0;  ///< up to this row, (first + j increment) / denominator is of exact doubles
  double double_first_{}, double_increment_{}, double_denominator_{};
  Time near_start_, near_step_;  ///< in twice the precision
};

}  // namespace tcb
