// Samples on a grid of times.
#include "sampler/by_time.hpp"

namespace tcb::sampler {

void ByTime::locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  const spline::Locate<double> locate(piece.start, piece.end, piece.warp);
  const auto sample_at = [&](const Time& t) -> Sample { return {t, locate(t)}; };
  if (first >= Row::at_key) {
    fill(located, first, last, [&](std::uint64_t row) { return sample_at(coordinate(piece, row)); });
  } else {
    fill(located, first, last, [&](std::uint64_t row) { return sample_at(grid().time(row)); });
  }
}

}  // namespace tcb::sampler
