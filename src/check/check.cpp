// Check: rows paired with curves, their distances from the computed numbers, and the limits for these.
#include "check/check.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "check/coverage.hpp"
#include "check/errors.hpp"
#include "check/problems.hpp"
#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "sample/look_up.hpp"
#include "sample/rows.hpp"
#include "schema/key_block.hpp"
#include "stream/ordered_map.hpp"

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

Pairs pairs_by_group(const KeptCurves& kept, SampleTable& table) {
  const std::vector<std::string>& names = kept.schema.groups;
  Pairs result;
  std::vector<bool> taken(table.curves.size());
  for (const KeptCurve& curve : kept.curves) {
    const auto wanted = contents(curve.group);
    SampleRows rows;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (taken[i] || contents(table.curves[i].group) != wanted) continue;
      taken[i] = true;
      rows = std::move(table.curves[i]);
      break;
    }
    if (rows.size() == 0)
      result.problems.push_back(curve_without_rows(group_title(names, curve.group)));
    else
      result.pairs.push_back({&curve, std::move(rows)});
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) continue;
    const SampleRows& rows = table.curves[i];
    result.problems.push_back(rows_without_curve(group_title(names, rows.group), rows.lines.at(0)));
  }
  return result;
}

}  // namespace

Pairs pair_up(const KeptCurves& kept, SampleTable& table) {
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
    result.problems.push_back(curve_counts_differ(table.curves.size(), kept.curves.size(), both));
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
                 const WholeCurve& curve, const Limits& limits) {
  const Time first = columns.by_length ? Time(0.0) : curve.extent.first;
  const Time last = columns.by_length ? Time(curve.curve->curve().length().value) : *curve.extent.last;
  const auto is_extended_to = [&](const Time& place) {
    const auto& [before, after] = curve.extrapolations;
    return !columns.by_length && (place < first ? before : after) != Extrapolation::error;
  };
  Places result;
  std::uint64_t off_curve = 0;
  std::pair<std::size_t, Time> first_off;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Time place = columns.place               ? Time(rows.numbers[row * table.columns.size() + *columns.place])
                 : curve.extent.decimals > 0 ? with_all_digits(rows.times[row])
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
    result.off_curve = has_place ? rows_off_curve(off_curve, rows.lines[row], columns.by_length, time_text(place),
                                                  time_text(place < first ? first : last))
                                 : rows_without_place(off_curve, rows.lines[row]);
  }
  return result;
}

void for_each_row(const SampleRows& given, const Places& places, const MatchedColumns& columns, const WholeCurve& curve,
                  spline::Side side, unsigned threads,
                  const std::function<void(std::size_t, std::span<const Cell>)>& use) {
  const auto place = [&places](std::uint64_t row) { return places.places[row]; };
  const auto evaluate_all = [&](const auto& locator) {
    const auto cells_of = [&columns, locator](const SampleBlock& block) {
      return evaluate(block, *locator, columns.fields);
    };
    return ordered_map(look_up(curve.curve, locator, side), cells_of, threads);
  };
  const std::uint64_t rows = places.places.size();
  const auto cells =
      columns.by_length
          ? evaluate_all(std::make_shared<const AnywhereInLength>(place, rows, curve.curve->curve().length().value))
          : evaluate_all(std::make_shared<const AnywhereInTime>(place, rows, curve.extrapolations, curve.extent.first,
                                                                *curve.extent.last, curve.curve->frames()));
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

namespace {

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
  for (const auto& [name, tolerances] :
       {std::pair{option::abs, &comparison.abs}, std::pair{option::rel, &comparison.rel},
        std::pair{option::ulp, &comparison.ulp}}) {
    for (const Tolerance& tolerance : *tolerances) {
      if (tolerance.column.empty() || std::ranges::count(known, tolerance.column) > 0) continue;
      throw tolerance_of_unknown_column(tolerance.column, known).about(name);
    }
  }
}

/// Compares which rows there are. Rows of provenance that these keys do not make are unknown.
void check_coverage(const Pair& pair, const Comparison& comparison, const ComparisonInputs& inputs,
                    const WholeCurve& curve, const Places& found, const Limits& limits, Check& result) {
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
  if (problem) result.problems.push_back(of_curve(coverage.curve, *problem));
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
  const WholeCurve curve = pipeline.whole(pair.curve->keys());
  const Limits limits = limits_of(comparison, inputs.place_name());
  const Places places = places_of(pair.rows, inputs.table, columns, curve, limits);
  if (places.off_curve) result.problems.emplace_back(*places.off_curve);
  for_each_row(pair.rows, places, columns, curve, side, inputs.threads,
               [&](std::size_t row, auto cells) { checker.compare_row(pair.rows, row, cells); });
  check_coverage(pair, comparison, inputs, curve, places, limits, result);
  if (observe) observe({inputs, pipeline, *pair.curve, pair.rows, curve, places, side});
}

}  // namespace

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

Check check(const Comparison& comparison, const std::function<void(const CheckedPair&)>& observe,
            FileProgress* progress) {
  return check(comparison, read_inputs(comparison, comparison.fields, progress), observe);
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
