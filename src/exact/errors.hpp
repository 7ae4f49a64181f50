// Errors of exact rows: one function for each fault.
#pragma once

#include <string_view>

#include "error.hpp"

namespace tcb {

/// A number of a key has more digits than exact reading takes.
Error decimal_too_long();

/// A number of a row was not found to the requested digits.
Error row_needs_more_digits(std::string_view time);

}  // namespace tcb
