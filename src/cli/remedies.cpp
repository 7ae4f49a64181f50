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
    // schema, read
    Words{ErrorCode::times_unclear,
          "no time column, but column \"{0}\" may be one; expected a column called time; give --columns time={0}, "
          "or --parameter uniform if the keys have no times"},
    Words{ErrorCode::no_such_time,
          "{c0}: {q1} does not exist; expected a time of a day, a frame below the rate that is not dropped, and no "
          "leap second; correct the cell"},
    Words{ErrorCode::time_in_other_notation,
          "{c0}: {q1} is not in the notation of the first time; expected one notation in a column; convert the cell"},
    // read/csv
    // keys
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
    Words{ErrorCode::other_columns,
          "its rows have the columns {0}; expected {1}, as in the previous files; give --output-dir to write an "
          "output for each file"},
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

}  // namespace

std::span<const Words> remedies() { return all_words; }

std::string error_message(const Error& error) {
  if (!error.message().empty()) return error.message();
  const auto words = std::ranges::find(all_words, error.code(), &Words::code);
  FormatArguments values;
  for (const ErrorValue& value : error.values()) std::visit(AddValue{values}, value);
  for (std::size_t i = 0; i < error.values().size(); ++i) std::visit(AddNamed{values, i}, error.values()[i]);
  const std::string subject = error.member().empty() ? error.option() : error.member();
  values.push_back(fmt::arg("subject", subject));
  values.push_back(fmt::arg("nearest", nearest(error.values())));
  const bool shows_subject = words->text.find("{subject}") != std::string_view::npos;
  const bool columns_help = error.option() == option::columns && !shows_subject;
  return fmt::vformat(words->text, values) + (columns_help ? columns_remedy : "");
}

}  // namespace tcb
