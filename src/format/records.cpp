// Delimited records: where they end, and which cells they have.
#include "format/records.hpp"

#include <algorithm>

#include "format/place.hpp"

namespace tcb::format {
namespace {

constexpr std::size_t longest_record = 64UL * 1024 * 1024;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// The quote that ends the quoted cell begun at `open`, or npos.
std::size_t closing_quote(std::string_view text, std::size_t open) {
  for (std::size_t at = text.find('"', open + 1); at != std::string_view::npos; at = text.find('"', at + 2)) {
    if (at + 1 == text.size() || text[at + 1] != '"') return at;
  }
  return std::string_view::npos;
}

/// The line end of the record or comment that begins at `at`, or npos.
std::size_t end_of_record(std::string_view text, std::size_t at, const Dialect& dialect) {
  while (at < text.size() && is_blank(text[at])) ++at;
  if (!dialect.comment.empty() && text.substr(at).starts_with(dialect.comment)) return text.find('\n', at);
  for (bool cell_begins = true; at < text.size() && text[at] != '\n'; ++at) {
    if (cell_begins && text[at] == '"') {
      at = closing_quote(text, at);
      if (at == std::string_view::npos) return at;
    }
    const bool delimits = text[at] == dialect.delimiter || (dialect.delimiter == ' ' && text[at] == '\t');
    cell_begins = delimits || (cell_begins && is_blank(text[at]));
  }
  return at < text.size() ? at : std::string_view::npos;
}

/// Where the last whole record of a text ends, 0 if there is none.
std::size_t end_of_records(std::string_view text, const Dialect& dialect) {
  if (text.find('"') == std::string_view::npos) return text.rfind('\n') + 1;  // npos + 1 is 0
  std::size_t end = 0;
  for (std::size_t at = end_of_record(text, 0, dialect); at != std::string_view::npos;
       at = end_of_record(text, end, dialect)) {
    end = at + 1;
  }
  return end;
}

}  // namespace

Source<Chunk> split_delimited(Source<std::string> bytes, Dialect dialect) {
  return [bytes = std::move(bytes), dialect = std::move(dialect), rest = std::string(),
          line = std::uint64_t{1}]() mutable -> std::optional<Chunk> {
    for (;;) {
      std::optional<std::string> more = bytes();
      rest += more.value_or("");
      const std::size_t end = more ? end_of_records(rest, dialect) : rest.size();
      if (end == 0 && !more) return std::nullopt;
      if (end == 0 && rest.size() > longest_record) {
        throw Error(Exit::data, Place{"", line, 1},
                    "a record of more than 64 MiB; a quote may have been opened and not closed; close it");
      }
      if (end == 0) continue;
      Chunk chunk{rest.substr(0, end), line, 0};
      rest.erase(0, end);
      line += count_lines(chunk.text);
      return chunk;
    }
  };
}

Records::Records(const Chunk& chunk, const Dialect& dialect)
    : dialect_(dialect),
      begin_(chunk.text.data()),
      at_(begin_),
      end_(begin_ + chunk.text.size()),
      record_(begin_),
      line_(chunk.line),
      record_line_(chunk.line) {}

void Records::pass_line_end() {
  if (at_ != end_ && *at_ == '\r') ++at_;
  if (at_ != end_) ++at_;
  ++line_;
}

bool Records::skip_to_record() {
  for (; at_ != end_; pass_line_end()) {
    record_ = at_;
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const std::string_view left(at_, static_cast<std::size_t>(end_ - at_));
    if (!dialect_.comment.empty() && left.starts_with(dialect_.comment)) {
      const std::size_t size = std::min(left.find('\n'), left.size());
      comment_ = left.substr(0, size);
      at_ += size;
    } else if (at_line_end()) {
      comment_ = {};
    } else {
      at_ = record_;
      return true;
    }
  }
  return false;
}

std::string_view Records::find_record() {
  (void)skip_to_record();
  return {at_, static_cast<std::size_t>(end_ - at_)};
}

bool Records::next(std::vector<std::string_view>& cells) {
  cells.clear();
  comment_ = {};
  if (!skip_to_record()) return false;
  record_line_ = line_;
  const bool blanks = dialect_.delimiter == ' ';
  for (;;) {
    while (!at_line_end() && is_blank(*at_) && *at_ != dialect_.delimiter) ++at_;
    while (blanks && !at_line_end() && is_blank(*at_)) ++at_;
    if (blanks && at_line_end()) break;
    cells.push_back(take_cell());
    if (at_line_end()) break;
    ++at_;  // the delimiter
    if (!blanks && at_line_end()) {
      cells.emplace_back(at_, 0U);
      break;
    }
  }
  pass_line_end();
  return true;
}

std::string_view Records::take_cell() {
  const char* const start = at_;
  if (*at_ == '"') return take_quoted();
  const bool blanks = dialect_.delimiter == ' ';
  while (!at_line_end() && *at_ != dialect_.delimiter && !(blanks && *at_ == '\t')) ++at_;
  const char* last = at_;
  while (last != start && is_blank(last[-1])) --last;
  return {start, static_cast<std::size_t>(last - start)};
}

std::string_view Records::take_quoted() {
  const char* const start = at_;
  for (++at_; at_ != end_; ++at_) {
    if (*at_ == '\n') ++line_;
    if (*at_ != '"') continue;
    if (at_ + 1 == end_ || at_[1] != '"') break;
    ++at_;
  }
  if (at_ == end_) {
    throw Error(Exit::data, place({start, 1}), "a quoted cell is not closed; expected \" at its end; add it");
  }
  const std::string_view cell(start, static_cast<std::size_t>(++at_ - start));
  while (!at_line_end() && is_blank(*at_) && *at_ != dialect_.delimiter) ++at_;
  if (!at_line_end() && *at_ != dialect_.delimiter && !is_blank(*at_)) {
    throw Error(Exit::data, place({at_, 1}),
                "text after a quoted cell; expected the delimiter or the line's end; double the quotes inside a cell");
  }
  return cell;
}

Place Records::place(std::string_view cell) const {
  const std::string_view before(record_, static_cast<std::size_t>(cell.data() - record_));
  return {"", record_line_ + count_lines(before), column_after(before, 1)};
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

std::optional<char> find_delimiter(std::string_view text, const std::string& comment) {
  const Chunk chunk{std::string(text)};
  const Dialect any{'\n', comment};
  const std::string_view record = Records(chunk, any).find_record();
  std::string seen;
  bool quoted = false, ended = false;
  for (const char c : record) {
    if (c == '"') quoted = !quoted;
    ended = c == '\n' && !quoted;
    if (ended) break;
    if (!quoted) seen += c;
  }
  if (!ended) return std::nullopt;
  for (const char delimiter : {'\t', ';', ',', ' '}) {
    if (seen.find(delimiter) != std::string::npos) return delimiter;
  }
  return ',';
}

}  // namespace tcb::format
