// FBX: the animation of a scene in an ASCII file of FBX (versions 6 and 7) as keys.
//
// An animation curve node of version 7, or a channel of a model of version 6, is a track of the object that it drives:
// position, rotation (x, y, z in degrees), scale, or another property. Its animation curves are the channels; a channel
// without keys has the constant that the node gives it. Where several takes or layers drive a property, each is a track
// with their names. Layers are not blended. Times are converted to seconds. The preset is fbx.
// Source: the documentation of the FBX SDK, and files of MotionBuilder, Maya and 3ds Max.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "read/scenes/fbx.hpp"
#include "read/scenes/tracks.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

/// A property of FBX, its name in version 6, and the track.
struct PropertyRow {
  std::string_view property, old_property, track;
};
constexpr std::string_view rotation_track = "rotation";
constexpr std::array properties{
    PropertyRow{"Lcl Translation", "T", "position"},
    PropertyRow{"Lcl Rotation", "R", rotation_track},
    PropertyRow{"Lcl Scaling", "S", "scale"},
};

std::string track_of_property(std::string_view property) {
  const auto row = std::ranges::find(properties, property, &PropertyRow::property);
  return std::string(row == properties.end() ? property : row->track);
}

/// The name of an object without its class, as in "Model::Cube".
std::string_view name_without_class(std::string_view name) {
  const std::size_t at = name.find("::");
  return at == std::string_view::npos ? name : name.substr(at + 2);
}

/// The name of a channel: x, y, z, or as the file has it, with "d|" before it in version 7.
std::string channel_name(std::string_view name) {
  if (name.starts_with("d|")) name.remove_prefix(2);
  if (name == "X" || name == "Y" || name == "Z") return {static_cast<char>(name[0] - 'X' + 'x')};
  return std::string(name);
}

/// How many values a node or its array has at most.
std::size_t values_in(const FbxNode& node) {
  const FbxNode* const array = node.find("a");
  return static_cast<std::size_t>(std::ranges::count(array == nullptr ? node.text : array->text, ',')) + 1;
}

/// The numbers of a property of a model, after its name and its types; nothing where it has no such property.
std::optional<std::array<double, 3>> property_of(const FbxNode& model, std::string_view wanted, std::size_t count) {
  for (const FbxNode& list : model.children) {
    const bool is_new = list.name == "Properties70";
    if (!is_new && list.name != "Properties60") continue;
    for (const FbxNode& property : list.children) {
      FbxValues values(property);
      if (values.at_end() || values.next() != wanted) continue;
      for (int skipped = is_new ? 3 : 2; skipped > 0; --skipped) values.next();
      std::array<double, 3> numbers{};
      constexpr double largest = 1e6;  // of angles and enumerators
      for (std::size_t i = 0; i < count; ++i) {
        numbers[i] = values.next_number().value;
        if (!(numbers[i] > -largest && numbers[i] < largest)) throw number_of_file_expected(wanted);
      }
      return numbers;
    }
  }
  return std::nullopt;
}

/// Angles around x, then y, then z of the parent, in degrees, as a quaternion.
std::array<double, 4> rotation_by_angles(const std::array<double, 3>& degrees) {
  constexpr spline::RotationNotation notation{spline::RotationForm::euler, {0, 1, 2}, false, true};
  const spline::Quaternion<double> q = spline::quaternion_from(degrees, notation);
  return {q.x, q.y, q.z, q.w};
}

/// The angles of a rotation of a model, in the order of the model and between its fixed rotations; nothing where these
/// or the angles are not known. Throws: Error (data) for properties that are no numbers.
/// Source: the properties PreRotation, PostRotation and RotationOrder, which count if RotationActive, in the FBX SDK.
std::optional<EulerTrack> euler_of(const FbxNode* model, const std::unordered_map<std::string, std::size_t>& places) {
  constexpr std::array<std::array<std::uint8_t, 3>, 6> orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
  constexpr std::array names{"x", "y", "z"};
  EulerTrack euler{.turns = {}, .degrees = true};
  std::size_t order = 0;
  if (model != nullptr && property_of(*model, "RotationActive", 1).value_or(std::array<double, 3>{})[0] != 0) {
    const double number = property_of(*model, "RotationOrder", 1).value_or(std::array<double, 3>{})[0];
    if (!(number >= 0 && number < static_cast<double>(orders.size()))) return std::nullopt;
    order = static_cast<std::size_t>(number);
    if (const auto before = property_of(*model, "PreRotation", 3)) euler.before = rotation_by_angles(*before);
    if (const auto after = property_of(*model, "PostRotation", 3)) {
      euler.after = rotation_by_angles(*after);
      for (std::size_t i = 0; i < 3; ++i) euler.after[i] = -euler.after[i];
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint8_t axis = orders[order][2 - i];  // the last turn is around an axis of the parent
    const auto place = places.find(names[axis]);
    if (place == places.end()) return std::nullopt;
    euler.turns[i] = {place->second, axis};
  }
  return euler;
}

/// A track while its channels are collected.
struct OpenTrack {
  struct Channel {
    std::string name;
    WrittenNumber constant = {};  ///< where it has no keys
    FbxCurve curve = {};

    bool has_keys() const { return !curve.keys.empty(); }
  };
  std::string object, name;
  std::string layer = {};  ///< the take and the layer
  std::vector<Channel> channels = {};
  std::unordered_map<std::string, std::size_t> places = {};  ///< of the channels, by their names
  const FbxNode* model = nullptr;                            ///< whose property it is
  std::optional<Error> failure = {};                         ///< why it is not read

  /// Appends a channel; one of the same name is returned.
  Channel& channel(std::string_view called) {
    const std::string wanted = channel_name(called);
    const auto [place, is_new] = places.emplace(wanted, channels.size());
    return is_new ? channels.emplace_back(Channel{wanted}) : channels[place->second];
  }
  std::string path() const { return object + "/" + name; }

  /// It changes, or is not read.
  bool is_animated() const { return failure || std::ranges::any_of(channels, &Channel::has_keys); }

  /// The track; the keys are not kept here any more.
  Track finish() {
    Track track{object, name};
    track.settings.preset = spline::Preset::fbx;
    track.failure = failure;
    if (failure) return track;
    try {
      if (name == rotation_track) track.euler = euler_of(model, places);
    } catch (const Error&) {
      track.euler = std::nullopt;  // its curves of angles do not need them
    }
    const WrittenNumber start = std::ranges::find_if(channels, &Channel::has_keys)->curve.keys.front().time;
    for (Channel& channel : channels) {
      const FbxCurve constant{{FbxKey{{start, channel.constant}}}};
      try {
        track.channels.push_back(channel_of(channel.name, channel.has_keys() ? channel.curve : constant));
      } catch (const Error& error) {
        track.failure = error.about(path() + "/" + channel.name);
      }
      channel.curve = {};
    }
    return track;
  }
};

/// The objects and connections of version 7.
class Objects {
 public:
  /// `size`: of the file, in bytes.
  Objects(const FbxNode& file, const FbxHead& head, std::size_t size, MemoryUse& memory)
      : head_(head), most_keys_(size), memory_(memory) {
    for (const FbxNode& objects : file.children) {
      if (objects.name != "Objects") continue;
      for (const FbxNode& object : objects.children) add(object);
    }
    if (const FbxNode* const connections = file.find("Connections")) {
      for (const FbxNode& connection : connections->children) connect(connection);
    }
  }

  std::vector<OpenTrack> tracks() {
    std::vector<OpenTrack> tracks;
    for (const Object* const node : curve_nodes_) {
      for (const Link& link : node->parents) {
        if (link.property.empty() || link.object->kind() == "AnimationLayer") continue;
        OpenTrack track{object_name(*link.object), track_of_property(link.property), layer_of(*node)};
        track.model = link.object->node;
        add_channels(track, *node);
        tracks.push_back(std::move(track));
      }
    }
    return tracks;
  }

 private:
  struct Object;
  /// A connection to an object, or to a property of it.
  struct Link {
    const Object* object;
    std::string_view property;
  };
  struct Object {
    const FbxNode* node = nullptr;
    std::string_view name = {};
    std::vector<Link> parents = {}, children = {};

    std::string_view kind() const { return node->name; }
    /// The first object of a kind that it is connected to.
    const Object* parent(std::string_view wanted) const {
      const auto found = std::ranges::find(parents, wanted, [](const Link& link) { return link.object->kind(); });
      return found == parents.end() ? nullptr : found->object;
    }
  };

  void add(const FbxNode& node) {
    FbxValues values(node);
    if (values.at_end()) return;
    const std::string_view id = values.next();
    memory_.add(2 * sizeof(Object));
    Object& object = objects_[id];
    if (object.node == nullptr && node.name == "AnimationCurveNode") curve_nodes_.push_back(&object);
    object.node = &node;
    object.name = values.at_end() ? "" : name_without_class(values.next());
  }

  void connect(const FbxNode& node) {
    FbxValues values(node);
    if (node.name != "C" || values.at_end()) return;
    values.next();  // OO or OP
    const auto child = objects_.find(values.next()), parent = objects_.find(values.next());
    if (child == objects_.end() || parent == objects_.end()) return;  // the root, or what is not in the file
    const std::string_view property = values.at_end() ? "" : values.next();
    memory_.add(4 * sizeof(Link));  // as both lists grow
    child->second.parents.push_back({&parent->second, property});
    parent->second.children.push_back({&child->second, property});
  }

  /// Attributes, such as those of a camera, and what has no name have the name of their model.
  static std::string object_name(const Object& object) {
    const Object* const model = object.parent("Model");
    const bool has_own_name = !object.name.empty() && object.kind() != "NodeAttribute";
    const std::string_view name = has_own_name || model == nullptr ? object.name : model->name;
    return std::string(name.empty() ? object.kind() : name);
  }

  static std::string layer_of(const Object& node) {
    const Object* const layer = node.parent("AnimationLayer");
    if (layer == nullptr) return "";
    const Object* const take = layer->parent("AnimationStack");
    return take == nullptr ? std::string(layer->name) : fmt::format("{}, {}", take->name, layer->name);
  }

  void add_channels(OpenTrack& track, const Object& node) {
    if (const FbxNode* const list = node.node->find("Properties70")) {
      for (const FbxNode& property : list->children) {
        FbxValues values(property);
        if (values.at_end()) continue;
        const std::string_view name = values.next();
        if (!name.starts_with("d|")) continue;
        for (int skipped = 0; skipped < 3; ++skipped) values.next();  // types and flags
        if (!values.at_end()) track.channel(name).constant = values.next_number();
      }
      count_keys(track.channels.size(), track);
    }
    for (const Link& link : node.children) {
      if (link.object->kind() != "AnimationCurve" || link.property.empty()) continue;
      const FbxNode* const times = link.object->node->find("KeyTime");
      if (times != nullptr) memory_.add(memory_of_key * values_in(*times));
      FbxCurve& curve = track.channel(link.property).curve;
      try {
        curve = read_curve(*link.object->node, head_);
      } catch (const Error& error) {
        track.failure = error.about(track.path());
      }
      count_keys(curve.keys.size(), track);
    }
  }

  /// Bounds the memory of a file whose curves have many connections. Throws: Error (data).
  void count_keys(std::size_t keys, const OpenTrack& track) {
    keys_ += keys;
    if (keys_ > most_keys_)
      throw data_error(
          "the animation curves have so many connections that their keys are more than the bytes of the file; expected "
          "one connection of each curve; export the file again")
          .about(track.path());
  }

  const FbxHead head_;
  std::size_t keys_ = 0;  ///< that were read, and constants of channels
  const std::size_t most_keys_;
  MemoryUse& memory_;
  std::map<std::string_view, Object> objects_;  ///< by number
  std::vector<const Object*> curve_nodes_;
};

/// The takes of version 6: channels within channels of models.
class Takes {
 public:
  Takes(const FbxNode& file, const FbxHead& head, MemoryUse& memory) : file_(file), head_(head), memory_(memory) {}

  std::vector<OpenTrack> tracks() {
    if (const FbxNode* const takes = file_.find("Takes")) {
      for (const FbxNode& take : takes->children) {
        if (take.name == "Take") read_take(take);
      }
    }
    return std::move(tracks_);
  }

 private:
  void read_take(const FbxNode& take) {
    const std::string_view name = FbxValues(take).next();
    for (const FbxNode& model : take.children) {
      if (model.children.empty()) continue;
      FbxValues values(model);
      if (values.at_end()) continue;
      const std::string_view full_name = values.next();
      OpenTrack track{std::string(name_without_class(full_name)), "", std::string(name)};
      track.model = model_called(full_name);
      for (const FbxNode& channel : model.children) read_channel(channel, track);
    }
  }

  const FbxNode* model_called(std::string_view name) {
    if (models_.empty()) {
      for (const FbxNode& objects : file_.children) {
        if (objects.name != "Objects") continue;
        for (const FbxNode& object : objects.children) {
          FbxValues values(object);
          if (object.name == "Model" && !values.at_end()) models_.emplace(values.next(), &object);
        }
      }
    }
    const auto found = models_.find(name);
    return found == models_.end() ? nullptr : found->second;
  }

  /// A channel has keys, or channels that have keys, or is Transform with T, R and S.
  void read_channel(const FbxNode& node, const OpenTrack& model) {
    if (node.name != "Channel") return;
    const std::string_view name = FbxValues(node).next();
    if (name == "Transform") {
      for (const FbxNode& channel : node.children) read_channel(channel, model);
      return;
    }
    memory_.add(memory_of_keys(node));
    OpenTrack track = model;
    const auto row = std::ranges::find(properties, name, &PropertyRow::old_property);
    track.name = row == properties.end() ? name : row->track;
    try {
      const FbxNode* const nested = node.find("Channel");
      if (nested == nullptr) add_keys(track, name, node);
      for (const FbxNode& channel : node.children) {
        if (channel.name == "Channel") add_keys(track, FbxValues(channel).next(), channel);
      }
    } catch (const Error& error) {
      track.failure = error.about(track.path());
    }
    tracks_.push_back(std::move(track));
  }

  /// Of a channel and those in it; a key has at least three values: time, value, and kind.
  static std::uint64_t memory_of_keys(const FbxNode& channel) {
    const FbxNode* const keys = channel.find("Key");
    std::uint64_t memory = sizeof(OpenTrack) + (keys == nullptr ? 0 : memory_of_key * (values_in(*keys) / 3));
    for (const FbxNode& inner : channel.children) {
      if (inner.name == "Channel") memory += memory_of_keys(inner);
    }
    return memory;
  }

  void add_keys(OpenTrack& track, std::string_view name, const FbxNode& node) const {
    OpenTrack::Channel& channel = track.channel(name);
    channel.curve = read_old_curve(node, head_);
    if (const FbxNode* const constant = node.find("Default")) channel.constant = FbxValues(*constant).next_number();
  }

  const FbxNode& file_;
  const FbxHead head_;
  MemoryUse& memory_;
  std::map<std::string_view, const FbxNode*> models_;  ///< by name
  std::vector<OpenTrack> tracks_;
};

FbxHead read_head(const FbxNode& file) {
  const FbxNode* const node = file.find("FBXHeaderExtension");
  if (node == nullptr || node->find("FBXVersion") == nullptr)
    throw data_error(
        "the text is not an FBX file; expected the node FBXHeaderExtension with an FBXVersion; give another "
        "--input-format")
        .at({"", 1, 1});
  FbxHead head;
  const FbxNode& version = node->child("FBXVersion");
  head.version = FbxValues(version).next_integer();
  constexpr std::int64_t first_version = 6000, last_version = 7999;
  if (head.version < first_version || head.version > last_version) {
    throw data_error("the FBX file is of version {}; expected 6000 to 7999; export it as FBX 7.4", head.version)
        .at({"", version.line, 0});
  }
  // Source: the definition of time codes in the FBX SDK 2020. Files without it have the default.
  constexpr std::int64_t first_header = 1004, default_definition = 127, ticks_of_others = 141'120'000;
  const FbxNode* const header = node->find("FBXHeaderVersion");
  const FbxNode* const flags = node->find("OtherFlags");
  if (header != nullptr && flags != nullptr && FbxValues(*header).next_integer() >= first_header) {
    const FbxNode* const definition = flags->find("TCDefinition");
    if (definition != nullptr && FbxValues(*definition).next_integer() != default_definition) {
      head.ticks_per_second = ticks_of_others;
    }
  }
  return head;
}

/// The names of objects and tracks become distinct: takes and layers where several drive a property, then numbers.
void name_apart(std::vector<OpenTrack>& tracks) {
  std::map<std::string, std::size_t> count, number;
  for (const OpenTrack& track : tracks) ++count[track.path()];
  for (OpenTrack& track : tracks) {
    if (count[track.path()] > 1 && !track.layer.empty()) track.name += fmt::format(" ({})", track.layer);
    const std::size_t nth = ++number[track.path()];
    if (nth > 1) track.object += fmt::format(" ({})", nth);
  }
}

std::vector<Track> read_tracks(std::string_view text, MemoryUse& memory) {
  const FbxNode file = parse_fbx(text, memory);
  const FbxHead head = read_head(file);
  constexpr std::int64_t first_with_connections = 7000;
  std::vector<OpenTrack> found = head.version >= first_with_connections
                                     ? Objects(file, head, text.size(), memory).tracks()
                                     : Takes(file, head, memory).tracks();
  std::erase_if(found, [](const OpenTrack& track) { return !track.is_animated(); });
  name_apart(found);
  std::vector<Track> tracks;
  for (OpenTrack& track : found) tracks.push_back(track.finish());
  return tracks;
}

constexpr SceneFormat fbx{read_tracks, false, true};

}  // namespace

extern const InputFormat fbx_input =
    input_of_scenes<fbx>([](std::string_view beginning) { return beginning.starts_with("; FBX"); });

}  // namespace tcb
