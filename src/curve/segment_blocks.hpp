// From keys to measured pieces of the curve: checked, linked to segments, and measured where lengths matter.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "keys/key_store.hpp"
#include "stream/stream.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/window.hpp"
#include "text/time.hpp"

namespace tcb {

using Rules = spline::CurveRules<double>;

/// Successive segments with their lengths.
struct SegmentBlock {
  spline::Segments<double> segments;
  std::vector<spline::Length<double>> lengths;  ///< one a segment, or none where nobody asked
  bool last = false;                            ///< the curve ends here
  bool closes = false;                          ///< and is back at its first key
};

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
