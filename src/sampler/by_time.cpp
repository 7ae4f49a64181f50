// Samples on a grid of times.
#include "sampler/by_time.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "sampler/bounds.hpp"

namespace tcb::sampler {

ByTime::ByTime(Grid grid, std::optional<Time> to, std::uint64_t limit)
    : grid_(std::move(grid)), to_(to), limit_(limit) {}

Run ByTime::place(const Piece& piece) {
  if (next_ == 0) require_not_before("--from", grid_.start(), first_key(piece.start));
  if (piece.last) require_not_beyond("--from", grid_.start(), last_key(piece.end));
  if (piece.last && to_) require_not_beyond("--to", exact_time(*to_), last_key(piece.end));
  const bool cut = to_ && *to_ <= piece.end;
  const Time end = cut ? *to_ : piece.end;
  if (limit_ > 1) require_resolution(grid_, end);
  const Run run{next_, limit_ == 1 ? (grid_.time(0) <= end ? 1 : 0) : std::min(limit_, grid_.rows_through(end))};
  next_ = std::max(run.first, run.last);
  done_ = next_ == limit_ || (cut && !piece.last);
  return {run.first, next_};
}

Sample ByTime::locate(const Piece& piece, std::uint64_t j) const {
  const Time t = grid_.time(j);
  return {t, spline::locate<double>(piece.start, piece.end, t, piece.warp)};
}

}  // namespace tcb::sampler
