// Samples on a grid of times.
#include "sampling/by_time.hpp"

namespace tcb {

void ByTime::locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const {
  const spline::TimeMap<double> locate(piece.start, piece.end, piece.warp);
  set_coordinates(piece, first, last, located.coordinates);
  located.samples.resize(located.coordinates.size());
  for (std::size_t i = 0; i < located.samples.size(); ++i) {
    Sample& sample = located.samples[i];
    sample.t = located.coordinates[i];
    sample.at = locate(sample.t);
    sample.s.reset();
  }
}

}  // namespace tcb
