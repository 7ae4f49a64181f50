// The scalars of golden rows: exact rationals, and floats of more and more digits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <limits>
#include <span>

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

/// |b - a|^exponent over the metric channels (empty: all).
template <class S>
S distance(std::span<const Rational> a, std::span<const Rational> b, std::span<const std::size_t> metric,
           double exponent) {
  Rational square = 0;
  for (std::size_t i = 0; i < (metric.empty() ? a.size() : metric.size()); ++i) {
    const std::size_t channel = metric.empty() ? i : metric[i];
    square += (b[channel] - a[channel]) * (b[channel] - a[channel]);
  }
  return pow(sqrt(scalar_of<S>(square)), S(exponent));
}

}  // namespace tcb
