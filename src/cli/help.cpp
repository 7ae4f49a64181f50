// Help: the texts for terminals, the pages tcbsample(1) and tcbsample-curves(7), and the tables as JSON, made from the
// tables of options, presets and rules.
#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "cli/options.hpp"
#include "tcb/spline/rules.hpp"
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

std::string option_object(const OptionRow& row) {
  std::vector<std::string> known;
  for (const std::string_view name : row.known_names()) known.push_back(json_text(name));
  return fmt::format(R"({{"name":{},"other_name":{},"group":{},"kind":"{}","value":{},"known":[{}],"text":{}}})",
                     json_text(row.name), json_text(row.other_name), json_text(row.group), name_of_kind(row),
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

std::string manual_options() {
  std::string out;
  const auto show = [&out](const OptionRow& row) {
    std::vector<std::string> names;
    for (const std::string_view name : row.all_names()) names.push_back("\\fB" + escaped(name) + "\\fR");
    const std::string value = row.value.empty() ? "" : " \\fI" + escaped(row.value) + "\\fR";
    out += fmt::format(".TP\n{}{}\n{}.\n", fmt::join(names, ", "), value, escaped(row.description()));
  };
  for_each_group([&out](std::string_view group) { out += fmt::format(".SS {}\n", group); }, show);
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

/// An object with the version, the options in the order of the help, and the presets.
std::string tables_text() {
  std::vector<std::string> options, preset_rows;
  for_each_group([](std::string_view) {}, [&options](const OptionRow& row) { options.push_back(option_object(row)); });
  for (const auto& row : spline::presets) {
    preset_rows.push_back(fmt::format(R"({{"name":{},"tangents":{},"ends":{},"timing":{},"product":{}}})",
                                      json_text(row.name), json_text(name_of(row.tangents)),
                                      json_text(name_of(row.ends)), json_text(name_of(row.timing)),
                                      json_text(row.product)));
  }
  return fmt::format("{{\"version\":{},\n\"options\":[\n{}],\n\"presets\":[\n{}]}}", json_text(TCBSAMPLE_VERSION),
                     fmt::join(options, ",\n"), fmt::join(preset_rows, ",\n"));
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
         "FILE, or of standard input.\n"
         "\n"
         "Where to take samples (give one of these):\n"
         "  -s, --step H        every H of time, such as 0.1 or 1/24\n"
         "      --fps HZ        HZ times per second, such as 24 or 30000/1001\n"
         "  -n, --count N       N samples, including both ends\n"
         "  -a, --arc-step H    every H of arc length\n"
         "      --at T,...      at these times, or at the times in @FILE\n"
         "      --tolerance D   as few as keep the polyline within D of the curve\n"
         "\n"
         "Other common options:\n"
         "      --preset NAME   follow the rules of a product; see --list-presets\n"
         "      --columns ROLE=NAME,...  say what the columns mean\n"
         "  -o, --output FILE   write to FILE instead of standard output\n"
         "      --output-dir DIR  write one file for each input file\n"
         "      --fields FIELD,...  choose time,position,velocity,curvature,...\n"
         "      --explain       show what was detected and what would be done\n"
         "\n"
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
  const auto show = [&out](const OptionRow& row) {
    out += fmt::format("  {}{}{}\n", fmt::join(row.all_names(), ", "), row.value.empty() ? "" : " ", row.value);
    out += wrapped(row.description(), 6);
  };
  for_each_group([&out](std::string_view group) { out += fmt::format("\n{}:\n", group); }, show);
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

std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string>> texts) {
  std::string out(text);
  for (const auto& [mark, replacement] : texts) {
    for (std::size_t at = 0; (at = out.find(mark, at)) != std::string::npos; at += replacement.size()) {
      out.replace(at, mark.size(), replacement);
    }
  }
  return out.substr(0, out.find_last_not_of('\n') + 1);
}

std::string generated_text(Generated kind, const std::vector<std::string>& files) {
  switch (kind) {
    case Generated::manual: return manual_page();
    case Generated::curves: return curves_page();
    case Generated::bash: return bash_completion();
    case Generated::zsh: return zsh_completion();
    case Generated::fish: return fish_completion();
    case Generated::columns: return columns_text(files, false);
    case Generated::positions: return columns_text(files, true);
    case Generated::tables: return tables_text();
  }
  return "";
}

}  // namespace tcb
