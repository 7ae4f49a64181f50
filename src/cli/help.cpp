// Help: the texts for terminals, the pages tcbsample(1) and tcbsample-curves(7), completions for shells, and the tables
// as JSON, made from the tables of options, presets and rules.
#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "cli/options.hpp"
#include "schema/roles.hpp"
#include "tcb/spline/rules.hpp"
#include "text/removed.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"

namespace tcb {
namespace {

using spline::end_rules;
using spline::presets;
using spline::tangent_rules;

/// Text in lines of 80 columns at most, each indented, each ended.
std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t width = 80;
  std::string out;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    if (column + 1 + word.size() > width || column == 0) {
      out += (out.empty() ? "" : "\n") + std::string(indent, ' ');
      column = indent;
    } else {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    begin = end + 1;
  }
  return out + "\n";
}

/// A text with others in the places marked for them, without line ends at its end.
std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string>> texts) {
  std::string out(text);
  for (const auto& [mark, replacement] : texts) {
    for (std::size_t at = 0; (at = out.find(mark, at)) != std::string::npos; at += replacement.size()) {
      out.replace(at, mark.size(), replacement);
    }
  }
  return out.substr(0, out.find_last_not_of('\n') + 1);
}

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
    {ValueKind::roles, "roles",
     "compopt +o default -o nospace; [[ ${word##*,} == *=* ]] || _tcbsample_offer , = @ROLES@",
     ":@VALUE@:_tcbsample_roles", " -x -a '(__tcbsample_roles)'"},
    {ValueKind::places, "places", "compopt +o default -o nospace; if [[ $word == @* ]]; then _tcbsample_files; fi",
     ":@VALUE@:_tcbsample_places", " -x -a '(__tcbsample_places)'"},
    {ValueKind::attached, "attached", "", "::@VALUE@: ", ""},
    {ValueKind::other, "other", "compopt +o default", ":@VALUE@: ", " -x"},
};

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

std::string bash_completion() {
  std::vector<std::string_view> names;
  std::string values;
  for (const OptionRow& row : option_table()) {
    const auto own = row.all_names();
    names.insert(names.end(), own.begin(), own.end());
    const std::string command = action(row, &KindRow::bash);
    if (!command.empty()) values += fmt::format("    {}) {};;\n", fmt::join(own, "|"), command);
  }
  return filled(bash_template, {{"@VALUES@", values}, {"@OPTIONS@", fmt::format("{}", fmt::join(names, " "))}});
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
  return filled(zsh_template, {{"@ROLES@", role_list()}, {"@OPTIONS@", options}});
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
  return filled(fish_template, {{"@ROLES@", role_list()}, {"@OPTIONS@", options}});
}

std::string option_object(const OptionRow& row) {
  std::vector<std::string> known;
  for (const std::string_view name : row.known_names()) known.push_back(json_text(name));
  return fmt::format(R"({{"name":{},"other_name":{},"group":{},"kind":"{}","value":{},"known":[{}],"text":{}}})",
                     json_text(row.name), json_text(row.other_name), json_text(row.group), kind_of(row).name,
                     json_text(row.value), fmt::join(known, ","), json_text(row.description()));
}

/// The rules of a preset's rotations that are not those of its positions; empty if only the curve is the usual one.
std::string rotation_rules_text(const spline::RotationRules& rules) {
  std::vector<std::string> words;
  if (rules.tangents) words.push_back(fmt::format("tangents {}", name_of(*rules.tangents)));
  if (rules.ends) words.push_back(fmt::format("ends {}", name_of(*rules.ends)));
  if (rules.curve != spline::rotation_curves[0].id) words.push_back(fmt::format("curve {}", name_of(rules.curve)));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Text for the manual page, where dashes, backslashes and leading points have a meaning.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::vector<const OptionRow*> rows_by_group() {
  std::vector<const OptionRow*> rows;
  for (const std::string_view group : option_groups) {
    for (const OptionRow& row : option_table()) {
      if (row.group == group) rows.push_back(&row);
    }
  }
  return rows;
}

std::string manual_options() {
  std::string out;
  std::string_view group;
  for (const OptionRow* const row : rows_by_group()) {
    if (row->group != group) out += fmt::format(".SS {}\n", group = row->group);
    std::vector<std::string> names;
    for (const std::string_view name : row->all_names()) names.push_back("\\fB" + escaped(name) + "\\fR");
    const std::string value = row->value.empty() ? "" : " \\fI" + escaped(row->value) + "\\fR";
    out += fmt::format(".TP\n{}{}\n{}.\n", fmt::join(names, ", "), value, escaped(row->description()));
  }
  return out;
}

std::string manual_presets() {
  std::string out;
  for (const auto& row : presets) {
    const std::string rotations = rotation_rules_text(row.rotations);
    const bool is_even = row.timing == spline::Timing::even;
    out += fmt::format(".TP\n.B {}\n{}, {}: {}{}{}.\n", escaped(row.name), escaped(name_of(row.tangents)),
                       escaped(name_of(row.ends)), escaped(row.product),
                       rotations.empty() ? "" : escaped("; rotations: " + rotations),
                       is_even ? "" : fmt::format("; timing: {}", name_of(row.timing)));
  }
  return out;
}

std::string manual_tangents() {
  std::string out;
  for (const auto& row : tangent_rules<double>) {
    out += fmt::format(".TP\n.B {}\nin = {}\n.br\nout = {}\n.br\nUsed by {}.\nChoose it {}.\n", escaped(row.name),
                       escaped(row.incoming), escaped(row.outgoing), escaped(row.used_by), escaped(row.choose));
  }
  return out;
}

std::string manual_ends() {
  std::string out;
  for (const auto& row : end_rules<double>) {
    out += fmt::format(
        ".TP\n.B {}\nout of the first key = {}\n.br\ninto the last key = {}\n.br\n{} {}.\nChoose it {}.\n",
        escaped(fmt::format("{}{}", row.name, row.takes_velocity ? "=V..." : "")), escaped(row.outgoing),
        escaped(row.incoming), row.takes_velocity ? "Takes" : "Used by", escaped(row.used_by), escaped(row.choose));
  }
  return out;
}

std::string manual_page() {
  return filled(manual_template, {{"@VERSION@", TCBSAMPLE_VERSION}, {"@OPTIONS@\n", manual_options()}});
}

std::string curves_page() {
  return filled(curves_template,
                {{"@PRESETS@\n", manual_presets()}, {"@TANGENTS@\n", manual_tangents()}, {"@ENDS@\n", manual_ends()}});
}

/// An object with the version, the options in the order of the help, the names of those that are gone, and the presets.
std::string tables_text() {
  std::vector<std::string> options, removed_options, preset_rows;
  for (const OptionRow* const row : rows_by_group()) options.push_back(option_object(*row));
  for (const RemovedName& row : removed_names()) {
    if (row.value.empty()) removed_options.push_back(json_text(row.option));
  }
  for (const auto& row : spline::presets) {
    preset_rows.push_back(fmt::format(R"({{"name":{},"tangents":{},"ends":{},"timing":{},"product":{}}})",
                                      json_text(row.name), json_text(name_of(row.tangents)),
                                      json_text(name_of(row.ends)), json_text(name_of(row.timing)),
                                      json_text(row.product)));
  }
  return fmt::format("{{\"version\":{},\n\"options\":[\n{}],\n\"removed\":[{}],\n\"presets\":[\n{}]}}",
                     json_text(TCBSAMPLE_VERSION), fmt::join(options, ",\n"), fmt::join(removed_options, ","),
                     fmt::join(preset_rows, ",\n"));
}

}  // namespace

std::string usage_text() {
  return "Usage: tcbsample [OPTION]... [FILE]...\n"
         "Reads keyframes from CSV or JSON (time, position, and optionally tension,\n"
         "continuity and bias), and prints samples of the spline through them.\n"
         "\n"
         "  tcbsample --step 0.1 keys.csv            a sample every 0.1 of time\n"
         "  tcbsample -n 200 < keys.json             200 samples, including both ends\n"
         "  tcbsample --arc-step 5 path.csv          equal distances along the curve\n"
         "\n"
         "-h shows the most common options, --help shows all, man tcbsample is the manual.";
}

std::string short_help_text() {
  return "Usage: tcbsample [OPTION]... [FILE]...\n"
         "Prints samples of the Kochanek-Bartels (TCB) spline through the keys of each\n"
         "FILE, which is CSV, other text or JSON, or of standard input.\n"
         "First look at what it makes of a file: tcbsample --explain FILE\n"
         "\n"
         "Where to take samples (give one of these):\n"
         "  -s, --step H        every H of time: 20ms, 1h; 0.1 is in the unit of the file\n"
         "      --fps HZ        HZ times per second, such as 24 or 30000/1001\n"
         "  -n, --count N       N samples, equally spaced in time, with both ends\n"
         "  -a, --arc-step H    every H of arc length; --arc-count N: N samples\n"
         "      --at T,...      at these times, or at the times in @FILE\n"
         "      --tolerance D   as few as keep the polyline within D of the curve\n"
         "      --from T, --to T    a part of the curve, with any of these\n"
         "What the file does not tell (columns by name, or by number from 1):\n"
         "      --columns time=NAME,position=NAME:NAME,ignore=NAME   what columns are\n"
         "      --input-fps HZ  times count frames, or are timecode\n"
         "      --time-unit ms  times are in ms; also s, us, ns, min, h and d\n"
         "      --date-order dmy   03/04/2024 begins with the day; mdy: with the month\n"
         "      --parameter uniform   there are no times\n"
         "  -g, --group NAME    one curve for each value in this column\n"
         "      --rotation quaternion=X:Y:Z:W   a rotation; --angle NAME=degrees\n"
         "      --missing skip-cell   leave out missing numbers; --na TEXT marks them\n"
         "      --max-gap D     keys further apart than D begin a new curve\n"
         "      --skip-lines N  lines above the table; --records PATH: the list in JSON\n"
         "Output and curve:\n"
         "  -o, --output FILE   write to FILE; one that is called .svg is a picture\n"
         "      --output-dir DIR    one file for each input\n"
         "      --fields FIELD,...  choose time,position,velocity,curvature,...\n"
         "      --golden        every number is the exact result, rounded once\n"
         "      --preset NAME   follow the rules of a product; see --list-presets\n"
         "      --tangents linear   straight lines between keys\n"
         "      --closed        back to the first key; --no-overshoot: between the keys\n"
         "      --fit D         few new keys with tension and bias, within D of all\n"
         "      --check FILE    compare FILE with the curve; --identify FILE: its rules\n"
         "      --limits        the largest speed, acceleration and jerk\n"
         "--help lists all options, man tcbsample is the manual.";
}

std::string help_text() {
  std::string out =
      "Usage: tcbsample [OPTION]... [FILE]...\n"
      "Reads keys with times, positions, and tension, continuity and bias\n"
      "(Kochanek-Bartels splines), and prints samples of the curve through them.\n"
      "\n"
      "  tcbsample --step 0.1 keys.csv            a sample every 0.1 of time\n"
      "  tcbsample --fps 30000/1001 keys.json     exact NTSC frames\n"
      "  tcbsample -n 200 < keys.csv              200 samples, including both ends\n"
      "  tcbsample --arc-step 5 path.csv          equal distances along the curve\n"
      "  tcbsample -s 0.1 --output-dir out *.csv  one output for each file\n";
  std::string_view group;
  for (const OptionRow* const row : rows_by_group()) {
    if (row->group != group) out += fmt::format("\n{}:\n", group = row->group);
    out += fmt::format("  {}{}{}\n", fmt::join(row->all_names(), ", "), row->value.empty() ? "" : " ", row->value);
    out += wrapped(row->description(), 6);
  }
  out +=
      "\nExit status: 0 if done, 1 if the data was rejected or differs, 2 after wrong\n"
      "usage or if a file cannot be opened or written, 130 if interrupted.";
  return out;
}

std::string presets_text() {
  std::string out = fmt::format("{:<11}{:<18}{:<16}{}\n", "PRESET", "TANGENTS", "ENDS", "AS IN");
  for (const auto& row : presets) {
    out += fmt::format("{:<11}{:<18}{:<16}{}\n", row.name, name_of(row.tangents), name_of(row.ends), row.product);
  }
  out +=
      "\nTANGENTS at a key between the chords D0 and D1 with the durations h0 and h1:\n"
      "  a = (1-T)(1+C)(1+B)   b = (1-T)(1-C)(1-B)   Uin  = (c D0 + d D1)/2\n"
      "  c = (1-T)(1-C)(1+B)   d = (1-T)(1+C)(1-B)   Uout = (a D0 + b D1)/2\n";
  for (const auto& row : tangent_rules<double>) {
    out += fmt::format("{}\n  in   {}\n  out  {}\n", row.name, row.incoming, row.outgoing) + wrapped(row.used_by, 4);
  }
  out +=
      "\nENDS: the tangent out of the first key, and the tangent into the last key; a\n"
      "  single formula is for both. D is the chord of the end segment, h its duration,\n"
      "  m the tangent at its other end; a to d and T belong to the end key:\n";
  for (const auto& row : end_rules<double>) {
    const bool same = row.outgoing == row.incoming;
    out += fmt::format("{:<17}{}\n", row.name,
                       same ? std::string(row.outgoing) : fmt::format("{}, {}", row.outgoing, row.incoming));
    out += wrapped(row.used_by, 4);
  }
  out += "\nCURVES OF ROTATIONS between keys p and q, with tangents from the same rules:\n";
  for (const auto& row : spline::rotation_curves) {
    out += fmt::format("{:<12}{}\n", row.name, row.formula) + wrapped(row.used_by, 4);
  }
  out += fmt::format("\nROTATIONS have the tangents and ends of the preset, and the curve {}, except:\n",
                     spline::rotation_curves[0].name);
  for (const auto& row : presets) {
    const std::string rules = rotation_rules_text(row.rotations);
    if (!rules.empty()) out += fmt::format("{:<12}{}\n", row.name, rules);
  }
  out +=
      "\nTIMING is even, except that u follows from time by the monotone cubic (PCHIP)\n"
      "  from the times of keys to their numbers with:\n";
  for (const auto& row : presets) {
    if (row.timing != spline::Timing::even) out += fmt::format("{}\n", row.name);
  }
  return out.substr(0, out.size() - 1);
}

std::string version_text() { return fmt::format("tcbsample {}", TCBSAMPLE_VERSION); }

std::string generated_text(Generated kind) {
  switch (kind) {
    case Generated::manual: return manual_page();
    case Generated::curves: return curves_page();
    case Generated::bash: return bash_completion();
    case Generated::zsh: return zsh_completion();
    case Generated::fish: return fish_completion();
    case Generated::tables: return tables_text();
  }
  return "";
}

}  // namespace tcb
