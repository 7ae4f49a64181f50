// glTF: an animation whose nodes move along curves.
//
// Rows of samples are LINEAR keyframes, rows of pieces exact CUBICSPLINE keyframes with tangents on both sides. A curve
// is a node, with these targets:
//   translation  three channels, the first that are nothing else; of a track, those of "position" and "target"
//   rotation     a rotation, as a quaternion; of a track, also angles with keys of their own, of which rows of pieces
//                become as many keyframes as keep the rotation within 0.01 degrees
//   scale        channels sx, sy, sz or scale_x, scale_y, scale_z; of a track, those of "scale"
// Numbers of all other channels are in the "extras" of the animation. Arrays have single precision, as the format
// requires; of two times that it does not distinguish, as at a step, the second is the next number.
// Source: Khronos Group, "glTF 2.0 Specification".
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schema/curve_channels.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// Gathers the rows of curves, some 32 bytes for each sample of a pose, and three times as many for a piece.
class GltfScene {
 public:
  /// `are_pieces`: rows are a start, a duration, and four numbers for each channel; else a time and a position.
  explicit GltfScene(bool are_pieces) : are_pieces_(are_pieces) {}

  /// Begins the rows of curves with this meaning. Throws: Error (data) for channels that are no target.
  void begin(const Schema& schema);

  /// Begins the rows of a curve. Throws: Error (data) for a second curve of the same group, and for a track that is no
  /// target.
  /// `euler`: angles that its channels are, whose rotations are written.
  void begin_curve(const std::vector<std::string>& group, const std::optional<EulerTrack>& euler = {});

  /// Adds rows, as the bytes of doubles, the lowest first. Throws: Error (data) for times before 0, for those that
  /// single precision does not distinguish, and for numbers beyond it.
  void add(std::string_view rows);

  /// Ends the rows of a curve. Throws: as add().
  void end_curve();

  /// Names of channels that have no target.
  const std::vector<std::string>& other_channels() const { return others_; }

  /// The file. Throws: Error (data) where there is no row.
  std::string text();

 private:
  /// What moves a node: the path of a property, and its channels in order.
  struct Target {
    std::string_view path;
    std::vector<std::size_t> channels;
    std::vector<float> values = {};  ///< keyframe after keyframe; of pieces incoming tangents, positions, outgoing ones
  };
  struct Node {
    std::string name;
    std::vector<float> times = {};
    std::vector<Target> targets = {};
    std::vector<std::vector<double>> others = {};  ///< of each other channel, a number for each keyframe
    std::optional<EulerTrack> euler = {};          ///< angles of the rotation that is its target
  };

  std::vector<Target> targets_of_track(const std::string& track, bool has_angles) const;
  void add_sample(const std::vector<double>& row);
  void end_curve_of_angles(const std::vector<double>& rows);
  void add_time(double time);
  static void add_number(Target& target, double number);

  bool are_pieces_;
  Schema schema_;
  double seconds_ = 1;           ///< of a unit of time
  std::vector<Target> targets_;  ///< of nodes that are no tracks
  std::vector<std::size_t> other_channels_;
  std::vector<std::string> others_;
  std::vector<double> pieces_;             ///< of the current curve, row after row
  double first_time_ = 0, last_time_ = 0;  ///< of its keyframes
  std::vector<Node> nodes_;
  std::set<std::pair<std::string, std::string_view>> known_;  ///< names of nodes, with the path of their first target
};

}  // namespace tcb
