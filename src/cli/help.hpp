// Help: the texts that are made from the tables of options, presets and rules: for terminals, the manual, completions,
// and the tables as JSON.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/typed_options.hpp"

namespace tcb {

struct OptionRow;

/// The text shown without arguments, the help on one screen, and all of it, in 80 columns.
std::string usage_text();
std::string short_help_text();
std::string help_text();

/// Presets, tangent rules and end rules with their formulas, in 80 columns.
std::string presets_text();

std::string version_text();

/// A text with others in the places marked for them, without line ends at its end.
std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string>> texts);

/// The texts of man/tcbsample.1.in, man/tcbsample-curves.7.in and cli/completions/, put into the program by the build.
extern const char* const manual_template;
extern const char* const curves_template;
extern const char* const bash_template;
extern const char* const zsh_template;
extern const char* const fish_template;

/// What a value of an option is, as the tables name it.
std::string_view name_of_kind(const OptionRow& row);

/// Scripts that complete options and their values in a shell.
std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

/// The names of the columns of files, or of standard input, one per line. Throws: Error.
std::string columns_text(const std::vector<std::string>& files, bool positions_only);

/// A page of the manual, a completion script, the names of the columns of files, or the tables; without the last line
/// end.
std::string generated_text(Generated kind, const std::vector<std::string>& files = {});

}  // namespace tcb
