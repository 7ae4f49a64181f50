// Prepare: what the keys of a curve go through before they make it: quaternions, times for those without any, and
// checks of their numbers.
#include "keys/prepare.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <utility>

#include "error.hpp"
#include "schema/roles.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/scalar.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error tcb_of_scale(ShownTcbScale shown, std::string_view role, double value) {
  if (shown == ShownTcbScale::percent) {
    return data_error(
        "{} is {}, as in a product that shows percent; expected a number that is usually from -1 to 1; divide it by "
        "100, or give --tcb-scale none to take it unchanged",
        role, value);
  }
  return data_error(
      "{} is {}, as in 3ds Max and similar programs, which show 0 to 50 with 25 for 0; expected a number that is "
      "usually from -1 to 1; give --tcb-scale 3dsmax to convert it, or --tcb-scale none to take it unchanged",
      role, value);
}

void require_ease(const spline::Ease<double>& ease, std::uint64_t line) {
  for (const auto& [name, value] : {std::pair{"ease_in", ease.in}, std::pair{"ease_out", ease.out}}) {
    if (value >= 0 && value <= 1) continue;
    throw data_error("{} is {}; expected a number from 0 to 1; correct it, or give --no-ease", name, value)
        .at({"", line, 0});
  }
}

Error not_retimed(const Time& time, const Retiming& retiming) {
  return data_error(
      "the time {}, with times multiplied by {}, is beyond the range of doubles, or not after the one before it; "
      "expected a factor that leaves times apart and below 1.8e308; give another limit",
      time.hi, nearest_double(retiming.factor));
}

using spline::DoubleDouble;

/// The steps that take one block after another.
class Steps {
 public:
  explicit Steps(const KeyPreparation& needs) : needs_(needs), before_in_(needs.turns.channels.size()) {}

  KeyBlock operator()(KeyBlock block) {
    if (needs_.exponent) add_times(block);
    if (needs_.retiming) retime(block, *needs_.retiming);
    if (needs_.unlikely_scale) require_scale(block, *needs_.unlikely_scale);
    if (!needs_.ease) block.keys.eases.clear();
    if (needs_.monotone && !block.empty()) require_rules_alone(block);
    if (!block.keys.velocities.empty()) require_velocities(block);
    for (std::size_t i = 0; i < block.keys.eases.size(); ++i) require_ease(block.keys.eases[i], block.line(i));
    if (count_ == 0 && !block.empty()) {
      first_ = {"", block.line(0), 0};
      list_position_ = block.list_position(0);
      if (!list_position_.empty()) {
        first_ = block.text_position(0);
        may_follow_break_ = needs_.only_breaks && block.text_positions.numbers[0] > 0;
      }
    }
    count_ += block.size();
    return block;
  }

  void end() const {
    if (count_ >= needs_.least) return;
    const Error error =
        data_error("there {}; a curve needs at least two; add keys{}", count_ == 0 ? "are no keys" : "is only one key",
                   may_follow_break_ ? ", or remove null in place of the key before it, which begins a new curve" : "");
    throw(list_position_.empty() ? error : error.about(list_position_)).at(first_);
  }

 private:
  void add_times(KeyBlock& block) {
    Keys& keys = block.keys;
    keys.times.reserve(block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto position = keys.position(i);
      if (!before_.empty()) advance(position, block.line(i));
      keys.times.emplace_back(time_.hi);
      before_.assign(position.begin(), position.end());
      line_ = block.line(i);
    }
  }

  void advance(std::span<const double> position, std::uint64_t line) {
    const double step = parameter_step<double, double>(before_, position, *needs_.exponent, needs_.metric);
    if (step == 0)
      throw data_error(
          "the position repeats the one on line {}, so the distance from which the time is made is 0; expected "
          "different positions; remove one of the rows, or give --parameter uniform",
          line_)
          .at({"", line, 0});
    const double earlier = time_.hi;
    time_ = time_ + DoubleDouble(step);
    if (time_.hi == earlier)
      throw data_error(
          "the distance gives a step of {}, which is too small to change the time {}; expected times that doubles can "
          "distinguish; give a smaller exponent to --parameter",
          step, time_.hi)
          .at({"", line, 0});
  }

  /// Other times, and velocities that fit.
  void retime(KeyBlock& block, const Retiming& retiming) {
    const double number = nearest_double(retiming.factor);
    for (std::size_t i = 0; i < block.keys.times.size(); ++i) {
      Time& time = block.keys.times[i];
      const Time changed = retimed(time, retiming, needs_.frames);
      if (before_retimed_ && !(*before_retimed_ < changed)) {
        throw not_retimed(time, retiming).at({"", block.line(i), 0});
      }
      before_retimed_ = time = changed;
    }
    for (auto& [in, out] : block.keys.velocities) {
      in /= number;
      out /= number;
    }
  }

  /// Throws: Error (data) for tension, continuity or bias beyond 5 in size: they are probably on the scale on which the
  /// product shows them.
  static void require_scale(const KeyBlock& block, ShownTcbScale shown) {
    const auto require = [&](std::size_t key, Role role, double value) {
      if (std::abs(value) > 5) throw tcb_of_scale(shown, role_name(role), value).at({"", block.line(key), 0});
    };
    const std::size_t per_key = std::max<std::size_t>(block.keys.tcbs_per_key(), 1);
    for (std::size_t i = 0; i < block.size() * per_key; ++i) {
      const auto& tcb = block.keys.tcb(i / per_key, i % per_key);
      require(i / per_key, Role::tension, tcb.tension);
      require(i / per_key, Role::continuity, tcb.continuity);
      require(i / per_key, Role::bias, tcb.bias);
    }
  }

  static void require_rules_alone(const KeyBlock& block) {
    const auto refuse = [&](const Error& error) { throw Error(error).at({"", block.line(0)}); };
    if (!block.keys.eases.empty()) {
      refuse(
          data_error("the keys have ease, and the preset has monotone timing; expected one of the two; give --no-ease, "
                     "or another --preset"));
    }
    if (!block.keys.velocities.empty()) {
      refuse(
          data_error("the keys have velocities, which a preset with monotone timing would change; expected one of the "
                     "two; give another --preset"));
    }
    if (block.keys.is_sparse()) {
      refuse(
          data_error("some numbers were skipped by --missing skip-cell, but a preset with monotone timing needs a "
                     "number in every channel; fill them in, or give another --preset"));
    }
  }

  void require_velocities(const KeyBlock& block) {
    const Keys& keys = block.keys;
    if (needs_.equal_speed)
      throw data_error(
          "the keys have velocities, which --equal-speed would change; expected one of the two; remove --equal-speed");
    for (std::size_t i = 0; i < keys.velocities.size(); ++i) {
      const std::size_t channel = i % keys.channels;
      const bool is_key = !std::isnan(keys.positions[i]);
      if (keys.given[channel] && is_key) require_velocity(channel, keys.velocities[i], block.line(i / keys.channels));
    }
  }

  /// A velocity is needed except before the first key in a channel and after its last one.
  void require_velocity(std::size_t channel, const spline::Velocity<double>& velocity, std::uint64_t line) {
    KeyInChannel& before = before_in_[channel];
    const bool has_before = before.line != 0;
    if (has_before && !before.has_outgoing) {
      throw data_error(
          "the outgoing velocity of channel {} is missing; expected a number at every key but the last; fill it in, or "
          "remove the row",
          in_quotes(needs_.turns.channels[channel]))
          .at({"", before.line, 0});
    }
    if (has_before && std::isnan(velocity.in)) {
      throw data_error(
          "the incoming velocity of channel {} is missing; expected a number at every key but the first; fill it in, "
          "or remove the row",
          in_quotes(needs_.turns.channels[channel]))
          .at({"", line, 0});
    }
    before = {line, !std::isnan(velocity.out)};
  }

  struct KeyInChannel {
    std::uint64_t line = 0;  ///< 0: there is none
    bool has_outgoing = false;
  };

  KeyPreparation needs_;
  DoubleDouble time_;  ///< made from distances
  std::optional<Time> before_retimed_;
  std::vector<double> before_;  ///< the position of the key before, and its line; empty at the first one
  std::uint64_t line_ = 0;
  std::vector<KeyInChannel> before_in_;  ///< the last key in each channel
  std::size_t count_ = 0;
  TextPosition first_ = {"", 0, 0};  ///< of the first key, and in a list the column, too
  std::string list_position_;
  bool may_follow_break_ = false;  ///< it is not the first one of its list
};

/// Passes the keys of a curve without times on. Throws: Error (data) where the first channel, of this name, increases
/// from key to key, up to the thousandth: then it may be the time. A coordinate that counts the keys says the same.
/// `are_frames`: only whole numbers may be the time.
Source<KeyBlock> with_clear_times(Source<KeyBlock> blocks, std::string channel, std::string request, bool are_frames) {
  return [blocks = std::move(blocks), counts = is_coordinate(channel), are_frames, channel = std::move(channel),
          request = std::move(request), held = std::deque<KeyBlock>(),
          is_clear = false]() mutable -> std::optional<KeyBlock> {
    constexpr std::size_t most = 1000;
    std::size_t keys = 0;
    for (double before = 0; !is_clear;) {
      std::optional<KeyBlock> block = blocks();
      for (std::size_t i = 0; block && i < block->size() && keys < most && !is_clear; ++i) {
        const double now = block->keys.positions[i * block->keys.channels];
        counts = counts && now == static_cast<double>(keys);
        is_clear = (keys++ > 0 && !(before < now)) || (are_frames && now != std::trunc(now));
        before = now;
      }
      const bool is_known = is_clear || !block || keys == most;
      if (is_known && !is_clear && !counts && keys > 1) {
        throw data_error(
            "there is no time column, but column {} may be one; expected a column called time; give --columns {}, or "
            "--parameter uniform if the keys have no times",
            in_quotes(channel), in_shell("time=" + request));
      }
      is_clear = is_known;
      if (block) held.push_back(std::move(*block));
    }
    if (held.empty()) return blocks();
    KeyBlock first = std::move(held.front());
    held.pop_front();
    return first;
  };
}

}  // namespace

SignedKeys with_signs(Source<KeyBlock> blocks, std::vector<AngleColumn> angles) {
  if (angles.empty()) return {std::move(blocks), {}};
  std::vector<KeyBlock> all;
  for (AngleColumn& angle : angles) angle.is_signed = false;
  while (std::optional<KeyBlock> block = blocks()) {
    const Keys& keys = block->keys;
    for (AngleColumn& angle : angles) {
      for (std::size_t i = angle.channel; i < keys.positions.size(); i += keys.channels) {
        angle.is_signed = angle.is_signed || keys.positions[i] < 0;
      }
    }
    all.push_back(std::move(*block));
  }
  const auto again = [all = std::move(all), next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next == all.size()) return std::nullopt;
    return std::move(all[next++]);
  };
  return {again, std::move(angles)};
}

Time retimed(const Time& time, const Retiming& retiming, const std::optional<FrameTimes>& frames) {
  const auto frame = frames ? frames->exact(time) : std::nullopt;
  const Rational exact = frame.value_or(Rational(time.hi) + Rational(time.lo));
  const Time changed = nearest_time(retiming.origin + (exact - retiming.origin) * retiming.factor);
  if (!std::isfinite(changed.hi)) throw not_retimed(time, retiming);
  return changed;
}

Source<KeyBlock> prepared(Source<KeyBlock> blocks, const KeyPreparation& needs) {
  blocks = with_clear_turns(std::move(blocks), needs.turns);
  if (!needs.likely_time.empty()) {
    blocks = with_clear_times(std::move(blocks), needs.turns.channels[0], needs.likely_time, needs.counts_rows);
  }
  return [blocks = std::move(blocks), steps = Steps(needs)]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (block) return steps(std::move(*block));
    steps.end();
    return std::nullopt;
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

}  // namespace tcb
