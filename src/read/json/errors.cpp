// Errors of the reading of JSON: their texts.
#include "read/json/errors.hpp"

#include <fmt/format.h>

#include <utility>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb::json {
namespace {

template <class... Values>
Error refused(fmt::format_string<Values...> text, Values&&... values) {
  return Error(Exit::data, fmt::format(text, std::forward<Values>(values)...));
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string columns_of_curve(std::string_view time, const std::vector<std::string>& channels) {
  return fmt::format("{} and {}", in_quotes(time), listed(channels));
}

}  // namespace

Error options_of_delimited_text() {
  return Error(
      Exit::usage,
      fmt::format("{}, {}, {}, {}, {} and {} have no effect on JSON; remove them, or, if the input is not JSON, "
                  "give its format with {}",
                  option::delimiter, option::header, option::no_header, option::comment, option::decimal,
                  option::thousands, option::input_format));
}

Error no_text() { return refused("the input has no keys; expected a JSON object for each key; see {}", option::help); }

Error key_too_long() {
  return refused("a key is longer than 64 MiB; expected a shorter one; remove what it does not need");
}

Error object_too_long() {
  return refused("the object around the keys is longer than 64 MiB without them; remove what it does not need");
}

Error unexpected(std::string_view token, Expected expected) {
  if (token.starts_with('"')) token.remove_prefix(1);
  if (token.ends_with('"')) token.remove_suffix(1);
  const std::string_view what = [&]() -> std::string_view {
    switch (expected) {
      case Expected::value: return "a value";
      case Expected::name: return "a name in quotes";
      case Expected::colon: return "a colon after the name";
      case Expected::comma: return "a comma or a closing bracket";
      case Expected::after_comma: return "another value or member after the comma";
      case Expected::nothing: break;
    }
    return "nothing after the last bracket";
  }();
  return refused("not JSON: found {}; expected {}; correct the text", in_quotes(token), what);
}

Error character_in_string(std::string_view string) {
  return refused(
      "not JSON: the last character of {} is not allowed in a string; expected UTF-8 without control characters, and "
      "only the escapes of JSON; correct the text",
      in_quotes(string));
}

Error string_not_closed() { return refused("not JSON: a string is not closed; expected \" at its end; add it"); }

Error ends_early() {
  return refused("not JSON: the text ends too early; expected the rest of the last value; complete it");
}

Error number_too_large(std::string_view number) {
  return refused("{} is too large for a double; expected less than 1.8e308 in size; correct it", in_quotes(number));
}

Error table_incomplete() {
  return refused("the table has no \"data\", or no \"columns\"; expected both, as pandas writes them; complete it");
}

Error row_of_other_size(std::size_t row, std::size_t cells, std::size_t columns) {
  return refused("row {} of the table has {}; expected {}, one for each column; correct it", row,
                 counted(cells, "cell"), columns);
}

Error columns_differ_in_length(std::string_view column, std::size_t values, std::string_view first,
                               std::size_t values_of_first) {
  return refused("the column {} has {}; expected {}, as many as {}; correct it", in_quotes(column),
                 counted(values, "value"), values_of_first, in_quotes(first));
}

Error text_after_list() { return refused("there is text after the array of keys; expected nothing; remove it"); }

Error curve_expected() { return refused("no curve here; expected an object with \"keys\"; correct the text"); }

Error comma_between_curves_expected() {
  return refused("no comma after a curve; expected one, or the end of \"curves\"; correct the text");
}

Error no_key_between_commas() {
  return refused("no key before or after a comma; expected an object; remove the comma");
}

Error key_is_no_object(std::string_view what) {
  return refused("found {} as a key; expected an object; correct it", what);
}

Error no_keys() { return refused("found no keys; expected at least two; add them"); }

Error curve_without_keys() { return refused("found no keys; expected at least two; add them, or remove the curve"); }

Error curves_differ(std::string_view time, const std::vector<std::string>& channels, std::string_view first_time,
                    const std::vector<std::string>& first_channels) {
  return refused("the keys have {}; expected {}, as in the first curve; give all curves the same members",
                 columns_of_curve(time, channels), columns_of_curve(first_time, first_channels));
}

Error groups_of_curves() {
  return refused(
      "the curves of \"curves\" are separate already; expected keys of several curves in one list; remove {}",
      option::group);
}

Error single_number_expected() { return refused("this is not a number; expected one; correct it"); }

Error tcb_array_expected() { return refused("this is not an array; expected [T,C,B]; correct it"); }

Error array_unused(std::string_view member) {
  return refused(
      "this array is not used; expected \"position\" as the name of an array of positions; rename it, or give {} "
      "position={}, or position=NAME:NAME for the members to take",
      option::columns, member);
}

Error object_unused() {
  return refused(
      "the numbers in this value are not used, as they are in an object, or in arrays in an array; expected an array "
      "of numbers, or a member for each number; write them so, or give {} position=NAME:NAME for the members to take",
      option::columns);
}

Error nearly_role(std::string_view member, std::string_view role) {
  return refused(
      "this name is close to \"{0}\", but makes the member a channel; expected \"{0}\" or a name unlike it; rename it, "
      "or give {1} {0}={2} or position=NAME:NAME",
      role, option::columns, member);
}

Error no_time(std::string_view member) {
  return refused(
      "no member is the time, but {} may be; expected one called time; give {} time={}, or {} uniform if the keys have "
      "no times",
      in_quotes(member), option::columns, member, option::parameter);
}

Error velocity_count(std::size_t found, std::size_t expected) {
  return refused("the array has {}; expected {}, as in the array of positions; correct it", counted(found, "number"),
                 expected);
}

Error rotation_size(std::size_t found) {
  return refused(
      "the array has {}; expected four, x, y, z, w of a quaternion; correct it, or give {} position=NAME:NAME for the "
      "members to take",
      counted(found, "number"), option::columns);
}

Error rotation_members() {
  return refused(
      "\"rotation\" has members other than x, y, z and w; expected the four numbers of a quaternion; correct them, or "
      "give {} position=NAME:NAME for the members to take",
      option::columns);
}

Error channel_count(std::size_t names, std::size_t numbers) {
  return refused("\"channels\" has {}; expected {}, one for each number of \"position\"; correct it",
                 counted(names, "name"), numbers);
}

Error member_repeats() { return refused("the key has this member twice; expected it once; remove one"); }

Error member_unknown() {
  return refused("the first key has no such number; expected the same members in every key; add it there");
}

Error member_missing(std::string_view member, bool is_time) {
  return refused(
      "the key has no member {}; expected the members of the first key; add it, or give {} skip-row{} or break",
      in_quotes(member), option::missing, is_time ? "" : ", skip-cell");
}

Error not_a_number(std::string_view text) {
  return refused("{} is not a number; expected a number without quotes; correct it", in_quotes(text));
}

Error number_missing(std::string_view sign, bool is_time) {
  return refused("found {}; expected a number; fill it in, or give {} skip-row{} or break", sign, option::missing,
                 is_time ? "" : ", skip-cell");
}

Error text_missing() {
  return refused("found null; expected a text; fill it in, or give {} skip-row", option::missing);
}

Error number_expected() { return refused("this is not a number; expected one, as in the first key; correct it"); }

Error text_expected() {
  return refused("this is not a text or a number; expected one, as in the first key; correct it");
}

Error array_expected() {
  return refused("this is not an array; expected one of numbers, as in the first key; correct it");
}

Error array_size(std::size_t found, std::size_t expected) {
  return refused("the array has {}; expected {}, as in the first key; correct it", counted(found, "element"), expected);
}

Error also_in_tcb() {
  return refused("this parameter is given twice, in \"tcb\" and alone; expected it once; remove one");
}

Error no_such_time(std::string_view time) {
  return refused(
      "{} does not exist; expected a date of the calendar, a time of day without leap seconds, and an undropped frame "
      "below the rate; correct it",
      in_quotes(time));
}

Error time_in_other_notation(std::string_view time) {
  return refused("{} is not in the notation of the first time; expected one notation in all keys; convert it",
                 in_quotes(time));
}

Error no_keyframes() {
  return refused(
      "the input has no keyframes; expected an object with a list \"keyframes\" that is not empty, as "
      "nerfstudio saves camera paths; give another {}",
      option::input_format);
}

Error matrix_is_text() {
  return refused(
      "the matrix is a text, as in files of nerfstudio before version 1, whose curve is another one; expected "
      "16 numbers; open the scene in a newer viewer, and save the camera path there");
}

Error last_row_of_matrix() {
  return refused(
      "the last row of the matrix is not 0, 0, 0, 1; expected the 4 x 4 matrix of a pose, row by row; correct "
      "it, or transpose the matrix");
}

Error matrix_missing() {
  return refused(
      "the keyframe has no matrix; expected a 4 x 4 matrix of 16 numbers, row by row; add it, or remove the "
      "keyframe");
}

Error matrix_size(std::size_t found) {
  return refused("the matrix has {}; expected 16, row by row; correct it", counted(found, "number"));
}

Error number_of_keyframe_missing(std::string_view member) {
  return refused("the keyframe has no {}; expected a number in every keyframe; add it", member);
}

Error transition_not_positive(std::string_view seconds) {
  return refused("the transition takes {} seconds; expected a number above 0; correct it, or remove the keyframe",
                 seconds);
}

Error no_setting(std::string_view suggestion) {
  return refused("there is no such setting; did you mean {}?", suggestion);
}

Error setting_repeats() { return refused("the object has this member twice; expected it once; remove one"); }

Error setting_of_keys() { return refused("this member is outside the keys; expected it in each key; move it there"); }

Error setting_is_option(std::string_view option) {
  return refused("this is an option, not a setting of a file; expected it on the command line; remove it, and give {}",
                 option);
}

Error setting_outside_curves() {
  return refused("this setting is outside the curves; expected it in each curve; move it there");
}

Error true_or_false_expected(std::string_view found) {
  return refused("found {}; expected true or false; correct it", in_quotes(found));
}

Error channel_names_expected() { return refused("this is not an array of names in quotes; expected one; correct it"); }

Error id_expected() { return refused("this is not a text or a number; expected one; correct it"); }

}  // namespace tcb::json
