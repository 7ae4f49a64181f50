// Parameterize: times for keys without any, from the distances between them.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "schema/key_block.hpp"
#include "stream/source.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

/// Adds times to keys without any: t[i+1] = t[i] + |P[i+1] - P[i]|^exponent, which is t[i] + 1 for exponent
/// 0. `metric`: the channels that count for distances; empty: all. Throws: Error (data) if two positions are equal,
/// or a step is lost in rounding; it has both lines.
Source<KeyBlock> parameterized(Source<KeyBlock> blocks, double exponent, std::vector<std::size_t> metric);

/// The power of a distance at a scalar, from its square. Doubles add up squares as double-doubles, in units of a power
/// of two, so that none overflows or vanishes. Exact scalars have their own, in exact/rounding.hpp.
template <class S>
struct DistancePower;

template <>
struct DistancePower<double> {
  /// Requires: differences of at most `largest` in size.
  explicit DistancePower(double largest);
  void add_square(double a, double b);
  double power(double exponent) const;

 private:
  int unit_ = 0;
  spline::DoubleDouble sum_;
};

/// |b - a|^exponent over the metric channels (empty: all); 1 for exponent 0. P: the scalar of positions.
template <class S, class P>
S parameter_step(std::span<const P> a, std::span<const P> b, double exponent, std::span<const std::size_t> metric) {
  using std::abs;
  if (exponent == 0) return S(1);
  const std::size_t channels = metric.empty() ? a.size() : metric.size();
  const auto channel = [&](std::size_t i) { return metric.empty() ? i : metric[i]; };
  P largest(0);
  for (std::size_t i = 0; i < channels; ++i) {
    const P difference = abs(P(b[channel(i)] - a[channel(i)]));
    if (largest < difference) largest = difference;
  }
  if (largest == P(0)) return S(0);
  DistancePower<S> distance(largest);
  for (std::size_t i = 0; i < channels; ++i) distance.add_square(a[channel(i)], b[channel(i)]);
  return distance.power(exponent);
}

}  // namespace tcb
