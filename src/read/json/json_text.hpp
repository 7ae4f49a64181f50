// JSON text as nlohmann-json reads it: pieces one after the other, and how far they were read.
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>

namespace tcb {

/// A text in up to three pieces, such as keys in brackets. Only one parser reads it, once.
class JsonText {
 public:
  using Pieces = std::array<std::string_view, 3>;

  JsonText() = default;
  explicit JsonText(const Pieces& pieces) : pieces_(pieces), now_(pieces[0].data()), end_(now_ + pieces[0].size()) {}

  /// What follows the last byte that was read, in its piece.
  const char* now() const { return now_; }

  std::size_t size() const { return pieces_[0].size() + pieces_[1].size() + pieces_[2].size(); }

  /// Byte `index` of the text, in its piece; the end of the last piece where the text has fewer.
  const char* byte(std::size_t index) const;

  /// The rest of the text, from a place in it to the end of a piece, that is not blank: of the piece with the place, or
  /// else of one after it. Empty at the end of the last piece.
  std::string_view rest(const char* from) const;

  /// Reads the bytes. The iterator that a parser takes for the end is one without a text.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Iterator() = default;
    /// Requires: `text` outlives it.
    explicit Iterator(JsonText& text) : text_(&text) {}

    reference operator*() const { return *text_->now_; }
    Iterator& operator++() {
      ++text_->now_;
      return *this;
    }
    /// Whether all was read. Requires: this one has a text, the other one has none.
    bool operator==(const Iterator&) const { return text_->now_ == text_->end_ && !text_->begin_next_piece(); }

   private:
    JsonText* text_ = nullptr;
  };

 private:
  bool begin_next_piece();

  Pieces pieces_;
  std::size_t piece_ = 0;  ///< the index of the current one
  const char* now_ = nullptr;
  const char* end_ = nullptr;  ///< of the current piece
};

}  // namespace tcb
