// Splitter of delimited text: its delimiter, and chunks cut between records.
#include "read/csv/splitter.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "read/text_bytes.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

[[noreturn]] void refuse_long_record(std::uint64_t line) {
  throw data_error(
      "a record has more than 64 MiB; expected a line for each key; break the lines, or close a quote that was left "
      "open")
      .at({"", line, 1});
}

/// Cuts text into whole records.
class RecordSplitter {
 public:
  RecordSplitter(Source<std::string> bytes, Dialect dialect, std::uint64_t line)
      : bytes_(std::move(bytes)), dialect_(std::move(dialect)), line_(line) {}

  /// All records that were read whole, or one once it is.
  std::optional<Chunk> next() {
    at_ = end_ = 0;
    while (pass_record()) end_ = at_;
    if (end_ == 0) end_ = text_.size();  // at the end of the input
    if (end_ == 0) return std::nullopt;
    std::string rest = text_.substr(end_);
    text_.resize(end_);
    Chunk chunk{std::exchange(text_, std::move(rest)), line_};
    line_ += count_lines(chunk.text);
    return chunk;
  }

 private:
  /// Reads on; false at the end of the input, and where whole records are to be cut off first.
  bool read_more() {
    if (end_ > 0 || is_input_read_) return false;
    if (text_.size() > longest_record) refuse_long_record(line_);
    is_input_read_ = !bytes_.append_to(text_, {line_, 1});
    return !is_input_read_;
  }
  bool has_more() {
    while (at_ == text_.size()) {
      if (!read_more()) return false;
    }
    return true;
  }

  /// Goes past a record, or lines without quotes, each of which is one; false if the text ends before that.
  bool pass_record() {
    if (!has_more()) return false;
    const std::size_t line_end = text_.rfind('\n', text_.find('"', at_));
    if (line_end != std::string::npos && line_end >= at_) return at_ = line_end + 1, true;
    while (has_more() && Dialect::is_blank(text_[at_])) ++at_;
    const std::string& comment = dialect_.comment;
    while (comment.size() > text_.size() - at_ && comment.starts_with(std::string_view(text_).substr(at_))) {
      if (!read_more()) break;
    }
    const std::string_view line = std::string_view(text_).substr(at_);
    // The other bytes of a comment have no effect, and those of a line with text after a quoted cell, which is an
    // error.
    bool is_rest = dialect_.is_comment(line) || dialect_.is_divider(line), begins_cell = true, is_quoted = false;
    for (; has_more(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') return ++at_, true;
      if (is_rest) continue;
      if (c == dialect_.delimiter || (dialect_.delimiter == ' ' && c == '\t')) {
        begins_cell = true;
        is_quoted = false;
      } else if (c == '"' && begins_cell) {
        if (!pass_quoted()) return false;
        begins_cell = false;
        is_quoted = true;
      } else if (!Dialect::is_blank(c)) {
        begins_cell = false;
        is_rest = is_quoted;
      }
    }
    return false;
  }

  /// Goes from the first quote of a cell to its last one, which none follows.
  bool pass_quoted() {
    for (++at_;; at_ += 2) {
      do {
        at_ = std::min(text_.find('"', at_), text_.size());
      } while (at_ + 1 >= text_.size() && read_more());
      if (at_ + 1 >= text_.size()) return false;
      if (text_[at_ + 1] != '"') return true;
    }
  }

  TextBytes bytes_;
  Dialect dialect_;
  std::string text_;              ///< read and not yet cut off
  std::size_t at_ = 0, end_ = 0;  ///< scanned up to here; the end of the last whole record
  std::uint64_t line_;            ///< of the text
  bool is_input_read_ = false;    ///< to its end
};

}  // namespace

std::optional<char> delimiter_of(std::string_view record, char decimal) {
  std::string seen;
  bool quoted = false, ended = false, has_bars = true;
  for (std::size_t at = 0; at < record.size() && !ended; ++at) {
    const char c = record[at];
    if (c == '"') quoted = !quoted;
    ended = c == '\n' && !quoted;
    if (ended || quoted) continue;
    if (seen.find(c) == std::string::npos) seen += c;
    const auto is_blank_at = [&](std::size_t i) {
      return i >= record.size() || std::string_view(" \t\r\n").find(record[i]) != std::string_view::npos;
    };
    if (c == '|') has_bars = has_bars && is_blank_at(at - 1) == is_blank_at(at + 1);  // unlike those of |v|
  }
  if (!ended) return std::nullopt;
  for (const char delimiter : std::string_view(decimal == ',' ? "\t;| " : "\t;,| ")) {
    if (delimiter == '|' && !has_bars) continue;
    if (seen.find(delimiter) != std::string::npos) return delimiter;
  }
  return ',';
}

Beginning find_delimiter(const Source<std::string>& bytes, std::optional<char> known, const DelimitedOptions& options) {
  const Dialect any{' ', options.comment};
  Beginning beginning;
  std::string& text = beginning.text;
  std::optional<std::size_t> last;  // where the line above the record is, if it is a comment
  for (std::size_t record = 0;;) {
    const std::size_t before = text.size();
    const bool more = append_next(text, bytes);
    if (text.size() > longest_record) refuse_long_record(beginning.line);
    if (more && text.find('\n', before) == std::string::npos) continue;
    std::size_t kept = 0;  // from here on: without the lines before the record, but for two comments directly above it
    for (std::size_t end = 0; (end = text.find('\n', record)) != std::string::npos; record = end + 1) {
      const std::string_view line = trimmed(std::string_view(text).substr(record, end - record));
      const bool is_comment = any.is_comment(line);
      const bool has_nul = line.find('\0') != std::string_view::npos;  // an error, also in a comment
      if (has_nul || (!is_comment && !line.empty() && !any.is_divider(line))) break;
      if (is_comment || line.empty()) {
        kept = is_comment ? last.value_or(record) : end + 1;
        last = is_comment ? std::optional(record) : std::nullopt;
      }
    }
    if (last) *last -= kept;
    beginning.line += count_lines(std::string_view(text).substr(0, kept));
    text.erase(0, kept);
    record -= kept;
    if (!more) text += '\n';  // the last record may lack its line end
    const std::optional<char> delimiter =
        known ? known : delimiter_of(std::string_view(text).substr(record), options.marks.decimal);
    if (!more) text.pop_back();
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
  const auto is_open = [&] {
    return may_name() && beginning.find('\n') == std::string::npos && beginning.size() < name.size() + 3;
  };
  while (is_open() && append_next(beginning, bytes)) {
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

Source<Chunk> split_delimited(Source<std::string> bytes, const Dialect& dialect, std::uint64_t line) {
  const auto splitter = std::make_shared<RecordSplitter>(std::move(bytes), dialect, line);
  return [splitter] { return splitter->next(); };
}

}  // namespace tcb
