// What stands beside keys in JSON: settings of the curve, names of its channels, its id.
#include "input/json/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "error.hpp"
#include "input/json/events.hpp"
#include "input/roles.hpp"
#include "text/number.hpp"
#include "text/refusal.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

class Reader : public JsonEvents {
 public:
  using JsonEvents::JsonEvents;
  JsonCurveInfo found;

 private:
  bool on_member(const std::string& name) override {
    constexpr std::array<std::string_view, 9> known{"preset",   "tangents", "ends",   "closed", "period",
                                                    "channels", "keys",     "curves", "id"};
    member_ = name;
    known_ = std::ranges::find(known, name) != known.end();
    require_no_loss(name);
    if (!known_) {
      const std::string near = did_you_mean(name, known);
      if (!near.empty()) fail(fmt::format("{}: no setting{}", path(), near));
      return true;
    }
    if (std::ranges::find(members_, name) != members_.end()) {
      fail(fmt::format("{}: a second time in one object; expected once; take one out", path()));
    }
    members_.push_back(name);
    return true;
  }

  /// Throws: Error (data) for what has a meaning elsewhere, and none here.
  void require_no_loss(const std::string& name) const {
    constexpr std::array of_keys{Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out};
    constexpr std::array<std::string_view, 5> options{"equal-speed", "parameter", "metric", "extrapolate", "no-ease"};
    if (name == "tcb" || std::ranges::count(of_keys, role_of_name(name)) > 0) {
      fail(fmt::format("{}: not in a key; expected in each of them; move it there", path()));
    }
    std::string option = name;
    std::ranges::replace(option, '_', '-');
    if (std::ranges::count(options, option) > 0) {
      fail(fmt::format("{}: an option, not a setting of a file; take it out, and give --{} where it is wanted", path(),
                       option));
    }
  }

  bool on_number(const spline::Time<double>& value) override { return take(time_text(value)); }
  bool on_other(std::string_view text) override {
    if (member_ == "id" && is_quoted()) found.keys.id = '"' + std::string(text);
    return member_ == "id" && is_quoted() ? true : take(text);
  }

  bool take(std::string_view text) {
    if (!known_) return true;
    const std::string value(text);
    CurveSettings& settings = found.keys.settings;
    if (member_ != "id") found.keys.places.emplace_back(member_, here());
    if (member_ == "channels") take_channel(value);
    if (member_ == "preset") settings.preset = value;
    if (member_ == "tangents") settings.tangents = value;
    if (member_ == "ends") settings.ends = settings.ends && in_array() ? *settings.ends + "," + value : value;
    if (member_ == "period") settings.period = value;
    if (member_ == "id") take_id(value);
    if (member_ != "closed") return true;
    if (is_quoted() || (text != "true" && text != "false")) {
      fail(fmt::format("{}: {}; expected true or false; correct it", path(), shown(text)));
    }
    settings.closed = text == "true";
    return true;
  }

  void take_channel(const std::string& name) {
    if (!in_array() || !is_quoted()) fail(fmt::format("{}: expected an array of names in quotes; correct it", path()));
    found.channels.push_back(name);
  }

  void take_id(const std::string& value) {
    if (in_array() || value == "an object") fail(fmt::format("{}: expected a text or a number; correct it", path()));
    found.keys.id = value == "null" ? "" : value;
  }

  std::string member_;
  bool known_ = false;  ///< the member says something
  std::vector<std::string> members_;
};

}  // namespace

JsonCurveInfo read_beside(const JsonPart& part) {
  Reader reader(part);
  reader.parse_object();
  reader.found.path = part.chunk.path;
  reader.found.place = {"", part.chunk.line, part.chunk.column};
  return std::move(reader.found);
}

std::vector<std::string> channels_before_keys(const JsonPart& part) {
  JsonPart whole = part;
  if (whole.gap != std::string::npos) whole.chunk.text.resize(whole.gap - 2);
  whole.gap = std::string::npos;
  whole.chunk.text += "[]}";
  try {
    return read_beside(whole).channels;
  } catch (const Error&) {
    return {};  // it is said when the whole object is read
  }
}

}  // namespace tcb
