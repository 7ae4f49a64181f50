// From keys to measured pieces of the curve: checked, linked to segments, and measured where lengths matter.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "input/input.hpp"
#include "stream/stream.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/window.hpp"

namespace tcb {

using Keys = spline::Keys<double>;
using Rules = spline::CurveRules<double>;
using Time = spline::Time<double>;

/// Successive segments with their lengths.
struct SegmentBlock {
  spline::Segments<double> segments;
  std::vector<spline::Length<double>> lengths;  ///< one a segment, or none where nobody asked
  bool last = false;                            ///< the curve ends here
  bool closes = false;                          ///< and is back at its first key
};

/// Keys with times where the input has none: key i + 1 follows key i after |P[i+1] - P[i]|^exponent, which is 1
/// for exponent 0. Throws: Error (data) naming both rows where that is no time at all.
Source<KeyBlock> parameterized(Source<KeyBlock> blocks, double exponent, std::vector<std::size_t> metric);

/// |b - a|^exponent over the metric channels (empty: all); 1 for exponent 0.
double parameter_step(std::span<const double> a, std::span<const double> b, double exponent,
                      std::span<const std::size_t> metric);

/// The keys, once it is seen that there are enough of them and that their ease is in [0, 1].
/// Requires: times that increase. Throws: Error (data) naming the rows.
Source<KeyBlock> checked(Source<KeyBlock> blocks, std::size_t least);

/// How many keys are linked at once: so few that the memory of their segments is soon used again, and stays near.
inline constexpr std::size_t keys_at_once = 512;

/// Keys ready to be linked to segments.
struct LinkedKeys {
  Source<Keys> keys;
  std::optional<Keys> context;  ///< of a closed curve: the key before the first
};

/// Sets the lengths of the segments.
void measure(SegmentBlock& block, const Rules& rules);

/// The segments between the keys, each as soon as the key after its end has come.
Source<SegmentBlock> segment_blocks(LinkedKeys keys, const Rules& rules, bool measured, unsigned threads = 1);

/// Throws: Error (data) where the length of the curve up to a time is beyond the range of doubles.
void require_length(const spline::DoubleDouble& length, const spline::Time<double>& end);

/// The lengths of all segments in order.
using Lengths = std::deque<spline::Length<double>>;  // it grows without a copy
Lengths all_lengths(const Source<SegmentBlock>& measured);

/// The length of the whole curve.
double total_length(const Lengths& lengths);

/// Stretches that were not measured, with the lengths that are known of their segments.
Source<SegmentBlock> with_lengths(Source<SegmentBlock> segment_blocks, Lengths lengths);

}  // namespace tcb
