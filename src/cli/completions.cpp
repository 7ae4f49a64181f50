// Completions: scripts for bash, zsh and fish, made from the table of options, and the columns that they offer.
#include "cli/completions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/completion_scripts.hpp"
#include "cli/help.hpp"
#include "cli/options.hpp"
#include "formats/open_input.hpp"
#include "io/input_file.hpp"
#include "schema/roles.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

std::string known_names(const OptionRow& row) { return fmt::format("{}", fmt::join(row.known(), " ")); }

/// The options whose next word is a value.
std::string valued_options(std::string_view separator) {
  std::vector<std::string_view> names;
  for (const OptionRow& row : option_table()) {
    if (row.kind == ValueKind::flag || row.kind == ValueKind::attached) continue;
    const auto own = row.all_names();
    names.insert(names.end(), own.begin(), own.end());
  }
  return fmt::format("{}", fmt::join(names, separator));
}

std::string role_list() {
  std::vector<std::string_view> names;
  for (const Role role : {Role::time, Role::position, Role::tension, Role::continuity, Role::bias, Role::ease_in,
                          Role::ease_out, Role::group, Role::carry, Role::unused}) {
    names.push_back(role_name(role));
  }
  return fmt::format("{}", fmt::join(names, " "));
}

/// Text in single quotes, where the characters of `special` have a backslash in front, and a quote is `quote`.
std::string quoted(std::string_view text, std::string_view special, std::string_view quote) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c == '\'' ? std::string(quote) : std::string(1, c);
  }
  return out;
}

std::string zsh_text(std::string_view text) { return quoted(text, "[]:\\", "'\\''"); }
std::string fish_text(std::string_view text) { return quoted(text, "\\", "\\'"); }

/// What bash does for the value of an option.
std::string bash_value(const OptionRow& row) {
  switch (row.kind) {
    case ValueKind::flag:
    case ValueKind::attached: return "";
    case ValueKind::name: return fmt::format("_tcbsample_offer , '' {}", known_names(row));
    case ValueKind::names: return fmt::format("compopt -o nospace; _tcbsample_offer , '' {}", known_names(row));
    case ValueKind::file: return ":";
    case ValueKind::folder: return "compopt +o default -o dirnames";
    case ValueKind::columns: return "compopt +o default -o nospace; _tcbsample_columns ,";
    case ValueKind::column_pair: return "compopt +o default -o nospace; _tcbsample_columns : positions";
    case ValueKind::roles:
      return "compopt +o default -o nospace; if [[ ${word##*,} == position=* ]]; then _tcbsample_columns ,=: "
             "positions; elif [[ ${word##*,} == *=* ]]; "
             "then _tcbsample_columns ,=:; else "
             "_tcbsample_offer , = " +
             role_list() + "; fi";
    case ValueKind::places: return "compopt +o default -o nospace; if [[ $word == @* ]]; then _tcbsample_files; fi";
    case ValueKind::other: return "compopt +o default";
  }
  return "";
}

/// What zsh offers for the value of an option.
std::string zsh_value(const OptionRow& row) {
  const auto action = [&row](const std::string& what) { return fmt::format(":{}:{}", zsh_text(row.value), what); };
  switch (row.kind) {
    case ValueKind::flag: return "";
    case ValueKind::attached: return ":" + action(" ");
    case ValueKind::name: return action(fmt::format("({})", known_names(row)));
    case ValueKind::names: return action(fmt::format("_sequence -d compadd - {}", known_names(row)));
    case ValueKind::file: return action("_files");
    case ValueKind::folder: return action("_files -/");
    case ValueKind::columns: return action("_sequence _tcbsample_columns columns");
    case ValueKind::column_pair: return action("_tcbsample_pair");
    case ValueKind::roles: return action("_tcbsample_roles");
    case ValueKind::places: return action("_tcbsample_places");
    case ValueKind::other: return action(" ");
  }
  return "";
}

/// The beginning of a description that fits into a line of fish's list.
std::string_view brief(std::string_view text) {
  constexpr std::size_t longest = 60;
  text = text.substr(0, std::min({text.find(". "), text.find("; "), text.find(": ")}));
  if (text.size() <= longest) return text;
  const std::size_t end = std::max(text.rfind(", ", longest) + 1, text.rfind(" (", longest) + 1);
  return text.substr(0, end > 1 ? end - 1 : text.rfind(' ', longest));
}

/// What fish offers for the value of an option.
std::string fish_value(const OptionRow& row) {
  switch (row.kind) {
    case ValueKind::flag:
    case ValueKind::attached: return "";
    case ValueKind::name: return fmt::format(" -x -a '{}'", known_names(row));
    case ValueKind::names: return fmt::format(" -x -a '(__tcbsample_list , {})'", known_names(row));
    case ValueKind::file: return " -r -F";
    case ValueKind::folder: return " -x -a '(__fish_complete_directories)'";
    case ValueKind::columns: return " -x -a '(__tcbsample_list , (__tcbsample_columns columns))'";
    case ValueKind::column_pair: return " -x -a '(__tcbsample_list : (__tcbsample_columns positions))'";
    case ValueKind::roles: return " -x -a '(__tcbsample_roles)'";
    case ValueKind::places: return " -x -a '(__tcbsample_places)'";
    case ValueKind::other: return " -x";
  }
  return "";
}

}  // namespace

std::string bash_completion() {
  std::vector<std::string_view> names;
  std::string values;
  for (const OptionRow& row : option_table()) {
    const auto own = row.all_names();
    names.insert(names.end(), own.begin(), own.end());
    const std::string action = bash_value(row);
    if (!action.empty()) values += fmt::format("    {}) {};;\n", fmt::join(own, "|"), action);
  }
  return filled(bash_script, {{"@VALUED@", valued_options("|")},
                              {"@VALUES@", values},
                              {"@OPTIONS@", fmt::format("{}", fmt::join(names, " "))}});
}

std::string zsh_completion() {
  std::string options;
  for (const OptionRow& row : option_table()) {
    const std::vector<std::string_view> names = row.all_names();
    for (const std::string_view name : names) {
      std::string_view mark = name.starts_with("--") ? "=" : "+";  // the value may be in the same word
      if (row.kind == ValueKind::flag) mark = "";
      if (row.kind == ValueKind::attached) mark = "=-";
      const std::string others = names.size() > 1 ? fmt::format("({})", fmt::join(names, " ")) : "";
      options += fmt::format("  '{}{}{}[{}]{}' \\\n", others, name, mark, zsh_text(row.description()), zsh_value(row));
    }
  }
  return filled(zsh_script, {{"@VALUED@", valued_options("|")}, {"@ROLES@", role_list()}, {"@OPTIONS@", options}});
}

std::string fish_completion() {
  std::string options;
  for (const OptionRow& row : option_table()) {
    options += options.empty() ? "complete -c tcbsample" : "\ncomplete -c tcbsample";
    for (const std::string_view name : row.all_names()) {
      const bool is_long = name.starts_with("--");
      options += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
    }
    options += fmt::format("{} -d '{}'", fish_value(row), fish_text(brief(row.text)));
  }
  return filled(fish_script, {{"@VALUED@", valued_options(" ")}, {"@ROLES@", role_list()}, {"@OPTIONS@", options}});
}

std::string columns_text(const std::vector<std::string>& files, bool positions_only) {
  std::vector<std::string> names;
  for (const std::string& file : files.empty() ? std::vector<std::string>{"-"} : files) {
    try {
      const Input input = open_input(file, read_file(file), {});
      const Schema& schema = input.schema;
      if (positions_only) {
        names.insert(names.end(), schema.channels.begin(), schema.channels.end());
        continue;
      }
      if (schema.time.is_given) names.push_back(schema.time.name);
      for (const auto* group : {&schema.channels, &schema.groups, &schema.labels, &input.facts.ignored}) {
        names.insert(names.end(), group->begin(), group->end());
      }
      names.insert(names.end(), input.facts.roles.begin(), input.facts.roles.end());
    } catch (const Error& error) {
      throw error.in(shown_name(file));
    }
  }
  std::ranges::transform(names, names.begin(), printable);
  return fmt::format("{}", fmt::join(names, "\n"));
}

}  // namespace tcb
