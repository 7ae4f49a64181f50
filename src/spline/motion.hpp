// Motion: velocity, acceleration and jerk per unit of time, and the shape of the path: tangent, curvature, torsion.
//
//   curvature = |v ^ a| / |v|^3          torsion = det(v, a, j) / |v ^ a|^2
// with |v ^ a|^2 the sum of the squared 2 x 2 minors, so for any number of channels; in more than three
// the torsion has no sign and det is the root of the sum of the squared 3 x 3 minors.
// Source: C. Jordan, "Sur la théorie des courbes dans l'espace à n dimensions", 1874.
// Undefined quantities are said to be so, and what rounding cannot tell from zero is zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "spline/ease.hpp"

namespace tcb::spline {

/// The derivatives of a segment at one place, a number a channel, with bounds on the rounding of the first two.
template <class S>
struct Motion {
  std::vector<S> velocity, acceleration, jerk;
  S velocity_noise{}, acceleration_noise{};
};

/// Sets the derivatives by time at a place that is reached after the fraction u of the duration h.
template <class S>
void set_motion(Motion<S>& motion, std::span<const Cubic<S>> segment, const Local<S>& at, const Warp<S>& warp,
                const S& u, const S& h) {
  using std::abs;
  const S rate = warp.slope(u) / h;
  const S bend = warp.bend(u) / (h * h);
  const S unit(0x1p-50);
  motion.velocity.clear();
  motion.acceleration.clear();
  motion.jerk.clear();
  motion.velocity_noise = motion.acceleration_noise = S(0);
  const S x = at.near_start() ? at.u : at.w;
  for (const Cubic<S>& cubic : segment) {
    const S& first = at.near_start() ? cubic.out : cubic.in;
    const S& second = at.near_start() ? cubic.c : cubic.e;
    const S d1 = first + x * (S(2) * second + x * (S(3) * cubic.d));
    const S d2 = S(2) * second + S(6) * x * cubic.d;
    const S d3 = S(6) * cubic.d;
    motion.velocity.push_back(d1 * rate);
    motion.acceleration.push_back(d2 * rate * rate + d1 * bend);
    motion.jerk.push_back(d3 * rate * rate * rate + S(3) * d2 * rate * bend);
    const S size1 = abs(first) + abs(x) * (S(2) * abs(second) + S(3) * abs(x * cubic.d));
    const S size2 = S(2) * abs(second) + S(6) * abs(x * cubic.d);
    motion.velocity_noise += unit * size1 * abs(rate);
    motion.acceleration_noise += unit * (size2 * rate * rate + size1 * abs(bend));
  }
}

/// Looks at some channels of a vector as if they were all.
template <class S>
class Picked {
 public:
  Picked(const std::vector<S>& values, std::span<const std::size_t> metric) : values_(values), metric_(metric) {}
  std::size_t size() const { return metric_.empty() ? values_.size() : metric_.size(); }
  const S& operator[](std::size_t i) const { return values_[metric_.empty() ? i : metric_[i]]; }

 private:
  const std::vector<S>& values_;
  std::span<const std::size_t> metric_;
};

/// |v|^2
template <class S>
S square(const Picked<S>& v) {
  S sum(0);
  for (std::size_t i = 0; i < v.size(); ++i) sum += v[i] * v[i];
  return sum;
}

template <class S>
S norm(const Picked<S>& v) {
  using std::sqrt;
  return sqrt(square(v));
}

/// a d - b c, right to its last digits also where the products cancel.
template <class S>
S minor2(const S& a, const S& b, const S& c, const S& d) {
  using W = working_t<S>;
  return narrow<S>(W(a) * W(d) - W(b) * W(c));
}

/// |v ^ a|^2
template <class S>
S wedge_square(const Picked<S>& v, const Picked<S>& a) {
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
S wedge(const Picked<S>& v, const Picked<S>& a) {
  using std::sqrt;
  return sqrt(wedge_square(v, a));
}

/// det(v, a, j) of the channels p, q, r.
template <class S>
S minor3(const Picked<S>& v, const Picked<S>& a, const Picked<S>& j, std::size_t p, std::size_t q, std::size_t r) {
  return v[p] * minor2(a[q], a[r], j[q], j[r]) - v[q] * minor2(a[p], a[r], j[p], j[r]) +
         v[r] * minor2(a[p], a[q], j[p], j[q]);
}

/// |v ^ a ^ j|^2
template <class S>
S wedge_square(const Picked<S>& v, const Picked<S>& a, const Picked<S>& j) {
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
S wedge(const Picked<S>& v, const Picked<S>& a, const Picked<S>& j) {
  using std::sqrt;
  return v.size() == 3 ? minor3(v, a, j, 0, 1, 2) : sqrt(wedge_square(v, a, j));
}

/// A motion over the metric channels with each of its derivatives in units of a power of two, so that products and
/// squares neither overflow nor vanish.
template <class S>
class ScaledMotion {
 public:
  ScaledMotion(const Motion<S>& motion, std::span<const std::size_t> metric)
      : v(motion.velocity, metric),
        a(motion.acceleration, metric),
        j(motion.jerk, metric),
        v_noise(v.scaled(motion.velocity_noise)),
        a_noise(a.scaled(motion.acceleration_noise)) {}

  struct Vector {
    Vector(const std::vector<S>& all, std::span<const std::size_t> metric) {
      using std::abs, std::frexp;
      const Picked<S> picked(all, metric);
      S largest(0);
      for (std::size_t i = 0; i < picked.size(); ++i) largest = std::max(largest, S(abs(picked[i])));
      (void)frexp(largest, &exponent);
      for (std::size_t i = 0; i < picked.size(); ++i) values.push_back(scaled(picked[i]));
    }
    S scaled(const S& value) const {
      using std::ldexp;
      return ldexp(value, -exponent);
    }
    operator Picked<S>() const { return {values, {}}; }  // NOLINT(google-explicit-constructor): it is one

    int exponent = 0;  ///< of the unit
    std::vector<S> values;
  };

  Vector v, a, j;
  S v_noise, a_noise;
};

/// What is known of the path's shape at one place, over the metric channels.
template <class S>
struct Shape {
  S speed{};
  bool moves = false;          ///< there is a tangent: velocity / speed
  std::optional<S> curvature;  ///< where there is a tangent
};

/// |v ^ a| in its units, 0 where rounding cannot tell it from that. Requires: there is a tangent.
template <class S>
S bend_area(const ScaledMotion<S>& in) {
  const S area = wedge<S>(in.v, in.a);
  return area > in.v_noise * norm<S>(in.a) + in.a_noise * norm<S>(in.v) ? area : S(0);
}

template <class S>
Shape<S> shape(const Motion<S>& motion, std::span<const std::size_t> metric) {
  using std::ldexp;
  const ScaledMotion<S> in(motion, metric);
  const S speed = norm<S>(in.v);
  Shape<S> result{ldexp(speed, in.v.exponent), speed > in.v_noise, {}};
  if (!result.moves) return result;
  result.curvature = ldexp(bend_area(in) / speed / speed / speed, in.a.exponent - 2 * in.v.exponent);
  return result;
}

/// The torsion, where the curvature is not 0.
template <class S>
std::optional<S> torsion(const Motion<S>& motion, std::span<const std::size_t> metric) {
  using std::abs, std::ldexp;
  const ScaledMotion<S> in(motion, metric);
  const S speed = norm<S>(in.v);
  if (!(speed > in.v_noise)) return std::nullopt;
  const S area = bend_area(in);
  if (area == S(0)) return std::nullopt;
  const S volume = in.v.values.size() < 3 ? S(0) : wedge<S>(in.v, in.a, in.j);
  const S across = norm<S>(in.a);
  const S noise = norm<S>(in.j) * (in.v_noise * across + in.a_noise * speed + S(0x1p-50) * speed * across);
  if (!(abs(volume) > noise)) return S(0);
  return ldexp(volume / area / area, in.j.exponent - in.v.exponent - in.a.exponent);
}

}  // namespace tcb::spline
