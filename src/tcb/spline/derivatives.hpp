// Derivatives: velocity, acceleration, jerk per unit of time, and the shape of the curve: tangent, curvature, torsion.
//
//   curvature = |v ^ a| / |v|^3          torsion = det(v, a, j) / |v ^ a|^2
// with |v ^ a|^2 the sum of the squared 2 x 2 minors, so for any number of channels; in more than three
// the torsion has no sign and det is the root of the sum of the squared 3 x 3 minors.
// Source: C. Jordan, "Sur la théorie des courbes dans l'espace à n dimensions", 1874.
// Undefined quantities are absent, and a value within its rounding error of zero is zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tcb/spline/ease.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// The derivatives of a segment at one place, a number per channel, with bounds on the rounding of the first two, which
/// are 0 for scalars without roots.
template <class S>
struct Derivatives {
  std::vector<S> velocity, acceleration, jerk;
  S velocity_noise{}, acceleration_noise{};
};

/// dX/du, d2X/du2, d3X/du3 of one channel at one place.
template <class S>
struct LocalDerivatives {
  S d1, d2, d3;
};
template <class S>
LocalDerivatives<S> local_derivatives(const Cubic<S>& cubic, const LocalParameter<S>& at) {
  const S x = at.near_start() ? at.u : at.w;
  const S& first = at.near_start() ? cubic.out : cubic.in;
  const S& second = at.near_start() ? cubic.c : cubic.e;
  return {first + x * (S(2) * second + x * (S(3) * cubic.d)), S(2) * second + S(6) * x * cubic.d, S(6) * cubic.d};
}

/// The derivative of X(w(t)) of any order from 1: F. Faa di Bruno's formula where w is quadratic, and what is added
/// where it is cubic. `rate`, `change`, `third`: the derivatives of w by time.
template <class S>
S derivative_of_quadratic_warp(std::size_t order, const LocalDerivatives<S>& x, const S& rate, const S& change) {
  switch (order) {
    case 1: return x.d1 * rate;
    case 2: return x.d2 * rate * rate + x.d1 * change;
    case 3: return x.d3 * rate * rate * rate + S(3) * x.d2 * rate * change;
    case 4: return S(6) * x.d3 * rate * rate * change + S(3) * x.d2 * change * change;
    case 5: return S(15) * x.d3 * rate * change * change;
    case 6: return S(15) * x.d3 * change * change * change;
    default: return S(0);
  }
}
template <class S>
S derivative_of_cubic_term(std::size_t order, const LocalDerivatives<S>& x, const S& rate, const S& change,
                           const S& third) {
  switch (order) {
    case 3: return x.d1 * third;
    case 4: return S(4) * x.d2 * rate * third;
    case 5: return S(10) * third * (x.d2 * change + x.d3 * rate * rate);
    case 6: return S(10) * third * (x.d2 * third + S(6) * x.d3 * rate * change);
    case 7: return S(35) * x.d3 * third * (S(2) * rate * third + S(3) * change * change);
    case 8: return S(280) * x.d3 * change * third * third;
    case 9: return S(280) * x.d3 * third * third * third;
    default: return S(0);
  }
}

/// The derivative of one channel by time, of any order from 1, at the place reached after the fraction u of the
/// duration h, in a part of the ease; where none is given, at a place between two parts in the later one. It is 0
/// beyond the ninth.
template <class S>
S time_derivative(std::size_t order, const Cubic<S>& cubic, const LocalParameter<S>& at, const Warp<S>& warp,
                  const S& u, const S& h, std::optional<EasePart> given_part = {}) {
  const LocalDerivatives<S> local = local_derivatives(cubic, at);
  const EasePart part = given_part ? *given_part : warp.part(u);
  const S rate = warp.first_derivative(u, part) / h;
  const S change = warp.second_derivative(u, part) / (h * h);
  const S of_quadratic = derivative_of_quadratic_warp<S>(order, local, rate, change);
  if (!warp.is_cubic()) return of_quadratic;
  return of_quadratic + derivative_of_cubic_term<S>(order, local, rate, change, warp.third_derivative() / (h * h * h));
}

/// Sets the derivatives by time at the place reached after the fraction u of the duration h, in a part of the ease, as
/// for time_derivative().
template <class S>
void set_derivatives(Derivatives<S>& of, std::span<const Cubic<S>> segment, const LocalParameter<S>& at,
                     const Warp<S>& warp, const S& u, const S& h, std::optional<EasePart> given_part = {}) {
  using std::abs;
  const EasePart part = given_part ? *given_part : warp.part(u);
  const S rate = warp.first_derivative(u, part) / h;
  const S change = warp.second_derivative(u, part) / (h * h);
  const S third = warp.is_cubic() ? S(warp.third_derivative() / (h * h * h)) : S(0);
  [[maybe_unused]] const S unit(0x1p-50);
  of.velocity.clear();
  of.acceleration.clear();
  of.jerk.clear();
  of.velocity_noise = of.acceleration_noise = S(0);
  const S x = at.near_start() ? at.u : at.w;
  for (const Cubic<S>& cubic : segment) {
    const S& first = at.near_start() ? cubic.out : cubic.in;
    const S& second = at.near_start() ? cubic.c : cubic.e;
    const auto [d1, d2, d3] = local_derivatives(cubic, at);
    of.velocity.push_back(d1 * rate);
    of.acceleration.push_back(d2 * rate * rate + d1 * change);
    of.jerk.push_back(d3 * rate * rate * rate + S(3) * d2 * rate * change);
    if (warp.is_cubic()) of.jerk.back() += d1 * third;
    if constexpr (has_roots<S>) {
      const S size1 = abs(first) + abs(x) * (S(2) * abs(second) + S(3) * abs(x * cubic.d));
      const S size2 = S(2) * abs(second) + S(6) * abs(x * cubic.d);
      of.velocity_noise += unit * size1 * abs(rate);
      of.acceleration_noise += unit * (size2 * rate * rate + size1 * abs(change));
    }
  }
}

/// The metric channels of a vector.
template <class S>
class MetricView {
 public:
  MetricView(const std::vector<S>& values, std::span<const std::size_t> metric) : values_(values), metric_(metric) {}
  std::size_t size() const { return metric_.empty() ? values_.size() : metric_.size(); }
  const S& operator[](std::size_t i) const { return values_[metric_.empty() ? i : metric_[i]]; }

 private:
  const std::vector<S>& values_;
  std::span<const std::size_t> metric_;
};

/// |v|^2
template <class S>
S square(const MetricView<S>& v) {
  S sum(0);
  for (std::size_t i = 0; i < v.size(); ++i) sum += v[i] * v[i];
  return sum;
}

template <class S>
S norm(const MetricView<S>& v) {
  return square_root(square(v));
}

/// a d - b c, accurate to its last digits also where the products cancel.
template <class S>
S minor2(const S& a, const S& b, const S& c, const S& d) {
  using W = working_t<S>;
  return high_part<S>(W(a) * W(d) - W(b) * W(c));
}

/// |v ^ a|^2
template <class S>
S wedge_square(const MetricView<S>& v, const MetricView<S>& a) {
  S sum(0);
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = i + 1; k < v.size(); ++k) {
      const S minor = minor2(v[i], v[k], a[i], a[k]);
      sum += minor * minor;
    }
  }
  return sum;
}

/// |v ^ a|
template <class S>
S wedge(const MetricView<S>& v, const MetricView<S>& a) {
  return square_root(wedge_square(v, a));
}

/// det(v, a, j) of the channels p, q, r.
template <class S>
S minor3(const MetricView<S>& v, const MetricView<S>& a, const MetricView<S>& j, std::size_t p, std::size_t q,
         std::size_t r) {
  return v[p] * minor2(a[q], a[r], j[q], j[r]) - v[q] * minor2(a[p], a[r], j[p], j[r]) +
         v[r] * minor2(a[p], a[q], j[p], j[q]);
}

/// |v ^ a ^ j|^2
template <class S>
S wedge_square(const MetricView<S>& v, const MetricView<S>& a, const MetricView<S>& j) {
  S sum(0);
  for (std::size_t p = 0; p < v.size(); ++p) {
    for (std::size_t q = p + 1; q < v.size(); ++q) {
      for (std::size_t r = q + 1; r < v.size(); ++r) {
        const S minor = minor3(v, a, j, p, q, r);
        sum += minor * minor;
      }
    }
  }
  return sum;
}

/// det(v, a, j) of three channels; of more, |v ^ a ^ j|.
template <class S>
S wedge(const MetricView<S>& v, const MetricView<S>& a, const MetricView<S>& j) {
  return v.size() == 3 ? minor3(v, a, j, 0, 1, 2) : square_root(wedge_square(v, a, j));
}

/// Exponents of the units in which products and squares of derivatives neither overflow nor vanish; 0 for most.
struct Units {
  int v = 0, a = 0, j = 0;
};

template <class S>
int unit_of(const MetricView<S>& vector) {
  using std::abs, std::frexp;
  constexpr int harmless = 100;
  S largest(0);
  for (std::size_t i = 0; i < vector.size(); ++i) largest = std::max(largest, S(abs(vector[i])));
  int exponent = 0;
  (void)frexp(largest, &exponent);
  return abs(exponent) <= harmless ? 0 : exponent;
}

/// The result of `in` for derivatives in such units, and the units. Most derivatives need no scaling.
template <class S, class In>
auto in_units(const Derivatives<S>& of, std::span<const std::size_t> metric, In in) {
  using std::ldexp;
  const Units units{unit_of<S>({of.velocity, metric}), unit_of<S>({of.acceleration, metric}),
                    unit_of<S>({of.jerk, metric})};
  if (units.v == 0 && units.a == 0 && units.j == 0) return in(of, units);
  Derivatives<S> scaled = of;
  for (S& value : scaled.velocity) value = ldexp(value, -units.v);
  for (S& value : scaled.acceleration) value = ldexp(value, -units.a);
  for (S& value : scaled.jerk) value = ldexp(value, -units.j);
  scaled.velocity_noise = ldexp(scaled.velocity_noise, -units.v);
  scaled.acceleration_noise = ldexp(scaled.acceleration_noise, -units.a);
  return in(scaled, units);
}

/// The shape of the curve at one place, over the metric channels.
template <class S>
struct Shape {
  S speed{};
  bool moves = false;          ///< there is a tangent: velocity / speed
  std::optional<S> curvature;  ///< if there is a tangent
};

/// |v ^ a|, or 0 if it is within its rounding error of 0.
template <class S>
S parallelogram(const Derivatives<S>& of, std::span<const std::size_t> metric) {
  const MetricView<S> v(of.velocity, metric), a(of.acceleration, metric);
  const S area = wedge(v, a);
  return area > of.velocity_noise * norm(a) + of.acceleration_noise * norm(v) ? area : S(0);
}

template <class S>
Shape<S> shape(const Derivatives<S>& of, std::span<const std::size_t> metric) {
  using std::ldexp;
  return in_units(of, metric, [metric](const Derivatives<S>& in, const Units& units) {
    const S speed = norm<S>({in.velocity, metric});
    Shape<S> result{ldexp(speed, units.v), speed > in.velocity_noise, {}};
    if (!result.moves) return result;
    result.curvature = ldexp(parallelogram(in, metric) / speed / speed / speed, units.a - 2 * units.v);
    return result;
  });
}

/// The torsion, where the curvature is not 0.
template <class S>
std::optional<S> torsion(const Derivatives<S>& of, std::span<const std::size_t> metric) {
  using std::abs, std::ldexp;
  return in_units(of, metric, [metric](const Derivatives<S>& in, const Units& units) -> std::optional<S> {
    const MetricView<S> v(in.velocity, metric), a(in.acceleration, metric), j(in.jerk, metric);
    const S speed = norm(v), across = norm(a);
    const S area = speed > in.velocity_noise ? parallelogram(in, metric) : S(0);
    if (area == S(0)) return std::nullopt;
    const S volume = v.size() < 3 ? S(0) : wedge(v, a, j);
    const S noise =
        norm(j) * (in.velocity_noise * across + in.acceleration_noise * speed + S(0x1p-50) * speed * across);
    if (!(abs(volume) > noise)) return S(0);
    return ldexp(volume / area / area, units.j - units.v - units.a);
  });
}

}  // namespace tcb::spline
