// Samples on a grid of arc lengths.
#include "sampler/by_length.hpp"

#include <cmath>

#include "spline/arc_length.hpp"

namespace tcb::sampler {

Time rounded_time(const Time& t) {
  constexpr double whole_from = 9007199254740992.0;  // 2^53
  if (std::abs(t.hi) < whole_from) return {t.hi};
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  return spline::Twice::normalized(t.hi, (t.lo + round_to_whole) - round_to_whole);
}

Sample at_length(const Piece& piece, const Time& s) {
  if (s <= Time(piece.s_start.hi)) return {piece.start, {0, -1}, s.hi};
  if (s >= Time(piece.s_end.hi)) return {piece.end, {1, 0}, s.hi};
  const double total = (piece.s_end - piece.s_start).hi;
  const spline::Speed<double> speed(piece.cubics, piece.metric);
  if (speed.is_constant()) {
    const spline::Twice h = piece.s_end - piece.s_start;
    const spline::Local<double> at{((s - piece.s_start) / h).hi, ((s - piece.s_end) / h).hi};
    return {rounded_time(piece.start + piece.warp.inverse(at.u) * (piece.end - piece.start)), at, s.hi};
  }
  const double u = spline::parameter_at(speed, (s - piece.s_start).hi, total);
  return {rounded_time(piece.start + piece.warp.inverse(u) * (piece.end - piece.start)), {u, u - 1}, s.hi};
}

}  // namespace tcb::sampler
