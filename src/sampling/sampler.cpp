// From a request and what is known of the curve to the sampler that answers it.
#include "sampling/sampler.hpp"

#include "sampling/by_length.hpp"
#include "sampling/by_time.hpp"
#include "sampling/per_segment.hpp"

namespace tcb {

std::unique_ptr<Sampler> make_sampler(const SamplingRequest& request, const Extent& extent) {
  if (request.mode == Mode::per_segment) return std::make_unique<PerSegment>(request);
  if (by_length(request.mode)) return std::make_unique<ByLength>(request, spacing(request, extent));
  return std::make_unique<ByTime>(request, spacing(request, extent));
}

}  // namespace tcb
