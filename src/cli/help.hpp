// Help: the texts made from the tables of options, presets and rules, for terminals and the manual page.
#pragma once

#include <string>
#include <vector>

#include "cli/typed_options.hpp"

namespace tcb {

/// The prose of the manual page, man/tcbsample.1.in, put into the program by the build.
extern const char* const manual_template;

/// The text shown without arguments, the help on one screen, and all of it, in 80 columns.
std::string usage_text();
std::string short_help_text();
std::string help_text();

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

std::string version_text();

/// The manual page, a completion script, or the names of the columns of files.
std::string generated_text(Generated kind, const std::vector<std::string>& files = {});

}  // namespace tcb
