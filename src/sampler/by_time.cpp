// Samples on a grid of times.
#include "sampler/by_time.hpp"

namespace tcb::sampler {

void ByTime::locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  const spline::Locate<double> locate(piece.start, piece.end, piece.warp);
  set_coordinates(piece, first, last, located.coordinates);
  located.samples.clear();
  for (const Time& t : located.coordinates) located.samples.push_back({t, locate(t)});
}

}  // namespace tcb::sampler
