// The tables of presets and rules, as text for a terminal and for the manual page.
#pragma once

#include <string>

namespace tcb {

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

/// The same as parts of the manual page, without its escapes: headings and entries.
std::string manual_presets();
std::string manual_tangents();
std::string manual_ends();

}  // namespace tcb
