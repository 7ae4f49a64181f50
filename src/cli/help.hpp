// Help: the texts made from the tables of options, presets and rules, for terminals, the manual page and shells.
#pragma once

#include <string>
#include <string_view>

#include "cli/options.hpp"

namespace tcb {

/// The prose of the manual page, man/tcbsample.1.in, put into the program by the build.
extern const char* const manual_template;

/// The help, in 80 columns.
std::string help_text();

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

std::string version_text();

/// The manual page, or a completion script.
std::string generated_text(Generated kind);

}  // namespace tcb
