// Settings of a curve as values of options or JSON members, before names are looked up.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "error.hpp"

namespace tcb {

struct CurveSettings {
  std::optional<std::string> preset;
  std::optional<std::string> tangents;
  std::optional<std::string> ends;  ///< RULE[,RULE]
  std::optional<bool> closed;
  std::optional<std::string> period;     ///< a decimal or a ratio; implies closed
  std::optional<std::string> parameter;  ///< for keys without times: uniform, chordal, centripetal, or an exponent
  std::optional<std::string> extrapolate;
  std::optional<std::string> metric;  ///< names or numbers of channels, separated by commas
  bool equal_speed = false;
  bool no_ease = false;
};

/// The member of a JSON object that has the value of an option.
struct SettingMember {
  Option option;
  std::string_view name;
};
inline constexpr std::array setting_members{
    SettingMember{Option::preset, "preset"}, SettingMember{Option::tangents, "tangents"},
    SettingMember{Option::ends, "ends"},     SettingMember{Option::closed, "closed"},
    SettingMember{Option::period, "period"},
};
constexpr std::string_view setting_member(Option option) {
  for (const SettingMember& member : setting_members) {
    if (member.option == option) return member.name;
  }
  return "";
}

}  // namespace tcb
