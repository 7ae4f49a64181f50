// Printing numbers: shortest, rounded, whole and hexadecimal.
#include "numbers/print_number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "numbers/shortest_decimal.hpp"

namespace tcb {
namespace {

constexpr int longest_fixed = 311;  ///< of a double without decimals, with its sign and point

template <class Word>
Word load(const char* text) {
  Word bytes;
  std::memcpy(&bytes, text, sizeof bytes);
  return bytes;
}

template <class Word>
void store(char* out, Word bytes) {
  std::memcpy(out, &bytes, sizeof bytes);
}

/// Seventeen digits with the point after the first of them.
struct PlacedDigits {
  SixteenDigits sixteen;
  char last;
  int exponent;
  int count;  ///< without the zeros at the end

  void write(char* out) const {
    sixteen.write(out);
    out[16] = last;
  }
};

/// Requires: 16 or 17 digits. Inlined, so that they stay in registers.
[[gnu::always_inline]] inline PlacedDigits digits_of(const SplitDecimal& decimal) {
  const bool missing = decimal.tens < 1'000'000'000'000'000;
  const SixteenDigits sixteen(choose(missing, decimal.tens * 10 + decimal.last, decimal.tens));
  const std::uint64_t last = choose(missing, 0, decimal.last);
  return {sixteen, static_cast<char>('0' + last), decimal.exponent + 16 - (missing ? 1 : 0), sixteen.count(last != 0)};
}

/// Requires: 17 digits.
PlacedDigits digits_of(const Decimal& decimal) {
  return digits_of(SplitDecimal{decimal.digits / 10, decimal.digits % 10, decimal.exponent});
}

/// The exponent with its sign and two or three digits.
char* write_exponent(int exponent, char* out) {
  const auto size = static_cast<unsigned>(std::abs(exponent));
  store<std::uint16_t>(out, static_cast<std::uint16_t>('e' | ('+' + ('-' - '+') * (exponent < 0 ? 1 : 0)) << 8));
  out[2] = static_cast<char>('0' + size / 100);
  out += size < 100 ? 2 : 3;
  out[0] = static_cast<char>('0' + size / 10 % 10);
  out[1] = static_cast<char>('0' + size % 10);
  return out + 2;
}

char* write_scientific(const PlacedDigits& digits, char* out) {
  digits.write(out + 1);
  out[0] = out[1];
  out[1] = '.';
  return write_exponent(digits.exponent, out + (digits.count == 1 ? 1 : digits.count + 1));
}

/// With `count` digits from the first one that is not zero, and all of those before the point.
/// Requires: -18 <= digits.exponent <= 16. Inlined, so that the digits stay in registers.
[[gnu::always_inline]] inline char* write_plain(const PlacedDigits& digits, int count, char* out) {
  const int before = digits.exponent + 1;  // digits before the point
  if (before <= 0) {
    for (int i = 0; i < 24; i += 8) store(out + i, eight_zeros);
    out[1] = '.';
    digits.write(out + 2 - before);
    return out + 2 - before + count;
  }
  digits.write(out);
  if (count <= before) return out + before;
  // What follows the point goes one byte further.
  const auto late = load<std::uint64_t>(out + 8);
  if (before <= 8) {
    const auto from_point = load<std::uint64_t>(out + before);
    store(out + 9, late);
    store(out + before + 1, from_point);
  } else {
    store(out + before + 1, late >> 8 * (before - 9) >> 8);
  }
  out[17] = digits.last;
  out[before] = '.';
  return out + count + 1;
}

/// The sign, if there is one.
char* write_sign(double value, char* out) {
  *out = '-';
  return out + (std::signbit(value) ? 1 : 0);
}

/// By the standard library, which writes all digits of a double.
char* write_exactly(double value, std::chars_format notation, int precision, char* out) {
  return std::to_chars(out, out + longest_fixed + precision, value, notation, precision).ptr;
}

/// Numbers from 100000 up that are whole, below 0.001, or not finite, and those for which shortest_if_easy() fails.
/// Requires: not 0; no sign. Not inlined, so that write_shortest stays small.
[[gnu::noinline]] char* write_unusual(double size, char* out) {
  if (!std::isfinite(size)) return std::to_chars(out, out + number_room, size).ptr;
  const auto decimal = shortest_if_easy(size);
  const PlacedDigits digits = decimal ? digits_of(*decimal) : digits_of(shortest(size));
  // The shorter one of the two notations, as std::to_chars has it. A lone digit has no point in the second one.
  const int lone = digits.count == 1 ? 1 : 0;
  const auto above_least = static_cast<unsigned>(digits.exponent + 4 - lone);
  if (above_least > static_cast<unsigned>(digits.count + 8 - 2 * lone)) return write_scientific(digits, out);
  if (digits.exponent <= 15) return write_plain(digits, digits.count, out);
  if (size < 2 * 0x1p63) return write_whole(static_cast<std::uint64_t>(size), out);
  return std::to_chars(out, out + number_room, size).ptr;
}

char* write_bytes(double value, char* out) {
  auto bits = std::bit_cast<std::uint64_t>(value);
  for (int i = 0; i < 8; ++i, bits >>= 8) *out++ = static_cast<char>(bits & 0xFFU);
  return out;
}

template <class Value>
void append(std::string& out, char* (*write)(Value, char*), const std::type_identity_t<Value>& value) {
  std::array<char, number_room> text;
  out.append(text.data(), write(value, text.data()));
}

/// The digits of a decimal as a text.
std::string text_of(LongDecimal::Digits digits) {
  std::string text;
  for (; digits != 0; digits /= 10) text.insert(text.begin(), static_cast<char>('0' + static_cast<int>(digits % 10)));
  return text;
}

/// Digits with the point after the first `before` of them, or zeros before them.
char* write_plain(std::string digits, int before, char* out) {
  if (before <= 0) digits.insert(0, static_cast<std::size_t>(1 - before), '0');
  const auto whole = static_cast<std::size_t>(std::max(before, 1));
  if (digits.size() < whole) digits.append(whole - digits.size(), '0');
  if (digits.size() > whole) digits.insert(whole, 1, '.');
  return std::copy(digits.begin(), digits.end(), out);
}

/// The exponent has its sign and two digits at least.
char* write_scientific(std::string digits, int exponent, char* out) {
  if (digits.size() > 1) digits.insert(1, 1, '.');
  digits += exponent < 0 ? "e-" : "e+";
  const std::string size = std::to_string(std::abs(exponent));
  digits += size.size() < 2 ? "0" + size : size;
  return std::copy(digits.begin(), digits.end(), out);
}

/// A long decimal in the shorter one of the two notations.
char* write_shorter(const LongDecimal& decimal, char* out) {
  if (decimal.negative) *out++ = '-';
  std::string digits = text_of(decimal.digits);
  const int count = static_cast<int>(digits.size()), before = count + decimal.exponent;
  const int plain = before <= 0 ? count + 2 - before : before < count ? count + 1 : before;
  const int scientific = count + (count > 1 ? 1 : 0) + (before > 100 || before < -98 ? 5 : 4);
  return plain <= scientific ? write_plain(std::move(digits), before, out)
                             : write_scientific(std::move(digits), before - 1, out);
}

}  // namespace

char* write_decimal(LongDecimal decimal, const Notation& notation, char* out) {
  if (notation.kind == Notation::Kind::shortest) return write_shorter(decimal, out);
  const bool fixed = notation.kind == Notation::Kind::fixed;
  if (decimal.negative) *out++ = '-';
  const int count = std::max(notation.count, 1);
  decimal = rounded(decimal, fixed ? notation.count : count - decimal.size() - decimal.exponent);
  std::string digits = text_of(decimal.digits);
  const int before = static_cast<int>(digits.size()) + decimal.exponent;
  if (!fixed && (before < -3 || before > count)) return write_scientific(std::move(digits), before - 1, out);
  const int zeros = fixed ? notation.count + decimal.exponent : 0;
  digits.append(static_cast<std::size_t>(zeros), '0');
  return write_plain(std::move(digits), before, out);
}

char* write_whole(std::uint64_t value, char* out) {
  constexpr std::uint64_t eight = 100'000'000;
  if (value >= eight) {
    out = write_whole(value / eight, out);
    store(out, eight_digits(value % eight) | eight_zeros);
    return out + 8;
  }
  const std::uint64_t digits = eight_digits(value);
  const int zeros = std::countr_zero(digits | std::uint64_t{1} << 56) / 8;  // at least the last digit stays
  store(out, (digits | eight_zeros) >> 8 * zeros);
  return out + 8 - zeros;
}

char* write_shortest(double value, char* out) {
  const double size = std::abs(value);
  out = write_sign(value, out);
  constexpr double whole_below_are_plain = 100'000;  // which is 1e+05
  if (size < whole_below_are_plain) {
    const auto whole = static_cast<std::int32_t>(size);
    if (whole == size) return write_whole(static_cast<std::uint64_t>(whole), out);
  }
  if (const auto decimal = shortest_if_easy(size)) {
    const PlacedDigits digits = digits_of(*decimal);
    const bool plain = digits.exponent >= -3 && digits.exponent + 1 < digits.count;
    if (plain) return write_plain(digits, digits.count, out);
  }
  return write_unusual(size, out);
}

char* write_fixed(double value, int decimals, char* out) {
  if (decimals < 0 || decimals > digits_of_double) return nullptr;
  const double size = std::abs(value);
  if (!(size < static_cast<double>(whole_power_of_ten(digits_of_double - decimals)))) return nullptr;
  out = write_sign(value, out);
  const std::uint64_t scaled = size == 0 ? 0 : rounded(size, decimals);
  const PlacedDigits zero{SixteenDigits(0), '0', decimals == 0 ? 0 : -1, 1};
  const PlacedDigits digits = scaled == 0 ? zero : digits_of(widened({scaled, -decimals}));
  return write_plain(digits, digits.exponent + 1 + decimals, out);
}

char* write_digits(double value, int count, char* out) {
  count = std::max(count, 1);
  const double size = std::abs(value);
  if (count > digits_of_double || !std::isnormal(value)) return size == 0 ? write_shortest(value, out) : nullptr;
  int power = count - 1 - floor_log10_power_of_two(Binary(size).q + 52);
  std::uint64_t scaled = rounded(size, power);
  if (scaled >= whole_power_of_ten(count)) scaled = rounded(size, --power);
  const PlacedDigits digits = digits_of(widened({scaled, -power}));
  out = write_sign(value, out);
  if (digits.exponent < -4 || digits.exponent >= count) return write_scientific(digits, out);
  return write_plain(digits, digits.count, out);
}

char* write_hex(double value, char* out) {
  out = write_sign(value, out);
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr int mantissa_bits = 52;
  const int biased = static_cast<int>(bits >> mantissa_bits & 0x7FFU);
  std::uint64_t mantissa = bits << (64 - mantissa_bits);
  *out++ = '0';
  *out++ = 'x';
  *out++ = biased == 0 ? '0' : '1';
  if (mantissa != 0) *out++ = '.';
  for (; mantissa != 0; mantissa <<= 4U) *out++ = "0123456789abcdef"[mantissa >> 60U];
  const int exponent = biased == 0 && value == 0 ? 0 : std::max(biased, 1) - 1023;
  *out++ = 'p';
  *out++ = exponent < 0 ? '-' : '+';
  return write_whole(static_cast<std::uint64_t>(std::abs(exponent)), out);
}

std::size_t longest_number_in(const Notation& notation) {
  const auto count = static_cast<std::size_t>(notation.count);
  return notation.kind == Notation::Kind::fixed    ? static_cast<std::size_t>(longest_fixed) + count
         : notation.kind == Notation::Kind::digits ? longest_number + count
                                                   : longest_number;
}

char* write_number(double value, const Notation& notation, char* out) {
  switch (notation.kind) {
    case Notation::Kind::shortest: break;
    case Notation::Kind::bytes: return write_bytes(value, out);
    case Notation::Kind::hex: return write_hex(value, out);
    case Notation::Kind::digits:
      if (char* const end = write_digits(value, notation.count, out)) return end;
      return write_exactly(value, std::chars_format::general, notation.count, out);
    case Notation::Kind::fixed:
      if (char* const end = write_fixed(value, notation.count, out)) return end;
      return write_exactly(value, std::chars_format::fixed, notation.count, out);
  }
  return write_shortest(value, out);
}

char* write_time(const Time& time, const Notation& notation, char* out) {
  constexpr double whole_from = 9007199254740992.0;  // 2^53: every double from here on is whole
  const bool rounds = notation.is_rounded();
  if (is_long_decimal(time) && time.lo != std::trunc(time.lo) && rounds)
    return write_decimal(decimal_of(time), notation, out);
  const bool plain = notation.kind == Notation::Kind::shortest ||
                     (notation.is_text() && (std::abs(time.hi) >= whole_from || time.lo != 0));
  return plain ? write_time(time, out) : write_number(time.hi, notation, out);
}

char* write_time(const Time& time, char* out) {
  if (is_long_decimal(time)) return write_decimal(decimal_of(time), {}, out);
  if (!(time.hi >= -0x1p63 && time.hi <= 0x1p63)) return write_shortest(time.hi, out);
  if (time.hi == 0x1p63) {
    return write_whole((std::uint64_t{1} << 63) + static_cast<std::uint64_t>(static_cast<std::int64_t>(time.lo)), out);
  }
  const auto high = static_cast<std::int64_t>(time.hi);
  if (static_cast<double>(high) != time.hi) return write_shortest(time.hi, out);
  const std::int64_t whole = high + static_cast<std::int64_t>(time.lo);
  *out = '-';
  const auto bits = static_cast<std::uint64_t>(whole);
  return whole < 0 ? write_whole(-bits, out + 1) : write_whole(bits, out);
}

void append_number(std::string& out, double value) { append(out, write_shortest, value); }

void append_time(std::string& out, const Time& time) { append(out, write_time, time); }

std::string time_text(const Time& time) {
  std::string out;
  append_time(out, time);
  return out;
}

std::string with_thousands(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

}  // namespace tcb
