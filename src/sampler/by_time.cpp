// Samples on a grid of times.
#include "sampler/by_time.hpp"

namespace tcb::sampler {

void ByTime::locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  const spline::Locate<double> locate(piece.start, piece.end, piece.warp);
  fill(located, first, last, [&](std::uint64_t row) -> Sample {
    const Time t = coordinate(piece, row);
    return {t, locate(t)};
  });
}

}  // namespace tcb::sampler
