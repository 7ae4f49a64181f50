// Gap rows: how many rows of a curve lie between keys that are far apart.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "numbers/rational.hpp"
#include "sample/sampler.hpp"
#include "schema/curve_settings.hpp"

namespace tcb {

struct SampleBlock;

/// The rows in gaps, which are more than 30 times as long as the median of the first hundred steps between keys.
struct RowsInGaps {
  std::uint64_t rows;
  Time from, to;     ///< of the longest gap, as the keys were given
  Rational max_gap;  ///< below all of these gaps
};

/// Counts them as segments are made and rows are placed on them, in memory that does not grow with the curve.
class GapRows {
 public:
  /// `locator`: of the rows. `in_order`: rows follow each other, on the curve. `retiming`, then less `zero`: how the
  /// times of the keys were changed.
  GapRows(std::shared_ptr<const Locator> locator, bool in_order, Retiming retiming, Rational zero)
      : locator_(std::move(locator)), in_order_(in_order), retiming_(std::move(retiming)), zero_(std::move(zero)) {}

  /// The next times of keys; the first one ends the step before.
  void add_steps(std::span<const Time> times);
  void end_steps();
  void add_rows(const SampleBlock& block);

  /// Nothing where no row is in a gap. Requires: all steps and rows were added.
  std::optional<RowsInGaps> found();

 private:
  struct Segment {
    std::uint64_t number = 0;
    Time from, to;
    std::uint64_t rows = 0;

    double duration() const { return (to - from).hi; }
  };

  void take(const Segment& segment);
  std::uint64_t rows_between_keys(const CurveSegment& segment, std::uint64_t first, std::uint64_t last);

  std::shared_ptr<const Locator> locator_;
  bool in_order_;
  Retiming retiming_;
  Rational zero_;
  std::vector<double> steps_;       ///< the first ones, until the limit is known
  std::optional<double> limit_;     ///< of steps that are no gaps
  std::vector<Segment> undecided_;  ///< segments with rows, until then
  std::uint64_t rows_ = 0;          ///< in gaps
  Segment longest_;
  double least_ = 0;  ///< the duration of the shortest one with rows
  Located located_;
};

}  // namespace tcb
