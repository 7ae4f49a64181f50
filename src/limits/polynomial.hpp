// Polynomials over bounded numbers and rationals by their coefficients in Bernstein's form, which bound them.
//
// On [0, 1] a polynomial is within the smallest and the largest of its coefficients, and has the first and the last one
// as its values at 0 and 1; halving the interval brings them together quadratically.
// Source: R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29 (2012),
//   doi:10.1016/j.cagd.2012.03.001.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <utility>

namespace tcb::limits {

/// At least one coefficient. Most have seven at most, which need no memory of their own. They are copied: GCC 12 warns
/// of moving so few.
template <class S>
struct Polynomial : boost::container::small_vector<S, 7> {
  using boost::container::small_vector<S, 7>::small_vector;
  Polynomial(const Polynomial&) = default;
  Polynomial& operator=(const Polynomial&) = default;

  std::size_t degree() const { return this->size() - 1; }
};

template <class S>
S power_of(const S& x, int exponent) {
  S power(1);
  for (int i = 0; i < exponent; ++i) power = power * x;
  return power;
}

template <class S>
bool is_zero(const Polynomial<S>& a) {
  return std::ranges::all_of(a, [](const S& x) { return x == S(0); });
}

/// Calls f(i, C(degree, i)) for all i.
template <class F>
void with_binomials(std::size_t degree, const F& f) {
  double binomial = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    f(i, binomial);
    binomial = binomial * static_cast<double>(degree - i) / static_cast<double>(i + 1);
  }
}

template <class S>
Polynomial<S> product(Polynomial<S> a, Polynomial<S> b) {
  with_binomials(a.degree(), [&](std::size_t i, double binomial) { a[i] = a[i] * S(binomial); });
  with_binomials(b.degree(), [&](std::size_t i, double binomial) { b[i] = b[i] * S(binomial); });
  Polynomial<S> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = result[i + j] + a[i] * b[j];
  }
  with_binomials(result.degree(), [&](std::size_t i, double binomial) {
    if (binomial != 1) result[i] = result[i] / S(binomial);
  });
  return result;
}

template <class S>
Polynomial<S> times(Polynomial<S> a, const S& factor) {
  for (S& x : a) x = x * factor;
  return a;
}

template <class S>
Polynomial<S> power_of(const Polynomial<S>& base, int exponent) {
  Polynomial<S> power{S(1)};
  for (int i = 0; i < exponent; ++i) power = product(power, base);
  return power;
}

/// The same polynomial with the coefficients of a degree that is not below its own.
template <class S>
Polynomial<S> of_degree(const Polynomial<S>& a, std::size_t degree) {
  if (degree <= a.degree()) return a;
  return a.degree() == 0 ? Polynomial<S>(degree + 1, a[0]) : product(a, Polynomial<S>(degree - a.degree() + 1, S(1)));
}

/// a + factor b.
template <class S>
Polynomial<S> sum(const Polynomial<S>& a, const Polynomial<S>& b, const S& factor = S(1)) {
  Polynomial<S> result = of_degree(a, b.degree());
  const Polynomial<S> other = of_degree(b, a.degree());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] + factor * other[i];
  return result;
}

template <class S>
Polynomial<S> derivative(const Polynomial<S>& a) {
  Polynomial<S> result{S(0)};
  if (a.degree() > 0) result.resize(a.degree());
  for (std::size_t i = 0; i < a.degree(); ++i) result[i] = S(static_cast<int>(a.degree())) * (a[i + 1] - a[i]);
  return result;
}

/// The polynomials on [0, at] and [at, 1].
template <class S>
std::pair<Polynomial<S>, Polynomial<S>> split(Polynomial<S> b, const S& at) {
  const S rest = S(1) - at;
  Polynomial<S> left = b;
  for (std::size_t level = b.degree(); level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) b[i] = rest * b[i] + at * b[i + 1];
    left[b.size() - level] = b[0];
  }
  return {left, b};
}

template <class S>
S value_at(const Polynomial<S>& a, const S& x) {
  return split(a, x).second.front();
}

/// outer(inner(x)).
template <class S>
Polynomial<S> composed(const Polynomial<S>& outer, const Polynomial<S>& inner) {
  std::vector<Polynomial<S>> b;
  for (const S& coefficient : outer) b.push_back({coefficient});
  Polynomial<S> rest = inner;
  for (S& x : rest) x = S(1) - x;
  for (std::size_t level = outer.degree(); level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) b[i] = sum(product(rest, b[i]), product(inner, b[i + 1]));
  }
  return b.front();
}

}  // namespace tcb::limits
