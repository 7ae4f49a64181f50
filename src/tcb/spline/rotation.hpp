// Rotations: the curve of unit quaternions between two keys, and its derivative, at any scalar with roots.
//
// With q_i the keys, q_(i+1) negated where its dot product with q_i is negative, D_i = log(q_i^-1 q_(i+1)) and `out`,
// `in` the tangents that the rules of rules.hpp make of the chords D_i, the curve on segment i is
//   squad:      slerp(slerp(q_i, q_(i+1), u), slerp(a, b, u), 2u (1 - u)),
//               a = q_i exp((out - D_i)/2), b = q_(i+1) exp((D_i - in)/2)
//   casteljau:  de Casteljau's algorithm with slerp over q_i, q_i exp(out/3), q_(i+1) exp(-in/3), q_(i+1)
//   components: the same with lerp over the cubics of the four numbers, normalized
//   slerp:      slerp(q_i, q_(i+1), u)
// A turn of the angle g > 2 pi around the axis n from q_i has D_i = n pi/2. With s = u g/pi, squad runs from q_i and a
// to p = q_i exp(n pi/2) in s <= 1, along q_i exp(s n pi/2) up to the last half turn, and back from q_(i+1) likewise.
// Source: K. Shoemake, "Animating rotation with quaternion curves", doi:10.1145/325165.325242, for slerp and
//   casteljau; D. Eberly, "Key Frame Interpolation via Splines and Quaternions", for squad; the products of the preset
//   nel, for turns.
// Units: logarithms are half the angle of the turn, in radians, along its axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/dual.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation_curve.hpp"
#include "tcb/spline/scalar.hpp"
#include "tcb/spline/segment.hpp"

namespace tcb::spline {

template <class T>
using Vector3 = TurnVector<T>;

template <class T>
struct Quaternion {
  T x{}, y{}, z{}, w{};

  /// Negates all components; zeros stay +0.
  friend Quaternion operator-(const Quaternion& q) { return {T(0) - q.x, T(0) - q.y, T(0) - q.z, T(0) - q.w}; }
  friend Quaternion operator+(const Quaternion& p, const Quaternion& q) {
    return {p.x + q.x, p.y + q.y, p.z + q.z, p.w + q.w};
  }
  friend Quaternion operator*(const Quaternion& q, const T& factor) {
    return {q.x * factor, q.y * factor, q.z * factor, q.w * factor};
  }
  friend Quaternion operator*(const Quaternion& p, const Quaternion& q) {
    return {p.w * q.x + p.x * q.w + (p.y * q.z - p.z * q.y), p.w * q.y + p.y * q.w + (p.z * q.x - p.x * q.z),
            p.w * q.z + p.z * q.w + (p.x * q.y - p.y * q.x), p.w * q.w - p.x * q.x - (p.y * q.y + p.z * q.z)};
  }
};

/// The inverse of a unit quaternion.
template <class T>
Quaternion<T> conjugate(const Quaternion<T>& q) {
  return {-q.x, -q.y, -q.z, q.w};
}

template <class T>
T dot(const Quaternion<T>& p, const Quaternion<T>& q) {
  return (p.x * q.x + p.y * q.y) + (p.z * q.z + p.w * q.w);
}

template <class T>
Quaternion<T> normalized(const Quaternion<T>& q) {
  const T size = square_root(dot(q, q));
  return {q.x / size, q.y / size, q.z / size, q.w / size};
}

/// For doubles, each number rounded about once. Promises: |q| = 1 within 2^-52.
inline Quaternion<double> normalized(const Quaternion<double>& q) {
  Rounded<double> square = two_product(q.x, q.x);
  for (const double number : {q.y, q.z, q.w}) {
    const auto product = two_product(number, number);
    const auto sum = two_sum(square.value, product.value);
    square = {sum.value, square.error + (sum.error + product.error)};
  }
  const double size = std::sqrt(square.value);
  const auto rounded = two_product(size, size);
  const double excess = ((square.value - rounded.value) - rounded.error + square.error) / (2 * square.value);
  const auto divided = [&](double number) {
    const double quotient = number / size;
    return quotient - quotient * excess;
  };
  return {divided(q.x), divided(q.y), divided(q.z), divided(q.w)};
}

/// The arc of unit quaternions from one to another, at a constant rate.
template <class T>
class Arc {
 public:
  Arc() = default;
  Arc(const Quaternion<T>& from, const Quaternion<T>& to) : from_(from), to_(to) {
    const Quaternion<T> turn = conjugate(from) * to;
    square_ = turn.x * turn.x + (turn.y * turn.y + turn.z * turn.z);
    is_short_ = value_of(square_) < 0.015625 && value_of(turn.w) > 0;
    if (is_short_) return;
    sine_ = square_root(square_);
    angle_ = angle_of(sine_, turn.w);
    is_turned_ = value_of(square_) < 0x1p-40;
    if (is_turned_) to_ = turn;
  }

  const Quaternion<T>& from() const { return from_; }

  /// The point after the fraction u of the arc; `left` is 1 - u.
  template <class U>
  Quaternion<U> at(const U& u, const U& left) const {
    if (is_turned_) return turned_by(U(u * angle_));
    const U first = weight(left), second = weight(u);
    return {from_.x * first + to_.x * second, from_.y * first + to_.y * second, from_.z * first + to_.z * second,
            from_.w * first + to_.w * second};
  }

 private:
  /// sin(u angle) / sin(angle). For short arcs, by its series in powers of the square of the sine.
  /// Source: M. Abramowitz, I. A. Stegun, "Handbook of Mathematical Functions", 15.1.16.
  template <class U>
  U weight(const U& u) const {
    if (!is_short_) return sine(U(u * angle_)) / sine_;
    const auto least = std::numeric_limits<value_t<U>>::epsilon() / 8;
    const auto whole = [](int number) { return U(static_cast<value_t<U>>(number)); };
    const U u2 = u * u;
    U sum(1), term(1);
    for (int odd = 1; value_of(term) > least; odd += 2) {
      term = term * ((whole(odd * odd) - u2) * U(square_) / whole((odd + 1) * (odd + 2)));
      sum = sum + term;
    }
    return u * sum;
  }

  /// The point at an angle from the first one, along the direction of the arc. Near opposite points this keeps more
  /// digits than the weights of both.
  template <class U>
  Quaternion<U> turned_by(const U& angle) const {
    const auto [sine, cosine] = sine_cosine(angle);
    const U factor = sine / U(sine_);
    return Quaternion<U>{from_.x, from_.y, from_.z, from_.w} *
           Quaternion<U>{U(to_.x) * factor, U(to_.y) * factor, U(to_.z) * factor, cosine};
  }

  Quaternion<T> from_;
  Quaternion<T> to_;               ///< or the turn to it: is_turned_
  T square_{}, sine_{}, angle_{};  ///< of the angle between the two; for a short arc, the square of its sine alone
  bool is_short_ = true;
  bool is_turned_ = false;  ///< between nearly opposite points
};

/// Half the angle of a rotation along its axis. Requires: |q| = 1.
template <class S>
Vector3<S> logarithm(const Quaternion<S>& q) {
  const S sine = square_root(q.x * q.x + (q.y * q.y + q.z * q.z));
  if (sine == S(0)) return {q.x, q.y, q.z};
  const S factor = angle_of(sine, q.w) / sine;
  return {q.x * factor, q.y * factor, q.z * factor};
}

/// The number of half turns of a turn; 0: it is none.
template <class S>
S half_turns_of(const Vector3<S>& turn) {
  const S half = square_root(turn[0] * turn[0] + (turn[1] * turn[1] + turn[2] * turn[2]));
  return half == S(0) ? S(0) : S(S(2) * half / pi<S>());
}

/// The rotation with a logarithm.
template <class S>
Quaternion<S> exponential(const Vector3<S>& v) {
  const S angle = square_root(v[0] * v[0] + (v[1] * v[1] + v[2] * v[2]));
  if (angle == S(0)) return {v[0], v[1], v[2], S(1)};
  const auto [sine, cosine] = sine_cosine(angle);
  const S factor = sine / angle;
  return {v[0] * factor, v[1] * factor, v[2] * factor, cosine};
}

/// The rotation of a key, from its four numbers: normalized, unless doubles are so already.
template <class S>
Quaternion<S> rotation_of(std::span<const S> numbers, const RotationChannels& channels) {
  using std::abs;
  const Quaternion<S> q{numbers[channels[0]], numbers[channels[1]], numbers[channels[2]], numbers[channels[3]]};
  if constexpr (std::is_same_v<S, double>) {
    const double excess = dot(q, q) - 1;
    if (excess <= 0x1p-52 && excess >= -0x1p-52) return q;
  }
  const S largest = std::max({S(abs(q.x)), S(abs(q.y)), S(abs(q.z)), S(abs(q.w))});
  return normalized(q * S(S(1) / power_of_two_below(largest)));  // whose squares do not overflow
}

/// The curve of a rotation between two keys, or a part of it.
template <class S>
class RotationSegment {
 public:
  RotationSegment() = default;

  /// From four points: the keys, and between them the control points of squad or of de Casteljau's algorithm. `turn`:
  /// that of squad or slerp, if it makes whole turns.
  RotationSegment(RotationCurve curve, const std::array<Quaternion<S>, 4>& points, const Vector3<S>& turn = {})
      : curve_(curve), points_(points), half_turns_(half_turns_of(turn)) {
    if (has_whole_turns()) {
      const S part = S(1) / half_turns_;
      const Quaternion<S> half_turn = exponential<S>({turn[0] * part, turn[1] * part, turn[2] * part});
      const Quaternion<S> after = points[0] * half_turn;
      arcs_ = {Arc<S>(points[0], after), Arc<S>(points[1], after), Arc<S>(points[3] * conjugate(half_turn), points[3])};
      return;
    }
    if (curve == RotationCurve::casteljau) {
      arcs_ = {Arc<S>(points[0], points[1]), Arc<S>(points[1], points[2]), Arc<S>(points[2], points[3])};
    } else if (curve != RotationCurve::components) {
      arcs_[0] = Arc<S>(points[0], points[3]);
      if (curve == RotationCurve::squad) arcs_[1] = Arc<S>(points[1], points[2]);
    }
  }

  /// The part of this curve from the place u = from, of the given size; `left` is what remains after it.
  RotationSegment part(const S& from, const S& size, const S& left) const {
    RotationSegment result = *this;
    result.from_ = from;
    result.size_ = size;
    result.left_ = left;
    return result;
  }

  /// The places between which it turns at a constant rate, beyond its ends or not; the first one is not before the last
  /// one where it does so nowhere.
  std::array<S, 2> constant_part() const {
    if (curve_ == RotationCurve::slerp) return {S(0), S(1)};
    if (!has_whole_turns()) return {S(1), S(0)};
    const S part = S(1) / half_turns_;
    return {S(part - from_) / size_, S(S(1) - part - from_) / size_};
  }

  /// The rotation at a place. Promises: |q| = 1 within 2^-52 for doubles; exact at both ends of a whole curve.
  Quaternion<S> at(const LocalParameter<S>& place) const {
    const auto [u, w] = of_whole(place);
    if (u == S(0)) return points_[0];
    if (w == S(0)) return points_[3];
    return normalized(point<S>(u, -w));
  }

  /// 2 dq/du q^-1: the turn per u, in the frame in which the rotations are given.
  Vector3<S> rate(const LocalParameter<S>& place) const {
    const auto whole = of_whole(place);
    const auto [x, y, z, w] = normalized(point<Dual<S>>({whole.u, size_}, {S(-whole.w), S(-size_)}));
    const Quaternion<S> slope{x.slope, y.slope, z.slope, w.slope};
    const Quaternion<S> turn = slope * conjugate(Quaternion<S>{x.value, y.value, z.value, w.value});
    return {S(2) * turn.x, S(2) * turn.y, S(2) * turn.z};
  }

 private:
  bool has_whole_turns() const { return half_turns_ > S(1.5); }

  LocalParameter<S> of_whole(const LocalParameter<S>& place) const {
    if (size_ == S(1)) return place;
    return {from_ + size_ * place.u, size_ * place.w - left_};
  }
  /// A point of the curve, not yet normalized.
  template <class T>
  Quaternion<T> point(const T& u, const T& left) const {
    if (has_whole_turns()) return turned(u, left);
    if (curve_ == RotationCurve::components) return cubic_point(u, left);
    const Quaternion<T> first = arcs_[0].at(u, left);
    if (curve_ == RotationCurve::slerp) return first;
    const Quaternion<T> second = arcs_[1].at(u, left);
    if (curve_ == RotationCurve::squad) {
      return Arc<T>(first, second).at(T(T(2) * (u * left)), T(u * u + left * left));
    }
    const Quaternion<T> before = Arc<T>(first, second).at(u, left),
                        after = Arc<T>(second, arcs_[2].at(u, left)).at(u, left);
    return Arc<T>(before, after).at(u, left);
  }
  /// A point of whole turns: on the way from the first key, along the great circle, or on the way to the last key.
  template <class T>
  Quaternion<T> turned(const T& u, const T& left) const {
    using std::floor;
    const T one(1), s = u * half_turns_, rest = left * half_turns_;
    const auto squad = [&](const Arc<S>& keys, const Arc<S>& controls, const T& to, const T& from) {
      return Arc<T>(keys.at(to, from), controls.at(to, from)).at(T(T(2) * (to * from)), T(to * to + from * from));
    };
    if (curve_ == RotationCurve::squad && value_of(s) < S(1)) return squad(arcs_[0], arcs_[1], s, T(one - s));
    if (curve_ == RotationCurve::squad && value_of(rest) < S(1)) {
      return squad(arcs_[2], Arc<S>(arcs_[2].from(), points_[2]), T(one - rest), rest);
    }
    const S turns = floor(S(value_of(s) / S(2)));  // each negates the quaternion
    const T within = s - T(S(2) * turns);
    const Quaternion<T> q = arcs_[0].at(within, T(one - within));
    return floor(S(turns / S(2))) * S(2) == turns ? q : -q;
  }
  template <class T>
  Quaternion<T> cubic_point(const T& u, const T& left) const {
    const T three(3);
    const std::array<T, 4> weights{left * left * left, three * (left * left * u), three * (left * u * u), u * u * u};
    Quaternion<T> sum{T(0), T(0), T(0), T(0)};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto& [x, y, z, w] = points_[i];
      sum = sum + Quaternion<T>{T(x), T(y), T(z), T(w)} * weights[i];
    }
    return sum;
  }
  RotationCurve curve_ = RotationCurve::slerp;
  std::array<Quaternion<S>, 4> points_;
  S half_turns_{0};                ///< of the turn; 0: the shorter way
  std::array<Arc<S>, 3> arcs_;     ///< that the curve begins with; those of squad to and from the ends of a turn
  S from_{0}, size_{1}, left_{0};  ///< of a part
};

}  // namespace tcb::spline
