// Key times: at which samples of a recording keys lie, so that few are enough.
//
// Keys begin a little denser than the longest cubics need them, and move to where the errors of all segments are alike.
// Segments that stay too far from their samples are divided; then each group of segments is tried with one less. Parts
// of long recordings are tried on several threads, and then the segments around the keys between parts. Short
// recordings are tried in several ways, and as long as that finds fewer keys.
#include "fit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "stream/ordered_map.hpp"
#include "stream/source.hpp"

namespace tcb {

namespace {

/// Keys at samples, whose positions and slopes are 0.
std::vector<FitKey> keys_at(const std::vector<std::size_t>& samples, const Recording& recording) {
  std::vector<FitKey> keys;
  keys.reserve(samples.size());
  const std::vector<double> zeros(recording.channels);
  for (const std::size_t sample : samples) keys.push_back({sample, zeros, zeros});
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

/// Keys with a gap where the last ones were replaced, so that the next replacement there moves few of the others.
class KeyList {
 public:
  explicit KeyList(std::vector<FitKey> keys) : before_(std::move(keys)) {}

  std::size_t size() const { return before_.size() + after_.size(); }
  const FitKey& operator[](std::size_t i) const { return i < before_.size() ? before_[i] : after_[size() - 1 - i]; }

  std::vector<FitKey> range(std::size_t first, std::size_t last) const {
    std::vector<FitKey> keys;
    for (std::size_t i = first; i < last; ++i) keys.push_back((*this)[i]);
    return keys;
  }

  /// The number of the first key that is not before a sample.
  std::size_t at_sample(std::size_t sample) const {
    std::size_t first = 0, last = size();
    while (first < last) {
      const std::size_t middle = first + (last - first) / 2;
      if ((*this)[middle].sample < sample) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    return first;
  }

  void replace(std::size_t first, std::size_t last, std::vector<FitKey> keys) {
    const auto move_last = [](std::vector<FitKey>& from, std::vector<FitKey>& onto) {
      onto.push_back(std::move(from.back()));
      from.pop_back();
    };
    while (before_.size() > last) move_last(before_, after_);
    while (before_.size() < last) move_last(after_, before_);
    before_.resize(first);
    std::ranges::move(keys, std::back_inserter(before_));
  }

 private:
  std::vector<FitKey> before_, after_;  ///< after the gap the last key is the first one
};

/// While segments are divided: few iterations, and enough stiffness to keep slopes from oscillating.
constexpr FitEffort of_division{6, 0.05, false};
/// With as little stiffness as the last fits, to see whether that is enough.
constexpr FitEffort of_trial{2, 1e-6, false};

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

/// How many segments the windows have that are tried with one less, one sweep after another.
using Sweeps = std::array<std::size_t, 3>;
constexpr Sweeps wider_sweeps{4, 8, 16}, narrower_sweeps{16, 8, 4};

/// Removes keys that the tolerances do not need.
class Thinning {
 public:
  /// `fixed`: among them the first and the last key. `ends`: which of these keep their positions and slopes.
  Thinning(const Recording& recording, std::vector<FitKey> keys, std::vector<std::size_t> fixed, const Sweeps& sweeps,
           const SamplesDone& done, FixedEnds ends = {})
      : recording_(recording),
        keys_(std::move(keys)),
        fixed_(std::move(fixed)),
        sweeps_(sweeps),
        done_(done),
        ends_(ends) {}

  std::vector<FitKey> keys() const { return keys_.range(0, keys_.size()); }

  /// All steps, on the keys at samples [from, to].
  void thin(std::size_t from, std::size_t to) {
    remove_keys(from, to);
    for (const std::size_t segments : sweeps_) sweep(segments, from, to);
    remove_keys(from, to);
  }
  void thin() { thin(keys_[0].sample, keys_[keys_.size() - 1].sample); }

  /// All steps, on the keys near a sample.
  void thin_around(std::size_t sample) {
    constexpr std::size_t reach = 20;  // keys
    const std::size_t key = keys_.at_sample(sample);
    thin(keys_[key - std::min(reach, key)].sample, keys_[std::min(key + reach, keys_.size() - 1)].sample);
  }

 private:
  static constexpr int most_moves = 4;

  /// Tries to remove each key, with its neighbours fitted again where they are.
  void remove_keys(std::size_t from, std::size_t to) {
    constexpr std::size_t reach = 3;
    for (std::size_t key = std::max<std::size_t>(keys_.at_sample(from), 1);
         key + 1 < keys_.size() && keys_[key].sample <= to;) {
      const std::size_t first = key - std::min(reach, key), last = std::min(key + reach, keys_.size() - 1);
      const bool is_fixed = std::ranges::binary_search(fixed_, keys_[key].sample);
      if (is_fixed || !remove(first, key, last)) ++key;
    }
    end_pass();
  }

  /// Tries each window of so many segments with one less.
  void sweep(std::size_t segments, std::size_t from, std::size_t to) {
    for (std::size_t first = keys_.at_sample(from); first + 1 < keys_.size() && keys_[first].sample < to;) {
      const std::size_t last = std::min(first + segments, next_fixed(first));
      if (last - first > 1 && shorten(first, last)) continue;
      const bool at_fixed = last == next_fixed(first) && last - first <= segments;
      first =
          at_fixed && last - first <= (segments + 3) / 4 ? last : first + std::max<std::size_t>((segments + 3) / 4, 1);
    }
    end_pass();
  }

  void end_pass() {
    if (done_) done_(keys_[keys_.size() - 1].sample - keys_[0].sample);
  }

  /// The first key after this one that has to stay.
  std::size_t next_fixed(std::size_t key) const {
    return keys_.at_sample(*std::ranges::upper_bound(fixed_, keys_[key].sample));
  }

  FixedEnds ends_of(std::size_t first, std::size_t last) const {
    return {first > 0 || ends_.first, last + 1 < keys_.size() || ends_.last};
  }

  /// Removes a key between two keys, if that is possible.
  bool remove(std::size_t first, std::size_t key, std::size_t last) {
    std::vector<FitKey> keys = keys_.range(first, last + 1);
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(key - first));
    const std::vector<double> worst = fit_smoothly(recording_, keys, ends_of(first, last));
    if (*std::ranges::max_element(worst) > 1) return false;
    keys_.replace(first, last + 1, std::move(keys));
    return true;
  }

  /// Replaces the keys between two keys by one less, if that is possible.
  bool shorten(std::size_t first, std::size_t last) {
    std::vector<std::size_t> marks = samples_of(keys_.range(first, last + 1));
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
        keys_.replace(first, last + 1, std::move(keys));
        return true;
      }
      if (largest > before * 0.9) break;
      before = std::min(largest, 2.0);
      masses = masses_of(worst);
    }
    return false;
  }

  const Recording& recording_;
  KeyList keys_;
  const std::vector<std::size_t> fixed_;
  const Sweeps& sweeps_;
  const SamplesDone& done_;
  const FixedEnds ends_;
};

/// The samples of keys between fixed ones, half as many again as the longest cubics there, and evenly spread.
std::vector<std::size_t> spread_samples(const Recording& recording, const FirstTimes& times,
                                        const std::vector<std::size_t>& fixed) {
  std::vector<std::size_t> samples{fixed.front()};
  for (std::size_t i = 1; i < fixed.size(); ++i) {
    const auto first = std::ranges::upper_bound(times.cubics, fixed[i - 1]);
    const auto last = std::ranges::lower_bound(first, times.cubics.end(), fixed[i]);
    std::vector<std::size_t> marks{fixed[i - 1]};
    marks.insert(marks.end(), first, last);
    marks.push_back(fixed[i]);
    const std::vector<double> masses(marks.size() - 1, 1.0);
    const auto divisions = divided(recording, marks, masses, masses.size() + masses.size() / 2);
    samples.insert(samples.end(), divisions.begin() + 1, divisions.end());
  }
  return samples;
}

std::vector<std::size_t> union_of(std::vector<std::size_t> samples, const std::vector<std::size_t>& others) {
  samples.insert(samples.end(), others.begin(), others.end());
  std::ranges::sort(samples);
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  return samples;
}

/// The samples of keys at knots, if they suffice; otherwise at both sides of each, and in the middle between two knots.
std::vector<std::size_t> samples_at_knots(const Recording& recording, const FirstTimes& times,
                                          const std::vector<std::size_t>& fixed, unsigned threads) {
  std::vector<std::size_t> plain = union_of(fixed, times.knots);
  std::vector<FitKey> keys = keys_at(plain, recording);
  const std::vector<double> worst = fit_smoothly(recording, keys, {}, of_trial, threads);
  if (*std::ranges::max_element(worst) <= 1) return plain;
  std::vector<std::size_t> after, samples;
  for (const std::size_t knot : times.knots) after.push_back(std::min(knot + 1, recording.size() - 1));
  for (const std::size_t end : union_of(plain, after)) {
    if (!samples.empty() && end - samples.back() > 1) samples.push_back(samples.back() + (end - samples.back()) / 2);
    samples.push_back(end);
  }
  return samples;
}

/// Fits keys with the stiffness of division, unless more segments are within the tolerances with less.
std::vector<double> fit_for_division(const Recording& recording, std::vector<FitKey>& keys, FixedEnds ends,
                                     unsigned threads = 1) {
  const auto failures = [](const std::vector<double>& worst) {
    return std::ranges::count_if(worst, [](double error) { return !(error <= 1); });
  };
  std::vector<FitKey> loose = keys;
  std::vector<double> of_loose = fit_smoothly(recording, loose, ends, of_trial, threads);
  if (failures(of_loose) > 0) {
    std::vector<double> worst = fit_smoothly(recording, keys, ends, of_division, threads);
    if (failures(worst) <= failures(of_loose)) return worst;
  }
  keys = std::move(loose);
  return of_loose;
}

/// Keys with the segments divided that are beyond the tolerances. `worst`: the largest error of each segment.
std::vector<FitKey> with_divisions(const Recording& recording, const std::vector<FitKey>& keys,
                                   std::span<const double> worst) {
  std::vector<std::size_t> samples{keys.front().sample};
  for (std::size_t i = 0; i < worst.size(); ++i) {
    const std::size_t from = keys[i].sample, to = keys[i + 1].sample;
    // Where no sample is left between, the segments next to this one are divided.
    const bool is_far = worst[i] > 1 || (i > 0 && worst[i - 1] > 1 && keys[i].sample - keys[i - 1].sample == 1) ||
                        (i + 1 < worst.size() && worst[i + 1] > 1 && keys[i + 2].sample - to == 1);
    if (is_far && to - from > 1) samples.push_back(from + (to - from) / 2);
    samples.push_back(to);
  }
  std::vector<FitKey> divided = keys_at(samples, recording);
  divided.front() = keys.front();
  divided.back() = keys.back();
  return divided;
}

/// The keys between which the parts of a recording are divided and thinned: about every so many samples, the first and
/// the last one.
std::vector<std::size_t> ends_of_parts(const std::vector<FitKey>& keys) {
  constexpr std::size_t samples_of_part = 50'000;
  std::vector<std::size_t> ends{0};
  for (std::size_t key = 1; key + 1 < keys.size(); ++key) {
    const bool is_far = keys[key].sample - keys[ends.back()].sample >= samples_of_part;
    if (is_far && keys.back().sample - keys[key].sample >= samples_of_part / 2) ends.push_back(key);
  }
  ends.push_back(keys.size() - 1);
  return ends;
}

/// Calls a function for each part of a recording, with its keys and which of its ends stay, on several threads. Returns
/// the keys of all parts.
template <class F>
std::vector<FitKey> in_parts(const std::vector<FitKey>& keys, const std::vector<std::size_t>& ends, unsigned threads,
                             const F& f) {
  const auto call = [&](std::size_t part) {
    const auto at = [&](std::size_t end) { return keys.begin() + static_cast<std::ptrdiff_t>(ends[end]); };
    return f(std::vector<FitKey>(at(part), at(part + 1) + 1), FixedEnds{part > 0, part + 2 < ends.size()});
  };
  const auto parts = ordered_map(numbers_to(ends.size() - 1), call, threads);
  std::vector<FitKey> joined;
  while (std::optional<std::vector<FitKey>> part = parts()) {
    std::ranges::move(part->begin() + (joined.empty() ? 0 : 1), part->end(), std::back_inserter(joined));
  }
  return joined;
}

/// Keys at samples, between which segments are divided until all are within the tolerances.
std::vector<FitKey> divided_keys(const Recording& recording, const std::vector<std::size_t>& samples,
                                 unsigned threads) {
  std::vector<FitKey> all = keys_at(samples, recording);
  const std::vector<double> worst_of_all = fit_for_division(recording, all, {}, threads);
  const auto divide = [&](std::vector<FitKey> keys, FixedEnds ends) {
    const auto first = std::ranges::lower_bound(all, keys.front().sample, {}, &FitKey::sample) - all.begin();
    std::vector<double> worst(worst_of_all.begin() + first, worst_of_all.begin() + first + std::ssize(keys) - 1);
    while (*std::ranges::max_element(worst) > 1) {
      std::vector<FitKey> divided = with_divisions(recording, keys, worst);
      if (divided.size() == keys.size()) break;
      keys = std::move(divided);
      worst = fit_for_division(recording, keys, ends);
    }
    return keys;
  };
  return in_parts(all, ends_of_parts(all), threads, divide);
}

/// Removes keys, and moves the others, until no more are found that the tolerances do not need.
std::vector<FitKey> thinned(const Recording& recording, const std::vector<FitKey>& keys,
                            const std::vector<std::size_t>& fixed, const Sweeps& sweeps, const SamplesDone& done,
                            unsigned threads) {
  const std::vector<std::size_t> ends = ends_of_parts(keys);
  std::mutex mutex;
  const SamplesDone counted = [&](std::size_t samples) {
    const std::lock_guard lock(mutex);
    if (done) done(samples);
  };
  const auto thin = [&](std::vector<FitKey> part, FixedEnds ends_of_part) {
    const std::size_t from = part.front().sample, to = part.back().sample;
    std::vector<std::size_t> own_fixed{from, to};
    std::ranges::copy_if(fixed, std::back_inserter(own_fixed),
                         [&](std::size_t sample) { return sample >= from && sample <= to; });
    Thinning thinning(recording, std::move(part), union_of(std::move(own_fixed), {}), sweeps, counted, ends_of_part);
    thinning.thin();
    return thinning.keys();
  };
  const SamplesDone none;
  Thinning between(recording, in_parts(keys, ends, threads, thin), fixed, sweeps, none);
  for (std::size_t end = 1; end + 1 < ends.size(); ++end) between.thin_around(keys[ends[end]].sample);
  return between.keys();
}

/// The fewest keys that several tries find: from two beginnings, with sweeps in either order, and until nothing is
/// found any more.
std::vector<FitKey> thinned_best(const Recording& recording, const std::array<std::vector<FitKey>, 2>& beginnings,
                                 const std::vector<std::size_t>& fixed, const SamplesDone& done, unsigned threads) {
  const auto thin = [&](std::size_t number) {
    return thinned(recording, beginnings[number % 2], fixed, number < 2 ? wider_sweeps : narrower_sweeps,
                   number == 0 ? done : SamplesDone{}, 1);
  };
  constexpr std::size_t tries = 4;
  const auto results = ordered_map(numbers_to(tries), thin, threads);
  std::vector<FitKey> best = *results();
  while (std::optional<std::vector<FitKey>> keys = results()) {
    if (keys->size() < best.size()) best = *std::move(keys);
  }
  for (std::size_t before = 0; before != best.size();) {
    before = best.size();
    best = thinned(recording, best, fixed, wider_sweeps, {}, threads);
  }
  return best;
}

}  // namespace

std::vector<FitKey> fitting_keys(const Recording& recording, const FirstTimes& times,
                                 const std::vector<std::size_t>& fixed, const SamplesDone& done, unsigned threads) {
  std::vector<FitKey> keys = divided_keys(recording, spread_samples(recording, times, fixed), threads);
  std::vector<FitKey> others = divided_keys(recording, samples_at_knots(recording, times, fixed, threads), threads);
  if (others.size() < keys.size()) std::swap(keys, others);
  constexpr std::size_t many_samples = 50'000;
  if (recording.size() > many_samples) return thinned(recording, keys, fixed, wider_sweeps, done, threads);
  return thinned_best(recording, {keys, others}, fixed, done, threads);
}

}  // namespace tcb
