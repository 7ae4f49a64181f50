// Endings of file names, in upper or lower case, and those of compressed files.
#pragma once

#include <string_view>

namespace tcb {

/// Whether the last name of a path ends in `ending`, which is in lower case, and is longer than that.
bool has_ending(std::string_view path, std::string_view ending);

/// The ending of compressed files that a path has, .gz or .zst in lower case; empty: it has none.
std::string_view compression_ending(std::string_view path);

/// The path without that ending.
std::string_view without_compression(std::string_view path);

}  // namespace tcb
