// Gap rows: how many rows of a curve lie between keys that are far apart.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "numbers/rational.hpp"
#include "sample/sampler.hpp"

namespace tcb {

struct SampleBlock;
struct SegmentBlock;

/// The rows in gaps, which are more than 30 times as long as the median of the first hundred steps between keys.
struct RowsInGaps {
  std::uint64_t rows = 0, gaps = 0;
  Time from, to;     ///< of the longest gap
  Rational max_gap;  ///< below all of these gaps
};

/// Counts them as segments are made and rows are placed on them, in memory that does not grow with the curve.
class GapRows {
 public:
  /// `locator`: of the rows.
  explicit GapRows(std::shared_ptr<const Locator> locator) : locator_(std::move(locator)) {}

  /// The next step between keys.
  void add_step(const Time& from, const Time& to);
  void add_steps(const SegmentBlock& block);
  void add_rows(const SampleBlock& block);

  /// Nothing where no row is in a gap. Requires: all steps and rows were added.
  std::optional<RowsInGaps> found();

 private:
  struct Segment {
    std::uint64_t number;
    Time from, to;
    std::uint64_t rows;

    double duration() const { return (to - from).hi; }
  };

  void set_limit();
  void take(const Segment& segment);
  std::uint64_t rows_between_keys(const CurveSegment& segment, std::uint64_t first, std::uint64_t last);

  std::shared_ptr<const Locator> locator_;
  std::vector<double> steps_;       ///< the first ones, until the limit is known
  std::optional<double> limit_;     ///< of steps that are no gaps
  std::vector<Segment> undecided_;  ///< segments with rows, until then
  std::optional<Segment> last_;     ///< the last gap with rows
  double least_ = 0;                ///< the shortest one
  RowsInGaps found_;
  Located located_;
};

}  // namespace tcb
