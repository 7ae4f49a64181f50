// Errors of the reading of JSON: one function for each fault, in the order of the flow.
//
// Who finds a fault of a value adds its path, as in "keys[17].x: ", by Error::about(), and its position.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb::json {

// The input
Error options_of_delimited_text();
Error no_text();
Error key_too_long();
Error object_too_long();

// The grammar of JSON
/// What may follow the part of a text that was read.
enum class Expected { value, name, colon, comma, after_comma, nothing };
/// `token` may be a string with its quotes.
Error unexpected(std::string_view token, Expected expected);
/// `string` is without its quotes, up to the character that may not be there.
Error character_in_string(std::string_view string);
Error string_not_closed();
Error ends_early();
Error number_too_large(std::string_view number);

// Tables
Error table_incomplete();
Error row_of_other_size(std::size_t row, std::size_t cells, std::size_t columns);
Error columns_differ_in_length(std::string_view column, std::size_t values, std::string_view first,
                               std::size_t values_of_first);

// Lists of keys and of curves
Error text_after_list();
Error curve_expected();
Error comma_between_curves_expected();
Error no_key_between_commas();
Error key_is_no_object(std::string_view what);
Error no_keys();
Error curve_without_keys();
/// `time` and `channels` are names.
Error curves_differ(std::string_view time, const std::vector<std::string>& channels, std::string_view first_time,
                    const std::vector<std::string>& first_channels);
Error groups_of_curves();

// Members of the first key
Error single_number_expected();
Error tcb_array_expected();
Error array_unused(std::string_view member);
Error object_unused();
Error nearly_role(std::string_view member, std::string_view role);
Error no_time(std::string_view member);
Error velocity_count(std::size_t found, std::size_t expected);
Error rotation_size(std::size_t found);
Error rotation_members();
Error channel_count(std::size_t names, std::size_t numbers);

// Members of any key
Error member_repeats();
Error member_unknown();
Error member_missing(std::string_view member, bool is_time);
Error not_a_number(std::string_view text);
Error number_missing(std::string_view sign, bool is_time);
Error text_missing();
Error number_expected();
Error text_expected();
Error array_expected();
Error array_size(std::size_t found, std::size_t expected);
Error also_in_tcb();
Error no_such_time(std::string_view time);
Error time_in_other_notation(std::string_view time);

// Camera paths
Error no_keyframes();
Error matrix_is_text();
Error last_row_of_matrix();
Error matrix_missing();
Error matrix_size(std::size_t found);
Error number_of_keyframe_missing(std::string_view member);
Error transition_not_positive(std::string_view seconds);

// Members around keys
Error no_setting(std::string_view suggestion);
Error setting_repeats();
Error setting_of_keys();
Error setting_is_option(std::string_view option);
Error setting_outside_curves();
Error true_or_false_expected(std::string_view found);
Error channel_names_expected();
Error id_expected();

}  // namespace tcb::json
