// Grids of rows: row j is at start + j step, rounded once, in time or in arc length; and from requests to grids.
//
// Counts follow from the same rule: a row is at or before T if its rounded place is.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
#include "sample/request.hpp"

namespace tcb {

class Grid {
 public:
  /// Requires: step >= 0; a step of 0 makes sense for a single row only.
  Grid(const Rational& start, const Rational& step);

  /// start + j step, rounded once. `decimals`: as for nearest_time().
  Time time(std::uint64_t j, int decimals = 0) const;

  /// Replaces `times` with those of the rows from first to before last.
  void set_times(std::uint64_t first, std::uint64_t last, int decimals, std::vector<Time>& times) const;

  /// The number of rows before t, and of those at or before it. Requires: step > 0.
  std::uint64_t rows_before(const Time& t, int decimals = 0) const;
  std::uint64_t rows_through(const Time& t, int decimals = 0) const;

  /// Row 0 and row 1 differ, and so do neighbouring rows at t.
  bool resolves(const Time& t, int decimals = 0) const;

  /// The number of rows up to t, to a few units in the last place.
  double rough_rows(const Time& t) const { return ((t - near_start_) / near_step_).hi + 1; }

  const Rational& start() const { return start_; }
  const Rational& step() const { return step_; }
  bool is_single() const { return is_single_; }  ///< the step is 0

 private:
  /// The time of a row in double-double precision, or those of two rows.
  template <class D>
  spline::DoubleDoubleOf<D> near_time(const D& row) const;

  /// A bound on the error of that.
  template <class D>
  D doubt(const D& near) const;

  /// The number of rows before t, where no row is so near to it that rounding could decide.
  std::optional<std::uint64_t> rows_if_clear(const Time& t) const;

  /// A row number that is right or a little off, for the exact search to start from.
  std::uint64_t estimate(const Time& t) const;

  Rational start_, step_;
  bool is_single_;
  std::uint64_t double_rows_ = 0;  ///< up to this row, (first + j increment) / denominator is of exact doubles
  double double_first_{}, double_increment_{}, double_denominator_{};
  Time near_start_, near_step_;  ///< as double-doubles
};

struct Spacing {
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

  Grid grid;
  std::uint64_t rows = unlimited;  ///< at most; fewer where the curve ends before
  std::optional<Rational> end;     ///< the last place that a row may have, where it is known
  std::uint64_t most = unlimited;  ///< rows up to that, where exact times decide it instead of rounded ones
};

/// Requires: a mode of equal steps. Throws: Error (usage) for more than max_rows rows, if that is known.
Spacing spacing(const SamplingRequest& request, const Extent& extent);

/// Throws: Error (usage) with the number of rows, if there are more than allowed; `at_least`: and more may come.
void require_rows(const Rational& steps, std::uint64_t max_rows, bool at_least = false);

/// A rational for people: a decimal of 31 digits at most in full, otherwise the nearest double, shortest.
std::string text(const Rational& value);

/// The ends of a request: those of the keys, beyond which a curve can be extended, or of pieces, both in time, or of
/// the curve in arc length.
enum class RangeEnds { of_keys, of_pieces, of_length };

/// Throws: Error (usage) about the option if its value lies before the first end, or after the last one.
void require_not_before(std::string_view option, const Rational& value, RangeEnds ends, const Rational& first);
void require_not_after(std::string_view option, const Rational& value, RangeEnds ends, const Rational& last);

/// Throws: Error (usage) if neighbouring rows of the grid would be the same double at `end`.
void require_resolution(const Grid& grid, const Time& end, int decimals = 0);

}  // namespace tcb
