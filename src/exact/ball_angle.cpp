// Angles of balls: sine, cosine, and the angle of a vector.
//
// Method: an angle is k pi/16 and a rest, whose Taylor series are short. The sines and cosines of k pi/16 are nested
// square roots. The angle of a vector is that of its middle in doubles, and the arc tangent of the small rest that
// remains when the vector is turned back by it.
#include "exact/ball_angle.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace tcb {
namespace {

/// Pi, of which the next bits are -0x1.f1976b7ed8fbcp-109.
Ball pi() { return Ball({0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}, 0x1p-108); }

constexpr std::size_t parts = 8;  // of a quarter turn

/// The sines and cosines of k pi/16, for k from 0 to 7.
std::array<spline::SineCosine<Ball>, parts> make_directions() {
  const Ball two(2.0), root = sqrt(two + sqrt(two));
  const spline::SineCosine<Ball> first{halved(sqrt(two - root)), halved(sqrt(two + root))};
  std::array<spline::SineCosine<Ball>, parts> result{{{Ball(), Ball(1.0)}, first}};
  for (std::size_t k = 2; k < parts; ++k) {
    const auto& [sine, cosine] = result[k - 1];
    result[k] = {sine * first.cosine + cosine * first.sine, cosine * first.cosine - sine * first.sine};
  }
  return result;
}

/// 1/n!, for n up to 17.
std::array<Ball, 18> make_inverse_factorials() {
  std::array<Ball, 18> result;
  result[0] = Ball(1.0);
  for (std::size_t n = 1; n < result.size(); ++n) result[n] = result[n - 1] / Ball(n);
  return result;
}

/// The squares of smaller numbers may be beyond the range of balls, and do not matter.
constexpr double tiny = 0x1p-60;

/// The sine and cosine of |rest| < 0.1, by their series. The first terms that are left out, of 19th and 18th degree,
/// are below 2^-115 of the rest and 2^-112, and bound all of them.
spline::SineCosine<Ball> sine_cosine_of_rest(const Ball& rest) {
  if (rest.most() < tiny) return {rest.widened(0x1p-120 * rest.most()), Ball(1.0).widened(0x1p-120)};
  static const std::array<Ball, 18> inverse = make_inverse_factorials();
  const Ball z = -(rest * rest);
  Ball odd = inverse[17], even = inverse[16];
  for (std::size_t n = 15; n > 1; n -= 2) {
    odd = inverse[n] + z * odd;
    even = inverse[n - 1] + z * even;
  }
  return {(rest + rest * z * odd).widened(0x1p-115 * rest.most()), (Ball(1.0) + z * even).widened(0x1p-112)};
}

}  // namespace

spline::SineCosine<Ball> sine_cosine(const Ball& angle) {
  if (angle.is_zero()) return {Ball(), Ball(1.0)};
  constexpr double largest = 1000, sixteen_over_pi = 0x1.45f306dc9c883p+2;
  if (!(angle.most() < largest)) throw Undecided();
  static const Ball part = pi() / Ball(16.0);
  static const std::array<spline::SineCosine<Ball>, parts> directions = make_directions();
  const double count = std::nearbyint(angle.middle().hi * sixteen_over_pi);
  const Ball rest = angle - part * Ball(count);
  if (!(rest.most() < 0.1)) throw Undecided();
  const auto turned = static_cast<std::size_t>(static_cast<int>(count) & 31);
  const auto& [a, b] = directions[turned % parts];
  const auto [c, d] = sine_cosine_of_rest(rest);
  const Ball sine = a * d + b * c, cosine = b * d - a * c;
  switch (turned / parts) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

Ball angle_of(const Ball& y, const Ball& x) {
  if (y.is_zero()) return x > Ball() ? Ball() : pi();
  const double rough = spline::angle_of(std::abs(y.middle().hi), x.middle().hi);
  const auto [sine, cosine] = sine_cosine(Ball(rough));
  const Ball tangent = (y * cosine - x * sine) / (x * cosine + y * sine);
  if (!(tangent.most() < 0x1p-20)) throw Undecided();
  if (tangent.most() < tiny) return Ball(rough) + tangent.widened(0x1p-120 * tangent.most());
  const Ball z = tangent * tangent;
  const Ball rest = tangent - tangent * z * (Ball(1.0) / Ball(3.0) - z / Ball(5.0));
  return Ball(rough) + rest.widened(0x1p-120 * tangent.most());  // the next term is a seventh of z^3
}

}  // namespace tcb
