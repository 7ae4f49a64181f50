// Where the samples are: the options that say it, and which of them have a meaning together.
#include "cli/sampling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string>

#include "error.hpp"
#include "text/number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// A decimal or a ratio that is a time, a length or a rate. Throws: Error (usage) saying what was expected.
Rational rational(std::string_view option, std::string_view text, std::string_view expected) {
  auto value = parse_rational(text);
  if (!value) refuse_value(option, text, expected);
  if (!within_doubles(*value)) refuse_value(option, text, double_range);
  return *value;
}

Rational positive_rational(std::string_view option, const std::string& text) {
  constexpr std::string_view expected = "a decimal or a ratio above 0, such as 0.1 or 1/24";
  auto value = rational(option, text, expected);
  if (value <= 0) refuse_value(option, text, expected);
  return value;
}

std::uint64_t positive_count(std::string_view option, const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0 || value > INT64_MAX) {
    refuse_value(option, text, "a whole number from 1 to 2^63 - 1, in digits");
  }
  return value;
}

Rational listed_number(std::string_view option, std::string_view text) {
  return rational(option, text, "decimals or ratios, apart by commas, such as 0,0.5,7/24");
}

std::vector<Rational> list(std::string_view option, const std::string& text) {
  std::vector<Rational> values;
  for (const std::string_view item : split(text, ',')) {
    values.push_back(listed_number(option, item));
  }
  return values;
}

using Set = void (*)(SamplingRequest&, std::string_view name, const std::string& value);

void set_step(SamplingRequest& request, std::string_view name, const std::string& value) {
  request.step = positive_rational(name, value);
}
void set_rate(SamplingRequest& request, std::string_view name, const std::string& value) {
  request.step = 1 / positive_rational(name, value);
  if (!within_doubles(request.step)) refuse_value(name, value, "a rate whose step is a double, less than 1.8e308");
}
void set_count(SamplingRequest& request, std::string_view name, const std::string& value) {
  request.count = positive_count(name, value);
}
void set_places(SamplingRequest& request, std::string_view name, const std::string& value) {
  request.places = list(name, value);
}
void set_tolerance(SamplingRequest& request, std::string_view name, const std::string& value) {
  const auto tolerance = parse_number(value);
  if (!tolerance || *tolerance <= 0) refuse_value(name, value, "a distance above 0, such as 0.01");
  request.tolerance = *tolerance;
}

/// A way to ask for samples: its option, what its value becomes, and which other options have a meaning with it.
struct Way {
  std::string_view name;
  std::string TypedOptions::*value;
  Mode mode;
  Set set;
  bool range, end, keys;  ///< --from and --to; --end; --keys
};

constexpr std::array ways{
    Way{"--step", &TypedOptions::step, Mode::step, set_step, true, true, true},
    Way{"--rate", &TypedOptions::rate, Mode::step, set_rate, true, true, true},
    Way{"--count", &TypedOptions::count, Mode::count, set_count, true, false, true},
    Way{"--segments", &TypedOptions::segments, Mode::segments, set_count, true, false, true},
    Way{"--per-segment", &TypedOptions::per_segment, Mode::per_segment, set_count, false, false, false},
    Way{"--at", &TypedOptions::at, Mode::at, set_places, false, false, false},
    Way{"--arc-step", &TypedOptions::arc_step, Mode::arc_step, set_step, true, true, true},
    Way{"--arc-count", &TypedOptions::arc_count, Mode::arc_count, set_count, true, false, true},
    Way{"--arc-at", &TypedOptions::arc_at, Mode::arc_at, set_places, false, false, false},
    Way{"--tolerance", &TypedOptions::tolerance, Mode::tolerance, set_tolerance, false, false, true},
};

const Way& chosen_way(const TypedOptions& typed) {
  std::vector<const Way*> given;
  std::vector<std::string_view> names;
  for (const Way& way : ways) {
    names.push_back(way.name);
    if (!(typed.*way.value).empty()) given.push_back(&way);
  }
  if (given.empty()) {
    throw Error(Exit::usage, fmt::format("nothing says where the samples are; expected one of {}; for example "
                                         "tcbsample --step 0.1 keys.csv",
                                         fmt::join(names, ", ")));
  }
  if (given.size() > 1) {
    throw Error(Exit::usage, fmt::format("{} and {} both say where the samples are; expected one of them; take one out",
                                         given[0]->name, given[1]->name));
  }
  return *given[0];
}

void require_effect(bool given, bool has_effect, std::string_view option, std::string_view way) {
  if (!given || has_effect) return;
  throw Error(Exit::usage, fmt::format("{} has no effect with {}; take it out", option, way));
}

std::optional<Rational> bound(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return rational(option, text, "a decimal or a ratio, such as 1.5 or 7/24");
}

void require_extrapolation(const TypedOptions& typed, const Way& way) {
  if (!typed.curve.extrapolate || *typed.curve.extrapolate == "error") return;
  const bool leaves = way.mode == Mode::at || (!by_length(way.mode) && !(typed.from.empty() && typed.to.empty()));
  require_effect(true, leaves, "--extrapolate",
                 leaves ? way.name : fmt::format("{} alone, whose samples lie on the curve", way.name));
}

/// A list of numbers as it is typed, or where it is @FILE, the numbers in that file, apart by commas.
std::string listed(std::string_view option, const std::string& text) {
  if (!text.starts_with('@')) return text;
  const std::string path = text.substr(1);
  std::ifstream file(path);
  if (!file)
    throw Error(Exit::usage, TextPosition{path},
                fmt::format("cannot be read for {}; expected a file of numbers", option));
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  std::string items, line;
  for (std::uint64_t number = 1; std::getline(file, line); ++number) {
    std::ranges::replace_if(line, is_blank, ',');
    for (const std::string_view item : split(line, ',')) {
      if (item.empty()) continue;
      at_position({path, number, 0}, [&] { (void)listed_number(option, item); });
      items += (items.empty() ? "" : ",") + std::string(item);
    }
  }
  if (items.empty()) refuse_value(option, text, "one number at least");
  return items;
}

}  // namespace

void take_lists(TypedOptions& typed) {
  typed.at = listed("--at", typed.at);
  typed.arc_at = listed("--arc-at", typed.arc_at);
}

SamplingRequest make_sampling(const TypedOptions& typed) {
  const Way& way = chosen_way(typed);
  SamplingRequest request;
  request.mode = way.mode;
  way.set(request, way.name, typed.*way.value);
  require_effect(!typed.from.empty(), way.range, "--from", way.name);
  require_effect(!typed.to.empty(), way.range, "--to", way.name);
  require_effect(!typed.end.empty(), way.end, "--end", way.name);
  require_effect(typed.keys, way.keys, "--keys", way.name);
  require_extrapolation(typed, way);
  request.from = bound("--from", typed.from);
  request.to = bound("--to", typed.to);
  if (request.from && request.to && *request.to < *request.from) {
    throw Error(Exit::usage,
                fmt::format("--to {} is before --from {}; expected it after; exchange them", typed.to, typed.from));
  }
  if (!typed.end.empty()) request.end = end_policies[find_named("--end", end_policies, typed.end)].policy;
  request.keys = typed.keys;
  if (!typed.max_rows.empty()) {
    const auto rows = parse_rational(typed.max_rows);
    if (!rows || *rows < 1 || denominator(*rows) != 1 || *rows > INT64_MAX)
      refuse_value("--max-rows", typed.max_rows, "a whole number from 1 to 2^63 - 1");
    request.max_rows = whole_number(*rows);
  }
  return request;
}

}  // namespace tcb
