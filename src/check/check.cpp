// Check: rows paired with curves, their distances from the computed numbers, and the limits for these.
#include "check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/fields.hpp"
#include "sample/places.hpp"
#include "sample/rows.hpp"
#include "schema/key_block.hpp"
#include "schema/texts.hpp"
#include "stream/ordered_map.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

bool has_content(const std::vector<std::string>& group) {
  return std::ranges::any_of(group, [](const std::string& text) { return !text.empty(); });
}

/// All rows as those of one curve.
SampleRows concatenated(const std::vector<SampleRows>& parts) {
  SampleRows all;
  for (const SampleRows& part : parts) {
    all.times.insert(all.times.end(), part.times.begin(), part.times.end());
    all.numbers.insert(all.numbers.end(), part.numbers.begin(), part.numbers.end());
    all.lines.insert(all.lines.end(), part.lines.begin(), part.lines.end());
  }
  return all;
}

/// Divides rows at the gaps of the keys, so that each part of a curve has its own; rows in a gap belong to the part
/// before it. Requires: the rows have times.
void divide_at_gaps(const KeptInput& kept, SampleTable& table) {
  const std::vector<KeptKeys>& curves = kept.curves;
  const auto is_first_part = [](const KeptKeys& curve) { return curve.part->number == 0; };
  if (std::ranges::count_if(curves, is_first_part) == 1) table.curves = {concatenated(table.curves)};
  std::vector<SampleRows> divided;
  std::size_t next = 0;  // of the first part of a curve
  for (SampleRows& rows : table.curves) {
    if (next == curves.size()) {
      divided.push_back(std::move(rows));
      continue;
    }
    const std::size_t width = rows.size() == 0 ? 0 : rows.numbers.size() / rows.size();
    std::vector<bool> taken(rows.size());
    do {
      const std::optional<Time> end = curves[next].part->next();
      SampleRows& part = divided.emplace_back(SampleRows{rows.group, {}, {}, {}});
      for (std::size_t row = 0; row < rows.size(); ++row) {
        if (taken[row] || (end && rows.times[row] >= *end)) continue;
        taken[row] = true;
        part.times.push_back(rows.times[row]);
        part.lines.push_back(rows.lines[row]);
        const auto first = rows.numbers.begin() + static_cast<std::ptrdiff_t>(row * width);
        part.numbers.insert(part.numbers.end(), first, first + static_cast<std::ptrdiff_t>(width));
      }
    } while (++next < curves.size() && curves[next].part->number > 0);
  }
  table.curves = std::move(divided);
}

Pairs pairs_by_group(const KeptInput& kept, SampleTable& table) {
  const std::vector<std::string>& names = kept.schema.groups;
  Pairs result;
  std::vector<bool> taken(table.curves.size());
  for (const KeptKeys& curve : kept.curves) {
    const auto wanted = contents(curve.group);
    SampleRows rows;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (taken[i] || contents(table.curves[i].group) != wanted) continue;
      taken[i] = true;
      rows = std::move(table.curves[i]);
      break;
    }
    if (rows.size() == 0)
      result.problems.push_back(fmt::format("curve {} has no rows", listed(group_title(names, curve.group))));
    else
      result.pairs.push_back({&curve, std::move(rows)});
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) continue;
    const SampleRows& rows = table.curves[i];
    result.problems.push_back(fmt::format("curve {} has no keys; its rows are in line {} and below",
                                          listed(group_title(names, rows.group)), rows.lines.at(0)));
  }
  return result;
}

/// How the rows of a curve differ from those that are expected.
struct RowCounts {
  std::uint64_t expected = 0, found = 0;
  std::uint64_t missing = 0;       ///< expected, but not found
  std::uint64_t surplus = 0;       ///< found, but not expected
  std::uint64_t surplus_line = 0;  ///< of the first of these
  // Times or arc lengths:
  std::string first_missing = {}, first_surplus = {}, last_found = {};
};

/// The problem of rows that differ.
std::string rows_not_as_expected(const RowCounts& counts) {
  std::string text = fmt::format("rows: {} expected, {} found", counts.expected, counts.found);
  if (counts.missing > 0) text += fmt::format("; missing: {}, the first at {}", counts.missing, counts.first_missing);
  if (counts.surplus > 0) {
    text += fmt::format("; not expected: {}, the first in line {} at {}", counts.surplus, counts.surplus_line,
                        counts.first_surplus);
  }
  return text + (counts.last_found.empty() ? "" : fmt::format("; the last row found is at {}", counts.last_found));
}

/// The number that is read from the text of a place.
double as_printed(const Time& place, const Notation& notation) {
  std::string text(longest_number_in(notation) + spare_room, '\0');
  text.resize(static_cast<std::size_t>(write_time(place, notation, text.data()) - text.data()));
  return parse_number(text).value_or(place.hi);
}

/// Decides which rows are the expected ones.
class RowMatcher {
 public:
  RowMatcher(std::span<const Time> expected, const Notation& notation, const Limits& limits)
      : expected_(expected), notation_(notation), limits_(limits) {
    if (!expected.empty()) rounding_ = billionth * (expected.back() - expected.front()).hi;
  }

  /// Whether a row here is the expected one with this index.
  bool is_row(std::size_t index, const Time& place) const {
    const Time& wanted = expected_[index];
    const double apart = std::abs((place - wanted).hi);
    if (apart <= rounding_ || apart < part_of_gap * gap(index)) return true;
    if (limits_.admit(distance(place.hi, wanted.hi))) return true;
    return notation_.is_rounded() && as_printed(wanted, notation_) == place.hi;
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
  const Notation& notation_;
  const Limits& limits_;
  double rounding_ = 0;  ///< differences up to this are those of rounding
};

/// The places that the rows of a curve should have, in increasing order: arc lengths if the given rows are at these,
/// otherwise times. Throws: Error if the request does not fit the curve.
std::vector<Time> expected_places(const ExpectedSamples& expected, const Comparison& comparison,
                                  const ComparisonInputs& inputs, const KeptKeys& curve) {
  const std::vector<std::size_t> fields{field_of(inputs.columns.by_length ? "s" : "time")};
  const Schema& schema = inputs.kept.schema;
  CurveSettings rules = comparison.keys.rules;
  if (!rules.metric) rules.metric = expected.metric;
  const CurveRequest request{.samples = expected.samples.of({curve.group, curve.curve_info, {}}, schema),
                             .rules = rules,
                             .fields = fields,
                             .threads = inputs.threads};
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
/// than an eighth of the way to the next one, within `limits`, or different only as printed in `notation`. Nothing:
/// they are the same; otherwise the problem.
std::optional<std::string> rows_differ(std::span<const Time> expected, const Places& found, const SampleRows& rows,
                                       const Notation& notation, const Limits& limits) {
  std::vector<std::size_t> order(found.places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::less<>(), [&](std::size_t i) { return found.places[i]; });
  const RowMatcher matcher(expected, notation, limits);
  RowCounts counts{expected.size(), order.size()};
  const auto miss = [&](std::size_t row) {
    if (counts.missing++ == 0) counts.first_missing = time_text(expected[row]);
  };
  const auto refuse = [&](std::size_t index) {
    if (counts.surplus++ > 0) return;
    counts.first_surplus = time_text(found.places[index]);
    counts.surplus_line = rows.lines[found.rows[index]];
  };
  std::size_t row = 0, next = 0;
  while (row < expected.size() && next < order.size()) {
    const Time& place = found.places[order[next]];
    if (matcher.is_row(row, place)) {
      ++row;
      ++next;
    } else if (place < expected[row]) {
      refuse(order[next++]);
    } else {
      miss(row++);
    }
  }
  for (; row < expected.size(); ++row) miss(row);
  for (; next < order.size(); ++next) refuse(order[next]);
  if (counts.missing == 0 && counts.surplus == 0) return std::nullopt;
  if (!order.empty()) counts.last_found = time_text(found.places[order.back()]);
  return rows_not_as_expected(counts);
}

/// The part of a curve that its rows cover.
Coverage coverage_of(const KeptKeys& curve, const ComparisonInputs& inputs, const KeptCurve& whole,
                     const Places& found) {
  Coverage coverage{group_title(inputs.kept.schema.groups, curve.group), inputs.place_name()};
  coverage.first = inputs.columns.by_length ? Time(0.0) : whole.extent().first;
  coverage.last = inputs.columns.by_length ? Time(whole.length()) : *whole.extent().last;
  coverage.rows = found.places.size();
  if (found.places.empty()) return coverage;
  const auto [least, most] = std::ranges::minmax(found.places, std::less<>());
  coverage.covered = {least, most};
  return coverage;
}

/// An index of the doubles in increasing order; both zeros have index 0.
std::int64_t index_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(std::abs(value));
  return value < 0 ? -static_cast<std::int64_t>(bits) : static_cast<std::int64_t>(bits);
}

std::optional<double> limit(const std::vector<Tolerance>& tolerances, const std::string& column) {
  std::optional<double> all, own;
  for (const Tolerance& tolerance : tolerances) {
    if (tolerance.column.empty()) all = tolerance.most;
    if (tolerance.column == column) own = tolerance.most;
  }
  return own ? own : all;
}

/// Compares the rows of one curve after another.
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
      const double given = rows.numbers[row * inputs_.table.columns.size() + column.given];
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

/// Compares which rows there are. Rows of provenance that these keys do not make are unknown.
void check_coverage(const Pair& pair, const Comparison& comparison, const ComparisonInputs& inputs,
                    const KeptCurve& curve, const Places& found, const Limits& limits, Check& result) {
  Coverage& coverage = result.coverage.emplace_back(coverage_of(*pair.curve, inputs, curve, found));
  std::optional<ExpectedSamples> expected = comparison.expected;
  if (!expected && inputs.table.provenance) expected = comparison.recorded(*inputs.table.provenance);
  if (!expected) return;
  std::vector<Time> places;
  try {
    places = expected_places(*expected, comparison, inputs, *pair.curve);
  } catch (const Error&) {
    if (comparison.expected) throw;
    return;
  }
  coverage.expected_rows = places.size();
  const auto problem = rows_differ(places, found, pair.rows, expected->notation, limits);
  if (!problem) return;
  result.problems.push_back(coverage.curve.empty() ? *problem
                                                   : fmt::format("curve {}: {}", listed(coverage.curve), *problem));
}

/// Compares the rows of one curve.
void check_pair(const Pair& pair, const Comparison& comparison, const ComparisonInputs& inputs, Checker& checker,
                Check& result, const std::function<void(const CheckedPair&)>& observe) {
  const MatchedColumns& columns = inputs.columns;
  CurveRequest request{
      .samples = {}, .rules = comparison.keys.rules, .fields = columns.fields, .threads = inputs.threads};
  request.samples.from_left = comparison.from_left;
  request.samples.mode = columns.by_length ? Mode::arc_at : Mode::at;
  const spline::Side side = request.samples.side();
  CurvePipeline pipeline(request, inputs.kept.schema, inputs.kept.traits, *pair.curve->curve_info);
  const std::shared_ptr<const KeptCurve> curve = pipeline.kept(pair.curve->keys());
  const Limits limits = limits_of(comparison, inputs.place_name());
  const Places places = places_of(pair.rows, inputs.table, columns, *curve, limits);
  if (places.off_curve) result.problems.emplace_back(*places.off_curve);
  for_each_row(pair.rows, places, columns, curve, side, inputs.threads,
               [&](std::size_t row, auto cells) { checker.compare_row(pair.rows, row, cells); });
  check_coverage(pair, comparison, inputs, *curve, places, limits, result);
  if (observe) observe({inputs, pipeline, *pair.curve, pair.rows, curve, places, side});
}

}  // namespace

Pairs pair_up(const KeptInput& kept, SampleTable& table) {
  if (!kept.curves.empty() && kept.curves[0].part && table.timed) divide_at_gaps(kept, table);
  if (!kept.curves.empty() && has_content(kept.curves[0].group) && !table.curves.empty() &&
      has_content(table.curves[0].group)) {
    return pairs_by_group(kept, table);
  }
  Pairs result;
  if (kept.curves.size() == 1) {
    result.pairs.push_back({&kept.curves[0], concatenated(table.curves)});
    return result;
  }
  const std::size_t both = std::min(kept.curves.size(), table.curves.size());
  for (std::size_t i = 0; i < both; ++i) result.pairs.push_back({&kept.curves[i], std::move(table.curves[i])});
  if (kept.curves.size() != table.curves.size()) {
    result.problems.push_back(fmt::format("number of curves: {} in the rows, {} in the keys, {} compared",
                                          table.curves.size(), kept.curves.size(), both));
  }
  return result;
}

ComparisonSummary summary(const ComparisonInputs& inputs, const Pairs& pairs) {
  const MatchedColumns& columns = inputs.columns;
  ComparisonSummary result{inputs.file, inputs.keys, columns.by_length, columns.ignored, columns.problems};
  result.problems.insert(result.problems.end(), pairs.problems.begin(), pairs.problems.end());
  return result;
}

Places places_of(const SampleRows& rows, const SampleTable& table, const MatchedColumns& columns,
                 const KeptCurve& curve, const Limits& limits) {
  const Time first = columns.by_length ? Time(0.0) : curve.extent().first;
  const Time last = columns.by_length ? Time(curve.length()) : *curve.extent().last;
  const auto is_extended_to = [&](const Time& place) {
    const auto& [before, after] = curve.extrapolations();
    return !columns.by_length && (place < first ? before : after) != Extrapolation::error;
  };
  Places result;
  std::uint64_t off_curve = 0;
  std::pair<std::size_t, Time> first_off;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Time place = columns.place                 ? Time(rows.numbers[row * table.columns.size() + *columns.place])
                 : curve.extent().decimals > 0 ? with_all_digits(rows.times[row])
                                               : as_double(rows.times[row]);
    const bool on_curve = place >= first && place <= last;
    const Time end = place < first ? first : last;
    const bool extended = is_extended_to(place);
    if (place == place && !on_curve && !extended && limits.admit(distance(place.hi, end.hi))) place = end;
    if ((place >= first && place <= last) || (extended && place == place)) {
      result.rows.push_back(row);
      result.places.push_back(place);
      continue;
    }
    if (off_curve++ == 0) first_off = {row, place};
  }
  if (off_curve > 0) {
    const auto& [row, place] = first_off;
    const bool has_place = place == place;
    result.off_curve =
        has_place
            ? fmt::format("rows outside the curve: {}; the first, in line {}, has {} {}; {} of the curve is {}",
                          off_curve, rows.lines[row], columns.by_length ? "arc length" : "time", time_text(place),
                          columns.by_length ? "the nearest one" : "the nearest time",
                          time_text(place < first ? first : last))
            : fmt::format("rows without a time or arc length: {}; the first is in line {}", off_curve, rows.lines[row]);
  }
  return result;
}

void for_each_row(const SampleRows& given, const Places& places, const MatchedColumns& columns,
                  const std::shared_ptr<const KeptCurve>& curve, spline::Side side, unsigned threads,
                  const std::function<void(std::size_t, std::span<const Cell>)>& use) {
  const FoundRows rows = find_rows(curve, {.places = places.places}, columns.by_length, side);
  const auto cells_of = [&columns, &rows](const SampleBlock& block) {
    return evaluate(block, *rows.locator, columns.fields);
  };
  const auto cells = ordered_map(rows.blocks, cells_of, threads);
  std::size_t next = 0;
  while (std::optional<std::vector<Cell>> block = cells()) {
    const std::size_t width = block->size() / std::min<std::size_t>(SampleBlock::most_rows, places.rows.size() - next);
    for (std::size_t at = 0; at < block->size(); at += width) {
      const std::span row = std::span(*block).subspan(at, width);
      columns.align(row, given.row(places.rows[next]));
      use(places.rows[next++], row);
    }
  }
}

Distance distance(double given, double computed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::isnan(given) && std::isnan(computed)) return {};
  if (std::isnan(given) || std::isnan(computed)) return {infinity, infinity, std::numeric_limits<std::uint64_t>::max()};
  const double abs = std::abs(given - computed);
  const std::int64_t a = index_of(given), b = index_of(computed);
  const auto ulp = static_cast<std::uint64_t>(a > b ? a : b) - static_cast<std::uint64_t>(a > b ? b : a);
  return {abs, abs == 0 ? 0 : abs / std::abs(computed), ulp};
}

bool Limits::admit(const Distance& distance) const {
  if (distance.ulp == 0) return true;
  return (abs && distance.abs <= *abs) || (rel && distance.rel <= *rel) ||
         (ulp && static_cast<double>(distance.ulp) <= *ulp);
}

Limits limits_of(const Comparison& comparison, const std::string& column) {
  return {limit(comparison.abs, column), limit(comparison.rel, column), limit(comparison.ulp, column)};
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
