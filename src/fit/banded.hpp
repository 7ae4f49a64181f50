// Banded systems of linear equations, as cubics have that share positions and slopes with their neighbours.
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

  /// Sets all numbers to 0.
  void clear() { std::ranges::fill(rows_, std::array<double, band>{}); }

  /// Subtracts a variable of known value from one of several right-hand vectors, whose numbers alternate. remove()
  /// follows after the last one.
  void move_to_target(std::size_t variable, double value, std::span<double> targets, std::size_t number = 0,
                      std::size_t count = 1) {
    const std::size_t size = rows_.size();
    for (std::size_t other = variable < band ? 0 : variable - band + 1; other < std::min(variable + band, size);
         ++other) {
      if (other == variable) continue;
      targets[other * count + number] -= at(std::max(variable, other), std::min(variable, other)) * value;
    }
    targets[variable * count + number] = value;
  }
  /// Removes a variable from the equations of the others.
  void remove(std::size_t variable) {
    const std::size_t size = rows_.size();
    for (std::size_t other = variable < band ? 0 : variable - band + 1; other < std::min(variable + band, size);
         ++other) {
      at(std::max(variable, other), std::min(variable, other)) = other == variable ? 1 : 0;
    }
  }

  /// Cholesky's factors, in place, with the inverse of each number on the diagonal.
  void factor() {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      const std::size_t first = row < band ? 0 : row - band + 1;
      for (std::size_t column = first; column <= row; ++column) {
        double sum = at(row, column);
        const std::size_t begin = std::max(first, column < band ? 0 : column - band + 1);
        for (std::size_t k = begin; k < column; ++k) sum -= at(row, k) * at(column, k);
        at(row, column) = column < row ? sum * at(column, column) : 1 / std::sqrt(std::max(sum, 1e-300));
      }
    }
  }

  /// Solves for `count` right-hand vectors, whose numbers alternate, in place. Requires: factor().
  void solve(std::span<double> targets, std::size_t count = 1) {
    const std::size_t size = rows_.size();
    const auto subtract = [&](std::size_t row, std::size_t other, double factor) {
      for (std::size_t c = 0; c < count; ++c) targets[row * count + c] -= factor * targets[other * count + c];
    };
    const auto scale = [&](std::size_t row) {
      for (std::size_t c = 0; c < count; ++c) targets[row * count + c] *= at(row, row);
    };
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t k = row < band ? 0 : row - band + 1; k < row; ++k) subtract(row, k, at(row, k));
      scale(row);
    }
    for (std::size_t row = size; row-- > 0;) {
      for (std::size_t k = row + 1; k < std::min(row + band, size); ++k) subtract(row, k, at(k, row));
      scale(row);
    }
  }

 private:
  std::vector<std::array<double, band>> rows_;  ///< from the diagonal backward
};

}  // namespace tcb
