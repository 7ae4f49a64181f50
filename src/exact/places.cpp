// Where rows are on a golden curve: at the times that they print, or at exact arc lengths.
#include "exact/places.hpp"

namespace tcb {

std::optional<ArcPlaces> arc_places(const SamplingRequest& request, const Extent& extent) {
  if (!by_length(request.mode)) return std::nullopt;
  ArcPlaces arc{request.places, 0, 0, 0, request.to};
  if (request.mode == Mode::arc_at) return arc;
  const Grid grid = spacing(request, extent).grid;
  arc.from = grid.start();
  arc.step = grid.step();
  const bool by_end = !request.to && needs_end(request) && grid.step() != 0;
  if (!by_end) return arc;
  const Rational steps = steps_between(arc.from, Rational(*extent.length), arc.step);
  arc.intervals = whole_number(numerator(steps));
  return arc;
}

}  // namespace tcb
