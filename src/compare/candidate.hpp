// Candidates: how well each convention agrees with someone's samples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/check.hpp"
#include "compare/convention.hpp"
#include "compare/lookup.hpp"
#include "compare/samples.hpp"

namespace tcb {

struct Candidate {
  Convention convention;
  double largest = 0;                              ///< error of a position
  std::array<double, precisions.size()> excess{};  ///< the largest error in allowances of each precision
  std::uint64_t rows_off = 0;                      ///< rows with an error beyond them all
  std::optional<Difference> first, worst;          ///< in the first of these; and the largest of all
};

/// Compares the rows of samples with conventions. It looks into what it was made from.
class Comparer {
 public:
  Comparer(const Job& plan, const ComparisonInputs& sides, const std::vector<TcbOrders>& orders, bool closed);

  Candidate compare(const Convention& convention, const std::vector<GivenSamples>& samples) const;

  /// Where the rows of a sample are on the keys' curve under a convention; an arc length beyond its end is there.
  Places places(const GivenSamples& sample, const IndexedCurve& whole) const;
  IndexedCurve whole(const KeptCurve& curve, const Convention& convention) const;

 private:
  void compare_row(Candidate& candidate, const GivenSamples& sample, std::size_t row,
                   std::span<const Cell> cells) const;

  const Job& plan_;
  const ComparisonInputs& sides_;
  const std::vector<TcbOrders>& orders_;
  bool closed_;
  SamplingRequest request_;
};

/// The candidates in the order of how well they agree: those that fit and cannot be told apart, the most usual first;
/// then those that are off in a quarter of the rows at most, by their number; then the others; each by the largest
/// error.
struct Ranking {
  std::vector<Candidate> candidates;
  std::size_t fitting = 0;
  std::optional<std::size_t> precision;  ///< index into precisions, with which they fit
};
Ranking ranked(std::vector<Candidate> candidates, std::uint64_t rows, bool closed);

}  // namespace tcb
