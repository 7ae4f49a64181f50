// Settings in JSON: the members around keys, which are settings of the curve, channel names and an id.
#include "read/json/settings.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "read/json/errors.hpp"
#include "read/json/object_reader.hpp"
#include "schema/roles.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Options that are not members.
constexpr std::array options_only{option::equal_speed,     option::parameter, option::metric,
                                  option::extrapolate,     option::no_ease,   option::rotation_curve,
                                  option::rotation_output, option::angles,    option::normalize};

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
      const std::string nearest = nearest_name(name, known);
      if (nearest.empty()) return true;
      throw at_value(json::no_setting(nearest));
    }
    if (std::ranges::find(members_, name) != members_.end()) throw at_value(json::setting_repeats());
    members_.push_back(name);
    return true;
  }

  std::string_view member() const override { return member_; }

  /// Throws: Error (data) for a name that has a meaning only elsewhere.
  void require_no_loss(const std::string& name) const {
    constexpr std::array of_keys{Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out};
    const auto of_channel = channel_role_of(name);
    const bool is_tcb = of_channel && of_channel->role < Role::velocity;
    if (name == "tcb" || is_tcb || std::ranges::count(of_keys, role_of_name(name)) > 0) {
      throw at_value(json::setting_of_keys());
    }
    std::string option = "--" + name;
    std::ranges::replace(option, '_', '-');
    const auto known = std::ranges::find(options_only, option);
    if (known != options_only.end()) throw at_value(json::setting_is_option(*known));
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
    if (member_ == "id") throw at_value(json::id_expected());
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
    if (member_ == "preset") settings.preset = {value, {"preset", value_position()}};
    if (member_ == "tangents") settings.tangents = {value, {"tangents", value_position()}};
    if (member_ == "ends" && settings.ends && in_array()) {
      settings.ends->value += "," + value;
    } else if (member_ == "ends") {
      settings.ends = {value, {"ends", value_position()}};
    }
    if (member_ == "period") settings.period = {value, {"period", value_position()}};
    if (member_ == "id") {
      if (in_array()) throw at_value(json::id_expected());
      found.curve_info.id = value == "null" ? "" : value;
    }
    if (member_ != "closed") return true;
    if (is_quoted() || (text != "true" && text != "false")) {
      throw at_value(json::true_or_false_expected(value));
    }
    settings.closed = {text == "true", {"closed", value_position()}};
    return true;
  }

  void take_channel(const std::string& name) {
    if (!in_array() || !is_quoted()) throw at_value(json::channel_names_expected());
    found.channels.push_back(name);
  }

  std::string member_;
  bool known_ = false;  ///< the member is a setting
  std::vector<std::string> members_;
};

}  // namespace

JsonCurveInfo read_curve_info(const JsonPart& part) {
  SettingsReader reader(part);
  reader.parse();
  reader.found.path = part.chunk.path;
  reader.found.position = {"", part.chunk.line, part.chunk.column};
  return std::move(reader.found);
}

std::vector<std::string> channels_before_keys(const Chunk& text) {
  if (text.text.empty()) return {};
  try {
    return read_curve_info({JsonPart::Kind::object, text, {"]}"}}).channels;
  } catch (const Error&) {
    return {};  // thrown again when the whole object is read
  }
}

}  // namespace tcb
