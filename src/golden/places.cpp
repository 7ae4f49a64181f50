// Where rows are on a golden curve: at the times that they print, or at exact arc lengths.
#include "golden/places.hpp"

namespace tcb::golden {

std::optional<ArcPlaces> arc_places(const sampler::Request& request, const sampler::Extent& extent) {
  if (!sampler::by_length(request.mode)) return std::nullopt;
  ArcPlaces arc{request.places, 0, 0, 0, request.to};
  if (request.mode == sampler::Mode::arc_at) return arc;
  const sampler::Grid grid = sampler::spacing(request, extent).grid;
  arc.from = grid.start();
  arc.step = grid.step();
  const bool by_end = !request.to && sampler::needs_end(request) && grid.step() != 0;
  if (!by_end) return arc;
  const Rational steps = sampler::steps_between(arc.from, Rational(*extent.length), arc.step);
  arc.intervals = static_cast<std::uint64_t>(numerator(steps));
  return arc;
}

}  // namespace tcb::golden
