// Look up: rows in any order on a kept curve, also outside it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sample/anywhere.hpp"
#include "sample/rows.hpp"
#include "sample/shown_curve.hpp"
#include "stream/source.hpp"

namespace tcb {

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
