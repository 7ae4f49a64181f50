// Samples on a grid of arc lengths.
#include "sampling/by_length.hpp"

#include <cmath>
#include <cstddef>

#include "tcb/spline/arc_inverse.hpp"

namespace tcb {

Time rounded_time(const Time& t) {
  constexpr double whole_from = 9007199254740992.0;  // 2^53
  if (std::abs(t.hi) < whole_from) return {t.hi};
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  return spline::DoubleDouble::normalized(t.hi, (t.lo + round_to_whole) - round_to_whole);
}

namespace {

/// The sample where a piece has an arc length. A length that is printed as that of a key is the key's.
Sample sample_at(const CurveSegment& piece, const Time& duration, const Time& s,
                 const spline::LocalParameter<double>& at) {
  if (s <= Time(piece.s_start.hi) || at.u == 0) return {piece.start, {0, -1}, s.hi};
  if (s >= Time(piece.s_end.hi) || at.w == 0) return {piece.end, {1, 0}, s.hi};
  if (!piece.warp.is_identity()) return {rounded_time(piece.start + piece.warp.inverse(at) * duration), at, s.hi};
  return {rounded_time(at.near_start() ? piece.start + duration * at.u : piece.end + duration * at.w), at, s.hi};
}

}  // namespace

void locate_lengths(const CurveSegment& piece, Located& located) {
  located.arc.assign(piece.cubics, piece.metric);
  located.places.resize(located.coordinates.size());
  spline::ArcInverse<double>(located.arc, piece.s_start, piece.s_end).at(located.coordinates, located.places);
  const Time duration = piece.end - piece.start;
  located.samples.clear();
  for (std::size_t i = 0; i < located.coordinates.size(); ++i) {
    located.samples.push_back(sample_at(piece, duration, located.coordinates[i], located.places[i]));
  }
}

void ByLength::locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  set_coordinates(piece, first, last, located.coordinates);
  locate_lengths(piece, located);
}

}  // namespace tcb
