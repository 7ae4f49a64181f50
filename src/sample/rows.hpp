// From segments of the curve to rows: which samples lie on each, and the cells of their rows.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sample/curve_segment.hpp"
#include "sample/table.hpp"
#include "stream/source.hpp"
#include "tcb/spline/curve_keys.hpp"

namespace tcb {

class Locator;
class Sampler;
struct SegmentBlock;

/// Samples on successive segments, few enough to be evaluated at once.
struct SampleBlock {
  struct Part {
    CurveSegment segment;
    std::uint64_t first, last;  ///< rows from first to before last
  };
  std::shared_ptr<const void> owner;  ///< owns what the segments refer to
  std::vector<Part> parts;
  bool first = false;  ///< there is no row before these

  static constexpr std::uint64_t most_rows = 1024;
  std::uint64_t rows() const;
};

/// The samples of a curve in order, in blocks, each as soon as its segments are known. `side`: of a place between two
/// parts of an ease, that on which a row there is.
Source<SampleBlock> place(Source<SegmentBlock> segments, std::shared_ptr<Sampler> sampler, CurveChannels channels,
                          spline::Side side = spline::Side::right);

/// The cells of a block, row after row. A pure function. Throws: Error (data) for a number beyond
/// the range of doubles.
std::vector<Cell> evaluate(const SampleBlock& block, const Locator& locator, std::span<const std::size_t> chosen);

/// The rows that evaluate() makes.
Evaluate fast_rows(std::shared_ptr<const Locator> locator);

/// The same rows, but cells of a channel are empty where it has a gap. At a key its position is shown.
Evaluate without_gaps(Evaluate evaluate, std::shared_ptr<const Locator> locator,
                      const std::vector<spline::ChannelGap>& gaps);

/// Throws: Error (data) for a number in the row of a sample.
[[noreturn]] void refuse_overflow(const Sample& sample);

}  // namespace tcb
