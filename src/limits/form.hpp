// Forms: a measure on a part of a piece in Bernstein's form, which bounds it, and has its values at both ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "limits/ball.hpp"
#include "limits/pieces.hpp"
#include "limits/polynomial.hpp"
#include "numbers/rational.hpp"

namespace tcb::limits {

inline constexpr double relative_rounding = 0x1p-40;  ///< of the segments, and of hundreds of operations on them
inline constexpr double smallest_square = 1e-290;     ///< below it, squares may be 0

/// How far rounding may move a sum of terms whose sizes are `scale` together.
inline double slack_of(double scale) { return scale == 0 ? 0 : relative_rounding * scale + smallest_square; }

/// The power of a polynomial in Bernstein's form, times the binomials.
template <class S>
Polynomial<S> power_of_form(const Polynomial<S>& form, int power) {
  const Polynomial<S> base = with_binomials(form);
  Polynomial<S> result{S(1)};
  for (int i = 0; i < power; ++i) result = product(result, base);
  return result;
}

/// A measure over a part of a piece in Bernstein's form, and how far rounding may move that of doubles.
template <class S>
struct Form {
  Polynomial<S> over{S(0)}, base{S(0)};
  int power = 0;
  double slack = 0, base_slack = 0;
};

template <class S>
Form<S> form_of(const Measured<S>& x) {
  const std::size_t base_degree = x.base.size() - 1, of_power = base_degree * static_cast<std::size_t>(x.power);
  return {bernstein(x.over, std::max(x.over.size() - 1, of_power)), bernstein(x.base, base_degree), x.power,
          slack_of(x.scale), relative_rounding * x.base_scale};
}

/// The forms on [0, at] and [at, 1].
template <class S>
std::pair<Form<S>, Form<S>> split(const Form<S>& form, const S& at) {
  std::pair<Form<S>, Form<S>> parts{form, form};
  std::tie(parts.first.over, parts.second.over) = split(form.over, at);
  std::tie(parts.first.base, parts.second.base) = split(form.base, at);
  return parts;
}

inline Rational exactly(const spline::DoubleDouble& x) { return Rational(x.hi) + Rational(x.lo); }
template <unsigned bits>
Rational exactly(const Float<bits>& x) {
  return rational_of<bits>(x);
}

/// The ends of what a scalar may be, as numbers that are compared.
template <class Number, class S>
std::pair<Number, Number> ends_of(const S& x) {
  if constexpr (std::is_same_v<S, Number>) {
    return {x, x};
  } else if constexpr (std::is_same_v<Number, Rational>) {
    const Rational middle = exactly(x.middle()),
                   radius = exactly(Middle<std::decay_t<decltype(x.middle())>>::number(x.radius()));
    return {middle - radius, middle + radius};
  } else {
    const Number radius = x.widened(0x1p-95 * x.most()).radius();  // and the rounding of the sums
    return {x.middle() - radius, x.middle() + radius};
  }
}

inline const Rational& middle_of(const Rational& x) { return x; }
template <class M>
const M& middle_of(const BallOf<M>& x) {
  return x.middle();
}
inline bool is_above_zero(const Rational& x) { return x > 0; }
template <class M>
bool is_above_zero(const BallOf<M>& x) {
  return x.middle() > M() && !x.may_be_zero();
}
inline double rough(double x) { return x; }
inline double rough(const Rational& x) { return nearest_double(x); }
template <class M>
double rough(const BallOf<M>& x) {
  return x.rough();
}

/// A bound on a part; nothing where none is known. Rounding may keep it `doubt` away from the values.
template <class Number>
struct Bound {
  std::optional<Number> upper;
  Number doubt{};
};

/// A quotient is at most the largest of those of the coefficients, or of them with binomials.
template <class Number, class S>
Bound<Number> bound_of(const Form<S>& form) {
  Polynomial<S> x = form.over;
  if (form.power > 0) {
    x = with_binomials(x);
    const Polynomial<S> below = power_of_form(form.base, form.power);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!is_above_zero(below[i])) return {};
      x[i] = x[i] / below[i];
    }
  }
  const auto larger = [](const S& a, const S& b) { return middle_of(a) < middle_of(b); };
  const S& largest = *std::ranges::max_element(x, larger);
  Number upper = ends_of<Number>(largest).second;
  if constexpr (is_ball<S>) {
    for (const S& other : x) {
      if ((largest - other).may_be_zero()) upper = std::max(upper, ends_of<Number>(other).second);
    }
  }
  return {upper, std::max(upper, -upper) * Number(0x1p-80)};
}
template <>
inline Bound<double> bound_of<double, double>(const Form<double>& form) {
  const int power = form.power;
  const double slack = form.slack, base_slack = form.base_slack;
  if (power == 0) return {*std::ranges::max_element(form.over) + slack, 8 * slack};
  Polynomial<double> base = form.base;
  for (double& x : base) x -= base_slack;
  const double smallest = *std::ranges::min_element(base);
  if (!(smallest > 0)) return {};  // it may be 0 there
  const Polynomial<double> below = power_of_form(base, power), above = with_binomials(form.over);
  double upper = 0, binomial = 1;
  for (std::size_t i = 0; i < above.size(); ++i) {
    upper = std::max(upper, (above[i] + slack * binomial) / below[i] * (1 + relative_rounding));
    binomial *= static_cast<double>(above.size() - 1 - i) / static_cast<double>(i + 1);
  }
  return {upper, 8 * (slack / power_of(smallest, power) + power * upper * (base_slack / smallest + relative_rounding))};
}

/// A value that is attained at the start of a part, or at its end; nothing where none is known.
template <class Number, class S>
std::optional<Number> value_at_end(const Form<S>& form, bool last) {
  const S &above = last ? form.over.back() : form.over.front(), &base = last ? form.base.back() : form.base.front();
  if constexpr (std::is_same_v<S, double>) {
    if (form.power == 0) return above - form.slack;
    return std::max(0.0, above - form.slack) / power_of(base + form.base_slack, form.power) * (1 - relative_rounding);
  } else {
    if (form.power == 0) return ends_of<Number>(above).first;
    const S below = power_of(base, form.power);
    return is_above_zero(below) ? std::optional(ends_of<Number>(S(above / below)).first) : std::nullopt;
  }
}

/// Where a function on [0, 1] is no longer above 0, if it is at first and falls.
template <class F>
double falling_root(const F& f) {
  if (!(f(0) > 0)) return 0;
  if (f(1) > 0) return 1;
  double low = 0;
  for (double size = 0.5; size >= 0x1p-45; size /= 2) low += f(low + size) >= 0 ? size : 0;
  return low;
}

/// Either will do where balls may be equal.
template <class S>
S larger_of(const S& a, const S& b) {
  if constexpr (is_ball<S>) {
    return rough_max(a, b);
  } else {
    return std::max(a, b);
  }
}

/// Where the largest value on [0, 1] probably is: the root of the derivative.
template <class S>
double likely_place(const Form<S>& form) {
  using std::abs;
  const auto differences = [](const Polynomial<S>& x) {
    Polynomial<S> result;
    for (std::size_t i = 1; i < x.size(); ++i) result.push_back(x[i] - x[i - 1]);
    return result;
  };
  const auto in_units = [](const Polynomial<S>& x) {  // near doubles, by rising powers
    S unit(0);
    for (const S& coefficient : x) unit = larger_of(unit, S(abs(coefficient)));
    Polynomial<double> result(x.size());
    if constexpr (is_ball<S>) unit = without_radius(unit);
    if (is_exactly_zero(unit)) return result;
    for (std::size_t i = 0; i < x.size(); ++i) result[i] = rough(S(x[i] / unit));
    return from_bernstein(result);
  };
  if (form.over.size() == 1) return 0;
  if (form.power == 0) {
    return falling_root([rate = in_units(differences(form.over))](double u) { return value_at(rate, u); });
  }
  const Polynomial<double> over = in_units(form.over), base = in_units(form.base);
  return falling_root([&, over_rate = derivative(over), base_rate = derivative(base)](double u) {
    return value_at(over_rate, u) * value_at(base, u) - form.power * value_at(over, u) * value_at(base_rate, u);
  });
}

}  // namespace tcb::limits
