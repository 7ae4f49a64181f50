// Channel columns: the columns with the tension or a velocity of one channel, and those of segments.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "schema/columns.hpp"
#include "schema/roles.hpp"

namespace tcb {

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
