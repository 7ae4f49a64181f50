// Check: compares every number of given rows with the computed one, and the rows with those that are expected.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check/compare_job.hpp"
#include "check/distance.hpp"
#include "check/inputs.hpp"
#include "check/pairs.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

class CurvePipeline;
class KeptCurve;

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

/// The parts of a result that all comparisons have.
ComparisonSummary summary(const ComparisonInputs& inputs, const Pairs& pairs);

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
