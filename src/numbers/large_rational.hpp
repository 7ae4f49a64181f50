// Integers and rationals of any size, by Boost.Multiprecision: what Rational falls back to.
//
// Only numbers/rational.cpp and the files of exact/ include this: Boost's headers take seconds to compile.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "numbers/rational.hpp"

namespace tcb {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

struct Rational::Large {
  using Number =
      boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                    boost::multiprecision::et_off>;
  Number number;
};

/// A whole number as an integer, and back. Requires: whole.
inline Integer integer(const Rational& whole) {
  return whole.is_small() ? Integer(whole.small_numerator()) : Integer(numerator(whole.large().number));
}
inline Rational rational(const Integer& whole) { return Rational(Rational::Large{Rational::Large::Number(whole)}); }

/// above / below. Requires: below != 0.
inline Rational ratio(const Integer& above, const Integer& below) {
  return Rational(Rational::Large{Rational::Large::Number(above, below)});
}

/// n / d rounded to the nearest whole number, ties to even. Requires: n >= 0, d > 0.
inline Integer rounded_quotient(const Integer& n, const Integer& d) {
  Integer quotient, rest;
  divide_qr(n, d, quotient, rest);
  const int side = Integer(2 * rest).compare(d);
  return side > 0 || (side == 0 && quotient % 2 != 0) ? Integer(quotient + 1) : quotient;
}

}  // namespace tcb
