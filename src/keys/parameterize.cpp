// Parameterize: times for keys without any, from the distances between them.
#include "keys/parameterize.hpp"

#include <cmath>
#include <utility>

#include "keys/errors.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

/// Adds times to blocks, one after the other.
class Parameterizer {
 public:
  Parameterizer(double exponent, std::vector<std::size_t> metric) : exponent_(exponent), metric_(std::move(metric)) {}

  KeyBlock operator()(KeyBlock block) {
    Keys& keys = block.keys;
    keys.times.reserve(block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto position = keys.position(i);
      if (!before_.empty()) advance(position, block.line(i));
      keys.times.emplace_back(time_.hi);
      before_.assign(position.begin(), position.end());
      line_ = block.line(i);
    }
    return block;
  }

 private:
  void advance(std::span<const double> position, std::uint64_t line) {
    const double step = parameter_step<double, double>(before_, position, exponent_, metric_);
    if (step == 0) throw position_repeats(line_).at({"", line, 0});
    const double earlier = time_.hi;
    time_ = time_ + DoubleDouble(step);
    if (time_.hi == earlier) throw parameter_step_lost(step, time_.hi).at({"", line, 0});
  }

  double exponent_;
  std::vector<std::size_t> metric_;
  DoubleDouble time_;
  std::vector<double> before_;  ///< position of the previous key; empty at the first one
  std::uint64_t line_ = 0;      ///< line of the previous key
};

}  // namespace

DistancePower<double>::DistancePower(double largest) {
  (void)std::frexp(largest, &unit_);
  --unit_;  // 2^unit is a double even if the next power of two is not
}

void DistancePower<double>::add_square(double a, double b) {
  const DoubleDouble step = DoubleDouble(std::ldexp(b, -unit_)) - DoubleDouble(std::ldexp(a, -unit_));
  sum_ = sum_ + step * step;
}

double DistancePower<double>::power(double exponent) const {
  const DoubleDouble unit(std::ldexp(1.0, unit_));
  return (spline::power(spline::sqrt(sum_), exponent) * spline::power(unit, exponent)).hi;
}

Source<KeyBlock> parameterized(Source<KeyBlock> blocks, double exponent, std::vector<std::size_t> metric) {
  return mapped(std::move(blocks), Parameterizer(exponent, std::move(metric)));
}

}  // namespace tcb
