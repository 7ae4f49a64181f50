// Key lists: keys that are being fitted, and samples for them.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "fit/recording.hpp"
#include "fit/smooth_fit.hpp"

namespace tcb {

/// Keys at samples, whose positions and slopes are 0.
std::vector<FitKey> keys_at(const std::vector<std::size_t>& samples, const Recording& recording);

/// Samples from the first to the last of `marks` that divide it into `count` parts with about the same mass, where each
/// step between two marks has a mass, spread evenly over its time.
std::vector<std::size_t> divided(const Recording& recording, std::span<const std::size_t> marks,
                                 std::span<const double> masses, std::size_t count);

/// Keys with a gap where the last ones were replaced, so that the next replacement there moves few of the others.
class KeyList {
 public:
  explicit KeyList(std::vector<FitKey> keys) : before_(std::move(keys)) {}

  std::size_t size() const { return before_.size() + after_.size(); }
  const FitKey& operator[](std::size_t i) const { return i < before_.size() ? before_[i] : after_[size() - 1 - i]; }
  /// Keys [first, last).
  std::vector<FitKey> range(std::size_t first, std::size_t last) const;

  /// The number of the first key that is not before a sample.
  std::size_t at_sample(std::size_t sample) const;

  /// Replaces keys [first, last).
  void replace(std::size_t first, std::size_t last, std::vector<FitKey> keys);

  /// All keys.
  std::vector<FitKey> take() &&;

 private:
  void move_gap(std::size_t to);

  std::vector<FitKey> before_, after_;  ///< after the gap the last key is the first one
};

}  // namespace tcb
