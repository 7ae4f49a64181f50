// Samples on a grid of arc lengths.
#include "sampler/by_length.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sampler/bounds.hpp"
#include "spline/arc_length.hpp"

namespace tcb::sampler {
namespace {

/// A time worked out from a place on a segment, rounded once: to a double, or beyond 2^53 to a whole number.
Time rounded(const Time& t) {
  constexpr double whole_from = 9007199254740992.0;  // 2^53
  if (std::abs(t.hi) < whole_from) return {t.hi};
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  return spline::Twice::normalized(t.hi, (t.lo + round_to_whole) - round_to_whole);
}

}  // namespace

ByLength::ByLength(Grid grid, std::optional<double> to, std::uint64_t limit)
    : grid_(std::move(grid)), to_(to), limit_(limit) {}

Run ByLength::place(const Piece& piece) {
  if (next_ == 0) require_not_before("--from", grid_.start(), curve_start());
  if (piece.last) require_not_beyond("--from", grid_.start(), curve_length(piece.s_end.hi));
  if (piece.last && to_) require_not_beyond("--to", exact_time({*to_}), curve_length(piece.s_end.hi));
  const bool cut = to_ && *to_ <= piece.s_end.hi;
  const double end = cut ? *to_ : piece.s_end.hi;
  if (limit_ > 1 && end > 0) require_resolution(grid_, {end});
  const bool single = limit_ == 1 || grid_.step() == 0;
  const Run run{next_,
                single ? (grid_.time(0) <= Time(end) ? limit_ : 0) : std::min(limit_, grid_.rows_through({end}))};
  next_ = std::max(run.first, run.last);
  done_ = next_ == limit_ || (cut && !piece.last);
  return {run.first, next_};
}

Sample ByLength::locate(const Piece& piece, std::uint64_t j) const {
  const Time s = grid_.time(j);
  if (s >= Time(piece.s_end.hi)) return {piece.end, {1, 0}, s.hi};
  const double total = (piece.s_end - piece.s_start).hi;
  const double u =
      spline::parameter_at(spline::Speed<double>(piece.cubics, piece.metric), (s - piece.s_start).hi, total);
  return {rounded(piece.start + piece.warp.inverse(u) * (piece.end - piece.start)), {u, u - 1}, s.hi};
}

}  // namespace tcb::sampler
