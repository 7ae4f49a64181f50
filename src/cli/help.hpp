// Help: the texts for terminals, made from the tables of options, presets and rules.
#pragma once

#include <string>
#include <vector>

#include "cli/typed_options.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

/// The text shown without arguments, the help on one screen, and all of it, in 80 columns.
std::string usage_text();
std::string short_help_text();
std::string help_text();

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

/// The rules of a preset's rotations that are not those of its positions; empty if only the curve is the usual one.
std::string rotation_rules_text(const spline::RotationRules& rules);

std::string version_text();

/// The manual page, a completion script, or the names of the columns of files.
std::string generated_text(Generated kind, const std::vector<std::string>& files = {});

}  // namespace tcb
