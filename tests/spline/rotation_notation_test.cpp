// Notations of rotations: Euler angles of all orders, axis and angle, matrices, and where forms are not unique.
#include "tcb/spline/rotation_notation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace tcb::spline {
namespace {

constexpr double pi = 3.141592653589793;

double distance(const Quaternion<double>& a, const Quaternion<double>& b) {
  const Quaternion<double> turn = conjugate(a) * b;
  return std::max({std::abs(turn.x), std::abs(turn.y), std::abs(turn.z)});
}

std::vector<RotationNotation> euler_notations() {
  std::vector<RotationNotation> all;
  for (int i = 0; i < 27; ++i) {
    const std::array<std::uint8_t, 3> axes{static_cast<std::uint8_t>(i / 9), static_cast<std::uint8_t>(i / 3 % 3),
                                           static_cast<std::uint8_t>(i % 3)};
    if (axes[0] == axes[1] || axes[1] == axes[2]) continue;
    all.push_back({RotationForm::euler, axes, true, false});
    all.push_back({RotationForm::euler, axes, false, true});
  }
  return all;
}

TEST(RotationNotation, turns_follow_the_right_hand_rule) {
  const auto yaw_then_roll = [](bool intrinsic) {
    return quaternion_from(std::array{90.0, 0.0, 90.0}, {RotationForm::euler, {2, 1, 0}, intrinsic, true});
  };
  EXPECT_LE(distance(yaw_then_roll(true), {0.5, 0.5, 0.5, 0.5}), 1e-15);  // the turned x axis is y
  EXPECT_LE(distance(yaw_then_roll(false), {0.5, -0.5, 0.5, 0.5}), 1e-15);
}

TEST(RotationNotation, euler_angles_of_all_orders_give_the_rotation_again) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const RotationNotation& notation : euler_notations()) {
    for (int i = 0; i < 100; ++i) {
      const auto q = normalized(Quaternion<double>{number(random), number(random), number(random), number(random)});
      const auto angles = numbers_of(q, notation);
      EXPECT_LE(distance(q, quaternion_from(std::span(angles).first(3), notation)), 4e-15);
    }
  }
}

TEST(RotationNotation, the_third_angle_is_zero_where_two_axes_are_parallel) {
  for (const RotationNotation& notation : euler_notations()) {
    const double half = notation.degrees ? 180 : pi;
    const bool is_proper = notation.axes[0] == notation.axes[2];
    for (const double middle : is_proper ? std::array{0.0, half} : std::array{-half / 2, half / 2}) {
      const auto q = quaternion_from(std::array{0.3, middle, 0.4}, notation);
      const auto angles = numbers_of(q, notation);
      EXPECT_NEAR(angles[1], middle, 1e-7 * half);
      EXPECT_EQ(angles[2], 0);
      EXPECT_LE(distance(q, quaternion_from(std::span(angles).first(3), notation)), 4e-15);
    }
  }
}

TEST(RotationNotation, an_axis_has_any_length_and_an_angle_up_to_half_a_turn) {
  const RotationNotation notation{RotationForm::axis_angle, {}, true, true};
  const auto numbers = numbers_of(quaternion_from(std::array{0.0, -1e200, 0.0, 300.0}, notation), notation);
  EXPECT_EQ(numbers[1], 1);
  EXPECT_NEAR(numbers[3], 60, 1e-13);
  const auto none = numbers_of(quaternion_from(std::array{0.0, 0.0, 0.0, 0.0}, notation), notation);
  EXPECT_EQ(none, (std::array<double, 9>{1, 0, 0, 0}));
}

TEST(RotationNotation, whole_quarters_in_degrees_are_exact) {
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const auto [sine, cosine] = sine_cosine_of_half(180.0 * quarter, true);
    EXPECT_EQ(std::abs(sine) + std::abs(cosine), 1) << quarter;
  }
  EXPECT_EQ(sine_cosine_of_half(60.0, true).sine, 0.5);
}

TEST(RotationNotation, a_matrix_turns_column_vectors) {
  const RotationNotation axis_angle{RotationForm::axis_angle, {}, true, true};
  const auto numbers = matrix_of(quaternion_from(std::array{0.0, 0.0, 1.0, 90.0}, axis_angle));
  const std::array<double, 9> expected{0, -1, 0, 1, 0, 0, 0, 0, 1};
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_NEAR(numbers[i], expected[i], 3e-16) << i;
}

TEST(RotationNotation, a_matrix_gives_its_rotation_again) {
  std::mt19937 random(2);
  std::normal_distribution<double> number;
  const RotationNotation notation{RotationForm::matrix};
  for (int i = 0; i < 1000; ++i) {
    const auto q =
        normalized(Quaternion<double>{number(random), number(random), number(random), number(random) / (i + 1)});
    EXPECT_LE(distance(q, quaternion_from(matrix_of(q), notation)), 1e-15);
  }
  const auto half = quaternion_from(std::array{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, notation);
  EXPECT_EQ((std::array<double, 4>{half.x, half.y, half.z, half.w}), (std::array<double, 4>{0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(quaternion_from(std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, notation).w, 1);
}

TEST(RotationNotation, a_matrix_that_is_no_rotation_gives_the_nearest_one) {
  const auto q = quaternion_from(std::array{0.5, -2.0, 0.0, 2.0, 0.5, 0.0, 0.0, 0.0, 0.01}, {RotationForm::matrix});
  const double angle = std::atan2(2, 0.5);  // the largest scalar product with turns around z
  EXPECT_LE(distance(q, {0, 0, std::sin(angle / 2), std::cos(angle / 2)}), 1e-15);
}

}  // namespace
}  // namespace tcb::spline
