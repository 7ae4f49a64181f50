// Patterns of names, where * is any text and ? any character.
#pragma once

#include <cstddef>
#include <string_view>

namespace tcb {

/// Whether a name is one of the pattern's.
constexpr bool matches(std::string_view name, std::string_view pattern) {
  std::size_t star = std::string_view::npos, retry = 0, at = 0, next = 0;  // retry: what follows the last *
  while (at < name.size()) {
    if (next < pattern.size() && pattern[next] == '*') {
      star = next++;
      retry = at;
    } else if (next < pattern.size() && (pattern[next] == '?' || pattern[next] == name[at])) {
      ++at;
      ++next;
    } else if (star != std::string_view::npos) {
      next = star + 1;
      at = ++retry;
    } else {
      return false;
    }
  }
  while (next < pattern.size() && pattern[next] == '*') ++next;
  return next == pattern.size();
}

}  // namespace tcb
