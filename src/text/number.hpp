// Text to number and back, without loss and without locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "text/time.hpp"

namespace tcb {



/// The double nearest to a decimal number, which must be the whole text: digits with an optional sign,
/// point and exponent. Nothing for any other text, nor for a number too large for a double.
std::optional<double> parse_number(std::string_view text);

/// A time: as parse_number, but a whole number below 2^63 keeps all its digits.
std::optional<Time> parse_time(std::string_view text);

/// A whole number as a time, exactly.
Time whole_time(std::int64_t value);
Time whole_time(std::uint64_t value);

/// The cell stands for a missing number: empty, NA, nan or null, in any case.
bool is_missing(std::string_view cell);

/// The text belongs in a column of numbers: a number, a missing one, or an infinity (which is refused
/// later, as a number, rather than taken for a name here).
bool looks_numeric(std::string_view text);

/// The shortest text that reads back as the same double, as std::to_chars writes it.
void append_number(std::string& out, double value);

/// A time: whole numbers below 2^63 with all their digits, others as append_number.
void append_time(std::string& out, const Time& time);

/// A time as append_time writes it.
std::string time_text(const Time& time);

void append_whole(std::string& out, std::uint64_t value);

}  // namespace tcb
