// Places: the times or arc lengths of --at and --arc-at, as listed, in a file of numbers, or in a column of a file.
#include "cli/values.hpp"

#include <filesystem>
#include <system_error>

#include "formats/formats.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "read/csv/splitter.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "schema/key_rules.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr std::string_view not_a_range = "is not a range; expected FIRST:LAST:STEP, such as 0:10:0.5";

constexpr std::string_view not_a_list_of_numbers =
    "is not a number; expected decimals or ratios of whole numbers, separated by commas, such as 0,0.5,7/24";

/// Throws: Error (usage) for more numbers of an option than are kept.
void require_room_for(const Rational& numbers) {
  constexpr std::uint64_t most_places = 10'000'000;
  if (numbers > most_places)
    throw usage_error(
        "there are more than {} numbers; expected fewer; give --from, --to and --step instead, or divide the list",
        most_places);
}

struct NumberedPlaces {
  std::vector<Rational> list;
  bool in_seconds = false;  ///< they have units of time, as in 30min
  bool are_dates = false;
};

/// The numbers of a list, all with units of time or none.
class PlaceNumbers {
 public:
  explicit PlaceNumbers(const UnitOptions& units) : units_(units) {}

  /// Appends a number, or A, A + H, ... up to B for "A:B:H". Throws: Error (usage).
  void add(std::string_view item) {
    require_room_for(places_.list.size() + 1);
    const auto notation = find_notation(item);
    if (notation && is_date(*notation)) {
      places_.list.push_back(*seconds_in_words(units_, item));
      ++dates_;
    } else if (item.find(':') == std::string_view::npos) {
      places_.list.push_back(number(not_a_list_of_numbers, item));
    } else {
      add_range(item);
    }
  }

  NumberedPlaces take() {
    if (dates_ > 0 && dates_ != places_.list.size()) {
      throw usage_error("there are both dates and numbers; expected one of the two");
    }
    places_.are_dates = dates_ > 0;
    places_.in_seconds = places_.in_seconds || places_.are_dates;
    return std::move(places_);
  }

 private:
  void add_range(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    if (parts.size() != 3) throw usage_error("{} {}", in_quotes(text), not_a_range);
    const auto part = [&](std::size_t i) { return number(not_a_range, parts[i]); };
    const Rational first = part(0), last = part(1), step = part(2);
    if (step == 0 || (last - first) / step < 0)
      throw usage_error("{} never reaches its end; expected a step that leads from the first number to the last",
                        in_quotes(text));
    const Rational steps = floor((last - first) / step);
    require_room_for(places_.list.size() + steps + 1);
    for (std::uint64_t i = 0; i <= whole_number(steps); ++i) places_.list.push_back(first + step * i);
  }

  Rational number(std::string_view words, std::string_view text) {
    TimeValue value = time_value(words, text);
    if (std::exchange(any_, true) && value.in_seconds != places_.in_seconds)
      throw usage_error(
          "{} and the numbers before it do not both have a unit of time; expected a unit for each number, or for none",
          in_quotes(text));
    places_.in_seconds = value.in_seconds;
    return std::move(value.value);
  }

  const UnitOptions& units_;
  NumberedPlaces places_;
  std::size_t dates_ = 0;
  bool any_ = false;
};

/// Whether no cell has a digit, or is a sign of a missing number or an infinite one, so that the cells are names of
/// columns and not misspelt numbers.
bool is_header(const std::vector<std::string_view>& cells) {
  return std::ranges::all_of(cells, [](std::string_view cell) {
    const bool has_digit = cell.find_first_of("0123456789") != std::string_view::npos;
    return cell.empty() || !(has_digit || looks_numeric(cell) || is_missing_sign(cell, {}));
  });
}

/// The numbers in a file as a list separated by commas. A first line without a digit is a header.
std::string numbers_in(const std::string& path) {
  return in_file(shown_name(path), [&] {
    const Source<Chunk> chunks = split_delimited(decompressed(read_file(path)), {',', ""});
    std::string items;
    std::uint64_t count = 0;
    while (std::optional<Chunk> chunk = chunks()) {
      std::uint64_t line = chunk->line;
      if (line == 1 && chunk->text.starts_with(byte_order_mark)) chunk->text.erase(0, byte_order_mark.size());
      std::ranges::replace_if(
          chunk->text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; }, ',');
      for (const std::string_view text : split(chunk->text, '\n')) {
        const TextPosition position{"", line++, 0};
        const std::vector<std::string_view> cells = split(text, ',');
        if (position.line == 1 && is_header(cells)) continue;
        for (const std::string_view cell : cells) {
          if (cell.empty()) continue;
          at_position(position, [&] { (void)ratio_or(not_a_list_of_numbers, cell); });
          items += (items.empty() ? "" : ",") + std::string(cell);
          require_room_for(++count);
        }
      }
    }
    if (items.empty()) throw usage_error("the file has no numbers; expected at least one");
    return items;
  });
}

/// Whether there is a file; false also for a name that the system does not take.
bool exists(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

/// The numbers in a text; for @FILE those in that file, for "-" those of standard input, as one text separated by
/// commas.
std::string listed_numbers(const std::string& text) {
  if (text == "-") return numbers_in(text);
  if (!text.starts_with('@')) return text;
  const std::string path = text.substr(1);
  if (!exists(path))
    throw usage_error("the file cannot be read; expected a file of numbers, or @FILE:COLUMN for a column of a file")
        .in(path);
  return numbers_in(path);
}

/// The parts of "@FILE:COLUMN". Both may contain colons: the file is the longest name of one. Nothing for a file alone.
std::optional<PlaceColumn> place_column(const std::string& text, std::string_view option) {
  if (!text.starts_with('@')) return std::nullopt;
  const std::string names = text.substr(1);
  if (exists(names)) return std::nullopt;
  for (std::size_t colon = names.rfind(':'); colon != std::string::npos && colon > 0;
       colon = names.rfind(':', colon - 1)) {
    const std::string path = names.substr(0, colon);
    if (colon + 1 < names.size() && exists(path)) return PlaceColumn{option, path, names.substr(colon + 1)};
  }
  return std::nullopt;
}

/// The groups of keys as those of the file, where it has columns of these names.
std::vector<std::string> group_names(const InputOptions& keys) {
  const auto group = std::ranges::find(keys.columns.roles, Role::group, &RoleRequest::role);
  return group == keys.columns.roles.end() ? std::vector<std::string>{} : group->columns;
}

/// The places in a column of a file, in its order. Throws: Error.
GroupedPlaces read_places(const PlaceColumn& column, const InputOptions& of_keys) {
  InputOptions options;
  options.columns.samples = SampleNames{column.name, group_names(of_keys)};
  options.columns.samples->times_only = column.option;
  options.units = {
      .frame_rate = of_keys.units.frame_rate, .date_order = of_keys.units.date_order, .are_optional = true};
  const Input input = open_input(column.path, read_file(column.path), options);
  const Source<KeyBlock> keys = without_faults(input.keys.blocks, false);
  SamplingRequest request;
  if (const auto& rate = input.schema.time.frame_rate) request.frames.emplace(*rate);
  GroupedPlaces places;
  std::uint64_t count = 0;
  while (const std::optional<KeyBlock> block = keys()) {
    require_room_for(count += block->size());
    for (std::size_t key = 0; key < block->size(); ++key) {
      std::vector<std::string> group;
      for (std::size_t i = 0; i < input.schema.groups.size(); ++i) group.emplace_back(content(block->text(key, i)));
      places[group].push_back(request.exact(block->keys.times[key]));
    }
  }
  return places;
}

}  // namespace

void store_places(TypedOptions& typed, std::string_view option, const std::string& text) {
  typed.places.column = place_column(text, option);
  typed.places.from_input = text == "-";
  if (typed.places.column) typed.files.other_inputs.push_back(typed.places.column->path);
  if (typed.places.column) return;
  if (typed.places.from_input) typed.files.other_inputs.push_back(text);
  if (text.starts_with('@')) typed.files.other_inputs.push_back(text.substr(1));
  const std::string listed = listed_numbers(text);
  PlaceNumbers numbers(typed.keys.input.units);
  for (const std::string_view item : split(listed, ',')) numbers.add(item);
  NumberedPlaces places = numbers.take();
  if (places.are_dates && option != "--at") throw usage_error("there are dates; expected numbers");
  if (places.in_seconds && option == "--arc-at")
    throw usage_error(
        "a unit of time is given, but samples are placed by arc length; expected a length without a unit");
  typed.places.list = std::move(places.list);
  typed.places.in_seconds = places.in_seconds;
}

void read_place_column(TypedOptions& typed) {
  if (!typed.places.column) return;
  const PlaceColumn& column = *typed.places.column;
  GroupedPlaces places = in_file(column.path, [&] { return read_places(column, typed.keys.input); });
  const auto alone = places.find({});
  if (alone == places.end()) {
    typed.places.grouped = std::move(places);
  } else {
    typed.places.list = std::move(alone->second);
  }
}

}  // namespace tcb
