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

LengthToSample::LengthToSample(const Piece& piece, const spline::ArcLength<double>& arc)
    : piece_(piece), duration_(piece.end - piece.start), inverse_(arc, piece.s_end - piece.s_start) {}

Sample LengthToSample::operator()(const Time& s) {
  // A length that is printed as that of a key is the key's.
  if (s <= Time(piece_.s_start.hi)) return {piece_.start, {0, -1}, s.hi};
  if (s >= Time(piece_.s_end.hi)) return {piece_.end, {1, 0}, s.hi};
  const spline::Local<double> at = inverse_.at(s - piece_.s_start);
  if (at.u == 0) return {piece_.start, at, s.hi};
  if (at.w == 0) return {piece_.end, at, s.hi};
  return {rounded_time(piece_.start + piece_.warp.inverse(at) * duration_), at, s.hi};
}

void ByLength::locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  located.arc.assign(piece.cubics, piece.metric);
  LengthToSample sample(piece, located.arc);
  fill(located, first, last, [&](std::uint64_t row) -> Sample {
    const Time s = coordinate(piece, row);
    return row == Row::at_key ? Sample{piece.start, {0, -1}, s.hi} : sample(s);
  });
}

}  // namespace tcb::sampler
