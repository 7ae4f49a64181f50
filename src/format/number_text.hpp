// Numbers as text, written straight into a caller's buffer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "spline/scalar.hpp"

namespace tcb::format {

/// Room for any of the texts below. No text is longer than 24 characters, but bytes after it are written too.
inline constexpr std::size_t number_room = 40;

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

}  // namespace tcb::format
