// Pace: at which arc length of a curve a row is at its time, and how fast it moves there.
#include "sample/pace.hpp"

#include <algorithm>

namespace tcb {
namespace {

/// A ramp from speed 0 to 1 in the time 1, after the time w.
PacePart ramp(const Rational& w) {
  const Rational w2 = w * w, w3 = w2 * w;
  return {w3 - w3 * w / 2, 3 * w2 - 2 * w3, 6 * (w - w2)};
}

}  // namespace

PacePart Pace::at(const Rational& time) const {
  const Rational top = top_speed(), left = 1 - time;
  if (time < rise) {
    const PacePart part = ramp(time / rise);
    return {top * rise * part.distance, top * part.speed, top / rise * part.acceleration};
  }
  if (left < fall) {
    const PacePart part = ramp(left / fall);
    return {1 - top * fall * part.distance, top * part.speed, -top / fall * part.acceleration};
  }
  return {top * (time - rise / 2), top, 0};
}

PacePart Pace::at(const Rational& time, const Rational& first, const Rational& last) const {
  if (first == last) return {};  // of a single key
  const Rational duration = last - first;
  const PacePart part = at(std::clamp<Rational>((time - first) / duration, 0, 1));
  return {part.distance, part.speed / duration, part.acceleration / (duration * duration)};
}

}  // namespace tcb
