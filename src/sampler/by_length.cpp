// Samples on a grid of arc lengths.
#include "sampler/by_length.hpp"

#include <cmath>

namespace tcb::sampler {

Time rounded_time(const Time& t) {
  constexpr double whole_from = 9007199254740992.0;  // 2^53
  if (std::abs(t.hi) < whole_from) return {t.hi};
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  return spline::Twice::normalized(t.hi, (t.lo + round_to_whole) - round_to_whole);
}

Sample at_length(const Piece& piece, spline::ArcInverse<double>& inverse, const Time& s) {
  // A length that is printed as that of a key is the key's.
  if (s <= Time(piece.s_start.hi)) return {piece.start, {0, -1}, s.hi};
  if (s >= Time(piece.s_end.hi)) return {piece.end, {1, 0}, s.hi};
  const spline::Local<double> at = inverse.at(s - piece.s_start, piece.s_end - s);
  if (at.u == 0) return {piece.start, at, s.hi};
  if (at.w == 0) return {piece.end, at, s.hi};
  return {rounded_time(piece.start + piece.warp.inverse(at) * (piece.end - piece.start)), at, s.hi};
}

void ByLength::locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  located.arc.assign(piece.cubics, piece.metric);
  spline::ArcInverse<double> inverse(located.arc);
  fill(located, first, last, [&](std::uint64_t row) -> Sample {
    const Time s = coordinate(piece, row);
    if (row == Row::at_key) return {piece.start, {0, -1}, s.hi};
    return at_length(piece, inverse, s);
  });
}

}  // namespace tcb::sampler
