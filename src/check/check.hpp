// Check: rows paired with curves, their distances from the computed numbers, and the limits for these.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check/compare_job.hpp"
#include "check/inputs.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

class CurvePipeline;
class KeptCurve;

/// The distance of a given number from the computed one; a missing number is NaN.
struct Distance {
  double abs = 0;         ///< |given - computed|; infinite beyond the range of doubles, or if one of them is missing
  double rel = 0;         ///< abs / |computed|; infinite if only the computed number is 0
  std::uint64_t ulp = 0;  ///< number of steps between neighbouring doubles; 0 and -0 are equal
};

/// Two missing numbers are equal.
Distance distance(double given, double computed);

/// Limits of a column: a number is accepted if it is within any of those given.
struct Limits {
  std::optional<double> abs, rel, ulp;

  bool admit(const Distance& distance) const;
};

/// For each measure the column's own tolerance, else the one for all columns. Without any, only equal numbers are
/// accepted.
Limits limits_of(const Comparison& comparison, const std::string& column);

/// A given number that differs from the computed one.
struct Difference {
  std::uint64_t row = 0, line = 0;  ///< among the rows of the curve, from 1; in the file
  std::string column;
  double given = 0, computed = 0;  ///< NaN if missing
  Distance distance;
};

/// The parts of a result that all comparisons have.
struct ComparisonSummary {
  std::string file, keys;             ///< names of the files of samples and of keys
  bool by_length = false;             ///< the samples are at arc lengths
  std::vector<std::string> ignored;   ///< names of columns that are intentionally not compared
  std::vector<std::string> problems;  ///< of columns, curves and rows, besides the numbers
};

struct ColumnCheck {
  std::string name;
  std::uint64_t mismatches = 0;
  Distance largest;  ///< in each measure, over all rows where neither number is missing
};

/// The part of a curve that its rows cover.
struct Coverage {
  std::vector<std::string> curve;                     ///< NAME=VALUE for each column of its group
  std::string place;                                  ///< the column of times or arc lengths
  Time first = {}, last = {};                         ///< of the curve
  std::optional<std::pair<Time, Time>> covered = {};  ///< the first and the last row on the curve
  std::uint64_t rows = 0;                             ///< on the curve
  std::optional<std::uint64_t> expected_rows = {};    ///< if it is known
};

struct Check : ComparisonSummary {
  std::uint64_t rows = 0, values = 0, mismatches = 0;
  std::vector<ColumnCheck> columns = {};
  std::vector<Coverage> coverage = {};               ///< of each curve that has rows
  std::optional<Difference> first = {}, worst = {};  ///< the worst: the largest absolute distance

  bool passed() const { return mismatches == 0 && problems.empty(); }
};

// Its report as text and as a JSON object, and its result in a line, as a subtitle of a picture.
std::string text(const Check& check);
std::string json(const Check& check);
std::string in_short(const Check& check);

/// A curve and its given rows.
struct Pair {
  const KeptKeys* curve;
  SampleRows rows;
};

struct Pairs {
  std::vector<Pair> pairs;
  std::vector<std::string> problems;  ///< curves without rows, rows without a curve
};

/// Pairs curves and rows by their groups if both have them, else by their order; a single curve takes all rows.
Pairs pair_up(const KeptInput& kept, SampleTable& table);

/// The parts of a result that all comparisons have.
ComparisonSummary summary(const ComparisonInputs& inputs, const Pairs& pairs);

/// The places of rows on a curve.
struct Places {
  std::vector<std::size_t> rows;
  std::vector<Time> places;              ///< of these rows
  std::optional<std::string> off_curve;  ///< if other rows are not on the curve: how many, and the first of them
};

/// Where rows lie on a curve. A place before or after the curve, but within `limits` of its end, counts as that end.
Places places_of(const SampleRows& rows, const SampleTable& table, const MatchedColumns& columns,
                 const KeptCurve& curve, const Limits& limits);

/// Calls `use` for each of the rows, in order, with its cells. They are aligned with the given row. Throws: Error
/// (data) for a number beyond the range.
void for_each_row(const SampleRows& given, const Places& places, const MatchedColumns& columns,
                  const std::shared_ptr<const KeptCurve>& curve, spline::Side side, unsigned threads,
                  const std::function<void(std::size_t row, std::span<const Cell> cells)>& use);

/// A curve with the places of its samples, as it is compared.
struct CheckedPair {
  const ComparisonInputs& inputs;
  const CurvePipeline& pipeline;
  const KeptKeys& curve;
  const SampleRows& rows;
  const std::shared_ptr<const KeptCurve>& indexed;
  const Places& places;
  spline::Side side;  ///< of a key, the segment on which a row there is
};

/// Compares every number of the samples with the curve. `observe` sees each curve with its samples, if it is given.
/// Throws: Error if the keys make no curve, or there is nothing to compare.
Check check(const Comparison& comparison, ComparisonInputs inputs,
            const std::function<void(const CheckedPair& pair)>& observe = {});

}  // namespace tcb
