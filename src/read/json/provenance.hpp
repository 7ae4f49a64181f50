// Provenance in JSON: the member "meta" of an earlier output.
#pragma once

#include <string_view>

#include "read/earlier_output.hpp"

namespace tcb {

/// The member "meta" of JSON text, or of the last line of JSON Lines; empty if there is none.
EarlierOutput json_provenance(std::string_view text);

}  // namespace tcb
