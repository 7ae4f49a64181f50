// Splitter of delimited text: the delimiter, found by a fixed rule, and chunks cut between records.
#include <algorithm>
#include <memory>
#include <utility>

#include "read/csv/delimited_text.hpp"
#include "read/csv/errors.hpp"
#include "read/text_bytes.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// Skips lines before the first record: blank ones, comments, and those between curves.
class Preamble {
 public:
  explicit Preamble(std::string comment) : any_{' ', std::move(comment)} {}

  /// Drops whole lines from the beginning, except a comment that may be directly above the first record.
  void skip(Beginning& beginning) {
    for (std::size_t end = 0; (end = beginning.text.find('\n', at_)) != std::string::npos; at_ = end + 1) {
      const std::string_view line = content(beginning.text, end);
      const bool comment = any_.is_comment(line);
      if (!comment && !line.empty() && !any_.is_divider(line)) break;
      if (comment || line.empty()) kept_ = comment ? at_ : end + 1;
    }
    const auto dropped = beginning.text.begin() + static_cast<std::ptrdiff_t>(kept_);
    beginning.line += static_cast<std::uint64_t>(std::count(beginning.text.begin(), dropped, '\n'));
    beginning.text.erase(beginning.text.begin(), dropped);
    at_ -= std::exchange(kept_, 0);
  }

  /// The start of the first record, once it was read.
  std::size_t record() const { return at_; }

 private:
  /// The current line without leading and trailing blanks.
  std::string_view content(std::string_view text, std::size_t end) const {
    std::string_view line = text.substr(at_, end - at_);
    while (!line.empty() && Dialect::is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && (Dialect::is_blank(line.back()) || line.back() == '\r')) line.remove_suffix(1);
    return line;
  }

  Dialect any_;
  std::size_t at_ = 0, kept_ = 0;
};

/// Finds the ends of records in text that grows; it reads each byte once.
class RecordEnds {
 public:
  explicit RecordEnds(Dialect dialect) : dialect_(std::move(dialect)) {}

  /// Where the last whole record of the text ends, 0 if there is none. Requires: the text continues the last one.
  std::size_t last_end(std::string_view text) {
    const std::string_view fresh = text.substr(at_);
    if (state_ != State::quoted && state_ != State::quote && fresh.find('"') == std::string_view::npos) {
      skip_lines(fresh);
    }
    while (at_ < text.size() && step(text)) {
    }
    return std::exchange(end_, 0);
  }

  /// The text was cut off at the end that was found.
  void cut(std::size_t end) { at_ -= end; }

 private:
  /// In `rest` the bytes of the line have no effect: it is a comment, or text after a quoted cell, which is an error.
  enum class State { line_start, rest, cell_start, cell, quoted, quote, closed };

  /// Without quotes, a record ends with its line.
  void skip_lines(std::string_view fresh) {
    const std::size_t line_end = fresh.rfind('\n');
    if (line_end == std::string_view::npos) return;
    at_ += line_end + 1;
    end_ = at_;
    state_ = State::line_start;
  }

  /// Takes one step; false if it needs more text.
  bool step(std::string_view text) {
    const char c = text[at_];
    switch (state_) {
      case State::line_start: return start_line(text.substr(at_));
      case State::quoted:
        at_ = std::min(text.find('"', at_), text.size());
        if (at_ == text.size()) return false;
        state_ = State::quote;
        break;
      case State::quote:  // it ends the cell, unless another one follows
        state_ = c == '"' ? State::quoted : State::closed;
        if (c != '"') return true;
        break;
      case State::cell_start:
        if (c == '"') {
          state_ = State::quoted;
          break;
        }
        [[fallthrough]];
      case State::rest:
      case State::cell:
      case State::closed: pass(c);
    }
    ++at_;
    return true;
  }

  /// A character outside quotes.
  void pass(char c) {
    if (c == '\n') {
      end_ = at_ + 1;
      state_ = State::line_start;
    } else if (state_ != State::rest) {
      const bool delimits = c == dialect_.delimiter || (dialect_.delimiter == ' ' && c == '\t');
      const bool nothing = Dialect::is_blank(c) && state_ != State::cell;
      if (delimits) {
        state_ = State::cell_start;
      } else if (!nothing) {
        state_ = state_ == State::closed ? State::rest : State::cell;
      }
    }
  }

  bool start_line(std::string_view line) {
    if (line.size() < dialect_.comment.size() && dialect_.comment.starts_with(line)) return false;
    if (Dialect::is_blank(line[0])) {
      ++at_;
      return true;
    }
    state_ = dialect_.is_comment(line) || dialect_.is_divider(line) ? State::rest : State::cell_start;
    return true;
  }

  Dialect dialect_;
  State state_ = State::line_start;
  std::size_t at_ = 0, end_ = 0;
};

/// Cuts text into whole records.
class RecordSplitter {
 public:
  RecordSplitter(Source<std::string> bytes, Dialect dialect, std::uint64_t line)
      : bytes_(std::move(bytes)), ends_(std::move(dialect)), line_(line) {}

  std::optional<Chunk> next() {
    for (;;) {
      const bool more = bytes_.append_to(text_, {line_, 1});
      const std::size_t end = more ? ends_.last_end(text_) : text_.size();
      if (end == 0 && !more) return std::nullopt;
      if (end == 0 && text_.size() > longest_record) refuse_long_record(line_);
      if (end == 0) continue;
      std::string rest = text_.substr(end);
      text_.resize(end);
      Chunk chunk{std::exchange(text_, std::move(rest)), line_};
      ends_.cut(end);
      line_ += count_lines(chunk.text);
      return chunk;
    }
  }

 private:
  TextBytes bytes_;
  RecordEnds ends_;
  std::string text_;  ///< read and not yet cut off
  std::uint64_t line_;
};

}  // namespace

std::optional<char> delimiter_of(std::string_view record, char decimal) {
  std::string seen;
  bool quoted = false, ended = false;
  for (const char c : record) {
    if (c == '"') quoted = !quoted;
    ended = c == '\n' && !quoted;
    if (ended) break;
    if (!quoted && seen.find(c) == std::string::npos) seen += c;
  }
  if (!ended) return std::nullopt;
  for (const char delimiter : std::string_view(decimal == ',' ? "\t; " : "\t;, ")) {
    if (seen.find(delimiter) != std::string::npos) return delimiter;
  }
  return ',';
}

Beginning find_delimiter(const Source<std::string>& bytes, const InputOptions& options) {
  Beginning beginning;
  Preamble preamble(options.comment);
  for (;;) {
    const std::optional<std::string> more = bytes();
    beginning.text += more.value_or("");
    if (beginning.text.size() > longest_record) refuse_long_record(beginning.line);
    if (more && more->find('\n') == std::string::npos) continue;
    preamble.skip(beginning);
    std::string record = beginning.text.substr(preamble.record());
    if (!more) record += '\n';  // the last record may lack its line end
    const std::optional<char> delimiter = delimiter_of(record, options.decimal);
    beginning.delimiter = delimiter.value_or(',');
    if (delimiter || !more) return beginning;
  }
}

std::optional<char> take_named_delimiter(Source<std::string>& bytes) {
  constexpr std::string_view name = "sep=";
  std::string beginning;
  const auto may_name = [&] {
    const std::size_t size = std::min(beginning.size(), name.size());
    return same_in_any_case(std::string_view(beginning).substr(0, size), name.substr(0, size));
  };
  while (may_name() && beginning.find('\n') == std::string::npos && beginning.size() < name.size() + 3) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  const std::size_t end = std::min(beginning.find('\n'), beginning.size());
  std::string_view line = std::string_view(beginning).substr(0, end);
  if (line.ends_with('\r')) line.remove_suffix(1);
  const bool names = line.size() == name.size() + 1 && may_name() && end < beginning.size();
  const std::optional<char> delimiter = names ? std::optional(line.back()) : std::nullopt;
  if (names) beginning.erase(0, end + 1);
  bytes = preceded_by(std::move(beginning), std::move(bytes));
  return delimiter;
}

void refuse_long_record(std::uint64_t line) { throw record_too_long().at({"", line, 1}); }

Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line) {
  const auto splitter = std::make_shared<RecordSplitter>(std::move(bytes), dialect, line);
  return [splitter] { return splitter->next(); };
}

}  // namespace tcb
