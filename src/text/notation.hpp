// Notations: how a number of the output is written.
#pragma once

#include <cstddef>

namespace tcb {

struct Notation {
  enum class Kind {
    shortest,  ///< the shortest text that reads back as the same double
    digits,    ///< so many significant digits, as printf's %.*g
    fixed,     ///< so many decimals, as printf's %.*f
    hex,       ///< C's hexadecimal, as printf's %a
    bytes,     ///< no text: the eight bytes of the double, the lowest first
  };
  Kind kind = Kind::shortest;
  int count = 0;

  /// Times that are whole numbers beyond 2^53 stay whole numbers, with all their digits.
  bool is_text() const { return kind != Kind::bytes; }
};

/// So many digits tell every double from all others.
inline constexpr int digits_of_double = 17;

/// So many digits or decimals can be asked for.
inline constexpr int most_digits = 100;

}  // namespace tcb
