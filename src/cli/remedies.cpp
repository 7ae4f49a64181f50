// Words for errors of the command line: from codes, subjects and values to sentences with the remedy.
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
    // run
    Words{ErrorCode::unexpected, "{0}"},
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
  const std::string& subject = error.option();
  values.push_back(fmt::arg("subject", subject));
  values.push_back(fmt::arg("nearest", nearest(error.values())));
  const bool shows_subject = words->text.find("{subject}") != std::string_view::npos;
  const bool columns_help = error.option() == option::columns && !shows_subject;
  return fmt::vformat(words->text, values) + (columns_help ? columns_remedy : "");
}

}  // namespace tcb
