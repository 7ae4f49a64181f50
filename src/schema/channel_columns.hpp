// Channel columns: the columns with the tension or a velocity of one channel, and those of segments.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "schema/columns.hpp"
#include "schema/roles.hpp"

namespace tcb {

/// For each column, its role in one channel, if its name has one: that of a column that may be a channel. `chosen`: the
/// channels were requested. Throws: Error (data) for a name such as "tension_q" where there is no q, unless `chosen`;
/// but "q_v" is then any other name.
std::vector<std::optional<ChannelRole>> channel_roles(std::span<const std::string> header,
                                                      const std::vector<bool>& may_be_channel, bool chosen);

/// A column with a role in one channel, which is known once all channels are.
struct ColumnOfChannel {
  std::size_t cell;
  ChannelRole role;
  std::string name;
  bool requested;
};

/// The columns that have such a role by their names. `times`: for each column, whether it is the time by its name.
std::vector<ColumnOfChannel> columns_of_channels(const Columns& columns, std::span<const std::string> header,
                                                 const std::vector<bool>& numeric, const std::vector<bool>& times);

/// Sets the channels of columns with a role in one. A requested column has priority over others. Throws: Error (data)
/// for two columns with one role, for an unknown channel, and for velocities of one side alone or with tension.
void assign_channels(Columns& columns, const std::vector<ColumnOfChannel>& found);

/// Sets the columns of a header with "start", "duration", and "x_p0", "x_v0", "x_p1" and "x_v1" for each channel, as
/// exact segments are written; false for any other.
bool assign_segments(Columns& columns, std::span<const std::string> header);

}  // namespace tcb
