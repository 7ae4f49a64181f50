// From settings to a curve specification, and from keys to segments with their lengths.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "keys/key_store.hpp"
#include "keys/parameterize.hpp"
#include "numbers/rational.hpp"
#include "sample/extrapolation.hpp"
#include "sample/request.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/window.hpp"

namespace tcb {

/// Which curve the keys make.
struct CurveSpec {
  spline::Preset preset = spline::Preset::gte;
  spline::CurveRules<double> rules;
  bool closed = false;
  std::optional<Rational> period;                  ///< of a closed curve, if given
  std::optional<double> parameter;                 ///< exponent of the distances that make times
  std::optional<std::string> parameter_name = {};  ///< as given
  std::vector<RotationColumns> rotations = {};     ///< those of the rules, and how rows show them
  std::vector<AngleColumn> angles = {};            ///< likewise
  Extrapolation extrapolation = Extrapolation::error;
  bool ease = true;  ///< ease columns are used, if there are any

  /// There are rotations alone, which have no lengths.
  bool lacks_metric = false;

  CurveChannels channels() const { return {rules.metric, rotations, angles}; }
};

/// The settings of the command line, completed by those of the input. A preset of the command
/// line replaces all rules of the input.
CurveSettings merged(CurveSettings settings, const CurveSettings& of_input);

/// The index of a channel by its name, or by its number from 1.
std::optional<std::size_t> find_channel(const std::string& name, const std::vector<std::string>& channels);

/// Throws: Error about a setting for an unknown name, or for settings that contradict each other.
CurveSpec make_spec(const CurveSettings& settings);

/// The curve of keys with these channels, with the metric, to which rotations and angles do not belong. Throws: Error
/// about a setting, also for a metric channel that does not exist or belongs to a rotation, or a velocity with another
/// number of channels.
CurveSpec make_spec(const CurveSettings& settings, const std::vector<std::string>& channels,
                    const std::vector<RotationColumns>& rotations = {}, const std::vector<AngleColumn>& angles = {});

/// The scale on which the preset's product shows tension, continuity and bias, where it is another than the formulas'.
std::optional<ShownTcbScale> shown_tcb_scale(spline::Preset preset);

/// What is used of the metric: lengths along the curve, or also distances and speeds.
enum class MetricUse { nothing, lengths, path };

/// Throws: Error (data) for lengths where there are only rotations, for distances where lengths are angles, and for
/// cubics of rotations that have none.
void require_fitting_rotations(const CurveSpec& spec, MetricUse use, bool emits);

/// Throws: Error (data) where a field or a tolerance is of rotations, and there are none, or of distances, and there
/// are rotations alone.
void require_rotations(const CurveSpec& spec, const std::vector<std::size_t>& chosen, const SamplingRequest& request);

using Rules = spline::CurveRules<double>;

/// Successive segments with their lengths.
struct SegmentBlock {
  spline::Segments<double> segments;
  std::vector<spline::Length<double>> lengths;  ///< one per segment, or none if the curve is not measured
  bool last = false;                            ///< the curve ends here
  bool closes = false;                          ///< and has returned to its first key
};

/// Keys in the order in which they are linked to segments.
struct LinkedKeys {
  Source<Keys> keys;
  std::optional<Keys> last = {};  ///< of a closed curve: its last key
  Time end = {};                  ///< and the time when it is back at its first one
};

/// The keys of a curve. `end`: of a closed one.
LinkedKeys linked(const KeyStore& keys, const std::optional<Time>& end);

/// When a closed curve is back at its first key. A last key that repeats the first one is dropped: it only gives that
/// time. `timed`: the input has times. Throws: Error (data) for keys that make no closed curve.
Time take_closing(KeyStore& keys, const CurveSpec& spec, bool timed, const std::vector<std::string>& channels);

/// The segments between the keys, each as soon as the key after its end is known.
Source<SegmentBlock> segment_blocks(LinkedKeys keys, const Rules& rules, bool measured, unsigned threads = 1);

/// The segments of a curve whose keys lack positions: each channel runs through the keys that have a position in it.
/// `end`: of a closed curve. `expanded`: cubics are expanded parts of those between a channel's own keys.
/// Requires: a position in every channel.
Source<SegmentBlock> sparse_segment_blocks(const KeyStore& keys, const std::optional<Time>& end, const Rules& rules,
                                           bool measured, bool expanded = false);

/// Throws: Error (data) if the length of the curve up to a time is beyond the range of doubles.
void require_length(const spline::DoubleDouble& length, const Time& end);

/// The lengths of all segments in order.
using Lengths = std::deque<spline::Length<double>>;  // which grows without a copy
Lengths all_lengths(const Source<SegmentBlock>& measured);
double total_length(const Lengths& lengths);

/// Segments that were not measured, with their lengths, which are known.
Source<SegmentBlock> with_lengths(Source<SegmentBlock> segments, Lengths lengths);

}  // namespace tcb
