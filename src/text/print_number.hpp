// Numbers as text, written straight into a caller's buffer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tcb/spline/scalar.hpp"
#include "text/notation.hpp"

namespace tcb {

/// The length of the longest text below but for the last two.
inline constexpr std::size_t longest_number = 24;

/// Bytes behind the longest text that may be written, too.
inline constexpr std::size_t spare_room = 16;

/// Room for both.
inline constexpr std::size_t number_room = longest_number + spare_room;

/// The length of the longest number in a notation.
std::size_t longest_number_in(const Notation& notation);

/// Each function writes at out, where it needs number_room bytes, and answers the end of the text.

/// The shortest text that reads back as the same double, as std::to_chars writes it.
char* write_shortest(double value, char* out);

/// A time: whole numbers below 2^63 with all their digits, others as write_shortest.
char* write_time(const spline::Time<double>& time, char* out);

char* write_whole(std::uint64_t value, char* out);

/// As printf("%.*f", decimals, value) writes it, if that has at most 17 digits; otherwise nothing, and null.
char* write_fixed(double value, int decimals, char* out);

/// As printf("%.*g", count, value) writes it, if count is at most 17 and the value not subnormal; otherwise nothing,
/// and null.
char* write_digits(double value, int count, char* out);

/// As printf("%a", value) writes it, but always with a point.
char* write_hex(double value, char* out);

/// These need longest_number_in(notation) + spare_room bytes at out.

/// A finite number in a notation.
char* write_number(double value, const Notation& notation, char* out);

/// A time in a notation. In text, a whole number from 2^53 up has all its digits.
char* write_time(const spline::Time<double>& time, const Notation& notation, char* out);

}  // namespace tcb
