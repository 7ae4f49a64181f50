// Polynomials over the scalars double, Rational and balls: arithmetic, and Bernstein's form, which bounds them.
//
// On [0, 1] a polynomial is within the smallest and the largest of its coefficients in Bernstein's form, and has the
// first and the last one as its values at 0 and 1; halving the interval brings them together quadratically.
// Source: R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29 (2012),
//   doi:10.1016/j.cagd.2012.03.001.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <utility>

namespace tcb::limits {

/// Coefficients by rising powers, or in Bernstein's form; at least one. Most have seven at most, which need no memory
/// of their own. They are copied: GCC 12 warns of moving so few.
template <class S>
struct Polynomial : boost::container::small_vector<S, 7> {
  using boost::container::small_vector<S, 7>::small_vector;
  Polynomial(const Polynomial&) = default;
  Polynomial& operator=(const Polynomial&) = default;
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

/// a + factor b.
template <class S>
Polynomial<S> sum(const Polynomial<S>& a, const Polynomial<S>& b, const S& factor = S(1)) {
  Polynomial<S> result(std::max(a.size(), b.size()));
  std::ranges::copy(a, result.begin());
  for (std::size_t i = 0; i < b.size(); ++i) result[i] = result[i] + factor * b[i];
  return result;
}

template <class S>
Polynomial<S> product(const Polynomial<S>& a, const Polynomial<S>& b) {
  Polynomial<S> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = result[i + j] + a[i] * b[j];
  }
  return result;
}

/// outer(inner(x)).
template <class S>
Polynomial<S> composed(const Polynomial<S>& outer, const Polynomial<S>& inner) {
  Polynomial<S> result{outer.back()};
  for (std::size_t i = outer.size() - 1; i-- > 0;) {
    result = product(result, inner);
    result[0] = result[0] + outer[i];
  }
  return result;
}

template <class S>
Polynomial<S> derivative(const Polynomial<S>& a) {
  if (a.size() == 1) return {S(0)};
  Polynomial<S> result(a.size() - 1);
  for (std::size_t i = 1; i < a.size(); ++i) result[i - 1] = S(static_cast<int>(i)) * a[i];
  return result;
}

template <class S>
S value_at(const Polynomial<S>& a, const S& x) {
  S value = a.back();
  for (std::size_t i = a.size() - 1; i-- > 0;) value = value * x + a[i];
  return value;
}

/// The common divisor of the largest degree, by Euclid's algorithm; a constant: there is none.
template <class S>
Polynomial<S> common_divisor(Polynomial<S> a, Polynomial<S> b) {
  const auto trim = [](Polynomial<S>& x) {
    while (x.size() > 1 && x.back() == S(0)) x.pop_back();
  };
  trim(a);
  trim(b);
  while (b.size() > 1) {
    while (a.size() >= b.size()) {
      const S factor = a.back() / b.back();
      for (std::size_t i = 1; i <= b.size(); ++i) {
        S& coefficient = a[a.size() - i];
        coefficient = coefficient - factor * b[b.size() - i];
      }
      a.pop_back();
      trim(a);
    }
    std::swap(a, b);
  }
  return is_zero(b) ? a : b;
}

/// From rising powers to Bernstein's form of a degree that is not below its own: b_j is the sum over i of
/// C(j, i) a_i / C(n, i), as numbers are sums of their differences.
template <class S>
Polynomial<S> bernstein(const Polynomial<S>& a, std::size_t degree) {
  const auto whole = [](std::size_t i) { return S(static_cast<int>(i)); };
  Polynomial<S> result(degree + 1);
  S binomial(1), last(0);  // C(n, i), and the last coefficient, which has the rounding of no quotients
  for (std::size_t i = 0; i < a.size(); ++i) {
    result[i] = a[i] / binomial;
    last = last + a[i];
    binomial = binomial * whole(degree - i) / whole(i + 1);
  }
  for (std::size_t level = degree; level-- > 0;) {
    for (std::size_t j = level; j < degree; ++j) result[j + 1] = result[j + 1] + result[j];
  }
  result.back() = last;
  return result;
}

/// The coefficients of Bernstein's form times the binomials. Their products are those of the product.
template <class S>
Polynomial<S> with_binomials(Polynomial<S> b) {
  S binomial(1);
  for (std::size_t i = 0; i < b.size(); ++i) {
    b[i] = b[i] * binomial;
    binomial = binomial * S(static_cast<int>(b.size() - 1 - i)) / S(static_cast<int>(i + 1));
  }
  return b;
}

/// From Bernstein's form to rising powers.
template <class S>
Polynomial<S> from_bernstein(Polynomial<S> b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t j = b.size() - 1; j > i; --j) b[j] = b[j] - b[j - 1];
  }
  return with_binomials(b);
}

/// Bernstein's forms on [0, at] and [at, 1].
template <class S>
std::pair<Polynomial<S>, Polynomial<S>> split(Polynomial<S> b, const S& at) {
  const S rest = S(1) - at;
  Polynomial<S> left(b.size());
  left[0] = b[0];
  for (std::size_t level = b.size() - 1; level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) b[i] = rest * b[i] + at * b[i + 1];
    left[b.size() - level] = b[0];
  }
  return {left, b};
}

}  // namespace tcb::limits
