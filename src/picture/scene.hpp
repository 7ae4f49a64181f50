// Scene: the curves of a picture with their samples and names, and the extent of each channel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keys/key_store.hpp"
#include "picture/axis.hpp"
#include "schema/curve_channels.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

struct SegmentBlock;

/// A sample as it is drawn.
struct SceneSample {
  Time t;
  std::vector<double> position, velocity;
};

/// A curve, which can be read more than once.
struct SceneCurve {
  std::size_t name = 0;  ///< index into Scene::names
  KeyStore keys;
  std::function<Source<SegmentBlock>()> segments;
  bool closed = false;
  std::uint64_t rows = 0;
  std::vector<SceneSample> samples = {};  ///< all of them, or none if there are more than Scene::most_samples
  bool is_polyline = false;               ///< through samples of another program, which are its keys
  std::size_t dotted = 0;                 ///< of a polyline: in so many channels its dots are enough, if they have room
};

/// A place that is marked in the views of some channels.
struct SceneMark {
  Time t;
  std::vector<double> position;
  std::vector<std::size_t> channels;
};

/// Axes x, y and z that turn with a rotation, along the path.
struct SceneFrame {
  spline::RotationChannels rotation{};
  std::array<std::size_t, 2> axes{};  ///< of space, those of the path: 0 is x
};

struct Scene {
  std::string title, subtitle;
  std::string time;  ///< name of the time
  TimeScale time_scale = {};
  std::vector<std::string> channels;               ///< names of the channels
  std::vector<std::size_t> strips;                 ///< the channels with a strip over time; empty: all
  std::vector<std::string> names;                  ///< of groups or files, each with its own colour
  std::optional<std::array<std::size_t, 2>> path;  ///< the channels of the path, to the right and up
  bool is_path_requested = false;                  ///< it is there whatever the extents of its channels
  std::optional<SceneFrame> frame = {};
  std::vector<SceneCurve> curves = {};
  std::optional<SceneMark> worst = {};  ///< where given samples differ most from the curve, or another worst place
  std::string worst_in_words = "largest difference";

  /// The samples of a curve with more are not drawn.
  static constexpr std::uint64_t most_samples = 400;
  /// Further curves are counted, not drawn.
  static constexpr std::size_t most_curves = 400;

  std::uint64_t keys() const;  ///< without those of polylines
  std::uint64_t dots() const;  ///< of polylines
  std::uint64_t rows() const;
  /// Nobody can read a picture of more strips, and its size would grow with them.
  static constexpr std::size_t most_strips = 1000;

  /// Takes the times of a schema, and channels of these names. The path has the requested axes, or else the first two
  /// of `metric`, unless the curves lack one. Throws: Error (usage) as path_axes().
  void begin(const Schema& schema, std::vector<std::string> of_channels, const std::vector<std::string>& axes,
             const std::vector<std::size_t>& metric = {}, bool lacks_metric = false);

  /// The number of strips.
  std::size_t strip_count() const { return strips.empty() ? channels.size() : strips.size(); }
  /// Throws: Error (usage) if there are more than most_strips.
  void require_few_strips() const;
  /// Whether every curve has its samples.
  bool has_samples() const;
};

/// The channels of the path: those requested by name or number, or else the first two of some. Throws: Error (usage).
std::optional<std::array<std::size_t, 2>> path_axes(const std::vector<std::string>& channels,
                                                    const std::vector<std::string>& requested,
                                                    const std::vector<std::size_t>& metric = {});

/// A rotation of a curve, from which angles are measured.
struct FirstRotation {
  spline::RotationChannels channels{};
  spline::Quaternion<double> rotation;  ///< the first one that a key has
};
std::vector<FirstRotation> first_rotations(const KeyStore& keys, const std::vector<RotationColumns>& columns);

/// Segments whose rotations have become cubics for their numbers: of short parts, which are near enough for a picture.
/// Each of `firsts` adds a channel: the angle from it in degrees.
std::function<Source<SegmentBlock>()> with_rotations_as_cubics(std::function<Source<SegmentBlock>()> segments,
                                                               CurveChannels channels,
                                                               std::vector<FirstRotation> firsts = {});
/// Keys with the angles as further channels.
KeyStore with_angles(const KeyStore& keys, const std::vector<FirstRotation>& firsts);
void add_angles(SceneSample& sample, const std::vector<FirstRotation>& firsts);

/// The extent of the curves, their keys and their samples.
struct SceneExtent {
  Interval time;
  std::vector<Interval> channels;
  std::array<Interval, 2> path;         ///< with the tangents at the keys
  std::vector<Interval> with_tangents;  ///< of the channels
  std::size_t segments = 0;             ///< of all curves
};

/// Without the path if it is not requested and one of its channels extends less than a twentieth of the other, so that
/// equal scales would make a line of it.
void remove_flat_path(Scene& scene, const SceneExtent& extent);

/// Reads all curves. Throws: Error (data) if the difference of two numbers is beyond the range of doubles.
SceneExtent extent_of(const Scene& scene);

}  // namespace tcb
