// Rotations of keys in other forms than quaternions: their quaternions, channels and decimals, and what is refused.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "error.hpp"
#include "keys/rotation_keys.hpp"
#include "keys/rotations.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

/// Keys with a position x, and axes and angles in degrees, as quaternions.
Numbers quaternions_of(const std::vector<Numbers>& keys, bool relative, bool in_parent) {
  const GivenRotation given{
      {spline::RotationForm::axis_angle, {}, true, true}, relative, {"ax", "ay", "az", "angle"}, {1, 2, 3, 4}};
  const RotationSchema rotation{{{{1, 2, 3, 4}, 0}, {}, {}}, given};
  return with_clear_turns(source_of(block_of(keys)), {{rotation}, {}, spline::RotationCurve::squad, in_parent})()
      ->keys.positions;
}

void expect_near(const Numbers& numbers, const Numbers& expected) {
  ASSERT_EQ(numbers.size(), expected.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_NEAR(numbers[i], expected[i], 1e-15) << i;
}

TEST(Rotations, of_an_axis_and_an_angle_become_quaternions) {
  const double root = std::sqrt(0.5);
  const std::vector<Numbers> keys{{0, 0, 2, 90}, {1, 0, 0, 90}};
  expect_near(quaternions_of(keys, false, false), {7, 0, 0, root, root, 7, root, 0, 0, root});
  expect_near(quaternions_of(keys, true, false), {7, 0, 0, root, root, 7, 0.5, 0.5, 0.5, 0.5});
  expect_near(quaternions_of(keys, true, true), {7, 0, 0, root, root, 7, 0.5, -0.5, 0.5, 0.5});
  EXPECT_THROW(quaternions_of({{0, 0, 0, 90}}, false, false), Error);
  EXPECT_THROW(quaternions_of({{0, 0, 1, 3.7e6}}, false, false), Error);
}

TEST(Rotations, of_three_angles_get_a_channel_more) {
  KeyBlock block;
  block.keys.channels = 4;
  block.keys.times = {0.0, 1.0};
  block.keys.positions = {0, 0, 90, 7, 0, 0, 0, 8};
  block.text_positions.lines = {2, 3};
  for (const char* const decimal :
       {"0", "", "", "", "", "", "0", "0", "90", "7", "1", "", "", "", "", "", "0", "0", "0", "8"}) {
    block.decimals.add(decimal);
  }
  const GivenRotation given{{spline::RotationForm::euler, {2, 1, 0}, true, true}, false, {"a", "b", "c"}, {0, 1, 2}};
  const RotationSchema rotation{{{{0, 1, 2, 3}}}, given};
  const KeyBlock wider = *with_clear_turns(source_of(block), {{rotation}, {0, 0, 0, 0, 3}})();
  EXPECT_EQ(wider.keys.channels, 5U);
  const double root = std::sqrt(0.5);
  expect_near(wider.keys.positions, {root, 0, 0, root, 7, 0, 0, 0, 1, 8});
  ASSERT_EQ(wider.decimals.size(), 22U);
  EXPECT_EQ(wider.decimals[10], "7");
  EXPECT_EQ(wider.decimals[11], "1");
  EXPECT_EQ(wider.rotations.numbers[0], (spline::RotationNumbers<double>{0, 0, 90}));
  EXPECT_EQ(wider.rotations.decimals[2], "90");
}

/// The position x of a key and the quaternion of its matrix, between whose rows x is.
Numbers quaternion_of(const Numbers& matrix, bool normalize) {
  KeyBlock block;
  block.keys.channels = 10;
  block.keys.times = {0.0};
  block.keys.positions = matrix;
  block.keys.positions.insert(block.keys.positions.begin() + 3, 7);
  block.text_positions.lines = {2};
  const GivenRotation given{{spline::RotationForm::matrix}, false, {"r11"}, {0, 1, 2, 4, 5, 6, 7, 8, 9}, normalize};
  const RotationSchema rotation{{{{0, 1, 2, 3}}}, given};
  return with_clear_turns(source_of(block), {{rotation}, {0, 0, 0, 0, 3}})()->keys.positions;
}

std::string refusal_of_matrix(const Numbers& matrix, bool normalize = false) {
  try {
    (void)quaternion_of(matrix, normalize);
  } catch (const Error& error) {
    EXPECT_EQ(error.position().line, 2U);
    return error.message();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Rotations, of_matrices_become_quaternions) {
  const double root = std::sqrt(0.5);
  expect_near(quaternion_of({1, 0, 0, 0, 1, 0, 0, 0, 1}, false), {0, 0, 0, 1, 7});
  expect_near(quaternion_of({0, -1, 0, 1, 0, 0, 0, 0, 1}, false), {0, 0, root, root, 7});
  expect_near(quaternion_of({0, 0, 1, 1, 0, 0, 0, 1, 0}, false), {0.5, 0.5, 0.5, 0.5, 7});
  expect_near(quaternion_of({1, 0, 0, 0, -1, 0, 0, 0, -1}, false), {1, 0, 0, 0, 7});
  expect_near(quaternion_of({0, -1.0009, 0, 1, 0, 0, 0, 0, 1}, false), {0, 0, root, root, 7});
  EXPECT_THAT(refusal_of_matrix({0, -1.0011, 0, 1, 0, 0, 0, 0, 1}), HasSubstr("orthogonal"));
  EXPECT_THAT(refusal_of_matrix({1, 0.0011, 0, 0, 1, 0, 0, 0, 1}), HasSubstr("orthogonal"));
  EXPECT_THAT(refusal_of_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, true), HasSubstr("is not a rotation"));
  EXPECT_THAT(refusal_of_matrix({1, 0, 0, 0, 1, 0, 0, 0, 0}, true), HasSubstr("is not a rotation"));
  EXPECT_THAT(refusal_of_matrix({0, 0, 0, 0, 0, 0, 0, 0, 0}, true), HasSubstr("is not a rotation"));
  for (const double size : {1e-200, 3.0, 1e300}) {
    expect_near(quaternion_of({0, -size, 0, size, 0, 0, 0, 0, size / 8}, true), {0, 0, root, root, 7});
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal_of_matrix({none, 0, 0, 0, 1, 0, 0, 0, 1}), HasSubstr("lacks a number"));
  EXPECT_TRUE(std::isnan(quaternion_of(Numbers(9, none), false)[3]));
}

}  // namespace
}  // namespace tcb
