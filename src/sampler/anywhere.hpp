// Samples at times in any order, also outside the curve. The curve has to be kept to find them.
#pragma once

#include <cstdint>
#include <functional>

#include "sampler/sampler.hpp"

namespace tcb::sampler {

class Anywhere : public Locator {
 public:
  /// Rows 0 to size - 1 at the times that `time` gives, on a curve from `first` to `last`.
  Anywhere(std::function<Time(std::uint64_t)> time, std::uint64_t size, Extrapolation kind, const Time& first,
           const Time& last)
      : time_(std::move(time)), size_(size), kind_(kind), first_(first), last_(last) {}

  std::uint64_t size() const { return size_; }

  /// The time on the curve that stands for row j. Throws: Error (usage) outside where that is an error.
  Outside on_curve(std::uint64_t j) const;

  Sample locate(const Piece& piece, std::uint64_t j) const override;

 private:
  std::function<Time(std::uint64_t)> time_;
  std::uint64_t size_;
  Extrapolation kind_;
  Time first_, last_;
};

}  // namespace tcb::sampler
