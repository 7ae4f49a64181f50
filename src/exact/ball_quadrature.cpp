// Quadrature in balls: rules from the roots of Legendre polynomials, and places in doubles.
#include "exact/ball_quadrature.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/arc_length.hpp"

namespace tcb {

using spline::DoubleDouble;

namespace {

/// The Legendre polynomials P_n and P_(n-1) at x.
std::pair<Real, Real> legendre(int n, const Real& x) {
  Real before(1.0), value = x;
  for (int k = 2; k <= n; ++k) {
    const Real next = (Real(2.0 * k - 1) * x * value - Real(k - 1.0) * before) / Real(static_cast<double>(k));
    before = std::exchange(value, next);
  }
  return {value, before};
}
double legendre(int n, double x, double& slope) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
  slope = n * (x * value - before) / (x * x - 1);
  return value;
}

/// Roots by Newton's method, from x_i = cos(pi (i + 3/4)/(n + 1/2)), in doubles and then in more digits.
BallRule<Real> make_rule(int n, int bits) {
  const std::vector<Real> numbers(static_cast<std::size_t>(n));
  BallRule<Real> rule{numbers, numbers};
  for (int i = 0; i < n / 2; ++i) {
    double rough = spline::sine_cosine(3.14159265358979 * (i + 0.75) / (n + 0.5)).cosine, slope = 0;
    for (int step = 0; step < 6; ++step) {
      const double value = legendre(n, rough, slope);
      rough -= value / slope;
    }
    constexpr int guard = 60;
    std::vector<int> digits{bits + guard};  // of each step; the first one begins with those of a double
    while (digits.back() > 90) digits.push_back(digits.back() / 2 + 25);
    Real x(rough), rate;
    for (auto step = digits.rbegin(); step != digits.rend(); ++step) {
      const RealPrecision precision(*step);
      const auto [value, before] = legendre(n, x);
      const Real degree(static_cast<double>(n)), rest = Real(1.0) - x * x;
      const Real derivative = degree * (before - x * value) / rest, off = value / derivative;
      // The derivative at the root, by Legendre's equation; the next term has the square of `off`.
      rate = derivative - off * (Real(2.0) * x * derivative - degree * (degree + Real(1.0)) * value) / rest;
      x = x - off;
    }
    const RealPrecision wide(bits + guard);
    const Real weight = Real(1.0) / ((Real(1.0) - x * x) * rate * rate), left = halved(Real(1.0) - x),
               right = halved(Real(1.0) + x);
    const RealPrecision precision(bits);
    const auto first = static_cast<std::size_t>(i), last = static_cast<std::size_t>(n - 1 - i);
    rule.node[first] = left + Real();
    rule.node[last] = right + Real();
    rule.weight[first] = rule.weight[last] = weight + Real();
  }
  return rule;
}

}  // namespace

template <>
const BallRule<Real>& ball_rule() {
  thread_local std::map<int, BallRule<Real>> known;
  const int bits = Real::bits();
  BallRule<Real>& rule = known[bits];
  if (rule.node.empty()) rule = make_rule((bits * 10 / 32 + 5) / 2 * 2, bits);
  return rule;
}
template <>
const BallRule<DoubleDouble>& ball_rule() {
  static const BallRule<DoubleDouble> rule = [] {
    const BallRule<Real> exact = make_rule(32, 140);
    const auto rounded = [](const Real& number) {
      const RealPrecision precision(140);
      const double high = number.rough();
      return DoubleDouble::normalized(high, Real(number - Real(high)).rough());
    };
    BallRule<DoubleDouble> result;
    for (const Real& node : exact.node) result.node.push_back(rounded(node));
    for (const Real& weight : exact.weight) result.weight.push_back(rounded(weight));
    return result;
  }();
  return rule;
}

double rough_ratio(const DoubleDouble& a, const DoubleDouble& b) { return a.hi / b.hi; }
double rough_ratio(const Real& a, const Real& b) {
  return a.over_power_of_two(b.exponent()) / b.over_power_of_two(b.exponent());
}

double rough_place(const std::function<double(double)>& speed, double fraction) {
  const auto& rule = spline::gauss_rule<double, 16>();
  const auto sum = [&](double to) {
    double total = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) total += rule.weight[i] * speed(to * rule.node[i]);
    return total * to;
  };
  const double length = fraction * sum(1);
  double low = 0, high = 1, place = fraction > 0 ? std::min(fraction, 1.0) : 0;
  for (int step = 0; step < 60; ++step) {
    const double excess = sum(place) - length;
    (excess > 0 ? high : low) = place;
    double next = place - excess / speed(place);
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool is_settled = std::abs(next - place) < 0x1p-48;
    place = next;
    if (is_settled) break;
  }
  return place;
}

}  // namespace tcb
