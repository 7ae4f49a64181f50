// Samples on a grid of times.
#include "sampler/by_time.hpp"

namespace tcb::sampler {

Sample ByTime::locate(const Piece& piece, std::uint64_t row) const {
  const Time t = coordinate(piece, row);
  return {t, spline::locate<double>(piece.start, piece.end, t, piece.warp)};
}

}  // namespace tcb::sampler
