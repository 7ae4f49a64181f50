// Key lists: keys that are being fitted, and samples for them.
#include "fit/key_list.hpp"

#include <algorithm>
#include <iterator>

namespace tcb {

std::vector<FitKey> keys_at(const std::vector<std::size_t>& samples, const Recording& recording) {
  std::vector<FitKey> keys;
  keys.reserve(samples.size());
  const std::vector<double> zeros(recording.channels);
  for (const std::size_t sample : samples) keys.push_back({sample, zeros, zeros});
  return keys;
}

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

std::vector<FitKey> KeyList::range(std::size_t first, std::size_t last) const {
  std::vector<FitKey> keys;
  for (std::size_t i = first; i < last; ++i) keys.push_back((*this)[i]);
  return keys;
}

std::size_t KeyList::at_sample(std::size_t sample) const {
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

void KeyList::replace(std::size_t first, std::size_t last, std::vector<FitKey> keys) {
  move_gap(last);
  before_.resize(first);
  std::ranges::move(keys, std::back_inserter(before_));
}

std::vector<FitKey> KeyList::take() && {
  move_gap(size());
  return std::move(before_);
}

void KeyList::move_gap(std::size_t to) {
  const auto move_last = [](std::vector<FitKey>& from, std::vector<FitKey>& onto) {
    onto.push_back(std::move(from.back()));
    from.pop_back();
  };
  while (before_.size() > to) move_last(before_, after_);
  while (before_.size() < to) move_last(after_, before_);
}

}  // namespace tcb
