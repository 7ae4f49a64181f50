// Text lines: the lines of a text as words, and numbers in them with their decimals.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "numbers/parse_number.hpp"
#include "read/scenes/track_channel.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// The lines of the text of a product, one after the other.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  /// Reads the next line that is not blank; false at the end.
  bool next() {
    words_.clear();
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      line_ = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      const std::size_t first = line_.find_first_not_of(" \t\r");
      if (first == std::string_view::npos) continue;
      line_ = line_.substr(first, line_.find_last_not_of(" \t\r") + 1 - first);
      for (std::size_t at = 0; at < line_.size();) {
        const std::size_t stop = std::min(line_.find_first_of(" \t", at), line_.size());
        words_.push_back(line_.substr(at, stop - at));
        at = std::min(line_.find_first_not_of(" \t", stop), line_.size());
      }
      return true;
    }
    return false;
  }
  /// Throws: Error (data) at the end.
  void require_next() {
    if (!next()) throw file_ends_early().at({"", number_, 0});
  }

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : ""; }
  /// The line from a word on.
  std::string_view from_word(std::size_t i) const {
    return i < words_.size() ? line_.substr(static_cast<std::size_t>(words_[i].data() - line_.data())) : "";
  }
  std::uint64_t number() const { return number_; }
  Error at(const Error& error) const { return error.at({"", number_, 0}); }

  /// A word as a number or a count. Throws: Error (data) for another one.
  WrittenNumber number_in(std::size_t i) const {
    const auto value = parse_number(word(i));
    if (!value) throw at(number_of_file_expected(word(i)));
    return {*value, std::string(word(i))};
  }
  std::size_t count_in(std::size_t i) const {
    const auto count = in_digits<std::size_t>(word(i));
    if (!count) throw at(count_of_file_expected(word(i)));
    return *count;
  }
  /// Throws: Error (data) where a word is beyond those of a key.
  void require_end(std::size_t i) const {
    if (i < words_.size()) {
      throw at(data_error("{} follows the numbers of the key; expected the end of the line; correct the file",
                          in_quotes(from_word(i))));
    }
  }

 private:
  std::string_view text_, line_;
  std::vector<std::string_view> words_;
  std::uint64_t number_ = 0;
};

}  // namespace tcb
