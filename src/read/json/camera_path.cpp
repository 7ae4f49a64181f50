// Camera paths: the keyframes of nerfstudio as keys. The curve has the preset nerfstudio, is closed if the path is a
// cycle, and its tension is smoothness_value.
//
// Source: the viewer of nerfstudio, which writes and reads such files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "read/input_format.hpp"
#include "read/json/keys.hpp"
#include "read/json/tape.hpp"
#include "read/key_builder.hpp"
#include "read/text_bytes.hpp"
#include "read/written_number.hpp"
#include "schema/pose_formats.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

constexpr std::string_view keyframe_list = "keyframes";
constexpr std::size_t matrix_size = 16;  // 4 x 4, row by row

/// A keyframe as it is written, and what is wrong with it.
struct Keyframe {
  LinePosition position = {};
  std::uint64_t number = 0;
  std::vector<WrittenNumber> matrix = {};
  std::optional<WrittenNumber> fov, transition, render_time;  ///< transition: its own, in seconds
  bool has_own_transition = false;
  std::vector<Error> faults = {};

  Error at(const Error& error, std::string_view member) const {
    return error.about(fmt::format("{}[{}].{}", keyframe_list, number, member))
        .at({"", position.line, position.column});
  }
};

/// A camera path as it is written.
struct PathOfCameras {
  std::vector<Keyframe> keyframes = {};
  WrittenNumber tension = {}, transition = {};           ///< of all keyframes, and of those that have no own
  std::optional<WrittenNumber> fov = {};                 ///< of keyframes that have none
  std::optional<WrittenNumber> rate = {}, seconds = {};  ///< of its frames
  bool is_cycle = false;
  bool has_render_times = false;
  TextPosition position = {};
  std::string members = {};  ///< as in Schema
};

Error array_expected() {
  return data_error("this is not an array; expected one of numbers, as in the first key; correct it");
}
Error number_expected() { return data_error("this is not a number; expected one, as in the first key; correct it"); }
Error not_a_number(std::string_view text) {
  return data_error("{} is not a number; expected a number; correct it", in_quotes(text));
}
Error true_or_false_expected(std::string_view found) {
  return data_error("found {}; expected true or false; correct it", in_quotes(found));
}
Error no_keyframes() {
  return data_error(
      "the input has no keyframes; expected an object with a list \"keyframes\" that is not empty, as nerfstudio saves "
      "camera paths; give another {}",
      option::input_format);
}

/// Reads a camera path from its tape.
class CameraPathReader {
 public:
  explicit CameraPathReader(const JsonTape& tape) : tape_(tape) {}

  PathOfCameras read() {
    if (tape_.kind(0) != Kind::object) throw no_keyframes();
    path_.position = tape_.position(0);
    const auto list = tape_.member(0, keyframe_list);
    if (!list || tape_.kind(*list) != Kind::array) throw no_keyframes().at(path_.position);
    counted_position_ = {path_.position.line, path_.position.column};
    tape_.for_each_element(*list, [&](std::size_t value) { return read_keyframe(value), true; });
    if (path_.keyframes.empty()) throw no_keyframes().at(path_.position);
    constexpr double usual_transition = 0.5;  // of the viewer, where a file has none
    path_.tension = number_around("smoothness_value").value_or(WrittenNumber{0, "0"});
    path_.transition = number_around("default_transition_sec").value_or(WrittenNumber{usual_transition, "0.5"});
    path_.fov = number_around("default_fov");
    path_.rate = number_if_any("fps");
    path_.seconds = number_if_any("seconds");
    read_cycle();
    path_.has_render_times =
        std::ranges::any_of(path_.keyframes, [](const Keyframe& one) { return one.render_time.has_value(); });
    path_.members = members_besides_cameras();
    return std::move(path_);
  }

 private:
  WrittenNumber number_of(std::size_t value) const {
    const std::string_view decimal = tape_.written(value);
    return {parse_number(decimal).value_or(0), std::string(decimal)};
  }
  /// The characters of a text, or a word as it is written.
  std::string_view text_of(std::size_t value) const {
    return tape_.kind(value) == Kind::string ? tape_.text(value) : tape_.written(value);
  }
  Error at(std::size_t value, const Error& error) const {
    return error.about(tape_.path(0, value).substr(1)).at(tape_.position(value));
  }

  void read_keyframe(std::size_t value) {
    if (tape_.kind(value) != Kind::object) throw not_a_record(tape_, value, false);
    const std::string_view text = tape_.part().chunk.text;
    counted_position_ = position_after(text.substr(counted_, tape_[value].begin - counted_), counted_position_);
    counted_ = tape_[value].begin;
    Keyframe& keyframe = path_.keyframes.emplace_back();
    keyframe.number = path_.keyframes.size() - 1;
    keyframe.position = counted_position_;
    std::unordered_set<std::string_view> names;
    tape_.for_each_member(value, [&](std::size_t name, std::size_t member) {
      if (!names.insert(tape_.text(name)).second) {
        add_fault(keyframe, name, data_error("the key has this member twice; expected it once; remove one"));
      }
      read_member(keyframe, tape_.text(name), member);
      return true;
    });
    if (!names.contains("matrix")) {
      keyframe.faults.push_back(
          data_error("the keyframe has no matrix; expected a 4 x 4 matrix of 16 numbers, row by row; add it, or remove "
                     "the keyframe")
              .at({"", keyframe.position.line, keyframe.position.column}));
    }
    if (keyframe.matrix.size() < matrix_size || !keyframe.faults.empty()) return;
    const auto is_number = [&](std::size_t i, double number) { return keyframe.matrix[i].value == number; };
    if (is_number(12, 0) && is_number(13, 0) && is_number(14, 0) && is_number(15, 1)) return;
    keyframe.faults.push_back(keyframe.at(
        data_error("the last row of the matrix is not 0, 0, 0, 1; expected the 4 x 4 matrix of a pose, row by row; "
                   "correct it, or transpose the matrix"),
        "matrix"));
  }

  /// An array is one fault.
  void add_fault(Keyframe& keyframe, std::size_t value, const Error& error) const {
    if (keyframe.faults.empty()) keyframe.faults.push_back(at(value, error));
  }

  void read_member(Keyframe& keyframe, std::string_view name, std::size_t value) const {
    const Kind kind = tape_.kind(value);
    if (name == "matrix") return read_matrix(keyframe, value);
    if (name == "override_transition_enabled") {
      keyframe.has_own_transition = tape_.written(value) == "true";
      if (kind == Kind::boolean || kind == Kind::null || kind == Kind::object) return;
      return add_fault(keyframe, value, true_or_false_expected(text_of(value)));
    }
    std::optional<WrittenNumber>* const number = name == "fov"                       ? &keyframe.fov
                                                 : name == "override_transition_sec" ? &keyframe.transition
                                                 : name == "render_time"             ? &keyframe.render_time
                                                                                     : nullptr;
    if (number == nullptr || kind == Kind::null) return;
    if (kind == Kind::number) {
      *number = number_of(value);
    } else {
      add_fault(keyframe, value, tape_[value].is_nested() ? number_expected() : not_a_number(text_of(value)));
    }
  }

  void read_matrix(Keyframe& keyframe, std::size_t value) const {
    if (tape_.kind(value) == Kind::string) {
      return add_fault(keyframe, value,
                       data_error("the matrix is a text, as in files of nerfstudio before version 1, whose curve is "
                                  "another one; expected 16 numbers; give {} json {} camera_path {} uniform {} "
                                  "position=camera_to_world[3]:camera_to_world[7]:camera_to_world[11] for its frames",
                                  option::input_format, option::records, option::parameter, option::columns));
    }
    if (tape_.kind(value) != Kind::array) return add_fault(keyframe, value, array_expected());
    tape_.for_each_element(value, [&](std::size_t element) {
      const Kind kind = tape_.kind(element);
      if (kind == Kind::number) {
        if (keyframe.matrix.size() < matrix_size) keyframe.matrix.push_back(number_of(element));
      } else {
        add_fault(keyframe, element,
                  tape_[element].is_nested() ? number_expected()
                  : kind == Kind::null       ? array_expected()
                                             : not_a_number(text_of(element)));
      }
      return true;
    });
    const std::size_t size = tape_.count(value);
    if (size == matrix_size) return;
    add_fault(
        keyframe, value,
        data_error("the matrix has {} number{}; expected 16, row by row; correct it", size, size == 1 ? "" : "s"));
  }

  /// A number among the members around the keyframes, of which arrays and null are none.
  std::optional<WrittenNumber> number_around(std::string_view name) const {
    const auto value = tape_.member(0, name);
    if (!value || tape_.kind(*value) == Kind::null || tape_.kind(*value) == Kind::array) return std::nullopt;
    if (tape_.kind(*value) == Kind::number) return number_of(*value);
    throw at(*value, tape_.kind(*value) == Kind::object ? number_expected() : not_a_number(text_of(*value)));
  }

  /// A member around the keyframes, if it is a number.
  std::optional<WrittenNumber> number_if_any(std::string_view name) const {
    const auto value = tape_.member(0, name);
    return value && tape_.kind(*value) == Kind::number ? std::optional(number_of(*value)) : std::nullopt;
  }

  void read_cycle() {
    const auto value = tape_.member(0, "is_cycle");
    if (!value || tape_.kind(*value) == Kind::null || tape_.kind(*value) == Kind::object) return;
    if (tape_.kind(*value) != Kind::boolean) throw at(*value, true_or_false_expected(text_of(*value)));
    path_.is_cycle = tape_.written(*value) == "true";
  }

  /// The members besides the cameras and their rate, as they are to be written again.
  std::string members_besides_cameras() const {
    std::string all;
    std::unordered_set<std::string_view> names;
    tape_.for_each_member(0, [&](std::size_t name, std::size_t value) {
      const std::string_view text = tape_.text(name);
      if (!names.insert(text).second) {
        throw at(name, data_error("the object has this member twice; expected it once; remove one"));
      }
      const bool is_made = text == "camera_path" || text == "fps" || text == "seconds";
      if (!is_made) write_member(all, name, value);
      return true;
    });
    return "{" + all + "}";
  }

  void write_member(std::string& text, std::size_t name, std::size_t value) const {
    if (!text.empty() && text.back() != '{') text += ',';
    text += nlohmann::json(std::string(tape_.text(name))).dump() + ":";
    write(text, value);
  }

  void write(std::string& text, std::size_t value) const {
    switch (tape_.kind(value)) {
      case Kind::object:
        text += '{';
        tape_.for_each_member(
            value, [&](std::size_t name, std::size_t member) { return write_member(text, name, member), true; });
        text += '}';
        return;
      case Kind::array:
        text += '[';
        tape_.for_each_element(value, [&](std::size_t element) {
          if (text.back() != '[') text += ',';
          return write(text, element), true;
        });
        text += ']';
        return;
      case Kind::string: text += nlohmann::json(std::string(tape_.text(value))).dump(); return;
      case Kind::number: text += number_in_json(tape_.written(value)); return;
      case Kind::null: text += "null"; return;
      default: text += tape_.written(value);
    }
  }

  /// A whole number as it is; others as nlohmann-json writes them.
  static std::string number_in_json(std::string_view decimal) {
    const std::string text = json_number_text(decimal);
    const bool is_whole = decimal.find_first_of(".eE") == std::string_view::npos && decimal != "-0";
    return is_whole && text == decimal ? text
           : decimal == "-0"           ? "0"
                                       : nlohmann::json(parse_number(decimal).value_or(0)).dump();
  }

  const JsonTape& tape_;
  PathOfCameras path_;
  std::size_t counted_ = 0;        ///< a place in the text,
  LinePosition counted_position_;  ///< and its position
};

PathOfCameras read_camera_path(const Source<std::string>& bytes, std::uint64_t max_memory) {
  TextBytes text_bytes(bytes);
  JsonPart part{JsonPart::Kind::whole, {}};
  while (text_bytes.append_to(part.chunk.text, {1, 1})) MemoryUse(max_memory).add(part.chunk.text.size());
  if (std::ranges::all_of(part.chunk.text, is_json_blank)) throw no_keyframes();
  const JsonTape tape(part, max_memory);
  return CameraPathReader(tape).read();
}

/// The names of the columns of keys.
std::vector<std::string> names_of(const PathOfCameras& path) {
  std::vector<std::string> names{"t", "x", "y", "z"};
  for (const std::string_view name : rotation_columns_of(nerfstudio_poses)) names.emplace_back(name);
  names.emplace_back("fov");
  if (path.has_render_times) names.emplace_back("render_time");
  return names;
}

/// The duration of the transition to a keyframe.
Rational transition_to(Keyframe& keyframe, const PathOfCameras& path) {
  const bool is_own = keyframe.has_own_transition && keyframe.transition;
  const WrittenNumber& number = is_own ? *keyframe.transition : path.transition;
  const std::string_view member = is_own ? "override_transition_sec" : "default_transition_sec";
  Rational seconds = exact_number(number);
  if (!(seconds > 0))
    keyframe.faults.push_back(
        keyframe.at(data_error("the transition takes {} seconds; expected a number above 0; correct it, "
                               "or remove the keyframe",
                               number.decimal),
                    member));
  return seconds;
}

/// The numbers of a keyframe besides its time, in the order of the columns.
std::vector<WrittenNumber> numbers_of(Keyframe& keyframe, const PathOfCameras& path) {
  std::vector<WrittenNumber> numbers;
  if (keyframe.matrix.size() < matrix_size) return numbers;
  for (const std::size_t i : {3U, 7U, 11U, 0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) numbers.push_back(keyframe.matrix[i]);
  const auto add = [&](const std::optional<WrittenNumber>& number, std::string_view member) {
    if (!number)
      keyframe.faults.push_back(keyframe.at(
          data_error("the keyframe has no {}; expected a number in every keyframe; add it", member), member));
    numbers.push_back(number.value_or(WrittenNumber{}));
  };
  add(keyframe.fov ? keyframe.fov : path.fov, "fov");
  if (path.has_render_times) add(keyframe.render_time, "render_time");
  return numbers;
}

/// Adds a keyframe to the keys.
void add_key(KeyBuilder& keys, Keyframe& keyframe, const PathOfCameras& path, const Columns& columns,
             const Rational& seconds) {
  keys.begin_key();
  const std::vector<WrittenNumber> numbers = numbers_of(keyframe, path);
  for (Error& fault : keyframe.faults) keys.add_fault(std::move(fault));
  for (std::size_t i = 0; i < columns.cells.size() && i <= numbers.size(); ++i) {
    const Columns::Column& column = columns.cells[i];
    const std::string decimal = i == 0 ? ratio_text(seconds) : numbers[i - 1].decimal;
    if (column.role == Role::time) {
      keys.set_time(i == 0 ? nearest_time(seconds) : parse_time(decimal).value_or(Time(numbers[i - 1].value)));
    } else if (i > 0 && (column.role == Role::position || is_of_channel(column.role))) {
      keys.number(column) = numbers[i - 1].value;
    } else {
      continue;
    }
    if (keys.keeps_decimals()) keys.keep_decimal(column, decimal);
    if (keys.scales() && !keys.scale(column, decimal)) {
      keys.add_fault(
          keyframe.at(data_error("{} is too large for a double; expected less than 1.8e308 in size; correct it",
                                 in_quotes(decimal)),
                      columns.name_of(column)));
    }
  }
  if (!keys.end_key()) return;
  keys.set_number(keyframe.number);
  keys.set_position(keyframe.position.line, keyframe.position.column);
}

/// Lengths and speeds are those of the positions of the cameras, by the numbers of their channels.
std::optional<TextSetting> metric_of(const Columns& columns, const TextPosition& position) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < columns.channels.size(); ++i) {
    if (std::ranges::count(names, columns.channels[i]) > 0) numbers.push_back(i + 1);
  }
  if (numbers.empty()) return std::nullopt;
  return TextSetting{fmt::format("{}", fmt::join(numbers, ",")), {"metric", position}};
}

/// The frames that the viewer renders of a path that lasts so long: int(fps * seconds) of doubles, evenly in time.
std::optional<ViewerFrames> frames_of(const PathOfCameras& path, const Rational& duration) {
  constexpr double most = 1e9;
  if (!path.rate || !(path.rate->value > 0) || duration <= 0) return std::nullopt;
  const Rational seconds = path.seconds ? exact_number(*path.seconds) : duration;
  const double count = std::floor(path.rate->value * nearest_double(seconds));
  if (!(count >= 1) || count > most) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(count);
  return ViewerFrames{exact_number(*path.rate), seconds, whole, duration / Rational(whole)};
}

/// Whether the beginning of a text is that of a camera path: the first list in an object is "keyframes", and the first
/// one of these has a matrix. Nothing: that depends on the text that follows.
std::optional<bool> begins_camera_path(std::string_view beginning) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = beginning.find_first_not_of(blanks);
  if (first == std::string_view::npos) return std::nullopt;
  if (beginning[first] != '{') return false;
  const std::size_t nested = beginning.find_first_of("[{}", first + 1);
  if (nested == std::string_view::npos) return std::nullopt;
  const std::string_view members = beginning.substr(0, nested);
  const std::size_t name = members.rfind('"', members.find_last_not_of(" \t\r\n:"));
  const bool is_list = beginning[nested] == '[' && name != std::string_view::npos &&
                       members.substr(0, name + 1).ends_with("\"keyframes\"");
  if (!is_list) return false;
  const std::size_t keyframe = beginning.find_first_not_of(blanks, nested + 1);
  if (keyframe == std::string_view::npos) return std::nullopt;
  if (beginning[keyframe] != '{') return true;
  const std::size_t end = beginning.find_first_of("{}", keyframe + 1);
  if (beginning.substr(keyframe, end - keyframe).find("\"matrix\"") != std::string_view::npos) return true;
  return end == std::string_view::npos ? std::nullopt : std::optional(false);
}

std::optional<int> fit_of_camera_path(std::string_view beginning) {
  const std::optional<bool> begins = begins_camera_path(beginning);
  return begins ? std::optional(*begins ? 3 : 0) : std::nullopt;
}

/// The options with the rotation of camera paths and their unit of times, unless others are requested.
InputOptions options_of_camera_path(const Format&, Source<std::string>&, InputOptions options) {
  if (options.rotation.requests.empty() && !options.rotation.none) {
    options.rotation.requests.push_back(rotation_of(nerfstudio_poses));
  }
  if (!options.units.time && !options.units.frame_rate) options.units.time = TimeUnit::s;
  return options;
}

/// Keys with x, y, z, the matrix r11 to r33, fov in degrees, and render_time where the keyframes have it; the first one
/// is at 0 seconds.
Records open_camera_path(const Format&, Source<std::string> bytes, InputOptions options) {
  PathOfCameras path = read_camera_path(bytes, options.max_memory);
  const std::vector<std::string> names = names_of(path);
  Records records;
  records.columns = at_position(path.position, [&] {
    return find_columns(names, std::vector<bool>(names.size(), true), options.columns.roles, options.columns.timeless);
  });
  const spline::Tcb<double> tcb{path.tension.value, 0, 0};
  KeyRules rules = options.keys;
  if (!rules.tcb) rules.tcb = records.facts.tcb = tcb;
  KeyBuilder keys(records.columns, rules, units_of_keys(options.units, records.columns, ""));
  Rational seconds(0);
  for (Keyframe& keyframe : path.keyframes) {
    if (keyframe.number > 0) seconds += transition_to(keyframe, path);
    add_key(keys, keyframe, path, records.columns, seconds);
  }
  CurveInfo& info = records.keys.curve_info;
  info.settings.preset = {std::string(spline::name_of(spline::Preset::nerfstudio)), {"preset", path.position}};
  info.settings.closed = {path.is_cycle, {"is_cycle", path.position}};
  const Rational period = path.is_cycle ? seconds + transition_to(path.keyframes.front(), path) : seconds;
  info.frames = frames_of(path, period);
  if (path.is_cycle) {
    info.settings.period = {ratio_text(period), {"is_cycle", path.position}};
  }
  info.settings.metric = metric_of(records.columns, path.position);
  records.facts.shape = JsonShape::object;
  records.camera_path = std::move(path.members);
  records.keys.blocks = [block = std::optional(keys.finish(std::string(keyframe_list)))]() mutable {
    return std::exchange(block, std::nullopt);
  };
  return records;
}

}  // namespace

extern const InputFormat camera_path_input{.open = open_camera_path,
                                           .options = options_of_camera_path,
                                           .fit = fit_of_camera_path,
                                           .takes_delimiters = false,
                                           .has_own_columns = true,
                                           .has_frames = true};

}  // namespace tcb
