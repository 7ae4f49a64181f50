// Errors of the command line: one function for each fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// The words of the command line. `suggestion`: the option that is probably meant, or "".
Error unknown_option(std::string_view name, std::string_view suggestion);
Error option_repeated();
Error flag_with_value(std::string_view flag);
Error value_missing(std::string_view option);
Error value_empty();
Error file_name_empty();
/// `message`: the words of CLI11.
Error command_line_not_understood(std::string_view message);

// Values. Their errors are about the option that has the value.
Error unknown_value(std::string_view name, std::span<const std::string_view> known);
Error number_beyond_doubles(std::string_view text);
Error not_a_positive_ratio(std::string_view text);
Error not_a_ratio(std::string_view text);
Error step_of_rate_beyond_doubles(std::string_view text);
Error not_a_count(std::string_view text);
Error not_a_whole_number(std::string_view text, std::uint64_t least, std::uint64_t most);
Error not_a_curve_tolerance(std::string_view text);
Error not_limits_of_a_fit(std::string_view text);
Error not_an_angle_of_a_corner(std::string_view text);
Error not_a_tolerance(std::string_view text);
Error not_a_delimiter(std::string_view text);
Error not_a_decimal_mark(std::string_view text);
Error not_a_thousands_mark(std::string_view text);
Error not_three_parameters(std::string_view text);
Error not_a_list_of_columns(std::string_view text);
Error not_a_list_of_renamings(std::string_view text);
Error not_a_list_of_scales(std::string_view text);
Error not_a_list_of_angles(std::string_view text);
Error not_a_rotation(std::string_view text);
Error not_an_order_of_axes(std::string_view text);
Error not_a_form_of_rotations(std::string_view text);
Error other_number_of_coefficients(std::string_view text);
Error field_repeated(std::string_view field);
Error not_a_part_of_a_name(std::string_view text);
Error not_two_axes(std::string_view text);
Error not_a_size(std::string_view text);

// Times and arc lengths of an option:
Error not_a_list_of_numbers(std::string_view text);
Error not_a_range(std::string_view text);
/// Some numbers of the list have a unit of time, and this one has none, or the other way round.
Error units_of_some_numbers(std::string_view number);
Error duration_is_no_length();
Error range_without_end(std::string_view text);
Error range_of_too_many_numbers(std::string_view text, std::uint64_t most);
/// In the file of the list.
Error list_unreadable();
Error list_of_too_many_numbers(std::uint64_t most);
Error list_without_numbers();
Error groups_of_numbers_in_provenance();

// Conflicts. `option`, `other`: a name, with the value if the conflict depends on it. `reason` goes on after the last
// option.
Error options_exclude_each_other(std::string_view option, std::string_view other, std::string_view reason);
Error option_needs_another(std::string_view option, std::string_view other, std::string_view reason);
Error option_without_effect_with(std::string_view option, std::string_view other, std::string_view reason);
Error option_without_effect(std::string_view option, std::string_view reason);

// The job:
Error no_sampling_option(std::span<const std::string_view> options);
Error range_backwards(std::string_view from, std::string_view to);
/// `named`: the format that the ending of the output names; `chosen`: that of the option.
Error output_of_other_format(std::string_view path, std::string_view named, std::string_view chosen);
Error output_not_written(std::string_view path, std::string_view ending);
Error binary_to_terminal();
/// About the option whose file is standard input as well.
Error standard_input_twice();
/// About the option of the comparison.
Error comparison_of_several_files(std::size_t files);

// Provenance: a value that it cannot hold, about its option; an earlier output that is not reproduced.
Error line_end_in_provenance();
Error option_not_of_provenance(std::string_view option);
Error file_in_provenance(std::string_view file);
/// `option` reads a file that the keys do not name.
Error option_of_provenance_reads_file(std::string_view option);
Error provenance_without_meta();
/// `option` is given besides the options of `file`.
Error option_besides_provenance(std::string_view option, std::string_view file);
Error other_number_of_files(std::string_view file, std::size_t recorded, std::size_t files);

}  // namespace tcb
