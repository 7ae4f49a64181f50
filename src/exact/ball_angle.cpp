// Angles of balls: sine, cosine, the angle of a vector, and the logarithms of rotations.
//
// Method: an angle is k pi/16 and a rest, whose Taylor series are short. The sines and cosines of k pi/16 are nested
// square roots. The angle of a vector is that of its middle in doubles, and the arc tangent of the small rest that
// remains when the vector is turned back by it.
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "exact/ball.hpp"

namespace tcb {
namespace {

template <class B>
B pi();
/// Of which the next bits are -0x1.f1976b7ed8fbcp-109.
template <>
Ball pi<Ball>() {
  return Ball({0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}, 0x1p-108);
}
template <>
RealBall pi<RealBall>() {
  return RealBall(Real::pi(), ErrorBound::power_of_two(3 - Real::bits()));
}

constexpr std::size_t parts = 8;  // of a quarter turn

/// The sines and cosines of k pi/16, for k from 0 to 7.
template <class B>
std::array<spline::SineCosine<B>, parts> make_directions() {
  const B two(2.0), root = sqrt(two + sqrt(two));
  const spline::SineCosine<B> first{halved(sqrt(two - root)), halved(sqrt(two + root))};
  std::array<spline::SineCosine<B>, parts> result{{{B(), B(1.0)}, first}};
  for (std::size_t k = 2; k < parts; ++k) {
    const auto& [sine, cosine] = result[k - 1];
    result[k] = {sine * first.cosine + cosine * first.sine, cosine * first.cosine - sine * first.sine};
  }
  return result;
}

/// 1/n! for n from 0 to an odd number n, of which the terms of a series up to it suffice: with |x| < 0.1, those left
/// out are below 2^-(bits + 12) of x, or of 1.
template <class B>
std::vector<B> make_inverse_factorials(int bits) {
  std::vector<B> result{B(1.0), B(1.0)};
  double size = 2 * std::log2(10.0) + 1;  // of 0.1^(n + 1)/(n + 1)!
  while (size < bits + 12) {
    for (int i = 0; i < 2; ++i) {
      result.push_back(result.back() / B(result.size()));
      size += std::log2(10.0) + std::log2(static_cast<double>(result.size()));
    }
  }
  return result;
}

/// What sines take at one precision.
template <class B>
struct Constants {
  B part;  ///< pi/16
  std::array<spline::SineCosine<B>, parts> directions;
  std::vector<B> inverse_factorials;
};

template <class B>
const Constants<B>& constants() {
  thread_local std::map<int, Constants<B>> known;
  const int bits = B::Ops::bits();
  const auto found = known.find(bits);
  if (found != known.end()) return found->second;
  return known.emplace(bits, Constants<B>{pi<B>() / B(16.0), make_directions<B>(), make_inverse_factorials<B>(bits)})
      .first->second;
}

/// Below this size a square is beyond the digits, and may be beyond the range of balls.
template <class B>
typename B::Bound tiny() {
  return B::Ops::power_of_two(-(B::Ops::bits() / 2 + 10));
}
/// A bound on what is left out there, and beyond the last terms of a series of arc tangents.
template <class B>
typename B::Bound left_out() {
  return B::Ops::power_of_two(-(B::Ops::bits() + 20));
}

/// The sine and cosine of |rest| < 0.1, by their series.
template <class B>
spline::SineCosine<B> sine_cosine_of_rest(const B& rest, const std::vector<B>& inverse) {
  if (rest.most() < tiny<B>()) return {rest.widened(left_out<B>() * rest.most()), B(1.0).widened(left_out<B>())};
  const B z = -(rest * rest);
  std::size_t n = inverse.size() - 1;
  B odd = inverse[n], even = inverse[n - 1];
  for (n -= 2; n > 1; n -= 2) {
    odd = inverse[n] + z * odd;
    even = inverse[n - 1] + z * even;
  }
  const auto error = B::Ops::power_of_two(-(B::Ops::bits() + 12));
  return {(rest + rest * z * odd).widened(error * rest.most()), (B(1.0) + z * even).widened(error)};
}

double rough_angle(const Ball& y, const Ball& x) { return spline::angle_of(std::abs(y.rough()), x.rough()); }
double rough_angle(const RealBall& y, const RealBall& x) {
  int exponent = 0;
  (void)frexp(y.most() < x.most() ? x : y, &exponent);
  return spline::angle_of(std::abs(ldexp(y, -exponent).rough()), ldexp(x, -exponent).rough());
}

/// Squares below this have short series.
template <class B>
bool is_small(const B& square) {
  return square.most() < B::Ops::power_of_two(-40);
}
/// The number of terms, each of which is below 2^-40 of the one before, after which those left out are below
/// 2^-(bits + 20).
template <class B>
int terms() {
  return (B::Ops::bits() + 20) / 40 + 1;
}

}  // namespace

template <class M>
spline::SineCosine<BallOf<M>> sine_cosine(const BallOf<M>& whole_angle) {
  using B = BallOf<M>;
  if (whole_angle.is_zero()) return {B(), B(1.0)};
  B angle = whole_angle;
  if (!(angle.most() < typename B::Bound(100.0))) {
    const B turn = B(2.0) * pi<B>();
    angle = angle - turn * B(B::Ops::floor((angle / turn).middle()));
  }
  constexpr double largest = 1000, sixteen_over_pi = 0x1.45f306dc9c883p+2;
  if (!(angle.most() < typename B::Bound(largest))) throw Undecided();
  const auto& [part, directions, inverse] = constants<B>();
  const double count = std::nearbyint(angle.rough() * sixteen_over_pi);
  const B rest = angle - part * B(count);
  if (!(rest.most() < typename B::Bound(0.1))) throw Undecided();
  const auto turned = static_cast<std::size_t>(static_cast<int>(count) & 31);
  const auto& [a, b] = directions[turned % parts];
  const auto [c, d] = sine_cosine_of_rest(rest, inverse);
  const B sine = a * d + b * c, cosine = b * d - a * c;
  switch (turned / parts) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

template <class M>
BallOf<M> angle_of(const BallOf<M>& y, const BallOf<M>& x) {
  using B = BallOf<M>;
  if (y.is_zero()) return x > B() ? B() : pi<B>();
  const double rough = rough_angle(y, x);
  const auto [sine, cosine] = sine_cosine(B(rough));
  const B tangent = (y * cosine - x * sine) / (x * cosine + y * sine);
  if (!(tangent.most() < B::Ops::power_of_two(-20))) throw Undecided();
  if (tangent.most() < tiny<B>()) return B(rough) + tangent.widened(left_out<B>() * tangent.most());
  const B z = -(tangent * tangent);
  B sum;
  for (int n = terms<B>() - 1; n >= 0; --n) sum = B(1.0) / B(2 * n + 1) + z * sum;
  return B(rough) + (tangent * sum).widened(left_out<B>() * tangent.most());
}

template <class M>
spline::Quaternion<BallOf<M>> enclosed_exponential(const spline::Vector3<BallOf<M>>& v) {
  using B = BallOf<M>;
  const B square = v[0] * v[0] + (v[1] * v[1] + v[2] * v[2]);
  B factor, cosine;
  if (is_small(square)) {  // the series of sine and cosine
    factor = cosine = B(1.0);
    for (int n = terms<B>(); n > 0; --n) {
      factor = B(1.0) - factor * square / B(2 * n * (2 * n + 1));
      cosine = B(1.0) - cosine * square / B(2 * n * (2 * n - 1));
    }
    factor = factor.widened(B::Ops::power_of_two(-(B::Ops::bits() + 20)) * square.most());
    cosine = cosine.widened(B::Ops::power_of_two(-(B::Ops::bits() + 20)) * square.most());
  } else {
    const B angle = sqrt(square);
    const auto [sine, along] = sine_cosine(angle);
    factor = sine / angle;
    cosine = along;
  }
  return {v[0] * factor, v[1] * factor, v[2] * factor, cosine};
}

/// Near no turn, by the series of the arc sine.
template <class M>
spline::Vector3<BallOf<M>> enclosed_logarithm(const spline::Quaternion<BallOf<M>>& q) {
  using B = BallOf<M>;
  const B square = q.x * q.x + (q.y * q.y + q.z * q.z);
  B factor;
  if (is_small(square) && q.w > B()) {
    factor = B(1.0);
    B term(1.0);
    for (int n = 1; n <= terms<B>(); ++n) {
      term = term * square * B(2 * n - 1) / B(2 * n);
      factor = factor + term / B(2 * n + 1);
    }
    factor = factor.widened(B::Ops::power_of_two(-(B::Ops::bits() + 20)) * square.most());
  } else {
    const B sine = sqrt(square);
    factor = angle_of(sine, q.w) / sine;
  }
  return {q.x * factor, q.y * factor, q.z * factor};
}

template spline::SineCosine<Ball> sine_cosine(const Ball& angle);
template spline::SineCosine<RealBall> sine_cosine(const RealBall& angle);
template Ball angle_of(const Ball& y, const Ball& x);
template RealBall angle_of(const RealBall& y, const RealBall& x);
template spline::Quaternion<Ball> enclosed_exponential(const spline::Vector3<Ball>& v);
template spline::Quaternion<RealBall> enclosed_exponential(const spline::Vector3<RealBall>& v);
template spline::Vector3<Ball> enclosed_logarithm(const spline::Quaternion<Ball>& q);
template spline::Vector3<RealBall> enclosed_logarithm(const spline::Quaternion<RealBall>& q);

}  // namespace tcb
