// Numbers as an input writes them: with a decimal point, or with a comma in its place.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "text/number.hpp"

namespace tcb {

class Decimals {
 public:
  explicit Decimals(char mark) : mark_(mark) {}

  std::optional<double> number(std::string_view text) { return parse_number(with_point(text)); }
  std::optional<Time> time(std::string_view text) { return parse_time(with_point(text)); }
  std::string text(std::string_view text) { return std::string(with_point(text)); }
  bool looks_numeric(std::string_view text) { return tcb::looks_numeric(with_point(text)); }

 private:
  /// The text with a point for the mark; a point that is not the mark makes it no number.
  std::string_view with_point(std::string_view text) {
    if (mark_ == '.') return text;
    changed_ = text;
    for (char& c : changed_) c = c == mark_ ? '.' : c == '.' ? mark_ : c;
    return changed_;
  }

  char mark_;
  std::string changed_;
};

}  // namespace tcb
