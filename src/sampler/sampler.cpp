// From a request and what is known of the curve to the sampler that answers it.
#include "sampler/sampler.hpp"

#include "sampler/by_length.hpp"
#include "sampler/by_time.hpp"
#include "sampler/per_segment.hpp"

namespace tcb::sampler {

std::unique_ptr<Sampler> make_sampler(const Request& request, const Extent& extent) {
  if (request.mode == Mode::per_segment) return std::make_unique<PerSegment>(request);
  if (by_length(request.mode)) return std::make_unique<ByLength>(request, spacing(request, extent));
  return std::make_unique<ByTime>(request, spacing(request, extent));
}

}  // namespace tcb::sampler
