// Values: from the text of an option's value to its type, or to an error, and the tables of names that values have.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options.hpp"
#include "schema/format.hpp"
#include "text/suggest.hpp"

namespace tcb {

inline constexpr auto generated_names = std::to_array<Named<Generated>>({{"man", Generated::manual},
                                                                         {"man-curves", Generated::curves},
                                                                         {"bash", Generated::bash},
                                                                         {"zsh", Generated::zsh},
                                                                         {"fish", Generated::fish},
                                                                         {"tables", Generated::tables}});
inline constexpr auto color_names = std::to_array<Named<ColorWhen>>(
    {{"auto", ColorWhen::by_terminal}, {"always", ColorWhen::always}, {"never", ColorWhen::never}});
inline constexpr auto delimiter_names =
    std::to_array<Named<char>>({{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"space", ' '}, {"pipe", '|'}});
/// The marks between thousands, which may also be given themselves.
inline constexpr auto thousands_names = std::to_array<Named<char>>(
    {{"comma", ','}, {"point", '.'}, {"apostrophe", '\''}, {"underscore", '_'}, {"space", ' '}});

/// What an error about a value says after it.
inline constexpr std::string_view expects_ratio =
    "is not a number; expected a decimal or a ratio of whole numbers, such as 1.5 or 7/24";
inline constexpr std::string_view expects_positive_ratio =
    "is not a number above 0; expected a decimal or a ratio of whole numbers, such as 0.1 or 1/24";

/// A time or a step of time: a number in the unit of the times, or a duration such as 30min, in seconds.
struct TimeValue {
  Rational value;
  bool in_seconds = false;
};

// Each function throws Error (usage) for any other text, with what it expects; the caller makes it an error about the
// option. The errors of those with `words` end with these.

Rational ratio_or(std::string_view words, std::string_view text);
/// Throws: Error (usage) for a date in a form that is not read; not for a ratio, such as 1024/12.
void require_known_date(std::string_view text);
TimeValue time_value(std::string_view words, std::string_view text);
Rational positive_ratio(const std::string& text);
/// The rate of NTSC video for which a decimal such as "29.97" stands, else a ratio above 0.
Rational frame_rate(const std::string& text);
Rational step_of_rate(const Rational& rate, std::string_view text);
/// The seconds of a date, a time of day or timecode; nothing for other texts. Throws: Error (usage) where another
/// option has to tell its meaning.
std::optional<Rational> seconds_in_words(const UnitOptions& units, std::string_view text);
std::uint64_t positive_count(const std::string& text);
/// A whole number, also as 1e9.
std::uint64_t count_between(const std::string& text, std::uint64_t least, std::uint64_t most);
std::uint64_t memory_size(const std::string& text);
int digit_count(const std::string& text, int least);
double corner_angle(const std::string& text);
char delimiter(const std::string& text);
char decimal_mark(const std::string& text);
char thousands_mark(const std::string& text);
std::string name_part(const std::string& text);
PictureSize picture_size(const std::string& text);
spline::Tcb<double> tcb_values(const std::string& text);
CurveTolerance curve_tolerance(const std::string& text);
std::vector<Tolerance> tolerances(const std::string& text);
/// The angle is in radians.
std::pair<std::vector<Tolerance>, std::optional<double>> fit_limits(const std::string& text);
/// None for "all".
std::vector<Limit> limit_list(const std::string& text);
std::vector<std::string> column_list(const std::string& text);
std::vector<std::string> axis_names(const std::string& text);
std::vector<Renaming> renamings(const std::string& text);
std::vector<ChannelScale> channel_scales(const std::string& text);
std::vector<NamedAngle> angle_channels(const std::string& text);
/// Sets `none` if the text is "none", for no rotation.
std::vector<GivenRotation> rotations(const std::string& text, bool& none);
spline::RotationNotation rotation_form(const std::string& text);
Extrapolations extrapolation(const std::string& text);
/// Indices into fields(), each once.
std::vector<std::size_t> field_list(const std::string& text);
/// The field with the cubics of pieces in a form.
std::size_t form_of_pieces(const std::string& text);
spline::Preset preset_named(const std::string& text);
const Format* format_with(bool (Format::*capability)() const, const std::string& text);

/// The names of the formats that can be read or written, of the fields, and of the forms of a cubic.
std::vector<std::string_view> formats_with(bool (Format::*capability)() const);
std::vector<std::string_view> field_names();
std::vector<std::string_view> form_names();

template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& row : table) names.push_back(row.name);
  return names;
}
template <const auto& table>
std::vector<std::string_view> names_in() {
  return names_of(table);
}

Error unknown_value(std::string_view name, std::span<const std::string_view> known);

/// The row of a table by its name. Throws: Error (usage) with the nearest known name.
template <class Table>
const auto& named_row(const Table& table, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.name == name; });
  if (found != std::ranges::end(table)) return *found;
  throw unknown_value(name, names_of(table));
}

/// Stores the places of an option: numbers, dates, and ranges FIRST:LAST:STEP, separated by commas, or for @FILE and
/// "-" numbers in that file or standard input. A column of a file is only named. Throws: Error (usage); the caller adds
/// the name of the option.
void store_places(TypedOptions& typed, std::string_view option, const std::string& text);

/// Stores constant, ease, ease=A,B or the file of a profile, which is only named. Throws: Error (usage) for others.
void store_pace(TypedOptions& typed, const std::string& text);

/// Reads the column of a file that an option names, if one does. Throws: Error.
void read_place_column(TypedOptions& typed);

}  // namespace tcb
