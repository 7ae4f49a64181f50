// Check: distances between given and computed numbers, limits for them, and the check of all samples.
#include "compare/check.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "compare/match.hpp"
#include "error.hpp"

namespace tcb {
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
      : table_(inputs.table), columns_(inputs.columns), result_(result) {
    for (const MatchedColumn& column : columns_.compared) {
      limits_.push_back(limits_of(comparison, column.name));
      result.columns.push_back({column.name, 0, {}});
    }
  }

  void compare_row(const SampleRows& rows, std::size_t row, std::span<const Cell> cells) {
    ++result_.rows;
    for (std::size_t i = 0; i < columns_.compared.size(); ++i) {
      const MatchedColumn& column = columns_.compared[i];
      const Cell& cell = cells[column.computed];
      const double computed = is_empty(cell) ? std::numeric_limits<double>::quiet_NaN() : cell.hi;
      const double given = rows.numbers[row * table_.columns.size() + column.given];
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

  const SampleTable& table_;
  const MatchedColumns& columns_;
  Check& result_;
  std::vector<Limits> limits_;
};

/// Throws: Error (usage) for a tolerance of a column that is not compared.
void require_columns(const Comparison& comparison, const ComparisonInputs& inputs) {
  std::vector<std::string> known{inputs.place_name()};
  for (const MatchedColumn& column : inputs.columns.compared) known.push_back(column.name);
  for (const auto& [option, tolerances] :
       {std::pair{Option::abs, &comparison.abs}, std::pair{Option::rel, &comparison.rel},
        std::pair{Option::ulp, &comparison.ulp}}) {
    for (const Tolerance& tolerance : *tolerances) {
      if (tolerance.column.empty() || std::ranges::count(known, tolerance.column) > 0) continue;
      throw Error(Exit::usage, ErrorCode::tolerance_of_other_column, {tolerance.column, known}).about(option);
    }
  }
}

/// Compares the rows of one curve.
void check_pair(const Pair& pair, const Job& job, const ComparisonInputs& inputs, Checker& checker, Check& result) {
  const MatchedColumns& columns = inputs.columns;
  SamplingRequest request = job.sampling;
  request.mode = columns.by_length ? Mode::arc_at : Mode::at;
  const CurvePipeline pipeline(request, job.curve, columns.fields, std::nullopt, inputs.kept.input,
                               *pair.curve->curve_info);
  const IndexedCurve curve = pipeline.whole(pair.curve->keys());
  const Places places =
      places_of(pair.rows, inputs.table, columns, curve, limits_of(*job.comparison, inputs.place_name()));
  if (places.off_curve) result.problems.emplace_back(*places.off_curve);
  for_each_row(places, columns, curve, request.from_left, inputs.threads,
               [&](std::size_t row, auto cells) { checker.compare_row(pair.rows, row, cells); });
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

Check check(const Job& job) {
  ComparisonInputs inputs = read_inputs(job, job.fields);
  require_columns(*job.comparison, inputs);
  const Pairs pairs = pair_up(inputs.kept, inputs.table);
  Check result{summary(inputs, pairs)};
  Checker checker(inputs, *job.comparison, result);
  for (const Pair& pair : pairs.pairs) {
    in_file(inputs.keys, [&] { check_pair(pair, job, inputs, checker, result); });
  }
  return result;
}

}  // namespace tcb
