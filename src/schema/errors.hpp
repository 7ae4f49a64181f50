// Errors of columns: requested roles, names, channels, segments, rotations, and units of times.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "error.hpp"

namespace tcb {

// The value of --columns.
/// `request`: such as "time=".
Error role_without_column(std::string_view request);
Error not_a_role_with_columns(std::string_view text);

// Requested columns. `columns` and `channels` are the names that exist.
Error same_column_names(std::string_view name);
Error no_such_column(std::string_view name, std::span<const std::string> columns);
Error no_such_column_number(std::string_view number, std::size_t column_count);
Error column_without_channel(std::string_view number, std::span<const std::string> numbers_of_channels);

// Roles of columns.
Error column_with_two_roles(std::string_view column);
/// `request`, `other_request`: what makes each of them the time.
Error two_times(std::string_view column, std::string_view other_column, std::string_view request,
                std::string_view other_request);
Error two_columns_for_role(std::string_view role, std::string_view second_column);
/// A column of numbers, by its name.
Error column_may_be_group(std::string_view column);
Error no_channel_column();
Error column_nearly_role(std::string_view column, std::string_view role);

// Roles in one channel.
Error column_of_unknown_channel(std::string_view column, std::string_view channel,
                                std::span<const std::string> channels);
Error role_of_unknown_channel(std::string_view role, std::string_view channel, std::span<const std::string> channels);
Error velocity_columns_overlap(std::string_view both_sides, std::string_view one_side);
Error velocity_column_missing(std::string_view column, std::string_view missing_column);
Error velocity_with_tcb(std::string_view velocity_column, std::string_view tcb_column);
Error tcb_with_all_velocities(std::string_view role);

// Segments.
Error segment_column_missing(std::string_view column, std::string_view missing_column);
Error segment_without_duration(double duration);

// Rotations and angles.
Error rotation_column_missing(std::string_view missing_column, std::span<const std::string> columns);
/// `columns`: with the numbers 0 to 3, or 1 to 4, in their names. The others: what requests the quaternion if the first
/// or the last of them is w.
Error quaternion_without_letters(std::span<const std::string> columns, std::string_view with_first_as_w,
                                 std::string_view with_last_as_w);
Error column_in_two_rotations(std::string_view column);
Error no_rotation_to_show(std::string_view form);

// Times.
Error times_unclear(std::string_view column);
Error times_without_column();
Error time_units_differ(std::string_view column, std::string_view unit_of_column, std::string_view unit_of_option);
Error times_without_rate(std::string_view column);
/// `date`: the first one, with the year last.
Error date_order_unknown(std::string_view column, std::string_view date);
Error dates_have_year_first(std::string_view column, std::string_view date);
Error times_are_no_dates(std::string_view column);

// Names in the output.
Error same_output_names(std::string_view name);

}  // namespace tcb
