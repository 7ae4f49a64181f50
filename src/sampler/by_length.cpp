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

Sample at_length(const Piece& piece, const spline::ArcInverse<double>& arc, const Time& s) {
  const spline::Local<double> at = arc.at(s - piece.s_start, piece.s_end - s);
  if (at.u == 0) return {piece.start, at, s.hi};
  if (at.w == 0) return {piece.end, at, s.hi};
  return {rounded_time(piece.start + piece.warp.inverse(at) * (piece.end - piece.start)), at, s.hi};
}

Sample ByLength::locate(const Piece& piece, std::uint64_t row) const { return locate(piece, row, row + 1).front(); }

std::vector<Sample> ByLength::locate(const Piece& piece, std::uint64_t first, std::uint64_t last) const {
  const spline::ArcLength<double> arc(piece.cubics, piece.metric);
  const spline::ArcInverse<double> inverse(arc, nearest_time(grid().step()).hi);
  std::vector<Sample> samples;
  samples.reserve(last - first);
  for (std::uint64_t row = first; row != last; ++row) {
    const Time s = coordinate(piece, row);
    if (row == Row::at_key) {
      samples.push_back({piece.start, {0, -1}, s.hi});
    } else if (row == Row::at_end && s >= Time(piece.s_end.hi)) {
      samples.push_back({piece.end, {1, 0}, s.hi});
    } else {
      samples.push_back(at_length(piece, inverse, s));
    }
  }
  return samples;
}

}  // namespace tcb::sampler
