// Printing numbers: their notations, and their texts written straight into the caller's buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "numbers/decimal_time.hpp"

namespace tcb {

/// How a number of the output is written.
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
  /// Whether it has so many digits or decimals, so that most numbers are rounded.
  bool is_rounded() const { return kind == Kind::digits || kind == Kind::fixed; }
};

/// So many digits tell every double from all others.
inline constexpr int digits_of_double = 17;

/// The largest number of digits or decimals of an option.
inline constexpr int most_digits = 100;

/// The length of the longest text below but for times and the last three.
inline constexpr std::size_t longest_number = 24;

/// The length of the longest time in the shortest notation.
inline constexpr std::size_t longest_time = 38;

/// Bytes after the longest text that may be written, too.
inline constexpr std::size_t spare_room = 16;

/// Room for both.
inline constexpr std::size_t number_room = longest_number + spare_room;

/// The length of the longest number in a notation.
std::size_t longest_number_in(const Notation& notation);

/// Each function writes at out, where it needs number_room bytes, and returns the end of the text.

/// The shortest text that reads back as the same double, as std::to_chars writes it.
char* write_shortest(double value, char* out);

/// A time: long decimals and whole numbers with all their digits, others as write_shortest.
char* write_time(const Time& time, char* out);

char* write_whole(std::uint64_t value, char* out);

/// As printf("%.*f", decimals, value) writes it, if that has at most 17 digits; otherwise nothing, and null.
char* write_fixed(double value, int decimals, char* out);

/// As printf("%.*g", count, value) writes it, if count is at most 17 and the value not subnormal; otherwise nothing,
/// and null.
char* write_digits(double value, int count, char* out);

/// As printf("%a", value) writes it, but always with a point; below the normal doubles as 0x0.0000000000001p-1022,
/// where C libraries differ. Requires: finite.
char* write_hex(double value, char* out);

/// These need longest_number_in(notation) + spare_room bytes at out.

/// A finite number in a notation.
char* write_number(double value, const Notation& notation, char* out);

/// A time in a notation. In text, a whole number from 2^53 up has all its digits, and in hexadecimal so has a long
/// decimal.
char* write_time(const Time& time, const Notation& notation, char* out);

/// A long decimal, shortest, or rounded as printf's %.*f and %.*g would. Needs longest_number_in(notation) bytes at
/// out.
char* write_decimal(LongDecimal decimal, const Notation& notation, char* out);

/// The texts above, appended to a string.

void append_number(std::string& out, double value);    ///< as write_shortest
void append_time(std::string& out, const Time& time);  ///< as write_time
std::string time_text(const Time& time);

/// A count with a comma between thousands, as in 200,000.
std::string with_thousands(std::uint64_t count);

}  // namespace tcb
