// Samples at times in any order, also outside the curve.
#include "sampler/anywhere.hpp"

#include "sampler/bounds.hpp"

namespace tcb::sampler {

Outside Anywhere::on_curve(std::uint64_t j) const {
  const Time t = time_(j);
  if (kind_ == Extrapolation::error) {
    require_not_before("the time", exact_time(t), first_key(first_));
    require_not_beyond("the time", exact_time(t), last_key(last_));
  }
  return map_to_curve(kind_, first_, last_, t);
}

Sample Anywhere::locate(const Piece& piece, std::uint64_t j) const {
  const Outside outside = on_curve(j);
  return {time_(j), spline::locate<double>(piece.start, piece.end, outside.t, piece.warp), {}, outside};
}

}  // namespace tcb::sampler
