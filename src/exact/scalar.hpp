// The scalars of golden rows: exact rationals, and floats of more and more digits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

#include "text/rational.hpp"

namespace tcb {

template <unsigned digits>
using Float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>, boost::multiprecision::et_off>;

/// An exact number at a scalar: rounded, unless that is exact.
template <class S>
S scalar_of(const Rational& value) {
  if constexpr (std::numeric_limits<S>::is_exact) {
    return value;
  } else {
    return S(numerator(value)) / S(denominator(value));
  }
}

/// The exact value of a scalar.
template <class S>
Rational rational_of(const S& value) {
  if constexpr (std::numeric_limits<S>::is_exact) {
    return value;
  } else {
    constexpr int digits = std::numeric_limits<S>::digits;
    int exponent = 0;
    const S mantissa = frexp(value, &exponent);
    const Integer whole(ldexp(mantissa, digits));
    exponent -= digits;
    return exponent < 0 ? Rational(whole, Integer(1) << -exponent) : Rational(Integer(whole << exponent));
  }
}

}  // namespace tcb
