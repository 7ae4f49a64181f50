// Anywhere: rows in any order on a kept curve, at times that may be outside it, or at arc lengths.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "numbers/frame_times.hpp"
#include "sample/extrapolation.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "sample/shown_curve.hpp"
#include "stream/source.hpp"

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

/// Adds the times of keys in [from, to], and drops a time that is closer to a key than a billionth of the first step.
/// T: Time or Rational.
template <class T>
std::vector<T> with_keys(const std::vector<T>& times, std::span<const T> keys, const T& from, const T& to,
                         const T& billionth) {
  const T near = times.size() > 1 ? (times[1] - times[0]) * billionth : T(0.0);
  std::vector<T> merged;
  std::size_t next = 0;
  for (const T& key : keys) {
    if (key < from - near || key > to + near) continue;
    for (; next < times.size() && times[next] < key - near; ++next) merged.push_back(times[next]);
    while (next < times.size() && times[next] <= key + near) ++next;
    merged.push_back(key);
  }
  merged.insert(merged.end(), times.begin() + static_cast<std::ptrdiff_t>(next), times.end());
  return merged;
}

/// The rows of a locator in order, in blocks. `side`: of a key, the segment on which a row there is.
Source<SampleBlock> look_up(const std::shared_ptr<const ShownCurve>& curve,
                            const std::shared_ptr<const AnywhereInTime>& rows, spline::Side side);
Source<SampleBlock> look_up(const std::shared_ptr<const ShownCurve>& curve,
                            const std::shared_ptr<const AnywhereInLength>& rows, spline::Side side);

}  // namespace tcb
