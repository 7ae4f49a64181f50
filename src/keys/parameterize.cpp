// Parameterize and check: times for keys without any, from the distances between them; ease and number of keys.
#include "keys/parameterize.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "keys/errors.hpp"
#include "schema/errors.hpp"
#include "schema/roles.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

void require_ease(const spline::Ease<double>& ease, std::uint64_t line) {
  for (const auto& [name, value] : {std::pair{"ease_in", ease.in}, std::pair{"ease_out", ease.out}}) {
    if (value >= 0 && value <= 1) continue;
    throw ease_out_of_range(name, value).at({"", line, 0});
  }
}

/// Adds times to blocks, one after the other.
class Parameterizer {
 public:
  Parameterizer(double exponent, std::vector<std::size_t> metric) : exponent_(exponent), metric_(std::move(metric)) {}

  KeyBlock operator()(KeyBlock block) {
    Keys& keys = block.keys;
    keys.times.reserve(block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto position = keys.position(i);
      if (!before_.empty()) advance(position, block.lines[i]);
      keys.times.emplace_back(time_.hi);
      before_.assign(position.begin(), position.end());
      line_ = block.lines[i];
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

Source<KeyBlock> with_clear_times(Source<KeyBlock> blocks, std::string channel) {
  return [blocks = std::move(blocks), channel = std::move(channel), held = std::deque<KeyBlock>(),
          is_clear = false]() mutable -> std::optional<KeyBlock> {
    constexpr std::size_t most = 1000;
    std::size_t keys = 0;
    for (double before = 0; !is_clear;) {
      std::optional<KeyBlock> block = blocks();
      for (std::size_t i = 0; block && i < block->size() && keys < most && !is_clear; ++i) {
        const double now = block->keys.positions[i * block->keys.channels];
        is_clear = keys++ > 0 && !(before < now);
        before = now;
      }
      if (!is_clear && keys > 1 && (!block || keys == most)) {
        throw times_unclear(channel);
      }
      is_clear = is_clear || !block;
      if (block) held.push_back(std::move(*block));
    }
    if (held.empty()) return blocks();
    KeyBlock first = std::move(held.front());
    held.pop_front();
    return first;
  };
}

Source<KeyBlock> within_tcb_scale(Source<KeyBlock> blocks, ShownTcbScale shown) {
  const auto fault = shown == ShownTcbScale::percent ? tcb_in_percent : tcb_from_0_to_50;
  return mapped(std::move(blocks), [fault](KeyBlock block) {
    const auto require = [&](std::size_t key, Role role, double value) {
      if (std::abs(value) <= 5) return;
      throw fault(role_name(role), value).at({"", block.lines[key], 0});
    };
    const std::size_t per_key = std::max<std::size_t>(block.keys.tcbs_per_key(), 1);
    for (std::size_t i = 0; i < block.size() * per_key; ++i) {
      const auto& tcb = block.keys.tcb(i / per_key, i % per_key);
      require(i / per_key, Role::tension, tcb.tension);
      require(i / per_key, Role::continuity, tcb.continuity);
      require(i / per_key, Role::bias, tcb.bias);
    }
    return block;
  });
}

Source<KeyBlock> without_ease(Source<KeyBlock> blocks) {
  return mapped(std::move(blocks), [](KeyBlock block) {
    block.keys.eases.clear();
    return block;
  });
}

Source<KeyBlock> checked(Source<KeyBlock> blocks, std::size_t least) {
  return [blocks = std::move(blocks), least, count = std::size_t{0},
          line = std::uint64_t{0}]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block && count < least) throw too_few_keys(count).at({"", line, 0});
    if (!block) return std::nullopt;
    for (std::size_t i = 0; i < block->keys.eases.size(); ++i) require_ease(block->keys.eases[i], block->lines[i]);
    if (count == 0 && block->keys.size() > 0) line = block->lines[0];
    count += block->keys.size();
    return block;
  };
}

}  // namespace tcb
