// Banded: a matrix with few numbers beside its diagonal, and the solution of its linear system.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace tcb {

/// A symmetric positive definite matrix whose numbers are at most 3 columns from the diagonal.
class Banded {
 public:
  static constexpr std::size_t band = 4;

  explicit Banded(std::size_t size) : rows_(size) {}

  /// The number in a row and a column at or before it.
  double& at(std::size_t row, std::size_t column) { return rows_[row][row - column]; }

  void clear() { std::ranges::fill(rows_, std::array<double, band>{}); }

  /// Subtracts a variable of known value from one of `count` right-hand vectors, whose numbers alternate. remove()
  /// follows after the last one.
  void move_to_target(std::size_t variable, double value, std::span<double> targets, std::size_t number,
                      std::size_t count) {
    for (std::size_t other = first_near(variable); other < end_near(variable); ++other) {
      if (other == variable) continue;
      targets[other * count + number] -= at(std::max(variable, other), std::min(variable, other)) * value;
    }
    targets[variable * count + number] = value;
  }
  void remove(std::size_t variable) {
    for (std::size_t other = first_near(variable); other < end_near(variable); ++other) {
      at(std::max(variable, other), std::min(variable, other)) = other == variable ? 1 : 0;
    }
  }

  /// Cholesky's factors, in place, with the inverse of each number on the diagonal.
  void factor() {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::size_t column = first_near(row); column <= row; ++column) {
        double sum = at(row, column);
        for (std::size_t k = first_near(row); k < column; ++k) sum -= at(row, k) * at(column, k);
        at(row, column) = column < row ? sum * at(column, column) : 1 / std::sqrt(std::max(sum, 1e-300));
      }
    }
  }

  /// Solves for `count` right-hand vectors, whose numbers alternate, in place. Requires: factor().
  void solve(std::span<double> targets, std::size_t count) {
    const std::size_t size = rows_.size();
    const auto subtract = [&](std::size_t row, std::size_t other, double factor) {
      for (std::size_t c = 0; c < count; ++c) targets[row * count + c] -= factor * targets[other * count + c];
    };
    const auto scale = [&](std::size_t row) {
      for (std::size_t c = 0; c < count; ++c) targets[row * count + c] *= at(row, row);
    };
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t k = first_near(row); k < row; ++k) subtract(row, k, at(row, k));
      scale(row);
    }
    for (std::size_t row = size; row-- > 0;) {
      for (std::size_t k = row + 1; k < end_near(row); ++k) subtract(row, k, at(k, row));
      scale(row);
    }
  }

 private:
  /// The variables that have a number with another one.
  static std::size_t first_near(std::size_t variable) { return variable < band ? 0 : variable - band + 1; }
  std::size_t end_near(std::size_t variable) const { return std::min(variable + band, rows_.size()); }

  std::vector<std::array<double, band>> rows_;  ///< from the diagonal backward
};

}  // namespace tcb
