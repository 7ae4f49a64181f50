// Places in text: lines, and columns counted in characters of UTF-8.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace tcb {

/// How many line ends a text has.
inline std::uint64_t count_lines(std::string_view text) {
  return static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
}

/// The column behind a text that begins in the given one.
inline std::uint64_t column_after(std::string_view text, std::uint64_t column) {
  const std::size_t last = text.rfind('\n');
  if (last != std::string_view::npos) {
    text.remove_prefix(last + 1);
    column = 1;
  }
  constexpr unsigned continues = 0x80, mask = 0xC0;  // the bytes of a character after its first
  const auto characters =
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & mask) != continues; });
  return column + static_cast<std::uint64_t>(characters);
}

/// A line and a column in it.
struct LinePosition {
  std::uint64_t line = 1;
  std::uint64_t column = 1;
};

/// The place behind a text that begins in the given one.
inline LinePosition place_after(std::string_view text, LinePosition place) {
  return {place.line + count_lines(text), column_after(text, place.column)};
}

}  // namespace tcb
