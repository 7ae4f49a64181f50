// What the input is like: the options that say it, and which of them have a meaning together.
#include "cli/input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "error.hpp"
#include "text/number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

char delimiter(const std::string& text) {
  constexpr std::array names{std::pair{"tab", '\t'}, std::pair{"comma", ','}, std::pair{"semicolon", ';'},
                             std::pair{"space", ' '}, std::pair{"pipe", '|'}};
  for (const auto& [name, character] : names) {
    if (text == name) return character;
  }
  const bool usable =
      text.size() == 1 && std::string_view("\"\n\r+-.0123456789eE").find(text[0]) == std::string_view::npos;
  if (!usable)
    refuse_value("--delimiter", text,
                 "one character that is no part of a number, or tab, comma, semicolon, space or pipe");
  return text[0];
}

spline::Tcb<double> tcb(const std::string& text) {
  const auto parts = split(text, ',');
  std::array<double, 3> values{};
  if (parts.size() != values.size()) refuse_value("--tcb", text, "three numbers T,C,B, such as 0,0.5,-0.25");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = parse_number(parts[i]);
    if (!value) refuse_value("--tcb", text, "three numbers T,C,B, such as 0,0.5,-0.25");
    values[i] = *value;
  }
  return {values[0], values[1], values[2]};
}

/// The columns of --group, besides those of --columns.
RoleRequest groups(const std::string& text) {
  const auto names = split(text, ',');
  if (std::ranges::count(names, "") > 0) refuse_value("--group", text, "columns by name or number, apart by commas");
  return {Role::group, {names.begin(), names.end()}, "--group"};
}

/// Throws: Error (usage) for options about delimited text where the input is JSON.
void require_text(const InputOptions& input, const TypedOptions& typed) {
  const bool about_text = input.delimiter || input.header || !typed.decimal.empty() || !typed.comment.empty();
  if (!about_text || !input.format || format_of(*input.format).has_header) return;
  throw Error(Exit::usage,
              "--delimiter, --header, --no-header, --comment and --decimal have no effect on JSON; take them out");
}

/// Throws: Error (usage) where a decimal comma would end cells.
void require_delimiter(const InputOptions& input) {
  if (input.decimal != ',' || input.delimiter != ',') return;
  throw Error(Exit::usage,
              "--decimal , and --delimiter , contradict each other; expected another delimiter; take one of them out");
}

}  // namespace

FormatId named_format(std::string_view option, std::string_view name, bool Format::*capability) {
  std::vector<std::string_view> names;
  for (const Format& format : formats) {
    if (!(format.*capability)) continue;
    if (format.name == name) return format.id;
    names.push_back(format.name);
  }
  throw Error(Exit::usage,
              fmt::format("{}: unknown format \"{}\"; expected one of {}", option, name, fmt::join(names, ", ")));
}

InputOptions make_input(const TypedOptions& typed) {
  InputOptions input;
  if (!typed.input_format.empty()) input.format = named_format("--input-format", typed.input_format, &Format::can_read);
  if (!typed.delimiter.empty()) input.delimiter = delimiter(typed.delimiter);
  if (typed.header && typed.no_header) {
    throw Error(Exit::usage, "--header and --no-header contradict each other; expected one of them; take one out");
  }
  if (typed.header || typed.no_header) input.header = typed.header;
  if (!typed.comment.empty()) input.comment = typed.comment == "none" ? "" : typed.comment;
  if (!typed.decimal.empty()) {
    if (typed.decimal != "," && typed.decimal != ".") refuse_value("--decimal", typed.decimal, "a comma or a point");
    input.decimal = typed.decimal[0];
  }
  require_text(input, typed);
  require_delimiter(input);
  if (!typed.columns.empty()) input.roles = parse_roles(typed.columns);
  if (!typed.group.empty()) input.roles.push_back(groups(typed.group));
  if (!typed.tcb.empty()) input.tcb = tcb(typed.tcb);
  if (!typed.missing.empty()) {
    input.missing = missing_names[find_named("--missing", missing_names, typed.missing)].way;
  }
  return input;
}

CurveOptions make_curves(const TypedOptions& typed) {
  CurveOptions curves;
  curves.sort = typed.sort;
  if (!typed.duplicates.empty()) {
    curves.duplicates = duplicates_names[find_named("--duplicates", duplicates_names, typed.duplicates)].value;
  }
  return curves;
}

}  // namespace tcb
