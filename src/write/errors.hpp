// Errors of outputs: what a format cannot hold, columns, times in words, and provenance.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// What a format cannot hold.
Error text_in_binary_format(std::string_view column, std::string_view format);
Error text_in_poses(std::string_view column, std::string_view format);
/// `positions`: the number of channels of the position.
Error not_a_pose(std::size_t positions, std::size_t rotations, std::string_view format);
Error channel_of_format_missing(std::string_view channel, std::string_view format);
Error poses_without_unit_of_time(std::string_view column, std::string_view format);
Error several_curves_in_one_table(std::string_view format);
Error no_path_with_yaw(const std::vector<std::string>& channels);
Error durations_not_in_seconds(std::string_view unit);

// Animations.
Error no_target_of_node(const std::vector<std::string>& channels);
Error no_target_of_track(std::string_view track);
Error several_curves_of_node(std::string_view name);
Error time_before_start_of_animation(double time, double seconds);
Error times_not_in_single_precision(double seconds);
Error number_beyond_single_precision(double number);
Error animation_without_rows();

// Times and marks.
Error time_not_a_double(std::string_view time);
Error time_not_in_notation(std::string_view time, std::string_view notation);
Error input_without_marks();

// The columns of several inputs in one output.
Error columns_differ_from_before(std::span<const std::string> columns, std::span<const std::string> columns_before);
Error file_column_taken(std::string_view name);
Error file_name_not_utf8(char byte);

// Provenance. `output` is the file that was made earlier.
Error checksum_differs(std::string_view checksum, std::string_view expected, std::string_view output);
Error made_from_fewer_inputs(std::string_view output, std::size_t inputs);
Error made_from_more_inputs(std::string_view output, std::size_t inputs);

}  // namespace tcb
