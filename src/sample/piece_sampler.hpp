// Pieces: a row for each segment, or for the part of it that lies in the range of the request.
#pragma once

#include <memory>

#include "sample/sampler.hpp"

namespace tcb {

/// A row for each segment, or for the piece of it that lies in the range of the request.
std::unique_ptr<Sampler> make_piece_sampler(const SamplingRequest& request);

}  // namespace tcb
