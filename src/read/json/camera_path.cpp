// Camera paths: the keyframes of nerfstudio as keys.
#include "read/json/camera_path.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "read/json/errors.hpp"
#include "read/json/object_reader.hpp"
#include "read/json/splitter.hpp"
#include "read/key_builder.hpp"
#include "read/written_number.hpp"
#include "schema/pose_formats.hpp"

namespace tcb {
namespace {

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

/// Reads objects by the members that they may have.
class MemberReader : public JsonObjectReader {
 public:
  using JsonObjectReader::JsonObjectReader;

 protected:
  bool on_member(const std::string& name) override {
    member_ = name;
    return true;
  }
  std::string_view member() const override { return member_; }

  /// The number of a member that is a number.
  WrittenNumber number_of(const spline::Time<double>& value) const {
    return {value.hi, decimal().empty() ? time_text(value) : std::string(decimal())};
  }

 private:
  std::string member_;
};

class KeyframeReader : public MemberReader {
 public:
  using MemberReader::MemberReader;
  std::vector<Keyframe> found;

 private:
  bool on_key_start() override {
    Keyframe& keyframe = found.emplace_back();
    keyframe.position = key_position();
    keyframe.number = key_number();
    seen_.clear();
    return true;
  }
  bool on_member(const std::string& name) override {
    (void)MemberReader::on_member(name);
    const bool repeats = std::ranges::count(seen_, name) > 0;
    seen_.push_back(name);
    return repeats ? fault(json::member_repeats()) : true;
  }
  std::optional<WrittenNumber>* number() {
    Keyframe& keyframe = found.back();
    if (member() == "fov") return &keyframe.fov;
    if (member() == "override_transition_sec") return &keyframe.transition;
    return member() == "render_time" ? &keyframe.render_time : nullptr;
  }
  bool on_number(const spline::Time<double>& value) override {
    if (member() == "matrix") {
      if (!in_array()) return fault(json::array_expected());
      if (element() < matrix_size) found.back().matrix.push_back(number_of(value));
      return true;
    }
    if (member() == "override_transition_enabled") return fault(json::true_or_false_expected(number_of(value).decimal));
    std::optional<WrittenNumber>* const one = number();
    if (one == nullptr) return true;
    if (in_array()) return fault(json::number_expected());
    *one = number_of(value);
    return true;
  }
  bool on_text(std::string_view text) override {
    if (member() == "matrix") return fault(in_array() ? json::not_a_number(text) : json::matrix_is_text());
    if (member() == "override_transition_enabled") {
      if (is_quoted() || in_array()) return fault(json::true_or_false_expected(text));
      found.back().has_own_transition = text == "true";
    }
    return number() == nullptr || fault(json::not_a_number(text));
  }
  bool on_null() override { return member() != "matrix" || fault(json::array_expected()); }
  bool on_nested() override {
    if (member() == "matrix" && in_array()) return fault(json::number_expected());
    return number() == nullptr || fault(json::number_expected());
  }
  bool on_array_end() override {
    if (member() != "matrix" || element() == matrix_size) return true;
    return fault(json::matrix_size(element()));
  }
  bool on_key_end() override {
    const Keyframe& keyframe = found.back();
    if (std::ranges::count(seen_, "matrix") == 0) add(at_key(json::matrix_missing()));
    if (keyframe.matrix.size() < matrix_size || !keyframe.faults.empty()) return true;
    const auto is_number = [&](std::size_t i, double value) { return keyframe.matrix[i].value == value; };
    const bool is_pose = is_number(12, 0) && is_number(13, 0) && is_number(14, 0) && is_number(15, 1);
    if (!is_pose) add(keyframe.at(json::last_row_of_matrix(), "matrix"));
    return true;
  }

  /// Adds a fault of the current value; true. An array is one fault.
  bool fault(const Error& error) {
    if (found.back().faults.empty()) add(at_value(error));
    return true;
  }
  void add(Error error) { found.back().faults.push_back(std::move(error)); }

  std::vector<std::string> seen_;
};

/// The members around the keyframes.
class AroundReader : public MemberReader {
 public:
  using MemberReader::MemberReader;
  std::optional<WrittenNumber> tension, fov, transition, rate, seconds;
  bool is_cycle = false;

 private:
  std::optional<WrittenNumber>* number() {
    if (member() == "smoothness_value") return &tension;
    if (member() == "default_fov") return &fov;
    return member() == "default_transition_sec" ? &transition : nullptr;
  }
  bool on_number(const spline::Time<double>& value) override {
    if (std::optional<WrittenNumber>* const one = number(); one != nullptr && !in_array()) *one = number_of(value);
    if (member() == "is_cycle") throw at_value(json::true_or_false_expected(number_of(value).decimal));
    if (!in_array() && member() == "fps") rate = number_of(value);
    if (!in_array() && member() == "seconds") seconds = number_of(value);
    return true;
  }
  bool on_text(std::string_view text) override {
    if (number() != nullptr) throw at_value(json::not_a_number(text));
    if (member() != "is_cycle") return true;
    if (is_quoted() || in_array()) throw at_value(json::true_or_false_expected(text));
    is_cycle = text == "true";
    return true;
  }
  bool on_null() override { return true; }
  bool on_nested() override {
    if (number() != nullptr) throw at_value(json::number_expected());
    return true;
  }
};

/// A camera path as it is written.
struct PathOfCameras {
  std::vector<Keyframe> keyframes;
  WrittenNumber tension, transition;           ///< of all keyframes, and of those that have no own
  std::optional<WrittenNumber> fov;            ///< of keyframes that have none
  std::optional<WrittenNumber> rate, seconds;  ///< of its frames
  bool is_cycle = false;
  bool has_render_times = false;
  TextPosition position;
  std::string members;  ///< as in Schema
};

/// The members besides the cameras and their rate, as they are to be written again.
std::string members_of(const std::string& text) {
  auto members = nlohmann::ordered_json::parse(text);
  for (const char* const made : {"camera_path", "fps", "seconds"}) members.erase(made);
  return members.dump();
}

PathOfCameras read_camera_path(Source<std::string> bytes) {
  PathOfCameras path;
  std::string text;
  JsonSplitter splitter(mapped(std::move(bytes),
                               [&text](std::string part) {
                                 text += part;
                                 return part;
                               }),
                        keyframe_list);
  constexpr double usual_transition = 0.5;  // of the viewer, where a file has none
  std::optional<JsonPart> around;
  while (std::optional<JsonPart> part = splitter.next()) {
    if (part->kind == JsonPart::Kind::object) {
      around = std::move(part);
      continue;
    }
    if (splitter.shape() != JsonShape::object) break;
    KeyframeReader reader(*part);
    reader.parse();
    std::ranges::move(reader.found, std::back_inserter(path.keyframes));
  }
  if (!around || splitter.shape() != JsonShape::object) throw json::no_keyframes();
  AroundReader settings(*around);
  settings.parse();
  path.position = {"", around->chunk.line, around->chunk.column};
  if (path.keyframes.empty()) throw json::no_keyframes().at(path.position);
  path.tension = settings.tension.value_or(WrittenNumber{0, "0"});
  path.transition = settings.transition.value_or(WrittenNumber{usual_transition, "0.5"});
  path.fov = settings.fov;
  path.rate = settings.rate;
  path.seconds = settings.seconds;
  path.is_cycle = settings.is_cycle;
  path.has_render_times =
      std::ranges::any_of(path.keyframes, [](const Keyframe& one) { return one.render_time.has_value(); });
  path.members = members_of(text);
  return path;
}

/// The names of the columns of keys.
std::vector<std::string> names_of(const PathOfCameras& path) {
  std::vector<std::string> names{"t", "x", "y", "z"};
  for (const std::string_view name : rotation_columns_of(pose_format(FormatId::nerfstudio))) names.emplace_back(name);
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
  if (!(seconds > 0)) keyframe.faults.push_back(keyframe.at(json::transition_not_positive(number.decimal), member));
  return seconds;
}

/// The numbers of a keyframe besides its time, in the order of the columns.
std::vector<WrittenNumber> numbers_of(Keyframe& keyframe, const PathOfCameras& path) {
  std::vector<WrittenNumber> numbers;
  if (keyframe.matrix.size() < matrix_size) return numbers;
  for (const std::size_t i : {3U, 7U, 11U, 0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) numbers.push_back(keyframe.matrix[i]);
  const auto add = [&](const std::optional<WrittenNumber>& number, std::string_view member) {
    if (!number) keyframe.faults.push_back(keyframe.at(json::number_of_keyframe_missing(member), member));
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
      keys.add_fault(keyframe.at(json::number_too_large(decimal), columns.name_of(column)));
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

}  // namespace

std::optional<bool> begins_camera_path(std::string_view beginning) {
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return std::nullopt;
  if (beginning[first] != '{') return false;
  const std::size_t nested = beginning.find_first_of("[{}", first + 1);
  if (nested == std::string_view::npos) return std::nullopt;
  const std::string_view members = beginning.substr(0, nested);
  const std::size_t name = members.rfind('"', members.find_last_not_of(" \t\r\n:"));
  return beginning[nested] == '[' && name != std::string_view::npos &&
         members.substr(0, name + 1).ends_with("\"keyframes\"");
}

InputOptions options_of_camera_path(InputOptions options) {
  if (options.rotation.requests.empty() && !options.rotation.none) {
    options.rotation.requests.push_back(rotation_of(pose_format(FormatId::nerfstudio)));
  }
  if (!options.units.time && !options.units.frame_rate) options.units.time = TimeUnit::s;
  return options;
}

Records open_camera_path(Source<std::string> bytes, const InputOptions& options) {
  if (options.delimited != DelimitedOptions{}) throw json::options_of_delimited_text();
  PathOfCameras path = read_camera_path(std::move(bytes));
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

}  // namespace tcb
