// 3D Studio: the keyframe tracks of .3ds files as keys.
//
// Each node has the tracks position, rotation, scale, field of view, roll, color, hotspot and falloff; a target has the
// track target. Times are frames. Rotations are relative to the key before, by an axis in the parent's frame and
// a left-handed angle, whose sign is changed here. Positions, rotations and scales are relative to
// the parent of the node. A track that loops is closed if its last key repeats the first one. The preset is lib3ds1.
// Source: the behaviour of lib3ds, which reads and writes such files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read/scenes/tracks.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

Error chunk_too_short() {
  return data_error(
      "a chunk of the file is longer or shorter than its content; expected a whole .3ds file; copy or export it again");
}

/// The numbers of chunks.
enum ChunkId : std::uint16_t {
  main_chunk = 0x4D4D,
  keyframes = 0xB000,
  first_node = 0xB001,
  camera_target = 0xB004,
  light_target = 0xB006,
  last_node = 0xB007,
  node_header = 0xB010,
  instance_name = 0xB011,
};

/// A track that is read.
struct TrackKind {
  std::uint16_t chunk;
  std::string_view name;
  std::vector<std::string_view> channels;
};
const std::array<TrackKind, 8> kinds{{
    {0xB020, "position", {"x", "y", "z"}},
    {0xB021, "rotation", {"angle", "axis_x", "axis_y", "axis_z"}},
    {0xB022, "scale", {"x", "y", "z"}},
    {0xB023, "fov", {"fov"}},
    {0xB024, "roll", {"roll"}},
    {0xB025, "color", {"red", "green", "blue"}},
    {0xB027, "hotspot", {"hotspot"}},
    {0xB028, "falloff", {"falloff"}},
}};

/// Bytes of a file, from which little-endian numbers are read.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) throw chunk_too_short();
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  std::uint32_t word(std::size_t size = 2) {
    std::uint32_t value = 0;
    const std::string_view bytes = take(size);
    for (std::size_t i = 0; i < size; ++i)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << 8 * i;
    return value;
  }
  float single() {
    const auto value = std::bit_cast<float>(word(4));
    if (!std::isfinite(value)) {
      throw data_error("a number of a key is infinite or no number; expected finite numbers; export the file again");
    }
    return value;
  }
  /// A text that ends with a zero.
  std::string_view name() {
    const std::size_t end = bytes_.find('\0');
    if (end == std::string_view::npos) throw chunk_too_short();
    const std::string_view name = take(end);
    (void)take(1);
    return name;
  }

 private:
  std::string_view bytes_;
};

/// Calls f(number, bytes) for each chunk.
template <class F>
void each_chunk(std::string_view chunks, F f) {
  for (Bytes bytes(chunks); bytes.left() > 0;) {
    constexpr std::uint32_t head = 6;
    const auto id = static_cast<std::uint16_t>(bytes.word());
    const std::uint32_t size = bytes.word(4);
    if (size < head) throw chunk_too_short();
    f(id, bytes.take(size - head));
  }
}

WrittenNumber number_of(float value) { return written_number(Rational(static_cast<double>(value))); }

/// An axis in the frame of the parent, and the angle from the key before.
GivenRotation turns_around_axes() {
  return {.notation = {.form = spline::RotationForm::axis_angle},
          .relative = true,
          .columns = {"axis_x", "axis_y", "axis_z", "angle"},
          .in_parent = true};
}

/// Reads the nodes of a file.
class Nodes {
 public:
  explicit Nodes(MemoryUse& memory) : memory_(memory) {}

  std::vector<Track> read(std::string_view file) {
    each_chunk(file, [this](std::uint16_t id, std::string_view content) {
      if (id == main_chunk)
        each_chunk(content, [this](std::uint16_t inner, std::string_view part) { read_part(inner, part); });
    });
    return std::move(tracks_);
  }

 private:
  void read_part(std::uint16_t id, std::string_view content) {
    if (id != keyframes) return;
    each_chunk(content, [this](std::uint16_t node, std::string_view part) {
      if (node >= first_node && node <= last_node) read_node(node, part);
    });
  }

  void read_node(std::uint16_t node, std::string_view content) {
    std::string name, instance;
    each_chunk(content, [&](std::uint16_t id, std::string_view part) {
      if (id == node_header) name = Bytes(part).name();
      if (id == instance_name) instance = Bytes(part).name();
    });
    const bool is_dummy = name == "$$$DUMMY" && !instance.empty();
    if (is_dummy) name = instance;
    const bool is_target = node == camera_target || node == light_target;
    const std::size_t number = ++names_[(is_target ? "target " : "") + name];
    if (number > 1) name += fmt::format(" ({})", number);
    each_chunk(content, [&](std::uint16_t id, std::string_view part) {
      const auto kind = std::ranges::find(kinds, id, &TrackKind::chunk);
      if (kind == kinds.end()) return;
      const std::string_view track = is_target && kind->name == "position" ? "target" : kind->name;
      try {
        add_track(name, track, *kind, part);
      } catch (const Error& error) {
        throw error.about(fmt::format("{}/{}", name, track));
      }
    });
  }

  void add_track(const std::string& object, std::string_view name, const TrackKind& kind, std::string_view content) {
    Bytes bytes(content);
    constexpr std::uint32_t loops = 2;
    const std::uint32_t flags = bytes.word();
    (void)bytes.take(8);  // unused
    const std::uint32_t count = bytes.word(4);
    Track track{object, std::string(name)};
    for (const std::string_view channel : kind.channels) track.channels.push_back({std::string(channel)});
    const bool is_rotation = kind.name == "rotation";
    if (is_rotation) track.rotation = turns_around_axes();
    for (std::uint32_t i = 0; i < count; ++i) {
      memory_.add(memory_of_key * track.channels.size());
      add_key(track, bytes, is_rotation);
    }
    if (bytes.left() > 0) throw chunk_too_short();
    if (count == 0) return;
    track.settings.preset = spline::Preset::lib3ds1;
    const auto repeats = [](const TrackChannel& channel) {
      return channel.keys.front().value.value == channel.keys.back().value.value;
    };
    if ((flags & loops) != 0 && count > 2 && !is_rotation && std::ranges::all_of(track.channels, repeats)) {
      track.settings.closed = {true, {"loop", {"", 1, 0}}};
    }
    tracks_.push_back(std::move(track));
  }

  static void add_key(Track& track, Bytes& bytes, bool is_rotation) {
    TrackKey key;
    const auto frame = static_cast<std::int32_t>(bytes.word(4));
    key.time = {static_cast<double>(frame), std::to_string(frame)};
    const std::uint32_t flags = bytes.word();
    for (unsigned bit = 0; bit < 5; ++bit) {
      if ((flags >> bit & 1U) == 0) continue;
      const std::array<WrittenNumber*, 5> numbers{&key.tension, &key.continuity, &key.bias, &key.ease_in,
                                                  &key.ease_out};
      *numbers.at(bit) = number_of(bytes.single());
      track.has_ease = track.has_ease || bit >= 3;
    }
    for (TrackChannel& channel : track.channels) {
      const float value = bytes.single();
      key.value = number_of(is_rotation && channel.name == "angle" ? -value : value);
      channel.keys.push_back(key);
    }
  }

  MemoryUse& memory_;
  std::map<std::string, std::size_t> names_;
  std::vector<Track> tracks_;
};

constexpr SceneFormat studio_3ds{[](std::string_view file, MemoryUse& memory) { return Nodes(memory).read(file); },
                                 true};

bool begins_3ds(std::string_view beginning) {
  constexpr std::size_t high_byte_of_size = 5;  // 0 below 16 MiB
  return beginning.starts_with("MM") && beginning.size() > high_byte_of_size && beginning[high_byte_of_size] == '\0';
}

}  // namespace

extern const InputFormat studio_3ds_input = input_of_scenes<studio_3ds>(begins_3ds);

}  // namespace tcb
