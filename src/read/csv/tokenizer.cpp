// Tokenizer of delimited text: records and their cells.
#include "read/csv/tokenizer.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "option_names.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

bool is_blank(char c) { return Dialect::is_blank(c); }

/// Sets the upper bit of the first of eight bytes that is zero, and of none before it; bits after it may be wrong.
/// Source: H. S. Warren, Hacker's Delight, ch. 6.
std::uint64_t zero_bytes(std::uint64_t bytes) { return (bytes - 0x0101010101010101) & ~bytes & 0x8080808080808080; }

/// The first of three characters, or the end.
const char* find_one(const char* at, const char* end, char a, char b, char c) {
  const auto eight = [](char each) { return std::uint64_t{0x0101010101010101} * static_cast<unsigned char>(each); };
  for (; end - at >= 8; at += 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof bytes);
    const std::uint64_t found =
        zero_bytes(bytes ^ eight(a)) | zero_bytes(bytes ^ eight(b)) | zero_bytes(bytes ^ eight(c));
    if (found != 0) return at + std::countr_zero(found) / 8;
  }
  while (at != end && *at != a && *at != b && *at != c) ++at;
  return at;
}

}  // namespace

Tokenizer::Tokenizer(const Chunk& chunk, const Dialect& dialect)
    : dialect_(dialect),
      begin_(chunk.text.data()),
      at_(begin_),
      end_(begin_ + chunk.text.size()),
      record_(begin_),
      line_(chunk.line),
      record_line_(chunk.line) {}

void Tokenizer::pass_line_end() {
  if (at_ != end_ && *at_ == '\r') ++at_;
  if (at_ != end_) ++at_;
  ++line_;
}

void Tokenizer::skip_line() {
  at_ = std::find(at_, end_, '\n');
  pass_line_end();
}

bool Tokenizer::skip_to_record() {
  for (; at_ != end_; pass_line_end()) {
    record_ = at_;
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const std::string_view left(at_, static_cast<std::size_t>(end_ - at_));
    const bool divides = dialect_.is_divider(left);
    if (divides || dialect_.is_comment(left)) {
      const std::size_t size = std::min(left.find('\n'), left.size());
      if (!divides) comment_ = left.substr(0, size);
      broken_ = broken_ || divides;
      at_ += size;
    } else if (at_line_end()) {
      comment_ = {};
      follows_blank_ = true;
      broken_ = broken_ || dialect_.divided || dialect_.delimiter == ' ';
    } else {
      at_ = record_;
      return true;
    }
  }
  return false;
}

bool Tokenizer::next(std::vector<std::string_view>& cells) {
  cells.clear();
  comment_ = {};
  broken_ = follows_blank_ = false;
  if (!skip_to_record()) return false;
  record_line_ = line_;
  const bool blanks = dialect_.delimiter == ' ';
  for (;;) {
    while (!at_line_end() && is_blank(*at_) && *at_ != dialect_.delimiter) ++at_;
    while (blanks && !at_line_end() && is_blank(*at_)) ++at_;
    if (blanks && at_line_end()) break;
    if (cells.size() == most_cells) refuse_cells();
    cells.push_back(take_cell());
    if (at_line_end()) break;
    ++at_;  // the delimiter, which another cell follows
  }
  pass_line_end();
  return true;
}

void Tokenizer::refuse_cells() {
  const TextPosition where = position({record_, 1});
  skip_line();
  throw data_error(
      "the record has more than {} cells; expected at most {}; correct the row, or give the "
      "delimiter with {}",
      most_cells, most_cells, option::delimiter)
      .at(where);
}

std::string_view Tokenizer::take_cell() {
  const char* const start = at_;
  if (*start == '"') return take_quoted();
  const char delimiter = dialect_.delimiter, other = delimiter == ' ' ? '\t' : delimiter;
  const char* const now = find_one(start, end_, delimiter, '\n', other);
  const bool at_end = now == end_ || *now == '\n';
  at_ = at_end && now != start && now[-1] == '\r' ? now - 1 : now;
  const char* last = at_;
  while (last != start && is_blank(last[-1])) --last;
  return {start, static_cast<std::size_t>(last - start)};
}

std::string_view Tokenizer::take_quoted() {
  const char* const start = at_;
  for (++at_; at_ != end_; ++at_) {
    if (*at_ == '\n') ++line_;
    if (*at_ != '"') continue;
    if (at_ + 1 == end_ || at_[1] != '"') break;
    ++at_;
  }
  if (at_ == end_)
    throw data_error("a quoted cell is not closed; expected \" at its end; add it").at(position({start, 1}));
  const std::string_view cell(start, static_cast<std::size_t>(++at_ - start));
  const bool blanks = dialect_.delimiter == ' ';  // blanks and tabs delimit
  while (!blanks && !at_line_end() && is_blank(*at_) && *at_ != dialect_.delimiter) ++at_;
  if (!at_line_end() && *at_ != dialect_.delimiter && !is_blank(*at_)) {
    const TextPosition where = position({at_, 1});
    skip_line();
    throw data_error(
        "text follows a quoted cell; expected the delimiter or the end of the line; double the quotes inside a cell")
        .at(where);
  }
  return cell;
}

TextPosition Tokenizer::position(std::string_view cell) const {
  const std::string_view before(record_, static_cast<std::size_t>(cell.data() - record_));
  return {"", record_line_ + count_lines(before), column(cell)};
}

std::uint64_t Tokenizer::column(std::string_view cell) const {
  return column_after({record_, static_cast<std::size_t>(cell.data() - record_)}, 1);
}

std::string unquoted(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"') return std::string(cell);
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"') ++i;
  }
  return text;
}

}  // namespace tcb
