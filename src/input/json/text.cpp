// JSON text as it comes: read on, looked at character by character, cut off, with its place.
#include "input/json/text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "error.hpp"
#include "text/text_position.hpp"

namespace tcb {
namespace {

bool is_white(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
constexpr std::size_t longest_part = 64UL * 1024 * 1024;

/// The characters that tell where keys end; between them lie most of the others.
constexpr std::array<bool, 256> telling = [] {
  std::array<bool, 256> is_telling{};
  for (const char c : std::string_view("\"[]{},\n")) is_telling[static_cast<unsigned char>(c)] = true;
  return is_telling;
}();

}  // namespace

bool JsonText::is_blank() const { return std::ranges::all_of(text_, is_white); }

void JsonText::skip_blanks() {
  while (at != text_.size() && is_white(text_[at])) ++at;
}

bool JsonText::skip_to_telling() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* now = begin + at;
  for (;;) {
    if (in_string) {
      at = static_cast<std::size_t>(now - begin);
      if (!skip_string()) return false;
      now = begin + at;
    }
    while (now != end && !telling[static_cast<unsigned char>(*now)]) ++now;
    in_string = now != end && *now == '"';
    if (!in_string) break;
    ++now;
  }
  at = static_cast<std::size_t>(now - begin);
  return now != end;
}

void JsonText::skip_plain_object() {
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

bool JsonText::skip_string() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* now = begin + at;
  if (now != end && std::exchange(escaped_, false)) ++now;
  while (now != end && *now != '"') {
    while (now != end && *now != '"' && *now != '\\') ++now;
    if (now == end || *now == '"') break;
    escaped_ = now + 1 == end;
    now += escaped_ ? 1 : 2;
  }
  in_string = now == end;
  at = static_cast<std::size_t>(now - begin) + (in_string ? 0 : 1);
  return !in_string;
}

Chunk JsonText::take(std::size_t end) {
  std::string rest = text_.substr(end);
  text_.resize(end);
  Chunk chunk{std::exchange(text_, std::move(rest)), line, column};
  column = column_after(chunk.text, column);
  line += count_lines(chunk.text);
  at -= std::min(at, end);
  return chunk;
}

bool JsonText::read_more(const char* too_much) {
  if (text_.size() > longest_part) refuse(too_much);
  return bytes_.append_to(text_, {line, column});
}

void JsonText::refuse(const char* message) const { throw Error(Exit::data, TextPosition{"", line, column}, message); }

}  // namespace tcb
