// Options: the table of options, their typed values, validators and conflicts, and the texts made from the tables.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "io/terminal.hpp"
#include "option_names.hpp"
#include "run/job.hpp"

namespace tcb {

/// The options, in the order of their rows.
enum class Option {
  none,
  // input
  input_format,
  delimiter,
  header,
  no_header,
  comment,
  columns,
  tcb,
  tcb_scale,
  decimal,
  group,
  missing,
  na,
  time_unit,
  input_fps,
  scale,
  rotation,
  angles,
  rotation_output,
  angle,
  normalize,
  duplicates,
  sort,
  // curve
  preset,
  tangents,
  ends,
  closed,
  period,
  equal_speed,
  parameter,
  metric,
  rotation_curve,
  no_ease,
  extrapolate,
  // sampling
  step,
  rate,
  count,
  segments,
  per_segment,
  at,
  arc_step,
  arc_count,
  arc_at,
  tolerance,
  emit,
  fit,
  fit_keys,
  keep_times,
  corner,
  from,
  to,
  end,
  keys,
  max_rows,
  // output
  output,
  output_format,
  fields,
  side,
  digits,
  fixed,
  jobs,
  golden,
  exact_input,
  meta,
  from_meta,
  hex,
  no_output_header,
  file_column,
  time_format,
  rename,
  plot,
  axes,
  title,
  size,
  // files
  output_dir,
  files,
  null,
  recursive,
  suffix,
  update,
  fail_fast,
  // comparison
  check,
  abs,
  rel,
  ulp,
  map,
  identify,
  // about
  explain,
  progress,
  no_progress,
  quiet,
  color,
  generate,
  list_presets,
  version,
  help,
};

inline constexpr std::size_t option_count = static_cast<std::size_t>(Option::help);

constexpr std::size_t index_of(Option option) { return static_cast<std::size_t>(option) - 1; }

/// Texts that are printed instead of rows, by name.
enum class Generated { manual, bash, zsh, fish, columns };
struct GeneratedName {
  std::string_view name;
  Generated kind;
};
inline constexpr std::array generated_names{
    GeneratedName{"man", Generated::manual}, GeneratedName{"bash", Generated::bash},
    GeneratedName{"zsh", Generated::zsh}, GeneratedName{"fish", Generated::fish},
    GeneratedName{"columns", Generated::columns}};

struct ColorName {
  std::string_view name;
  ColorWhen when;
};
inline constexpr std::array color_names{ColorName{"auto", ColorWhen::by_terminal},
                                        ColorName{"always", ColorWhen::always}, ColorName{"never", ColorWhen::never}};

/// A column of a file that has the times or arc lengths of an option.
struct PlaceColumn {
  Option option;
  std::string path, name;
};

struct DelimiterName {
  std::string_view name;
  char character;
};
inline constexpr std::array delimiter_names{DelimiterName{"tab", '\t'}, DelimiterName{"comma", ','},
                                            DelimiterName{"semicolon", ';'}, DelimiterName{"space", ' '},
                                            DelimiterName{"pipe", '|'}};

/// The forms of a cubic that help and completions show; a polynomial may have other numbers of coefficients.
struct FormName {
  std::string_view name;
};
inline constexpr std::array form_table{FormName{"hermite"}, FormName{"bezier"}, FormName{"poly"}, FormName{"poly8"}};

/// The values of the options, each by itself; what they mean together is decided by make_job.
struct TypedOptions {
  /// The value of each option as typed, "" where it is not given; of a list in a file, its numbers.
  std::array<std::string, option_count> texts;
  Job job;
  Comparison comparison;
  Notation notation;
  std::optional<Generated> generated;
  ColorWhen color = ColorWhen::by_terminal;
  std::optional<std::size_t> form = {};  ///< the field with the cubics of pieces
  bool places_from_input = false;        ///< the times or arc lengths are read from standard input
  std::optional<PlaceColumn> place_column = {};

  const std::string& text(Option option) const { return texts[index_of(option)]; }
  bool has(Option option) const { return !text(option).empty(); }
  /// Whether a text is printed, so that no other value is read.
  bool wants_text() const;
};

/// What the value of an option is, for completions.
enum class ValueKind {
  flag,
  name,   ///< one of `known`
  names,  ///< several of `known`, separated by commas
  file,
  folder,
  columns,      ///< columns of the input, separated by commas
  column_pair,  ///< two columns with a colon between
  roles,        ///< ROLE=COLUMN, separated by commas
  places,       ///< numbers, or @FILE
  attached,     ///< a text in the word of the option, or none
  other,
};

/// An option. To add one: its name in enum class Option, and its row at the same place of the table.
struct OptionRow {
  Option id;
  std::string_view names;  ///< short and long, with their dashes, separated by commas
  std::string_view value;  ///< what the help calls its value; empty for a flag
  std::string_view group;
  std::string_view text;           ///< what it does, without a point at the end
  std::string_view default_value;  ///< as it would be typed; empty: none, or described in the text
  ValueKind kind;
  bool changes_rows;  ///< it is part of the provenance of the output
  /// Reads the value. Throws: Error (usage), which the caller makes an error about this option.
  void (*store)(TypedOptions& typed, const std::string& value);
  std::vector<std::string_view> (*known)() =
      nullptr;  ///< the names that the value is made of, for ValueKind::name and names

  /// With its dashes.
  std::string_view long_name() const;
  std::vector<std::string_view> all_names() const;
  /// What it does, and its default.
  std::string description() const;
};

/// All options in the order of the help, which is that of enum class Option.
std::span<const OptionRow> option_table();

inline const OptionRow& row_of(Option option) { return option_table()[index_of(option)]; }

/// Reads the words of a command line. Throws: Error (usage) for unknown options, and for values that are wrong in
/// themselves.
TypedOptions read_options(const std::vector<std::string>& given);

/// What the command line requests: a text to print, or else a job.
struct Invocation {
  std::optional<std::string> text;
  Job job = {};
  Exit exit = Exit::done;  ///< after the text; where it is another one, the text is an error message
};

/// When messages are colored, by words that may be wrong otherwise.
ColorWhen color_of(int argc, const char* const* argv);

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Invocation parse(int argc, const char* const* argv);

/// The prose of the manual page, man/tcbsample.1.in, put into the program by the build.
extern const char* const manual_template;

/// The text shown without arguments, the help on one screen, and all of it, in 80 columns.
std::string usage_text();
std::string short_help_text();
std::string help_text();

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

std::string version_text();

/// Scripts that complete options and their values in a shell.
std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

/// The names of the columns of files, for completions. Throws: Error.
std::string columns_text(const std::vector<std::string>& files);

/// The manual page, a completion script, or the names of the columns of files.
std::string generated_text(Generated kind, const std::vector<std::string>& files = {});

/// A set of options.
class OptionSet {
 public:
  constexpr OptionSet() = default;
  constexpr OptionSet(std::initializer_list<Option> options) {
    for (const Option option : options) words_[index_of(option) / 64] |= bit(option);
  }
  constexpr bool has(Option option) const { return (words_[index_of(option) / 64] & bit(option)) != 0; }
  constexpr bool empty() const { return *this == OptionSet{}; }
  constexpr bool operator==(const OptionSet&) const = default;
  constexpr OptionSet operator|(const OptionSet& other) const {
    OptionSet both = *this;
    for (std::size_t i = 0; i < words_.size(); ++i) both.words_[i] |= other.words_[i];
    return both;
  }

 private:
  static constexpr std::uint64_t bit(Option option) { return std::uint64_t{1} << index_of(option) % 64; }

  std::array<std::uint64_t, (option_count + 63) / 64> words_{};
};

/// The options that place the samples.
inline constexpr OptionSet sampling_options{Option::step,        Option::rate,      Option::count,    Option::segments,
                                            Option::per_segment, Option::at,        Option::arc_step, Option::arc_count,
                                            Option::arc_at,      Option::tolerance, Option::emit,     Option::fit};

enum class Relation {
  exclude,  ///< at most one of `options`, or of `options` and `others`
  need,     ///< each of `options` needs one of `others`
  idle,     ///< each of `options` has no effect with any of `others`; without `others`, where `applies` holds
};

/// A conflict of options. To add one: a row of the table.
struct Conflict {
  OptionSet options;
  Relation relation;
  OptionSet others = {};
  std::string_view reason = {};                          ///< goes on after the last option in the message
  bool (*applies)(const TypedOptions& typed) = nullptr;  ///< a further condition on the values; none: always
};

std::span<const Conflict> conflict_table();

/// Throws: Error (usage) for the first conflict of the options given.
void require_no_conflict(const TypedOptions& typed);

/// The output's ending names its format, unless that is given, and is the same. A report is JSON by its ending.
/// `earlier`: the format is that of an earlier output. Throws: Error (usage).
void set_output_format(TypedOptions& typed, bool earlier);

/// All throw Error (usage) for other texts; the caller adds the option.

/// Above 0: a decimal or a ratio of two.
Rational positive_ratio(const std::string& text);
/// The step of a rate.
Rational step_of_rate(const std::string& text);
/// A decimal or a ratio of two within the doubles; for another text the error is `expected`.
Rational ratio_or(ErrorCode expected, std::string_view text);
Rational ratio(const std::string& text);
/// Numbers, and ranges FIRST:LAST:STEP, separated by commas.
std::vector<Rational> ratios(const std::string& text);
/// Stores the places of an option: numbers as above, or for @FILE and "-" those in a file or standard input. A column
/// of a file is only named. Throws: Error (usage).
void store_places(TypedOptions& typed, Option option, const std::string& text);
/// Reads the column of a file that an option names, if one does. Throws: Error.
void read_place_column(TypedOptions& typed);
/// The field with the cubics of pieces in a form.
std::size_t form_of_pieces(const std::string& text);
/// In digits, from 1 to 2^63 - 1.
std::uint64_t positive_count(const std::string& text);
/// A whole number from `least` to `most`, also as 1e9.
std::uint64_t count_between(const std::string& text, std::uint64_t least, std::uint64_t most);
/// In digits alone.
int digit_count(const std::string& text, int least);
CurveTolerance curve_tolerance(const std::string& text);
/// "D", "NAME=D" or an angle such as "0.5deg", or several separated by commas, above 0; the angle in radians.
std::pair<std::vector<Tolerance>, std::optional<double>> fit_limits(const std::string& text);
/// Degrees above 0 and below 180.
double corner_angle(const std::string& text);
/// "1e-9", "x=1e-6", or several separated by commas.
std::vector<Tolerance> tolerances(const std::string& text);
char delimiter(const std::string& text);
char decimal_mark(const std::string& text);
spline::Tcb<double> tcb_values(const std::string& text);
/// Columns by name or number, separated by commas.
std::vector<std::string> column_list(const std::string& text);
/// "OLD=NEW", or several separated by commas.
std::vector<Renaming> renamings(const std::string& text);
/// "CHANNEL=FACTOR", or several separated by commas.
std::vector<ChannelScale> channel_scales(const std::string& text);
/// FORM=COLUMN:... for each rotation, or none.
std::vector<GivenRotation> rotations(const std::string& text, bool& none);
/// "CHANNEL=UNIT", or several separated by commas.
std::vector<NamedAngle> angle_channels(const std::string& text);
/// quaternion, axis-angle, matrix or euler=ORDER.
spline::RotationNotation rotation_form(const std::string& text);
/// Indices into fields(), each once.
std::vector<std::size_t> field_list(const std::string& text);
/// A part of a file's name.
std::string name_part(const std::string& text);
/// Two columns with a colon between.
std::vector<std::string> axis_names(const std::string& text);
/// Width and height with an x between.
PictureSize picture_size(const std::string& text);
FormatId input_format(const std::string& text);
FormatId output_format(const std::string& text);
/// The format that an output's ending names, if it does. Throws: Error (usage) for the ending of other files.
std::optional<FormatId> format_by_ending(const std::string& path);

/// The names of a table's rows, of the formats that can be read or written, and of the fields.
template <const auto& table>
std::vector<std::string_view> names_in() {
  std::vector<std::string_view> names;
  std::ranges::transform(table, std::back_inserter(names), [](const auto& row) { return row.name; });
  return names;
}
std::vector<std::string_view> input_format_names();
std::vector<std::string_view> output_format_names();
std::vector<std::string_view> field_names();

/// The row of a table by its name. Throws: Error (usage) with the nearest known name.
template <class Table>
const auto& named_row(const Table& table, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.name == name; });
  if (found != std::ranges::end(table)) return *found;
  std::vector<std::string> known;
  known.reserve(std::ranges::size(table));
  for (const auto& row : table) known.emplace_back(row.name);
  throw Error(Exit::usage, ErrorCode::unknown_name, {std::string(name), known});
}

}  // namespace tcb
