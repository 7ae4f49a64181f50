// The tables of presets and rules, as text for a terminal and for the manual page.
#include "cli/presets.hpp"

#include <fmt/format.h>

#include "cli/text.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

using spline::end_rules;
using spline::presets;
using spline::tangent_rules;

std::string presets_text() {
  std::string out = fmt::format("{:<10}{:<18}{:<16}{}\n", "PRESET", "TANGENTS", "ENDS", "AS IN");
  for (const auto& row : presets) {
    out += fmt::format("{:<10}{:<18}{:<16}{}\n", row.name, name_of(row.tangents), name_of(row.ends), row.product);
  }
  out +=
      "\nTANGENTS of a key between chords D0, D1 of durations h0, h1, for the segment:\n"
      "  a = (1-T)(1+C)(1+B)   b = (1-T)(1-C)(1-B)   Uin  = (c D0 + d D1)/2\n"
      "  c = (1-T)(1-C)(1+B)   d = (1-T)(1+C)(1-B)   Uout = (a D0 + b D1)/2\n";
  for (const auto& row : tangent_rules<double>) {
    out += fmt::format("{}\n  in   {}\n  out  {}\n", row.name, row.incoming, row.outgoing) + wrapped(row.used_by, 4);
  }
  out +=
      "\nENDS: out of the first key, into the last (one formula: the same for both).\n"
      "D is the end segment's chord, h its duration, m its other\n"
      "tangent, a to d and T the end key's own:\n";
  for (const auto& row : end_rules<double>) {
    const bool same = row.outgoing == row.incoming;
    out += fmt::format("{:<17}{}\n", row.name,
                       same ? std::string(row.outgoing) : fmt::format("{}, {}", row.outgoing, row.incoming));
    out += wrapped(row.used_by, 4);
  }
  return out.substr(0, out.size() - 1);
}

std::string manual_presets() {
  std::string out;
  for (const auto& row : presets) {
    out += fmt::format(".TP\n.B {}\n{}, {}: {}.\n", escaped(row.name), escaped(name_of(row.tangents)),
                       escaped(name_of(row.ends)), escaped(row.product));
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
    out += fmt::format(".TP\n.B {}\nout of the first key = {}\n.br\nin of the last key = {}\n.br\n{}: {}.\n",
                       escaped(fmt::format("{}{}", row.name, row.takes_velocity ? "=V..." : "")), escaped(row.outgoing),
                       escaped(row.incoming), escaped(row.used_by), escaped(row.choose));
  }
  return out;
}

}  // namespace tcb
