// Key numbers: velocities, or tension, continuity and bias, that give keys their slopes, in few digits.
//
// With the chord velocities v0, v1 of a channel before and after a key, the default tangent rule has the slopes
//   in  = (1-T)((1-C)(1+B) v0 + (1+C)(1-B) v1)/2
//   out = (1-T)((1+C)(1+B) v0 + (1-C)(1-B) v1)/2
// For one slope S, C = 0, and B = 0, T = 1 - 2S/(v0+v1), or T = 0, B = (2S-v0-v1)/(v0-v1), the one nearer to 0.
// For a corner with C = -1, P = (1-T)(1+B)/2 = in/(2 v0) and Q = (1-T)(1-B)/2 = out/(2 v1): 1-T = P+Q, B = (P-Q)/(P+Q).
// At the first and the last key, the default end rule has out = (1-T)(1-C)(1-B) v1 and in = (1-T)(1-C)(1+B) v0; with
// C = B = 0 it is the tangent rule with the chord velocity on both sides.
// Source: the tables of tangent rules and end rules, solved for the three numbers.
#include "fit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "tcb/spline/rotation.hpp"

namespace tcb {
namespace {

using Tcb = spline::Tcb<double>;

/// The nearest multiple of the largest power of ten that is at most `step`, as the double nearest to that decimal.
double rounded(double number, double step) {
  constexpr double largest = 9007199254740992.0;  // 2^53
  if (!(step > 1e-22) || !(step < 1e22)) return number;
  double power = 1;  // of ten, exact
  if (step >= 1) {
    while (power * 10 <= step) power *= 10;
    return std::nearbyint(number / power) * power + 0.0;  // no negative zero
  }
  while (1 / power > step) power *= 10;
  const double scaled = number * power;
  return std::abs(scaled) < largest ? std::nearbyint(scaled) / power + 0.0 : number;
}

/// Tension, continuity and bias of one slope between chords with these velocities, rounded so that the slope changes by
/// at most `step`; nothing where none give it.
std::optional<Tcb> tcb_of_slope(double slope, double before, double after, double step) {
  const double sum = before + after, difference = before - after;
  const auto size = [](double number) { return std::abs(number); };
  const Tcb tense{1 - 2 * slope / sum, 0, 0}, biased{0, 0, (2 * slope - sum) / difference};
  const bool can_tense = std::isfinite(tense.tension), can_bias = std::isfinite(biased.bias);
  constexpr double rounding = 1 + 1e-9;
  if (can_tense && (!can_bias || size(tense.tension) <= size(biased.bias) * rounding)) {
    return Tcb{rounded(tense.tension, 2 * step / size(sum)), 0, 0};
  }
  if (can_bias) return Tcb{0, 0, rounded(biased.bias, 2 * step / size(difference))};
  return size(slope) <= step ? std::optional(Tcb{}) : std::nullopt;
}

/// Tension, continuity and bias of an incoming and an outgoing slope, as tcb_of_slope().
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

using Quaternion = spline::Quaternion<double>;
using Vector = spline::Vector3<double>;

std::array<double, 4> numbers_of(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector scaled(const Vector& v, double factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

/// Tension, continuity and bias of the tangents of a rotation nearest to these, between chords with these velocities,
/// rounded so that a tangent changes by at most `step`. Tangents that differ lie along the chords.
Tcb tcb_of_turns(const Vector& in, const Vector& out, const Vector& before, const Vector& after, double step) {
  const double before2 = dot(before, before), after2 = dot(after, after), both = dot(before, after);
  const bool is_corner = in != out;
  double p = 0.5, q = 0.5;  // the parts of the chords in the tangent
  if (before2 > 0 && after2 > 0 && is_corner) {
    p = dot(in, before) / before2;
    q = dot(out, after) / after2;
  } else if (before2 > 0 && before == after) {
    p = q = dot(in, before) / (2 * before2);
  } else if (before2 > 0 && after2 > 0) {
    const double little = 1e-6 * (before2 + after2);  // keeps them near a half where chords are parallel
    const double first = dot(in, before) + little / 2, second = dot(in, after) + little / 2;
    const double determinant = (before2 + little) * (after2 + little) - both * both;
    p = (first * (after2 + little) - second * both) / determinant;
    q = (second * (before2 + little) - first * both) / determinant;
  } else if (before2 + after2 > 0) {
    p = q = (dot(in, before) + dot(out, after)) / (before2 + after2);
  }
  const double sum = p + q, bias = (p - q) / sum;
  if (!std::isfinite(bias)) return {1, 0, 0};
  const double chords = std::sqrt(before2) + std::sqrt(after2);
  const double little = step / (4 * chords * (1 + std::abs(p) + std::abs(q)) * (1 + std::abs(bias)));
  return {rounded(is_corner ? 1 - sum / 2 : 1 - sum, little), is_corner ? -1.0 : 0.0, rounded(bias, little)};
}

class Numbering {
 public:
  Numbering(const std::vector<CornerKey>& keys, const Recording& recording, const std::vector<Time>& times,
            const FitRules& rules)
      : keys_(keys), recording_(recording), times_(times), rules_(rules) {}

  spline::Keys<double> run() {
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
      if (group.angle) {
        set_rotation(group);
        continue;
      }
      const double step = group.tolerance / 1000 / std::sqrt(static_cast<double>(group.channels.size()));
      for (const std::size_t channel : group.channels) set_channel(channel, step);
    }
    return std::move(result_);
  }

 private:
  double duration(std::size_t key) const {
    return recording_.times[keys_[key + 1].sample] - recording_.times[keys_[key].sample];
  }

  /// Of the segments of a key.
  double longest_duration(std::size_t key) const {
    return std::max(key > 0 ? duration(key - 1) : 0, key + 1 < keys_.size() ? duration(key) : 0);
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
      const auto chord = [&](std::size_t from) { return (position(from + 1) - position(from)) / duration(from); };
      const double before = chord(has_before ? key - 1 : key);
      const double after = chord(has_after ? key : key - 1);
      const double slope_step =
          step * 4 / longest_duration(key);  // moves the curve by at most 4/27 of its product with a duration
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

  void set_rotation(const FitGroup& group) {
    const double step = *group.angle / 4000;  // of half the angle
    std::vector<Quaternion> rotations;        // as they are read
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      const std::span numbers = std::span(result_.positions).subspan(key * recording_.channels, recording_.channels);
      const auto unit = numbers_of(spline::rotation_of<double>(keys_[key].position, group.rotation()));
      for (std::size_t i = 0; i < unit.size(); ++i) numbers[group.channels[i]] = rounded(unit[i], step);
      rotations.push_back(spline::rotation_of<double>(numbers, group.rotation()));
    }
    std::vector<Vector> chords(1);  // per unit of time; those at the ends are repeated
    for (std::size_t key = 0; key + 1 < keys_.size(); ++key) {
      const Quaternion turn = spline::conjugate(rotations[key]) * rotations[key + 1];
      chords.push_back(scaled(spline::logarithm(turn.w < 0 ? -turn : turn), 1 / duration(key)));
    }
    chords.front() = chords[1];
    chords.push_back(chords.back());
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      const double slope_step = 4 * step / longest_duration(key);
      const Vector in = tangent(key, group, &CornerKey::incoming), out = tangent(key, group, &CornerKey::outgoing);
      const Tcb tcb = tcb_of_turns(in, out, chords[key], chords[key + 1], slope_step);
      const auto before = numbers_of(rotations[key] * Quaternion{in[0], in[1], in[2], 0});
      const auto after = numbers_of(rotations[key] * Quaternion{out[0], out[1], out[2], 0});
      for (std::size_t i = 0; i < before.size(); ++i) {
        const std::size_t number = key * recording_.channels + group.channels[i];
        if (rules_.keys == FitKeys::tcb) {
          result_.tcbs[number] = tcb;
        } else {
          result_.velocities[number] = {rounded(before[i], slope_step / 2), rounded(after[i], slope_step / 2)};
        }
      }
    }
  }

  /// The logarithm of the turn of a key per unit of time, from the slopes of the four numbers.
  Vector tangent(std::size_t key, const FitGroup& group, std::vector<double> CornerKey::*slope) const {
    const auto four = [&](const std::vector<double>& numbers) {
      const auto [x, y, z, w] = group.rotation();
      return Quaternion{numbers[x], numbers[y], numbers[z], numbers[w]};
    };
    const Quaternion q = four(keys_[key].position), turn = spline::conjugate(q) * four(keys_[key].*slope);
    return scaled({turn.x, turn.y, turn.z}, 1 / spline::dot(q, q));
  }

  const std::vector<CornerKey>& keys_;
  const Recording& recording_;
  const std::vector<Time>& times_;
  const FitRules& rules_;
  spline::Keys<double> result_;
};

}  // namespace

spline::Keys<double> numbered_keys(const std::vector<CornerKey>& keys, const Recording& recording,
                                   const std::vector<Time>& times, const FitRules& rules) {
  return Numbering(keys, recording, times, rules).run();
}

}  // namespace tcb
