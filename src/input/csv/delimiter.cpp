// Which delimiter delimited text has: found in its first record, by a fixed rule.
#include "input/csv/delimiter.hpp"

#include <algorithm>

#include "input/csv/splitter.hpp"

namespace tcb {
namespace {

/// Passes over lines before the first record: blank ones, comments, and those that set curves apart.
class Preamble {
 public:
  explicit Preamble(std::string comment) : any_{' ', std::move(comment)} {}

  /// Drops whole lines from the beginning, but for a comment that the first record may follow.
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

  /// Where the first record begins, once it is there.
  std::size_t record() const { return at_; }

 private:
  /// The line at hand without blanks at its ends.
  std::string_view content(std::string_view text, std::size_t end) const {
    std::string_view line = text.substr(at_, end - at_);
    while (!line.empty() && Dialect::is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && (Dialect::is_blank(line.back()) || line.back() == '\r')) line.remove_suffix(1);
    return line;
  }

  Dialect any_;
  std::size_t at_ = 0, kept_ = 0;
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

}  // namespace tcb
