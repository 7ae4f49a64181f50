// Near turns: the turns between points that are nearly opposite, which floats of many digits determine.
#include "exact/near_turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tcb {

Ball ball_of(const RealBall& ball) {
  const ErrorBound& radius = ball.radius();
  constexpr int largest = 400;
  if (ball.most() >= ErrorBound::power_of_two(largest)) throw Undecided();
  const double high = ball.middle().rough();
  const Real rest = ball.middle() - Real(high);
  const double low = rest.rough();
  const ErrorBound error = radius + (rest - Real(low)).most() + rest.most() * ErrorBound::power_of_two(-100);
  const double bound =
      error == 0.0 ? 0
                   : std::ldexp(error.mantissa(), static_cast<int>(std::max<std::int64_t>(error.exponent(), -1000)));
  return Ball(spline::DoubleDouble::normalized(high, low)).widened(bound);
}
template <>
Ball from_ball<Ball>(const Ball& ball) {
  return ball;
}
template <>
RealBall from_ball<RealBall>(const Ball& ball) {
  return (RealBall(ball.middle().hi) + RealBall(ball.middle().lo)).widened(ball.radius());
}

spline::RotationSegment<Ball> from_start(const spline::RotationSegment<RealBall>& rotation) {
  const auto rounded = [](const RealBall& number) { return ball_of(number); };
  std::array<spline::Quaternion<Ball>, 4> points{{{Ball(), Ball(), Ball(), Ball(1.0)}}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [x, y, z, w] = conjugate(rotation.points()[0]) * rotation.points()[i];
    const bool is_same = x.is_zero_at_last() && y.is_zero_at_last() && z.is_zero_at_last();
    points[i] = is_same ? points[0] : spline::Quaternion<Ball>{rounded(x), rounded(y), rounded(z), rounded(w)};
  }
  const auto& [x, y, z] = rotation.turn();
  return {rotation.curve(), points, {rounded(x), rounded(y), rounded(z)}};
}

namespace {

/// The turn with its polynomial, by divided differences at the nodes.
NearTurn near_turn(const spline::RotationSegment<RealBall>& rotation, NearTurn result) {
  std::array<spline::Vector3<RealBall>, NearTurn::nodes> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const RealBall u = RealBall(result.place) + RealBall(NearTurn::node(i));
    const auto [from, to] = rotation.pair_at(result.pair, u, RealBall(1.0) - u);
    const auto [x, y, z, w] = conjugate(from) * to;
    numbers[i] = {x, y, z};
  }
  for (std::size_t order = 1; order < numbers.size(); ++order) {
    for (std::size_t i = numbers.size() - 1; i >= order; --i) {
      const RealBall between(NearTurn::node(i) - NearTurn::node(i - order));
      for (std::size_t k = 0; k < 3; ++k) numbers[i][k] = (numbers[i][k] - numbers[i - 1][k]) / between;
    }
  }
  double left_out = 0;  // the next term, as an error of the second one
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) result.coefficients[i][k] = ball_of(numbers[i][k]);
  }
  for (const Ball& last : result.coefficients.back()) left_out += last.most();
  for (std::size_t i = 2; i < NearTurn::nodes; ++i) left_out *= NearTurn::reach;
  double along = 0, square = 0, least = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = result.coefficients[0][k].rough(), slope = result.coefficients[1][k].rough();
    along += value * slope;
    square += slope * slope;
    result.coefficients[1][k] = result.coefficients[1][k].widened(left_out);
  }
  result.nearest = -along / square;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = (result.coefficients[0][k] + Ball(result.nearest) * result.coefficients[1][k]).rough();
    least += value * value;
  }
  result.width = std::sqrt(least / square);
  return result;
}

}  // namespace

std::vector<NearTurn> near_turns(std::span<const spline::RotationSegment<RealBall>> rotations) {
  constexpr double nearly_opposite = 0x1p-26 - 1;  // the dot product of two points
  std::vector<NearTurn> result;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    for (std::size_t pair = 0; pair < rotations[i].pairs(); ++pair) {
      for (const double place : in_doubles(rotations[i]).opposite_places(pair, nearly_opposite)) {
        result.push_back(near_turn(rotations[i], {i, pair, place}));
      }
    }
  }
  return result;
}

}  // namespace tcb
