// Smooth fits: positions and slopes of keys at given times, so that the largest distance from the samples is small.
//
// The curve between two keys is the cubic with their positions and slopes, so that the curve and its slope are
// continuous. Least squares give both, by a banded system; then samples that are far get more weight, and so on.
// Source: C. L. Lawson, "Contributions to the theory of linear least maximum approximation", 1961, for the weights.
#include "fit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "stream/ordered_map.hpp"
#include "tcb/spline/double_pair.hpp"

namespace tcb {

namespace {

// A matrix with few numbers beside its diagonal, and the solution of its linear system.

/// A symmetric positive definite matrix whose numbers are at most 3 columns from the diagonal.
class Banded {
 public:
  static constexpr std::size_t band = 4;

  explicit Banded(std::size_t size) : rows_(size) {}

  /// The number in a row and a column at or before it.
  double& at(std::size_t row, std::size_t column) { return rows_[row][row - column]; }

  void clear() { std::ranges::fill(rows_, std::array<double, band>{}); }

  /// Subtracts a variable of known value from one of `count` right-hand vectors, whose numbers alternate. remove()
  /// follows after the last one.
  void move_to_target(std::size_t variable, double value, std::span<double> targets, std::size_t number,
                      std::size_t count) {
    for (std::size_t other = first_near(variable); other < end_near(variable); ++other) {
      if (other == variable) continue;
      targets[other * count + number] -= at(std::max(variable, other), std::min(variable, other)) * value;
    }
    targets[variable * count + number] = value;
  }
  void remove(std::size_t variable) {
    for (std::size_t other = first_near(variable); other < end_near(variable); ++other) {
      at(std::max(variable, other), std::min(variable, other)) = other == variable ? 1 : 0;
    }
  }

  /// Cholesky's factors, in place, with the inverse of each number on the diagonal.
  void factor() {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::size_t column = first_near(row); column <= row; ++column) {
        double sum = at(row, column);
        for (std::size_t k = first_near(row); k < column; ++k) sum -= at(row, k) * at(column, k);
        at(row, column) = column < row ? sum * at(column, column) : 1 / std::sqrt(std::max(sum, 1e-300));
      }
    }
  }

  /// Solves for `count` right-hand vectors, whose numbers alternate, in place. Requires: factor().
  void solve(std::span<double> targets, std::size_t count) {
    const std::size_t size = rows_.size();
    const auto subtract = [&](std::size_t row, std::size_t other, double factor) {
      for (std::size_t c = 0; c < count; ++c) targets[row * count + c] -= factor * targets[other * count + c];
    };
    const auto scale = [&](std::size_t row) {
      for (std::size_t c = 0; c < count; ++c) targets[row * count + c] *= at(row, row);
    };
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t k = first_near(row); k < row; ++k) subtract(row, k, at(row, k));
      scale(row);
    }
    for (std::size_t row = size; row-- > 0;) {
      for (std::size_t k = row + 1; k < end_near(row); ++k) subtract(row, k, at(k, row));
      scale(row);
    }
  }

 private:
  /// The variables that have a number with another one.
  static std::size_t first_near(std::size_t variable) { return variable < band ? 0 : variable - band + 1; }
  std::size_t end_near(std::size_t variable) const { return std::min(variable + band, rows_.size()); }

  std::vector<std::array<double, band>> rows_;  ///< from the diagonal backward
};

/// The numbers of a cubic: the position and slope at its start and at its end; or the factors of powers of t, which
/// goes from -1 to 1.
using Four = std::array<double, 4>;

/// Four numbers as pairs, whose sums take half as long.
using Pairs = std::array<spline::DoublePair, 2>;
Four four(const Pairs& pairs) { return {pairs[0][0], pairs[0][1], pairs[1][0], pairs[1][1]}; }

/// The factors of powers of t of a cubic with these positions and slopes, these per half the duration.
Four powers_of(const Four& hermite) {
  const double sum = hermite[0] + hermite[2], step = hermite[2] - hermite[0];
  const double slopes = (hermite[1] + hermite[3]) / 4, bend = (hermite[1] - hermite[3]) / 4;
  return {sum / 2 + bend, 0.75 * step - slopes, -bend, slopes - 0.25 * step};
}

/// Weighted sums over the samples of a segment: of t^0 to t^3 and of t^3 to t^6.
struct Moments {
  Four low{}, high{};
};

/// The products of the Hermite polynomials, summed over the samples, of which those up to the diagonal count; slopes
/// are per half the duration.
std::array<Four, 4> hermite_products(const Moments& moments) {
  const auto& [one, t, t2, t3] = moments.low;
  const double t4 = moments.high[1], t5 = moments.high[2], t6 = moments.high[3];
  // The polynomials are 1/2 +- a for the positions, and b +- c for the slopes:
  // a = (t^3 - 3t) / 4, b = (t^3 - t) / 4, c = (1 - t^2) / 4.
  const double a = (t3 - 3 * t) / 4, b = (t3 - t) / 4, c = (one - t2) / 4;
  const double aa = (t6 - 6 * t4 + 9 * t2) / 16, bb = (t6 - 2 * t4 + t2) / 16, cc = (one - 2 * t2 + t4) / 16;
  const double ab = (t6 - 4 * t4 + 3 * t2) / 16, ac = (-t5 + 4 * t3 - 3 * t) / 16, bc = (-t5 + 2 * t3 - t) / 16;
  return {{
      {one / 4 + a + aa},
      {(b + c) / 2 + ab + ac, bb + 2 * bc + cc},
      {one / 4 - aa, (b + c) / 2 - ab - ac, one / 4 - a + aa},
      {(b - c) / 2 + ab - ac, bb - cc, (b - c) / 2 - ab + ac, bb - 2 * bc + cc},
  }};
}

/// The products of the Hermite polynomials and a value, summed over the samples; `sums`: those of the value with t^0 to
/// t^3.
Four hermite_targets(const Four& sums) {
  const double half = sums[0] / 2, a = (sums[3] - 3 * sums[1]) / 4;
  const double b = (sums[3] - sums[1]) / 4, c = (sums[0] - sums[2]) / 4;
  return {half + a, b + c, half - a, b - c};
}

/// Numbers of the channels of a group.
template <class T, std::size_t channels>
using PerChannel = std::conditional_t<channels == 0, std::vector<T>, std::array<T, channels>>;

/// The fit of the channels of one group. `channels`: how many there are, which makes the inner loops faster; 0: any
/// number. Points are those samples whose distance counts.
template <std::size_t channels>
class GroupFit {
 public:
  /// `step`: the points are the samples of keys, and of the others every so many.
  GroupFit(const Recording& recording, const FitGroup& group, std::span<FitKey> keys, FixedEnds fixed, std::size_t step,
           unsigned threads)
      : recording_(recording),
        channels_(group.channels),
        per_tolerance_(1 / group.tolerance),
        keys_(keys),
        fixed_(fixed),
        threads_(threads),
        unit_(elapsed(keys.front().sample, keys.back().sample) / static_cast<double>(keys.size() - 1)),
        worst_(keys.size() - 1),
        sums_(keys.size() - 1),
        matrix_(2 * keys.size()),
        targets_(2 * keys.size() * count()) {
    const std::size_t most = (keys.back().sample - keys.front().sample) / step + keys.size();
    places_.reserve(most);
    gaps_.reserve(most * count());
    begins_.reserve(keys.size());
    for (std::size_t segment = 0; segment < segments(); ++segment) {
      begins_.push_back(places_.size());
      const std::size_t from = keys[segment].sample, to = keys[segment + 1].sample;
      const double scale = 2 / elapsed(from, to);
      for (std::size_t i = from; i < to; i += step) add(i, elapsed(from, i) * scale - 1);
    }
    add(keys.back().sample, 1);
    begins_.push_back(places_.size());
    weights_.assign(places_.size(), 1.0);
    errors_.resize(places_.size());
  }

  /// Raises the largest distance of each segment to that of this group. Returns whether it is proved that no curve is
  /// within the tolerance.
  bool run(const FitEffort& effort, std::span<double> result) {
    // Where segments are long, few of their samples decide, and their weights need more steps.
    const bool has_long_segments = effort.gives_up && weights_.size() > 50 * segments();
    const int most = effort.most_weightings * (has_long_segments ? 2 : 1);
    double before = 0;
    bool proved = false;
    for (int i = 0;; ++i) {
      solve(effort.stiffness, i > 0);
      measure();
      const double largest = *std::ranges::max_element(worst_);
      if (largest <= 1 || i >= most) break;
      proved = effort.gives_up && is_impossible();
      if (proved) break;
      constexpr int interval = 3;
      if (effort.gives_up && i % interval == 0) {
        if (i > 0 && !may_suffice(largest, before, (most - i) / interval)) break;
        before = largest;
      }
      weigh();
    }
    for (std::size_t i = 0; i < segments(); ++i) result[i] = std::max(result[i], worst_[i]);
    return proved;
  }

 private:
  double elapsed(std::size_t from, std::size_t to) const { return recording_.times[to] - recording_.times[from]; }
  std::size_t segments() const { return keys_.size() - 1; }
  std::size_t count() const { return channels == 0 ? channels_.size() : channels; }

  template <class T>
  PerChannel<T, channels> per_channel() const {
    if constexpr (channels == 0) {
      return std::vector<T>(channels_.size());
    } else {
      return {};
    }
  }

  void add(std::size_t sample, double place) {
    places_.push_back(place);
    for (const std::size_t channel : channels_) gaps_.push_back(recording_.position(sample, channel));
  }

  /// Calls a function for each segment, on all threads if there are many points. Requires: it changes numbers of this
  /// segment only.
  template <class F>
  void for_each_segment(const F& f) {
    constexpr std::size_t many = 1 << 15;
    if (threads_ == 1 || weights_.size() < 2 * many) {
      for (std::size_t segment = 0; segment < segments(); ++segment) f(segment);
      return;
    }
    const std::size_t parts = weights_.size() / many;
    const auto first_of = [&](std::size_t part) { return segments() * part / parts; };
    for_each_number(parts, threads_, [&](std::size_t part) {
      for (std::size_t segment = first_of(part); segment < first_of(part + 1); ++segment) f(segment);
    });
  }

  /// Of the points of a segment: weighted sums, and the largest weight.
  struct Sums {
    Moments moments;
    PerChannel<Pairs, channels> gaps{};  ///< with t^0 to t^3
    double squares = 0;                  ///< of errors, after the cubics moved
    double largest_weight = 1;
  };

  /// The sums over the points of a segment.
  [[gnu::noinline]] void set_sums(std::size_t segment) {
    Pairs low{}, high{};
    auto gaps = per_channel<Pairs>();
    const double scale = weight_scale_;
    for (std::size_t i = begins_[segment], end = begins_[segment + 1]; i < end; ++i) {
      const double w = weights_[i] = std::max(weights_[i] * scale, 1e-9);
      const double t = places_[i], t2 = t * t, t3 = t2 * t;
      const Pairs part{spline::DoublePair(w, w * t), spline::DoublePair(w * t2, w * t3)};
      for (std::size_t k = 0; k < part.size(); ++k) {
        low[k] = low[k] + part[k];
        high[k] = high[k] + part[k] * t3;
      }
      for (std::size_t c = 0; c < count(); ++c) {
        for (std::size_t k = 0; k < part.size(); ++k) gaps[c][k] = gaps[c][k] + part[k] * gaps_[i * count() + c];
      }
    }
    sums_[segment].moments = {four(low), four(high)};
    sums_[segment].gaps = gaps;
  }

  /// The variables are positions and slopes, these per mean duration of a segment; or their `corrections`, which keep
  /// the digits that the squares of the equations lose, and are pulled to 0 instead of to plain slopes.
  void solve(double stiffness, bool corrections) {
    for_each_segment([this](std::size_t segment) { set_sums(segment); });
    matrix_.clear();
    std::ranges::fill(targets_, 0.0);
    for (std::size_t segment = 0; segment < segments(); ++segment) {
      const auto products = hermite_products(sums_[segment].moments);
      const Four scale = scale_of(segment);
      for (std::size_t j = 0; j < products.size(); ++j) {
        for (std::size_t k = 0; k <= j; ++k) {
          matrix_.at(2 * segment + j, 2 * segment + k) += products[j][k] * scale[j] * scale[k];
        }
      }
      for (std::size_t c = 0; c < count(); ++c) {
        const Four target = hermite_targets(four(sums_[segment].gaps[c]));
        for (std::size_t j = 0; j < target.size(); ++j) targets(2 * segment + j)[c] += target[j] * scale[j];
      }
    }
    keep_regular(stiffness, corrections);
    fix_ends(corrections);
    matrix_.factor();
    matrix_.solve(targets_, count());
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      for (std::size_t c = 0; c < count(); ++c) {
        double &position = keys_[key].position[channels_[c]], &slope = keys_[key].slope[channels_[c]];
        position = (corrections ? position : 0) + targets(2 * key)[c];
        slope = (corrections ? slope : 0) + targets(2 * key + 1)[c] / unit_;
      }
    }
  }

  /// The factors from variables to the positions and slopes of Hermite polynomials of t.
  Four scale_of(std::size_t segment) const {
    const double scale = elapsed(keys_[segment].sample, keys_[segment + 1].sample) / (2 * unit_);
    return {1, scale, 1, scale};
  }

  /// The right-hand numbers of a variable, one for each channel.
  std::span<double> targets(std::size_t variable) { return std::span(targets_).subspan(variable * count(), count()); }

  /// Pulls each key a little to its sample, and to a slope between those to the samples next to it, so that no slopes
  /// swing where samples do not determine them.
  void keep_regular(double stiffness, bool corrections) {
    double total = 0;
    for (const Sums& sums : sums_) total += sums.moments.low[0];
    const double strength = stiffness * total / static_cast<double>(weights_.size());
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      const std::size_t sample = keys_[key].sample;
      matrix_.at(2 * key, 2 * key) += strength * 1e-3;
      matrix_.at(2 * key + 1, 2 * key + 1) += strength;
      for (std::size_t c = 0; c < count() && !corrections; ++c) {
        targets(2 * key)[c] += strength * 1e-3 * recording_.position(sample, channels_[c]);
        targets(2 * key + 1)[c] += strength * plain_slope(sample, channels_[c]) * unit_;
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

  void fix_ends(bool corrections) {
    const auto fix = [&](std::size_t variable, const auto& value) {
      for (std::size_t c = 0; c < count(); ++c) {
        matrix_.move_to_target(variable, corrections ? 0 : value(channels_[c]), targets_, c, count());
      }
      matrix_.remove(variable);
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

  /// Moves the cubics of a segment by the variables.
  void measure() {
    for_each_segment([this](std::size_t segment) { move_cubics(segment); });
  }
  void move_cubics(std::size_t segment) {
    const Four scale = scale_of(segment);
    auto cubics = per_channel<Four>();
    for (std::size_t c = 0; c < count(); ++c) {
      Four hermite;
      for (std::size_t j = 0; j < hermite.size(); ++j) hermite[j] = targets(2 * segment + j)[c] * scale[j];
      cubics[c] = powers_of(hermite);
    }
    const double per_tolerance = per_tolerance_;
    double largest = 0, squares = 0;
    for (std::size_t i = begins_[segment], end = begins_[segment + 1]; i < end; ++i) {
      const double t = places_[i];
      double sum = 0;
      for (std::size_t c = 0; c < count(); ++c) {
        const Four& a = cubics[c];
        double& gap = gaps_[i * count() + c];
        gap -= a[0] + t * (a[1] + t * (a[2] + t * a[3]));
        sum += gap * gap;
      }
      errors_[i] = std::sqrt(sum) * per_tolerance;
      largest = std::max(largest, errors_[i]);
      squares += weights_[i] * errors_[i] * errors_[i];
    }
    worst_[segment] = largest;
    sums_[segment].squares = squares;
  }

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
    double weights = 0, squares = 0;
    for (const Sums& sums : sums_) {
      weights += sums.moments.low[0];
      squares += sums.squares;
    }
    return squares > weights;
  }

  /// More weight to points that are far, compared with those around them.
  void weigh() {
    for_each_segment([this](std::size_t segment) {
      double worst = worst_[segment];
      if (segment > 0) worst = std::max(worst, worst_[segment - 1]);
      if (segment + 1 < segments()) worst = std::max(worst, worst_[segment + 1]);
      const double factor = worst > 0 ? 1 / worst : 0, least = worst > 0 ? 0.02 : 1;
      double largest = 0;
      for (std::size_t i = begins_[segment]; i < begins_[segment + 1]; ++i) {
        weights_[i] *= errors_[i] * factor + least;
        largest = std::max(largest, weights_[i]);
      }
      sums_[segment].largest_weight = largest;
    });
    double largest = 0;
    for (const Sums& sums : sums_) largest = std::max(largest, sums.largest_weight);
    weight_scale_ = 1 / largest;
  }

  const Recording& recording_;
  const std::vector<std::size_t>& channels_;
  double per_tolerance_;
  std::span<FitKey> keys_;
  FixedEnds fixed_;
  unsigned threads_;
  double unit_;                                    ///< of time
  double weight_scale_ = 1;                        ///< by which weights are multiplied next, so that the largest is 1
  std::vector<std::size_t> begins_;                ///< of each segment, its first point, and the end of the last one
  std::vector<double> places_, weights_, errors_;  ///< of each point; places: t in its segment
  std::vector<double> gaps_;                       ///< of each point and channel, from the curve to the sample
  std::vector<double> worst_;                      ///< the largest error of each segment
  std::vector<Sums> sums_;                         ///< of each segment
  Banded matrix_;
  std::vector<double> targets_;
};

}  // namespace

std::vector<double> fit_smoothly(const Recording& recording, std::span<FitKey> keys, FixedEnds fixed,
                                 const FitEffort& effort, unsigned threads) {
  std::vector<double> worst;
  const auto fit = [&](std::size_t step) {
    worst.assign(keys.size() - 1, 0);
    bool proved = false;
    const auto fit_group = [&]<std::size_t channels>(const FitGroup& group,
                                                     std::integral_constant<std::size_t, channels>) {
      if (GroupFit<channels>(recording, group, keys, fixed, step, threads).run(effort, worst)) proved = true;
    };
    for (const FitGroup& group : recording.groups) {
      switch (group.channels.size()) {
        case 1: fit_group(group, std::integral_constant<std::size_t, 1>()); break;
        case 2: fit_group(group, std::integral_constant<std::size_t, 2>()); break;
        case 3: fit_group(group, std::integral_constant<std::size_t, 3>()); break;
        default: fit_group(group, std::integral_constant<std::size_t, 0>());
      }
    }
    return proved;
  };
  // Where no curve is near enough, some samples of each segment mostly show it.
  constexpr std::size_t some = 8;
  const std::size_t step = (keys.back().sample - keys.front().sample) / (some * (keys.size() - 1));
  if (effort.gives_up && step > 1 && fit(step)) return worst;
  fit(1);
  return worst;
}

}  // namespace tcb
