// Anywhere: locators of rows in any order, at times that may be outside the curve, or at arc lengths.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "numbers/frame_times.hpp"
#include "sample/extrapolation.hpp"
#include "sample/sampler.hpp"

namespace tcb {

/// Samples at places in any order: rows 0 to size - 1, each at the place that a function gives. A curve with random
/// access is needed to find their segments.
class AnywhereLocator : public Locator {
 public:
  using Coordinate = std::function<Time(std::uint64_t)>;

  AnywhereLocator(Coordinate place, std::uint64_t size) : place_(std::move(place)), size_(size) {}

  std::uint64_t size() const { return size_; }
  Time place_of(std::uint64_t row) const { return place_(row); }

  /// The time on the curve, or the arc length, of a row. Throws: Error (usage) outside the curve.
  virtual Time on_curve(std::uint64_t row) const = 0;

 private:
  Coordinate place_;
  std::uint64_t size_;
};

/// Places are times, which may be outside the curve.
class AnywhereInTime : public AnywhereLocator {
 public:
  /// `frames`: where times are frames in seconds.
  AnywhereInTime(Coordinate place, std::uint64_t size, const Extrapolations& rules, const Time& first, const Time& last,
                 const std::optional<FrameTimes>& frames = {})
      : AnywhereLocator(std::move(place), size), rules_(rules), first_(first), last_(last), frames_(frames) {}

  Time on_curve(std::uint64_t row) const override;
  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override;

 private:
  Outside outside(const Time& t) const;

  Extrapolations rules_;
  Time first_, last_;
  std::optional<FrameTimes> frames_;
};

/// Places are arc lengths.
class AnywhereInLength : public AnywhereLocator {
 public:
  AnywhereInLength(Coordinate place, std::uint64_t size, double length)
      : AnywhereLocator(std::move(place), size), length_(length) {}

  Time on_curve(std::uint64_t row) const override;
  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override;

 private:
  double length_;
};

}  // namespace tcb
