// Pace profiles: files of keys whose curve tells where rows are on another one.
#pragma once

#include <memory>
#include <string>

#include "run/key_options.hpp"
#include "sample/pace.hpp"
#include "sample/request.hpp"

namespace tcb {

struct PaceFile {
  std::string path;
  std::string column = {};  ///< with the distances; empty: the one called s or fraction
};

/// The rows of a request on the curve of a profile, which follows the rules of the keys without overshoot. Throws:
/// Error.
std::shared_ptr<const PaceProfile> read_pace_profile(const PaceFile& file, const SamplingRequest& request,
                                                     const KeyOptions& keys);

}  // namespace tcb
