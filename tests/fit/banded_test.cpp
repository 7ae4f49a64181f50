// Banded systems: solutions, and variables of known values.
#include "fit/banded.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

/// 4 on the diagonal, and 1 next to it and three columns away.
Banded matrix_of(std::size_t size) {
  Banded matrix(size);
  for (std::size_t i = 0; i < size; ++i) {
    matrix.at(i, i) = 4;
    if (i >= 1) matrix.at(i, i - 1) = 1;
    if (i >= 3) matrix.at(i, i - 3) = 1;
  }
  return matrix;
}

TEST(Banded, a_system_is_solved) {
  Banded matrix = matrix_of(5);
  std::vector<double> target{4 + 2 + 4, 1 + 8 + 3 + 5, 2 + 12 + 4, 1 + 3 + 16 + 5, 2 + 4 + 20};  // of 1, 2, 3, 4, 5
  matrix.factor();
  matrix.solve(target);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(target[i], static_cast<double>(i + 1), 1e-14) << i;
}

TEST(Banded, several_vectors_are_solved_at_a_time) {
  Banded matrix = matrix_of(5);
  std::vector<double> targets{10, 100, 17, 170, 18, 180, 25, 250, 26, 260};
  matrix.factor();
  matrix.solve(targets, 2);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(targets[2 * i], static_cast<double>(i + 1), 1e-14) << i;
    EXPECT_NEAR(targets[2 * i + 1], static_cast<double>(10 * (i + 1)), 1e-13) << i;
  }
}

TEST(Banded, a_known_variable_leaves_the_other_equations) {
  Banded matrix = matrix_of(5);
  std::vector<double> target{10, 17, 18, 25, 26};
  matrix.move_to_target(2, 7, target);
  matrix.remove(2);
  matrix.factor();
  matrix.solve(target);
  EXPECT_NEAR(target[2], 7, 1e-14);
  EXPECT_NEAR(4 * target[0] + target[1] + target[3], 10, 1e-13);
  EXPECT_NEAR(target[0] + 4 * target[1] + 7 + target[4], 17, 1e-13);
}

}  // namespace
}  // namespace tcb
