// JSON text as it comes: read on, looked at character by character, cut off, with its place.
#include "format/json_text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "error.hpp"
#include "format/place.hpp"

namespace tcb::format {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t longest_part = 64UL * 1024 * 1024;

/// The characters that tell where keys end; between them lie most of the others.
constexpr std::array<bool, 256> telling = [] {
  std::array<bool, 256> is_telling{};
  for (const char c : std::string_view("\"[]{},\n")) is_telling[static_cast<unsigned char>(c)] = true;
  return is_telling;
}();

}  // namespace

bool JsonText::is_blank() const { return text_.find_first_not_of(blanks) == std::string::npos; }

void JsonText::skip_blanks() { at = std::min(text_.find_first_not_of(blanks, at), text_.size()); }

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
  std::optional<std::string> more = bytes_();
  if (more) text_ += *more;
  return more.has_value();
}

void JsonText::refuse(const char* message) const { throw Error(Exit::data, Place{"", line, column}, message); }

}  // namespace tcb::format
