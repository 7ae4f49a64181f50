// Places: the times or arc lengths of --at and --arc-at, as listed, in a file of numbers, or in a column of a
// recording.
#include "cli/values.hpp"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <system_error>

#include "formats/formats.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "numbers/print_number.hpp"
#include "read/csv/splitter.hpp"
#include "read/csv/tokenizer.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "schema/key_rules.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr std::string_view not_a_range = "is not a range; expected FIRST:LAST:STEP, such as 0:10:0.5";

constexpr std::string_view not_a_list_of_numbers =
    "is not a number; expected decimals or ratios of whole numbers, separated by commas, such as 0,0.5,7/24";

/// Whether a text such as 0:10:0.5 is a range. One that may be a time of day as well is that if a zero precedes another
/// digit in a part of it, as in 10:05:30.
bool is_range(std::string_view text) {
  if (text.find_first_not_of("0123456789.:") != std::string_view::npos) return false;
  const std::vector<std::string_view> parts = split(text, ':');
  return parts.size() == 3 && std::ranges::none_of(parts, [](std::string_view part) {
           return part.size() > 1 && part[0] == '0' && is_digit(part[1]);
         });
}

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
  bool are_words = false;   ///< dates, times of day or timecode
  std::string range = {};   ///< one that might be a time of day
};

/// The numbers of a list, all with units of time or none, or times in words.
class PlaceNumbers {
 public:
  explicit PlaceNumbers(const UnitOptions& units) : units_(units) {}

  /// Appends a number, or A, A + H, ... up to B for "A:B:H". Throws: Error (usage).
  void add(std::string_view item) {
    require_room_for(places_.list.size() + 1);
    const auto notation = find_notation(item);
    if (notation && !is_range(item)) {
      places_.list.push_back(*seconds_in_words(units_, item));
      ++words_;
    } else if (item.find(':') == std::string_view::npos) {
      require_known_date(item);
      places_.list.push_back(number(not_a_list_of_numbers, item));
    } else {
      if (notation && item.find('.') == std::string_view::npos) places_.range = item;
      add_range(item);
    }
  }

  NumberedPlaces take() {
    if (words_ > 0 && words_ != places_.list.size()) {
      throw usage_error("there are both dates and numbers; expected one of the two");
    }
    places_.are_words = words_ > 0;
    places_.in_seconds = places_.in_seconds || places_.are_words;
    return std::move(places_);
  }

 private:
  void add_range(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    const auto is_number = [](std::string_view part) { return parse_rational(part) || read_duration(part); };
    if (parts.size() != 3 || !std::ranges::all_of(parts, is_number)) require_known_date(text);
    if (parts.size() != 3) throw usage_error("{} {}", in_quotes(text), not_a_range);
    const auto part = [&](std::size_t i) { return number(not_a_range, parts[i]); };
    const Rational first = part(0), last = part(1), step = part(2);
    if (step == 0 || (last - first) / step < 0) {
      require_known_date(text);
      throw usage_error("{} never reaches its end; expected a step that leads from the first number to the last",
                        in_quotes(text));
    }
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
  std::size_t words_ = 0;
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

/// The text of a file or of standard input. Throws: Error (usage) for one that is too large to be kept.
std::string content_of(const std::string& path, std::uint64_t max_memory) {
  return in_file(shown_name(path), [&] {
    const Source<std::string> bytes = decompressed(read_file(path));
    std::string text;
    while (append_next(text, bytes)) {
      if (text.size() > max_memory)
        throw usage_error(
            "the text has more than {} bytes, as --max-memory allows; expected fewer; give fewer places, or more "
            "memory",
            with_thousands(max_memory));
    }
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    return text;
  });
}

Source<std::string> source_of(const std::string& text) { return each_of(std::deque<std::string>{text}); }

/// Whether a text is a recording: JSON, the text of a format with a beginning of its own, or rows of one length, above
/// one. Otherwise it is a list of numbers.
bool is_recording(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  const auto begins = [&](const Format& format) {
    return format.can_read() && format.input->begins != nullptr && format.input->begins(text);
  };
  if (text[first] == '[' || text[first] == '{' || std::ranges::any_of(formats(), begins)) return true;
  const DelimitedOptions usual;
  const Source<std::string> bytes = source_of(text);
  Beginning beginning = find_delimiter(bytes, {}, usual);
  const Dialect dialect{beginning.delimiter, usual.comment};
  const Source<Chunk> chunks = split_delimited(preceded_by(std::move(beginning.text), bytes), dialect);
  std::size_t rows = 0, length = 0;
  std::vector<std::string_view> cells;
  while (const std::optional<Chunk> chunk = chunks()) {
    for (Tokenizer records(*chunk, dialect); records.next(cells); ++rows) {
      if (rows > 0 && cells.size() != length) return false;
      length = cells.size();
    }
  }
  return rows > 1 && length > 1;
}

/// The numbers in a text as a list separated by commas. A first line without a digit is a header.
std::string numbers_in(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; }, ',');
  std::string items;
  std::uint64_t count = 0, line = 0;
  for (const std::string_view row : split(text, '\n')) {
    const TextPosition position{"", ++line, 0};
    const std::vector<std::string_view> cells = split(row, ',');
    if (line == 1 && is_header(cells)) continue;
    for (const std::string_view cell : cells) {
      if (cell.empty()) continue;
      if (!find_notation(cell)) at_position(position, [&] { (void)ratio_or(not_a_list_of_numbers, cell); });
      items += (items.empty() ? "" : ",") + std::string(cell);
      require_room_for(++count);
    }
  }
  if (items.empty()) throw usage_error("the file has no numbers; expected at least one");
  return items;
}

/// Whether there is a file; false also for a name that the system does not take.
bool exists(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

/// The file of "@FILE", or "-" for standard input; nothing for a list. Throws: Error (usage) where there is none.
std::optional<std::string> place_file(const std::string& text) {
  if (text == "-") return text;
  if (!text.starts_with('@')) return std::nullopt;
  const std::string path = text.substr(1);
  if (!exists(path))
    throw usage_error("the file cannot be read; expected a file of numbers, or @FILE:COLUMN for a column of a file")
        .in(path);
  return path;
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

/// Opens the recording of a column. The column of times is found as that of keys, if it has no name. Throws: Error.
Input open_recording(const PlaceColumn& column, const InputOptions& of_keys) {
  InputOptions options;
  options.units = {
      .frame_rate = of_keys.units.frame_rate, .date_order = of_keys.units.date_order, .are_optional = true};
  if (column.name.empty()) {
    options.columns.times_only = true;
    const std::vector<std::string> groups = group_names(of_keys);
    if (!groups.empty()) options.columns.roles = {{Role::group, groups}};
  } else {
    options.columns.samples = SampleNames{column.name, group_names(of_keys)};
    options.columns.samples->times_only = column.option;
  }
  if (column.content == nullptr) return open_input(column.path, read_file(column.path), options);
  try {
    return open_input(column.path, source_of(*column.content), options);
  } catch (const Error& error) {
    const std::string_view fault = error.message();
    throw Error(error.exit(), fmt::format("{}; name the column, as in {} @{}:COLUMN", fault.substr(0, fault.find(';')),
                                          column.option, column.path == "-" ? "FILE" : column.path))
        .at(error.position());
  }
}

/// The places in a column of a file, in its order, and whether they are in seconds. Throws: Error.
std::pair<GroupedPlaces, bool> read_places(const PlaceColumn& column, const InputOptions& of_keys) {
  const Input input = open_recording(column, of_keys);
  const Source<KeyBlock> keys = without_faults(input.keys.blocks);
  const TimeSchema& time = input.schema.time;
  const bool in_seconds = column.name.empty() && column.option == "--at" && time.unit && *time.unit != TimeUnit::frames;
  const Rational units = in_seconds ? units_per_second(*time.unit) : Rational(1);
  SamplingRequest request;
  if (time.frame_rate) request.frames.emplace(*time.frame_rate);
  GroupedPlaces places;
  std::uint64_t count = 0;
  while (const std::optional<KeyBlock> block = keys()) {
    require_room_for(count += block->size());
    for (std::size_t key = 0; key < block->size(); ++key) {
      std::vector<std::string> group;
      for (std::size_t i = 0; i < input.schema.groups.size(); ++i) group.emplace_back(content(block->text(key, i)));
      places[group].push_back(request.exact(block->keys.times[key]) / units);
    }
  }
  return {std::move(places), in_seconds};
}

}  // namespace

void store_places(TypedOptions& typed, std::string_view option, const std::string& text) {
  typed.places.column = place_column(text, option);
  typed.places.from_input = text == "-";
  if (typed.places.column) typed.files.other_inputs.push_back(typed.places.column->path);
  if (typed.places.column) return;
  std::string listed = text;
  if (const auto path = place_file(text)) {
    typed.files.other_inputs.push_back(*path);
    std::string content = content_of(*path, typed.keys.input.max_memory);
    if (in_file(shown_name(*path), [&] { return is_recording(content); })) {
      typed.places.column = PlaceColumn{option, *path, option == "--arc-at" ? "s" : "",
                                        std::make_shared<const std::string>(std::move(content))};
      return;
    }
    listed = in_file(shown_name(*path), [&] { return numbers_in(std::move(content)); });
  }
  PlaceNumbers numbers(typed.keys.input.units);
  for (const std::string_view item : split(listed, ',')) numbers.add(item);
  NumberedPlaces places = numbers.take();
  if (places.are_words && option != "--at") throw usage_error("there are dates; expected numbers");
  if (places.in_seconds && option == "--arc-at")
    throw usage_error(
        "a unit of time is given, but samples are placed by arc length; expected a length without a unit");
  typed.places.list = std::move(places.list);
  typed.places.in_seconds = places.in_seconds;
  typed.sampling.range_like_clock = std::move(places.range);
}

void store_pace(TypedOptions& typed, const std::string& text) {
  typed.sampling.pace.emplace();
  if (text.starts_with('@') && text.size() > 1) {
    const auto column = place_column(text, "--pace");
    typed.pace_profile = column ? PaceFile{column->path, column->name} : PaceFile{text.substr(1)};
    typed.files.other_inputs.push_back(typed.pace_profile->path);
    return;
  }
  if (text == "constant") return;
  const std::vector<std::string_view> ramps =
      split(std::string_view(text).substr(std::min<std::size_t>(text.size(), 5)), ',');
  const bool has_ramps = text.starts_with("ease=") && ramps.size() == 2;
  if (text != "ease" && !has_ramps) {
    throw usage_error("{} is no pace; expected constant, ease, ease=A,B, @FILE or @FILE:COLUMN", in_quotes(text));
  }
  constexpr std::string_view not_a_part =
      "is not a part of the duration; expected two numbers from 0 whose sum is 1 at most, such as ease=0.25,0.25";
  const auto ramp = [&](std::size_t i) { return has_ramps ? ratio_or(not_a_part, ramps[i]) : Rational(1, 4); };
  Pace& pace = *typed.sampling.pace;
  pace.rise = ramp(0);
  pace.fall = ramp(1);
  if (pace.rise < 0 || pace.fall < 0 || pace.rise + pace.fall > 1)
    throw usage_error("{} {}", in_quotes(text), not_a_part);
}

void read_place_column(TypedOptions& typed) {
  if (!typed.places.column) return;
  const PlaceColumn& column = *typed.places.column;
  auto [places, in_seconds] = in_file(shown_name(column.path), [&] { return read_places(column, typed.keys.input); });
  typed.places.in_seconds = in_seconds;
  const auto alone = places.find({});
  if (alone == places.end()) {
    typed.places.grouped = std::move(places);
  } else {
    typed.places.list = std::move(alone->second);
  }
}

}  // namespace tcb
