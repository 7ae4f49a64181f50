// Roles: what a column or a member of a key can be, and the names that say so.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace tcb {

enum class Role { left_out, time, position, tension, continuity, bias, ease_in, ease_out, group, carry };

inline constexpr std::size_t role_count = 10;

/// How --columns calls a role. Requires: not left_out.
std::string_view role_name(Role role);

/// The role that --columns calls so.
std::optional<Role> find_role(std::string_view name);

/// The role that a column's name gives it, where nothing else says; otherwise position.
/// Case does not matter, except that t is time and T, C, B are tension, continuity and bias.
Role role_of_name(std::string_view name);

/// The role that a name gives but for a slip: a letter dropped, added or changed, or two of them swapped. In names of
/// four letters, a letter changed makes other words, such as tide, and no slip. Nothing for all other names.
std::optional<Role> role_missed(std::string_view name);

/// Whether two names are the same, whatever the case of their letters.
bool same_in_any_case(std::string_view a, std::string_view b);

}  // namespace tcb
