// Near misses: names of columns that are nearly those of roles.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schema/columns.hpp"
#include "schema/roles.hpp"

namespace tcb {

/// The role of which this name is a near miss: with a letter dropped, added or changed, or two letters swapped. In
/// names of four letters a changed letter is no near miss, as it often makes another word, such as tide. Nothing for
/// others.
std::optional<Role> near_role(std::string_view name);

/// The role in one of the channels of which a name such as "tensoin_x" or "x_tension" is a near miss.
std::optional<ChannelRole> near_channel_role(std::string_view name, const std::vector<std::string>& channels);

/// The name of the role of which a channel's name is a near miss, unless a column has that role or channels were
/// requested.
std::optional<std::string> near_miss(const std::string& name, const Columns& columns,
                                     std::span<const RoleRequest> requests, bool timeless);

}  // namespace tcb
