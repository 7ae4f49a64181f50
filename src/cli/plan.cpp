// What the typed options mean: text to values, and the checks that no option stands in another's way.
#include "cli/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "curve_plan.hpp"
#include "error.hpp"
#include "format/number.hpp"
#include "nearest.hpp"
#include "rows.hpp"
#include "sampler/rational.hpp"

namespace tcb::cli {
namespace {

using sampler::Mode;
using sampler::Rational;

[[noreturn]] void refuse(std::string_view option, std::string_view value, std::string_view expected) {
  throw Error(Exit::usage, fmt::format("{} \"{}\": expected {}", option, value, expected));
}

std::vector<std::string_view> split_list(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Rational positive_rational(std::string_view option, const std::string& text) {
  const auto value = sampler::parse_rational(text);
  if (!value || *value <= 0) refuse(option, text, "a decimal or a ratio above 0, such as 0.1 or 1/24");
  return *value;
}

std::uint64_t positive_count(std::string_view option, const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0 || value > INT64_MAX) {
    refuse(option, text, "a whole number from 1 up");
  }
  return value;
}

std::optional<Rational> optional_rational(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto value = sampler::parse_rational(text);
  if (!value) refuse(option, text, "a decimal or a ratio, such as 1.5 or 7/24");
  return value;
}

/// A way to ask for samples: its option, and how its value becomes a request.
struct ModeOption {
  std::string_view name;
  std::string Typed::*value;
  void (*set)(sampler::Request&, std::string_view name, const std::string& value);
};

template <Mode mode>
void set_step(sampler::Request& request, std::string_view name, const std::string& value) {
  request.mode = mode;
  request.step = positive_rational(name, value);
}
template <Mode mode>
void set_count(sampler::Request& request, std::string_view name, const std::string& value) {
  request.mode = mode;
  request.count = positive_count(name, value);
}
void set_rate(sampler::Request& request, std::string_view name, const std::string& value) {
  request.mode = Mode::step;
  request.step = 1 / positive_rational(name, value);
}

constexpr std::array mode_options{
    ModeOption{"--step", &Typed::step, set_step<Mode::step>},
    ModeOption{"--rate", &Typed::rate, set_rate},
    ModeOption{"--count", &Typed::count, set_count<Mode::count>},
    ModeOption{"--segments", &Typed::segments, set_count<Mode::segments>},
    ModeOption{"--arc-step", &Typed::arc_step, set_step<Mode::arc_step>},
    ModeOption{"--arc-count", &Typed::arc_count, set_count<Mode::arc_count>},
};

sampler::Request make_sampling(const Typed& typed) {
  std::vector<const ModeOption*> given;
  std::vector<std::string_view> names;
  for (const ModeOption& option : mode_options) {
    names.push_back(option.name);
    if (!(typed.*option.value).empty()) given.push_back(&option);
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
  sampler::Request request;
  given[0]->set(request, given[0]->name, typed.*given[0]->value);
  request.from = optional_rational("--from", typed.from);
  request.to = optional_rational("--to", typed.to);
  if (request.from && request.to && *request.to < *request.from) {
    throw Error(Exit::usage,
                fmt::format("--to {} is before --from {}; expected it after; exchange them", typed.to, typed.from));
  }
  return request;
}

char delimiter(const std::string& text) {
  constexpr std::array names{std::pair{"tab", '\t'}, std::pair{"comma", ','}, std::pair{"semicolon", ';'},
                             std::pair{"space", ' '}, std::pair{"pipe", '|'}};
  for (const auto& [name, character] : names) {
    if (text == name) return character;
  }
  const bool usable =
      text.size() == 1 && std::string_view("\"\n\r+-.0123456789eE").find(text[0]) == std::string_view::npos;
  if (!usable)
    refuse("--delimiter", text, "one character that is no part of a number, or tab, comma, semicolon, space or pipe");
  return text[0];
}

spline::Tcb<double> tcb(const std::string& text) {
  const auto parts = split_list(text);
  std::array<double, 3> values{};
  if (parts.size() != values.size()) refuse("--tcb", text, "three numbers T,C,B, such as 0,0.5,-0.25");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = format::parse_number(parts[i]);
    if (!value) refuse("--tcb", text, "three numbers T,C,B, such as 0,0.5,-0.25");
    values[i] = *value;
  }
  return {values[0], values[1], values[2]};
}

format::InputOptions make_input(const Typed& typed) {
  format::InputOptions input;
  if (!typed.input_format.empty()) input.format = format::find_format("--input-format", typed.input_format);
  if (!typed.delimiter.empty()) input.delimiter = delimiter(typed.delimiter);
  if (typed.header && typed.no_header) {
    throw Error(Exit::usage, "--header and --no-header contradict each other; expected one of them; take one out");
  }
  if (typed.header || typed.no_header) input.header = typed.header;
  input.comment = typed.comment == "none" ? "" : typed.comment;
  if (input.format && (input.delimiter || input.header) && !format::formats()[*input.format].has_header) {
    throw Error(Exit::usage, "--delimiter, --header and --no-header have no effect on JSON; take them out");
  }
  if (!typed.columns.empty()) input.roles = format::parse_roles(typed.columns);
  if (!typed.tcb.empty()) input.tcb = tcb(typed.tcb);
  return input;
}

std::vector<std::size_t> make_fields(const std::string& text) {
  std::vector<std::string_view> known;
  std::ranges::transform(fields(), std::back_inserter(known), &Field::name);
  std::vector<std::size_t> chosen;
  for (const std::string_view name : split_list(text)) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      throw Error(Exit::usage, fmt::format("--fields: no field \"{}\"; expected some of {}{}", name,
                                           fmt::join(known, ", "), did_you_mean(name, known)));
    }
    chosen.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  return chosen;
}

/// The names are known, and no option about the curve is without effect.
void check_curve(const Typed& typed, Plan& plan) {
  const CurvePlan curve = make_curve(plan.curve);
  plan.input.timeless = typed.curve.parameter.has_value();
  if (curve.extrapolation != sampler::Extrapolation::error) {
    if (sampler::by_length(plan.sampling.mode)) {
      throw Error(Exit::usage,
                  "--extrapolate has no effect on samples by arc length, which end with the curve; take it out");
    }
    if (plan.sampling.mode == Mode::step && plan.sampling.to == std::nullopt && plan.sampling.from == std::nullopt) {
      throw Error(Exit::usage,
                  "--extrapolate has no effect without --from or --to; expected a range beyond the keys; give one");
    }
  }
}

}  // namespace

Plan make_plan(const Typed& typed) {
  Plan plan;
  plan.sampling = make_sampling(typed);
  plan.input = make_input(typed);
  plan.curve = typed.curve;
  if (typed.closed) plan.curve.closed = true;
  check_curve(typed, plan);
  plan.files = typed.files.empty() ? std::vector<std::string>{"-"} : typed.files;
  plan.fields = make_fields(typed.fields.empty() ? "time,position" : typed.fields);
  if (!typed.output_format.empty()) plan.output_format = format::find_format("--output-format", typed.output_format);
  if (typed.no_output_header) {
    if (!format::formats()[plan.output_format].has_header) {
      throw Error(Exit::usage,
                  "--no-output-header has no effect on this output format, which names the numbers of each row; "
                  "take it out");
    }
    plan.output_header = false;
  }
  if (!typed.output.empty() && !typed.output_dir.empty()) {
    throw Error(Exit::usage,
                "--output and --output-dir both say where the rows go; expected one of them; take one out");
  }
  if (!typed.output.empty()) plan.output = typed.output;
  if (!typed.output_dir.empty()) plan.output_folder = typed.output_dir;
  return plan;
}

}  // namespace tcb::cli
