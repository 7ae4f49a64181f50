// Completions: the texts of cli/completions/ for bash, zsh and fish with what follows from the table of options, and
// the columns that the scripts offer.
#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "formats/formats.hpp"
#include "io/input_file.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "schema/roles.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// A kind of value as the tables name it, and what the shells do with one, where @NAMES@ are the names of the option,
/// @ROLES@ those of roles, and @VALUE@ what the help calls the value.
struct KindRow {
  ValueKind kind;
  std::string_view name;
  std::string_view bash;  ///< a command of the script for bash; empty: the value is no word of its own
  std::string_view zsh;   ///< the rest of an argument of _arguments
  std::string_view fish;  ///< further options of complete
};
constexpr KindRow kind_rows[] = {
    {ValueKind::flag, "flag", "", "", ""},
    {ValueKind::name, "name", "_tcbsample_offer , '' @NAMES@", ":@VALUE@:(@NAMES@)", " -x -a '@NAMES@'"},
    {ValueKind::names, "names", "compopt -o nospace; _tcbsample_offer , '' @NAMES@",
     ":@VALUE@:_sequence -d compadd - @NAMES@", " -x -a '(__tcbsample_list , @NAMES@)'"},
    {ValueKind::file, "file", ":", ":@VALUE@:_files", " -r -F"},
    {ValueKind::folder, "folder", "compopt +o default -o dirnames", ":@VALUE@:_files -/",
     " -x -a '(__fish_complete_directories)'"},
    {ValueKind::columns, "columns", "compopt +o default -o nospace; _tcbsample_columns ,",
     ":@VALUE@:_sequence _tcbsample_columns columns", " -x -a '(__tcbsample_list , (__tcbsample_columns columns))'"},
    {ValueKind::column_pair, "column_pair", "compopt +o default -o nospace; _tcbsample_columns : positions",
     ":@VALUE@:_tcbsample_pair", " -x -a '(__tcbsample_list : (__tcbsample_columns positions))'"},
    {ValueKind::roles, "roles",
     "compopt +o default -o nospace; if [[ ${word##*,} == position=* ]]; then _tcbsample_columns ,=: positions; elif "
     "[[ ${word##*,} == *=* ]]; then _tcbsample_columns ,=:; else _tcbsample_offer , = @ROLES@; fi",
     ":@VALUE@:_tcbsample_roles", " -x -a '(__tcbsample_roles)'"},
    {ValueKind::places, "places", "compopt +o default -o nospace; if [[ $word == @* ]]; then _tcbsample_files; fi",
     ":@VALUE@:_tcbsample_places", " -x -a '(__tcbsample_places)'"},
    {ValueKind::attached, "attached", "", "::@VALUE@: ", ""},
    {ValueKind::other, "other", "compopt +o default", ":@VALUE@: ", " -x"},
};

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

const KindRow& kind_of(const OptionRow& row) { return *std::ranges::find(kind_rows, row.kind, &KindRow::kind); }

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

/// What a shell does for the value of an option. `value`: what the help calls it.
std::string action(const OptionRow& row, std::string_view KindRow::*shell, const std::string& value = "") {
  return filled(kind_of(row).*shell, {{"@NAMES@", fmt::format("{}", fmt::join(row.known_names(), " "))},
                                      {"@ROLES@", role_list()},
                                      {"@VALUE@", value}});
}

/// The beginning of a description that fits into a line of fish's list.
std::string_view brief(std::string_view text) {
  constexpr std::size_t longest = 60;
  text = text.substr(0, std::min({text.find(". "), text.find("; "), text.find(": ")}));
  if (text.size() <= longest) return text;
  const std::size_t end = std::max(text.rfind(", ", longest) + 1, text.rfind(" (", longest) + 1);
  return text.substr(0, end > 1 ? end - 1 : text.rfind(' ', longest));
}

}  // namespace

std::string_view name_of_kind(const OptionRow& row) { return kind_of(row).name; }

std::string bash_completion() {
  std::vector<std::string_view> names;
  std::string values;
  for (const OptionRow& row : option_table()) {
    const auto own = row.all_names();
    names.insert(names.end(), own.begin(), own.end());
    const std::string command = action(row, &KindRow::bash);
    if (!command.empty()) values += fmt::format("    {}) {};;\n", fmt::join(own, "|"), command);
  }
  return filled(bash_template, {{"@VALUED@", valued_options("|")},
                                {"@VALUES@", values},
                                {"@OPTIONS@", fmt::format("{}", fmt::join(names, " "))}});
}

std::string zsh_completion() {
  std::string options;
  for (const OptionRow& row : option_table()) {
    const std::vector<std::string_view> names = row.all_names();
    const std::string value = action(row, &KindRow::zsh, zsh_text(row.value));
    for (const std::string_view name : names) {
      std::string_view mark = name.starts_with("--") ? "=" : "+";  // the value may be in the same word
      if (row.kind == ValueKind::flag) mark = "";
      if (row.kind == ValueKind::attached) mark = "=-";
      const std::string others = names.size() > 1 ? fmt::format("({})", fmt::join(names, " ")) : "";
      options += fmt::format("  '{}{}{}[{}]{}' \\\n", others, name, mark, zsh_text(row.description()), value);
    }
  }
  return filled(zsh_template, {{"@VALUED@", valued_options("|")}, {"@ROLES@", role_list()}, {"@OPTIONS@", options}});
}

std::string fish_completion() {
  std::string options;
  for (const OptionRow& row : option_table()) {
    options += options.empty() ? "complete -c tcbsample" : "\ncomplete -c tcbsample";
    for (const std::string_view name : row.all_names()) {
      const bool is_long = name.starts_with("--");
      options += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
    }
    options += fmt::format("{} -d '{}'", action(row, &KindRow::fish), fish_text(brief(row.text)));
  }
  return filled(fish_template, {{"@VALUED@", valued_options(" ")}, {"@ROLES@", role_list()}, {"@OPTIONS@", options}});
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
