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
#include "numbers/parse_number.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/memory_use.hpp"
#include "schema/curve_channels.hpp"
#include "schema/curve_settings.hpp"
#include "schema/rotation_options.hpp"
#include "stream/source.hpp"
#include "tcb/spline/keys.hpp"

namespace tcb {

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

struct Track {
  std::string object, name;
  std::vector<TrackChannel> channels = {};
  bool has_ease = false;
  CurveSettings settings = {};
  std::optional<GivenRotation> rotation = {};          ///< that channels are
  std::optional<spline::RotationNotation> euler = {};  ///< of the angles that channels are, in this order
  std::optional<Error> failure = {};                   ///< why its curve is not read

  bool is_constant() const;  ///< it has a single key in each channel
};

/// The memory that a key of a channel takes at most while a file is read, besides the text of its numbers.
inline constexpr std::uint64_t memory_of_key = 2 * sizeof(TrackKey);

/// The number nearest to a ratio. Throws: Error (data) beyond the doubles.
WrittenNumber written_number(const Rational& exact);

/// The error for a key that is not after the one before it.
Error times_of_track_repeat(const TrackKey& key);

/// How the format of a scene is read.
struct SceneFormat {
  /// The tracks of a file, which is kept while they are read.
  std::vector<Track> (*read)(std::string_view file, MemoryUse& memory);
  bool has_frames = false;  ///< times are frames, else seconds
};

/// The tracks that are chosen, as keys. Those that are constant are left out unless all are; without a choice also
/// those with other channels than the first. Before and after its keys, a track has the extrapolation of all channels
/// that change, if they have the same one. Throws: Error (data) for an empty file and one that needs too much memory,
/// where no track is left, where one of them is not read, where chosen ones differ in their channels, and where two
/// keys of a channel have the same time.
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
          .has_own_columns = true};
}

}  // namespace tcb
