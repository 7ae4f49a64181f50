// Provenance in JSON: the member "meta" of an output.
#pragma once

#include <string_view>

#include "output/provenance.hpp"

namespace tcb {

/// The provenance in JSON, or in the last line of JSON Lines; empty where there is none.
Provenance read_json_meta(std::string_view text);

}  // namespace tcb
