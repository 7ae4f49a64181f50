// Invariants: conditions that must hold for every input; a violation is a crash, which the fuzzer reports.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "text/utf8.hpp"

namespace tcb::fuzz {

inline void require(bool holds, std::string_view what, std::string_view seen) {
  if (holds) return;
  const std::string text = fmt::format("{}:\n{}\n", what, seen);
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  std::abort();
}

inline void require_same(std::string_view one, std::string_view other, std::string_view what) {
  if (one != other) require(false, what, fmt::format("one:\n{}\nother:\n{}", one, other));
}

/// An error fits a terminal: at most ten lines of UTF-8 and one that says that there are more, each with the name of
/// the file or the program.
inline void require_refusal(std::string_view text, std::string_view file) {
  require(find_invalid_utf8(text) == std::string_view::npos, "a refusal is not UTF-8", text);
  std::size_t lines = 0;
  for (std::string_view left = text; !left.empty(); ++lines) {
    const std::string_view line = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(left.size(), line.size() + 1));
    const bool named = line.starts_with(file) || line.starts_with("tcbsample:");
    require(named && line.find(": error: ") != std::string_view::npos, "a refusal without a place", text);
    const bool plain = std::ranges::none_of(line, [](char c) { return static_cast<unsigned char>(c) < ' '; });
    require(plain, "a refusal with control characters", text);
  }
  const bool has_more = text.find(": error: further errors are not shown") != std::string_view::npos;
  require(lines >= 1 && lines <= (has_more ? 11U : 10U), "not one to ten faults", text);
}

}  // namespace tcb::fuzz
