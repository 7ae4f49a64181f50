// Distance: how far a number is from the computed one, in three measures, and the limits for them.
#include "check/distance.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace tcb {
namespace {

/// An index of the doubles in increasing order; both zeros have index 0.
std::int64_t index_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(std::abs(value));
  return value < 0 ? -static_cast<std::int64_t>(bits) : static_cast<std::int64_t>(bits);
}

std::optional<double> limit(const std::vector<Tolerance>& tolerances, const std::string& column) {
  std::optional<double> all, own;
  for (const Tolerance& tolerance : tolerances) {
    if (tolerance.column.empty()) all = tolerance.most;
    if (tolerance.column == column) own = tolerance.most;
  }
  return own ? own : all;
}

}  // namespace

Distance distance(double given, double computed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::isnan(given) && std::isnan(computed)) return {};
  if (std::isnan(given) || std::isnan(computed)) return {infinity, infinity, std::numeric_limits<std::uint64_t>::max()};
  const double abs = std::abs(given - computed);
  const std::int64_t a = index_of(given), b = index_of(computed);
  const auto ulp = static_cast<std::uint64_t>(a > b ? a : b) - static_cast<std::uint64_t>(a > b ? b : a);
  return {abs, abs == 0 ? 0 : abs / std::abs(computed), ulp};
}

bool Limits::admit(const Distance& distance) const {
  if (distance.ulp == 0) return true;
  return (abs && distance.abs <= *abs) || (rel && distance.rel <= *rel) ||
         (ulp && static_cast<double>(distance.ulp) <= *ulp);
}

Limits limits_of(const Comparison& comparison, const std::string& column) {
  return {limit(comparison.abs, column), limit(comparison.rel, column), limit(comparison.ulp, column)};
}

}  // namespace tcb
