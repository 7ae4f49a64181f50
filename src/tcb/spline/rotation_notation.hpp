// Notations of rotations: a quaternion from numbers of another form, and back.
//
// Angles turn by the right-hand rule. Euler angles are in the order of their axes.
// Source: E. Bernardes, S. Viollet, "Quaternion to Euler angles conversion", doi:10.1371/journal.pone.0276302.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rotation_form.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// The cosine and sine of half an angle. Requires: |angle| <= 2^20 radians.
inline SineCosine<double> sine_cosine_of_half(double angle, bool degrees) {
  const ReducedAngle half = degrees ? ReducedAngle::of_degrees(angle / 2) : ReducedAngle(angle / 2);
  return {half.sine(), half.cosine()};
}

/// The cosine and sine of half an angle, at a scalar that has functions of its own. In degrees, multiples of 180 are
/// exact.
template <class S>
SineCosine<S> sine_cosine_of_half(const S& angle, bool degrees) {
  if (!degrees) return sine_cosine(S(angle / S(2)));
  const S quarters = whole_below(S(angle / S(180) + S(1) / S(2)));
  const auto [sine, cosine] = sine_cosine(S((angle / S(180) - quarters) * pi<S>() / S(2)));
  switch (static_cast<int>(quarters) & 3) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

/// The vector of numbers that are an axis, with the length 1. Requires: they are not all 0.
template <class S>
Quaternion<S> unit_axis(const S& x, const S& y, const S& z) {
  using std::abs;
  const S unit = power_of_two_below(std::max({S(abs(x)), S(abs(y)), S(abs(z))}));
  return normalized(Quaternion<S>{S(x / unit), S(y / unit), S(z / unit), S(0)});
}

/// A symmetric matrix of four rows, which turns quaternions into others.
template <class S>
using QuaternionMatrix = std::array<std::array<S, 4>, 4>;

/// The square of a matrix, with the trace 1.
template <class S>
QuaternionMatrix<S> squared(const QuaternionMatrix<S>& a) {
  QuaternionMatrix<S> square;
  S trace(0);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      square[i][j] = (a[i][0] * a[0][j] + a[i][1] * a[1][j]) + (a[i][2] * a[2][j] + a[i][3] * a[3][j]);
    }
    trace += square[i][i];
  }
  for (auto& row : square) {
    for (S& number : row) number /= trace;
  }
  return square;
}

/// The eigenvector of the largest eigenvalue. Requires: the trace is 1; no other eigenvalue has its size.
template <class S>
Quaternion<S> eigenvector(const QuaternionMatrix<S>& a) {
  using std::abs;
  QuaternionMatrix<S> power = a;
  constexpr int most = 32;
  for (int i = 0; i < most; ++i) {
    power = squared(power);
    S purity(0);  // the sum of the squares of the eigenvalues, which are not negative and whose sum is 1
    for (const auto& row : power) {
      for (const S& number : row) purity += number * number;
    }
    if (abs(S(purity - S(1))) <= S(8) * std::numeric_limits<S>::epsilon()) break;
  }
  std::size_t largest = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (power[largest][largest] < power[i][i]) largest = i;
  }
  const auto& [x, y, z, w] = power[largest];
  Quaternion<S> q = normalized(Quaternion<S>{x, y, z, w});
  for (int refinement = 0; refinement < 2; ++refinement) {
    const auto product = [&](std::size_t i) { return S(dot(q, {a[i][0], a[i][1], a[i][2], a[i][3]})); };
    q = normalized(Quaternion<S>{product(0), product(1), product(2), product(3)});
  }
  return q;
}

/// The rotation nearest to a matrix by the sum of the squares of the differences, with w >= 0: the eigenvector of a
/// matrix that for a rotation is the product of q and its transpose.
/// Source: I. Y. Bar-Itzhack, "New Method for Extracting the Quaternion from a Rotation Matrix", doi:10.2514/2.4654.
/// Requires: the determinant is positive. Promises: for a rotation, each number within 2^-51.
template <class S>
Quaternion<S> nearest_rotation(RotationNumbers<S> m) {
  using std::abs;
  S largest(0), squares(0);
  for (const S& number : m) largest = std::max(largest, S(abs(number)));
  const S unit = power_of_two_below(largest);
  for (S& number : m) {
    number /= unit;
    squares += number * number;
  }
  const S size = square_root(S(squares / S(3)));  // 1 / unit for a rotation
  const auto part = [&](const S& sum) { return S(sum / (S(4) * size)); };
  const S xy = part(m[1] + m[3]), xz = part(m[2] + m[6]), yz = part(m[5] + m[7]);
  const S xw = part(m[7] - m[5]), yw = part(m[2] - m[6]), zw = part(m[3] - m[1]);
  const S xx = part(size + m[0] - m[4] - m[8]), yy = part(size - m[0] + m[4] - m[8]);
  const S zz = part(size - m[0] - m[4] + m[8]), ww = part(size + m[0] + m[4] + m[8]);
  const Quaternion<S> q = eigenvector<S>({{{xx, xy, xz, xw}, {xy, yy, yz, yw}, {xz, yz, zz, zw}, {xw, yw, zw, ww}}});
  return q.w < S(0) ? -q : q;
}

/// The length of the vector that the first three numbers are.
template <class Numbers, class S = std::remove_cvref_t<decltype(std::declval<Numbers>()[0])>>
S length_of_vector(const Numbers& numbers) {
  return square_root(S(numbers[0] * numbers[0] + (numbers[1] * numbers[1] + numbers[2] * numbers[2])));
}

/// The rotation that numbers give. Requires: the form is not that of quaternions; an axis is not zero unless its angle
/// is; the determinant of a matrix is positive. Promises: |q| = 1 within 2^-52.
template <class Numbers, class S = std::remove_cvref_t<decltype(std::declval<Numbers>()[0])>>
Quaternion<S> quaternion_from(const Numbers& numbers, const RotationNotation& notation) {
  if (notation.form == RotationForm::matrix) {
    RotationNumbers<S> matrix;
    std::ranges::copy(numbers, matrix.begin());
    return nearest_rotation(matrix);
  }
  if (notation.form == RotationForm::axis_angle || notation.form == RotationForm::rotation_vector) {
    if (numbers[0] == S(0) && numbers[1] == S(0) && numbers[2] == S(0)) return {S(0), S(0), S(0), S(1)};
    const S angle = notation.form == RotationForm::axis_angle ? S(numbers[3]) : length_of_vector(numbers);
    const auto [sine, cosine] = sine_cosine_of_half(angle, notation.degrees);
    const Quaternion<S> axis = unit_axis(numbers[0], numbers[1], numbers[2]);
    return normalized(Quaternion<S>{S(axis.x * sine), S(axis.y * sine), S(axis.z * sine), cosine});
  }
  Quaternion<S> q{S(0), S(0), S(0), S(1)};
  for (std::size_t i = 0; i < notation.axes.size(); ++i) {
    const auto [sine, cosine] = sine_cosine_of_half(numbers[i], notation.degrees);
    std::array<S, 3> v{};
    v[notation.axes[i]] = sine;
    const Quaternion<S> turn{v[0], v[1], v[2], cosine};
    q = notation.intrinsic ? q * turn : turn * q;
  }
  return normalized(q);
}

/// The rotation after a turn. `in_parent`: in the frame outside that of the rotation before, otherwise in that frame.
template <class S>
Quaternion<S> after_turn(const Quaternion<S>& before, const Quaternion<S>& turn, bool in_parent) {
  return normalized(in_parent ? turn * before : before * turn);
}

/// The turn from a rotation to the next one, in the frame of the first, that the numbers of an axis and an angle give.
template <class S>
TurnVector<S> turn_vector_from(const RotationNumbers<S>& numbers, bool degrees, const Quaternion<S>& before,
                               bool in_parent) {
  Quaternion<S> axis = unit_axis(numbers[0], numbers[1], numbers[2]);
  if (in_parent) axis = conjugate(before) * axis * before;
  const S half = degrees ? S(numbers[3] / S(360) * pi<S>()) : S(numbers[3] / S(2));
  return {S(axis.x * half), S(axis.y * half), S(axis.z * half)};
}

/// The angle of the vector (x, y) in (-pi, pi].
template <class S>
S direction(const S& y, const S& x) {
  return y < S(0) ? S(-angle_of(S(-y), x)) : angle_of(S(y), x);
}

/// A number of degrees or radians from radians.
template <class S>
S in_unit(const S& radians, bool degrees) {
  if (!degrees) return radians;
  if constexpr (std::is_same_v<S, double>) {
    constexpr double high = 0x1.ca5dc1a63c1f8p+5, low = -0x1.1e7ab456405f9p-49;  // 180/pi
    const auto product = two_product(radians, high);
    return product.value + (product.error + radians * low);
  } else {
    return radians * S(180) / pi<S>();
  }
}

/// Euler angles in radians: in (-pi, pi], the second one in [0, pi], or [-pi/2, pi/2] if the axes all differ. Where the
/// second makes the first and the third axis parallel, the third angle is 0.
template <class S>
std::array<S, 3> euler_angles(const Quaternion<S>& q, const RotationNotation& notation) {
  auto [i, j, k] = notation.axes;
  if (notation.intrinsic) std::swap(i, k);  // the same turns as around fixed axes in the other order
  const bool is_proper = i == k;
  if (is_proper) k = static_cast<std::uint8_t>(3 - i - j);
  const int parity = (i - j) * (j - k) * (k - i) / 2;
  const std::array<S, 3> v{q.x, q.y, q.z};
  const S third = S(parity) * v[k];
  const S a = is_proper ? q.w : S(q.w - v[j]), b = is_proper ? v[i] : S(v[i] + third);
  const S c = is_proper ? v[j] : S(v[j] + q.w), d = is_proper ? third : S(third - v[i]);
  const S pi = spline::pi<S>(), small = S(8) * std::numeric_limits<S>::epsilon();
  const S first = square_root(a * a + b * b), second = square_root(c * c + d * d);
  S middle = S(2) * angle_of(second, first);
  const bool is_zero = second < small, is_half_turn = first < small;
  const S sum = is_half_turn ? S(0) : direction(b, a), difference = is_zero ? S(0) : direction(d, c);
  S before = sum - difference, after = sum + difference;  // around i and k
  if (is_zero || is_half_turn) {
    S& kept = notation.intrinsic ? after : before;
    S& other = notation.intrinsic ? before : after;
    kept = is_zero ? S(2 * sum) : notation.intrinsic ? S(2 * difference) : S(-2 * difference);
    other = S(0);
  }
  if (!is_proper) {
    after = S(parity) * after;
    middle = middle - pi / S(2);
  }
  for (S* const angle : {&before, &after}) {
    if (*angle > pi) *angle -= pi + pi;
    if (*angle <= -pi) *angle += pi + pi;
  }
  return notation.intrinsic ? std::array<S, 3>{after, middle, before} : std::array<S, 3>{before, middle, after};
}

/// The nine numbers of the matrix that turns column vectors, row after row. The norm of q has no effect, so that its
/// rounding has none.
template <class S>
RotationNumbers<S> matrix_of(const Quaternion<S>& q) {
  const auto& [x, y, z, w] = q;
  const S xx = x * x, yy = y * y, zz = z * z, ww = w * w;
  const S square = (xx + yy) + (zz + ww), two(2);
  RotationNumbers<S> m{S((ww + xx) - (yy + zz)), S(two * (x * y - z * w)), S(two * (x * z + y * w)),
                       S(two * (x * y + z * w)), S((ww + yy) - (xx + zz)), S(two * (y * z - x * w)),
                       S(two * (x * z - y * w)), S(two * (y * z + x * w)), S((ww + zz) - (xx + yy))};
  for (S& number : m) number /= square;
  return m;
}

/// The numbers of a rotation in a notation, where zeros may have a sign.
template <class S>
RotationNumbers<S> signed_numbers_of(Quaternion<S> q, const RotationNotation& notation) {
  if (notation.form == RotationForm::matrix) return matrix_of(q);
  if (notation.is_quaternion()) return {q.x, q.y, q.z, q.w};
  if (notation.form == RotationForm::euler) {
    const auto angles = euler_angles(q, notation);
    return {in_unit(angles[0], notation.degrees), in_unit(angles[1], notation.degrees),
            in_unit(angles[2], notation.degrees)};
  }
  if (q.w < S(0)) q = -q;
  const S sine = square_root(q.x * q.x + (q.y * q.y + q.z * q.z));
  const bool is_vector = notation.form == RotationForm::rotation_vector;
  if (sine == S(0)) return {S(is_vector ? 0 : 1)};
  const S angle = in_unit(S(S(2) * angle_of(sine, q.w)), notation.degrees);
  const S size = is_vector ? angle : S(1);
  return {S(q.x / sine * size), S(q.y / sine * size), S(q.z / sine * size), is_vector ? S(0) : angle};
}

/// The numbers of a rotation in a notation. The angle around an axis is in [0, pi]; where it is 0, the axis is x. No
/// zero is negative. Requires: |q| = 1.
template <class S>
RotationNumbers<S> numbers_of(const Quaternion<S>& q, const RotationNotation& notation) {
  RotationNumbers<S> numbers = signed_numbers_of(q, notation);
  for (std::size_t i = 0; i < notation.numbers(); ++i) {
    if (numbers[i] == S(0)) numbers[i] = S(0);
  }
  return numbers;
}

}  // namespace tcb::spline
