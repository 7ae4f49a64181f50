// Errors of the command line: the words, the values, the conflicts, the job, and provenance.
#include "cli/errors.hpp"

#include <fmt/format.h>

#include "formats/formats.hpp"
#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error usage(std::string message) { return {Exit::usage, std::move(message)}; }

/// `words`: go on after the value of the option.
Error about_value(std::string_view text, std::string_view words) {
  return usage(fmt::format("{} {}", in_quotes(text), words));
}

}  // namespace

Error unknown_option(std::string_view name, std::string_view suggestion) {
  const std::string meant = suggestion.empty() ? "" : fmt::format("; did you mean {}?", suggestion);
  return usage(fmt::format("unknown option {}{} ({} lists all options)", name, meant, option::help));
}

Error option_repeated() { return usage("the option is repeated; expected it once; remove all but one"); }

Error flag_with_value(std::string_view flag) { return usage(fmt::format("{} takes no value; remove the value", flag)); }

Error value_missing(std::string_view option) {
  return usage(fmt::format("{}: the value is missing; expected one after the option; see {}", option, option::help));
}

Error value_empty() {
  return usage(fmt::format("the value is empty; expected one as in {}; add it, or remove the option", option::help));
}

Error file_name_empty() {
  return usage("the name of a file is empty; expected a file, or - for standard input; remove it");
}

Error command_line_not_understood(std::string_view message) {
  return usage(fmt::format("{}; see {}", message, option::help));
}

Error unknown_value(std::string_view name, std::span<const std::string_view> known) {
  return about_value(
      name, fmt::format("is not a known name; expected one of {}{}", listed(known), did_you_mean(name, known)));
}

Error number_beyond_doubles(std::string_view text) {
  return about_value(text, "is too large; expected at most 1.7976931348623157e308 in size, the largest double");
}

Error not_a_positive_ratio(std::string_view text) {
  return about_value(text,
                     "is not a number above 0; expected a decimal or a ratio of whole numbers, such as 0.1 or 1/24");
}

Error not_a_ratio(std::string_view text) {
  return about_value(text, "is not a number; expected a decimal or a ratio of whole numbers, such as 1.5 or 7/24");
}

Error step_of_rate_beyond_doubles(std::string_view text) {
  return about_value(text, "is too small a rate; expected one whose step, 1/HZ, is at most 1.7976931348623157e308");
}

Error not_a_count(std::string_view text) {
  return about_value(text, "is not a count; expected a whole number from 1 to 2^63 - 1, in digits");
}

Error not_a_whole_number(std::string_view text, std::uint64_t least, std::uint64_t most) {
  return about_value(text,
                     fmt::format("is not valid; expected a whole number from {0} to {1}, such as {0}", least, most));
}

Error not_a_curve_tolerance(std::string_view text) {
  return about_value(text,
                     "is not a tolerance; expected a distance above 0, an angle with deg or rad for rotations, or both "
                     "separated by a comma, such as 0.01 or 0.01,0.5deg");
}

Error not_limits_of_a_fit(std::string_view text) {
  return about_value(text,
                     "is not a list of tolerances; expected a distance above 0 for all channels, NAME=D for one "
                     "channel, an angle with deg or rad for rotations, or several of these separated by commas, such "
                     "as 0.01 or 0.01,fov=0.5,0.5deg");
}

Error not_an_angle_of_a_corner(std::string_view text) {
  return about_value(text, "is not an angle of a corner; expected degrees above 0 and below 180, such as 30");
}

Error not_a_tolerance(std::string_view text) {
  return about_value(text,
                     "is not a tolerance; expected a distance of at least 0 for all columns, or COLUMN=DISTANCE for "
                     "one, such as 1e-9 or x=1e-6");
}

Error not_a_delimiter(std::string_view text) {
  return about_value(text,
                     "is not a delimiter; expected one character that cannot be part of a number, or tab, comma, "
                     "semicolon, space or pipe");
}

Error not_a_thousands_mark(std::string_view text) {
  return about_value(text, "is no mark between thousands; expected comma, point, apostrophe, underscore or space");
}

Error not_a_decimal_mark(std::string_view text) {
  return about_value(text, "is not a decimal mark; expected a comma or a point");
}

Error not_three_parameters(std::string_view text) {
  return about_value(text,
                     "is not a tension, a continuity and a bias; expected three numbers T,C,B, such as 0,0.5,-0.25");
}

Error not_a_list_of_columns(std::string_view text) {
  return about_value(text, "has an empty item; expected column names or numbers between commas; remove a comma");
}

Error not_a_list_of_renamings(std::string_view text) {
  return about_value(text,
                     "is not a list of renamings; expected NAME=NAME pairs separated by commas, such as "
                     "pos_x=x,pos_y=y");
}

Error not_a_list_of_scales(std::string_view text) {
  return about_value(text,
                     "is not a list of factors; expected CHANNEL=FACTOR pairs separated by commas, with factors other "
                     "than 0, such as x=0.01,y=1/3");
}

Error not_a_list_of_angles(std::string_view text) {
  return about_value(text,
                     "is not a list of angles; expected CHANNEL=degrees or CHANNEL=radians, separated by commas, such "
                     "as heading=degrees");
}

Error not_a_rotation(std::string_view text) {
  return about_value(text,
                     "is not a rotation; expected quaternion=X:Y:Z:W, axis-angle=X:Y:Z:ANGLE, "
                     "axis-angle=X:Y:Z:ANGLE,relative, euler=A:B:C,order=XYZ, or matrix= with nine columns row by row, "
                     "where columns are names or numbers; or none");
}

Error not_an_order_of_axes(std::string_view text) {
  return about_value(text,
                     "has no valid order of axes; expected three of the letters X, Y and Z, with no two equal letters "
                     "side by side, such as ZYX for intrinsic rotations, or zyx for extrinsic rotations");
}

Error not_a_form_of_rotations(std::string_view text) {
  return about_value(text,
                     "is not a form of rotations; expected quaternion, axis-angle, matrix, or euler= and an order of "
                     "axes, as in euler=ZYX");
}

Error other_number_of_coefficients(std::string_view text) {
  return about_value(text, "is not a form of polynomials; expected 4 to 32 coefficients, such as poly8");
}

Error field_repeated(std::string_view field) {
  return usage(fmt::format("field {} is repeated; expected each field once; remove one", field));
}

Error not_a_part_of_a_name(std::string_view text) {
  return about_value(text, "contains /; expected part of a file name; remove the /");
}

Error not_two_axes(std::string_view text) {
  return about_value(text,
                     "is not a pair of axes; expected two channels by name or number, with a colon between them, such "
                     "as x:z");
}

Error not_a_size(std::string_view text) {
  return about_value(text,
                     "is not a size; expected width and height in pixels, from 100 to 10000 each, such as 800x600");
}

Error not_a_list_of_numbers(std::string_view text) {
  return about_value(text,
                     "is not a number; expected decimals or ratios of whole numbers, separated by commas, such as "
                     "0,0.5,7/24");
}

Error units_of_some_numbers(std::string_view number) {
  return about_value(number,
                     "and the numbers before it do not both have a unit of time; expected a unit for each number, "
                     "or for none");
}

Error duration_is_no_length() {
  return {Exit::usage,
          "a unit of time is given, but samples are placed by arc length; expected a length without a unit"};
}

Error not_a_range(std::string_view text) {
  return about_value(text, "is not a range; expected FIRST:LAST:STEP, such as 0:10:0.5");
}

Error range_without_end(std::string_view text) {
  return about_value(text, "never reaches its end; expected a step that leads from the first number to the last");
}

Error range_of_too_many_numbers(std::string_view text, std::uint64_t most) {
  return about_value(text, fmt::format("is a range of more than {} numbers; expected fewer; give {}, {} and {} instead",
                                       most, option::from, option::to, option::step));
}

Error list_unreadable() {
  return usage("the file cannot be read; expected a file of numbers, or @FILE:COLUMN for a column of a file");
}

Error list_of_too_many_numbers(std::uint64_t most) {
  return usage(fmt::format("the list has more than {} numbers; expected fewer; divide the list", most));
}

Error list_without_numbers() { return usage("the file has no numbers; expected at least one"); }

Error groups_of_numbers_in_provenance() {
  return usage(
      fmt::format("the column has different numbers for each group, which {} cannot record; expected the same "
                  "numbers for all groups; remove {}, or list the numbers",
                  option::meta, option::meta));
}

Error options_exclude_each_other(std::string_view option, std::string_view other, std::string_view reason) {
  return usage(
      fmt::format("{} and {} cannot be combined{}; expected only one; remove the other", option, other, reason));
}

Error option_needs_another(std::string_view option, std::string_view other, std::string_view reason) {
  return usage(fmt::format("{} needs {}{}; give both, or neither", option, other, reason));
}

Error option_without_effect_with(std::string_view option, std::string_view other, std::string_view reason) {
  return usage(fmt::format("{0} has no effect with {1}{2}; remove {0}", option, other, reason));
}

Error option_without_effect(std::string_view option, std::string_view reason) {
  return usage(fmt::format("{} has no effect{}; remove it", option, reason));
}

Error no_sampling_option(std::span<const std::string_view> options) {
  return usage(fmt::format("there is no sampling option; expected one of {}; give one, as in tcbsample {} 0.1 keys.csv",
                           listed(options), option::step));
}

Error range_backwards(std::string_view from, std::string_view to) {
  return usage(
      fmt::format("{} {} is before {} {}; expected a later end; swap the two", option::to, to, option::from, from));
}

Error output_of_other_format(std::string_view path, std::string_view named, std::string_view chosen) {
  return usage(fmt::format("the ending of {} {} means {}, but {} is {}; expected the same format; change one of them",
                           option::output, path, named, option::output_format, chosen));
}

Error output_not_written(std::string_view path, std::string_view ending) {
  return usage(
      fmt::format("{} {}: {} is not an output format; expected one of {}; choose another ending, and convert the file "
                  "afterwards",
                  option::output, path, ending, listed(output_endings())));
}

Error binary_to_terminal() {
  return usage(
      fmt::format("the format npy is binary, and standard output is a terminal; expected a file or a pipe; "
                  "give {} FILE.npy",
                  option::output));
}

Error standard_input_twice() {
  return usage("the file and the keys are both standard input; expected it once; give a file name for one of them");
}

Error comparison_of_several_files(std::size_t files) {
  return usage(fmt::format("there are {} files of keys; expected one; remove the others", files));
}

Error line_end_in_provenance() {
  return usage(
      fmt::format("the value has a line end, which {} cannot record; expected a value of one line; remove {}, "
                  "or rename columns",
                  option::meta, option::meta));
}

Error option_not_of_provenance(std::string_view option) {
  return {Exit::data, fmt::format("the provenance has the option {}, which does not affect the rows; expected options "
                                  "that do; remove it from the provenance",
                                  option)};
}

Error file_in_provenance(std::string_view file) {
  return {Exit::data, fmt::format("the provenance has the file {} among its options; expected options only; remove it "
                                  "from the provenance",
                                  in_quotes(file))};
}

Error option_of_provenance_reads_file(std::string_view option) {
  return {Exit::data, fmt::format("the provenance has {} with the name of a file to be read; expected the numbers "
                                  "themselves, as the program records them; replace the name",
                                  option)};
}

Error provenance_without_meta() {
  return {Exit::data,
          fmt::format("the provenance lacks the option {}; expected all options of the run; add it", option::meta)};
}

Error option_besides_provenance(std::string_view option, std::string_view file) {
  return usage(fmt::format("{} is given with {}, which takes all options from {}; remove {}", option, option::from_meta,
                           file, option));
}

Error other_number_of_files(std::string_view file, std::size_t recorded, std::size_t files) {
  return usage(fmt::format("the number of key files is {}, but {} was made from {}; give the same files", files, file,
                           recorded));
}

}  // namespace tcb
