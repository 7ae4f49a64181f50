// Columns: the roles of the cells of a record: time, position, tension, continuity, bias, eases, and texts of a key.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/time_notation.hpp"
#include "option_names.hpp"
#include "tcb/spline/key.hpp"

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
  unused,  ///< ignored because it is requested
  // Of one channel:
  channel_tension,
  channel_continuity,
  channel_bias,
  velocity,
  velocity_in,
  velocity_out,
  end_position,  ///< of a record that is a segment; its position is at its start
  end_velocity,
  // Of a record that is a segment:
  duration,
};

inline constexpr std::size_t role_count = 20;
inline constexpr auto first_channel_role = Role::channel_tension;

/// The role is one in a channel.
constexpr bool is_of_channel(Role role) { return role >= first_channel_role && role < Role::duration; }

/// The role is a velocity of a key.
constexpr bool is_velocity(Role role) { return role >= Role::velocity && role <= Role::velocity_out; }

/// The name of a role where roles are requested. Requires: not ignored, not of one channel.
std::string_view role_name(Role role);

/// A role in one channel.
struct ChannelRole {
  Role role = Role::ignored;
  std::string channel;
  friend bool operator==(const ChannelRole&, const ChannelRole&) = default;
};

/// Its name, as in "tension_x" and "x_vin".
std::string role_name(const ChannelRole& role);

/// The role in a channel that a name such as "tension_x" or "x_v" has, whatever the channel and the case of the
/// letters.
std::optional<ChannelRole> channel_role_of(std::string_view name);

/// For each column, its role in one channel, if its name has one: that of a column that may be a channel. `chosen`: the
/// channels were requested. Throws: Error (data) for a name such as "tension_q" where there is no q, unless `chosen`;
/// but "q_v" is then any other name.
std::vector<std::optional<ChannelRole>> channel_roles(std::span<const std::string> header,
                                                      const std::vector<bool>& may_be_channel, bool chosen);

/// The role with this name.
std::optional<Role> find_role(std::string_view name);

/// The role that a column has by its name; position if the name gives none.
/// Case does not matter, except that t is time and T, C, B are tension, continuity and bias.
Role role_of_name(std::string_view name);

/// The role of which this name is a near miss: with a letter dropped, added or changed, or two letters swapped. In
/// names of four letters a changed letter is no near miss, as it often makes another word, such as tide. Nothing for
/// others.
std::optional<Role> near_role(std::string_view name);

/// Whether a name is a usual one of times, such as "Frame Number", "time_ms" or "header.stamp".
bool is_usual_time(std::string_view name);

/// The unit of times in a column of this name, such as "timestamp [ns]", "time_ms" or "frame"; nothing if it has none.
std::optional<TimeUnit> unit_of_time(std::string_view name);

/// Whether a name is a usual one of positions with several coordinates, such as "pos" or "translation".
bool is_usual_position(std::string_view name);

/// Whether a name is a usual one of what distinguishes curves, such as "id" or "track_id".
bool is_usual_label(std::string_view name);

/// Whether a name is that of a coordinate, such as "x", "pos_y" or "p3".
bool is_coordinate(std::string_view name);

/// A requested role: its columns by name or by number from 1, and the option that requests it.
struct RoleRequest {
  Role role;
  std::vector<std::string> columns;
  std::string_view option = option::columns;
  std::string channel = {};  ///< of a role in one channel
};

/// "time=frame,position=px:py:pz". Throws: Error (usage).
std::vector<RoleRequest> parse_roles(std::string_view text);

/// A column without a role, whose cells may distinguish curves.
struct Mark {
  std::string column;    ///< as it can be requested
  bool is_text = false;  ///< it holds texts
};

/// At most so many of them are compared.
inline constexpr std::size_t most_marks = 4;

/// The meaning of the cells of all records of an input.
struct Columns {
  struct Column {
    Role role = Role::ignored;
    std::size_t channel = 0;  ///< of positions and of roles in one; of groups and labels, the index among the texts of
                              ///< a key; of others, among the marks
    bool is_text = false;     ///< it has no role because it holds texts
  };
  std::vector<Column> cells;          ///< one per cell of a record
  bool named = false;                 ///< the input names its columns
  std::string time = "t";             ///< name of the time column
  std::vector<std::string> channels;  ///< names of the position channels
  std::vector<std::string> groups;    ///< names of the group columns
  std::vector<std::string> carried;   ///< names of the columns of labels
  std::vector<std::string> ignored;   ///< names of the columns without a role
  std::vector<Mark> marks;            ///< the first of them
  bool may_be_timed = false;          ///< the first channel may be the time, by its place and its name
  std::optional<spline::RotationForm> likely_rotation = {};  ///< that columns without names may be by their numbers
  bool are_segments = false;  ///< each record is a segment: start, duration, positions and velocities of its ends

  bool has(Role role) const;
  /// The names of the roles that shape a curve, such as tension and tension_x, and that a column has.
  std::vector<std::string> shape_roles() const;
  std::size_t texts() const { return groups.size() + carried.size(); }  ///< of each key
  /// The name of a column that has a role.
  std::string name_of(const Column& column) const;
};

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

/// The columns of records. `header` is empty where the input has no names; numeric[i]: column i holds numbers.
/// Without a header the first column is the time, unless `timeless`. Where no column has a name such as "time", one
/// with another usual name of times is it.
/// Throws: Error (data) for a column that does not exist, that has two roles, or whose role another column has.
Columns find_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                     std::span<const RoleRequest> requests, bool timeless = false);

/// Another name for a column.
struct Renaming {
  std::string from, to;
};

/// The names that samples of a curve are expected to have.
struct SampleNames {
  std::string time;                      ///< of the time column, if it is not one of the usual names
  std::vector<std::string> groups = {};  ///< of the group columns, if they are there
  std::vector<std::string> labels = {};  ///< of columns to ignore
  std::size_t time_place = 0;            ///< where columns have no names: how many are before the time, without groups
  std::vector<Renaming> maps = {};       ///< of columns of the samples
  std::string_view times_only = {};      ///< nothing is read but the groups and `time`, which this option names
};

/// The columns of samples: the time, the groups, and every other column of numbers as a channel, whatever its name.
/// Throws: Error (data) as find_columns.
Columns find_sample_columns(std::span<const std::string> given, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless);

/// The role in one of the channels of which a name such as "tensoin_x" or "x_tension" is a near miss.
std::optional<ChannelRole> near_channel_role(std::string_view name, const std::vector<std::string>& channels);

/// The name of the role of which a channel's name is a near miss, unless a column has that role or channels were
/// requested.
std::optional<std::string> near_miss(const std::string& name, const Columns& columns,
                                     std::span<const RoleRequest> requests, bool timeless);

/// Throws: Error (data) for the first channel whose name is a near miss.
void require_no_near_miss(std::span<const std::string> header, const Columns& columns,
                          std::span<const RoleRequest> requests, bool timeless);

/// Names for channels without any: x, y, z, or p1, p2, … for more than three.
std::vector<std::string> default_channel_names(std::size_t channels);

}  // namespace tcb
