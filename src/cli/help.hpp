// Help: the texts that are made from the tables of options, presets and rules: for terminals, the manual, completions,
// and the tables as JSON.
#pragma once

#include <string>

#include "cli/options.hpp"

namespace tcb {

/// The text shown without arguments, the help on one screen, and all of it, in 80 columns.
std::string usage_text();
std::string short_help_text();
std::string help_text();

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

std::string version_text();

/// The texts of man/tcbsample.1.in, man/tcbsample-curves.7.in and cli/completions/, put into the program by the build.
extern const char* const manual_template;
extern const char* const curves_template;
extern const char* const bash_template;
extern const char* const zsh_template;
extern const char* const fish_template;

/// A page of the manual, a completion script, or the tables; without the last line end.
std::string generated_text(Generated kind);

}  // namespace tcb
