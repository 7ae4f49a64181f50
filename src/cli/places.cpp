// Places: the times or arc lengths of --at and --arc-at, as listed, in a file of numbers, or in a column of a file.
#include "cli/places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "cli/errors.hpp"
#include "cli/values.hpp"
#include "io/input_file.hpp"
#include "keys/without_faults.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "read/reader.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Appends A, A + H, ... up to B for "A:B:H". The places of a range are kept, so there is a limit to their number.
void append_range(std::string_view text, std::vector<Rational>& values) {
  constexpr std::uint64_t most = 10'000'000;
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() != 3) throw not_a_range(text);
  const auto part = [&](std::size_t i) { return ratio_or(not_a_range, parts[i]); };
  const Rational first = part(0), last = part(1), step = part(2);
  if (step == 0 || (last - first) / step < 0) throw range_without_end(text);
  const Rational steps = floor((last - first) / step);
  if (steps >= most) throw range_of_too_many_numbers(text, most);
  for (std::uint64_t i = 0; i <= whole_number(steps); ++i) values.push_back(first + step * i);
}

/// The numbers in a text as a list separated by commas. A first line without any number is a header.
std::string numbers_in(std::istream& file, const std::string& path) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  std::string items, line;
  for (std::uint64_t number = 1; std::getline(file, line); ++number) {
    std::ranges::replace_if(line, is_blank, ',');
    const std::vector<std::string_view> cells = split(line, ',');
    if (number == 1 && std::ranges::none_of(cells, [](auto cell) { return parse_rational(cell).has_value(); }))
      continue;
    for (const std::string_view item : cells) {
      if (item.empty()) continue;
      at_position({shown_name(path), number, 0}, [&] { (void)ratio_or(not_a_list_of_numbers, item); });
      items += (items.empty() ? "" : ",") + std::string(item);
    }
  }
  if (items.empty()) throw list_without_numbers().in(shown_name(path));
  return items;
}

/// The numbers in a text; for @FILE those in that file, for "-" those of standard input, as one text separated by
/// commas.
std::string listed_numbers(const std::string& text) {
  if (text == "-") {
    std::string bytes;
    const Source<std::string> parts = read_file(text);
    while (const auto part = parts()) bytes += *part;
    std::istringstream input(bytes);
    return numbers_in(input, text);
  }
  if (!text.starts_with('@')) return text;
  std::ifstream file(text.substr(1));
  if (!file) throw list_unreadable().in(text.substr(1));
  return numbers_in(file, text.substr(1));
}

/// The parts of "@FILE:COLUMN". Both may contain colons: the file is the longest name of one. Nothing for a file alone.
std::optional<PlaceColumn> place_column(const std::string& text, std::string_view option) {
  if (!text.starts_with('@')) return std::nullopt;
  const std::string names = text.substr(1);
  if (std::filesystem::exists(names)) return std::nullopt;
  for (std::size_t colon = names.rfind(':'); colon != std::string::npos && colon > 0;
       colon = names.rfind(':', colon - 1)) {
    const std::string path = names.substr(0, colon);
    if (colon + 1 < names.size() && std::filesystem::exists(path))
      return PlaceColumn{option, path, names.substr(colon + 1)};
  }
  return std::nullopt;
}

/// The groups of keys as those of the file, where it has columns of these names.
std::vector<std::string> group_names(const InputOptions& keys) {
  const auto group = std::ranges::find(keys.columns.roles, Role::group, &RoleRequest::role);
  return group == keys.columns.roles.end() ? std::vector<std::string>{} : group->columns;
}

/// A number as the text of an option.
std::string text_of(const Rational& value) {
  const Rational divisor = denominator(value);
  return whole_text(numerator(value)) + (divisor == 1 ? "" : "/" + whole_text(divisor));
}

/// The places in a column of a file, in its order. Throws: Error.
GroupedPlaces read_places(const PlaceColumn& column, const InputOptions& of_keys) {
  InputOptions options;
  options.columns.samples = SampleNames{column.name, group_names(of_keys)};
  options.columns.samples->times_only = column.option;
  options.units = {.frame_rate = of_keys.units.frame_rate, .only_named_frames = true};
  const Input input = open_input(column.path, read_file(column.path), options);
  const Source<KeyBlock> keys = without_faults(input.keys.blocks, false);
  SamplingRequest request;
  request.frame_rate = input.schema.time.frame_rate;
  GroupedPlaces places;
  while (const std::optional<KeyBlock> block = keys()) {
    for (std::size_t key = 0; key < block->size(); ++key) {
      std::vector<std::string> group;
      for (std::size_t i = 0; i < input.schema.groups.size(); ++i) group.emplace_back(content(block->text(key, i)));
      places[group].push_back(request.exact(block->keys.times[key]));
    }
  }
  return places;
}

}  // namespace

std::vector<Rational> ratios(const std::string& text) {
  std::vector<Rational> values;
  for (const std::string_view item : split(text, ',')) {
    if (item.find(':') == std::string_view::npos) {
      values.push_back(ratio_or(not_a_list_of_numbers, item));
    } else {
      append_range(item, values);
    }
  }
  return values;
}

void store_places(TypedOptions& typed, std::string_view option, const std::string& text) {
  typed.place_column = place_column(text, option);
  typed.places_from_input = text == "-";
  if (typed.place_column) return;
  typed.set_text(option, listed_numbers(text));
  typed.places = ratios(typed.text(option));
}

void read_place_column(TypedOptions& typed) {
  if (!typed.place_column) return;
  const PlaceColumn& column = *typed.place_column;
  GroupedPlaces places = in_file(column.path, [&] { return read_places(column, typed.keys.input); });
  const auto alone = places.find({});
  if (alone == places.end()) {
    if (typed.has(option::meta)) throw groups_of_numbers_in_provenance().about(column.option);
    typed.grouped_places = std::move(places);
    return;
  }
  typed.places = std::move(alone->second);
  std::vector<std::string> texts;
  for (const Rational& place : typed.places) texts.push_back(text_of(place));
  typed.set_text(column.option, fmt::format("{}", fmt::join(texts, ",")));
}

}  // namespace tcb
