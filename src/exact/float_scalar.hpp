// Floats of many bits by Boost.Multiprecision, and rationals of them.
//
// Only the files that compute with them include this: Boost's headers take seconds to compile.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
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

/// The root of a float by Newton's method, where sqrt() of Boost takes a step for each bit. Promises: within two units
/// of the last place, and exactly, if it has at most half of the bits.
template <unsigned bits>
struct spline::SquareRoot<Float<bits>> {
  static Float<bits> of(const Float<bits>& x) {
    if (!(x > 0) || !isfinite(x)) return x < 0 ? std::numeric_limits<Float<bits>>::quiet_NaN() : x;
    int exponent = 0;
    Float<bits> part = frexp(x, &exponent);
    if (exponent % 2 != 0) part = ldexp(part, exponent < 0 ? -1 : 1);
    const ShortFloat rough(part);
    ShortFloat inverse(1 / std::sqrt(static_cast<double>(rough)));
    for (int step = 0; step < 2; ++step) inverse += ldexp(inverse * (1 - rough * inverse * inverse), -1);
    Float<bits> root(rough * inverse);
    const Float<bits> near(inverse);
    for (int step = 0; step < (bits > 192 ? 2 : 1); ++step) root += ldexp(near * (part - root * root), -1);
    return ldexp(root, exponent / 2);
  }
};

extern template class spline::CurveKeys<ShortFloat>;
extern template class spline::CurveKeys<LongFloat>;

}  // namespace tcb
