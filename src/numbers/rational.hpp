// Exact rationals: the values of steps, rates and times as they are written, and rounding them once.
//
// Numbers whose numerator and denominator fit in 64 bits are held in place; larger ones are shared and never change.
// Threads: as an int.
#pragma once

#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tcb/spline/double_double.hpp"

namespace tcb {

using Time = spline::Time<double>;

class Rational {
 public:
  struct Large;  ///< a rational of any size: large_rational.hpp

  Rational() = default;
  // Not inline: copies of numbers are most of what the templates over them compile.
  Rational(const Rational&);
  Rational(Rational&&) noexcept;
  Rational& operator=(const Rational&);
  Rational& operator=(Rational&&) noexcept;
  ~Rational();
  template <std::integral N>
  Rational(N value)  // NOLINT(google-explicit-constructor): an integer is a rational
      : Rational(std::in_range<std::int64_t>(value) && std::cmp_greater_equal(value, -largest)
                     ? Rational(static_cast<std::int64_t>(value), InPlace())
                     : reduced(value, 1)) {}
  explicit Rational(double value);  ///< its exact value. Requires: finite
  explicit Rational(const Large& value);

  /// dividend / divisor. Requires: divisor != 0.
  Rational(const Rational& dividend, const Rational& divisor);

  Large large() const;
  bool is_small() const { return large_ == nullptr; }

  /// In lowest terms. Requires: is_small().
  std::int64_t small_numerator() const { return numerator_; }
  std::int64_t small_denominator() const { return denominator_; }

  Rational operator-() const;
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);  ///< Requires: b != 0
  Rational& operator+=(const Rational& other) { return *this = *this + other; }
  Rational& operator-=(const Rational& other) { return *this = *this - other; }
  Rational& operator*=(const Rational& other) { return *this = *this * other; }
  Rational& operator/=(const Rational& other) { return *this = *this / other; }

  friend bool operator==(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

 private:
  __extension__ using Int128 = __int128;
  static constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

  struct InPlace {};
  Rational(std::int64_t whole, InPlace) : numerator_(whole) {}

  /// From terms without common factors. Requires: denominator > 0.
  static Rational reduced(Int128 numerator, Int128 denominator);

  std::int64_t numerator_ = 0, denominator_ = 1;  ///< in lowest terms, the denominator positive, both at most `largest`
  std::shared_ptr<const Large> large_;            ///< the value where it does not fit in these
};

Rational abs(const Rational& value);

/// The largest whole number up to a value.
Rational floor(const Rational& value);

/// In lowest terms, as whole numbers; the denominator is positive.
Rational numerator(const Rational& value);
Rational denominator(const Rational& value);

/// The digits of a whole number.
std::string whole_text(const Rational& whole);

/// A number as "p/q".
std::string ratio_text(const Rational& number);

/// A whole number as an integer. Requires: 0 <= whole < 2^64.
std::uint64_t whole_number(const Rational& whole);

/// A decimal such as "-0.25" or "1e-3", or a ratio of two such as "1001/30000"; nothing else.
/// Exponents beyond 10,000 are refused: no time needs them, and they would fill the memory.
std::optional<Rational> parse_rational(std::string_view text);

/// The exact value of a time: a whole number as it is, any other double as its shortest decimal, and any other time as
/// its decimal of 31 digits at most.
Rational exact_time(const Time& time);

/// The double nearest to a rational, ties to even.
double nearest_double(const Rational& value);

/// Whether that is a finite number.
bool within_doubles(const Rational& value);

/// The time nearest to a rational, ties to even: a double, or from 2^53 to 10^31 the nearest whole number.
Time nearest_time(const Rational& value);

/// The time nearest to a number that is within `doubt` of `near`; nothing where that leaves a choice. `whole_from`:
/// from this size on it is a whole number instead of a double.
inline std::optional<Time> rounded_once(const Time& near, double doubt, double whole_from = 0x1p53) {
  const double size = std::abs(near.hi);
  if (size < 0x1p-900) return std::nullopt;  // where the low part loses digits
  if (size < whole_from) {
    const bool certain = near.hi + (near.lo + doubt) == near.hi && near.hi + (near.lo - doubt) == near.hi;
    return certain ? std::optional(Time(near.hi)) : std::nullopt;
  }
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  const double low = (near.lo + round_to_whole) - round_to_whole;
  if (std::abs(near.lo - low) + doubt >= 0.5) return std::nullopt;
  return Time::normalized(near.hi, low);
}

}  // namespace tcb

template <>
struct std::numeric_limits<tcb::Rational> {
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = true;
  static constexpr bool is_bounded = false, has_infinity = false;
  static constexpr bool has_quiet_NaN = false;  // NOLINT(readability-identifier-naming): a name of the standard
  static constexpr int digits = std::numeric_limits<int>::max(), digits10 = digits;
};
