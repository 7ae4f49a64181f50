// Floats of many digits by Boost.Multiprecision, with which balls are compared.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "exact/rounding.hpp"
#include "numbers/large_rational.hpp"

namespace tcb {

template <unsigned digits>
using Float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>, boost::multiprecision::et_off>;

/// The exact value of a float.
template <unsigned digits>
Rational rational_of(const Float<digits>& value) {
  constexpr int bits = std::numeric_limits<Float<digits>>::digits;
  int exponent = 0;
  const Float<digits> mantissa = frexp(value, &exponent);
  const Integer whole(ldexp(mantissa, bits));
  exponent -= bits;
  return exponent < 0 ? ratio(whole, Integer(1) << -exponent) : rational(whole << exponent);
}

/// The float nearest to a rational.
template <unsigned digits>
Float<digits> float_of(const Rational& value) {
  return Float<digits>(integer(numerator(value))) / Float<digits>(integer(denominator(value)));
}

}  // namespace tcb
