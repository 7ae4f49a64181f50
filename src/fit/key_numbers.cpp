// Key numbers: velocities, or tension, continuity and bias, that give keys their slopes, in few digits.
#include "fit/key_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tcb {
namespace {

using Tcb = spline::Tcb<double>;

/// The nearest multiple of the largest power of ten that is at most `step`, as the double nearest to that decimal.
double rounded(double number, double step) {
  constexpr double largest = 9007199254740992.0;  // 2^53
  if (!(step > 1e-22) || !(step < 1e22)) return number;
  double power = 1;  // 10^n or its inverse, exact
  while (power > step) power /= 10;
  if (step >= 1) {
    while (power * 10 <= step) power *= 10;
    return std::nearbyint(number / power) * power + 0.0;  // no negative zero
  }
  double inverse = 1;
  while (1 / inverse > step) inverse *= 10;
  const double scaled = number * inverse;
  return std::abs(scaled) < largest ? std::nearbyint(scaled) / inverse + 0.0 : number;
}

/// Tension, continuity and bias of one slope between chords with these velocities, rounded so that the slope changes by
/// at most `step`; nothing where none give it.
std::optional<Tcb> tcb_of_slope(double slope, double before, double after, double step) {
  const double sum = before + after, difference = before - after;
  const auto size = [](double number) { return std::abs(number); };
  const Tcb tense{1 - 2 * slope / sum, 0, 0}, biased{0, 0, (2 * slope - sum) / difference};
  const bool can_tense = std::isfinite(tense.tension), can_bias = std::isfinite(biased.bias);
  if (can_tense && (!can_bias || size(tense.tension) <= size(biased.bias))) {
    return Tcb{rounded(tense.tension, 2 * step / size(sum)), 0, 0};
  }
  if (can_bias) return Tcb{0, 0, rounded(biased.bias, 2 * step / size(difference))};
  return size(slope) <= step ? std::optional(Tcb{}) : std::nullopt;
}

/// The same for two slopes.
std::optional<Tcb> tcb_of_corner(double in, double out, double before, double after, double step) {
  if (std::abs(in - out) <= step) return tcb_of_slope((in + out) / 2, before, after, step);
  const auto of = [&](double continuity, double p, double q) -> std::optional<Tcb> {
    const double tension = 1 - (p + q), bias = (p - q) / (p + q);
    if (!std::isfinite(tension) || !std::isfinite(bias)) return std::nullopt;
    const double chords = std::abs(before) + std::abs(after),
                 factors = (1 + std::abs(p) + std::abs(q)) * (1 + std::abs(bias));
    const double little = step / (4 * chords * factors);
    return Tcb{rounded(tension, little), rounded(continuity, little), rounded(bias, little)};
  };
  if (before != 0 && after != 0) {
    for (const double c : {-1.0, -0.5}) {  // the second where p + q is 0 for the first
      const double half = (out - in) / (2 * c), sum = (in + out) / 2;
      if (const auto tcb = of(c, (sum + half) / (2 * before), (sum - half) / (2 * after))) return tcb;
    }
    return std::nullopt;
  }
  const double c = before == 0 ? (in - out) / (in + out) : (out - in) / (in + out);
  const double chord = before == 0 ? after : before;
  if (!std::isfinite(c)) return std::nullopt;
  return before == 0 ? of(c, 0, (in + out) / (2 * chord)) : of(c, (in + out) / (2 * chord), 0);
}

class Numbering {
 public:
  Numbering(const std::vector<CornerKey>& keys, const Recording& recording, const std::vector<Time>& times,
            const FitRules& rules)
      : keys_(keys), recording_(recording), times_(times), rules_(rules) {}

  Keys run() {
    result_.channels = recording_.channels;
    result_.positions.resize(keys_.size() * recording_.channels);
    for (const CornerKey& key : keys_) result_.times.push_back(times_[key.sample]);
    const std::size_t numbers = keys_.size() * recording_.channels;
    if (rules_.keys == FitKeys::tcb) result_.tcbs.resize(numbers);
    if (rules_.keys == FitKeys::hermite) {
      result_.velocities.resize(numbers);
      result_.given.assign(recording_.channels, true);
    }
    for (const FitGroup& group : recording_.groups) {
      const double step = group.tolerance / 1000 / std::sqrt(static_cast<double>(group.channels.size()));
      for (const std::size_t channel : group.channels) set_channel(channel, step);
    }
    return std::move(result_);
  }

 private:
  double duration(std::size_t key) const {
    return recording_.times[keys_[key + 1].sample] - recording_.times[keys_[key].sample];
  }

  void set_channel(std::size_t channel, double step) {
    const auto position = [&](std::size_t key) -> double& {
      return result_.positions[key * recording_.channels + channel];
    };
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      position(key) = rounded(keys_[key].position[channel], step);
    }
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      const bool has_before = key > 0, has_after = key + 1 < keys_.size();
      const double before = has_before ? (position(key) - position(key - 1)) / duration(key - 1) : 0;
      const double after = has_after ? (position(key + 1) - position(key)) / duration(key) : 0;
      const double longest = std::max(has_before ? duration(key - 1) : 0, has_after ? duration(key) : 0);
      const double slope_step = step * 4 / longest;  // moves the curve by at most 4/27 of its product with a duration
      const double in = has_before ? keys_[key].incoming[channel] : keys_[key].outgoing[channel];
      const double out = has_after ? keys_[key].outgoing[channel] : in;
      const std::size_t number = key * recording_.channels + channel;
      if (rules_.keys == FitKeys::tcb) {
        result_.tcbs[number] = tcb_of_corner(in, out, before, after, slope_step).value_or(Tcb{1, 0, 0});
      } else {
        result_.velocities[number] = {rounded(in, slope_step), rounded(out, slope_step)};
      }
    }
  }

  const std::vector<CornerKey>& keys_;
  const Recording& recording_;
  const std::vector<Time>& times_;
  const FitRules& rules_;
  Keys result_;
};

}  // namespace

Keys numbered_keys(const std::vector<CornerKey>& keys, const Recording& recording, const std::vector<Time>& times,
                   const FitRules& rules) {
  return Numbering(keys, recording, times, rules).run();
}

}  // namespace tcb
