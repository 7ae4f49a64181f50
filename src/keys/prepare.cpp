// Prepare: what the keys of a curve go through before they make it: quaternions, times for those without any, and
// checks of their numbers.
#include "keys/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "error.hpp"
#include "keys/angles.hpp"
#include "option_names.hpp"
#include "schema/roles.hpp"
#include "tcb/spline/scalar.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error tcb_of_scale(ShownTcbScale shown, std::string_view role, double value) {
  if (shown == ShownTcbScale::percent) {
    return data_error(
        "{} is {}, as in a product that shows percent; expected a number that is usually from -1 to 1; divide it by "
        "100, "
        "or give {} none to take it unchanged",
        role, value, option::tcb_scale);
  }
  return data_error(
      "{} is {}, as in 3ds Max and similar programs, which show 0 to 50 with 25 for 0; expected a number that is "
      "usually "
      "from -1 to 1; give {} 3dsmax to convert it, or {} none to take it unchanged",
      role, value, option::tcb_scale, option::tcb_scale);
}

void require_ease(const spline::Ease<double>& ease, std::uint64_t line) {
  for (const auto& [name, value] : {std::pair{"ease_in", ease.in}, std::pair{"ease_out", ease.out}}) {
    if (value >= 0 && value <= 1) continue;
    throw data_error("{} is {}; expected a number from 0 to 1; correct it, or give {}", name, value, option::no_ease)
        .at({"", line, 0});
  }
}

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
    if (step == 0)
      throw data_error(
          "the position repeats the one on line {}, so the distance from which the time is made is 0; expected "
          "different positions; remove one of the rows, or give {} uniform",
          line_, option::parameter)
          .at({"", line, 0});
    const double earlier = time_.hi;
    time_ = time_ + DoubleDouble(step);
    if (time_.hi == earlier)
      throw data_error(
          "the distance gives a step of {}, which is too small to change the time {}; expected times that doubles can "
          "distinguish; give a smaller exponent to {}",
          step, time_.hi, option::parameter)
          .at({"", line, 0});
  }

  double exponent_;
  std::vector<std::size_t> metric_;
  DoubleDouble time_;
  std::vector<double> before_;  ///< position of the previous key; empty at the first one
  std::uint64_t line_ = 0;      ///< line of the previous key
};

/// The last key in each channel, whose outgoing velocity is needed if another one follows.
class VelocityCheck {
 public:
  VelocityCheck(std::vector<std::string> channels, bool equal_speed)
      : channels_(std::move(channels)), equal_speed_(equal_speed), before_(channels_.size()) {}

  KeyBlock operator()(KeyBlock block) {
    const Keys& keys = block.keys;
    if (keys.velocities.empty()) return block;
    if (equal_speed_)
      throw data_error("the keys have velocities, which {} would change; expected one of the two; remove {}",
                       option::equal_speed, option::equal_speed);
    for (std::size_t i = 0; i < keys.velocities.size(); ++i) {
      const std::size_t channel = i % keys.channels;
      const bool is_key = !std::isnan(keys.positions[i]);
      if (keys.given[channel] && is_key) add(channel, keys.velocities[i], block.line(i / keys.channels));
    }
    return block;
  }

 private:
  struct Before {
    std::uint64_t line = 0;  ///< 0: there is none
    bool has_outgoing = false;
  };

  void add(std::size_t channel, const spline::Velocity<double>& velocity, std::uint64_t line) {
    Before& before = before_[channel];
    const bool has_before = before.line != 0;
    if (has_before && !before.has_outgoing) {
      throw data_error(
          "the outgoing velocity of channel {} is missing; expected a number at every key but the last; fill it in, or "
          "remove the row",
          in_quotes(channels_[channel]))
          .at({"", before.line, 0});
    }
    if (has_before && std::isnan(velocity.in)) {
      throw data_error(
          "the incoming velocity of channel {} is missing; expected a number at every key but the first; fill it in, "
          "or remove the row",
          in_quotes(channels_[channel]))
          .at({"", line, 0});
    }
    before = {line, !std::isnan(velocity.out)};
  }

  std::vector<std::string> channels_;
  bool equal_speed_;
  std::vector<Before> before_;
};

}  // namespace

Source<KeyBlock> prepared(Source<KeyBlock> blocks, const KeyPreparation& needs) {
  blocks = with_quaternions(std::move(blocks), needs.rotations);
  blocks = with_clear_angles(std::move(blocks), needs.angles, needs.channels, needs.closed);
  if (needs.may_be_timed) blocks = with_clear_times(std::move(blocks), needs.channels[0]);
  if (needs.exponent) blocks = parameterized(std::move(blocks), *needs.exponent, needs.metric);
  if (needs.retiming) blocks = retimed(std::move(blocks), *needs.retiming, needs.frames);
  if (needs.unlikely_scale) blocks = within_tcb_scale(std::move(blocks), *needs.unlikely_scale);
  if (!needs.ease) blocks = without_ease(std::move(blocks));
  if (needs.monotone) blocks = with_rules_alone(std::move(blocks));
  blocks = with_complete_velocities(std::move(blocks), needs.channels, needs.equal_speed);
  return checked(std::move(blocks), needs.least);
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
        throw data_error(
            "there is no time column, but column {} may be one; expected a column called time; give "
            "{} {}, or {} uniform if the keys have no times",
            in_quotes(channel), option::columns, in_shell("time=" + channel), option::parameter);
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

Source<KeyBlock> retimed(Source<KeyBlock> blocks, const Retiming& retiming, const std::optional<FrameTimes>& frames) {
  return mapped(std::move(blocks), [retiming, frames](KeyBlock block) {
    const auto& [factor, origin] = retiming;
    const double number = nearest_double(factor);
    for (Time& time : block.keys.times) {
      const auto frame = frames ? frames->exact(time) : std::nullopt;
      time = nearest_time(origin + (frame.value_or(Rational(time.hi) + Rational(time.lo)) - origin) * factor);
    }
    for (auto& [in, out] : block.keys.velocities) {
      in /= number;
      out /= number;
    }
    return block;
  });
}

Source<KeyBlock> within_tcb_scale(Source<KeyBlock> blocks, ShownTcbScale shown) {
  return mapped(std::move(blocks), [shown](KeyBlock block) {
    const auto require = [&](std::size_t key, Role role, double value) {
      if (std::abs(value) <= 5) return;
      throw tcb_of_scale(shown, role_name(role), value).at({"", block.line(key), 0});
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

Source<KeyBlock> with_rules_alone(Source<KeyBlock> blocks) {
  return mapped(std::move(blocks), [](KeyBlock block) {
    if (block.empty()) return block;
    if (!block.keys.eases.empty())
      throw data_error(
          "the keys have ease, and the preset has monotone timing; expected one of the two; give {}, or another {}",
          option::no_ease, option::preset)
          .at({"", block.line(0)});
    if (!block.keys.velocities.empty())
      throw data_error(
          "the keys have velocities, which a preset with monotone timing would change; expected one of the two; give "
          "another {}",
          option::preset)
          .at({"", block.line(0)});
    if (block.keys.is_sparse())
      throw data_error(
          "some numbers were skipped by {} skip-cell, but a preset with monotone timing needs a number in every "
          "channel; fill them in, or give another {}",
          option::missing, option::preset)
          .at({"", block.line(0)});
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
    if (!block && count < least)
      throw data_error("there {}; a curve needs at least two; add keys", count == 0 ? "are no keys" : "is only one key")
          .at({"", line, 0});
    if (!block) return std::nullopt;
    for (std::size_t i = 0; i < block->keys.eases.size(); ++i) require_ease(block->keys.eases[i], block->line(i));
    if (count == 0 && block->keys.size() > 0) line = block->line(0);
    count += block->keys.size();
    return block;
  };
}

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

Source<KeyBlock> with_complete_velocities(Source<KeyBlock> blocks, std::vector<std::string> channels,
                                          bool equal_speed) {
  return mapped(std::move(blocks), VelocityCheck(std::move(channels), equal_speed));
}

}  // namespace tcb
