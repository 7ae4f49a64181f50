// Key times: at which samples of a recording keys lie, so that few are enough.
#include "fit/key_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace tcb {
namespace {

/// Slopes do not swing while segments are divided, as the keys of each group of segments are fitted between others.
constexpr FitEffort of_division{6, 0.05};

FitKey key_at(std::size_t sample, const Recording& recording) {
  return {sample, std::vector<double>(recording.channels), std::vector<double>(recording.channels)};
}

std::vector<FitKey> keys_at(const std::vector<std::size_t>& samples, const Recording& recording) {
  std::vector<FitKey> keys;
  keys.reserve(samples.size());
  for (const std::size_t sample : samples) keys.push_back(key_at(sample, recording));
  return keys;
}

/// Samples from the first to the last of `marks` that divide it into `count` parts with about the same mass, where each
/// step between two marks has a mass, spread evenly over its time.
std::vector<std::size_t> divided(const Recording& recording, std::span<const std::size_t> marks,
                                 std::span<const double> masses, std::size_t count) {
  double total = 0;
  for (const double mass : masses) total += mass;
  std::vector<std::size_t> samples{marks.front()};
  double before = 0;
  std::size_t step = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double wanted = total * static_cast<double>(i) / static_cast<double>(count);
    while (step + 1 < masses.size() && before + masses[step] < wanted) before += masses[step++];
    const double from = recording.times[marks[step]], to = recording.times[marks[step + 1]];
    const double time = from + (to - from) * (masses[step] > 0 ? (wanted - before) / masses[step] : 0.5);
    const auto after = std::ranges::lower_bound(recording.times, time);
    auto sample = static_cast<std::size_t>(after - recording.times.begin());
    if (sample > 0 &&
        (sample == recording.size() || recording.times[sample] - time > time - recording.times[sample - 1])) {
      --sample;
    }
    if (sample > samples.back() && sample < marks.back()) samples.push_back(sample);
  }
  samples.push_back(marks.back());
  return samples;
}

std::vector<std::size_t> samples_of(std::span<const FitKey> keys) {
  std::vector<std::size_t> samples;
  std::ranges::transform(keys, std::back_inserter(samples), &FitKey::sample);
  return samples;
}

/// Masses that move keys to where errors of the fourth power of a duration would be equal.
std::vector<double> masses_of(std::span<const double> worst) {
  std::vector<double> masses;
  for (const double error : worst) masses.push_back(std::sqrt(std::sqrt(std::max(error, 1e-4))));
  return masses;
}

/// Removes keys of segments where the others do.
class Thinning {
 public:
  Thinning(const Recording& recording, std::vector<FitKey>& keys, const std::vector<std::size_t>& fixed,
           const SamplesDone& done)
      : recording_(recording), keys_(keys), fixed_(fixed), done_(done) {}

  /// Tries to remove each key, with its neighbours fitted again where they are.
  void remove_keys() {
    constexpr std::size_t reach = 3;
    for (std::size_t key = 1; key + 1 < keys_.size();) {
      const std::size_t first = key - std::min(reach, key), last = std::min(key + reach, keys_.size() - 1);
      const bool is_fixed = std::ranges::binary_search(fixed_, keys_[key].sample);
      if (is_fixed || !remove(first, key, last)) count_before(++key);
    }
    end_pass();
  }

  /// Tries each window of so many segments with one less.
  void sweep(std::size_t segments) {
    for (std::size_t first = 0; first + 1 < keys_.size();) {
      const std::size_t last = std::min(first + segments, next_fixed(first));
      if (last - first > 1 && shorten(first, last)) continue;
      const bool at_fixed = last == next_fixed(first) && last - first <= segments;
      first =
          at_fixed && last - first <= (segments + 3) / 4 ? last : first + std::max<std::size_t>((segments + 3) / 4, 1);
      count_before(std::min(first, keys_.size() - 1));
    }
    end_pass();
  }

 private:
  static constexpr int most_moves = 3;

  void count_before(std::size_t key) {
    const std::size_t sample = keys_[key].sample;
    if (done_ && sample > counted_) done_(sample - counted_);
    counted_ = std::max(counted_, sample);
  }
  void end_pass() {
    count_before(keys_.size() - 1);
    counted_ = 0;
  }

  /// The first key after this one that has to stay.
  std::size_t next_fixed(std::size_t key) const {
    const auto sample = std::ranges::upper_bound(fixed_, keys_[key].sample);
    const auto found = std::ranges::lower_bound(keys_, *sample, {}, &FitKey::sample);
    return static_cast<std::size_t>(found - keys_.begin());
  }

  FixedEnds ends_of(std::size_t first, std::size_t last) const { return {first > 0, last + 1 < keys_.size()}; }

  /// Removes a key between two keys, if that is possible.
  bool remove(std::size_t first, std::size_t key, std::size_t last) {
    const auto at = [this](std::size_t index) { return keys_.begin() + static_cast<std::ptrdiff_t>(index); };
    std::vector<FitKey> keys(at(first), at(last + 1));
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(key - first));
    const std::vector<double> worst = fit_smoothly(recording_, keys, ends_of(first, last));
    if (*std::ranges::max_element(worst) > 1) return false;
    replace(first, last, std::move(keys));
    return true;
  }

  /// Replaces the keys between two keys by one less, if that is possible.
  bool shorten(std::size_t first, std::size_t last) {
    std::vector<std::size_t> marks = samples_of(std::span(keys_).subspan(first, last - first + 1));
    std::vector<double> masses(last - first, 1.0);
    double before = 4;
    for (int move = 0; move < most_moves; ++move) {
      marks = divided(recording_, marks, masses, last - first - 1);
      std::vector<FitKey> keys = keys_at(marks, recording_);
      keys.front() = keys_[first];
      keys.back() = keys_[last];
      const std::vector<double> worst = fit_smoothly(recording_, keys, ends_of(first, last));
      const double largest = *std::ranges::max_element(worst);
      if (largest <= 1) {
        replace(first, last, std::move(keys));
        return true;
      }
      if (largest > before * 0.9) break;
      before = std::min(largest, 2.0);
      masses = masses_of(worst);
    }
    return false;
  }

  void replace(std::size_t first, std::size_t last, std::vector<FitKey> keys) {
    const auto begin = keys_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = std::ranges::move(keys, begin).out;
    keys_.erase(end, keys_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }

  const Recording& recording_;
  std::vector<FitKey>& keys_;
  const std::vector<std::size_t>& fixed_;
  const SamplesDone& done_;
  std::size_t counted_ = 0;  ///< samples in this pass
};

/// The samples of keys between two fixed ones, half as many again as the longest cubics there.
void append_first_samples(std::vector<std::size_t>& samples, const Recording& recording,
                          const std::vector<std::size_t>& cubics, std::size_t first, std::size_t last) {
  std::vector<std::size_t> marks{first};
  for (const std::size_t cubic : cubics) {
    if (cubic > first && cubic < last) marks.push_back(cubic);
  }
  marks.push_back(last);
  const std::vector<double> masses(marks.size() - 1, 1.0);
  const auto divisions = divided(recording, marks, masses, masses.size() + masses.size() / 2);
  samples.insert(samples.end(), divisions.begin() + (samples.empty() ? 0 : 1), divisions.end());
}

}  // namespace

void divide_segments(const Recording& recording, std::vector<FitKey>& keys, std::vector<double> worst) {
  while (*std::ranges::max_element(worst) > 1) {
    std::vector<std::size_t> samples{keys.front().sample};
    for (std::size_t i = 0; i < worst.size(); ++i) {
      const std::size_t from = keys[i].sample, to = keys[i + 1].sample;
      // Where no sample is left between, the segments next to this one are divided.
      const bool is_far = worst[i] > 1 || (i > 0 && worst[i - 1] > 1 && keys[i].sample - keys[i - 1].sample == 1) ||
                          (i + 1 < worst.size() && worst[i + 1] > 1 && keys[i + 2].sample - to == 1);
      if (is_far && to - from > 1) samples.push_back(from + (to - from) / 2);
      samples.push_back(to);
    }
    if (samples.size() == keys.size()) return;
    keys = keys_at(samples, recording);
    worst = fit_smoothly(recording, keys, {}, of_division);
  }
}

std::vector<FitKey> fitting_keys(const Recording& recording, const std::vector<std::size_t>& cubics,
                                 const std::vector<std::size_t>& fixed, const SamplesDone& done) {
  std::vector<std::size_t> samples;
  for (std::size_t i = 1; i < fixed.size(); ++i) {
    append_first_samples(samples, recording, cubics, fixed[i - 1], fixed[i]);
  }
  std::vector<FitKey> keys = keys_at(samples, recording);
  divide_segments(recording, keys, fit_smoothly(recording, keys, {}, of_division));
  Thinning thinning(recording, keys, fixed, done);
  thinning.remove_keys();
  for (const std::size_t segments : std::array<std::size_t, 3>{4, 8, 16}) thinning.sweep(segments);
  thinning.remove_keys();
  return keys;
}

}  // namespace tcb
