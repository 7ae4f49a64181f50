// Ranking: comparing samples with all conventions, which of these fit, and in which order they are listed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/conventions.hpp"
#include "check/inputs.hpp"

namespace tcb {

/// A convention, and how well it agrees with the samples.
struct Candidate {
  Convention convention;
  double largest = 0;          ///< error of a position
  double excess = 0;           ///< the largest error beyond rounding, as a part of what is allowed
  std::uint64_t rows_off = 0;  ///< rows with an error beyond what is allowed
  std::optional<Difference> first = {}, worst = {};  ///< of the first of these rows; the largest of all
};

/// The candidates by agreement: those that fit and are equivalent here, the most usual first; then those that are off
/// in at most a quarter of the rows, by the number of these rows; then the others; each part by the largest error.
struct Ranking {
  std::vector<Candidate> candidates;
  std::size_t fitting = 0;
};
Ranking ranked(std::vector<Candidate> candidates, std::uint64_t rows, const ComparedParts& parts);

struct Identification : ComparisonSummary {
  ComparedParts parts = {};
  std::uint64_t rows = 0;              ///< number of rows compared
  std::vector<TcbOrders> orders = {};  ///< the orders that differ for these keys
  std::uint64_t conventions = 0;       ///< number of conventions compared
  Ranking ranking = {};

  bool fits() const { return ranking.fitting > 0; }
};

// Its report, as that of a check.
std::string text(const Identification& found);
std::string json(const Identification& found);
std::string in_short(const Identification& found);

/// Compares the positions with those of every convention. Throws: Error as check().
Identification identify(const Comparison& comparison, ComparisonInputs inputs);

/// Reads both files, and drops what is not a position. Throws: Error, naming the file.
ComparisonInputs read_positions(const Comparison& comparison, FileProgress* progress = nullptr);

/// Compares the samples with the best convention. `observe` as for check().
Check check_best(const Comparison& comparison, const Identification& found, ComparisonInputs inputs,
                 const std::function<void(const CheckedPair& pair)>& observe);

}  // namespace tcb
