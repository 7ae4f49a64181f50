// Exact rows: every number of a row as exact arithmetic gives it, rounded once.
//
// The fast rows decide which rows there are, and on which segment each of them lies. A number is tried in this order:
//   - where it is rational, or the root of a rational: with a proved bound on its error (Bounded); exactly, where it is
//     the same all along the segment, or as a rational;
//   - others, such as lengths, numbers at a length and rotations: as a double-double, then as floats of 192 and of 448
//     bits, by the templates that compute the fast rows. The error of each is estimated by its distance from the result
//     in fewer digits, and by how far the error of a length moves the place (PlaceError). What the floats do not tell
//     from 0, or from a simple fraction (simple_fraction()), is that.
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

  /// The cells of a block, row after row, as tcb::evaluate gives them. Threads: any number, each with an evaluation
  /// of its own; of rows by length, whose lengths are kept for later ones, one. Throws: Error (data) for a number
  /// beyond the range of doubles, or one that needs more digits than there are.
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
