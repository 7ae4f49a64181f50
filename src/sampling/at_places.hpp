// Samples at times or arc lengths in any order, times also outside the curve. The curve has to be kept to find them.
#pragma once

#include <cstdint>
#include <functional>

#include "sampling/sampler.hpp"

namespace tcb {

/// Rows 0 to size - 1, each at a place that `place` gives.
class Anywhere : public Locator {
 public:
  using Place = std::function<Time(std::uint64_t)>;

  Anywhere(Place place, std::uint64_t size) : place_(std::move(place)), size_(size) {}

  std::uint64_t size() const { return size_; }
  Time place(std::uint64_t row) const { return place_(row); }

  /// Where to look for a row: a time on the curve, or an arc length. Throws: Error (usage) outside the curve.
  virtual Time on_curve(std::uint64_t row) const = 0;

 private:
  Place place_;
  std::uint64_t size_;
};

/// Places are times.
class AnywhereInTime : public Anywhere {
 public:
  AnywhereInTime(Place place, std::uint64_t size, Extrapolation kind, const Time& first, const Time& last)
      : Anywhere(std::move(place), size), kind_(kind), first_(first), last_(last) {}

  Time on_curve(std::uint64_t row) const override;
  void locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;

 private:
  Extrapolation kind_;
  Time first_, last_;
};

/// Places are arc lengths.
class AnywhereInLength : public Anywhere {
 public:
  AnywhereInLength(Place place, std::uint64_t size, double length)
      : Anywhere(std::move(place), size), length_(length) {}

  Time on_curve(std::uint64_t row) const override;
  void locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;

 private:
  double length_;
};

}  // namespace tcb
