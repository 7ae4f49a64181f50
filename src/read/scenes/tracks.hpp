// Tracks: the animated values of a file with several objects, as keys of curves.
//
// The formats of products are read into tracks, one for each position, rotation, scale or other value of an object.
// Each track is a curve, with the object and the track as its groups. Its channels may have keys at different times,
// and tension, continuity and bias of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "error.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/memory_use.hpp"
#include "read/scenes/track_channel.hpp"
#include "schema/curve_channels.hpp"
#include "schema/curve_settings.hpp"
#include "schema/rotation_options.hpp"
#include "stream/source.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

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
