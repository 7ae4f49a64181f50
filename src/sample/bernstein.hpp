// Bernstein form: polynomials over [0, 1] by coefficients that bound them.
//
//   p(s) = sum of b_k C(N,k) s^k (1 - s)^(N - k), of degree N
// The values of p lie between the least and the largest b_k; b_0 and b_N are its values at both ends.
// Source: R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", 2012.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace tcb {

/// Coefficients, as many as the degree and one more.
template <std::size_t Size>
using Bernstein = std::array<double, Size>;

/// The polynomial with the coefficients of 1, s, s^2, ...
template <std::size_t Size>
Bernstein<Size> bernstein(std::array<double, Size> power) {
  double binomial = 1;
  for (std::size_t k = 1; k < Size; ++k) {
    binomial = binomial * static_cast<double>(Size - k) / static_cast<double>(k);
    power[k] /= binomial;
  }
  for (std::size_t step = 1; step < Size; ++step) {
    for (std::size_t k = Size - 1; k >= step; --k) power[k] += power[k - 1];
  }
  return power;
}

/// The parts of a polynomial before and after `s`, each over [0, 1] again: de Casteljau's algorithm.
template <std::size_t Size>
std::pair<Bernstein<Size>, Bernstein<Size>> split(Bernstein<Size> whole, double s) {
  std::pair<Bernstein<Size>, Bernstein<Size>> parts;
  for (std::size_t left = Size; left-- > 0;) {
    parts.first[Size - 1 - left] = whole[0];
    parts.second[left] = whole[left];
    for (std::size_t k = 0; k < left; ++k) whole[k] += s * (whole[k + 1] - whole[k]);
  }
  return parts;
}

/// The factors of r^k, where p(s) = (1 - s)^N times their sum, and r = s / (1 - s).
template <std::size_t Size>
std::array<double, Size> scaled_powers(Bernstein<Size> p) {
  double binomial = 1;
  for (std::size_t k = 1; k < Size; ++k) {
    binomial = binomial * static_cast<double>(Size - k) / static_cast<double>(k);
    p[k] *= binomial;
  }
  return p;
}

/// The differences of successive coefficients, which are the coefficients of the derivative divided by the degree.
template <std::size_t Size>
Bernstein<Size - 1> differences(const Bernstein<Size>& p) {
  Bernstein<Size - 1> result;
  for (std::size_t k = 0; k + 1 < Size; ++k) result[k] = p[k + 1] - p[k];
  return result;
}

/// A maximum of a polynomial near `s`, by Newton's method; without one nearby, some place between the ends.
template <std::size_t Size>
double stationary_place(const Bernstein<Size>& p, double s) {
  constexpr double margin = 1.0 / 64, degree = Size - 1;
  const auto first = differences(p);
  const auto slope = scaled_powers(first);
  const auto bend = scaled_powers(differences(first));
  const auto sum = [](const auto& powers, double r) {
    double result = 0;
    for (std::size_t k = powers.size(); k-- > 0;) result = result * r + powers[k];
    return result;
  };
  for (int step = 0; step < 6; ++step) {
    const double r = s / (1 - s), second = sum(bend, r);
    if (!(second < 0)) break;
    const double next = std::clamp(s - (1 - s) * sum(slope, r) / ((degree - 1) * second), margin, 1 - margin);
    const bool found = next - s < 1e-5 && s - next < 1e-5;  // the next step would be less than 1e-9
    s = next;
    if (found) break;
  }
  return s;
}

/// The maximum over [0, 1] of a polynomial and of `known`, or more: by two parts in 10^10 at most, unless `parts` parts
/// are too few to show that.
template <std::size_t Size>
double upper_bound(const Bernstein<Size>& p, double known, int& parts) {
  const auto top = std::ranges::max_element(p);
  known = std::max({known, p.front(), p.back()});
  if (!(*top > known * (1 + 1e-10))) return std::max(known, *top);
  if (--parts <= 0) return *top;
  const double middle = static_cast<double>(top - p.begin()) / static_cast<double>(Size - 1);
  const auto [before, after] = split(p, stationary_place(p, middle));
  return upper_bound(after, upper_bound(before, known, parts), parts);
}

}  // namespace tcb
