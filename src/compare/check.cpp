// The check: someone's samples against the curve, number by number.
#include "compare/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "compare/lookup.hpp"
#include "compare/pairs.hpp"
#include "compare/sides.hpp"
#include "error.hpp"

namespace tcb {
namespace {

/// Compares the rows of one curve after another.
class Checker {
 public:
  Checker(const ComparisonInputs& sides, const Comparison& comparison, Check& result)
      : table_(sides.table), columns_(sides.columns), result_(result) {
    for (const MatchedColumn& column : columns_.compared) {
      limits_.push_back(limits_of(comparison, column.name));
      result.columns.push_back({column.name, 0, {}});
    }
  }

  void compare_row(const SampleRows& rows, std::size_t row, std::span<const Cell> cells) {
    ++result_.rows;
    for (std::size_t i = 0; i < columns_.compared.size(); ++i) {
      const MatchedColumn& column = columns_.compared[i];
      const Cell& cell = cells[column.ours];
      const double ours = is_empty(cell) ? std::numeric_limits<double>::quiet_NaN() : cell.hi;
      const double theirs = rows.numbers[row * table_.columns.size() + column.theirs];
      ++result_.values;
      const Distance found = distance(theirs, ours);
      if (!std::isnan(theirs) && !std::isnan(ours)) widen(result_.columns[i].largest, found);
      if (limits_[i].admit(found)) continue;
      ++result_.mismatches;
      ++result_.columns[i].mismatches;
      note({row + 1, rows.lines[row], column.name, theirs, ours, found});
    }
  }

 private:
  static void widen(Distance& largest, const Distance& found) {
    largest.abs = std::max(largest.abs, found.abs);
    largest.rel = std::max(largest.rel, found.rel);
    largest.ulp = std::max(largest.ulp, found.ulp);
  }

  void note(Difference difference) {
    if (!result_.first || difference.line < result_.first->line) result_.first = difference;
    if (!result_.worst || difference.distance.abs > result_.worst->distance.abs) result_.worst = std::move(difference);
  }

  const SampleTable& table_;
  const MatchedColumns& columns_;
  Check& result_;
  std::vector<Limits> limits_;
};

/// Throws: Error (usage) for a tolerance of a column that is not compared.
void require_columns(const Comparison& comparison, const ComparisonInputs& sides) {
  std::vector<std::string> known{sides.place_name()};
  for (const MatchedColumn& column : sides.columns.compared) known.push_back(column.name);
  for (const auto& [option, tolerances] : {std::pair{"--abs", &comparison.abs}, std::pair{"--rel", &comparison.rel},
                                           std::pair{"--ulp", &comparison.ulp}}) {
    for (const Tolerance& tolerance : *tolerances) {
      if (tolerance.column.empty() || std::ranges::count(known, tolerance.column) > 0) continue;
      throw Error(Exit::usage, fmt::format("{}: no column \"{}\" is compared; expected some of {}; correct it", option,
                                           tolerance.column, fmt::join(known, ", ")));
    }
  }
}

/// Compares the rows of one curve.
void check_pair(const Pair& pair, const Job& plan, const ComparisonInputs& sides, Checker& checker, Check& result) {
  const MatchedColumns& columns = sides.columns;
  SamplingRequest request = plan.sampling;
  request.mode = columns.by_length ? Mode::arc_at : Mode::at;
  const CurvePipeline path(request, plan.curve, columns.fields, std::nullopt, sides.kept.input,
                           *pair.curve->curve_info);
  const IndexedCurve whole = path.whole(pair.curve->keys());
  const Places places =
      places_of(pair.rows, sides.table, columns, whole, limits_of(*plan.comparison, sides.place_name()));
  if (!places.off_curve.empty()) result.problems.push_back(off_curve(places, pair.rows));
  for_each_row(places, columns, whole, request.from_left, sides.threads,
               [&](std::size_t row, auto cells) { checker.compare_row(pair.rows, row, cells); });
}

}  // namespace

Check check(const Job& plan) {
  ComparisonInputs sides = read_sides(plan, plan.fields);
  require_columns(*plan.comparison, sides);
  const Pairs pairs = pair_up(sides.kept, sides.table);
  Check result{compared(sides, pairs)};
  Checker checker(sides, *plan.comparison, result);
  for (const Pair& pair : pairs.pairs) {
    in_file(sides.keys, [&] { check_pair(pair, plan, sides, checker, result); });
  }
  return result;
}

}  // namespace tcb
