// Exact rows: every number of a row as exact arithmetic gives it, rounded once.
//
// The fast rows decide which rows there are, and on which segment each of them lies. The numbers are computed in balls
// of double-doubles, and where their bounds leave a choice of the rounding, in rationals if they are rational or roots
// of rationals. What remains is computed in balls of more and more digits, until no choice is left. Lengths, angles and
// rotations are irrational, and no ball proves that one is 0, or halfway between two doubles: what some 400 digits
// beyond the size of the curve do not distinguish from 0, or from a short number, is that. A number that is 0 so at
// eleven places of a segment is 0 all along it, also where the place of a row is known to fewer digits. Source: A. Ziv,
// "Fast evaluation of elementary mathematical functions with correctly rounded last bit", doi:10.1145/114697.116813.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "exact/exact_keys.hpp"
#include "numbers/print_number.hpp"
#include "sample/request.hpp"
#include "sample/table.hpp"

namespace tcb {

class Locator;

/// The correctly rounded rows of one curve.
class ExactRows {
 public:
  /// For the rows of a request that are placed on a curve of this extent.
  ExactRows(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& notation);
  ~ExactRows();

  /// The cells of a block, row after row, as tcb::evaluate gives them. Threads: any number, each with levels of its
  /// own; of rows by length, whose lengths are kept for later ones, one. Throws: Error (data) for a number beyond the
  /// range of doubles, or one that needs more digits than there are.
  Table evaluate(const SampleBlock& block, const Locator& locator, std::span<const std::size_t> chosen);

 private:
  struct Request;
  class Evaluation;

  std::unique_ptr<Evaluation> take(std::span<const std::size_t> chosen);
  void give_back(std::unique_ptr<Evaluation> evaluation);

  const std::unique_ptr<const Request> request_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Evaluation>> idle_;
};

}  // namespace tcb
