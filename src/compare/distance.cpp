// Distances between two numbers in three measures, and what is admitted of them.
#include "compare/distance.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace tcb {
namespace {

/// The doubles in order, numbered; both zeros are 0.
std::int64_t number_of(double value) {
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

Distance distance(double theirs, double ours) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::isnan(theirs) && std::isnan(ours)) return {};
  if (std::isnan(theirs) || std::isnan(ours)) return {infinity, infinity, std::numeric_limits<std::uint64_t>::max()};
  const double abs = std::abs(theirs - ours);
  const std::int64_t a = number_of(theirs), b = number_of(ours);
  const auto ulp = static_cast<std::uint64_t>(a > b ? a : b) - static_cast<std::uint64_t>(a > b ? b : a);
  return {abs, abs == 0 ? 0 : abs / std::abs(ours), ulp};
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
