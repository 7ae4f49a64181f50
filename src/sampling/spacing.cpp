// From a request to rows on a grid: where they begin, how far apart they are, how many there are.
#include "sampling/spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "sampling/bounds.hpp"

namespace tcb {
namespace {

/// The whole number of equal steps that a policy takes instead of this many.
Rational fitted_steps(EndPolicy policy, const Rational& steps) {
  const Rational below = floor(steps);
  const bool whole = below == steps;
  Rational fitted = below;
  if (policy == EndPolicy::fit_down && !whole) fitted = below + 1;
  if (policy == EndPolicy::fit && steps - below >= Rational(1, 2)) fitted = below + 1;
  return fitted < 1 ? 1 : fitted;
}

/// A number of rows as a person reads it.
std::string shown(const Rational& rows) {
  std::string digits = whole_text(rows);
  if (digits.size() <= 20) return digits;
  return fmt::format("about {}.{}e{}", digits[0], digits.substr(1, 2), digits.size() - 1);
}

}  // namespace

Rational steps_between(const Rational& from, const Rational& to, const Rational& step) { return (to - from) / step; }

void require_rows(const Rational& steps, std::uint64_t max_rows, bool at_least) {
  const Rational rows = floor(steps) + 1;
  if (rows <= max_rows) return;
  throw Error(Exit::usage,
              fmt::format("{} rows{} are asked for; expected {} at most; ask for fewer, or raise --max-rows",
                          shown(rows), at_least ? " or more" : "", max_rows));
}

Spacing spacing(const SamplingRequest& request, const Extent& extent) {
  const bool arc = by_length(request.mode);
  const Rational from = request.from.value_or(arc ? Rational(0) : exact_time(extent.first));
  std::optional<Rational> to = request.to;
  if (to && *to < from) {  // a --from of the request is before it
    throw Error(Exit::usage,
                fmt::format("--to {} is before {}, where samples begin unless --from is given; expected it "
                            "after; give a later one, or --from",
                            text(*to), text(from)));
  }
  if (!to && arc && extent.length) to = Rational(*extent.length);  // nobody wrote it: the double is what it is
  if (!to && !arc && extent.last) to = exact_time(*extent.last);
  if (to && !std::isfinite(nearest_double(*to - from))) {
    throw Error(Exit::data,
                "the samples lie farther apart than doubles reach; expected less than 1.8e308 from the first "
                "to the last; scale the keys down");
  }
  const auto end = to ? std::optional(nearest_time(*to)) : std::nullopt;

  if (request.mode == Mode::step || request.mode == Mode::arc_step) {
    if (!to) return {Grid(from, request.step), Spacing::unlimited, end};
    const Rational steps = steps_between(from, *to, request.step);
    require_rows(steps, request.max_rows);
    if (!needs_end(request) || *to <= from) return {Grid(from, request.step), Spacing::unlimited, end};
    const Rational fitted = fitted_steps(request.end, steps);
    return {Grid(from, (*to - from) / fitted), whole_number(fitted) + 1, end};
  }
  const bool seam_once = extent.closed && request.mode != Mode::segments && !request.from && !request.to;
  const std::uint64_t intervals = request.mode == Mode::segments || seam_once ? request.count : request.count - 1;
  const std::uint64_t rows = seam_once ? request.count : intervals + 1;
  require_rows(Rational(rows) - 1, request.max_rows);
  return {Grid(from, intervals == 0 ? 0 : (*to - from) / intervals), rows, end};
}

}  // namespace tcb
