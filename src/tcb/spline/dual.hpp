// Dual numbers: a number and its derivative, so that a formula also gives its own derivative.
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// A number and its derivative.
template <class S>
struct Dual {
  S value{}, slope{};

  Dual() = default;
  Dual(const S& number) : value(number), slope(0) {}  // NOLINT(google-explicit-constructor): a constant
  Dual(const S& number, const S& derivative) : value(number), slope(derivative) {}

  friend Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.slope + a.slope * b.value};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const S quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
  }
  friend Dual sqrt(const Dual& a) {
    const S root = square_root(a.value);
    return {root, a.slope / (S(2) * root)};
  }
  friend SineCosine<Dual> sine_cosine(const Dual& angle) {
    const auto [sine, cosine] = sine_cosine(angle.value);
    return {{sine, cosine * angle.slope}, {cosine, -(sine * angle.slope)}};
  }
  friend Dual sine(const Dual& angle) { return sine_cosine(angle).sine; }
  friend Dual angle_of(const Dual& y, const Dual& x) {
    return {angle_of(y.value, x.value),
            (x.value * y.slope - y.value * x.slope) / (x.value * x.value + y.value * y.value)};
  }
};

/// The number without its derivative, if it has one.
template <class S>
const S& value_of(const S& number) {
  return number;
}
template <class S>
const S& value_of(const Dual<S>& number) {
  return number.value;
}
template <class T>
using value_t = std::remove_cvref_t<decltype(value_of(std::declval<const T&>()))>;

}  // namespace tcb::spline
