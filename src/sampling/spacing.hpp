// From a request to rows on a grid: where they begin, how far apart they are, how many there are.
#pragma once

#include <limits>
#include <optional>

#include "sampling/grid.hpp"
#include "sampling/request.hpp"

namespace tcb {

/// What is known of a curve before its samples are placed.
struct Extent {
  Time first;
  std::optional<Time> last;      ///< needed where needs_end(request)
  std::optional<double> length;  ///< needed where needs_end(request) and by_length(mode)
  bool closed = false;           ///< counted rows do not come round to the first again
};

struct Spacing {
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

  Grid grid;
  std::uint64_t rows = unlimited;  ///< at most; fewer where the curve ends before
  std::optional<Time> end;         ///< the last place that a row may have, where it is known
};

/// Requires: a mode of equal steps. Throws: Error (usage) for more than max_rows rows, where that is known.
Spacing spacing(const SamplingRequest& request, const Extent& extent);

/// How many steps lie between two places; a whole number, or not.
Rational steps_between(const Rational& from, const Rational& to, const Rational& step);

/// Throws: Error (usage) saying the number of rows, if there are more than allowed; `at_least`: and more may come.
void require_rows(const Rational& steps, std::uint64_t max_rows, bool at_least = false);

}  // namespace tcb
