// Exact scalars: rationals, and floats of more and more digits; what the templates of the curve need of them.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

#include "keys/parameterize.hpp"
#include "text/large_rational.hpp"

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
    return S(integer(numerator(value))) / S(integer(denominator(value)));
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
    return exponent < 0 ? ratio(whole, Integer(1) << -exponent) : rational(whole << exponent);
  }
}

/// The power of a distance between exact positions: the square of the distance is exact.
template <unsigned digits>
struct DistancePower<Float<digits>> {
  explicit DistancePower(const Rational&) {}
  void add_square(const Rational& a, const Rational& b) { sum_ += (b - a) * (b - a); }
  Float<digits> power(double exponent) const {
    return pow(sqrt(scalar_of<Float<digits>>(sum_)), Float<digits>(exponent));
  }

 private:
  Rational sum_ = 0;
};

}  // namespace tcb
