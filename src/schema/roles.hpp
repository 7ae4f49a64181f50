// Roles: what a column of a record means, the names of roles, and requests for columns with a role.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

enum class Role {
  ignored,
  time,
  position,
  tension,
  continuity,
  bias,
  ease_in,
  ease_out,
  group,
  carry,
  unused,       ///< ignored on request
  nanoseconds,  ///< of the time, besides its whole seconds
  clock,        ///< the time of day besides the date that is the time; or what follows the year, each in a column
  // Of one channel:
  channel_tension,
  channel_continuity,
  channel_bias,
  velocity,
  velocity_in,
  velocity_out,
};

inline constexpr std::size_t role_count = 19;
inline constexpr auto first_channel_role = Role::channel_tension;

/// The role is one in a channel.
constexpr bool is_of_channel(Role role) { return role >= first_channel_role; }

/// The role is a velocity of a key.
constexpr bool is_velocity(Role role) { return role >= Role::velocity && role <= Role::velocity_out; }

/// The name of a role where roles are requested. Requires: not ignored, not of one channel.
std::string_view role_name(Role role);

struct ChannelRole {
  Role role = Role::ignored;
  std::string channel;
  friend bool operator==(const ChannelRole&, const ChannelRole&) = default;
};

/// The name of a column with a role in one channel, as in "tension_x" and "x_vin".
std::string role_name(const ChannelRole& role);

/// The role in a channel that a name such as "tension_x" or "x_v" has, whatever the channel and the case of the
/// letters.
std::optional<ChannelRole> channel_role_of(std::string_view name);

std::optional<Role> find_role(std::string_view name);

/// The role that a column has by its name; position if the name gives none.
/// Case does not matter, except that t is the time, and ease_in and ease_out have this spelling alone.
Role role_of_name(std::string_view name);

struct RoleName {
  std::string_view name;
  Role role;
  bool any_case;
  bool in_header = true;  ///< a column of that name has that role
};

/// Names that give a column its role. The first ones, in the order of Role, are also the names of the roles.
inline constexpr std::array role_names{
    RoleName{"time", Role::time, true},
    RoleName{"position", Role::position, true},
    RoleName{"tension", Role::tension, true},
    RoleName{"continuity", Role::continuity, true},
    RoleName{"bias", Role::bias, true},
    RoleName{"ease_in", Role::ease_in, false},
    RoleName{"ease_out", Role::ease_out, false},
    RoleName{"group", Role::group, true, false},
    RoleName{"carry", Role::carry, true, false},
    RoleName{"ignore", Role::unused, true, false},
    RoleName{"nanoseconds", Role::nanoseconds, true, false},
    RoleName{"clock", Role::clock, true, false},
    RoleName{"t", Role::time, false},
    RoleName{"frame", Role::time, true},
    RoleName{"timestamp", Role::time, true},
    RoleName{"seconds", Role::time, true},
    RoleName{"T", Role::tension, false, false},
    RoleName{"C", Role::continuity, false, false},
    RoleName{"B", Role::bias, false, false},
};

/// A requested role: its columns by name or by number from 1, and the option that requests it; none where the input
/// does.
struct RoleRequest {
  Role role;
  std::vector<std::string> columns;
  std::string_view option = "--columns";
  std::string channel = {};  ///< of a role in one channel
  /// Columns that have the role already keep it; where the input requests it, those with any other role, too.
  bool unless_taken = false;
};

/// "time=frame,position=px:py:pz". Throws: Error (usage).
std::vector<RoleRequest> parse_roles(std::string_view text);

}  // namespace tcb
