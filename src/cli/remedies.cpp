// Words for errors and notes: from codes, subjects and values to sentences with the remedy.
#include "cli/remedies.hpp"

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "cli/options.hpp"
#include "io/terminal.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

namespace {

// A plain array: clang 14 does not deduce a std::array of so many.
constexpr Words all_words[]{
    // text
    // io
    Words{ErrorCode::cannot_open, "cannot be opened: {0}"},
    Words{ErrorCode::cannot_read, "cannot be read: {0}"},
    Words{ErrorCode::input_is_folder, "cannot be read: {0}; give --recursive and --output-dir for the files in it"},
    Words{ErrorCode::input_changed,
          "it changed while it was read; expected a complete file; wait until it is written, or read what is "
          "already in it through a pipe, as in cat FILE | tcbsample"},
    Words{ErrorCode::cannot_write, "cannot be written: {0}"},
    Words{ErrorCode::cannot_make_folder, "cannot be created: {0}"},
    Words{ErrorCode::cannot_make_temporary, "needs a temporary file, which cannot be created: {0}"},
    Words{ErrorCode::cannot_read_temporary, "cannot be read back from the temporary file: {0}"},
    Words{ErrorCode::cannot_read_folder, "the folder cannot be read: {0}"},
    Words{ErrorCode::nul_in_list,
          "a NUL byte in the list of files; expected one name per line; give -0 for names that end in NUL"},
    Words{ErrorCode::empty_list, "no file names; expected one per line; add some"},
    Words{ErrorCode::no_inputs_in_folders,
          "no input among {0} in the folders; expected .csv, .tsv, .ssv, .json or .jsonl; give --input-format to "
          "take all"},
    Words{ErrorCode::same_output,
          "its output {0} is also that of {1}; expected one for each; rename one of them, or use two folders"},
    Words{ErrorCode::output_is_input, "its output {0} is also an input; expected two files; give another output"},
    Words{ErrorCode::input_without_name, "standard input has no name; --output-dir needs files; give -o instead"},
    // schema, read
    Words{ErrorCode::npy_as_input,
          "the file is in a format of NumPy; expected text; convert it, for example with numpy.savetxt"},
    Words{ErrorCode::compressed_data_broken,
          "the {0} data are broken; expected an undamaged file; make or copy it again"},
    Words{ErrorCode::compressed_data_cut, "the {0} data end too early; expected a whole file; make or copy it again"},
    Words{ErrorCode::compressed_input,
          "the file is compressed with {0}; expected text; decompress it, as in {1} FILE | tcbsample"},
    Words{ErrorCode::input_of_other_format,
          "this is {0}; expected text with a key in each row, or JSON; export the keys as CSV or JSON"},
    Words{ErrorCode::not_in_utf8,
          "the text is {0}; expected UTF-8; convert it, for example with iconv -f {0} -t UTF-8"},
    Words{ErrorCode::two_byte_order_marks, "two byte order marks; expected at most one; remove one"},
    Words{ErrorCode::nul_byte,
          "a NUL byte; expected text in UTF-8; convert the input, for example with iconv -f UTF-16 -t UTF-8"},
    Words{ErrorCode::same_column_names,
          "two columns are called \"{0}\"; expected different names; rename one, or choose by number with --columns"},
    Words{ErrorCode::no_such_column, "no column \"{0}\"; the columns are {1}; correct {subject}"},
    Words{ErrorCode::no_such_column_number, "no column {0}; there are {1}, without names; give numbers from 1 to {1}"},
    Words{
        ErrorCode::column_without_channel,
        "{subject}: column {0} is the time or has another role; expected one of the columns {1}; name others, or give "
        "--parameter uniform if the keys have no times"},
    Words{ErrorCode::column_with_two_roles, "column \"{0}\" has two roles; expected one; correct --columns"},
    Words{ErrorCode::two_columns_for_role,
          "two columns could be the {0} column, the second is \"{1}\"; expected one; choose with --columns"},
    Words{ErrorCode::column_of_unknown_channel,
          "column \"{0}\" is for a channel \"{1}\", which does not exist; the channels are {2}; correct the name, "
          "or name the channels with --columns position=NAME:NAME"},
    Words{ErrorCode::role_of_unknown_channel,
          "{0} is for a channel \"{1}\", which does not exist; the channels are {2}; correct {subject}"},
    Words{ErrorCode::velocity_columns_overlap,
          "\"{0}\" and \"{1}\": two velocities of one side; expected {0} for both sides, or one for each; remove "
          "one, or give --columns ignore=NAME"},
    Words{ErrorCode::velocity_column_missing,
          "\"{0}\" without \"{1}\"; expected both, or one column for both sides; add it, or give --columns "
          "ignore={0}"},
    Words{ErrorCode::velocity_with_tcb,
          "\"{0}\" and \"{1}\": a given velocity leaves nothing to tension, continuity and bias; expected one of "
          "the two; remove one, or give --columns ignore=NAME"},
    Words{ErrorCode::rotation_column_missing,
          "of {1} and \"{0}\" the last is missing; expected the four numbers of a quaternion; add it, or give "
          "--rotation none "
          "to take them as plain channels"},
    Words{ErrorCode::rotation_columns_shared,
          "\"{0}\" is in two rotations or angles, or twice in one; expected columns of their own; name others"},
    Words{ErrorCode::velocity_of_rotation,
          "\"{0}\" is a number of a rotation with a velocity; expected velocities of all four numbers of a quaternion, "
          "or tension, continuity and bias; leave its column out with --columns ignore=NAME"},
    Words{ErrorCode::velocity_with_slerp,
          "\"{0}\" is a number of a rotation with velocities, which the curve slerp does not have; expected one of the "
          "two; give --rotation-curve squad, or leave the columns out with --columns ignore=NAME"},
    Words{ErrorCode::segment_column_missing,
          "\"{0}\" without \"{1}\"; expected both, where rows are segments; add it, or give --columns ignore={0}"},
    Words{ErrorCode::tcb_with_all_velocities,
          "the column of {0} has no effect, for all channels have given velocities; expected one of the two; "
          "remove it, or give --columns ignore=NAME"},
    Words{ErrorCode::no_channel_column,
          "no position column; expected at least one column of numbers besides the time; name it with --columns "
          "position=NAME"},
    Words{ErrorCode::column_nearly_role,
          "column \"{0}\" is close to \"{1}\", but its name makes it a channel; expected {1}, or another name; "
          "rename it, or give --columns {1}={0} or position=NAME:NAME"},
    Words{ErrorCode::times_unclear,
          "no time column, but column \"{0}\" may be one; expected a column called time; give --columns time={0}, "
          "or --parameter uniform if the keys have no times"},
    Words{ErrorCode::time_units_differ,
          "the times in column \"{0}\" are in {1} by its name, but in {2} by {subject}; expected one unit; remove "
          "the option, or rename the column"},
    Words{ErrorCode::unit_without_times,
          "no time column, but {subject} is given; expected one; name it with --columns time=NAME, or remove the "
          "option"},
    Words{ErrorCode::timecode_without_rate,
          "the times in column \"{0}\" are frames or timecode, but there is no rate; expected one; give it with "
          "--input-fps, as in --input-fps 24 or 30000/1001"},
    Words{ErrorCode::no_such_time,
          "{c0}: {q1} does not exist; expected a time of a day, a frame below the rate that is not dropped, and no "
          "leap second; correct the cell"},
    Words{ErrorCode::time_in_other_notation,
          "{c0}: {q1} is not in the notation of the first time; expected one notation in a column; convert the cell"},
    Words{ErrorCode::no_time_in_words,
          "the time {0} of a row cannot be written as {1}; expected a time at a frame for timecode, not before 0, "
          "and a year from 0 to 9999 for a date; give --time-format seconds"},
    Words{ErrorCode::invalid_role_request,
          "{subject}: \"{0}\" is not a role with its columns; expected time=NAME, position=NAME:NAME…, tension=, "
          "continuity=, bias=, tension_NAME=, continuity_NAME=, bias_NAME=, NAME_v=, NAME_vin=, NAME_vout=, "
          "ease_in=, ease_out=, group=, carry= or ignore=; for example --columns time=frame,position=px:py"},
    // read/csv
    Words{ErrorCode::record_too_long,
          "a record of more than 64 MiB; expected a line for each key; break the lines, or close a quote that was "
          "left open"},
    Words{ErrorCode::too_many_cells,
          "a record of more than {0} cells; expected fewer; correct the row, or give the delimiter with -d"},
    Words{ErrorCode::quote_not_closed, "a quoted cell is not closed; expected \" at its end; add it"},
    Words{ErrorCode::text_after_quotes,
          "text after a quoted cell; expected the delimiter or the end of the line; double the quotes inside a cell"},
    Words{ErrorCode::empty_input, "no keys: the input is empty; expected a row for each key; see --help"},
    Words{ErrorCode::header_without_rows,
          "no keys: there is a header and no row; expected a row for each key; see --help"},
    Words{ErrorCode::lines_end_in_carriage_returns,
          "no keys: there is one line, with carriage returns in it; expected a line for each key; change them to "
          "line feeds, for example with tr"},
    Words{ErrorCode::single_column,
          "one column, as there is no {q0}, but each row has {q1}; expected cells between delimiters; give -d {2}"},
    Words{ErrorCode::header_unclear,
          "the first record has text, {q0}, and a number, {q1}; expected only names or only numbers; give --header "
          "if they are names, --no-header if they are not"},
    Words{ErrorCode::row_unlike_header,
          "the first row has {0} where the header has {1}; expected the same number; correct one of them, or give "
          "the delimiter with -d"},
    Words{ErrorCode::column_not_utf8,
          "column {q0}: the byte {1} is not UTF-8; expected UTF-8; convert the text, for example with iconv"},
    Words{ErrorCode::cell_not_utf8,
          "{q0}: the byte {1} is not UTF-8; expected UTF-8; convert the text, for example with iconv"},
    Words{ErrorCode::wrong_number_of_cells,
          "the row has {0} where the rows above have {1}; expected the same number of cells; complete or correct "
          "the row, or give the delimiter with -d"},
    Words{ErrorCode::empty_group,
          "{0}: an empty cell; expected the name of a curve; fill it in, or give --missing skip-row"},
    Words{ErrorCode::number_in_text_column,
          "{c0}: {q1} is a number in a column of text; expected only numbers or only text; give the text that "
          "marks missing numbers to --na, or leave the column out with --columns position=NAME:NAME"},
    Words{ErrorCode::number_empty,
          "{c0}: an empty cell where a number was expected; fill it in, or give --missing skip-row, skip-cell or "
          "break"},
    Words{ErrorCode::number_missing,
          "{c0}: {q1} where a number was expected; fill it in, or give --missing skip-row, skip-cell or break"},
    Words{ErrorCode::time_empty,
          "{c0}: an empty cell where a number was expected; fill it in, or give --missing skip-row or break"},
    Words{ErrorCode::time_missing,
          "{c0}: {q1} where a number was expected; fill it in, or give --missing skip-row or break"},
    Words{ErrorCode::number_with_point,
          "{c0}: {q1} has a point; expected a decimal comma; correct the cell, or remove --decimal"},
    Words{ErrorCode::number_with_comma,
          "{c0}: {q1} is not a number; expected a decimal point; give --decimal , if this is a decimal comma"},
    Words{ErrorCode::number_with_thousands,
          "{c0}: {q1} is not a number; expected one without separators of thousands; remove them, or give "
          "--decimal , if this is a decimal comma"},
    Words{ErrorCode::number_too_large,
          "{c0}: {q1} is not a finite double; expected less than 1.8e308 in size; correct the cell"},
    Words{ErrorCode::several_numbers,
          "{c0}: {q1} is not a number; expected one in each cell; give the delimiter with -d"},
    Words{ErrorCode::not_a_number,
          "{c0}: {q1} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell"},
    Words{ErrorCode::decimal_comma_is_delimiter,
          "--decimal , excludes the delimiter , ; expected another one; give it with -d, or remove --decimal"},
    // read/json
    Words{ErrorCode::text_options_on_json,
          "--delimiter, --header, --no-header, --comment and --decimal have no effect on JSON; remove them, or "
          "give the format with -i"},
    Words{ErrorCode::empty_json, "no keys: the input is empty; expected an object for each key; see --help"},
    Words{ErrorCode::json_value_expected, "not JSON: {q0}; expected a value; correct the text"},
    Words{ErrorCode::json_name_expected, "not JSON: {q0}; expected a name in quotes; correct the text"},
    Words{ErrorCode::json_colon_expected, "not JSON: {q0}; expected a colon after the name; correct the text"},
    Words{ErrorCode::json_comma_or_bracket_expected, "not JSON: {q0}; expected a comma or ]; correct the text"},
    Words{ErrorCode::json_comma_or_brace_expected, "not JSON: {q0}; expected a comma or }}; correct the text"},
    Words{ErrorCode::json_end_expected, "not JSON: {q0} after the last bracket; expected nothing more; remove it"},
    Words{ErrorCode::json_string_not_closed, "not JSON: the string {q0} is not closed; expected \" at its end; add it"},
    Words{ErrorCode::json_character_in_string,
          "not JSON: the last character of {q0} may not be in a string; expected UTF-8 without control characters, "
          "and the escapes of JSON; correct the text"},
    Words{ErrorCode::json_ends_early, "not JSON: the text ends early; expected the rest of the value; complete it"},
    Words{ErrorCode::json_text_after_array, "text after the end of the JSON array; expected nothing more; remove it"},
    Words{ErrorCode::json_key_too_long, "a key of more than 64 MiB; expected less; shorten it"},
    Words{ErrorCode::json_object_too_long, "an object of more than 64 MiB around the keys; expected less; shorten it"},
    Words{ErrorCode::json_curve_expected, "no curve where one was expected; expected an object; correct the text"},
    Words{ErrorCode::json_comma_after_curve_expected, "expected a comma or the end of the curves; correct the text"},
    Words{ErrorCode::json_key_missing, "nothing where a key was expected; expected an object; remove the comma"},
    Words{ErrorCode::json_value_for_key, "{0} where a key was expected; expected an object; correct it"},
    Words{ErrorCode::json_number_for_key, "a number where a key was expected; expected an object; correct it"},
    Words{ErrorCode::json_array_for_key, "an array where a key was expected; expected an object; correct it"},
    Words{ErrorCode::json_number_too_large,
          "{q0} is not a finite double; expected less than 1.8e308 in size; correct it"},
    Words{ErrorCode::json_member_repeats, "{0}: repeated in one key; expected once; remove one"},
    Words{ErrorCode::json_member_unknown,
          "{0}: not in the first key; expected the same members in every key; add it there"},
    Words{ErrorCode::json_array_unused,
          "{0}: an array that is not used; expected \"position\" as the name of an array of positions; rename it, "
          "or give --columns position={1}, or position=NAME:NAME for the members to take"},
    Words{ErrorCode::json_object_unused,
          "{0}: numbers in an object, or in arrays in an array, are not used; expected an array of numbers, or a "
          "member for each number; write them so, or give --columns position=NAME:NAME for the members to take"},
    Words{ErrorCode::json_member_missing,
          "a key without \"{0}\"; expected the members of the first key; add it, or give --missing skip-row, "
          "skip-cell or break"},
    Words{ErrorCode::json_time_missing,
          "a key without \"{0}\"; expected the members of the first key; add it, or give --missing skip-row or "
          "break"},
    Words{ErrorCode::json_member_nearly_role,
          "{0}: close to \"{1}\", but its name makes it a channel; expected {1}, or another name; rename it, or "
          "give --columns {1}={2} or position=NAME:NAME"},
    Words{ErrorCode::json_not_a_number, "{0}: {q1} is not a number; expected one without quotes; correct it"},
    Words{ErrorCode::json_null_number,
          "{0}: null where a number was expected; fill it in, or give --missing skip-row, skip-cell or break"},
    Words{ErrorCode::json_null_time,
          "{0}: null where a number was expected; fill it in, or give --missing skip-row or break"},
    Words{ErrorCode::json_missing_number,
          "{0}: {q1} where a number was expected; fill it in, or give --missing skip-row, skip-cell or break"},
    Words{ErrorCode::json_missing_time,
          "{0}: {q1} where a number was expected; fill it in, or give --missing skip-row or break"},
    Words{ErrorCode::json_null_group, "{0}: null where a text was expected; fill it in, or give --missing skip-row"},
    Words{ErrorCode::json_number_expected, "{0}: expected a number, as in the first key; correct it"},
    Words{ErrorCode::json_text_expected, "{0}: expected a text or a number, as in the first key; correct it"},
    Words{ErrorCode::json_array_expected, "{0}: expected an array of numbers, as in the first key; correct it"},
    Words{ErrorCode::json_velocity_count, "{0}: an array of {1}; expected {2} numbers, as in \"position\"; correct it"},
    Words{ErrorCode::json_rotation_size,
          "{0}: an array of {1}; expected four numbers, x, y, z, w of a quaternion; correct it, or give --columns "
          "position=NAME:NAME for the members to take"},
    Words{ErrorCode::json_rotation_members,
          "{0}: \"rotation\" has other members than x, y, z and w; expected the four numbers of a quaternion; correct "
          "them, or give --columns position=NAME:NAME for the members to take"},
    Words{ErrorCode::json_array_size, "{0}: an array of {1}; expected {2} numbers, as in the first key; correct it"},
    Words{ErrorCode::json_tcb_twice, "{0}: also in \"tcb\"; expected one of them; remove one"},
    Words{ErrorCode::json_tcb_array_expected, "{0}: expected an array [T,C,B]; correct it"},
    Words{ErrorCode::json_single_number_expected, "{0}: expected a number; correct it"},
    Words{ErrorCode::json_channel_count,
          "\"channels\" names {0}; expected {1}, one for each number of \"position\"; correct it"},
    Words{ErrorCode::json_without_keys, "no keys; expected at least two; add them"},
    Words{ErrorCode::json_curve_without_keys, "{0}: no keys; expected at least two; add them, or remove the curve"},
    Words{ErrorCode::json_curves_differ,
          "{0}: keys with {1}, {2}; expected {3}, {4}, as in the first curve; correct them"},
    Words{ErrorCode::groups_of_curves,
          "{subject} has no meaning for an object with curves, which are separate already; remove it"},
    Words{ErrorCode::setting_nearly_known, "{2}: not a setting{nearest}"},
    Words{ErrorCode::setting_repeats, "{0}: repeated in one object; expected once; remove one"},
    Words{ErrorCode::setting_of_keys, "{0}: not in a key; expected in each of them; move it there"},
    Words{ErrorCode::setting_is_option,
          "{0}: an option, not a setting of a file; remove it, and give {subject} instead"},
    Words{ErrorCode::setting_outside_curves, "{0}: outside the curves; expected in each of them; move it there"},
    Words{ErrorCode::setting_closed_expected, "{0}: {q1}; expected true or false; correct it"},
    Words{ErrorCode::setting_channels_expected, "{0}: expected an array of names in quotes; correct it"},
    Words{ErrorCode::setting_id_expected, "{0}: expected a text or a number; correct it"},
    // keys
    Words{ErrorCode::equal_times,
          "time {0} repeats the time {1} in line {2}; expected increasing times; remove one of them, or give "
          "--duplicates first, last or break"},
    Words{ErrorCode::equal_times_in_list,
          "{3}: time {0} repeats the time {1} of {2}; expected increasing times; remove one of them, or give "
          "--duplicates first, last or break"},
    Words{ErrorCode::decreasing_times,
          "time {0} is less than the time {1} in line {2}; expected increasing times; sort the rows by time, or "
          "give --sort"},
    Words{ErrorCode::decreasing_times_by_place,
          "time {0} is less than the time {1} in line {2}; expected increasing times; sort the rows by time, give "
          "--sort, or give --parameter uniform if the keys have no times"},
    Words{ErrorCode::decreasing_times_in_list,
          "{3}: time {0} is less than the time {1} of {2}; expected increasing times; sort the rows by time, or "
          "give --sort"},
    Words{ErrorCode::curves_interleaved,
          "time {0} does not increase after {1} in line {2}, but it does for each value of \"{3}\"; expected the "
          "rows of one curve; give --group {3} for one curve per value"},
    Words{ErrorCode::curves_interleaved_in_list,
          "{3}: time {0} does not increase after {1} of {2}, but it does for each value of \"{4}\"; expected the "
          "keys of one curve; give --group {4} for one curve per value"},
    Words{ErrorCode::sort_interleaves,
          "--sort would mix rows with different values of \"{0}\" in one curve; expected the rows of one curve; "
          "give --group {0} for one curve per value, or --columns carry={0} if it does not distinguish curves"},
    Words{ErrorCode::sort_without_times,
          "--sort orders rows by time, and there is no time column; remove it, or name the column with --columns "
          "time=NAME"},
    Words{ErrorCode::duplicates_without_times,
          "--duplicates is about equal times, and there is no time column; remove it, or name the column with "
          "--columns time=NAME"},
    Words{ErrorCode::no_keys, "only 0 keys; a curve needs at least two; add keys"},
    Words{ErrorCode::single_key, "only 1 key; a curve needs at least two; add keys"},
    Words{ErrorCode::tcb_from_0_to_50,
          "{0} is {1}, and 3ds Max and programs like it show 0 to 50 with 25 for 0; expected a number, usually "
          "from -1 to 1; give --tcb-scale 3dsmax, or --tcb-scale none to take the number unchanged"},
    Words{ErrorCode::tcb_in_percent,
          "{0} is {1}, and the product shows percent; expected a number, usually from -1 to 1; divide by 100, or "
          "give --tcb-scale none to take the number unchanged"},
    Words{ErrorCode::ease_out_of_range, "{0} is {1}; expected 0 to 1; correct it, or give --no-ease"},
    Words{ErrorCode::position_repeats,
          "the position repeats that of line {0}; times are made from distances, and here the distance is 0; "
          "remove one of the rows, or give --parameter uniform"},
    Words{ErrorCode::parameter_step_lost,
          "the distance makes a step of {0}, which is lost when it is added to the time {1}; expected times that "
          "doubles distinguish; give a smaller exponent to --parameter"},
    // sample
    Words{ErrorCode::before_first_key,
          "{subject} {0} lies before the first key, at {1}; give one within the curve, or --extrapolate"},
    Words{ErrorCode::after_last_key,
          "{subject} {0} lies beyond the last key, at {1}; give one within the curve, or --extrapolate"},
    Words{ErrorCode::before_curve_start, "{subject} {0} lies before the start, at {1}; give one within the curve"},
    Words{ErrorCode::beyond_curve_length,
          "{subject} {0} lies beyond the curve's length, at {1}; give one within the curve"},
    Words{ErrorCode::step_too_small,
          "the step {0} is too small: near {1} two rows would get the same number; give a larger step"},
    Words{ErrorCode::too_many_rows, "{0} rows are requested; expected at most {1}; request fewer, or raise --max-rows"},
    Words{ErrorCode::too_many_rows_or_more,
          "at least {0} rows are requested; expected at most {1}; request fewer, or raise --max-rows"},
    Words{ErrorCode::end_before_start,
          "{subject} {0} is before {1}, where samples begin unless --from is given; expected a later one; correct "
          "it, or give --from"},
    Words{ErrorCode::start_after_end,
          "{subject} {0} lies beyond {1}, where samples end unless --to is given; expected an earlier one; correct "
          "it, or give --to"},
    Words{ErrorCode::samples_beyond_doubles,
          "the distances between samples are beyond the range of doubles; expected less than 1.8e308 from the "
          "first to the last; scale the keys down"},
    Words{ErrorCode::beyond_curve_end, "{subject} {0} lies beyond the last key, at {1}; give one within the curve"},
    Words{ErrorCode::no_piece_in_range,
          "no part of the curve lies from --from to --to; expected a range with a duration; correct it"},
    Words{ErrorCode::piece_with_ease,
          "segment {0}, from the key at time {1} to the key at {2}, has ease, so it is no cubic in time; expected "
          "keys without ease; give --no-ease, or a sampling option instead of --emit"},
    Words{ErrorCode::tolerance_too_small, "{subject} is too small: two rows would be the same; give a larger one"},
    // keys, sample and fit: the curve
    Words{ErrorCode::unknown_rule, "{subject}: unknown name \"{0}\"; expected one of {1}{nearest}"},
    Words{ErrorCode::velocity_missing, "{subject} {0}: expected a number for each channel, as in velocity=1:0"},
    Words{ErrorCode::unexpected_rule_value, "{subject} {0}: expected no value for this rule; remove it"},
    Words{ErrorCode::velocity_not_a_number, "{subject} {0}: \"{1}\" is not a number; expected velocity=V:V…"},
    Words{ErrorCode::velocity_of_other_size,
          "{subject}: a velocity of {0} numbers; expected {1}, one for each of {2}; correct it"},
    Words{ErrorCode::too_many_end_rules,
          "{subject} {0}: {1} rules; expected one, or one for the start and one for the end"},
    Words{ErrorCode::exponent_out_of_range, "{subject} {0}: expected an exponent from 0 to 16"},
    Words{ErrorCode::period_not_positive, "{subject} \"{0}\": expected a decimal or a ratio above 0, such as 7.5"},
    Words{ErrorCode::period_beyond_doubles,
          "{subject} \"{0}\": expected at most 1.7976931348623157e308 in size, as doubles are"},
    Words{ErrorCode::period_of_open_curve, "{subject}: false, but a period makes the curve closed; remove one of them"},
    Words{ErrorCode::ends_of_closed_curve,
          "{subject} has no effect on a closed curve, which has no ends; remove one of them"},
    Words{ErrorCode::unknown_metric_channel,
          "{subject}: no channel \"{0}\"; expected some of {1}, or numbers from 1{nearest}"},
    Words{ErrorCode::repeated_metric_channel, "{subject}: channel \"{0}\" is repeated; expected each once; remove one"},
    Words{ErrorCode::rotation_in_metric,
          "{subject}: channel \"{0}\" is a number of a rotation, which has no length; expected a position; give "
          "--rotation none to take it as one"},
    Words{
        ErrorCode::angle_in_metric,
        "{subject}: channel \"{0}\" is an angle, which has no length; expected a position; leave it out, or leave out "
        "--angle"},
    Words{ErrorCode::no_rotation,
          "{subject} {0}: there is no rotation; expected columns of one; name them with --rotation"},
    Words{
        ErrorCode::path_of_rotations,
        "{subject} rotation measures angles, so that there are no distances, speeds and shapes of a path; expected arc "
        "lengths alone; leave out the others, or give the field angular_speed"},
    Words{ErrorCode::only_rotations,
          "there are only rotations or angles, which have no lengths; expected a position; give --metric rotation for "
          "angles, or --rotation none to take their numbers as positions"},
    Words{ErrorCode::fit_without_times,
          "{subject} takes samples with times, and no column is the time; expected one; name it with --columns "
          "time=NAME"},
    Words{ErrorCode::fit_of_keys,
          "the input has the role {0}, as keys do; expected samples; leave its column out with --columns ignore=NAME"},
    Words{
        ErrorCode::fit_without_tolerance,
        "--fit has no tolerance for channel \"{0}\"; expected one for each, where D is for those of --metric together; "
        "add {0}=D"},
    Words{ErrorCode::fit_of_other_form,
          "{subject} takes rotations as quaternions, and column \"{0}\" gives one in another form; convert them first "
          "with --rotation-output quaternion"},
    Words{ErrorCode::fit_of_missing,
          "the number in channel \"{0}\" is missing; expected one in every sample; give --missing skip-row"},
    Words{ErrorCode::fit_of_single_sample,
          "{subject} takes two samples or more of each curve, and there are fewer; add some"},
    Words{ErrorCode::fit_of_sequence,
          "{subject} has several curves in {0}, which nothing tells apart when it is read; expected a group or another "
          "format; "
          "give -f ssv, -f json, or --group"},
    Words{ErrorCode::fit_of_setting,
          "the member \"{0}\" is a setting of a curve of keys, and --fit prints keys of the default rules; remove it"},
    Words{ErrorCode::fit_beyond_doubles,
          "{subject} squares numbers and tolerances, and those of channel \"{0}\" are too large or too small for that; "
          "expected numbers below 1e150 and tolerances above 1e-150; give --scale {0}=FACTOR"},
    Words{
        ErrorCode::fit_below_doubles,
        "{subject}: {0} is near the spacing of doubles in channel \"{1}\", whose numbers reach {2}; expected at least "
        "{3}; give a larger tolerance"},
    Words{ErrorCode::kept_time_without_sample, "{subject}: no sample is at the time {0}; expected times of samples"},
    Words{ErrorCode::fit_impossible,
          "no tension, continuity and bias were found that stay within {subject}; expected a tolerance that the digits "
          "of "
          "the output have, and positions that do not repeat; give --fit-keys hermite, more digits, or a larger "
          "tolerance"},
    Words{
        ErrorCode::tolerance_without_rotation,
        "{subject} has an angle, and there are no rotations; expected a distance alone; leave out the angle, or name a "
        "rotation with --rotation"},
    Words{ErrorCode::tolerance_of_rotations,
          "{subject} has a distance, and there are only rotations or angles, which have none; expected an angle alone; "
          "give one, as in {subject} 0.5deg, or --rotation none to take their numbers as positions"},
    Words{ErrorCode::end_velocity_of_rotation,
          "{subject}: a velocity has a number per channel, and rotations have none; expected another end rule; give "
          "--rotation none for plain channels"},
    Words{ErrorCode::emit_of_angle,
          "the pieces of an angle would be in different turns; expected channels that are no angles; leave out "
          "--angle, or "
          "{subject}"},
    Words{ErrorCode::emit_of_angles,
          "the pieces of a rotation are those of the numbers of its quaternion; expected rows with these; give "
          "--rotation-output quaternion"},
    Words{ErrorCode::emit_of_rotation,
          "the curve {0} of a rotation has no cubics; expected components; give --rotation-curve components, or "
          "--rotation none"},
    Words{ErrorCode::ease_with_missing_cells,
          "ease_in and ease_out warp all channels of a segment, and some are missing because --missing skip-cell "
          "skipped cells; expected numbers in all; fill them in, or give --no-ease"},
    Words{ErrorCode::tangents_beyond_doubles,
          "the curve from time {0} to {1} has tangents beyond the range of doubles; expected less than 1.8e308 in "
          "size; scale the keys down"},
    Words{ErrorCode::length_beyond_doubles,
          "up to time {0} the length of the curve is beyond the range of doubles; expected less than 1.8e308; "
          "scale the keys down"},
    Words{ErrorCode::channel_without_numbers,
          "{0}: no key has a number; expected at least one; fill one in, or leave the column out with --columns"},
    Words{ErrorCode::closing_key_differs,
          "this key closes the curve at the position of line {0}, but with another tension, continuity or bias; "
          "expected the same; correct one of the two"},
    Words{ErrorCode::closing_velocity_differs,
          "this key closes the curve at the position of line {0}, but with another velocity; expected the same; "
          "correct one of the two, or leave the incoming one of the first key and the outgoing one of the last "
          "empty"},
    Words{ErrorCode::seam_velocity_missing,
          "channel \"{0}\": a velocity is missing where the closed curve returns to its first key; expected the "
          "incoming one of the first key and the outgoing one of the last; fill them in"},
    Words{ErrorCode::incoming_velocity_missing,
          "the incoming velocity of channel \"{0}\" is missing; expected a number at every key but the first; fill "
          "it in, or remove the row"},
    Words{ErrorCode::outgoing_velocity_missing,
          "the outgoing velocity of channel \"{0}\" is missing; expected a number at every key but the last; fill "
          "it in, or remove the row"},
    Words{ErrorCode::rotation_incomplete,
          "the rotation of \"{0}\" lacks a number; expected all of them, or none; fill it in, or remove the row"},
    Words{ErrorCode::rotation_not_unit,
          "the quaternion of \"{0}\" has the norm {1}; expected 1, within 0.001; check its columns and their order, "
          "or give --normalize to divide by the norm, or --rotation none for plain channels"},
    Words{ErrorCode::rotation_zero,
          "the quaternion of \"{0}\" is zero, which is no rotation; expected the norm 1; correct it, or give "
          "--rotation none for plain channels"},
    Words{ErrorCode::matrix_not_orthogonal,
          "the matrix of \"{0}\" is {1} from orthogonal; expected rows of the norm 1 and at right angles, within "
          "0.001; "
          "check its columns and their order, or give --normalize for the nearest rotation, or --rotation none for "
          "plain channels"},
    Words{ErrorCode::matrix_no_rotation,
          "the matrix of \"{0}\" has the determinant {1}, so that it is no rotation; expected 1; check its columns "
          "and "
          "their order, or give --rotation none for plain channels"},
    Words{ErrorCode::angle_over_turn,
          "\"{0}\" has an angle of {1} radians; expected no more than a whole turn, 6.2832; give degrees as its unit, "
          "with --angles or --angle, or subtract whole turns"},
    Words{ErrorCode::angle_too_large,
          "\"{0}\" has an angle of {1} degrees; expected no more than 10000 turns; check its columns "
          "and their order"},
    Words{ErrorCode::axis_zero,
          "the rotation of \"{0}\" has an angle of {1} around an axis of zero; expected an axis; correct it"},
    Words{ErrorCode::half_turn_between_keys,
          "the rotation of \"{0}\" is half a turn from the one on line {1}, around an axis that nothing gives; "
          "expected less; add a key between them"},
    Words{ErrorCode::whole_turns,
          "the rotation of \"{0}\" makes whole turns, an angle of {1}; expected a curve that can; give "
          "--rotation-curve squad or slerp"},
    Words{ErrorCode::angle_missing,
          "the angle \"{0}\" is missing; expected a number at every key; fill it in, or remove the row"},
    Words{ErrorCode::half_turn_of_angle,
          "the angle \"{0}\" is half a turn from the one on line {1}, which leaves the way open; expected less; add a "
          "key "
          "between them"},
    Words{ErrorCode::equal_speed_with_velocities,
          "{subject} would change velocities, which are given; expected one of the two; remove {subject}"},
    Words{ErrorCode::segment_starts_elsewhere,
          "this segment starts at {0}, and the one before it ends at {1}; expected segments without gaps, in "
          "order; correct them, or divide the curves with --group"},
    Words{ErrorCode::segment_jumps,
          "this segment starts at the position {0}, and the one before it ends at {1}; expected the same; correct "
          "one of the two"},
    Words{ErrorCode::segment_without_duration,
          "the duration is {0}; expected a positive number, and an end within the range of doubles; correct it"},
    Words{ErrorCode::sort_of_segments,
          "{subject}: the rows are segments, which are expected in order; remove {subject}"},
    Words{ErrorCode::closing_key_against_period,
          "this key repeats the position of line {0} and so ends the period, but {subject} differs; remove one of "
          "them"},
    Words{ErrorCode::period_too_short,
          "{subject}: the curve is closed before its last key, at time {0}; expected a longer period; correct it"},
    Words{ErrorCode::too_few_closed_keys, "a closed curve needs at least two distinct keys; add keys"},
    Words{ErrorCode::no_period,
          "the period of the closed curve is unknown; expected --period, or a last row that repeats the first "
          "position; give one"},
    Words{ErrorCode::row_beyond_doubles,
          "the row at time {0} has a number beyond the range of doubles; expected less than 1.8e308 in size; scale "
          "the keys down"},
    // exact
    Words{ErrorCode::decimal_too_long,
          "a decimal of more digits than --exact-input takes; expected at most 10,000; shorten it, or remove "
          "--exact-input"},
    Words{ErrorCode::row_needs_more_digits,
          "the row at time {0} has a number that cannot be computed to so many digits; expected fewer; give a "
          "smaller number to --digits or --fixed"},
    // write
    Words{ErrorCode::text_in_binary_format,
          "column \"{0}\" holds text, and {1} holds only numbers; expected a format with text, such as csv; choose "
          "another one, or remove the column"},
    Words{ErrorCode::several_curves_in_one_table,
          "there is more than one curve, and {0} holds one table of rows; expected one; choose another format, "
          "such as csv"},
    Words{ErrorCode::time_beyond_doubles,
          "time {0} has more digits than a double; expected one that is a double, or a text format; choose one, "
          "such as csv"},
    Words{ErrorCode::other_columns,
          "its rows have the columns {0}; expected {1}, as in the previous files; give --output-dir to write an "
          "output for each file"},
    Words{ErrorCode::file_column_taken,
          "there is a column \"{0}\" already; expected another name for the column of files; give "
          "--file-column=NAME"},
    Words{ErrorCode::name_not_utf8,
          "the byte {0} of the file's name is not UTF-8; expected UTF-8 for --file-column; rename the file"},
    Words{ErrorCode::other_checksum,
          "its SHA-256 is {0}; expected {1}, that of the keys that {2} was made from; give that file"},
    Words{ErrorCode::made_from_fewer_inputs, "{0} was made from fewer files of keys, {1}; give as many"},
    Words{ErrorCode::made_from_more_inputs, "{0} was made from more files of keys, {1}; give as many"},
    Words{ErrorCode::no_provenance,
          "no provenance: nothing in it shows how it was made; expected an output that was made with --meta"},
    // plot
    Words{ErrorCode::picture_beyond_doubles,
          "the differences of a channel are beyond the range of doubles; expected less than 1.8e308; correct them"},
    Words{ErrorCode::picture_too_small,
          "the picture has no room for {0} channels; expected a larger one; give a larger {subject}, or remove it"},
    // run
    Words{ErrorCode::out_of_memory, "out of memory"},
    Words{ErrorCode::unexpected, "{0}"},
    Words{ErrorCode::parameter_with_times,
          "{subject} makes times, but column \"{0}\" has them; expected one of the two; remove {subject}, or "
          "choose other columns with --columns"},
    Words{ErrorCode::unknown_axis, "{subject}: no channel \"{0}\"; expected two of {1}, or numbers from 1{nearest}"},
    Words{ErrorCode::same_axes,
          "{subject}: channel \"{0}\" is given twice; expected two different ones; give another one"},
    // check: errors
    Words{ErrorCode::nothing_to_compare,
          "nothing to compare: the columns are {0}; expected some of {1}; rename the columns"},
    Words{ErrorCode::repeated_column, "two columns are called \"{0}\"; expected different names; rename one"},
    Words{ErrorCode::samples_without_places,
          "no column of times or arc lengths: the columns are {0}; expected {1}, or s for arc lengths; add one, or "
          "rename it"},
    Words{ErrorCode::unnamed_sample_columns,
          "{0} columns without names; expected {1}: {2}; name them in a first row, or list their fields with "
          "--fields"},
    Words{ErrorCode::fields_without_places,
          "{subject} has neither time nor s, the places of the samples; expected one of them; add it in the order "
          "of the columns"},
    Words{ErrorCode::tolerance_of_other_column,
          "{subject}: no column \"{0}\" is compared; expected some of {1}; correct it"},
    Words{ErrorCode::no_position_column, "no column of positions; expected at least one of {0}; rename it, or add one"},
    Words{ErrorCode::no_samples_on_curve,
          "no row is on the curve of the keys; expected at least one; give samples of the same curve"},
    Words{ErrorCode::no_sample_numbers, "no row has a number to compare; expected at least one; give other samples"},
    // check: problems
    Words{ErrorCode::missing_columns, "columns missing: {0}"},
    Words{ErrorCode::unknown_columns, "columns of no field: {0}; give the fields to compare with --fields"},
    Words{ErrorCode::curve_without_rows, "curve {0} has no rows"},
    Words{ErrorCode::rows_without_keys, "curve {0} has no keys; its rows are in line {1} and below"},
    Words{ErrorCode::curve_counts, "number of curves: {0} in the rows, {1} in the keys, {2} compared"},
    Words{ErrorCode::times_off_curve,
          "rows outside the curve: {0}; the first, in line {1}, has time {2}; the nearest time of the curve is {3}"},
    Words{ErrorCode::lengths_off_curve,
          "rows outside the curve: {0}; the first, in line {1}, has arc length {2}; the nearest one of the curve "
          "is {3}"},
    Words{ErrorCode::rows_without_place, "rows without a time or arc length: {0}; the first is in line {1}"},
    // cli
    Words{ErrorCode::wrong_command_line, "{0}; see --help"},
    Words{ErrorCode::unknown_option, "unknown option {0}{nearest} (--help lists all options)"},
    Words{ErrorCode::option_repeated, "{subject} is given more than once; expected once; remove one"},
    Words{ErrorCode::flag_with_value, "{0} takes no value; remove the value"},
    Words{ErrorCode::value_missing, "{0}: its value is missing; expected one after the option; see --help"},
    Words{ErrorCode::empty_value,
          "{subject}: an empty value; expected one as in --help; give it, or remove the option"},
    Words{ErrorCode::empty_file_name, "an empty file name; expected a file, or - for standard input; remove it"},
    Words{ErrorCode::unknown_name, "{subject}: unknown name \"{0}\"; expected one of {1}{nearest}"},
    Words{ErrorCode::expected_within_doubles,
          "{subject} \"{0}\": expected at most 1.7976931348623157e308 in size, as doubles are"},
    Words{ErrorCode::expected_positive_ratio,
          "{subject} \"{0}\": expected a decimal or a ratio above 0, such as 0.1 or 1/24"},
    Words{ErrorCode::expected_ratio, "{subject} \"{0}\": expected a decimal or a ratio, such as 1.5 or 7/24"},
    Words{ErrorCode::expected_ratios,
          "{subject} \"{0}\": expected decimals or ratios, separated by commas, such as 0,0.5,7/24"},
    Words{ErrorCode::expected_renamings,
          "{subject} \"{0}\": expected two names with = between, or several such pairs separated by commas, as in "
          "pos_x=x,pos_y=y"},
    Words{ErrorCode::expected_rotation,
          "{subject} \"{0}\": expected quaternion=X:Y:Z:W, axis-angle=X:Y:Z:ANGLE, after which ,relative may follow, "
          "euler=A:B:C,order=XYZ, matrix= with nine columns, row after row, each with names or numbers of columns, or "
          "none"},
    Words{ErrorCode::expected_euler_order,
          "{subject} \"{0}\": expected three letters of X, Y and Z, the second other than those next to it, as in "
          "order=ZYX for turns around the turned axes, or order=zyx around those at rest"},
    Words{ErrorCode::expected_rotation_form,
          "{subject} \"{0}\": expected quaternion, axis-angle, matrix, or euler= and an order, as in euler=ZYX"},
    Words{ErrorCode::expected_angles,
          "{subject} \"{0}\": expected a channel and its unit, degrees or radians, or several separated by commas, "
          "such as heading=degrees"},
    Words{ErrorCode::expected_scales,
          "{subject} \"{0}\": expected a channel and a factor other than 0, or several separated by commas, such "
          "as x=0.01,y=1/3"},
    Words{ErrorCode::expected_rate, "{subject} \"{0}\": expected a rate whose step is a double, less than 1.8e308"},
    Words{ErrorCode::expected_range, "{subject} \"{0}\": expected a range FIRST:LAST:STEP, such as 0:10:0.5"},
    Words{ErrorCode::endless_range,
          "{subject} \"{0}\": the range does not end; expected a step that leads from its first place to its last"},
    Words{ErrorCode::range_too_long,
          "{subject} \"{0}\": a range of more than {1} places; expected fewer; give --from, --to and --step"},
    Words{ErrorCode::list_without_numbers, "no number for {subject}; expected one at least"},
    Words{ErrorCode::group_without_places, "curve {0} has no rows in the file of {subject}; expected some; add them"},
    Words{ErrorCode::grouped_places_in_provenance,
          "{subject} has other places for each group, which --meta cannot record; expected the same for all; leave "
          "out one of them"},
    Words{ErrorCode::unreadable_list,
          "cannot be read for {subject}; expected a file of numbers, or @FILE:COLUMN for a column of a file"},
    Words{ErrorCode::expected_count, "{subject} \"{0}\": expected a whole number from 1 to 2^63 - 1, in digits"},
    Words{ErrorCode::expected_form, "{subject} \"{0}\": expected 4 to 32 coefficients, such as poly8"},
    Words{ErrorCode::expected_whole_number, "{subject} \"{0}\": expected a whole number from {1} to {2}"},
    Words{ErrorCode::expected_curve_tolerance,
          "{subject} \"{0}\": expected a distance above 0, an angle with deg or rad for rotations, or both separated "
          "by a "
          "comma, such as 0.01 or 0.01,0.5deg"},
    Words{
        ErrorCode::expected_fit,
        "{subject} \"{0}\": expected a distance above 0 for all channels, NAME=D for one, an angle with deg or rad for "
        "rotations, or several separated by commas, such as 0.01 or 0.01,fov=0.5,0.5deg"},
    Words{ErrorCode::expected_corner, "{subject} \"{0}\": expected degrees above 0 and below 180, such as 30"},
    Words{ErrorCode::expected_tolerance,
          "{subject} \"{0}\": expected a distance of at least 0, for all columns or as COLUMN=DISTANCE, such as "
          "1e-9 or x=1e-6"},
    Words{ErrorCode::expected_delimiter,
          "{subject} \"{0}\": expected one character that cannot be part of a number, or tab, comma, semicolon, "
          "space or pipe"},
    Words{ErrorCode::expected_decimal_mark, "{subject} \"{0}\": expected a comma or a point"},
    Words{ErrorCode::expected_tcb, "{subject} \"{0}\": expected three numbers T,C,B, such as 0,0.5,-0.25"},
    Words{ErrorCode::expected_columns, "{subject} \"{0}\": expected columns by name or number, separated by commas"},
    Words{ErrorCode::expected_name_part, "{subject} \"{0}\": expected a part of a file name, without /"},
    Words{ErrorCode::expected_axes,
          "{subject} \"{0}\": expected two channels by name or number, with a colon between them, such as x:z"},
    Words{ErrorCode::expected_size,
          "{subject} \"{0}\": expected width and height in pixels, 100 to 10000 each, such as 800x600"},
    Words{ErrorCode::field_repeated, "{subject}: {0} is repeated; expected each field once; remove one"},
    Words{ErrorCode::options_exclude, "{0} and {1} exclude each other{2}; expected one of them; remove one"},
    Words{ErrorCode::option_needs, "{0} needs {1}{2}; give both, or neither"},
    Words{ErrorCode::option_idle_with, "{0} has no effect with {1}{2}; remove it"},
    Words{ErrorCode::option_idle, "{0} has no effect{1}; remove it"},
    Words{ErrorCode::no_sampling_option,
          "no sampling option given; expected one of {0}; for example tcbsample --step 0.1 keys.csv"},
    Words{ErrorCode::range_backwards, "--to {0} is before --from {1}; expected a later one; swap them"},
    Words{ErrorCode::output_of_other_format,
          "--output {0} names {1} by its ending, but --output-format is {2}; expected the same; change one of them"},
    Words{ErrorCode::output_not_written,
          "--output {0}: {1} is not an output format; expected .csv, .tsv, .ssv, .json, .jsonl, .npy or .svg; give "
          "another ending, and convert the file afterwards"},
    Words{ErrorCode::binary_to_terminal,
          "npy is not text, and standard output is a terminal; expected a file or a pipe; give -o FILE.npy"},
    Words{ErrorCode::standard_input_twice,
          "{subject} - and the keys are both standard input; expected one of them; give the other by its file name"},
    Words{ErrorCode::fit_picture_of_several_files,
          "a picture of {subject} shows the recordings of one file; expected one input and one output; draw each by "
          "itself"},
    Words{ErrorCode::comparison_of_several_files, "{subject} takes one file of keys; {0} are given; remove the others"},
    Words{ErrorCode::line_end_in_provenance,
          "{subject}: --meta cannot hold a value with a line end; expected one without; remove --meta, or rename "
          "columns"},
    Words{ErrorCode::option_not_of_provenance,
          "the provenance has {subject}, which does not affect the rows; expected options that do; correct it"},
    Words{ErrorCode::file_in_provenance,
          "the provenance has the file {0} among its options; expected options; correct it"},
    Words{ErrorCode::provenance_incomplete, "the provenance lacks the option --meta; expected all options; add it"},
    Words{ErrorCode::option_in_provenance,
          "{subject} is given with --from-meta, which takes every option from {0}; remove it"},
    Words{ErrorCode::other_number_of_files, "{0} was made from {1} files of keys; {2} given; give as many"},
};

/// The further remedy of an error about the roles of columns whose words do not show the option.
constexpr const char* columns_remedy = "; or name the columns to take with --columns position=";

using FormatArguments = fmt::dynamic_format_arg_store<fmt::format_context>;

/// A list in words; a hundred thousand names would not make them clearer.
std::string listed(const std::vector<std::string>& list) {
  constexpr std::ptrdiff_t most = 20;
  if (std::ssize(list) <= most) return fmt::format("{}", fmt::join(list, ", "));
  return fmt::format("{} and {} more", fmt::join(list.begin(), list.begin() + most, ", "), std::ssize(list) - most);
}

struct AddValue {
  FormatArguments& to;
  void operator()(const std::vector<std::string>& list) const { to.push_back(listed(list)); }
  void operator()(const auto& value) const { to.push_back(value); }
};

/// A name as it is compared: in lower case, without the dashes of an option.
std::string compared(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; });
  return text;
}

/// The last option that has this name among its values, with it, as in "--extrapolate hold"; or "".
std::string option_with_value(std::string_view name) {
  std::string found;
  for (const OptionRow& row : option_table()) {
    const auto names = row.known == nullptr ? std::vector<std::string_view>{} : row.known();
    if (std::ranges::count(names, name) > 0) found = fmt::format("{} {}", row.long_name(), name);
  }
  return found;
}

/// The name that is probably meant, or "".
std::string meant(const std::string& text, const std::vector<std::string>& names) {
  const std::string wanted = compared(text);
  if (text.starts_with("--")) {
    if (std::string option = option_with_value(wanted); !option.empty()) return option;
  }
  std::vector<std::string> all;
  std::ranges::transform(names, std::back_inserter(all), compared);
  const std::string_view likely = likely_name(wanted, std::vector<std::string_view>(all.begin(), all.end()));
  return likely.empty() ? "" : names[static_cast<std::size_t>(std::ranges::find(all, likely) - all.begin())];
}

/// "; did you mean NAME?", or "".
std::string nearest(const std::vector<ErrorValue>& values) {
  const auto is_list = [](const ErrorValue& value) { return std::holds_alternative<std::vector<std::string>>(value); };
  const auto list = std::ranges::find_if(values, is_list);
  if (list == values.end() || !std::holds_alternative<std::string>(values[0])) return "";
  const std::string name = meant(std::get<std::string>(values[0]), std::get<std::vector<std::string>>(*list));
  return name.empty() ? "" : fmt::format("; did you mean {}?", name);
}

/// Adds the other ways in which words may show the value with this index.
struct AddNamed {
  FormatArguments& to;
  std::size_t index;

  void operator()(std::uint64_t number) const { add('c', fmt::format("column {}", number)); }
  void operator()(const std::string& text) const {
    add('q', in_quotes(text));
    add('c', text);
  }
  void operator()(const auto&) const {}
  void add(char kind, const std::string& text) const {
    to.push_back(fmt::arg(fmt::format("{}{}", kind, index).c_str(), text));
  }
};

std::string line_of(const Error& error, bool colored) {
  const TextPosition& position = error.position();
  std::string where = position.file.empty() ? "tcbsample" : in_one_line(position.file);
  if (!position.file.empty() && position.line != 0) where += fmt::format(":{}", position.line);
  if (!position.file.empty() && position.line != 0 && position.column != 0)
    where += fmt::format(":{}", position.column);
  return message_head(where, MessageKind::error, colored) + in_one_line(error_message(error));
}

/// A line for the error, and one for each that it holds.
std::string lines_of(const Error& error, bool colored) {
  std::string text = line_of(error, colored);
  for (const Error& other : error.others()) text += "\n" + lines_of(other, colored);
  return text;
}

}  // namespace

std::span<const Words> remedies() { return all_words; }

std::string_view option_name(Option option) { return option == Option::none ? "" : row_of(option).long_name(); }

std::string error_message(const Error& error) {
  if (!error.message().empty()) return error.message();
  const auto words = std::ranges::find(all_words, error.code(), &Words::code);
  FormatArguments values;
  for (const ErrorValue& value : error.values()) std::visit(AddValue{values}, value);
  for (std::size_t i = 0; i < error.values().size(); ++i) std::visit(AddNamed{values, i}, error.values()[i]);
  const std::string subject = error.member().empty() ? std::string(option_name(error.option())) : error.member();
  values.push_back(fmt::arg("subject", subject));
  values.push_back(fmt::arg("nearest", nearest(error.values())));
  const bool shows_subject = words->text.find("{subject}") != std::string_view::npos;
  const bool columns_help = error.option() == Option::columns && !shows_subject;
  return fmt::vformat(words->text, values) + (columns_help ? columns_remedy : "");
}

std::string error_text(const Error& error) { return lines_of(error, false); }

std::string colored_error_text(const Error& error) { return lines_of(error, true); }

namespace {

/// {0}, {1}, … are the values of the note, lists joined by ", ".
struct NoteWords {
  NoteCode code;
  std::string_view text;
};

constexpr std::array note_words{
    NoteWords{NoteCode::reads_terminal, "keys are read from the terminal; end them with Ctrl-D, or name a file"},
    NoteWords{NoteCode::no_time_column, "no time column; the times of the keys are 0, 1, 2, ..."},
    NoteWords{NoteCode::ignored_columns,
              "ignored: {0}; --columns gives them roles, as in carry=NAME or position=NAME:NAME"},
    NoteWords{NoteCode::unchosen_columns, "ignored, as --columns chooses others: {0}"},
    NoteWords{NoteCode::remainder, "the last key is {0} after the last row; --end keep or --end fit includes it"},
    NoteWords{NoteCode::range_remainder,
              "the end of the range is {0} after the last row; --end keep or --end fit includes it"},
    NoteWords{NoteCode::more_remainders, "the same in {0} more curves, with their own distances"},
    NoteWords{NoteCode::rate_of_frames,
              "the times in column \"{0}\" count frames, so --rate is per frame; --input-fps HZ makes them seconds"},
    NoteWords{NoteCode::step, "the step is {0}"},
    NoteWords{NoteCode::skipped_rows, "rows skipped for missing numbers: {0}"},
    NoteWords{NoteCode::made_times, "none; made with --parameter {0}"},
    NoteWords{NoteCode::fitted,
              "{0} samples, {1} keys, {2} times fewer; at most {3} from a sample, on line {4}; no fewer than {5} keys "
              "can do"},
    NoteWords{NoteCode::rotations_not_fitted, "rotations not fitted: {0}; --fit D,0.5deg fits them"},
    NoteWords{NoteCode::labels_not_fitted, "ignored: {0}; the keys of a fit have no labels"},
    NoteWords{NoteCode::likely_quaternion,
              "columns 5 to 8 may be a quaternion; --rotation quaternion=5:6:7:8 resamples them as a rotation, "
              "--rotation none leaves out this note"},
    NoteWords{NoteCode::likely_matrix,
              "the columns may be poses, matrices of 3 rows and 4 columns; --parameter uniform "
              "--rotation matrix=1:2:3:5:6:7:9:10:11 resamples them as such, --rotation none leaves out this note"},
    NoteWords{NoteCode::other_program, "made by {0}; this is {1}, whose last digits may differ"},
};

}  // namespace

std::string note_text(const Note& note) {
  const auto words = std::ranges::find(note_words, note.code, &NoteWords::code);
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const ErrorValue& value : note.values) {
    if (const auto* list = std::get_if<std::vector<std::string>>(&value)) {
      values.push_back(fmt::format("{}", fmt::join(*list, ", ")));
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      values.push_back(*text);
    } else if (const auto* number = std::get_if<double>(&value)) {
      values.push_back(*number);
    } else {
      values.push_back(std::get<std::uint64_t>(value));
    }
  }
  return fmt::vformat(words->text, values);
}

}  // namespace tcb
