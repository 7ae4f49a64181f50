// Path text: a path as text.
#pragma once

#include <filesystem>
#include <string>

namespace tcb {

/// A path in UTF-8, as it is, but with slashes where the system also has other separators.
inline std::string path_text(const std::filesystem::path& path) {
  constexpr bool has_slashes = std::filesystem::path::preferred_separator == '/';
  return has_slashes ? path.string() : path.generic_string();
}

}  // namespace tcb
