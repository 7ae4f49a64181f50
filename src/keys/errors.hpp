// Errors of keys: their order, curves, numbers, times made from distances, rotations, velocities, and segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "error.hpp"

namespace tcb {

/// A key as an error shows it.
struct ShownKey {
  std::string time;
  std::uint64_t line = 0;
  std::string list_position = {};  ///< as KeyBlock::list_position(), such as "keys[3]"; empty: it is in no list
};

// The order of time. `before` is the key before, `column` one that distinguishes curves.
Error equal_times(const ShownKey& key, const ShownKey& before);
/// `are_unnamed`: the columns have no names, so that the first one was taken as the time.
Error decreasing_times(const ShownKey& key, const ShownKey& before, bool are_unnamed);
Error curves_interleaved(const ShownKey& key, const ShownKey& before, std::string_view column);
Error sort_mixes_curves(std::string_view column);
Error sort_without_times();
Error duplicates_without_times();
Error sort_of_segments();

// The number of keys, and their numbers. `role` is tension, continuity or bias.
Error too_few_keys(std::size_t count);
Error tcb_from_0_to_50(std::string_view role, double value);
Error tcb_in_percent(std::string_view role, double value);
Error ease_out_of_range(std::string_view role, double value);

// Times made from distances.
Error position_repeats(std::uint64_t line_before);
Error parameter_step_lost(double step, double time);

// Rotations, by the name of their first column.
Error rotation_incomplete(std::string_view column);
Error quaternion_is_zero(std::string_view column);
Error quaternion_not_unit(std::string_view column, double norm);
Error matrix_not_a_rotation(std::string_view column, double determinant);
Error matrix_not_orthogonal(std::string_view column, double deviation);
Error axis_is_zero(std::string_view column, double angle);
Error half_turn_between_rotations(std::string_view column, std::uint64_t other_line);
Error whole_turns_of_rotation(std::string_view column, double angle);
Error velocities_of_part_of_rotation(std::string_view column);
Error velocities_with_slerp(std::string_view column);

// Angles, also those that give rotations.
Error angle_missing(std::string_view column);
Error angle_over_one_turn(std::string_view column, double radians);
Error angle_too_large(std::string_view column, double angle);
Error half_turn_between_angles(std::string_view column, std::uint64_t other_line);

// Velocities.
Error equal_speed_with_velocities();
Error velocities_with_timing();
Error ease_with_timing();
Error missing_cells_with_timing();
Error incoming_velocity_missing(std::string_view channel);
Error outgoing_velocity_missing(std::string_view channel);

// Segments.
Error segment_starts_elsewhere(std::string_view start, std::string_view end_before);
Error segment_jumps(double position, double position_before);

}  // namespace tcb
