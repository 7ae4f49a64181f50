// Values: from the text of an option's value to its type, or to an error.
#include "cli/values.hpp"

#include <cmath>

#include "formats/formats.hpp"
#include "numbers/dates.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "sample/table.hpp"
#include "tcb/spline/rules.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr std::string_view not_a_list_of_angles =
    "is not a list of angles; expected CHANNEL=degrees or CHANNEL=radians, separated by commas, such as "
    "heading=degrees";

constexpr std::string_view not_a_list_of_scales =
    "is not a list of factors; expected CHANNEL=FACTOR pairs separated by commas, with factors other than 0, such as "
    "x=0.01,y=1/3";

constexpr std::string_view not_a_list_of_renamings =
    "is not a list of renamings; expected NAME=NAME pairs separated by commas, such as pos_x=x,pos_y=y";

Error not_three_parameters(std::string_view text) {
  return usage_error("{} is not a tension, a continuity and a bias; expected three numbers T,C,B, such as 0,0.5,-0.25",
                     in_quotes(text));
}

Error bad_fit_limits(std::string_view text) {
  return usage_error(
      "{} is not a list of tolerances; expected a distance above 0 for all channels, NAME=D for one channel, an angle "
      "with deg or rad for rotations, or several of these separated by commas, such as 0.01 or 0.01,fov=0.5,0.5deg",
      in_quotes(text));
}

Error not_a_whole_number(std::string_view text, std::uint64_t least, std::uint64_t most) {
  return usage_error("{0} is not valid; expected a whole number from {1} to {2}, such as {1}", in_quotes(text), least,
                     most);
}

Error number_beyond_doubles(std::string_view text) {
  return usage_error("{} is too large; expected at most 1.7976931348623157e308 in size, the largest double",
                     in_quotes(text));
}

/// The radians of a positive angle with its unit, as in 0.5deg.
std::optional<double> angle_with_unit(std::string_view text) {
  constexpr double radian = 1, degree = 0.017453292519943295;
  for (const auto& [unit, size] : {std::pair{std::string_view("deg"), degree}, {"rad", radian}}) {
    if (!text.ends_with(unit)) continue;
    const auto value = parse_number(text.substr(0, text.size() - unit.size()));
    if (value && *value > 0) return *value * size;
  }
  return std::nullopt;
}

/// A distance, or COLUMN=DISTANCE.
std::optional<Tolerance> tolerance_of(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  const bool named = equals != std::string_view::npos;
  const auto most = parse_number(named ? text.substr(equals + 1) : text);
  if (!most || *most < 0 || (named && equals == 0)) return std::nullopt;
  return Tolerance{std::string(named ? text.substr(0, equals) : ""), *most};
}

/// "a=b,c=d". Throws: Error (usage) with the words unless all names and values are there.
std::vector<std::pair<std::string, std::string>> named_values(const std::string& text, std::string_view words) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const std::string_view item : split(text, ',')) {
    const std::size_t equals = item.rfind('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == item.size())
      throw usage_error("{} {}", in_quotes(text), words);
    all.emplace_back(item.substr(0, equals), item.substr(equals + 1));
  }
  return all;
}

Error not_a_rotation(std::string_view text) {
  return usage_error(
      "{} is not a rotation; expected quaternion=X:Y:Z:W, axis-angle=X:Y:Z:ANGLE, axis-angle=X:Y:Z:ANGLE,relative, "
      "axis-angle=X:Y:Z whose length is the angle, euler=A:B:C,order=XYZ, or matrix= with nine columns row by row, "
      "where columns are names or numbers, or the name of an array with all; or none",
      in_quotes(text));
}

/// The axes of Euler angles: capital letters for turns around the axes as already turned, small ones around fixed axes.
spline::RotationNotation euler_order(std::string_view letters, const std::string& text) {
  spline::RotationNotation notation{spline::RotationForm::euler};
  notation.intrinsic = letters.find_first_not_of("XYZ") == std::string_view::npos;
  const bool is_order = notation.intrinsic || letters.find_first_not_of("xyz") == std::string_view::npos;
  if (letters.size() != 3 || !is_order || letters[1] == letters[0] || letters[1] == letters[2]) {
    throw usage_error(
        "{} has no valid order of axes; expected three of the letters X, Y and Z, with no two equal letters side by "
        "side, such as ZYX for intrinsic rotations, or zyx for extrinsic rotations",
        in_quotes(text));
  }
  for (std::size_t i = 0; i < letters.size(); ++i) {
    notation.axes[i] = static_cast<std::uint8_t>(letters[i] - (notation.intrinsic ? 'X' : 'x'));
  }
  return notation;
}

/// The columns of a rotation after its form. Euler angles still lack their order.
GivenRotation rotation_request(std::string_view part, const std::string& text) {
  const std::size_t equals = std::min(part.find('='), part.size());
  const auto form = std::ranges::find(rotation_forms, part.substr(0, equals), &Named<spline::RotationForm>::name);
  if (equals == part.size() || form == rotation_forms.end()) {
    throw not_a_rotation(text);
  }
  GivenRotation request{{form->value}};
  for (const std::string_view column : split(part.substr(equals + 1), ':')) request.columns.emplace_back(column);
  const bool lacks_angle = form->value == spline::RotationForm::axis_angle && request.columns.size() == 3;
  if (lacks_angle) request.notation.form = spline::RotationForm::rotation_vector;
  const bool is_array = request.columns.size() == 1;
  if ((request.columns.size() != request.notation.numbers() && !is_array) ||
      std::ranges::count(request.columns, "") > 0) {
    throw not_a_rotation(text);
  }
  return request;
}

}  // namespace

Rational ratio_or(std::string_view words, std::string_view text) {
  auto value = parse_rational(text);
  if (!value) throw usage_error("{} {}", in_quotes(text), words);
  if (!within_doubles(*value)) throw number_beyond_doubles(text);
  return *value;
}

Rational positive_ratio(const std::string& text) {
  Rational value = ratio_or(expects_positive_ratio, text);
  if (value <= 0) throw usage_error("{} {}", in_quotes(text), expects_positive_ratio);
  return value;
}

Rational frame_rate(const std::string& text) {
  const auto known = broadcast_rate(text);
  return known ? *known : positive_ratio(text);
}

void require_known_date(std::string_view text) {
  const std::string date = parse_rational(text) ? "" : date_in_known_form(text);
  if (date.empty()) return;
  throw usage_error("{} is a date in a form that is not read; expected it as {}; write it so", in_quotes(text), date);
}

TimeValue time_value(std::string_view words, std::string_view text) {
  const std::optional<Rational> seconds = read_duration(text);
  if (!seconds) return {ratio_or(words, text)};
  if (!within_doubles(*seconds)) throw number_beyond_doubles(text);
  return {*seconds, true};
}

std::optional<Rational> seconds_in_words(const UnitOptions& units, std::string_view text) {
  const std::optional<TimeNotation> notation = find_notation(text);
  if (!notation) {
    require_known_date(text);
    return std::nullopt;
  }
  if (const std::string date = date_like_clock(text); !date.empty()) {
    throw usage_error(
        "{} is a date in a form that is not read, or a time of {} hours; expected the date as {}; write it so, or such "
        "hours in seconds",
        in_quotes(text), text.substr(0, 4), date);
  }
  if (counts_frames(*notation) && !units.frame_rate) {
    throw usage_error("{} is timecode, and no frame rate is given; expected one; give --input-fps", in_quotes(text));
  }
  const std::optional<DateFormat> format = find_date_format(text);
  const bool needs_order = format && format->needs_order();
  if (needs_order && !units.date_order) {
    throw usage_error(
        "the date {} does not tell which number is the day; expected the year first, in four digits; or give "
        "--date-order dmy, mdy or ymd",
        in_quotes(text));
  }
  const DateOrder order = needs_order ? *units.date_order : DateOrder::ymd;
  const std::string whole = fmt::format("{}{}", text, ends_with_minutes(units, text) ? ":00" : "");
  const auto seconds = read_time(whole, *notation, units.frame_rate.value_or(1), order);
  if (!seconds)
    throw usage_error("{} is not a time that exists; expected a day of the calendar and a time of day",
                      in_quotes(text));
  return seconds;
}

Rational step_of_rate(const Rational& rate, std::string_view text) {
  Rational step = 1 / rate;
  if (!within_doubles(step))
    throw usage_error("{} is too small a rate; expected one whose step, 1/HZ, is at most 1.7976931348623157e308",
                      in_quotes(text));
  return step;
}

std::uint64_t positive_count(const std::string& text) {
  const auto value = in_digits<std::uint64_t>(text);
  if (!value || *value == 0 || *value > INT64_MAX)
    throw usage_error("{} is not a count; expected a whole number from 1 to 2^63 - 1, in digits", in_quotes(text));
  return *value;
}

std::uint64_t count_between(const std::string& text, std::uint64_t least, std::uint64_t most) {
  const auto value = parse_rational(text);
  if (!value || *value < least || denominator(*value) != 1 || *value > most) {
    throw not_a_whole_number(text, least, most);
  }
  return whole_number(*value);
}

std::uint64_t memory_size(const std::string& text) {
  struct SizeUnit {
    std::string_view name;
    std::uint64_t bytes;
  };
  constexpr std::array<SizeUnit, 9> units{{{"", 1},
                                           {"B", 1},
                                           {"kB", 1'000},
                                           {"KiB", 1ULL << 10},
                                           {"MB", 1'000'000},
                                           {"MiB", 1ULL << 20},
                                           {"GB", 1'000'000'000},
                                           {"GiB", 1ULL << 30},
                                           {"TiB", 1ULL << 40}}};
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  const auto unit = std::ranges::find(units, std::string_view(text).substr(end), &SizeUnit::name);
  const auto number = parse_rational(text.substr(0, end));
  constexpr std::uint64_t least = 1ULL << 20, most = 1ULL << 50;
  const Rational bytes = number && unit != units.end() ? *number * Rational(unit->bytes) : Rational(0);
  if (bytes < least || bytes > most) {
    throw usage_error("{} is not a size of memory; expected 1MiB to 1024TiB, such as 512MiB or 4GiB", in_quotes(text));
  }
  return whole_number(Rational(numerator(bytes) / denominator(bytes)));
}

int digit_count(const std::string& text, int least) {
  const auto value = in_digits<int>(text);
  if (!value || *value < least || *value > most_digits) {
    throw not_a_whole_number(text, std::uint64_t(least), std::uint64_t(most_digits));
  }
  return *value;
}

CurveTolerance curve_tolerance(const std::string& text) {
  CurveTolerance tolerance;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> angle = angle_with_unit(part), value = angle ? angle : parse_number(part);
    double& limit = angle ? tolerance.angle : tolerance.distance;
    if (!value || *value <= 0 || std::isfinite(limit))
      throw usage_error(
          "{} is not a tolerance; expected a distance above 0, an angle with deg or rad for rotations, or both "
          "separated by a comma, such as 0.01 or 0.01,0.5deg",
          in_quotes(text));
    limit = *value;
  }
  return tolerance;
}

std::vector<Tolerance> tolerances(const std::string& text) {
  std::vector<Tolerance> list;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<Tolerance> tolerance = tolerance_of(part);
    if (!tolerance)
      throw usage_error(
          "{} is not a tolerance; expected a distance of at least 0 for all columns, or COLUMN=DISTANCE for one, such "
          "as 1e-9 or x=1e-6",
          in_quotes(part));
    list.push_back(*tolerance);
  }
  return list;
}

std::pair<std::vector<Tolerance>, std::optional<double>> fit_limits(const std::string& text) {
  std::vector<Tolerance> list;
  std::optional<double> angle;
  for (const std::string_view part : split(text, ',')) {
    if (const std::optional<double> limit = angle_with_unit(part)) {
      if (angle) throw bad_fit_limits(text);
      angle = limit;
      continue;
    }
    const std::optional<Tolerance> limit = tolerance_of(part);
    const bool repeats = limit && std::ranges::count(list, limit->column, &Tolerance::column) > 0;
    if (!limit || limit->most <= 0 || repeats) throw bad_fit_limits(text);
    list.push_back(*limit);
  }
  return {list, angle};
}

std::vector<Limit> limit_list(const std::string& text) {
  std::vector<Limit> limits;
  if (text == "all") return limits;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t mark = part.rfind('=');
    Limit limit{std::string(part.substr(0, mark)), {}, {}};
    if (mark != std::string_view::npos) {
      const std::string_view numbers = part.substr(mark + 1);
      const std::size_t colon = numbers.find(':');
      const bool is_range = colon != std::string_view::npos;
      limit.most = parse_rational(is_range ? numbers.substr(colon + 1) : numbers);
      if (is_range) limit.least = parse_rational(numbers.substr(0, colon));
      const bool are_numbers = limit.most && within_doubles(*limit.most) && limit.least.has_value() == is_range &&
                               within_doubles(limit.least.value_or(0));
      if (!are_numbers || *limit.most < limit.least.value_or(0)) limit.name.clear();
    }
    if (limit.name.empty()) {
      throw usage_error(
          "{} is not a limit; expected NAME, NAME=LIMIT or NAME=LEAST:MOST, as in speed=2 or position_z=0:3",
          in_quotes(part));
    }
    limits.push_back(std::move(limit));
  }
  return limits;
}

double corner_angle(const std::string& text) {
  const auto value = parse_number(text);
  if (!value || *value <= 0 || *value >= 180)
    throw usage_error("{} is not an angle of a corner; expected degrees above 0 and below 180, such as 30",
                      in_quotes(text));
  return *value;
}

char delimiter(const std::string& text) {
  for (const auto& [name, character] : delimiter_names) {
    if (text == name) return character;
  }
  const bool usable =
      text.size() == 1 && std::string_view("\"\n\r+-.0123456789eE").find(text[0]) == std::string_view::npos;
  if (!usable)
    throw usage_error(
        "{} is not a delimiter; expected one character that cannot be part of a number, or tab, comma, semicolon, "
        "space or pipe",
        in_quotes(text));
  return text[0];
}

char decimal_mark(const std::string& text) {
  if (text != "," && text != ".")
    throw usage_error("{} is not a decimal mark; expected a comma or a point", in_quotes(text));
  return text[0];
}

char thousands_mark(const std::string& text) {
  for (const auto& [name, character] : thousands_names) {
    if (text == name || text == std::string(1, character)) return character;
  }
  throw usage_error("{} is not a mark between thousands; expected comma, point, apostrophe, underscore or space",
                    in_quotes(text));
}

spline::Tcb<double> tcb_values(const std::string& text) {
  const auto parts = split(text, ',');
  std::array<double, 3> values{};
  if (parts.size() != values.size()) throw not_three_parameters(text);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = parse_number(parts[i]);
    if (!value) throw not_three_parameters(text);
    values[i] = *value;
  }
  return {values[0], values[1], values[2]};
}

std::vector<std::string> column_list(const std::string& text) {
  const auto names = split(text, ',');
  if (std::ranges::count(names, "") > 0)
    throw usage_error("{} has an empty item; expected column names or numbers between commas; remove a comma",
                      in_quotes(text));
  return {names.begin(), names.end()};
}

std::vector<Renaming> renamings(const std::string& text) {
  std::vector<Renaming> all;
  for (const auto& [from, to] : named_values(text, not_a_list_of_renamings)) all.push_back({from, to});
  return all;
}

std::vector<ChannelScale> channel_scales(const std::string& text) {
  std::vector<ChannelScale> all;
  for (const auto& [channel, factor] : named_values(text, not_a_list_of_scales)) {
    all.push_back({channel, ratio_or(not_a_list_of_scales, factor)});
    if (all.back().factor == 0) throw usage_error("{} {}", in_quotes(text), not_a_list_of_scales);
  }
  return all;
}

std::vector<NamedAngle> angle_channels(const std::string& text) {
  std::vector<NamedAngle> all;
  for (const auto& [channel, unit] : named_values(text, not_a_list_of_angles)) {
    const auto known = std::ranges::find(angle_units, unit, &Named<bool>::name);
    if (known == angle_units.end()) throw usage_error("{} {}", in_quotes(text), not_a_list_of_angles);
    all.push_back({channel, known->value});
  }
  return all;
}

std::vector<std::size_t> field_list(const std::string& text) {
  std::vector<std::size_t> chosen;
  for (const std::string_view name : split(text, ',')) {
    const auto field = static_cast<std::size_t>(&named_row(named_fields(), name) - fields().data());
    if (std::ranges::count(chosen, field) > 0)
      throw usage_error("field {} is repeated; expected each field once; remove one", name);
    chosen.push_back(field);
  }
  return chosen;
}

std::size_t form_of_pieces(const std::string& text) {
  const auto form = std::ranges::find(fields(), text, &Field::name);
  const bool is_form = form != fields().end() && form->of_piece && form->per_channel;
  if (!is_form) throw unknown_value(text, form_names());
  return static_cast<std::size_t>(form - fields().begin());
}

std::string name_part(const std::string& text) {
  if (text.find('/') != std::string::npos)
    throw usage_error("{} contains /; expected part of a file name; remove the /", in_quotes(text));
  return text;
}

std::vector<std::string> axis_names(const std::string& text) {
  const auto names = split(text, ':');
  if (names.size() != 2 || std::ranges::count(names, "") > 0)
    throw usage_error(
        "{} is not a pair of axes; expected two channels by name or number, with a colon between them, such as x:z",
        in_quotes(text));
  return {names.begin(), names.end()};
}

Extrapolations extrapolation(const std::string& text) {
  std::vector<Extrapolation> rules;
  for (const std::string_view rule : split(text, ',')) rules.push_back(named_row(extrapolations, rule).value);
  if (rules.size() > 2) throw too_many_rules(rules.size());
  return {rules.front(), rules.back()};
}

PictureSize picture_size(const std::string& text) {
  constexpr int least = 100, most = 10000;
  const auto parts = split(text, 'x');
  PictureSize size;
  if (parts.size() == 2) size = {in_digits<int>(parts[0]).value_or(0), in_digits<int>(parts[1]).value_or(0)};
  for (const int pixels : {size.width, size.height}) {
    if (pixels < least || pixels > most)
      throw usage_error(
          "{} is not a size; expected width and height in pixels, from 100 to 10000 each, such as 800x600",
          in_quotes(text));
  }
  return size;
}

const Format* format_with(bool (Format::*capability)() const, const std::string& text) {
  const auto names = formats_with(capability);
  if (std::ranges::count(names, text) == 0) throw unknown_value(text, names);
  return find_format(text);
}

std::vector<std::string_view> formats_with(bool (Format::*capability)() const) {
  std::vector<std::string_view> names;
  for (const Format& format : formats()) {
    if ((format.*capability)()) names.push_back(format.name);
  }
  return names;
}

spline::Preset preset_named(const std::string& text) {
  if (const std::string_view instead = in_place_of_preset(text); !instead.empty())
    throw usage_error("{} is not a known name; {}", in_quotes(text), instead);
  return named_row(spline::presets, text).id;
}

std::vector<std::string_view> field_names() { return names_of(named_fields()); }
std::vector<std::string_view> form_names() { return {"hermite", "bezier", "poly"}; }

Error unknown_value(std::string_view name, std::span<const std::string_view> known) {
  return usage_error("{} is not a known name; expected one of {}{}", in_quotes(name), listed(known),
                     did_you_mean(name, known));
}

std::vector<GivenRotation> rotations(const std::string& text, bool& none) {
  constexpr std::string_view order = "order=";
  std::vector<GivenRotation> result;
  const auto last_is = [&](spline::RotationForm form) {
    return !result.empty() && result.back().notation.form == form;
  };
  const auto lacks_order = [&] {
    return last_is(spline::RotationForm::euler) && result.back().notation.axes == std::array<std::uint8_t, 3>{};
  };
  for (const std::string_view part : split(text, ',')) {
    if (part.starts_with(order) && lacks_order()) {
      result.back().notation = euler_order(part.substr(order.size()), text);
    } else if (lacks_order()) {
      throw not_a_rotation(text);
    } else if (part == "relative" && last_is(spline::RotationForm::axis_angle)) {
      result.back().relative = true;
    } else if (part == "none") {
      none = true;
    } else {
      result.push_back(rotation_request(part, text));
    }
  }
  if (lacks_order() || (none && !result.empty())) throw not_a_rotation(text);
  return result;
}

spline::RotationNotation rotation_form(const std::string& text) {
  constexpr std::string_view euler = "euler=";
  if (text.starts_with(euler)) return euler_order(text.substr(euler.size()), text);
  const auto found = std::ranges::find(rotation_forms, text, &Named<spline::RotationForm>::name);
  if (found == rotation_forms.end() || found->value == spline::RotationForm::euler) {
    throw usage_error(
        "{} is not a form of rotations; expected quaternion, axis-angle, rotation-vector, matrix, or euler= and an "
        "order of axes, as in euler=ZYX",
        in_quotes(text));
  }
  return {found->value};
}

}  // namespace tcb
