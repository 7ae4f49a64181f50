// Settings in JSON: the members around keys, which are settings of the curve, channel names and an id.
#include "read/json/settings.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "schema/roles.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = Json::Kind;

constexpr std::array<std::string_view, 9> known_members{"preset",   "tangents", "ends",   "closed", "period",
                                                        "channels", "keys",     "curves", "id"};

/// Options that are not members.
constexpr std::array options_only{"--equal-speed",    "--parameter",       "--metric", "--extrapolate", "--no-ease",
                                  "--rotation-curve", "--rotation-output", "--angles", "--normalize"};

class SettingsReader {
 public:
  SettingsReader(const Json& json, std::size_t object, const std::string& path) : json_(json), path_(path) {
    for (const std::size_t value : json.inside(object)) {
      member_ = json.name(value);
      name_ = value - 1;
      read(value);
    }
  }
  JsonCurveInfo found;

 private:
  void read(std::size_t value) {
    const bool is_setting = std::ranges::count(known_members, member_) > 0;
    require_no_loss();
    if (!is_setting) return read_other(value);
    if (!settings_.insert(member_).second) {
      throw at(name_, twice_in("object"));
    }
    if (member_ == "keys" || member_ == "curves") return;
    text_.clear();
    if (json_.is(value, Kind::array)) {
      for (const std::size_t element : json_.inside(value)) take(element, true);
    } else {
      take(value, false);
    }
    const auto& places = found.curve_info.places;
    if (!places.empty() && places.back().first == member_)
      set({*std::ranges::find(known_members, member_), places.back().second});
  }

  /// Numbers of no setting are not used, except those about the rows of an earlier output.
  void read_other(std::size_t value) {
    const std::string nearest = nearest_name(member_, known_members);
    if (!nearest.empty()) throw at(name_, data_error("there is no such setting; did you mean {}?", nearest));
    const bool has_number = json_.holds(value, Kind::number);
    if (found.shown_rate.empty() && is_frame_rate(json_, value)) found.shown_rate = json_.text(value);
    if (has_number && member_ != "meta" && member_ != "rows" && others_.insert(member_).second)
      found.unused.emplace_back(member_);
  }

  /// Throws: Error (data) for a name that has a meaning only elsewhere.
  void require_no_loss() const {
    constexpr std::array of_keys{Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out};
    const auto of_channel = channel_role_of(member_);
    const bool is_tcb = of_channel && of_channel->role < Role::velocity;
    if (member_ == "tcb" || is_tcb || std::ranges::count(of_keys, role_of_name(member_)) > 0) {
      throw at(name_, data_error("this member is outside the keys; expected it in each key; move it there"));
    }
    std::string option = "--" + std::string(member_);
    std::ranges::replace(option, '_', '-');
    const auto known = std::ranges::find(options_only, option);
    if (known == options_only.end()) return;
    throw at(name_,
             data_error(
                 "this is an option, not a setting of a file; expected it on the command line; remove it, and give {}",
                 *known));
  }

  /// Takes a value of a setting, or an element of it.
  void take(std::size_t value, bool in_array) {
    const Kind kind = json_.kind(value);
    const bool is_quoted = kind == Kind::string;
    const std::string text = is_quoted                ? std::string(json_.text(value))
                             : kind == Kind::number   ? json_number_text(json_.text(value))
                             : json_.is_nested(value) ? "an object"
                                                      : std::string(json_.text(value));
    if (member_ == "id") {
      if (in_array || json_.is_nested(value)) {
        throw at(value, data_error("this is not a text or a number; expected one; correct it"));
      }
      found.curve_info.id = is_quoted ? '"' + text : text == "null" ? "" : text;
      return;
    }
    auto& places = found.curve_info.places;
    const bool is_first = places.empty() || places.back().first != member_;
    if (is_first) places.emplace_back(member_, json_.position(value));
    if (member_ == "channels") {
      if (!in_array || !is_quoted) {
        throw at(value, data_error("this is not an array of names in quotes; expected one; correct it"));
      }
      found.channels.push_back(text);
    }
    text_ += (is_first ? "" : ",") + text;
    if (member_ == "closed" && (kind != Kind::boolean || !is_first)) {
      throw at(value, data_error("found {}; expected true or false; correct it", in_quotes(text_)));
    }
  }

  void set(const SettingOrigin& origin) {
    CurveSettings& curve = found.curve_info.settings;
    try {
      if (member_ == "preset") curve.preset = preset_in(text_);
      if (member_ == "tangents") curve.tangents = tangents_in(text_);
      if (member_ == "period") curve.period = {period_in(text_), origin};
      if (member_ == "closed") curve.closed = {text_ == "true", origin};
      if (member_ == "ends") curve.ends = {ends_in(text_), origin};
    } catch (const Error& error) {
      throw origin.error(error);
    }
  }

  Error at(std::size_t value, const Error& error) const {
    return error.about(path_ + (path_.empty() ? "" : ".") + std::string(member_)).at(json_.position(value));
  }

  const Json& json_;
  const std::string& path_;
  std::size_t name_ = 0;
  std::string_view member_;
  std::string text_;  ///< of the member's value
  std::unordered_set<std::string_view> settings_, others_;
};

}  // namespace

bool is_frame_rate(const Json& json, std::size_t value) {
  constexpr std::array<std::string_view, 4> names{"fps", "framerate", "frame_rate", "frames_per_second"};
  return json.is(value, Kind::number) &&
         std::ranges::any_of(names, [&](auto known) { return same_in_any_case(known, json.name(value)); });
}

JsonCurveInfo read_curve_info(const Json& json, std::size_t object, const std::string& path) {
  return std::move(SettingsReader(json, object, path).found);
}

}  // namespace tcb
