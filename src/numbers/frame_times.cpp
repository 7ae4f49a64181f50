// Frame times: times of frames in seconds with the digits that doubles omit.
#include "numbers/frame_times.hpp"

#include <cmath>
#include <cstdint>

#include "numbers/decimal_time.hpp"

namespace tcb {
namespace {

constexpr std::int64_t parts_of_frame = 1000;
constexpr std::int64_t most = std::int64_t{1} << 40;  ///< so that a quotient of double-doubles has the nearest double

}  // namespace

FrameTimes::FrameTimes(const Rational& rate) {
  const Rational parts = rate * parts_of_frame;
  if (numerator(parts) > most || denominator(parts) > most) return;
  ticks_ = nearest_double(numerator(parts));
  seconds_ = nearest_double(denominator(parts));
}

Time FrameTimes::time_of(double number) const {
  if (number == 0) return {};
  const auto product = spline::two_product(number, seconds_);
  return Time(product.value, product.error) / Time(ticks_);
}

/// The number of the part of a frame to which a double is nearest.
std::optional<double> FrameTimes::number(const Time& time) const {
  if (time.lo != 0 || ticks_ == 0) return std::nullopt;
  const double near = time.hi * ticks_ / seconds_;
  if (!(std::abs(near) < 0x1p51)) return std::nullopt;
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  const double number = (near + round_to_whole) - round_to_whole;
  return time_of(number).hi == time.hi ? std::optional(number) : std::nullopt;
}

std::optional<Rational> FrameTimes::exact(const Time& time) const {
  const auto found = number(time);
  if (!found) return std::nullopt;
  return Rational(*found) * Rational(seconds_) / Rational(ticks_);
}

FrameTimes FrameTimes::from(const Time& origin) const {
  FrameTimes frames = *this;
  frames.origin_ = number(origin).value_or(0);
  return frames;
}

Time FrameTimes::elapsed(const Time& time) const {
  const auto found = number(time);
  return found ? time_of(*found - origin_) : time - time_of(origin_);
}

Time FrameTimes::time(const Time& elapsed) const { return as_double(elapsed + time_of(origin_)); }

}  // namespace tcb
