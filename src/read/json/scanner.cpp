// JSON scanner: strings and brackets of a JSON text that is read piece by piece.
#include "read/json/scanner.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "text/utf8.hpp"

namespace tcb {
namespace {

/// The characters that determine where records end.
constexpr std::array<bool, 256> is_structure = [] {
  std::array<bool, 256> found{};
  for (const char c : std::string_view("\"[]{},\n")) found[static_cast<unsigned char>(c)] = true;
  return found;
}();

}  // namespace

bool is_json_blank(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return is_json_blank(c); });
}

void JsonScanner::skip_blanks() {
  while (at != text_.size() && is_json_blank(text_[at])) ++at;
}

bool JsonScanner::skip_to_structure() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* now = begin + at;
  for (;;) {
    if (in_string) {
      at = static_cast<std::size_t>(now - begin);
      if (!skip_string()) return false;
      now = begin + at;
    }
    while (now != end && !is_structure[static_cast<unsigned char>(*now)]) ++now;
    in_string = now != end && *now == '"';
    if (!in_string) break;
    ++now;
  }
  at = static_cast<std::size_t>(now - begin);
  return now != end;
}

void JsonScanner::skip_plain_object() {
  // Without another brace and without a backslash, quotes come in pairs up to a brace outside of strings.
  const std::size_t end = text_.find('}', at);
  if (end == std::string::npos) return;
  std::uint8_t odd = 0, doubtful = 0;
  for (const char c : view().substr(at + 1, end - at - 1)) {
    odd = static_cast<std::uint8_t>(odd ^ static_cast<std::uint8_t>(c == '"'));
    doubtful = static_cast<std::uint8_t>(doubtful | static_cast<std::uint8_t>(c == '{') |
                                         static_cast<std::uint8_t>(c == '\\'));
  }
  if (odd == 0 && doubtful == 0) at = end - 1;
}

bool JsonScanner::skip_string() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* const quote = find_closing_quote(begin + at, end, escaped_);
  in_string = quote == end;
  at = static_cast<std::size_t>(quote - begin) + (in_string ? 0 : 1);
  return !in_string;
}

Chunk JsonScanner::take(std::size_t end) {
  std::string rest = text_.substr(end);
  text_.resize(end);
  Chunk chunk{std::exchange(text_, std::move(rest)), line, column};
  column = column_after(chunk.text, column);
  line += count_lines(chunk.text);
  at -= std::min(at, end);
  return chunk;
}

}  // namespace tcb
