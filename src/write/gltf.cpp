// glTF: an animation whose nodes move along curves.
//
// Rows of samples are LINEAR keyframes, rows of pieces exact CUBICSPLINE keyframes with tangents on both sides. A curve
// is a node, with these targets:
//   translation  three channels, the first that are nothing else; of a track, those of "position" and "target"
//   rotation     a rotation, as a quaternion; of a track, also samples of angles with keys of their own
//   scale        channels sx, sy, sz or scale_x, scale_y, scale_z; of a track, those of "scale"
// Numbers of all other channels are in the "extras" of the animation. Arrays have single precision, as the format
// requires; of two times that it does not distinguish, as at a step, the second is the next number.
// Source: Khronos Group, "glTF 2.0 Specification".
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "error.hpp"
#include "io/digest.hpp"
#include "sample/table.hpp"
#include "schema/curve_channels.hpp"
#include "schema/schema.hpp"
#include "schema/texts.hpp"
#include "schema/units.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"
#include "write/output_format.hpp"

namespace tcb {
namespace {

using Json = nlohmann::ordered_json;
using Rotation = spline::Quaternion<double>;

constexpr std::size_t numbers_of_piece = 4;  // of a channel: position and velocity at both ends

constexpr std::string_view track_column = "track";
constexpr std::string_view target_track = "target";  // what a camera looks at: a node of its own

Error no_target_of_node(const std::vector<std::string>& channels) {
  return data_error(
      "the channels are {}; expected three of a translation, one rotation, or sx, sy and sz of a scale; choose others "
      "with --columns, or give another format to --output-format",
      listed(channels));
}

Error animation_without_rows() {
  return data_error("a curve has no row in the range; expected one at least; give a longer range");
}

Error angles_have_no_cubics(const std::string& name) {
  return data_error(
      "the rotation of {} is by angles with keys of their own, whose pieces are no cubics of a rotation; expected "
      "samples; give --fps 30 or another rate",
      in_quotes(name));
}

/// The place of a channel among those of a scale; 3: it is none.
std::size_t axis_of_scale(std::string_view name) {
  constexpr std::array<std::string_view, 3> names{"sx", "sy", "sz"}, long_names{"scale_x", "scale_y", "scale_z"};
  const auto place = [&](const auto& all) { return std::ranges::find(all, name) - all.begin(); };
  return static_cast<std::size_t>(std::min(place(names), place(long_names)));
}

/// The rotation by the angles in the cells of a row.
Rotation rotation_of(const EulerTrack& euler, const std::vector<double>& row) {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = row[1 + euler.channels[i]];
    constexpr double largest = 1e6;  // of angles that sines are computed of
    if (!(std::abs(angles[i]) <= largest)) {
      throw data_error("an angle of a rotation is {}; expected at most 1e6 in size; take full turns off the angles",
                       angles[i]);
    }
  }
  return spline::quaternion_from(angles, euler.notation);
}

/// The last rotation of an array.
Rotation last_of(const std::vector<float>& values) {
  const auto number = [&](std::size_t i) { return static_cast<double>(values[values.size() - 4 + i]); };
  return {number(0), number(1), number(2), number(3)};
}

/// Writes arrays into one buffer, and describes them.
class Buffer {
 public:
  /// The number of the accessor of an array.
  std::size_t add(const std::vector<float>& values, std::size_t components) {
    constexpr int single_precision = 5126;
    constexpr std::array<const char*, 5> types{"", "SCALAR", "", "VEC3", "VEC4"};
    views_.push_back(Json{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size() * sizeof(float)}});
    Json accessor{{"bufferView", views_.size() - 1},
                  {"componentType", single_precision},
                  {"count", values.size() / components},
                  {"type", types.at(components)}};
    if (components == 1) {
      accessor["min"] = Json::array({values.front()});
      accessor["max"] = Json::array({values.back()});
    }
    accessors_.push_back(std::move(accessor));
    for (const float value : values) {
      const auto bits = std::bit_cast<std::uint32_t>(value);
      for (unsigned shift = 0; shift < 32; shift += 8) bytes_ += static_cast<char>(bits >> shift & 0xFFU);
    }
    return accessors_.size() - 1;
  }

  void describe(Json& file) const {
    file["accessors"] = accessors_;
    file["bufferViews"] = views_;
    Json buffer;
    buffer["byteLength"] = bytes_.size();
    buffer["uri"] = "data:application/octet-stream;base64," + in_base64(bytes_);
    file["buffers"] = Json::array({buffer});  // compilers differ in the meaning of {buffer}
  }

 private:
  std::string bytes_;
  Json accessors_ = Json::array(), views_ = Json::array();
};

/// Gathers the rows of curves, some 32 bytes for each sample of a pose, and three times as many for a piece.
class GltfScene : public RowKeeper {
 public:
  /// `are_pieces`: rows are a start, a duration, and four numbers for each channel; else a time and a position.
  explicit GltfScene(bool are_pieces) : are_pieces_(are_pieces) {}

  /// Throws: Error (data) for channels that are no target.
  void begin(const Schema& schema) override {
    if (schema.time.unit == TimeUnit::frames) throw times_without_rate(schema.time.name);
    schema_ = schema;
    if (schema.time.unit) seconds_ = nearest_double(Rational(1) / units_per_second(*schema.time.unit));
    const std::vector<RotationColumns> rotations = rotation_columns(schema);
    if (rotations.size() > 1) throw no_target_of_node(schema.channels);
    const std::size_t none = schema.channels.size();
    Target translation{"translation", {}}, scale{"scale", {none, none, none}};
    targets_.clear();
    others_.clear();
    const std::vector<bool> are_in_rotations = spline::in_rotations(rotations, schema.channels.size());
    for (std::size_t i = 0; i < schema.channels.size(); ++i) {
      const std::size_t axis = axis_of_scale(schema.channels[i]);
      if (axis < scale.channels.size()) {
        scale.channels[axis] = i;
      } else if (!are_in_rotations[i]) {
        (translation.channels.size() < 3 ? translation.channels : others_).push_back(i);
      }
    }
    const auto add_if_whole = [&](const Target& target) {
      if (target.channels.size() == 3 && std::ranges::count(target.channels, none) == 0) {
        return targets_.push_back(target);
      }
      std::ranges::remove_copy(target.channels, std::back_inserter(others_), none);
    };
    add_if_whole(translation);
    if (!rotations.empty()) {
      targets_.push_back({"rotation", {rotations[0].channels.begin(), rotations[0].channels.end()}});
    }
    add_if_whole(scale);
    if (targets_.empty()) throw no_target_of_node(schema.channels);
    std::ranges::sort(others_);
  }

  /// Throws: Error (data) for a second curve of the same group, for a track that is no target, and for pieces of angles
  /// with keys of their own.
  void begin_curve(const std::vector<std::string>& group, const std::optional<EulerTrack>& euler) override {
    std::vector<std::string> texts = contents(group);
    const bool is_track = !schema_.groups.empty() && schema_.groups.back() == track_column;
    std::vector<Target> targets = targets_;
    if (is_track) {
      targets = targets_of_track(texts.back(), euler.has_value());
      if (texts.back() != target_track) texts.pop_back();
    }
    std::string name = texts.empty() ? "curve" : fmt::format("{}", fmt::join(texts, " "));
    if (!known_.emplace(name, targets.front().path).second)
      throw data_error(
          "there is more than one curve of {}; expected one for each node of an animation; give another format, such "
          "as csv, to --output-format",
          in_quotes(name));
    if (is_track && euler && are_pieces_) throw angles_have_no_cubics(name);
    nodes_.push_back({std::move(name),
                      {},
                      std::move(targets),
                      std::vector<std::vector<double>>(others_.size()),
                      is_track ? euler : std::nullopt});
  }

  /// Adds rows, as the bytes of doubles, the lowest first. Throws: Error (data) for times before 0, for those that
  /// single precision does not distinguish, and for numbers beyond it.
  void add(std::string_view rows) override {
    const std::size_t channels = schema_.channels.size();
    std::vector<double> row(are_pieces_ ? 2 + numbers_of_piece * channels : 1 + channels);
    for (std::size_t at = 0; at < rows.size();) {
      for (double& number : row) {
        std::uint64_t bits = 0;
        for (unsigned shift = 0; shift < 64; shift += 8) {
          bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(rows[at++])) << shift;
        }
        number = std::bit_cast<double>(bits);
      }
      if (are_pieces_) {
        pieces_.insert(pieces_.end(), row.begin(), row.end());
      } else {
        add_sample(row);
      }
    }
  }

  /// Ends the rows of a curve. Throws: as add().
  void end_curve() override {
    const std::vector<double> rows = std::exchange(pieces_, {});
    if (rows.empty()) return;
    Node& node = nodes_.back();
    const std::size_t size = 2 + numbers_of_piece * schema_.channels.size(), pieces = rows.size() / size;
    const auto number = [&](std::size_t piece, std::size_t channel, std::size_t i) {
      return rows[piece * size + 2 + numbers_of_piece * channel + i];
    };
    for (std::size_t i = 0; i < pieces; ++i) add_time(rows[i * size]);
    add_time(rows[(pieces - 1) * size] + rows[(pieces - 1) * size + 1]);
    const auto tangent = [&](std::size_t piece, std::size_t channel, std::size_t i) {
      const double duration = static_cast<double>(node.times[piece + 1]) - static_cast<double>(node.times[piece]);
      return number(piece, channel, i) * rows[piece * size + 1] / duration;
    };
    for (std::size_t key = 0; key <= pieces; ++key) {
      const bool is_first = key == 0, is_last = key == pieces;
      const auto position = [&](std::size_t channel) {
        return is_last ? number(key - 1, channel, 2) : number(key, channel, 0);
      };
      for (Target& target : node.targets) {
        for (const std::size_t channel : target.channels)
          add_number(target, is_first ? 0 : tangent(key - 1, channel, 3));
        for (const std::size_t channel : target.channels) add_number(target, position(channel));
        for (const std::size_t channel : target.channels) add_number(target, is_last ? 0 : tangent(key, channel, 1));
      }
      for (std::size_t i = 0; i < others_.size(); ++i) node.others[i].push_back(position(others_[i]));
    }
  }

  /// Names of channels that have no target.
  std::vector<std::string> channels_in_extras() const override {
    std::vector<std::string> names;
    for (const std::size_t channel : others_) names.push_back(schema_.channels[channel]);
    return names;
  }

  /// The file. Throws: Error (data) where there is no row.
  std::string tail(const Rational&) override {
    Buffer buffer;
    Json nodes = Json::array(), numbers = Json::array(), channels = Json::array(), samplers = Json::array(), extras;
    std::unordered_map<std::string_view, std::size_t> numbers_of_names;
    std::vector<Json> others;  // of each node
    for (const Node& node : nodes_) {
      if (node.times.empty()) throw animation_without_rows();
      const auto [known, is_new] = numbers_of_names.emplace(node.name, nodes.size());
      const std::size_t number = known->second;
      if (is_new) {
        nodes.push_back(Json{{"name", node.name}});
        numbers.push_back(number);
        others.emplace_back();
      }
      const std::size_t times = buffer.add(node.times, 1);
      for (const Target& target : node.targets) {
        channels.push_back(
            Json{{"sampler", samplers.size()}, {"target", Json{{"node", number}, {"path", target.path}}}});
        samplers.push_back(Json{{"input", times},
                                {"interpolation", are_pieces_ ? "CUBICSPLINE" : "LINEAR"},
                                {"output", buffer.add(target.values, target.path == "rotation" ? 4 : 3)}});
      }
      for (std::size_t i = 0; i < others_.size(); ++i) others[number][schema_.channels[others_[i]]] = node.others[i];
    }
    if (nodes_.empty()) throw animation_without_rows();
    Json animation{{"channels", channels}, {"samplers", samplers}};
    for (std::size_t number = 0; !others_.empty() && number < others.size(); ++number) {
      if (extras.is_null()) extras = Json::object();
      extras.get_ref<Json::object_t&>().emplace_back(nodes[number]["name"], std::move(others[number]));
    }
    if (!extras.is_null()) animation["extras"] = std::move(extras);
    Json file{{"asset", Json{{"version", "2.0"}, {"generator", "tcbsample"}}},
              {"scene", 0},
              {"scenes", Json::array({Json{{"nodes", numbers}}})},
              {"nodes", nodes},
              {"animations", Json::array({animation})}};
    buffer.describe(file);
    return for_pages(file.dump()) + "\n";
  }

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

  std::vector<Target> targets_of_track(const std::string& track, bool has_angles) const {
    std::vector<Target> targets{targets_.front()};
    if (has_angles) targets.front().path = "rotation";
    const bool is_rotation = targets.front().path == "rotation";
    if (is_rotation || track == "position" || track == target_track) return targets;
    if (track != "scale")
      throw data_error(
          "the track {} is not a position, rotation or scale that a node has; expected one of these; choose others "
          "with --only",
          in_quotes(track));
    targets.front().path = "scale";
    return targets;
  }

  void add_sample(const std::vector<double>& row) {
    Node& node = nodes_.back();
    add_time(row[0]);
    if (node.euler) {
      Target& target = node.targets.front();
      Rotation q = rotation_of(*node.euler, row);
      if (!target.values.empty() && dot(q, last_of(target.values)) < 0) q = -q;
      for (const double number : {q.x, q.y, q.z, q.w}) add_number(target, number);
      return;
    }
    for (Target& target : node.targets) {
      for (const std::size_t channel : target.channels) add_number(target, row[1 + channel]);
    }
    for (std::size_t i = 0; i < others_.size(); ++i) node.others[i].push_back(row[1 + others_[i]]);
  }

  /// Adds a time. One that single precision does not distinguish from the time before, as at a step, gets the next
  /// number.
  void add_time(double time) {
    const double seconds = time * seconds_;
    if (seconds < 0)
      throw data_error(
          "a keyframe is at {} seconds; expected times from 0 on, as animations have them; give --time-zero {}",
          seconds, time);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    auto rounded = static_cast<float>(seconds);
    std::vector<float>& times = nodes_.back().times;
    if (times.empty()) {
      first_time_ = time;
    } else if (!(rounded > times.back())) {
      // The pieces of a step end and begin at the same time, or at neighbouring doubles.
      const bool is_step = are_pieces_ && time <= std::nextafter(last_time_, std::numeric_limits<double>::infinity());
      if (!is_step) {
        throw data_error(
            "the keyframe at {} seconds has the time of the one before it in single precision; expected times that "
            "differ there; give fewer samples, or --time-zero {}",
            seconds, first_time_);
      }
      rounded = std::nextafter(times.back(), infinity);
    }
    last_time_ = time;
    times.push_back(rounded);
  }

  static void add_number(Target& target, double number) {
    if (std::abs(number) > static_cast<double>(std::numeric_limits<float>::max())) {
      throw data_error(
          "{} is beyond the range of single precision; expected less than 3.4e38 in size; scale the keys down", number);
    }
    target.values.push_back(static_cast<float>(number));
  }

  bool are_pieces_;
  Schema schema_;
  double seconds_ = 1;                     ///< of a unit of time
  std::vector<Target> targets_;            ///< of nodes that are no tracks
  std::vector<std::size_t> others_;        ///< channels that have no target
  std::vector<double> pieces_;             ///< of the current curve, row after row
  double first_time_ = 0, last_time_ = 0;  ///< of its keyframes
  std::vector<Node> nodes_;
  std::set<std::pair<std::string, std::string_view>> known_;  ///< names of nodes, with the path of their first target
};

}  // namespace

/// Rows come as the bytes of doubles.
extern const OutputFormat gltf_output{
    .layout =
        [](const std::vector<OutputColumn>& columns, const TextMarks& marks, bool header) {
          Layout layout = npy_layout(columns, marks, header);
          layout.head.clear();
          return layout;
        },
    .keeper = [](const Schema&, std::span<const std::size_t> fields) -> std::unique_ptr<RowKeeper> {
      const bool are_pieces = std::ranges::count(fields, field_of("time")) == 0;
      return std::make_unique<GltfScene>(are_pieces);
    },
    .has_labels = false,
    .gathers_rows = true};

}  // namespace tcb
