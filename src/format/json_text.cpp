// JSON text as it comes: read on, looked at character by character, cut off, with its place.
#include "format/json_text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "error.hpp"
#include "format/place.hpp"
#include "format/refusal.hpp"

namespace tcb::format {
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
  const char* now = begin + at;
  const char* const end = begin + text_.size();
  while (now != end && !telling[static_cast<unsigned char>(*now)]) ++now;
  at = static_cast<std::size_t>(now - begin);
  return now != end;
}

bool JsonText::skip_string() {
  for (; at < text_.size(); ++at) {
    if (std::exchange(escaped_, false)) continue;
    escaped_ = text_[at] == '\\';
    if (text_[at] != '"') continue;
    in_string = false;
    ++at;
    return true;
  }
  return false;
}

Chunk JsonText::take(std::size_t end) {
  Chunk chunk{text_.substr(0, end), line, column};
  column = column_after(chunk.text, column);
  line += count_lines(chunk.text);
  text_.erase(0, end);
  at -= std::min(at, end);
  return chunk;
}

bool JsonText::read_more(const char* too_much) {
  if (text_.size() > longest_part) refuse(too_much);
  const std::optional<std::string> more = bytes_();
  if (!more) return false;
  text_ += *more;
  const std::size_t nul = more->find('\0');
  if (nul == std::string::npos) return true;
  const LinePlace place = place_after(view().substr(0, text_.size() - more->size() + nul), {line, column});
  throw Error(Exit::data, Place{"", place.line, place.column}, nul_byte());
}

void JsonText::refuse(const char* message) const { throw Error(Exit::data, Place{"", line, column}, message); }

}  // namespace tcb::format
