// What the declaration of the options says to people and shells: help, manual page, completions.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace tcb {

/// The help, in 80 columns.
std::string help_text(const CLI::App& app);

std::string version_text();

/// The manual page, or a completion script for bash, zsh or fish. Throws: Error (usage) for another kind.
std::string generated_text(const CLI::App& app, std::string_view kind);

}  // namespace tcb
