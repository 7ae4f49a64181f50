// A sampler says which samples lie on a piece of the curve, and where exactly.
//
// It sees the pieces once, in order; locating a sample on its piece is then a pure function, so that
// samples can be worked out anywhere, in any order.
// To add a sampler: a file beside this one, and a line in make_sampler.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sampling/extrapolation.hpp"
#include "sampling/spacing.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/ease.hpp"

namespace tcb {

/// A segment with its place in the curve. Lengths are 0 where nobody asked for them.
struct CurveSegment {
  Time start, end;                                ///< times of its two keys
  spline::DoubleDouble s_start, s_end;            ///< arc lengths of its two keys, from the curve's first
  std::span<const spline::Cubic<double>> cubics;  ///< one a channel
  std::span<const std::size_t> metric;            ///< the channels that lengths are over; empty: all
  bool last = false;                              ///< the curve ends here
  spline::Warp<double> warp = {};                 ///< of its local parameter
  std::span<const double> cycle = {};             ///< last key - first key, where that is wanted; one a channel
  std::uint64_t number = 0;                       ///< of the segment, from 0
  double s_error = 0;                             ///< bound on the error of s_end
  std::uint64_t end_key = number + 1;             ///< of the key at its end, 0 where a closed curve is back
};

/// Rows on a piece, by their numbers. Besides those of the grid there are rows at the piece's first key and
/// at the end of the range.
struct Row {
  static constexpr std::uint64_t at_key = std::numeric_limits<std::uint64_t>::max() - 1;
  static constexpr std::uint64_t at_end = std::numeric_limits<std::uint64_t>::max();
};

/// The rows on a piece in order: its key if wanted, those from first to before last, the end if wanted.
struct Run {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  bool key = false;
  bool end = false;
};

/// Where a sample is: its time, its place on the segment, and its arc length where that was asked for.
struct Sample {
  Time t;
  spline::LocalParameter<double> at;
  std::optional<double> s = std::nullopt;
};

/// Samples that were located, and the memory that locating needs.
struct Located {
  std::vector<Sample> samples;
  std::vector<Outside> outside = {};   ///< how their times relate to those on the curve; none where all must be on it
  std::vector<Time> coordinates = {};  ///< the times or arc lengths at which they are to be
  std::vector<spline::LocalParameter<double>> places = {};
  spline::ArcLength<double> arc = {};
};

/// Says where exactly a sample is on the piece that it lies on.
class Locator {
 public:
  Locator() = default;
  Locator(const Locator&) = delete;
  Locator& operator=(const Locator&) = delete;
  virtual ~Locator() = default;

  /// Puts the samples from first to before last in the place of those located before. Requires: they lie on this
  /// piece. Threads: any number at once, each with memory of its own.
  virtual void locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const = 0;

 protected:
  /// Samples that are located one by one.
  template <class At>
  static void fill(Located& located, std::uint64_t first, std::uint64_t last, At at) {
    located.samples.clear();
    for (std::uint64_t row = first; row != last; ++row) located.samples.push_back(at(row));
  }
};

/// Places samples while the curve goes by.
class Sampler : public Locator {
 public:
  /// The rows on the next piece. Throws: Error if the request leaves the curve or asks too much.
  virtual Run place(const CurveSegment& piece) = 0;

  /// No later piece can hold a sample: reading may stop.
  virtual bool done() const = 0;

  /// How far the end of the range lies behind the last row, once all pieces were placed.
  virtual std::optional<Rational> left_out() const { return std::nullopt; }
};

/// Requires: not needs_curve(mode). Throws: Error where the request does not fit the curve.
std::unique_ptr<Sampler> make_sampler(const SamplingRequest& request, const Extent& extent);

}  // namespace tcb
