// Grids of rows: double-double arithmetic where it determines the rounding, else integers.
#include "sample/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numbers/print_number.hpp"
#include "tcb/spline/double_pair.hpp"

namespace tcb {
namespace {

constexpr double all_whole_from = 9007199254740992.0;  // 2^53: every double from here on is whole

/// From which size on times of a grid are whole numbers.
double whole_from(int decimals) {
  return decimals == only_doubles ? std::numeric_limits<double>::infinity() : all_whole_from;
}

/// Up to which row |first + j increment| stays below 2^53; 0: not even the first.
std::uint64_t rows_within_doubles(const Rational& first, const Rational& increment) {
  const Rational room = Rational(all_whole_from) - 1 - abs(first);
  if (room < 0) return 0;
  constexpr std::uint64_t all_rows = std::numeric_limits<std::uint64_t>::max();
  return increment == 0 ? all_rows : whole_number(floor(room / increment));
}

/// The least common multiple of two positive whole numbers.
Rational least_common_multiple(const Rational& a, const Rational& b) { return a * numerator(b / a); }

Time nearest_double_double(const Rational& value) {
  const double high = nearest_double(value);
  return {high, nearest_double(value - Rational(high))};
}

/// The whole number of equal steps that a policy takes instead of this many.
Rational fitted_steps(EndPolicy policy, const Rational& steps) {
  const Rational below = floor(steps);
  const bool whole = below == steps;
  Rational fitted = below;
  if (policy == EndPolicy::fit_down && !whole) fitted = below + 1;
  if (policy == EndPolicy::fit && steps - below >= Rational(1, 2)) fitted = below + 1;
  return fitted < 1 ? 1 : fitted;
}

/// A number of rows for people: beyond 20 digits, three of them.
std::string shown(const Rational& rows) {
  std::string digits = whole_text(rows);
  if (digits.size() <= 20) return digits;
  return fmt::format("{}.{}e{}", digits[0], digits.substr(1, 2), digits.size() - 1);
}

}  // namespace

Grid::Grid(const Rational& start, const Rational& step) : start_(start), step_(step), is_single_(step == 0) {
  if (!std::isfinite(nearest_double(step))) {
    throw data_error(
        "the step from one sample to the next is beyond the range of doubles; expected less than 1.8e308; scale the "
        "keys down");
  }
  near_start_ = nearest_double_double(start);
  near_step_ = nearest_double_double(step);
  const Rational common = least_common_multiple(denominator(start), denominator(step));
  if (common >= Rational(all_whole_from)) return;
  const Rational first = start * common;
  const Rational increment = step * common;
  double_rows_ = rows_within_doubles(first, increment);
  if (double_rows_ == 0) return;
  double_first_ = nearest_double(first);
  double_increment_ = nearest_double(increment);
  double_denominator_ = nearest_double(common);
}

template <class D>
spline::DoubleDoubleOf<D> Grid::near_time(const D& row) const {
  const auto product = spline::two_product(D(near_step_.hi), row);
  const auto sum = spline::two_sum(D(near_start_.hi), product.value);
  const D low = (near_start_.lo + near_step_.lo * row) + (product.error + sum.error);
  return spline::DoubleDoubleOf<D>::normalized(sum.value, low);
}

template <class D>
D Grid::doubt(const D& near) const {
  using std::abs;
  return (std::abs(near_start_.hi) + abs(near)) * 0x1p-98;
}

Time Grid::time(std::uint64_t j, int decimals) const {
  if (decimals > 0) return nearest_time(start_ + step_ * j, decimals);
  // Numerator and denominator are whole numbers below 2^53, so the one division rounds once.
  const auto row = static_cast<double>(j);
  if (j <= double_rows_ && double_rows_ > 0) return {(double_first_ + double_increment_ * row) / double_denominator_};
  if (j < static_cast<std::uint64_t>(all_whole_from)) {
    const Time near = near_time(row);
    if (const auto time = rounded_once(near, doubt(near.hi), whole_from(decimals))) return *time;
  }
  return nearest_time(start_ + step_ * j, decimals);
}

void Grid::set_times(std::uint64_t first, std::uint64_t last, int decimals, std::vector<Time>& times) const {
  using spline::DoublePair;
  times.clear();
  std::uint64_t row = first;
  const bool near_is_enough = decimals <= 0 && double_rows_ == 0 && last < static_cast<std::uint64_t>(all_whole_from);
  for (; near_is_enough && last - row >= 2; row += 2) {
    const auto number = static_cast<double>(row);
    const auto near = near_time(DoublePair(number, number + 1));
    const DoublePair doubts = doubt(near.hi);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto rounded = rounded_once({near.hi[i], near.lo[i]}, doubts[i], whole_from(decimals));
      times.push_back(rounded ? *rounded : time(row + i, decimals));
    }
  }
  for (; row != last; ++row) times.push_back(time(row, decimals));
}

std::uint64_t Grid::estimate(const Time& t) const {
  const double rows = ((t - near_start_) / near_step_).hi;
  constexpr double most = 9.0e18;
  return rows > 0 ? static_cast<std::uint64_t>(std::min(rows, most)) : 0;
}

std::optional<std::uint64_t> Grid::rows_if_clear(const Time& t) const {
  // The error of `row`, and that of the rounding of rows, is less than five times (|t| + |start|) 2^-53 / step.
  const double row = (t.hi - near_start_.hi) / near_step_.hi;
  const double doubt = (std::abs(t.hi) + std::abs(near_start_.hi)) * 0x1p-50 / near_step_.hi;
  const bool step_has_all_digits = near_step_.hi >= std::numeric_limits<double>::min();
  if (!(row > 0 && row < all_whole_from && step_has_all_digits)) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(row);
  const double part = row - static_cast<double>(whole);
  if (!(part > doubt && part < 1 - doubt)) return std::nullopt;
  return whole + 1;
}

std::uint64_t Grid::rows_before(const Time& t, int decimals) const {
  if (const auto rows = rows_if_clear(t)) return *rows;
  std::uint64_t rows = estimate(t);
  while (rows > 0 && time(rows - 1, decimals) >= t) --rows;
  while (time(rows, decimals) < t) ++rows;
  return rows;
}

std::uint64_t Grid::rows_through(const Time& t, int decimals) const {
  if (const auto rows = rows_if_clear(t)) return *rows;
  std::uint64_t rows = estimate(t);
  while (rows > 0 && time(rows - 1, decimals) > t) --rows;
  while (time(rows, decimals) <= t) ++rows;
  return rows;
}

bool Grid::resolves(const Time& t, int decimals) const {
  const double largest = std::max(std::abs(t.hi), std::abs(near_start_.hi));
  if (near_step_.hi > largest * 0x1p-51) return true;
  return time(1, decimals) > time(0, decimals) && nearest_time(exact_time(t) + step_, decimals) > t;
}

void require_rows(const Rational& steps, std::uint64_t max_rows, bool at_least) {
  const Rational rows = floor(steps) + 1;
  if (rows <= max_rows) return;
  throw usage_error("{}{} rows are requested; expected at most {}; request fewer, or raise --max-rows",
                    at_least ? "at least " : "", shown(rows), max_rows);
}

void SamplingRequest::convert_seconds(const Rational& units) {
  if (in_seconds.step) step *= units;
  if (in_seconds.from) *from *= units;
  if (in_seconds.to) *to *= units;
  for (std::size_t i = 0; in_seconds.places && i < places.size(); ++i) places[i] *= units;
  in_seconds = {};
}

Rational SamplingRequest::exact(const Time& time) const {
  if (key_times) {
    if (const auto key = key_times->find(time); key != key_times->end()) return key->second;
  }
  const auto frame = frames ? frames->exact(time) : std::nullopt;
  return frame ? *frame : exact_time(time);
}

namespace {

/// The grid of rows by time on a part of a curve that gaps divide; no rows where the range does not meet it.
Spacing spacing_of_part(const SamplingRequest& request, const Extent& extent) {
  const Rational first = request.exact(extent.first);
  const bool steps = request.mode == Mode::step;
  Rational from = request.from.value_or(steps ? *request.origin : first);
  if (from < first && !request.reaches_before)
    from = steps ? from - floor((from - first) / request.step) * request.step : first;
  std::optional<Rational> to = request.to;
  if (extent.last && (!to || !request.reaches_after)) {
    to = std::min(to.value_or(request.exact(*extent.last)), request.exact(*extent.last));
  }
  if (to && *to < from) return {Grid(from, steps ? request.step : Rational(0)), 0, to};
  if (to && *to == from && !steps) return {Grid(from, 0), 1, to};
  SamplingRequest own = request;
  own.origin.reset();
  own.from = from;
  own.to = to;
  return spacing(own, extent);
}

}  // namespace

Spacing spacing(const SamplingRequest& request, const Extent& extent) {
  const bool arc = by_length(request.mode);
  if (request.origin && !arc) return spacing_of_part(request, extent);
  const Rational from = request.from.value_or(arc ? Rational(0) : request.exact(extent.first));
  std::optional<Rational> to = request.to;
  if (to && *to < from) {  // a start that was given is before it
    throw usage_error("{} is before {}, where samples begin without --from; give a later end, or --from", text(*to),
                      text(from))
        .about("--to");
  }
  if (!to && arc && extent.length) to = Rational(*extent.length);  // a computed double is its own value
  if (!to && !arc && extent.last) to = request.exact(*extent.last);
  if (to && *to < from && request.count != 1) {
    if (arc) require_not_after("--from", from, RangeEnds::of_length, Rational(*extent.length));
    throw usage_error("{} is after {}, where samples end without --to; give an earlier start, or --to", text(from),
                      text(*to))
        .about("--from");
  }
  if (to && !std::isfinite(nearest_double(*to - from))) {
    throw data_error(
        "the distance from the first sample to the last is beyond the range of doubles; expected less than 1.8e308; "
        "scale the keys down");
  }
  if (request.mode == Mode::step || request.mode == Mode::arc_step) {
    if (!to) return {Grid(from, request.step), Spacing::unlimited, to};
    const Rational steps = (*to - from) / request.step;
    require_rows(steps, request.max_rows);
    if (!needs_end(request) || *to <= from) {
      const std::uint64_t most = request.key_times ? whole_number(floor(steps)) + 1 : Spacing::unlimited;
      return {Grid(from, request.step), Spacing::unlimited, to, most};
    }
    const Rational fitted = fitted_steps(request.end, steps);
    return {Grid(from, (*to - from) / fitted), whole_number(fitted) + 1, to};
  }
  const bool seam_once = extent.closed && request.mode != Mode::intervals && !request.from && !request.to;
  const std::uint64_t intervals = request.mode == Mode::intervals || seam_once ? request.count : request.count - 1;
  const std::uint64_t rows = seam_once ? request.count : intervals + 1;
  require_rows(Rational(rows) - 1, request.max_rows);
  return {Grid(from, intervals == 0 ? 0 : (*to - from) / intervals), rows, to};
}

std::string text(const Rational& value) {
  const Time decimal = nearest_time(value, 1);
  if (has_many_digits(decimal) && exact_time(decimal) == value) return time_text(decimal);
  const Time time = nearest_time(value);
  return time.lo == 0 ? fmt::format("{}", time.hi) : whole_text(Rational(time.hi) + Rational(time.lo));
}

namespace {

/// A value that is rounded to the bound is shown as a ratio.
std::string beside(const Rational& value, const Rational& bound) {
  const std::string shown = text(value);
  return shown == text(bound) ? ratio_text(value) : shown;
}

std::string or_extended(RangeEnds ends) { return ends == RangeEnds::of_keys ? ", or --extrapolate hold" : ""; }

}  // namespace

void require_not_before(std::string_view option, const Rational& value, RangeEnds ends, const Rational& first) {
  if (value >= first) return;
  const std::string shown = beside(value, first), limit = text(first);
  throw(ends == RangeEnds::of_length
            ? usage_error("arc length {} is below {}, that of the first key; give a length within the curve", shown,
                          limit)
            : usage_error("time {} is before the first key, at {}; give a time on the curve{}", shown, limit,
                          or_extended(ends)))
      .about(option);
}

void require_not_after(std::string_view option, const Rational& value, RangeEnds ends, const Rational& last) {
  if (value <= last) return;
  const std::string shown = beside(value, last), limit = text(last);
  throw(ends == RangeEnds::of_length
            ? usage_error("arc length {} is beyond the length of the curve, {}; give a length within the curve", shown,
                          limit)
            : usage_error("time {} is after the last key, at {}; give a time on the curve{}", shown, limit,
                          or_extended(ends)))
      .about(option);
}

void require_resolution(const Grid& grid, const Time& end, int decimals) {
  if (grid.resolves(end, decimals)) return;
  throw usage_error("the step {} is too small: two rows near {} would coincide; give a larger step", text(grid.step()),
                    text(exact_time(end)));
}

}  // namespace tcb
