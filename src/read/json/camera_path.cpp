// Camera paths: the keyframes of nerfstudio as keys. The curve has the preset nerfstudio, is closed if the path is a
// cycle, and its tension is smoothness_value.
//
// Source: the viewer of nerfstudio, which writes and reads such files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "numbers/parse_number.hpp"
#include "read/input.hpp"
#include "read/json/text.hpp"
#include "read/key_builder.hpp"
#include "schema/pose_formats.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using Kind = Json::Kind;

constexpr std::string_view keyframe_list = "keyframes";
constexpr std::size_t matrix_size = 16;  // 4 x 4, row by row
constexpr std::size_t root = 1;

Error no_keyframes() {
  return data_error(
      "the input has no keyframes; expected an object with a list \"keyframes\" that is not empty, as nerfstudio saves "
      "camera paths; give another --input-format");
}

class CameraValues {
 public:
  explicit CameraValues(const Json& json) : json_(json) {}

  WrittenNumber number_of(std::size_t value) const {
    if (json_.is_nested(value)) throw at(value, data_error("this is not a number; expected one, as in the first key"));
    if (json_.kind(value) != Kind::number)
      throw at(value, data_error("{} is not a number; expected a number", in_quotes(json_.text(value))));
    const std::string_view decimal = json_.text(value);
    return {parse_number(decimal).value_or(0), std::string(decimal)};
  }

  /// The number of a member; nothing where it is null or not there.
  std::optional<WrittenNumber> number(std::size_t object, std::string_view name) const {
    const auto value = json_.member(object, name);
    return value && json_.kind(*value) != Kind::null ? std::optional(number_of(*value)) : std::nullopt;
  }

  /// A number among the members around the keyframes, of which arrays are none.
  std::optional<WrittenNumber> number_around(std::string_view name) const {
    const auto value = json_.member(root, name);
    return value && json_.kind(*value) == Kind::array ? std::nullopt : number(root, name);
  }

  /// A member around the keyframes, if it is a number.
  std::optional<WrittenNumber> number_if_any(std::string_view name) const {
    const auto value = json_.member(root, name);
    return value && json_.kind(*value) == Kind::number ? std::optional(number_of(*value)) : std::nullopt;
  }

  /// Whether a member is true. One that is null or an object, or not there, is false.
  bool is_true(std::size_t object, std::string_view name) const {
    const auto value = json_.member(object, name);
    if (!value || json_.kind(*value) == Kind::null || json_.kind(*value) == Kind::object) return false;
    if (json_.kind(*value) != Kind::boolean) {
      throw at(*value, data_error("found {}; expected true or false", in_quotes(json_.text(*value))));
    }
    return json_.text(*value) == "true";
  }

  /// The 4 x 4 matrix of a keyframe, row by row.
  std::vector<WrittenNumber> matrix_of(std::size_t keyframe) const {
    const auto value = json_.member(keyframe, "matrix");
    if (!value) {
      throw data_error(
          "the keyframe has no matrix; expected a 4 x 4 matrix of 16 numbers, row by row; add it, or remove the "
          "keyframe");
    }
    if (json_.kind(*value) == Kind::string) {
      throw at(
          *value,
          data_error("the matrix is a text, as in files of nerfstudio before version 1, whose curve is another one; "
                     "expected 16 numbers; give --input-format json --records camera_path --parameter uniform "
                     "--columns 'position=camera_to_world[3]:camera_to_world[7]:camera_to_world[11]' for its frames"));
    }
    if (json_.kind(*value) != Kind::array)
      throw at(*value, data_error("this is not an array; expected one of numbers, as in the first key"));
    if (const std::size_t size = json_.count(*value); size != matrix_size) {
      throw at(*value, data_error("the matrix has {}; expected 16, row by row", how_many(size, "number")));
    }
    std::vector<WrittenNumber> numbers;
    for (const std::size_t element : json_.inside(*value)) numbers.push_back(number_of(element));
    for (std::size_t i = 12; i < matrix_size; ++i) {
      if (numbers[i].value == (i == 15 ? 1 : 0)) continue;
      throw data_error(
          "the last row of the matrix is not 0, 0, 0, 1; expected the 4 x 4 matrix of a pose, row by row; correct it, "
          "or transpose the matrix")
          .about(json_.path(root, *value));
    }
    return numbers;
  }

  /// The members besides the cameras and their rate, which are to be written again.
  std::string members_besides_cameras() const {
    std::string all;
    std::unordered_set<std::string_view> names;
    for (const std::size_t value : json_.inside(root)) {
      const std::string_view name = json_.name(value);
      if (!names.insert(name).second) throw at(value - 1, twice_in("object"));
      if (name == "camera_path" || name == "fps" || name == "seconds") continue;
      all += fmt::format("{}{}:", all.empty() ? "" : ",", json_.written(value - 1));
      append(all, value);
    }
    return "{" + all + "}";
  }

 private:
  Error at(std::size_t value, const Error& error) const {
    return error.about(json_.path(root, value)).at(json_.position(value));
  }

  /// Appends a value as it is written, but for NaN, which JSON does not have.
  void append(std::string& text, std::size_t value) const {
    const std::string_view written = json_.written(value);
    std::size_t from = 0;
    for (std::size_t i = value; i < json_.next(value); ++i) {
      if (!json_.is(i, Kind::null)) continue;
      const std::size_t begin = json_.offset(i) - json_.offset(value);
      text.append(written.substr(from, begin - from)).append("null");
      from = begin + json_.written(i).size();
    }
    text += written.substr(from);
  }

  const Json& json_;
};

/// Adds keyframes to the keys.
class KeyframeReader {
 public:
  /// `transition` and `fov` are those of keyframes that have none.
  KeyframeReader(const Json& json, KeyBuilder& keys, const Columns& columns, WrittenNumber transition,
                 std::optional<WrittenNumber> fov)
      : json_(json),
        values_(json),
        keys_(keys),
        columns_(columns),
        transition_(std::move(transition)),
        fov_(std::move(fov)) {}

  /// Adds a keyframe at a time after that of the one before. Its faults are those of the keys.
  void add(std::size_t number, std::size_t keyframe) {
    const TextPosition position = json_.position(keyframe);
    position_ = {position.line, position.column};
    keys_.begin_key();
    try {
      read(number, keyframe);
    } catch (const Error& error) {
      add_fault(error);
    }
    if (!keys_.end_key()) return;
    keys_.set_number(number);
    keys_.set_position(position_.line, position_.column);
  }

  /// The time of the last keyframe, and for a cycle from there to the first one.
  const Rational& seconds() const { return seconds_; }
  const Rational& first_transition() const { return first_transition_; }

 private:
  void add_fault(const Error& error) { keys_.add_fault(error.at({"", position_.line, position_.column})); }

  void read(std::size_t number, std::size_t keyframe) {
    const auto of_member = [number](std::string_view member, const Error& error) {
      return error.about(fmt::format("{}[{}].{}", keyframe_list, number, member));
    };
    std::unordered_set<std::string_view> names;
    for (const std::size_t value : json_.inside(keyframe)) {
      if (names.insert(json_.name(value)).second) continue;
      throw of_member(json_.name(value), twice_in("key")).at(json_.position(value - 1));
    }
    const std::vector<WrittenNumber> matrix = values_.matrix_of(keyframe);
    const bool is_own = values_.is_true(keyframe, "override_transition_enabled");
    const auto own_transition = values_.number(keyframe, "override_transition_sec");
    const bool has_own = is_own && own_transition;
    const Rational duration = exact_number(has_own ? *own_transition : transition_);
    if (number > 0 && duration <= 0) {
      add_fault(of_member(
          has_own ? "override_transition_sec" : "default_transition_sec",
          data_error("the transition takes {} seconds; expected a number above 0; correct it, or remove the keyframe",
                     (has_own ? *own_transition : transition_).decimal)));
    }
    (number > 0 ? seconds_ : first_transition_) += duration;
    const auto required = [&](std::string_view name, const std::optional<WrittenNumber>& given) {
      if (given) return *given;
      throw of_member(name, data_error("the keyframe has no {}; expected a number in every keyframe", name));
    };
    std::vector<WrittenNumber> numbers{{nearest_double(seconds_), ratio_text(seconds_)}};
    constexpr std::array<std::size_t, 12> places{3, 7, 11, 0, 1, 2, 4, 5, 6, 8, 9, 10};  // the position comes first
    for (const std::size_t place : places) numbers.push_back(matrix[place]);
    const auto own_fov = values_.number(keyframe, "fov");
    numbers.push_back(required("fov", own_fov ? own_fov : fov_));
    const auto render_time = values_.number(keyframe, "render_time");
    if (numbers.size() < columns_.cells.size()) numbers.push_back(required("render_time", render_time));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Columns::Column& column = columns_.cells[i];
      const bool is_read = column.role == Role::time || column.role == Role::position || is_of_channel(column.role);
      if (is_read && !keys_.take(column, numbers[i].value, numbers[i].decimal)) {
        throw of_member(columns_.name_of(column), too_large(numbers[i].decimal));
      }
    }
  }

  const Json& json_;
  const CameraValues values_;
  KeyBuilder& keys_;
  const Columns& columns_;
  const WrittenNumber transition_;
  const std::optional<WrittenNumber> fov_;
  LinePosition position_;  ///< of the current keyframe
  Rational seconds_ = Rational(0), first_transition_ = Rational(0);
};

/// Lengths and speeds are those of the positions of the cameras, by the numbers of their channels.
std::optional<MetricSetting> metric_of(const Columns& columns, const TextPosition& position) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < columns.channels.size(); ++i) {
    if (std::ranges::count(names, columns.channels[i]) > 0) numbers.push_back(std::to_string(i + 1));
  }
  if (numbers.empty()) return std::nullopt;
  return MetricSetting{numbers, SettingOrigin{"metric", position}};
}

/// The frames that the viewer renders of a path that lasts so long: int(fps * seconds) of doubles, evenly in time.
std::optional<ViewerFrames> frames_of(const CameraValues& path, const Rational& duration) {
  constexpr double most = 1e9;
  const std::optional<WrittenNumber> rate = path.number_if_any("fps"), given = path.number_if_any("seconds");
  if (!rate || !(rate->value > 0) || duration <= 0) return std::nullopt;
  const Rational seconds = given ? exact_number(*given) : duration;
  const double count = std::floor(rate->value * nearest_double(seconds));
  if (!(count >= 1) || count > most) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(count);
  return ViewerFrames{exact_number(*rate), seconds, whole, duration / Rational(whole)};
}

/// A text fits if the first list in an object is "keyframes", and the first one of these has a matrix.
std::optional<int> fit_of_camera_path(std::string_view beginning) {
  constexpr std::string_view blanks = " \t\r\n";
  constexpr int fits = 3, fits_not = 0;
  const std::size_t first = beginning.find_first_not_of(blanks);
  if (first == std::string_view::npos) return std::nullopt;
  if (beginning[first] != '{') return fits_not;
  const std::size_t nested = beginning.find_first_of("[{}", first + 1);
  if (nested == std::string_view::npos) return std::nullopt;
  const std::string_view members = beginning.substr(0, nested);
  const std::size_t name = members.rfind('"', members.find_last_not_of(" \t\r\n:"));
  const bool is_list = beginning[nested] == '[' && name != std::string_view::npos &&
                       members.substr(0, name + 1).ends_with("\"keyframes\"");
  if (!is_list) return fits_not;
  const std::size_t keyframe = beginning.find_first_not_of(blanks, nested + 1);
  if (keyframe == std::string_view::npos) return std::nullopt;
  if (beginning[keyframe] != '{') return fits;
  const std::size_t end = beginning.find_first_of("{}", keyframe + 1);
  if (beginning.substr(keyframe, end - keyframe).find("\"matrix\"") != std::string_view::npos) return fits;
  return end == std::string_view::npos ? std::nullopt : std::optional(fits_not);
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
  std::optional<JsonBlock> block = JsonBlocks(std::move(bytes), options.max_memory).whole();
  if (!block) throw no_keyframes();
  const Json json(std::move(block->text), block->begin, block->nodes);
  if (!json.is(root, Kind::object) || json.count(0) > 1) throw no_keyframes();
  const TextPosition position = json.position(root);
  const auto list = json.member(root, keyframe_list);
  if (!list || !json.is(*list, Kind::array)) throw no_keyframes().at(position);
  const std::vector<std::uint32_t> keyframes = json.values(*list);
  std::vector<std::string> names{"t", "x", "y", "z"};
  for (const std::string_view name : rotation_columns_of(nerfstudio_poses)) names.emplace_back(name);
  names.emplace_back("fov");
  bool has_render_times = false;
  for (const std::uint32_t keyframe : keyframes) {
    if (!json.is(keyframe, Kind::object)) {
      throw data_error("found {} as a key; expected an object", json.shown(keyframe)).at(json.position(keyframe));
    }
    for (const std::size_t value : json.inside(keyframe)) {
      has_render_times |= json.name(value) == "render_time" && json.is(value, Kind::number);
    }
  }
  if (has_render_times) names.emplace_back("render_time");
  if (keyframes.empty()) throw no_keyframes().at(position);
  constexpr double usual_transition = 0.5;  // of the viewer, where a file has none
  const CameraValues path(json);
  const WrittenNumber tension = path.number_around("smoothness_value").value_or(WrittenNumber{});
  const auto transition = path.number_around("default_transition_sec").value_or(WrittenNumber{usual_transition, "0.5"});
  const std::optional<WrittenNumber> fov = path.number_around("default_fov");
  const bool is_cycle = path.is_true(root, "is_cycle");
  Records records;
  records.camera_path = path.members_besides_cameras();
  records.columns = at_position(position, [&] {
    return find_columns(names, std::vector<bool>(names.size(), true), options.columns.roles, options.columns.timeless);
  });
  if (!options.keys.tcb) options.keys.tcb = records.facts.tcb = spline::Tcb<double>{tension.value, 0, 0};
  KeyBuilder keys(records.columns, options.keys, units_of_keys(options.units, records.columns, ""));
  KeyframeReader reader(json, keys, records.columns, transition, fov);
  for (std::size_t i = 0; i < keyframes.size(); ++i) reader.add(i, keyframes[i]);
  CurveInfo& info = records.keys.curve_info;
  info.settings.preset = spline::Preset::nerfstudio;
  info.settings.closed = {is_cycle, {"is_cycle", position}};
  const Rational period = is_cycle ? reader.seconds() + reader.first_transition() : reader.seconds();
  info.frames = frames_of(path, period);
  if (is_cycle) info.settings.period = {{period}, {"is_cycle", position}};
  info.settings.metric = metric_of(records.columns, position);
  records.facts.shape = JsonShape::object;
  records.keys.blocks = each_of(std::deque{keys.finish(std::string(keyframe_list))});
  return records;
}

}  // namespace

extern const InputFormat camera_path_input{.open = open_camera_path,
                                           .options = options_of_camera_path,
                                           .fit = fit_of_camera_path,
                                           .has_own_columns = true,
                                           .has_frames = true};

}  // namespace tcb
