// Roles: what a column of a record means, the names of roles, and requests for columns with a role.
#include "schema/roles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "error.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// The text before or after the name of a channel in the names of its columns.
struct Affix {
  std::string_view text;
  Role role;
  bool is_prefix;
};

constexpr std::array affixes{
    Affix{"tension_", Role::channel_tension, true}, Affix{"continuity_", Role::channel_continuity, true},
    Affix{"bias_", Role::channel_bias, true},       Affix{"_v", Role::velocity, false},
    Affix{"_vin", Role::velocity_in, false},        Affix{"_vout", Role::velocity_out, false},
};

/// The value of the option for which a list of columns without roles, such as time,x,y, probably stands: those with the
/// name of a role have it, and the others are the position. An example for any other text.
std::string example_of_roles(std::string_view text) {
  std::string roles, position;
  for (const std::string_view name : split(text, ',')) {
    if (name.empty() || name.find('=') != std::string::npos) return "time=frame,position=px:py";
    if (const std::optional<Role> role = find_role(name); role && *role != Role::position) {
      roles += fmt::format("{}={},", role_name(*role), name);
    } else {
      position += fmt::format("{}{}", position.empty() ? "" : ":", name);
    }
  }
  return position.empty() ? "time=frame,position=px:py" : roles + "position=" + position;
}

}  // namespace

std::string_view role_name(Role role) { return role_names[static_cast<std::size_t>(role) - 1].name; }

std::optional<Role> find_role(std::string_view name) {
  const auto known = std::ranges::find(role_names, name, &RoleName::name);
  return known == role_names.end() ? std::nullopt : std::optional(known->role);
}

Role role_of_name(std::string_view name) {
  const auto role_of = [](std::string_view written) {
    const auto row = std::ranges::find_if(role_names, [&](const RoleName& known) {
      return known.in_header && (known.any_case ? same_in_any_case(written, known.name) : written == known.name);
    });
    return row == role_names.end() ? Role::position : row->role;
  };
  const std::string_view alone = without_unit(name);
  return alone.size() < name.size() && role_of(alone) == Role::time ? Role::time : role_of(name);
}

std::string role_name(const ChannelRole& role) {
  const auto affix = std::ranges::find(affixes, role.role, &Affix::role);
  const std::string text(affix->text);
  return affix->is_prefix ? text + role.channel : role.channel + text;
}

std::optional<ChannelRole> channel_role_of(std::string_view name) {
  for (const auto& [text, role, is_prefix] : affixes) {
    if (name.size() <= text.size()) continue;
    const std::size_t rest = name.size() - text.size();
    if (!same_in_any_case(is_prefix ? name.substr(0, text.size()) : name.substr(rest), text)) continue;
    return ChannelRole{role, std::string(is_prefix ? name.substr(text.size()) : name.substr(0, rest))};
  }
  return std::nullopt;
}

std::vector<RoleRequest> parse_roles(std::string_view text) {
  std::vector<RoleRequest> requests;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view name = part.substr(0, equals);
    const std::optional<Role> known = find_role(name);
    const std::optional<ChannelRole> of_channel = known ? std::nullopt : channel_role_of(name);
    if ((known || of_channel) && equals + 1 == part.size())
      throw usage_error("{} has no column; expected its name or number; give it, as in {}NAME", in_quotes(part), part);
    if (equals == std::string::npos || !(known || of_channel)) {
      throw usage_error(
          "{} is not a role with its columns; expected time=NAME, position=NAME:NAME…, tension=, continuity=, bias=, "
          "tension_NAME=, continuity_NAME=, bias_NAME=, NAME_v=, NAME_vin=, NAME_vout=, ease_in=, ease_out=, group=, "
          "carry=, ignore=, nanoseconds= or clock=; for example --columns {}",
          in_quotes(part), in_shell(example_of_roles(text)));
    }
    const auto columns = split(part.substr(equals + 1), ':');
    requests.push_back({known ? *known : of_channel->role, {columns.begin(), columns.end()}});
    if (of_channel) requests.back().channel = of_channel->channel;
  }
  return requests;
}

}  // namespace tcb
