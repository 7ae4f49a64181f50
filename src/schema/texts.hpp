// Texts of keys: groups and labels, and many texts in one string.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

/// A text of a key begins with a quote if it is a string; otherwise it is a number or a word of JSON, or empty if it is
/// missing. So it can be written as a cell and as JSON, whatever its format was.
inline bool is_string(std::string_view text) { return text.starts_with('"'); }

/// The characters of a text of a key, without the quote.
inline std::string_view content(std::string_view text) { return is_string(text) ? text.substr(1) : text; }

/// The characters of a group's texts, without their kinds, which differ between formats.
inline std::vector<std::string> contents(const std::vector<std::string>& group) {
  std::vector<std::string> texts;
  texts.reserve(group.size());
  for (const std::string& text : group) texts.emplace_back(content(text));
  return texts;
}

/// NAME=VALUE for each column of a group.
inline std::vector<std::string> group_title(const std::vector<std::string>& names,
                                            const std::vector<std::string>& group) {
  std::vector<std::string> title;
  for (std::size_t i = 0; i < group.size() && i < names.size(); ++i) {
    title.push_back(names[i] + "=" + std::string(content(group[i])));
  }
  return title;
}

/// Adds a cell in quotes to delimited text. Source: RFC 4180.
inline void add_quoted(std::string& text, std::string_view cell) {
  text += '"';
  for (const char c : cell) text.append(c == '"' ? 2 : 1, c);
  text += '"';
}

/// Many texts in one string.
class Texts {
 public:
  std::size_t size() const { return ends_.size(); }
  bool empty() const { return ends_.empty(); }
  std::string_view operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::string_view(bytes_).substr(begin, ends_[i] - begin);
  }

  void add(std::string_view text) {
    bytes_ += text;
    ends_.push_back(bytes_.size());
  }

  /// Appends the texts [first, last) of another list.
  void append(const Texts& other, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) add(other[i]);
  }

  /// Keeps the first `size` texts. Requires: size <= size().
  void cut(std::size_t size) {
    ends_.resize(size);
    bytes_.resize(ends_.empty() ? 0 : ends_.back());
  }

 private:
  std::string bytes_;
  std::vector<std::size_t> ends_;
};

}  // namespace tcb
