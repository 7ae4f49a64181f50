// Settings in JSON: the members around keys, which are settings of the curve, channel names and an id; provenance.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "read/json/json_input.hpp"
#include "read/json/object_reader.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Json = nlohmann::json;

/// Options that are not members.
constexpr std::array options_only{
    std::pair{std::string_view("equal-speed"), option::equal_speed},
    std::pair{std::string_view("parameter"), option::parameter},
    std::pair{std::string_view("metric"), option::metric},
    std::pair{std::string_view("extrapolate"), option::extrapolate},
    std::pair{std::string_view("no-ease"), option::no_ease},
    std::pair{std::string_view("rotation-curve"), option::rotation_curve},
    std::pair{std::string_view("rotation-output"), option::rotation_output},
    std::pair{std::string_view("angles"), option::angles},
    std::pair{std::string_view("normalize"), option::normalize},
};

class SettingsReader : public JsonObjectReader {
 public:
  using JsonObjectReader::JsonObjectReader;
  JsonCurveInfo found;

 private:
  bool on_member(const std::string& name) override {
    constexpr std::array<std::string_view, 9> known{"preset",   "tangents", "ends",   "closed", "period",
                                                    "channels", "keys",     "curves", "id"};
    member_ = name;
    known_ = std::ranges::find(known, name) != known.end();
    require_no_loss(name);
    if (!known_) {
      if (nearest_name(name, known).empty()) return true;
      const std::vector<std::string> names(known.begin(), known.end());
      throw Error(Exit::data, ErrorCode::setting_nearly_known, {name, names, path()}).at(value_position());
    }
    if (std::ranges::find(members_, name) != members_.end()) throw value_error(ErrorCode::setting_repeats);
    members_.push_back(name);
    return true;
  }

  /// Throws: Error (data) for a name that has a meaning only elsewhere.
  void require_no_loss(const std::string& name) const {
    constexpr std::array of_keys{Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out};
    const auto of_channel = channel_role_of(name);
    const bool is_tcb = of_channel && of_channel->role < Role::velocity;
    if (name == "tcb" || is_tcb || std::ranges::count(of_keys, role_of_name(name)) > 0) {
      throw value_error(ErrorCode::setting_of_keys);
    }
    std::string option = name;
    std::ranges::replace(option, '_', '-');
    const auto known = std::ranges::find(options_only, option, [](const auto& row) { return row.first; });
    if (known != options_only.end()) throw value_error(ErrorCode::setting_is_option).about(known->second);
  }

  bool on_number(const spline::Time<double>& value) override {
    note_number();
    return take(time_text(value));
  }
  void on_deep_value(bool is_number) override {
    if (is_number) note_number();
  }
  bool on_null() override { return take("null"); }
  bool on_nested() override {
    if (member_ == "id") throw value_error(ErrorCode::setting_id_expected);
    return take("an object");
  }
  bool on_text(std::string_view text) override {
    if (member_ != "id" || !is_quoted()) return take(text);
    found.curve_info.id = '"' + std::string(text);
    return true;
  }

  /// Numbers of no setting are not used, except those about the rows of an earlier output.
  void note_number() {
    if (known_ || member_ == "meta" || std::ranges::count(found.unused, member_) > 0) return;
    found.unused.push_back(member_);
  }

  bool take(std::string_view text) {
    if (!known_) return true;
    const std::string value(text);
    CurveSettings& settings = found.curve_info.settings;
    if (member_ != "id") found.curve_info.places.emplace_back(member_, value_position());
    if (member_ == "channels") take_channel(value);
    if (member_ == "preset") settings.preset = value;
    if (member_ == "tangents") settings.tangents = value;
    if (member_ == "ends") settings.ends = settings.ends && in_array() ? *settings.ends + "," + value : value;
    if (member_ == "period") settings.period = value;
    if (member_ == "id") {
      if (in_array()) throw value_error(ErrorCode::setting_id_expected);
      found.curve_info.id = value == "null" ? "" : value;
    }
    if (member_ != "closed") return true;
    if (is_quoted() || (text != "true" && text != "false")) {
      throw value_error(ErrorCode::setting_closed_expected, {value});
    }
    settings.closed = text == "true";
    return true;
  }

  void take_channel(const std::string& name) {
    if (!in_array() || !is_quoted()) throw value_error(ErrorCode::setting_channels_expected);
    found.channels.push_back(name);
  }

  std::string member_;
  bool known_ = false;  ///< the member is a setting
  std::vector<std::string> members_;
};

/// The text without its rows.
Json without_rows(std::string_view text) {
  const auto keep = [](int, Json::parse_event_t event, Json& parsed) {
    return event != Json::parse_event_t::key || (parsed != "rows" && parsed != "curves");
  };
  return Json::parse(text, keep, false);
}

std::string_view last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n") + 1;
  const std::size_t before = text.substr(0, end).find_last_of('\n');
  return text.substr(0, end).substr(before == std::string_view::npos ? 0 : before + 1);
}

std::string text_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

JsonCurveInfo read_curve_info(const JsonPart& part) {
  SettingsReader reader(part);
  reader.parse_object();
  reader.found.path = part.chunk.path;
  reader.found.position = {"", part.chunk.line, part.chunk.column};
  return std::move(reader.found);
}

std::vector<std::string> channels_before_keys(const JsonPart& part) {
  JsonPart whole = part;
  if (whole.gap != std::string::npos) whole.chunk.text.resize(whole.gap - 2);
  whole.gap = std::string::npos;
  whole.chunk.text += "[]}";
  try {
    return read_curve_info(whole).channels;
  } catch (const Error&) {
    return {};  // thrown again when the whole object is read
  }
}

EarlierOutput json_provenance(std::string_view text) {
  Json whole = without_rows(text);
  if (whole.is_discarded()) whole = without_rows(last_line(text));
  if (!whole.is_object() || !whole.contains("meta") || !whole["meta"].is_object()) return {};
  const Json& object = whole["meta"];
  EarlierOutput provenance;
  provenance.program = text_of(object, "program");
  for (const Json& option : object.value("options", Json::array())) {
    if (option.is_string()) provenance.options.push_back(option.get<std::string>());
  }
  for (const Json& input : object.value("inputs", Json::array())) {
    if (input.is_object()) provenance.inputs.emplace_back(text_of(input, "name"), text_of(input, "sha256"));
  }
  return provenance;
}

}  // namespace tcb
