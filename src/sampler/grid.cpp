// The exact grid: one division a row where the numbers are small, wider integers where they are not.
#include "sampler/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tcb::sampler {
namespace {

constexpr std::uint64_t all_rows = std::numeric_limits<std::uint64_t>::max();

/// The largest j with |first + j increment| below 2^bits, or 0.
std::uint64_t rows_within(const Integer& first, const Integer& increment, unsigned bits) {
  const Integer room = (Integer(1) << bits) - 1 - abs(first);
  if (room < 0) return 0;
  if (increment == 0) return all_rows;
  const Integer rows = room / increment;
  return rows > all_rows ? all_rows : static_cast<std::uint64_t>(rows);
}

}  // namespace

Grid::Grid(const Rational& start, const Rational& step) : start_(start), step_(step) {
  denominator_ = lcm(denominator(start), denominator(step));
  first_ = numerator(start) * (denominator_ / denominator(start));
  increment_ = numerator(step) * (denominator_ / denominator(step));
  rounded_start_ = nearest_time(start);
  rounded_step_ = nearest_time(step);
  if (bit_width(denominator_) > 64 || abs(first_) >= Integer(1) << 120) return;
  small_first_ = static_cast<Int128>(first_);
  small_denominator_ = static_cast<Int128>(denominator_);
  small_rows_ = rows_within(first_, increment_, 120);
  if (small_rows_ > 0) small_increment_ = static_cast<Int128>(increment_);
  if (bit_width(denominator_) <= 53 && small_rows_ > 0) double_rows_ = rows_within(first_, increment_, 53);
}

Time Grid::time(std::uint64_t j) const {
  if (j <= double_rows_ && double_rows_ > 0) {
    // Both are whole numbers below 2^53, so the one division rounds once.
    return {static_cast<double>(static_cast<std::int64_t>(small_first_ + small_increment_ * j)) /
            static_cast<double>(static_cast<std::int64_t>(small_denominator_))};
  }
  if (j <= small_rows_ && small_rows_ > 0) {
    return nearest_quotient<Int128>(small_first_ + small_increment_ * j, small_denominator_);
  }
  return nearest_quotient<Integer>(first_ + increment_ * j, denominator_);
}

std::uint64_t Grid::estimate(const Time& t) const {
  const double rows = ((t - rounded_start_) / rounded_step_).hi;
  constexpr double most = 9.0e18;
  return rows > 0 ? static_cast<std::uint64_t>(std::min(rows, most)) : 0;
}

std::uint64_t Grid::rows_before(const Time& t) const {
  std::uint64_t rows = estimate(t);
  while (rows > 0 && time(rows - 1) >= t) --rows;
  while (time(rows) < t) ++rows;
  return rows;
}

std::uint64_t Grid::rows_through(const Time& t) const {
  std::uint64_t rows = estimate(t);
  while (rows > 0 && time(rows - 1) > t) --rows;
  while (time(rows) <= t) ++rows;
  return rows;
}

bool Grid::resolves(const Time& t) const {
  const double largest = std::max(std::abs(t.hi), std::abs(rounded_start_.hi));
  if (rounded_step_.hi > largest * 0x1p-51) return true;
  return time(1) > time(0) && nearest_time(exact_time(t) + step_) > t;
}

}  // namespace tcb::sampler
