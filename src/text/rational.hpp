// Exact rationals: what the text of a step, a rate or a time says, without rounding.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <string_view>

#include "tcb/spline/scalar.hpp"

namespace tcb {

using Time = spline::Time<double>;
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                  boost::multiprecision::et_off>;

/// A decimal such as "-0.25" or "1e-3", or a ratio of two such as "1001/30000"; nothing else.
/// Exponents beyond 10,000 are refused: no time needs them, and they would fill the memory.
std::optional<Rational> parse_rational(std::string_view text);

/// The exact value of a time: a whole number as it is, any other double as its shortest decimal.
Rational exact_time(const Time& time);

/// The double nearest to a rational, ties to even.
double nearest_double(const Rational& value);

/// Whether that is a finite number; what is said of others.
inline constexpr std::string_view double_range = "at most 1.7976931348623157e308 in size, as doubles are";
bool within_doubles(const Rational& value);

/// The time nearest to a rational, ties to even: a double, or beyond 2^53 the nearest whole number.
Time nearest_time(const Rational& value);

/// The time nearest to a number that is within `doubt` of `near`; nothing where that leaves a choice.
inline std::optional<Time> rounded_once(const Time& near, double doubt) {
  const double size = std::abs(near.hi);
  if (size < 0x1p-900) return std::nullopt;  // where the low part loses digits
  if (size < 0x1p53) {
    const bool certain = near.hi + (near.lo + doubt) == near.hi && near.hi + (near.lo - doubt) == near.hi;
    return certain ? std::optional(Time(near.hi)) : std::nullopt;
  }
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  const double low = (near.lo + round_to_whole) - round_to_whole;
  if (std::abs(near.lo - low) + doubt >= 0.5) return std::nullopt;
  return Time::normalized(near.hi, low);
}

}  // namespace tcb
