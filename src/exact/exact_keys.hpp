// Keys as exact numbers, and the curve that they make, without any rounding.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "keys/rotations.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/rational.hpp"
#include "sample/extrapolation.hpp"
#include "schema/curve_channels.hpp"
#include "schema/key_block.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/curve_rules.hpp"

namespace tcb {

spline::CurveRules<Rational> exact_rules(const spline::CurveRules<double>& rules, bool decimal);

/// A rotation whose quaternions are converted from exact numbers at each scalar.
struct ExactRotation {
  ConvertedRotation rotation;
  /// One entry per key, including a last key that repeats the first one; 0 where missing.
  std::vector<spline::RotationNumbers<Rational>> numbers;
};

/// A curve without any rounding.
struct ExactCurve {
  spline::Keys<Rational> keys;                ///< the times have no meaning where distances make them
  std::vector<ExactRotation> converted = {};  ///< rotations whose positions and turns are converted and rounded
  spline::CurveRules<Rational> rules;
  CurveChannels channels = {};
  std::optional<double> exponent;  ///< of the distances that make the times
  bool closed = false;
  std::optional<Rational> end;  ///< when a closed curve is back at its first key, unless a distance gives it
  Extrapolations extrapolations;
  std::vector<spline::ChannelGap> gaps = {};
  bool decimal = false;  ///< numbers are the decimals that they are written as

  /// All numbers are rational: no distance makes a time or a tangent.
  bool is_rational() const {
    return !exponent && !rules.equal_speed && std::ranges::all_of(rules.angles, &spline::AngleChannel::degrees);
  }
};

/// The exact number of a time: that of its frame where times are frames in seconds, else as without them.
Rational exact_number(const Time& time, bool decimal, const std::optional<FrameTimes>& frames);

/// What is certain about the channels of a curve from its keys alone.
struct ChannelFacts {
  std::vector<bool> constant;   ///< all keys have the same position there
  std::vector<bool> zero;       ///< all keys have the position 0 there
  std::vector<Rational> cycle;  ///< last key - first key there
};
ChannelFacts channel_facts(const ExactCurve& exact);

/// Collects the keys of a curve as exact numbers.
class ExactKeys {
 public:
  /// `decimal`: a number is the decimal that it is written as, not the double nearest to it.
  /// `frames`: where times are frames in seconds.
  explicit ExactKeys(bool decimal, const std::vector<ConvertedRotation>& converted = {},
                     const std::optional<FrameTimes>& frames = {})
      : decimal_(decimal), frames_(frames) {
    for (const ConvertedRotation& rotation : converted) converted_.push_back({rotation, {}});
  }

  /// Throws: Error (data) for a decimal with too many digits.
  void add(const KeyBlock& block);

  /// Gives the keys of a block, the last one that was added, the times that their distances make, rounded once.
  void set_times(KeyBlock& block, double exponent, std::span<const std::size_t> metric);

  /// When a closed curve is back at its first key by the distance to it.
  Time time_back(double exponent, std::span<const std::size_t> metric) const;

  std::size_t size() const { return keys_.size(); }

  const std::vector<Rational>& times() const { return keys_.times; }

  /// The curve of the first `size` keys; where it is closed, its end is the time of the key after them, or `end`.
  ExactCurve curve(std::size_t size, const spline::CurveRules<double>& rules, const std::optional<Rational>& end) const;

 private:
  template <class Numbers>
  void add_velocities(const Keys& keys, std::size_t key, const Numbers& number);

  bool is_converted(std::size_t channel) const;

  bool decimal_;
  std::optional<FrameTimes> frames_;
  std::vector<ExactRotation> converted_;
  spline::Keys<Rational> keys_;
  Rational time_;  ///< of the last key, where distances make it: exactly that of a float
};

}  // namespace tcb
