// Tracks: the animated values of a file with several objects, as keys of curves.
//
// The formats of products are read into tracks, one for each position, rotation, scale or other value of an object.
// Each track is a curve, with the object and the track as its groups. Its channels may have keys at different times,
// and tension, continuity and bias of their own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/key_builder.hpp"
#include "read/memory_use.hpp"
#include "schema/curve_channels.hpp"
#include "schema/curve_settings.hpp"
#include "schema/rotation_options.hpp"
#include "stream/source.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

// Faults of files.
Error number_of_track_not_finite();
Error file_ends_early();
Error number_of_file_expected(std::string_view found);
Error count_of_file_expected(std::string_view found);

/// The number nearest to a ratio. Throws: Error (data) beyond the doubles.
WrittenNumber written_number(const Rational& exact);

/// A key of one channel.
struct TrackKey {
  WrittenNumber time;
  WrittenNumber value;
  WrittenNumber tension = {}, continuity = {}, bias = {};
  WrittenNumber ease_in = {}, ease_out = {};                         ///< the same in all channels of a track
  std::optional<WrittenNumber> velocity_in = {}, velocity_out = {};  ///< per unit of time, where the file decides them
  std::uint64_t line = 0;                                            ///< in the file; 0: it has no lines
};

/// The keys of a channel in order.
struct TrackChannel {
  std::string name;
  std::vector<TrackKey> keys = {};
  bool has_velocities = false;  ///< the file decides all velocities
  /// The extrapolations before and after the keys, or nothing where the file does not decide them.
  std::string_view before = {}, after = {};
};

/// The curve between two keys where the file decides it: a cubic in time, or a step.
struct TrackSpan {
  enum class Kind {
    cubic,
    holds_first,   ///< the first value up to the double before the second time
    holds_second,  ///< the second value from the double after the first time
  };
  Kind kind = Kind::cubic;
  Rational start = Rational(0), end = Rational(0);  ///< velocities of a cubic
};

/// Throws: Error (data).
void require_increasing_times(const TrackChannel& channel);

/// Gives the keys of a channel the velocities of the spans between them, and adds keys for steps. Throws: Error (data)
/// for a step that no double is within.
void set_spans(TrackChannel& channel, const std::vector<TrackSpan>& spans);

/// The keys of a channel, of a format's own kind, and its extrapolations as in TrackChannel.
template <class Key>
struct TrackCurve {
  std::vector<Key> keys = {};
  std::string_view before = {}, after = {};
};

/// The channel of a curve. Unless all its keys are TCB, span_of(i) is the span after key i. Throws: Error (data) for
/// times that do not increase, and as set_spans().
template <class Key, class SpanOf>
TrackChannel channel_of(std::string_view name, const TrackCurve<Key>& curve, const SpanOf& span_of) {
  const std::vector<Key>& keys = curve.keys;
  TrackChannel channel{std::string(name), {keys.begin(), keys.end()}, false, curve.before, curve.after};
  require_increasing_times(channel);
  if (keys.size() < 2 || std::ranges::all_of(keys, &Key::is_tcb)) return channel;
  std::vector<TrackSpan> spans;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) spans.push_back(span_of(i));
  set_spans(channel, spans);
  return channel;
}

struct Track {
  std::string object, name;
  std::vector<TrackChannel> channels = {};
  bool has_ease = false;
  bool is_recording = false;  ///< its keys are samples, between which it is straight
  CurveSettings settings = {};
  std::optional<GivenRotation> rotation = {};  ///< that channels are
  std::optional<EulerTrack> euler = {};        ///< that channels are
  std::optional<Error> failure = {};           ///< why its curve is not read

  bool is_constant() const;  ///< it has a single key in each channel
  bool changes() const;      ///< a channel has different values
};

/// The memory that a key of a channel takes at most while a file is read, besides the text of its numbers.
inline constexpr std::uint64_t memory_of_key = 2 * sizeof(TrackKey);

/// All bytes of a file, as a scene is kept while it is read. Throws: Error (data) for an empty file, and for one that
/// needs too much memory.
std::string whole_file(const Source<std::string>& bytes, MemoryUse& memory);

/// The options that tracks are read with: a channel runs through its own keys, and times are seconds or frames, unless
/// something else is requested.
InputOptions options_of_tracks(const Format& format, Source<std::string>& bytes, InputOptions options);
InputOptions options_of_frames(const Format& format, Source<std::string>& bytes, InputOptions options);

/// A format of files with several objects. `begins` and `options` are those of InputFormat.
constexpr InputFormat format_of_scenes(decltype(InputFormat::open) open, decltype(InputFormat::begins) begins,
                                       decltype(InputFormat::options) options = options_of_tracks) {
  return {.open = open,
          .options = options,
          .begins = begins,
          .has_tracks = true,
          .takes_delimiters = false,
          .has_own_columns = true};
}

/// The tracks that are chosen, as keys. Those that are constant are left out unless all are; without a choice also
/// those with other channels than the first, and with `first_object` all but the position, rotation and scale of the
/// first object that one of them moves. `time` is the name of the times. Before and after its keys, a track has the
/// extrapolation of all channels that change, if they have the same one. Throws: Error (data) where no track is left,
/// where one of them is not read, where chosen ones differ in their channels, and where two keys of a channel have the
/// same time.
Records records_of_tracks(std::vector<Track> tracks, const std::string& time, const InputOptions& options,
                          bool first_object = false);

}  // namespace tcb
