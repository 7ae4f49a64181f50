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

/// The rotation of a track of 3D Studio and 3ds Max: an axis in the frame of the parent, and the angle from the key
/// before.
GivenRotation turns_around_axes(const std::vector<std::string_view>& columns);

/// How the format of a scene is read.
struct SceneFormat {
  /// The tracks of a file, which is kept while they are read.
  std::vector<Track> (*read)(std::string_view file, MemoryUse& memory);
  bool has_frames = false;    ///< times are frames, else seconds
  bool first_object = false;  ///< without a choice, only what moves the first object that moves is read
};

/// The tracks that are chosen, as keys. Those that are constant are left out unless all are; without a choice also
/// those with other channels than the first, and with `first_object` all but the position, rotation and scale of the
/// first object that one of them moves. Before and after its keys, a track has the extrapolation of all channels that
/// change, if they have the same one. Throws: Error (data) for an empty file and one that needs too much memory, where
/// no track is left, where one of them is not read, where chosen ones differ in their channels, and where two keys of a
/// channel have the same time.
Records open_scene(const SceneFormat& format, const Source<std::string>& bytes, const InputOptions& options);

/// The options that tracks are read with: a channel runs through its own keys, and times are seconds or frames, unless
/// something else is requested.
InputOptions options_of_scene(const SceneFormat& format, InputOptions options);

/// The input half of a format. `begins` is as in InputFormat.
template <const SceneFormat& format>
constexpr InputFormat input_of_scenes(decltype(InputFormat::begins) begins) {
  return {.open = [](const Format&, Source<std::string> bytes,
                     InputOptions options) { return open_scene(format, bytes, options); },
          .options = [](const Format&, Source<std::string>&,
                        InputOptions options) { return options_of_scene(format, std::move(options)); },
          .begins = begins,
          .has_tracks = true,
          .takes_delimiters = false,
          .has_own_columns = true};
}

}  // namespace tcb
