// Usual names: those of times with their units, of positions, of labels of curves, and of coordinates.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "numbers/time_notation.hpp"

namespace tcb {

/// A name such as "timestamp [ns]", "time (s)" or "t in s" without its unit.
std::string_view without_unit(std::string_view name);

/// The index of the only name that is this one with a unit, as "x [m]" is "x".
std::optional<std::size_t> find_without_unit(std::span<const std::string> names, std::string_view name);

/// Whether a name is a usual one of times, such as "Frame Number", "time_ms" or "header.stamp".
bool is_usual_time(std::string_view name);

/// Whether a name is that of dates, such as "Date" or "obs_date".
bool names_dates(std::string_view name);

/// The unit of times in a column of this name, such as "timestamp [ns]", "time_ms" or "frame"; nothing if it has none.
std::optional<TimeUnit> unit_of_time(std::string_view name);

/// The names of a time in two columns, of its whole seconds and of its nanoseconds, as in header.stamp.sec and
/// header.stamp.nanosec, have the same stem: "header.stamp".
enum class TimePart { seconds, nanoseconds };
struct TimePartName {
  TimePart part;
  std::string_view stem;  ///< of the name, which outlives it; empty for a name such as "sec"
};

/// Whether a name is that of a part of a date or of a time of day, such as year or hour.
bool names_calendar(std::string_view name);

/// The part of a time that a name is by its last word; nothing for other names.
std::optional<TimePartName> time_part_of(std::string_view name);

/// Whether a name is a usual one of what numbers or labels records without being a position, such as "header.seq".
bool is_usual_counter(std::string_view name);

/// Whether a name, or its last word, is one of those that number records, as in event_id.
bool names_record(std::string_view name);

/// The stem of the name of a number of a rotation and its last letter or digit, such as "pose.orientation" and 'x', or
/// "rot" and 'x' of "rotX"; nothing if the stem does not end with a usual name of rotations.
std::optional<std::pair<std::string, char>> rotation_stem_of(std::string_view name);

/// Whether a name is a usual one of positions with several coordinates, such as "pos" or "translation".
bool is_usual_position(std::string_view name);

/// Whether a name is a usual one of what distinguishes curves, such as "id" or "track_id".
bool is_usual_label(std::string_view name);

/// Whether a name is one of those that tell curves apart and are never positions, such as "id" or "track".
bool tells_curves_apart(std::string_view name);

/// Whether the last word of a name is one of times, as in sensor_time, which may also be a duration.
bool ends_like_time(std::string_view name);

/// Whether a name is that of an angle of a heading or an attitude, such as "yaw" or "imu.heading".
bool is_usual_angle(std::string_view name);

/// Whether a name is that of a number of a rotation vector, such as "rvec_x" or "rotvec[0]".
bool is_of_rotation_vector(std::string_view name);

std::string_view without_brackets(std::string_view text);

/// Whether a text is a unit of a quantity, such as "km/h" or "[deg]".
bool is_unit(std::string_view text);

/// Whether the cells below names describe columns: units, or words such as "Avg" of instruments, and nothing else.
bool are_units(std::span<const std::string_view> cells);

/// Whether a name ends with the unit of degrees, as in "yaw_deg" and "yaw [deg]".
bool is_in_degrees(std::string_view name);

/// Whether a name may be that of an angle, such as "lon", "course" or "rotation_z".
bool may_be_angle(std::string_view name);

/// Whether a name is a usual one of a number over time, such as "x", "fov" or "temperature".
bool is_usual_channel(std::string_view name);

/// Whether two names may be of coordinates in the same space, such as "pos_x" and "pos_y", "lat" and "lon", or "a" and
/// "b", but not "x" and "temperature".
bool are_of_one_kind(std::string_view one, std::string_view other);

/// The channels called x, y and z, or px, pos_y, position.z and so on, where these are coordinates of one space, so
/// that lengths measure them; empty where there are no such or no others.
std::vector<std::size_t> spatial_channels(const std::vector<std::string>& channels);

/// Whether a name is that of a coordinate, such as "x", "pos_y" or "p3".
bool is_coordinate(std::string_view name);

}  // namespace tcb
