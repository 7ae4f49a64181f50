// From keys to segments with their lengths: open, closed and sparse curves, streamed and kept.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "keys/key_store.hpp"
#include "sample/curve_segment.hpp"
#include "sample/curve_spec.hpp"
#include "sample/extrapolation.hpp"
#include "sample/request.hpp"
#include "schema/curve_channels.hpp"
#include "stream/source.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/segments.hpp"

namespace tcb::spline {
struct BuildError;
template <class S>
class Curve;
}  // namespace tcb::spline

namespace tcb {

using Rules = spline::CurveRules<double>;

/// Successive segments with their lengths.
struct SegmentBlock {
  spline::Segments<double> segments;
  std::vector<spline::Length<double>> lengths;  ///< one per segment, or none if the curve is not measured
  bool last = false;                            ///< the curve ends here
  bool closes = false;                          ///< the last segment ends at the first key of a closed curve
};

struct SegmentOptions {
  bool measured = false;  ///< with their lengths
  bool expanded =
      false;  ///< where keys lack positions, cubics are expanded parts of those between a channel's own keys
  unsigned threads = 1;
  std::optional<FrameTimes> frames = {};      ///< where the times of the keys are frames in seconds
  std::vector<spline::ChannelGap> gaps = {};  ///< of channels that lack positions
};

/// The error for a fault that the library found in keys, by their lines and channels.
Error curve_error(const spline::BuildError& error, const KeyStore& keys, const std::vector<std::string>& channels);

/// When a closed curve is back at its first key. A last key that repeats the first one is dropped: it only gives that
/// time. Throws: Error (data) for keys that make no closed curve.
Time take_closing(KeyStore& keys, const CurveSpec& spec, const std::vector<std::string>& channels);

/// The segments of an open curve, each as soon as the key after its end is read. Requires: no position is missing.
Source<SegmentBlock> segment_blocks(Source<Keys> keys, const Rules& rules, const SegmentOptions& options);

/// A curve with random access to its segments, and how rows show its channels.
class KeptCurve {
 public:
  /// Requires: at least one segment. `extent`: of its keys, whose times may have more digits than those of segments.
  KeptCurve(spline::Curve<double> curve, CurveChannels channels, const Extent& extent,
            const Extrapolations& extrapolations = {}, std::vector<spline::ChannelGap> gaps = {});

  const spline::Curve<double>& curve() const { return *curve_; }
  const std::optional<FrameTimes>& frames() const { return channels_.frames; }
  const Extent& extent() const { return extent_; }
  const Extrapolations& extrapolations() const { return extrapolations_; }
  const std::vector<spline::ChannelGap>& gaps() const { return gaps_; }
  double length() const;
  std::uint64_t size() const;

  CurveSegment segment(std::uint64_t number) const;

 private:
  std::shared_ptr<const spline::Curve<double>> curve_;
  CurveChannels channels_;
  Extent extent_;
  Extrapolations extrapolations_;
  std::vector<spline::ChannelGap> gaps_;
  std::vector<double> cycle_;                      ///< last key - first key
  std::vector<spline::Quaternion<double>> turns_;  ///< last key times the inverse of the first, of each rotation
  int decimals_ = 0;                               ///< of the times
};

/// A curve whose segments are made from its keys, as often as they are needed.
struct StreamedCurve {
  KeyStore keys;
  Extent extent;  ///< a closed curve is back at its first key at the end
  Rules rules;
  SegmentOptions options;

  /// Where keys lack positions, each channel runs through those that have one in it. Requires: a position in every
  /// channel.
  Source<SegmentBlock> segments(bool measured = false) const;
  struct Measured {
    Source<SegmentBlock> segments;
    double length;            ///< of the curve
    std::size_t last_moving;  ///< as Extent has it
  };
  /// The segments with their lengths, which are all measured before the first one.
  Measured measured() const;
  /// The curve with random access. `measured`: with the lengths of its segments.
  KeptCurve kept(const CurveChannels& channels, const Extrapolations& extrapolation, bool measured) const;
};

/// Throws: Error (data) if the length of the curve up to a time is beyond the range of doubles.
void require_length(const spline::DoubleDouble& length, const Time& end);

}  // namespace tcb
