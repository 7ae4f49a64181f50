// Values: from the text of an option's value to its type, or to an error.
#include "cli/values.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "cli/errors.hpp"
#include "formats/formats.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "sample/fields.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

template <class Int>
std::optional<Int> in_digits(std::string_view text) {
  Int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> format_names(bool (Format::*capability)() const) {
  std::vector<std::string_view> names;
  for (const Format& format : formats()) {
    if ((format.*capability)()) names.push_back(format.name);
  }
  return names;
}

/// Throws: Error (usage) for a name that is not one of the formats that have the capability.
const Format* named_format(const std::string& text, bool (Format::*capability)() const) {
  const auto names = format_names(capability);
  if (std::ranges::count(names, text) == 0) {
    throw unknown_value(text, names);
  }
  return find_format(text);
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

}  // namespace

Rational ratio_or(Fault fault, std::string_view text) {
  auto value = parse_rational(text);
  if (!value) throw fault(text);
  if (!within_doubles(*value)) throw number_beyond_doubles(text);
  return *value;
}

Rational positive_ratio(const std::string& text) {
  Rational value = ratio_or(not_a_positive_ratio, text);
  if (value <= 0) throw not_a_positive_ratio(text);
  return value;
}

std::optional<Rational> broadcast_rate(std::string_view text) {
  const auto known = std::ranges::find(broadcast_rates, text, &BroadcastRate::decimal);
  return known == broadcast_rates.end() ? std::nullopt : std::optional(Rational(known->frames * 1000, 1001));
}

Rational frame_rate(const std::string& text) {
  const auto known = broadcast_rate(text);
  return known ? *known : positive_ratio(text);
}

TimeValue time_value(Fault fault, std::string_view text) {
  const std::optional<Rational> seconds = read_duration(text);
  if (!seconds) return {ratio_or(fault, text)};
  if (!within_doubles(*seconds)) throw number_beyond_doubles(text);
  return {*seconds, true};
}

Rational step_of_rate(const Rational& rate, std::string_view text) {
  Rational step = 1 / rate;
  if (!within_doubles(step)) throw step_of_rate_beyond_doubles(text);
  return step;
}

std::uint64_t positive_count(const std::string& text) {
  const auto value = in_digits<std::uint64_t>(text);
  if (!value || *value == 0 || *value > INT64_MAX) throw not_a_count(text);
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
    throw usage_error("{} is no size of memory; expected 1MiB to 1024TiB, such as 512MiB or 4GiB", in_quotes(text));
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
    if (!value || *value <= 0 || std::isfinite(limit)) throw not_a_curve_tolerance(text);
    limit = *value;
  }
  return tolerance;
}

std::vector<Tolerance> tolerances(const std::string& text) {
  std::vector<Tolerance> list;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<Tolerance> tolerance = tolerance_of(part);
    if (!tolerance) throw not_a_tolerance(part);
    list.push_back(*tolerance);
  }
  return list;
}

std::pair<std::vector<Tolerance>, std::optional<double>> fit_limits(const std::string& text) {
  std::vector<Tolerance> list;
  std::optional<double> angle;
  for (const std::string_view part : split(text, ',')) {
    if (const std::optional<double> limit = angle_with_unit(part)) {
      if (angle) throw not_limits_of_a_fit(text);
      angle = limit;
      continue;
    }
    const std::optional<Tolerance> limit = tolerance_of(part);
    const bool repeats = limit && std::ranges::count(list, limit->column, &Tolerance::column) > 0;
    if (!limit || limit->most <= 0 || repeats) throw not_limits_of_a_fit(text);
    list.push_back(*limit);
  }
  return {list, angle};
}

double corner_angle(const std::string& text) {
  const auto value = parse_number(text);
  if (!value || *value <= 0 || *value >= 180) throw not_an_angle_of_a_corner(text);
  return *value;
}

char delimiter(const std::string& text) {
  for (const auto& [name, character] : delimiter_names) {
    if (text == name) return character;
  }
  const bool usable =
      text.size() == 1 && std::string_view("\"\n\r+-.0123456789eE").find(text[0]) == std::string_view::npos;
  if (!usable) throw not_a_delimiter(text);
  return text[0];
}

char decimal_mark(const std::string& text) {
  if (text != "," && text != ".") throw not_a_decimal_mark(text);
  return text[0];
}

char thousands_mark(const std::string& text) {
  for (const auto& [name, character] : thousands_names) {
    if (text == name || text == std::string(1, character)) return character;
  }
  throw not_a_thousands_mark(text);
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
  if (std::ranges::count(names, "") > 0) throw not_a_list_of_columns(text);
  return {names.begin(), names.end()};
}

namespace {

/// "a=b,c=d". Throws: the fault unless all names and values are there.
std::vector<std::pair<std::string, std::string>> named_values(const std::string& text, Fault fault) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const std::string_view item : split(text, ',')) {
    const std::size_t equals = item.rfind('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == item.size()) throw fault(text);
    all.emplace_back(item.substr(0, equals), item.substr(equals + 1));
  }
  return all;
}

}  // namespace

std::vector<Renaming> renamings(const std::string& text) {
  std::vector<Renaming> all;
  for (const auto& [from, to] : named_values(text, not_a_list_of_renamings)) all.push_back({from, to});
  return all;
}

std::vector<ChannelScale> channel_scales(const std::string& text) {
  std::vector<ChannelScale> all;
  for (const auto& [channel, factor] : named_values(text, not_a_list_of_scales)) {
    all.push_back({channel, ratio_or(not_a_list_of_scales, factor)});
    if (all.back().factor == 0) throw not_a_list_of_scales(text);
  }
  return all;
}

std::vector<NamedAngle> angle_channels(const std::string& text) {
  std::vector<NamedAngle> all;
  for (const auto& [channel, unit] : named_values(text, not_a_list_of_angles)) {
    const auto known = std::ranges::find(angle_units, unit, &AngleUnit::name);
    if (known == angle_units.end()) throw not_a_list_of_angles(text);
    all.push_back({channel, known->degrees});
  }
  return all;
}

std::vector<std::size_t> field_list(const std::string& text) {
  std::vector<std::size_t> chosen;
  for (const std::string_view name : split(text, ',')) {
    const auto field = static_cast<std::size_t>(&named_row(named_fields(), name) - fields().data());
    if (std::ranges::count(chosen, field) > 0) throw field_repeated(name);
    chosen.push_back(field);
  }
  return chosen;
}

std::size_t form_of_pieces(const std::string& text) {
  const auto form = std::ranges::find(fields(), text == "poly4" ? "poly" : text, &Field::name);
  const bool is_form = form != fields().end() && form->of_piece && form->per_channel;
  if (!is_form && text.starts_with("poly") && in_digits<int>(text.substr(4))) throw other_number_of_coefficients(text);
  return is_form ? static_cast<std::size_t>(form - fields().begin()) : field_of(named_row(form_table, text).name);
}

std::string name_part(const std::string& text) {
  if (text.find('/') != std::string::npos) throw not_a_part_of_a_name(text);
  return text;
}

std::vector<std::string> axis_names(const std::string& text) {
  const auto names = split(text, ':');
  if (names.size() != 2 || std::ranges::count(names, "") > 0) throw not_two_axes(text);
  return {names.begin(), names.end()};
}

PictureSize picture_size(const std::string& text) {
  constexpr int least = 100, most = 10000;
  const auto parts = split(text, 'x');
  PictureSize size;
  if (parts.size() == 2) size = {in_digits<int>(parts[0]).value_or(0), in_digits<int>(parts[1]).value_or(0)};
  for (const int pixels : {size.width, size.height}) {
    if (pixels < least || pixels > most) throw not_a_size(text);
  }
  return size;
}

const Format* input_format(const std::string& text) { return named_format(text, &Format::can_read); }
const Format* output_format(const std::string& text) { return named_format(text, &Format::can_write); }
std::vector<std::string_view> input_format_names() { return format_names(&Format::can_read); }
std::vector<std::string_view> output_format_names() { return format_names(&Format::can_write); }

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(named_fields(), std::back_inserter(names), &Field::name);
  return names;
}

}  // namespace tcb
