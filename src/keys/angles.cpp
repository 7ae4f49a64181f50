// Angles among keys: their checks, and whether rows show negative ones.
#include "keys/angles.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "option_names.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/angle.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// One angle of successive keys.
class AngleChain {
 public:
  AngleChain(const AngleColumn& angle, std::string name) : angle_(angle), name_(std::move(name)) {}

  void check(const KeyBlock& block) {
    for (std::size_t key = 0; key < block.size(); ++key) {
      const double value = block.keys.position(key)[angle_.channel];
      const std::uint64_t line = block.line(key);
      if (std::isnan(value))
        throw data_error("the angle {} is missing; expected a number at every key; fill it in, or remove the row",
                         in_quotes(name_))
            .at({"", line, 0});
      require_angle(value, angle_.degrees, false, name_, line);
      if (line_ == 0) std::tie(first_, first_line_) = std::tie(value, line);
      require_turn(value, line, line_);
      std::tie(before_, line_) = std::tie(value, line);
    }
  }

  /// Checks the turn from the last key to the first one.
  void close() const { require_turn(first_, line_, first_line_); }

 private:
  /// Throws: Error (data), at a line, for half a turn from the last key to another one.
  void require_turn(double value, std::uint64_t line, std::uint64_t other) const {
    if (line_ == 0) return;
    const double half = spline::whole_turn<double>(angle_.degrees).hi / 2;
    const spline::DoubleDouble chord = spline::exact_difference(value, before_);
    const auto rest = chord - spline::nearest_turns<double>(chord, angle_.degrees);
    const bool is_half_turn = std::abs(std::abs(rest.hi) - half) <= half * 0x1p-50;
    if (is_half_turn)
      throw data_error(
          "the angle {} is exactly half a turn from the angle on line {}, so its direction is undefined; expected a "
          "smaller difference; add a key between them",
          in_quotes(name_), other)
          .at({"", line, 0});
  }

  AngleColumn angle_;
  std::string name_;
  double before_ = 0, first_ = 0;  ///< of the last key, and of the first one
  std::uint64_t line_ = 0;         ///< of the last one; 0: there is none
  std::uint64_t first_line_ = 0;
};

}  // namespace

void require_angle(double angle, bool degrees, bool makes_turns, const std::string& name, std::uint64_t line) {
  constexpr double turn = 6.283185307179586, most_turns = 1e4;
  if (std::abs(angle) <= (degrees ? 360 * most_turns : makes_turns ? turn * most_turns : turn)) return;
  const bool counts_turns = degrees || makes_turns;
  throw(counts_turns
            ? data_error(
                  "{} has an angle of {}; expected at most 10000 turns; check its column, and its unit with {} or {}",
                  in_quotes(name), angle, option::angles, option::angle)
            : data_error("{} has an angle of {} radians; expected at most one turn, 6.2832; give degrees as its unit "
                         "with {} or {}, or subtract whole turns",
                         in_quotes(name), angle, option::angles, option::angle))
      .at({"", line, 0});
}

Source<KeyBlock> with_clear_angles(Source<KeyBlock> blocks, const std::vector<AngleColumn>& angles,
                                   const std::vector<std::string>& channels, bool closed) {
  if (angles.empty()) return blocks;
  auto chains = std::make_shared<std::vector<AngleChain>>();
  for (const AngleColumn& angle : angles) chains->emplace_back(angle, channels[angle.channel]);
  blocks = mapped(std::move(blocks), [chains](KeyBlock block) {
    for (AngleChain& chain : *chains) chain.check(block);
    return block;
  });
  return closed ? with_checked_seam(std::move(blocks), std::move(chains)) : blocks;
}

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

LikelyAngles::LikelyAngles(const Schema& schema) : has_names_(schema.named) {
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    const bool is_angle = std::ranges::count(schema.angles, i, &AngleColumn::channel) > 0;
    const bool is_named = is_usual_angle(schema.channels[i]);
    if (is_angle || !(is_named || !schema.named || may_be_angle(schema.channels[i]))) continue;
    const bool is_of_rotation =
        std::ranges::any_of(schema.rotations, [i](const RotationSchema& rotation) { return rotation.columns.has(i); });
    if (is_of_rotation) continue;
    channels_.push_back({schema.sources.empty() ? i : schema.sources[i], schema.channels[i], is_named, true});
  }
}

Source<KeyBlock> LikelyAngles::observe(Source<KeyBlock> blocks) {
  if (channels_.empty()) return blocks;
  return mapped(std::move(blocks), [this](KeyBlock block) {
    for (Channel& channel : channels_) {
      for (std::size_t key = 0; key < block.size(); ++key) {
        if (block.begins_curve(key)) channel.before.reset();
        const double value = block.keys.position(key)[channel.channel];
        if (std::isnan(value)) continue;
        channel.largest = std::max(channel.largest, std::abs(value));
        channel.is_positive = channel.is_positive && value >= 0;
        channel.jump = std::max(channel.jump, std::abs(value - channel.before.value_or(value)));
        channel.before = value;
      }
    }
    return block;
  });
}

std::vector<NamedAngle> LikelyAngles::found() const {
  constexpr double half_turn = 3.15, whole_turn = 6.3;  // rounded up
  std::vector<NamedAngle> angles;
  for (const Channel& channel : channels_) {
    const bool degrees = channel.largest > whole_turn;
    // Within one turn, from 0 or around 0, where the name tells little.
    const double most = channel.is_positive ? (degrees ? 360.5 : 6.29) : (degrees ? 180.5 : half_turn);
    if (!channel.is_named && (channel.largest > most || (!has_names_ && !degrees))) continue;
    if (channel.jump > (degrees ? 180 : half_turn)) angles.push_back({channel.name, degrees});
  }
  return angles;
}

}  // namespace tcb
