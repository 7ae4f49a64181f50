// Errors of curves and samples: one function for each fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "schema/key_block.hpp"

namespace tcb {

// Settings of a curve. Their errors are about the option or the member of JSON that they come from.
Error unknown_rule(const SettingOrigin& setting, std::string_view name, std::span<const std::string_view> known);
/// `rule`: an end rule, as it is given.
Error end_velocity_missing(const SettingOrigin& ends, std::string_view rule);
Error end_velocity_unexpected(const SettingOrigin& ends, std::string_view rule);
Error end_velocity_not_a_number(const SettingOrigin& ends, std::string_view rule, std::string_view number);
Error end_velocity_of_other_size(const SettingOrigin& ends, std::size_t numbers,
                                 const std::vector<std::string>& channels);
Error end_velocity_with_timing(const SettingOrigin& ends);
Error end_velocity_of_rotation(const SettingOrigin& ends);
Error too_many_end_rules(const SettingOrigin& ends, std::size_t rules);
/// `closed`: the setting that makes the curve closed.
Error ends_of_closed_curve(const SettingOrigin& ends, const SettingOrigin& closed);
Error exponent_out_of_range(const SettingOrigin& parameter, std::string_view exponent);
Error period_not_positive(const SettingOrigin& period, std::string_view text);
Error period_beyond_doubles(const SettingOrigin& period, std::string_view text);
Error period_of_open_curve(const SettingOrigin& closed);
Error no_channel_of_metric(const SettingOrigin& metric, std::string_view name,
                           const std::vector<std::string>& channels);
Error repeated_metric_channel(const SettingOrigin& metric, std::string_view channel);
Error rotation_in_metric(const SettingOrigin& metric, std::string_view channel);
Error angle_in_metric(const SettingOrigin& metric, std::string_view channel);
Error metric_without_rotations(const SettingOrigin& metric);

// What a request needs of a curve:
Error only_rotations();
/// Distances, speeds or shapes are requested where lengths are angles.
Error path_of_rotations();
Error pieces_of_angles();
/// Rotations are not given as quaternions.
Error pieces_of_other_form();
/// `curve`: one of rotations that has no cubics.
Error pieces_of_rotations(std::string_view curve);
/// About the option of the fields.
Error field_without_rotations(std::string_view field);
// About the option of the tolerance:
Error tolerance_without_rotation();
Error tolerance_of_rotations();

// Keys of a closed curve, and of one with missing numbers. `line`: that of the first key.
Error closing_key_differs(std::uint64_t line);
Error closing_velocity_differs(std::uint64_t line);
Error closing_key_against_period(std::uint64_t line);
Error period_too_short(std::string_view time);
Error too_few_closed_keys();
Error no_period();
Error seam_velocity_missing(std::string_view channel);
Error channel_without_numbers(std::string_view channel);
Error ease_with_missing_cells();

// Segments and their lengths. `from`, `to`: times.
Error tangents_beyond_doubles(std::string_view from, std::string_view to);
Error length_beyond_doubles(std::string_view to);

// Places of samples. The first ones are about the option that requests them.
Error before_first_key(std::string_view time, std::string_view first);
Error after_last_key(std::string_view time, std::string_view last);
Error before_first_piece(std::string_view time, std::string_view first);
Error after_last_piece(std::string_view time, std::string_view last);
Error below_length(std::string_view length, std::string_view least);
Error beyond_length(std::string_view length, std::string_view most);
Error end_before_start(std::string_view end, std::string_view start);
Error start_after_end(std::string_view start, std::string_view end);
Error samples_beyond_doubles();
/// `place`: near which the step is lost.
Error step_too_small(std::string_view step, std::string_view place);
Error tolerance_too_small();
/// `at_least`: and more may come.
Error too_many_rows(std::string_view rows, std::uint64_t most, bool at_least);
/// `unit`: the times seem to count in it since 1970.
Error too_many_rows_of_unit(std::string_view rows, std::uint64_t most, std::string_view unit);
Error no_piece_in_range();
/// `number`: of the segment between two keys, with the times `from` and `to`.
Error piece_with_ease(std::uint64_t number, std::string_view from, std::string_view to);

// Rows:
Error row_beyond_doubles(std::string_view time);

}  // namespace tcb
