// Fit: few keys whose curve stays within tolerances of a recording, checked on the numbers as they are printed.
#include "fit/fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tcb/spline/angle.hpp"
#include "tcb/spline/ease.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/window_segments.hpp"

namespace tcb {
namespace {

bool limits_angle(const FitGroup& group) { return group.angle.has_value(); }

/// The samples of a recording from one to another one, with a share of the tolerances, which leaves room for the
/// rounding of keys.
Recording part_of(const Recording& recording, std::size_t first, std::size_t last, double share) {
  const auto at = [](const std::vector<double>& numbers, std::size_t index) {
    return numbers.begin() + static_cast<std::ptrdiff_t>(index);
  };
  Recording part{
      recording.channels,
      {at(recording.times, first), at(recording.times, last + 1)},
      {at(recording.positions, first * recording.channels), at(recording.positions, (last + 1) * recording.channels)},
      recording.groups,
      first > 0,
      last + 1 < recording.size()};
  for (FitGroup& group : part.groups) group.tolerance *= share;
  return part;
}

/// The listed samples in [first, last], renumbered from `first`.
std::vector<std::size_t> between(const std::vector<std::size_t>& samples, std::size_t first, std::size_t last) {
  std::vector<std::size_t> result;
  for (const std::size_t sample : samples) {
    if (sample >= first && sample <= last) result.push_back(sample - first);
  }
  return result;
}

/// The angle of the turn between two rotations, in radians.
double angle_between(const spline::Quaternion<double>& a, const spline::Quaternion<double>& b) {
  const auto turn = spline::conjugate(a) * b;
  return 2 * spline::angle_of(std::sqrt(turn.x * turn.x + (turn.y * turn.y + turn.z * turn.z)), std::abs(turn.w));
}

/// The distances of the samples from the curve of keys, as it is read.
class Verification {
 public:
  Verification(const Recording& recording, const std::vector<Time>& times) : recording_(recording), times_(times) {}

  /// Sets the largest distance, and returns that of each segment, in tolerances.
  std::vector<double> measure(const std::vector<std::size_t>& samples, FitResult& result) const {
    spline::CurveRules<double> rules;
    for (const FitGroup& group : recording_.groups) {
      if (group.angle) rules.rotations.push_back({group.rotation()});
    }
    const std::size_t rotations = rules.rotations.size();
    const auto segments = spline::segments(spline::Window<double>{result.keys}, rules);
    std::vector<double> worst(segments.size());
    result.largest = 0;
    for (std::size_t segment = 0; segment < segments.size(); ++segment) {
      const spline::TimeMap<double> map(segments.times[segment], segments.times[segment + 1], {});
      const auto turns = std::span(segments.rotations).subspan(segment * rotations, rotations);
      for (std::size_t sample = samples[segment]; sample <= samples[segment + 1]; ++sample) {
        const double now = error(segments[segment], turns, map(times_[sample]), sample);
        worst[segment] = std::max(worst[segment], now);
        if (!(now <= result.largest)) {
          result.largest = now;
          result.sample = sample;
        }
      }
    }
    return worst;
  }

 private:
  double error(std::span<const spline::Cubic<double>> cubics, std::span<const spline::RotationSegment<double>> turns,
               const spline::LocalParameter<double>& at, std::size_t sample) const {
    double largest = 0;
    for (const FitGroup& group : recording_.groups) {
      if (group.angle) {
        largest = std::max(largest, angle_between(turns.front().at(at), rotation(group, sample)) / *group.angle);
        turns = turns.subspan(1);
        continue;
      }
      double sum = 0;
      for (const std::size_t channel : group.channels) {
        const double gap = spline::position(cubics[channel], at) - recording_.position(sample, channel);
        sum += gap * gap;
      }
      largest = std::max(largest, std::sqrt(sum) / group.tolerance);
    }
    return largest;
  }

  spline::Quaternion<double> rotation(const FitGroup& group, std::size_t sample) const {
    return spline::rotation_of(std::span(recording_.positions).subspan(sample * recording_.channels), group.rotation());
  }

  const Recording& recording_;
  const std::vector<Time>& times_;
};

/// The keys of the parts between corners, joined.
std::vector<CornerKey> joined_keys(const Recording& recording, double share, const FirstTimes& times,
                                   const std::vector<std::size_t>& corners, const std::vector<std::size_t>& fixed,
                                   const FitRules& rules) {
  std::vector<CornerKey> keys;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const std::size_t first = corners[i - 1], last = corners[i];
    const auto own = fitting_keys(part_of(recording, first, last, share),
                                  {between(times.cubics, first, last), between(times.knots, first, last)},
                                  between(fixed, first, last), rules.done, rules.threads);
    for (const FitKey& key : own) {
      const bool is_corner = !keys.empty() && key.sample == 0;
      if (!is_corner) keys.push_back({first + key.sample, key.position, key.slope, key.slope});
      keys.back().outgoing = key.slope;
    }
  }
  return keys;
}

/// The largest distance between two samples, in tolerances.
double distance(const Recording& recording, std::size_t a, std::size_t b) {
  double largest = 0;
  for (const FitGroup& group : recording.groups) {
    double sum = 0;
    for (const std::size_t channel : group.channels) {
      const double gap = recording.position(a, channel) - recording.position(b, channel);
      sum += gap * gap;
    }
    largest = std::max(largest, std::sqrt(sum) / group.tolerance);
  }
  return largest;
}

/// The directions of the samples; with a single channel, those in its graph, scaled to a square.
class Directions {
 public:
  static constexpr std::size_t reach = 12;  ///< samples

  explicit Directions(const Recording& recording) : recording_(recording) {
    if (recording.channels > 1) return;
    const auto [least, most] = std::ranges::minmax(recording.positions);
    time_ = (most - least) / recording.times.back();
  }

  /// The cosine of the turn at a sample, between the nearest samples at least four tolerances away; 1 if there are none
  /// within reach.
  double cosine(std::size_t sample) const {
    constexpr double away = 4;
    std::size_t before = sample, after = sample;
    while (before > 0 && sample - before < reach && distance(recording_, before, sample) < away) --before;
    while (after + 1 < recording_.size() && after - sample < reach && distance(recording_, after, sample) < away)
      ++after;
    if (distance(recording_, before, sample) < away || distance(recording_, after, sample) < away) return 1;
    double in2 = 0, out2 = 0, both = 0;
    const auto add = [&](double in, double out) {
      in2 += in * in;
      out2 += out * out;
      both += in * out;
    };
    for (std::size_t c = 0; c < recording_.channels; ++c) {
      const double position = recording_.position(sample, c);
      add(position - recording_.position(before, c), recording_.position(after, c) - position);
    }
    add((recording_.times[sample] - recording_.times[before]) * time_,
        (recording_.times[after] - recording_.times[sample]) * time_);
    return both / std::sqrt(in2 * out2);
  }

 private:
  const Recording& recording_;
  double time_ = 0;  ///< positions per unit of time in the graph; 0 with several channels
};

/// The share of the tolerances, at most a quarter, that the rounding of times to doubles may use up: samples are also
/// within the tolerances where the times are taken as the decimals that they are written as.
double share_for_times(const Recording& recording, const std::vector<Time>& times) {
  if (std::ranges::any_of(times, [](const Time& time) { return time.lo != 0; })) return 0;  // these are exact
  const double spacing = std::max(std::abs(times.front().hi), std::abs(times.back().hi)) * 0x1p-52;
  double largest = 0;
  for (std::size_t sample = 1; sample < recording.size(); ++sample) {
    const double duration = recording.times[sample] - recording.times[sample - 1];
    largest = std::max(largest, distance(recording, sample - 1, sample) / duration);
  }
  return std::min(2 * spacing * largest, 0.25);
}

/// The number of keys that any curve within the tolerances of distances has.
std::size_t least_keys(Recording recording, unsigned threads) {
  std::erase_if(recording.groups, limits_angle);
  return longest_cubics(recording, threads).size() + 1;
}

}  // namespace

std::vector<std::size_t> corners_of(const Recording& recording, double degrees) {
  const double limit = spline::ReducedAngle::of_degrees(degrees).cosine();
  const Directions directions(recording);
  std::vector<double> cosines;
  for (std::size_t i = 0; i < recording.size(); ++i) cosines.push_back(directions.cosine(i));
  std::vector<std::size_t> corners;
  for (std::size_t i = 1; i + 1 < recording.size(); ++i) {
    const std::size_t first = i - std::min(i, Directions::reach);
    const auto around =
        std::span(cosines).subspan(first, std::min(i + Directions::reach + 1, recording.size()) - first);
    const bool is_sharpest = cosines[i] <= *std::ranges::min_element(around);
    if (cosines[i] < limit && is_sharpest && (corners.empty() || corners.back() + Directions::reach < i)) {
      corners.push_back(i);
    }
  }
  return corners;
}

std::optional<FitResult> fit(const Recording& recording, const std::vector<Time>& times, const FitRules& rules) {
  const std::size_t last = recording.size() - 1;
  std::vector<std::size_t> corners{0}, fixed = rules.fixed;
  if (rules.corner) {
    const auto inner = corners_of(recording, *rules.corner);
    corners.insert(corners.end(), inner.begin(), inner.end());
  }
  corners.push_back(last);
  fixed.insert(fixed.end(), corners.begin(), corners.end());
  FitResult result;
  FirstTimes first_times{longest_cubics(recording, rules.threads), {}};
  first_times.knots = knots_of(recording, first_times.cubics.size(), rules.threads);
  if (rules.done) rules.done(recording.size());
  const bool has_rotations = std::ranges::any_of(recording.groups, &limits_angle);
  result.least_keys = has_rotations ? least_keys(recording, rules.threads) : first_times.cubics.size() + 1;
  const Verification verification(recording, times);
  const double limit = 1 - share_for_times(recording, times);
  double share = 0.998 * limit;  // each failed attempt takes a smaller one, and adds a key to each segment that failed
  for (int attempt = 0; attempt < 12; ++attempt) {
    std::ranges::sort(fixed);
    fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
    const auto keys = joined_keys(recording, share, first_times, corners, fixed, rules);
    result.keys = numbered_keys(keys, recording, times, rules);
    std::vector<std::size_t> samples;
    std::ranges::transform(keys, std::back_inserter(samples), &CornerKey::sample);
    const std::vector<double> worst = verification.measure(samples, result);
    if (result.largest <= limit) return result;
    for (std::size_t i = 0; i < worst.size(); ++i) {
      if (!(worst[i] <= limit)) fixed.push_back((samples[i] + samples[i + 1]) / 2);
    }
    share = attempt < 4 ? share - 0.005 : 0.6 * share;
  }
  return std::nullopt;
}

}  // namespace tcb
