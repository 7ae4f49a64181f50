// Delimiter of delimited text: found in the first record by a fixed rule, or named by the first line.
#include "read/csv/delimiter.hpp"

#include <algorithm>
#include <utility>

#include "read/csv/splitter.hpp"
#include "read/csv/tokenizer.hpp"
#include "text/suggest.hpp"

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

Beginning find_delimiter(const Source<std::string>& bytes, const DelimitedOptions& options) {
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
    const std::optional<char> delimiter = delimiter_of(record, options.marks.decimal);
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

}  // namespace tcb
