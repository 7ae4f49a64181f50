// Prepare: what the keys of a curve go through before they make it: quaternions, times for those without any, and
// checks of their numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "keys/rotations.hpp"
#include "numbers/frame_times.hpp"
#include "schema/curve_channels.hpp"
#include "schema/curve_settings.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"
#include "tcb/spline/double_double.hpp"

namespace tcb {

/// The scale on which a product shows tension, continuity and bias, where it is not from -1 to 1.
enum class ShownTcbScale { from_0_to_50, percent };

/// What the keys of a curve need before they make it.
struct KeyPreparation {
  TurnsOfKeys turns;
  std::string likely_time = {};           ///< the first channel as it can be requested, if it may be the time
  bool counts_rows = false;               ///< keys have the times of rows at a rate, of which the channel has numbers
  std::optional<double> exponent = {};    ///< of the distances that make the times; nothing: keys have times
  std::vector<std::size_t> metric = {};   ///< the channels of these distances; empty: all
  std::optional<Retiming> retiming = {};  ///< their times change
  std::optional<FrameTimes> frames = {};  ///< where the times before that are frames in seconds
  std::optional<ShownTcbScale> unlikely_scale = {};  ///< on which tension, continuity and bias must not seem to be
  bool ease = true;                                  ///< that of keys is used
  bool monotone = false;                             ///< the timing, which has no ease, velocities or missing positions
  bool equal_speed = false;                          ///< of incoming and outgoing tangents, which has no velocities
  bool only_breaks = false;                          ///< begin new curves, and no groups
  std::size_t least = 2;                             ///< number of keys, 1 or 2
};

/// The new time of a key. `frames`: where times are frames in seconds.
Time retimed(const Time& time, const Retiming& retiming, const std::optional<FrameTimes>& frames);

/// The keys after all steps. Without times they get t[i+1] = t[i] + |P[i+1] - P[i]|^exponent, which is t[i] + 1 for
/// exponent 0. Throws: Error (data) with the line of a key.
Source<KeyBlock> prepared(Source<KeyBlock> blocks, const KeyPreparation& needs);

/// Keys, and whether any angle of a channel is negative, for which all keys are read where there are angles.
struct SignedKeys {
  Source<KeyBlock> blocks;
  std::vector<AngleColumn> angles;
};
SignedKeys with_signs(Source<KeyBlock> blocks, std::vector<AngleColumn> angles);

/// The power of a distance at a scalar, from its square. Doubles add up squares as double-doubles, in units of a power
/// of two, so that none overflows or vanishes. Exact scalars have their own, in exact/exact_curve.hpp.
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
