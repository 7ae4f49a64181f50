// Text lines: the lines of a text as words, and numbers in them with their decimals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/written_number.hpp"

namespace tcb {

/// The lines of the text of a product, one after the other.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  /// Reads the next line that is not blank; false at the end.
  bool next();
  /// Throws: Error (data) at the end.
  void require_next();

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : ""; }
  /// The line from a word on.
  std::string_view from_word(std::size_t i) const;
  std::uint64_t number() const { return number_; }
  Error at(const Error& error) const { return error.at({"", number_, 0}); }

  /// A word as a number or a count. Throws: Error (data) for another one.
  WrittenNumber number_in(std::size_t i) const;
  std::size_t count_in(std::size_t i) const;

 private:
  std::string_view text_, line_;
  std::vector<std::string_view> words_;
  std::uint64_t number_ = 0;
};

}  // namespace tcb
