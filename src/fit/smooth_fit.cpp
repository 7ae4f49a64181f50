// Smooth fits: positions and slopes of keys at given times, so that the largest distance from the samples is small.
#include "fit/smooth_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "fit/banded.hpp"

namespace tcb {
namespace {

/// The weights of the position and slope at the start and at the end of a segment for its point at u.
using Hermite = std::array<double, 4>;

Hermite hermite_at(double u, double duration) {
  const double left = 1 - u;
  return {left * left * (1 + 2 * u), u * left * left * duration, u * u * (3 - 2 * u), -u * u * left * duration};
}

/// Numbers of the channels of a group.
template <class T, std::size_t channels>
using PerChannel = std::conditional_t<channels == 0, std::vector<T>, std::array<T, channels>>;

/// The fit of the channels of one group. `channels`: how many there are, which makes the inner loops faster; 0: any
/// number.
template <std::size_t channels>
class GroupFit {
 public:
  GroupFit(const Recording& recording, const FitGroup& group, std::span<FitKey> keys, FixedEnds fixed)
      : recording_(recording),
        channels_(group.channels),
        tolerance_(group.tolerance),
        keys_(keys),
        fixed_(fixed),
        first_(keys.front().sample),
        unit_(elapsed(first_, keys.back().sample) / static_cast<double>(keys.size() - 1)),
        weights_(keys.back().sample - first_ + 1, 1.0),
        errors_(weights_.size()),
        worst_(keys.size() - 1) {
    hermite_.reserve(weights_.size());
    values_.reserve(weights_.size() * channels_.size());
    for (std::size_t segment = 0; segment + 1 < keys.size(); ++segment) {
      const std::size_t from = keys[segment].sample;
      const double duration = elapsed(from, keys[segment + 1].sample);
      for (std::size_t i = from; i < end_of(segment); ++i) {
        hermite_.push_back(hermite_at(elapsed(from, i) / duration, duration / unit_));
        for (const std::size_t channel : channels_) values_.push_back(recording.position(i, channel));
      }
    }
  }

  void run(const FitEffort& effort, std::span<double> result) {
    // Where segments are long, few of their samples decide, and their weights need more steps.
    const bool has_long_segments = is_window() && weights_.size() > 50 * worst_.size();
    const int most = effort.most_weightings * (has_long_segments ? 2 : 1);
    double before = 0;
    for (int i = 0;; ++i) {
      solve(effort.stiffness, i > 0);
      measure();
      const double largest = *std::ranges::max_element(worst_);
      if (largest <= 1 || i >= most || (is_window() && is_impossible())) break;
      constexpr int interval = 3;
      if (is_window() && i % interval == 0) {
        if (i > 0 && !may_suffice(largest, before, (most - i) / interval)) break;
        before = largest;
      }
      weigh();
    }
    for (std::size_t i = 0; i < worst_.size(); ++i) result[i] = std::max(result[i], worst_[i]);
  }

 private:
  double elapsed(std::size_t from, std::size_t to) const { return recording_.times[to] - recording_.times[from]; }

  /// Before which sample a segment ends: a key is on the segment after it, the last one on the last segment.
  std::size_t end_of(std::size_t segment) const {
    return keys_[segment + 1].sample + (segment + 2 == keys_.size() ? 1 : 0);
  }

  std::size_t count() const { return channels == 0 ? channels_.size() : channels; }

  template <class T>
  PerChannel<T, channels> per_channel() const {
    if constexpr (channels == 0) {
      return std::vector<T>(channels_.size());
    } else {
      return {};
    }
  }

  /// The variables are positions and slopes, these per mean duration of a segment; or their `corrections`, which keep
  /// the digits that the squares of the equations lose, and are pulled to 0 instead of to plain slopes.
  void solve(double stiffness, bool corrections) {
    Banded matrix(2 * keys_.size());
    std::vector<std::vector<double>> targets(count(), std::vector<double>(2 * keys_.size()));
    auto cubic = per_channel<Hermite>();
    for (std::size_t segment = 0; segment + 1 < keys_.size(); ++segment) {
      std::array<Hermite, 4> products{};  // in each row, those up to the diagonal count
      auto target = per_channel<Hermite>();
      for (std::size_t c = 0; c < count(); ++c) cubic[c] = cubic_of(segment, channels_[c]);
      for (std::size_t i = keys_[segment].sample - first_; i < end_of(segment) - first_; ++i) {
        const Hermite h = hermite_[i];
        Hermite part;
        for (std::size_t j = 0; j < h.size(); ++j) part[j] = weights_[i] * h[j];
        for (std::size_t k = 0; k < h.size(); ++k) {
          for (std::size_t j = 0; j < h.size(); ++j) products[k][j] += part[j] * h[k];
        }
        for (std::size_t c = 0; c < count(); ++c) {
          const double wanted = values_[i * count() + c] - (corrections ? position(cubic[c], h) : 0);
          for (std::size_t j = 0; j < h.size(); ++j) target[c][j] += part[j] * wanted;
        }
      }
      for (std::size_t j = 0; j < products.size(); ++j) {
        for (std::size_t k = 0; k <= j; ++k) matrix.at(2 * segment + j, 2 * segment + k) += products[k][j];
        for (std::size_t c = 0; c < count(); ++c) targets[c][2 * segment + j] += target[c][j];
      }
    }
    keep_regular(matrix, targets, stiffness, corrections);
    fix_ends(matrix, targets, corrections);
    matrix.factor();
    for (std::size_t c = 0; c < count(); ++c) {
      matrix.solve(targets[c]);
      for (std::size_t key = 0; key < keys_.size(); ++key) {
        double &position = keys_[key].position[channels_[c]], &slope = keys_[key].slope[channels_[c]];
        position = (corrections ? position : 0) + targets[c][2 * key];
        slope = (corrections ? slope : 0) + targets[c][2 * key + 1] / unit_;
      }
    }
  }

  /// The numbers of a segment in a channel that hermite_ weighs.
  Hermite cubic_of(std::size_t segment, std::size_t channel) const {
    const FitKey &from = keys_[segment], &to = keys_[segment + 1];
    return {from.position[channel], from.slope[channel] * unit_, to.position[channel], to.slope[channel] * unit_};
  }

  static double position(const Hermite& cubic, const Hermite& h) {
    return (h[0] * cubic[0] + h[1] * cubic[1]) + (h[2] * cubic[2] + h[3] * cubic[3]);
  }

  /// Pulls each key a little to its sample, and to a slope between those to the samples next to it, so that no slopes
  /// swing where samples do not determine them.
  void keep_regular(Banded& matrix, std::vector<std::vector<double>>& targets, double stiffness, bool corrections) {
    double total = 0;
    for (const double w : weights_) total += w;
    const double strength = stiffness * total / static_cast<double>(weights_.size());
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      const std::size_t sample = keys_[key].sample;
      matrix.at(2 * key, 2 * key) += strength * 1e-3;
      matrix.at(2 * key + 1, 2 * key + 1) += strength;
      for (std::size_t c = 0; c < targets.size() && !corrections; ++c) {
        targets[c][2 * key] += strength * 1e-3 * recording_.position(sample, channels_[c]);
        targets[c][2 * key + 1] += strength * plain_slope(sample, channels_[c]) * unit_;
      }
    }
  }

  /// The smaller one of the slopes to the samples next to a sample; 0 where they have different signs.
  double plain_slope(std::size_t sample, std::size_t channel) const {
    const auto slope = [&](std::size_t from) {
      return (recording_.position(from + 1, channel) - recording_.position(from, channel)) / elapsed(from, from + 1);
    };
    if (sample == 0) return slope(0);
    if (sample + 1 == recording_.size()) return slope(sample - 1);
    const double before = slope(sample - 1), after = slope(sample);
    if ((before < 0) != (after < 0)) return 0;
    return std::abs(before) < std::abs(after) ? before : after;
  }

  void fix_ends(Banded& matrix, std::vector<std::vector<double>>& targets, bool corrections) {
    const auto fix = [&](std::size_t variable, const auto& value) {
      for (std::size_t c = 0; c < targets.size(); ++c) {
        matrix.move_to_target(variable, corrections ? 0 : value(channels_[c]), targets[c]);
      }
      matrix.remove(variable);
    };
    const auto fix_key = [&](std::size_t key, bool is_fixed, bool is_corner) {
      if (is_fixed) {
        fix(2 * key, [&](std::size_t channel) { return keys_[key].position[channel]; });
        fix(2 * key + 1, [&](std::size_t channel) { return keys_[key].slope[channel] * unit_; });
      } else if (is_corner) {
        fix(2 * key, [&](std::size_t channel) { return recording_.position(keys_[key].sample, channel); });
      }
    };
    fix_key(0, fixed_.first, recording_.starts_at_corner && keys_.front().sample == 0);
    fix_key(keys_.size() - 1, fixed_.last, recording_.ends_at_corner && keys_.back().sample + 1 == recording_.size());
  }

  void measure() {
    auto cubic = per_channel<Hermite>();
    for (std::size_t segment = 0; segment + 1 < keys_.size(); ++segment) {
      for (std::size_t c = 0; c < count(); ++c) cubic[c] = cubic_of(segment, channels_[c]);
      double largest = 0;
      for (std::size_t i = keys_[segment].sample - first_; i < end_of(segment) - first_; ++i) {
        const Hermite& h = hermite_[i];
        double sum = 0;
        for (std::size_t c = 0; c < count(); ++c) {
          const double gap = position(cubic[c], h) - values_[i * count() + c];
          sum += gap * gap;
        }
        errors_[i] = std::sqrt(sum) / tolerance_;
        largest = std::max(largest, errors_[i]);
      }
      worst_[segment] = largest;
    }
  }

  bool is_window() const { return fixed_.first || fixed_.last; }

  /// Whether the largest error would come near 1 after `times` more steps, if each reduces it as the last one did.
  static bool may_suffice(double now, double before, int times) {
    constexpr double near = 0.1;
    const double factor = (now - 1) / (before - 1);
    double rest = now - 1;
    for (int i = 0; i < times && rest > near && factor < 1; ++i) rest *= factor;
    return rest <= near;
  }

  /// No positions and slopes have a largest error of at most 1, as the weighted mean of squares is larger.
  bool is_impossible() const {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      sum += weights_[i];
      squares += weights_[i] * errors_[i] * errors_[i];
    }
    return squares > sum;
  }

  /// More weight to samples that are far, compared with those around them.
  void weigh() {
    for (std::size_t segment = 0; segment + 1 < keys_.size(); ++segment) {
      double largest = worst_[segment];
      if (segment > 0) largest = std::max(largest, worst_[segment - 1]);
      if (segment + 2 < keys_.size()) largest = std::max(largest, worst_[segment + 1]);
      if (largest == 0) continue;
      for (std::size_t i = keys_[segment].sample - first_; i < keys_[segment + 1].sample - first_; ++i) {
        weights_[i] *= (errors_[i] + 0.02 * largest) / largest;
      }
    }
    weights_.back() *= (errors_.back() + 0.02) / std::max(worst_.back(), 1e-300);
    double largest = *std::ranges::max_element(weights_);
    for (double& w : weights_) w = std::max(w / largest, 1e-9);
  }

  const Recording& recording_;
  const std::vector<std::size_t>& channels_;
  double tolerance_;
  std::span<FitKey> keys_;
  FixedEnds fixed_;
  std::size_t first_;                     ///< sample
  double unit_;                           ///< of time
  std::vector<double> weights_, errors_;  ///< of each sample
  std::vector<double> worst_;             ///< the largest error of each segment
  std::vector<Hermite> hermite_;          ///< of each sample
  std::vector<double> values_;            ///< of each sample and channel
};

}  // namespace

std::vector<double> fit_smoothly(const Recording& recording, std::span<FitKey> keys, FixedEnds fixed,
                                 const FitEffort& effort) {
  std::vector<double> worst(keys.size() - 1);
  const auto fit = [&]<std::size_t channels>(const FitGroup& group, std::integral_constant<std::size_t, channels>) {
    GroupFit<channels>(recording, group, keys, fixed).run(effort, worst);
  };
  for (const FitGroup& group : recording.groups) {
    switch (group.channels.size()) {
      case 1: fit(group, std::integral_constant<std::size_t, 1>()); break;
      case 2: fit(group, std::integral_constant<std::size_t, 2>()); break;
      case 3: fit(group, std::integral_constant<std::size_t, 3>()); break;
      default: fit(group, std::integral_constant<std::size_t, 0>());
    }
  }
  return worst;
}

}  // namespace tcb
