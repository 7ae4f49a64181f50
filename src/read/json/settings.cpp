// Settings in JSON: the members around keys, which are settings of the curve, channel names and an id.
#include "read/json/keys.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "read/json/tape.hpp"
#include "schema/roles.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

constexpr std::array<std::string_view, 9> known_members{"preset",   "tangents", "ends",   "closed", "period",
                                                        "channels", "keys",     "curves", "id"};

/// Options that are not members.
constexpr std::array options_only{"--equal-speed",    "--parameter",       "--metric", "--extrapolate", "--no-ease",
                                  "--rotation-curve", "--rotation-output", "--angles", "--normalize"};

class SettingsReader {
 public:
  explicit SettingsReader(const JsonPart& part) : tape_(part) {
    found.path = part.chunk.path;
    found.position = {"", part.chunk.line, part.chunk.column};
    if (tape_.kind(0) != Kind::object) throw data_error("found no keys; expected at least two; add them");
    for (const std::size_t name : tape_.inside(0)) {
      name_ = name;
      member_ = tape_.text(name);
      read(name + 1);
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
    text_.clear();
    if (tape_.kind(value) == Kind::array) {
      for (const std::size_t element : tape_.inside(value)) take(element, true);
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
    const bool has_number = tape_.holds(value, Kind::number);
    if (found.shown_rate.empty() && is_frame_rate(tape_, name_)) found.shown_rate = tape_.written(value);
    if (has_number && member_ != "meta" && others_.insert(member_).second) found.unused.emplace_back(member_);
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
    const Kind kind = tape_.kind(value);
    const bool is_quoted = kind == Kind::string;
    const std::string text = is_quoted                  ? std::string(tape_.text(value))
                             : kind == Kind::number     ? json_number_text(tape_.written(value))
                             : tape_[value].is_nested() ? "an object"
                                                        : std::string(tape_.written(value));
    if (member_ == "id") {
      if (in_array || tape_[value].is_nested()) {
        throw at(value, data_error("this is not a text or a number; expected one; correct it"));
      }
      found.curve_info.id = is_quoted ? '"' + text : text == "null" ? "" : text;
      return;
    }
    auto& places = found.curve_info.places;
    const bool is_first = places.empty() || places.back().first != member_;
    if (is_first) places.emplace_back(member_, tape_.position(value));
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
    const std::string path = tape_.path(0, value);
    const std::string& curve = found.path;
    return error.about(curve.empty() ? path.substr(1) : curve + path).at(tape_.position(value));
  }

  JsonTape tape_;
  std::size_t name_ = 0;
  std::string_view member_;
  std::string text_;  ///< of the member's value
  std::unordered_set<std::string_view> settings_, others_;
};

}  // namespace

bool is_frame_rate(const JsonTape& tape, std::size_t name) {
  constexpr std::array<std::string_view, 4> names{"fps", "framerate", "frame_rate", "frames_per_second"};
  const bool has_number =
      tape.kind(name) == Kind::name && name + 1 < tape.size() && tape.kind(name + 1) == Kind::number;
  return has_number && std::ranges::any_of(names, [&](auto known) { return same_in_any_case(known, tape.text(name)); });
}

JsonCurveInfo read_curve_info(const JsonPart& part) { return std::move(SettingsReader(part).found); }

std::vector<std::string> channels_before_keys(const Chunk& text) {
  if (text.text.empty()) return {};
  JsonPart part{JsonPart::Kind::object, text};
  part.chunk.text += "[]}";
  try {
    return read_curve_info(part).channels;
  } catch (const Error&) {
    return {};  // thrown again when the whole object is read
  }
}

}  // namespace tcb
