// Where the keys are in JSON text: it is cut between key objects, without looking into them.
#include "format/json_split.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "format/place.hpp"

namespace tcb::format {
namespace {

constexpr std::string_view white_space = " \t\r\n";

bool is_blank(std::string_view text) { return text.find_first_not_of(white_space) == std::string_view::npos; }

}  // namespace

void JsonSplitter::advance_place(std::string_view text) {
  column_ = column_after(text, column_);
  line_ += count_lines(text);
}

bool JsonSplitter::read_more() {
  std::optional<std::string> more = bytes_();
  if (more) text_ += *more;
  return more.has_value();
}

/// Cuts text_ off at `end`.
Chunk JsonSplitter::take(std::size_t end) {
  Chunk chunk{text_.substr(0, end), line_, column_};
  advance_place(chunk.text);
  text_.erase(0, end);
  at_ -= std::min(at_, end);
  boundary_ = 0;
  return chunk;
}

void JsonSplitter::start_list(Shape shape) {
  shape_ = shape;
  if (shape == Shape::wrapped) {
    envelope_ = take(at_);
    envelope_.text += '[';
  } else {
    (void)take(at_);
  }
}

void JsonSplitter::scan_string() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\\') {
      ++at_;  // the next character is part of the string, whatever it is
    } else if (text_[at_] == '"') {
      in_string_ = false;
      if (depth_ == 1 && shape_ == Shape::unknown) member_ = text_.substr(string_start_, at_ - string_start_);
      ++at_;
      return;
    }
  }
}

void JsonSplitter::open(char bracket) {
  if (shape_ == Shape::unknown && bracket == '[') {
    if (depth_ == 0)
      start_list(Shape::list);
    else if (depth_ == 1 && member_ == "keys")
      start_list(Shape::wrapped);
  }
  ++depth_;
}

void JsonSplitter::close() {
  if (depth_ > 0) --depth_;
  const std::size_t outside = shape_ == Shape::wrapped ? 1 : 0;
  if (depth_ != outside) return;
  if (shape_ == Shape::unknown) shape_ = Shape::lines;
  ++records_;
  if (shape_ == Shape::lines) return;  // they end with their lines
  boundary_ = at_ + 1;
  list_closed_ = true;
}

/// Scans to the end of the text, or of the list of keys.
void JsonSplitter::scan() {
  while (at_ < text_.size() && !list_closed_) {
    if (in_string_) {
      scan_string();
      continue;
    }
    switch (text_[at_]) {
      case '"':
        in_string_ = true;
        string_start_ = at_ + 1;
        break;
      case '{':
      case '[': open(text_[at_]); break;
      case '}':
      case ']': close(); break;
      case ',':
        if (depth_ == (shape_ == Shape::wrapped ? 2U : 1U) && (shape_ == Shape::list || shape_ == Shape::wrapped)) {
          boundary_ = at_;
          ++records_;
        }
        break;
      case '\n':
        if (shape_ == Shape::lines && depth_ == 0) boundary_ = at_ + 1;
        break;
      default: break;
    }
    ++at_;
  }
}

/// The records up to the last boundary, as a JSON array or as lines; all that is left `at_end`.
std::optional<Chunk> JsonSplitter::cut(bool at_end) {
  const std::size_t end = at_end ? text_.size() : boundary_;
  if (end == 0) return std::nullopt;
  Chunk chunk = take(end);
  chunk.first = std::exchange(records_cut_, records_);
  if (shape_ == Shape::list || shape_ == Shape::wrapped) {
    // The text begins with the bracket or the comma before its first record, and ends after its last
    // one, or with the closing bracket.
    const bool empty_list = first_cut_ && list_closed_ && is_blank(std::string_view(chunk.text).substr(1, end - 2));
    chunk.text[0] = '[';
    if (!list_closed_ && !at_end) chunk.text += ']';
    first_cut_ = false;
    if (empty_list) return std::nullopt;
  }
  return chunk;
}

std::optional<Chunk> JsonSplitter::next() {
  while (!list_closed_) {
    scan();
    if (auto chunk = cut(false)) return chunk;
    if (list_closed_) break;
    if (read_more()) continue;
    return is_blank(text_) ? std::nullopt : cut(true);
  }
  while (read_more()) {
  }
  if (wrapped()) {
    // White space in place of the keys leaves the rest where it stands in the file.
    const std::uint64_t line = envelope_.line + count_lines(envelope_.text);
    const std::uint64_t column = line < line_ ? 1 : column_after(envelope_.text, envelope_.column);
    envelope_.text.append(line_ - line, '\n').append(column_ - 1 - column, ' ') += "]" + text_;
    text_.clear();
  }
  if (!is_blank(text_)) {
    advance_place(std::string_view(text_).substr(0, text_.find_first_not_of(white_space)));
    throw Error(Exit::data, Place{"", line_, column_},
                "text after the end of the JSON array; expected nothing more; take it out");
  }
  return std::nullopt;
}

}  // namespace tcb::format
