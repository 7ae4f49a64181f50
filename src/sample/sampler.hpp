// Samplers: which samples lie on a segment of the curve, and where exactly.
//
// A sampler gets the segments once, in order. Locating a sample on its segment is then a pure function, so samples can
// be evaluated in any order, on any thread.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "sample/curve_segment.hpp"
#include "sample/grid.hpp"
#include "tcb/spline/segment_length.hpp"

namespace tcb {

/// The numbers of two rows that are not on the grid, for locate(): at the segment's first key, and at the end of the
/// range.
struct SpecialRow {
  static constexpr std::uint64_t at_key = std::numeric_limits<std::uint64_t>::max() - 1;
  static constexpr std::uint64_t at_end = std::numeric_limits<std::uint64_t>::max();
};

/// The rows on a segment in order: its key if requested, those from first to before last, the end if requested.
struct SegmentRows {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  bool key = false;
  bool end = false;
};

/// Located samples, and the memory that locating needs.
struct Located {
  std::vector<Sample> samples;
  std::vector<Sample> ends = {};       ///< of the pieces that begin at the samples, or none where rows are samples
  std::vector<Outside> outside = {};   ///< one per sample, or none where all samples must be on the curve
  std::vector<Motion> motions = {};    ///< one per sample, or none where samples move as the curve does
  std::vector<Time> coordinates = {};  ///< the times or arc lengths of the samples
  std::vector<spline::LocalParameter<double>> places = {};
  spline::SegmentLength<double> arc = {};
};

/// The exact times of a row and of the end of its piece, where they have more digits than those of the samples.
struct ExactTimes {
  std::optional<Rational> time = {}, end_time = {};
};

struct ExactKeyTimes {
  Rational start, end;
};

/// Locates samples on the segment on which they lie.
class Locator {
 public:
  Locator() = default;
  Locator(const Locator&) = delete;
  Locator& operator=(const Locator&) = delete;
  virtual ~Locator() = default;

  /// Replaces the samples in `located` with those from first to before last. Requires: they lie on this segment.
  /// Threads: any number at once, each with its own memory.
  virtual void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const = 0;

  /// The exact times of a row that locate() places by time, where they are known. `keys`: null where distances make the
  /// times of keys.
  virtual ExactTimes exact_times(std::uint64_t row, const ExactKeyTimes* keys) const = 0;

 protected:
  /// Samples that are located one by one.
  template <class At>
  static void fill(Located& located, std::uint64_t first, std::uint64_t last, At at) {
    located.samples.clear();
    for (std::uint64_t row = first; row != last; ++row) located.samples.push_back(at(row));
  }
};

/// Places samples segment after segment.
class Sampler : public Locator {
 public:
  /// The rows on the next segment. Throws: Error if the request leaves the curve or has too many rows.
  virtual SegmentRows place(const CurveSegment& segment) = 0;

  /// No later segment can have a sample: reading may stop.
  virtual bool done() const = 0;

  /// How far the end of the range is from the last row, once all segments were placed; nothing if it is a row.
  virtual std::optional<Rational> remainder() const { return std::nullopt; }
};

/// Requires: a mode whose rows are in the order of the segments. Throws: Error if the request does not fit the curve.
std::unique_ptr<Sampler> make_sampler(const SamplingRequest& request, const Extent& extent);

/// Locates the samples at the arc lengths in located.coordinates, which lie on the segment. Promises: their times are
/// rounded once; a length that is printed as that of a key is the key's.
void locate_lengths(const CurveSegment& segment, Located& located);

}  // namespace tcb
