// Splitter of delimited text: chunks cut between records.
#include "read/csv/splitter.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "read/text_bytes.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

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

void refuse_long_record(std::uint64_t line) {
  throw data_error(
      "a record has more than 64 MiB; expected a line for each key; break the lines, or close a quote that was "
      "left open")
      .at({"", line, 1});
}

Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line) {
  const auto splitter = std::make_shared<RecordSplitter>(std::move(bytes), dialect, line);
  return [splitter] { return splitter->next(); };
}

}  // namespace tcb
