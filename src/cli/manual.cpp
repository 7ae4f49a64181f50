// Manual: the pages tcbsample(1) and tcbsample-curves(7), made from their texts and the tables of options, presets and
// rules.
#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using spline::end_rules;
using spline::presets;
using spline::tangent_rules;

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
}  // namespace

std::string manual_page() {
  return filled(manual_template, {{"@VERSION@", TCBSAMPLE_VERSION}, {"@OPTIONS@\n", manual_options()}});
}

std::string curves_page() {
  return filled(curves_template,
                {{"@PRESETS@\n", manual_presets()}, {"@TANGENTS@\n", manual_tangents()}, {"@ENDS@\n", manual_ends()}});
}

}  // namespace tcb
