// Pace: at which arc length of a curve a row is at its time, and how fast it moves there.
#include "sample/pace.hpp"

#include <algorithm>
#include <type_traits>

#include "numbers/rational.hpp"

namespace tcb {

template <class S>
PacePart<S> Pace::at(const Rational& time, const Rational& first, const Rational& last) const {
  if (first == last) return {};  // of a single key
  const auto scalar = [](const Rational& number) {
    if constexpr (std::is_same_v<S, Time>) {
      const double high = nearest_double(number);
      return Time(high, nearest_double(number - Rational(high)));
    } else {
      return number;
    }
  };
  const Rational duration = last - first;
  const Rational passed = std::clamp<Rational>((time - first) / duration, 0, 1);
  PacePart<S> part = part_of_length<S>(scalar(passed), scalar(rise), scalar(fall));
  if (passed == 1) part.distance = S(1);  // also after rounding
  const S unit = scalar(duration);
  return {part.distance, part.speed / unit, part.acceleration / (unit * unit)};
}

template PacePart<Rational> Pace::at(const Rational& time, const Rational& first, const Rational& last) const;
template PacePart<Time> Pace::at(const Rational& time, const Rational& first, const Rational& last) const;

}  // namespace tcb
