// Floats of many bits by Boost.Multiprecision, and rationals of them.
//
// Only the files that compute with them include this: Boost's headers take seconds to compile.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <limits>

#include "exact/rounding.hpp"
#include "numbers/large_rational.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/curve_keys.hpp"

namespace tcb {

template <unsigned bits>
using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

using ShortFloat = Float<192>;
using LongFloat = Float<448>;

/// The exact value of a float. Requires: finite.
template <unsigned bits>
Rational rational_of(const Float<bits>& value) {
  constexpr int digits = std::numeric_limits<Float<bits>>::digits;
  int exponent = 0;
  const Float<bits> mantissa = frexp(value, &exponent);
  const Integer whole(ldexp(mantissa, digits));
  exponent -= digits;
  return exponent < 0 ? ratio(whole, Integer(1) << -exponent) : rational(whole << exponent);
}

/// A rational as a float, to one unit in its last place.
template <unsigned bits>
Float<bits> float_of(const Rational& value) {
  return Float<bits>(integer(numerator(value))) / Float<bits>(integer(denominator(value)));
}
template <>
inline ShortFloat scalar_of<ShortFloat>(const Rational& value) {
  return float_of<192>(value);
}
template <>
inline LongFloat scalar_of<LongFloat>(const Rational& value) {
  return float_of<448>(value);
}

extern template class spline::CurveKeys<ShortFloat>;
extern template class spline::CurveKeys<LongFloat>;

}  // namespace tcb
