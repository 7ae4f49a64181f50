// Completions: scripts for bash, zsh and fish, made from the table of options, and the columns that they offer.
#pragma once

#include <string>
#include <vector>

namespace tcb {

/// Scripts that complete options and their values in a shell.
std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

/// The names of the columns of files, or of standard input, one per line. Throws: Error.
std::string columns_text(const std::vector<std::string>& files, bool positions_only);

}  // namespace tcb
