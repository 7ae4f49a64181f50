// Near misses: names of columns that are nearly those of roles.
#include "schema/near_misses.hpp"

#include <algorithm>
#include <utility>

#include "option_names.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// Whether `longer` is `shorter` with one additional letter.
bool is_with_a_letter(std::string_view longer, std::string_view shorter) {
  if (longer.size() != shorter.size() + 1) return false;
  std::size_t at = 0;
  while (at < shorter.size() && lower(longer[at]) == lower(shorter[at])) ++at;
  return is_letter(longer[at]) && same_in_any_case(longer.substr(at + 1), shorter.substr(at));
}

/// Whether `name` is a near miss of `known`.
bool is_near(std::string_view name, std::string_view known) {
  if (is_with_a_letter(name, known) || is_with_a_letter(known, name)) return true;
  if (name.size() != known.size()) return false;
  std::size_t at = 0;
  while (at < name.size() && lower(name[at]) == lower(known[at])) ++at;
  if (at + 1 >= name.size()) return at < name.size() && known.size() > 4;
  const bool changed = same_in_any_case(name.substr(at + 1), known.substr(at + 1));
  const bool swapped = lower(name[at]) == lower(known[at + 1]) && lower(name[at + 1]) == lower(known[at]) &&
                       same_in_any_case(name.substr(at + 2), known.substr(at + 2));
  return swapped || (changed && known.size() > 4);
}

/// Tension, continuity or bias, if a text is the name of one or a near miss; not as in x_T, which may be anything.
std::optional<Role> tcb_role(std::string_view text) {
  const Role role = near_role(text).value_or(role_of_name(text));
  const bool is_tcb = role == Role::tension || role == Role::continuity || role == Role::bias;
  return is_tcb && text.size() > 1 ? std::optional(role) : std::nullopt;
}

}  // namespace

std::optional<Role> near_role(std::string_view name) {
  if (role_of_name(name) != Role::position) return std::nullopt;
  const auto meant = std::ranges::find_if(role_names, [&](const RoleName& known) {
    const bool counts = known.any_case && known.in_header && known.role != Role::position;
    return counts && is_near(without_unit(name), known.name);
  });
  return meant == role_names.end() ? std::nullopt : std::optional(meant->role);
}

std::optional<ChannelRole> near_channel_role(std::string_view name, const std::vector<std::string>& channels) {
  for (std::size_t at = name.find('_'); at != std::string_view::npos; at = name.find('_', at + 1)) {
    const std::string_view first = name.substr(0, at), second = name.substr(at + 1);
    for (const auto& [role, channel] : {std::pair{first, second}, std::pair{second, first}}) {
      const std::optional<Role> meant = tcb_role(role);
      if (!meant) continue;
      const auto found = std::ranges::find_if(
          channels, [&, &text = channel](const std::string& known) { return same_in_any_case(known, text); });
      if (found != channels.end()) return channel_role_of(std::string(role_name(*meant)) + "_" + *found);
    }
  }
  return std::nullopt;
}

std::optional<std::string> near_miss(const std::string& name, const Columns& columns,
                                     std::span<const RoleRequest> requests, bool timeless) {
  if (std::ranges::count(requests, Role::position, &RoleRequest::role) > 0) return std::nullopt;
  if (const auto near = near_channel_role(name, columns.channels)) {
    const auto channel = std::ranges::find(columns.channels, near->channel);
    const auto index = static_cast<std::size_t>(channel - columns.channels.begin());
    const bool is_taken = std::ranges::any_of(columns.cells, [&](const Columns::Column& column) {
      return column.role == near->role && column.channel == index;
    });
    if (!is_taken) return role_name(*near);
  }
  const std::optional<Role> near = near_role(name);
  if (!near || columns.has(*near) || (timeless && *near == Role::time)) return std::nullopt;
  return std::string(role_name(*near));
}

}  // namespace tcb
