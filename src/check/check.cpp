// Check: compares every number of given rows with the computed one, and the rows with those that are expected.
//
// Curves get their rows and their limits; each row is computed at its place, and its numbers are compared column by
// column. Then the places of all rows are compared with those that the options request.
#include "check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/fields.hpp"
#include "sample/rows.hpp"
#include "schema/key_block.hpp"
#include "schema/texts.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// Throws: Error (usage) for a tolerance of a column that is not compared.
void require_columns(const Comparison& comparison, const ComparisonInputs& inputs) {
  std::vector<std::string> known{inputs.place_name()};
  for (const MatchedColumn& column : inputs.columns.compared) known.push_back(column.name);
  for (const auto& [name, tolerances] : {std::pair{"--abs", &comparison.abs}, std::pair{"--rel", &comparison.rel},
                                         std::pair{"--ulp", &comparison.ulp}}) {
    for (const Tolerance& tolerance : *tolerances) {
      if (tolerance.column.empty() || std::ranges::count(known, tolerance.column) > 0) continue;
      throw usage_error("no column {} is compared; expected one of {}{}", in_quotes(tolerance.column), listed(known),
                        did_you_mean(tolerance.column, known))
          .about(name);
    }
  }
}

/// Compares the numbers of rows, and counts and keeps what differs.
class Checker {
 public:
  Checker(const ComparisonInputs& inputs, const Comparison& comparison, Check& result)
      : inputs_(inputs), result_(result) {
    for (const MatchedColumn& column : inputs.columns.compared) {
      limits_.push_back(limits_of(comparison, column.name));
      result.columns.push_back({column.name, 0, {}});
    }
  }

  void compare_row(const SampleRows& rows, std::size_t row, std::span<const Cell> cells) {
    constexpr std::uint64_t at_once = 1024;
    if (++result_.rows % at_once == 0 && inputs_.progress != nullptr) inputs_.progress->add_rows(at_once);
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const MatchedColumn& column = inputs_.columns.compared[i];
      const Cell& cell = cells[column.computed];
      const double computed = is_empty(cell) ? std::numeric_limits<double>::quiet_NaN() : cell.hi;
      const double given = rows.row(row)[column.given];
      ++result_.values;
      const Distance found = distance(given, computed);
      if (!std::isnan(given) && !std::isnan(computed)) widen(result_.columns[i].largest, found);
      if (limits_[i].admit(found)) continue;
      ++result_.mismatches;
      ++result_.columns[i].mismatches;
      add({row + 1, rows.lines[row], column.name, given, computed, found});
    }
  }

 private:
  static void widen(Distance& largest, const Distance& found) {
    largest.abs = std::max(largest.abs, found.abs);
    largest.rel = std::max(largest.rel, found.rel);
    largest.ulp = std::max(largest.ulp, found.ulp);
  }

  void add(Difference difference) {
    if (!result_.first || difference.line < result_.first->line) result_.first = difference;
    if (!result_.worst || difference.distance.abs > result_.worst->distance.abs) result_.worst = std::move(difference);
  }

  const ComparisonInputs& inputs_;
  Check& result_;
  std::vector<Limits> limits_;
};

/// Decides which rows are the expected ones.
class RowMatcher {
 public:
  RowMatcher(std::span<const Time> expected, const Limits& limits) : expected_(expected), limits_(limits) {
    if (!expected.empty()) rounding_ = billionth * (expected.back() - expected.front()).hi;
  }

  /// Whether a row here is the expected one with this index.
  bool is_row(std::size_t index, const Time& place) const {
    const Time& wanted = expected_[index];
    const double apart = std::abs((place - wanted).hi);
    if (apart <= rounding_ || apart < part_of_gap * gap(index)) return true;
    return limits_.admit(distance(place.hi, wanted.hi));
  }

 private:
  static constexpr double billionth = 1e-9;
  static constexpr double part_of_gap = 0.125;  ///< more than two decimals round off at 24 rows per second

  /// From an expected row to the nearest other one, which may be at the same place; 0 if there is none.
  double gap(std::size_t index) const {
    const auto row = expected_.begin() + static_cast<std::ptrdiff_t>(index);
    const bool is_last = index + 1 == expected_.size();
    if (index == 0) return is_last ? 0 : (row[1] - *row).hi;
    const double before = (*row - row[-1]).hi;
    return is_last ? before : std::min(before, (row[1] - *row).hi);
  }

  std::span<const Time> expected_;
  const Limits& limits_;
  double rounding_ = 0;  ///< differences up to this are those of rounding
};

/// The places that the rows of a curve should have, in increasing order: arc lengths if the given rows are at these,
/// otherwise times. Throws: Error if the request does not fit the curve.
std::vector<Time> expected_places(const SampleOptions& expected, const Comparison& comparison,
                                  const ComparisonInputs& inputs, const KeptKeys& curve) {
  const std::vector<std::size_t> fields{field_of(inputs.columns.by_length ? "s" : "time")};
  const Schema& schema = inputs.kept.schema;
  const CurveRequest request{.samples = expected.of({curve.group, curve.curve_info, {}}, schema),
                             .rules = comparison.keys.rules,
                             .fields = fields,
                             .threads = inputs.threads,
                             .zero = inputs.kept.zero,
                             .leaves_gaps = true};
  CurvePipeline pipeline(request, schema, inputs.kept.traits, *curve.curve_info, curve.part);
  const CurveSamples samples = pipeline.samples(curve.keys());
  std::vector<Time> places;
  while (const std::optional<SampleBlock> block = samples.blocks()) {
    const Table rows = samples.evaluate(*block, fields);
    places.insert(places.end(), rows.cells.begin(), rows.cells.end());
  }
  std::ranges::sort(places, std::less<>());
  return places;
}

/// Compares the rows of a curve with those that are expected. A row counts as the expected one from which it is less
/// than an eighth of the way to the next one, or within `limits`. Nothing: they are the same; otherwise the problem.
std::optional<std::string> rows_differ(std::span<const Time> expected, const Places& found, const SampleRows& rows,
                                       const Limits& limits) {
  std::vector<std::size_t> order(found.places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::less<>(), [&](std::size_t i) { return found.places[i]; });
  const RowMatcher matcher(expected, limits);
  std::vector<std::size_t> missing, surplus;  // expected rows, and found ones
  std::size_t row = 0, next = 0;
  while (row < expected.size() && next < order.size()) {
    const Time& place = found.places[order[next]];
    if (matcher.is_row(row, place)) {
      ++row;
      ++next;
    } else if (place < expected[row]) {
      surplus.push_back(order[next++]);
    } else {
      missing.push_back(row++);
    }
  }
  for (; row < expected.size(); ++row) missing.push_back(row);
  for (; next < order.size(); ++next) surplus.push_back(order[next]);
  if (missing.empty() && surplus.empty()) return std::nullopt;
  std::string text = fmt::format("rows: {} expected, {} found", expected.size(), order.size());
  if (!missing.empty()) {
    text += fmt::format("; missing: {}, the first at {}", missing.size(), time_text(expected[missing.front()]));
  }
  if (!surplus.empty()) {
    text += fmt::format("; not expected: {}, the first in line {} at {}", surplus.size(),
                        rows.lines[found.rows[surplus.front()]], time_text(found.places[surplus.front()]));
  }
  if (!order.empty()) text += fmt::format("; the last row found is at {}", time_text(found.places[order.back()]));
  return text;
}

/// Notes which part of the curve has rows, and compares these with those that are expected.
void check_coverage(const Pair& pair, const Comparison& comparison, const ComparisonInputs& inputs, const Places& found,
                    const Limits& limits, Check& result) {
  Coverage& coverage = result.coverage.emplace_back(Coverage{group_title(inputs.kept.schema.groups, pair.curve->group),
                                                             inputs.place_name(), found.first, found.last});
  coverage.rows = found.places.size();
  if (!found.places.empty()) {
    const auto [least, most] = std::ranges::minmax(found.places, std::less<>());
    coverage.covered = {least, most};
  }
  if (!comparison.expected) return;
  const std::vector<Time> places = expected_places(*comparison.expected, comparison, inputs, *pair.curve);
  coverage.expected_rows = places.size();
  const auto problem = rows_differ(places, found, pair.rows, limits);
  if (!problem) return;
  result.problems.push_back(coverage.curve.empty() ? *problem
                                                   : fmt::format("curve {}: {}", listed(coverage.curve), *problem));
}

void check_pair(const Pair& pair, const Comparison& comparison, const ComparisonInputs& inputs, Checker& checker,
                Check& result, const std::function<void(const CheckedPair&)>& observe) {
  const MatchedColumns& columns = inputs.columns;
  CurveRequest request{.samples = {},
                       .rules = comparison.keys.rules,
                       .fields = columns.fields,
                       .threads = inputs.threads,
                       .zero = inputs.kept.zero,
                       .leaves_gaps = true};
  request.samples.from_left = comparison.from_left;
  request.samples.mode = columns.by_length ? Mode::arc_at : Mode::at;
  const spline::Side side = request.samples.side();
  CurvePipeline pipeline(request, inputs.kept.schema, inputs.kept.traits, *pair.curve->curve_info, pair.curve->part);
  const std::shared_ptr<const KeptCurve> curve = pipeline.kept(pair.curve->keys());
  const Limits limits = limits_of(comparison, inputs.place_name());
  const Places places = places_of(pair.rows, columns, *curve, limits);
  if (places.off_curve) result.problems.emplace_back(*places.off_curve);
  for_each_row(pair.rows, places, columns, curve, side, inputs.threads,
               [&](std::size_t row, auto cells) { checker.compare_row(pair.rows, row, cells); });
  check_coverage(pair, comparison, inputs, places, limits, result);
  if (observe) observe({inputs, pipeline, *pair.curve, pair.rows, curve, places, side});
}

}  // namespace

ComparisonSummary summary(const ComparisonInputs& inputs, const Pairs& pairs) {
  const MatchedColumns& columns = inputs.columns;
  ComparisonSummary result{inputs.file, inputs.keys, columns.by_length, columns.ignored, columns.problems};
  result.problems.insert(result.problems.end(), pairs.problems.begin(), pairs.problems.end());
  return result;
}

Check check(const Comparison& comparison, ComparisonInputs inputs,
            const std::function<void(const CheckedPair&)>& observe) {
  require_columns(comparison, inputs);
  const Pairs pairs = pair_up(inputs.kept, inputs.table);
  Check result{summary(inputs, pairs)};
  Checker checker(inputs, comparison, result);
  std::uint64_t rows = 0;
  for (const Pair& pair : pairs.pairs) rows += pair.rows.size();
  if (inputs.progress != nullptr) inputs.progress->expect_rows(static_cast<double>(rows));
  for (const Pair& pair : pairs.pairs) {
    in_file(inputs.keys, [&] { check_pair(pair, comparison, inputs, checker, result, observe); });
  }
  return result;
}

}  // namespace tcb
