// Golden rows: every number of a row is what exact arithmetic gives, rounded once.
//
// The fast path says which rows there are, and on which segment each of them lies. A number is worked out in floats of
// more and more digits, until what a float gives and what one of twice its digits gives leave no choice of the
// rounding. Where the first two leave one, and the number is rational or the root of a rational, it is worked out as
// that.
// Source: A. Ziv, "Fast evaluation of elementary mathematical functions with correctly rounded last bit",
//   doi:10.1145/114697.116813.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "curve/rows.hpp"
#include "exact/exact_keys.hpp"
#include "output/layout.hpp"

namespace tcb {

/// Whether a field of this name has a golden value.
bool has_field(std::string_view name);

/// The rows of one curve.
class GoldenRows {
 public:
  /// The rows of a request that are placed on a curve of this extent.
  GoldenRows(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& notation);
  ~GoldenRows();

  /// The cells of a batch, row after row, as tcb::evaluate gives them. Threads: one.
  /// Throws: Error (data) for a number beyond the range of doubles, or that more digits are needed for than there are.
  Table evaluate(const SampleBlock& batch, const Locator& locator, std::span<const std::size_t> chosen);

 private:
  class Evaluation;
  std::unique_ptr<Evaluation> evaluation_;
};

}  // namespace tcb
