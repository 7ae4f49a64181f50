// Endings of file names.
#include "text/file_ending.hpp"

#include <algorithm>

namespace tcb {

bool has_ending(std::string_view path, std::string_view ending) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  if (path.size() <= ending.size() || path[path.size() - ending.size() - 1] == '/') return false;
  return std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, lower);
}

std::string_view compression_ending(std::string_view path) {
  for (const std::string_view ending : {".gz", ".zst"}) {
    if (has_ending(path, ending)) return ending;
  }
  return "";
}

std::string_view without_compression(std::string_view path) {
  return path.substr(0, path.size() - compression_ending(path).size());
}

}  // namespace tcb
