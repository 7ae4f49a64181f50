// The checks that a request fits the curve, each with its message.
#pragma once

#include <string_view>

#include "sampler/grid.hpp"

namespace tcb::sampler {

/// Throws: Error (usage) where `value`, given with `option`, lies before `bound`, which is `what`.
void require_not_before(std::string_view option, std::string_view what, const Rational& value, const Rational& bound);

/// Throws: Error (usage) where `value`, given with `option`, lies beyond `bound`, which is `what`.
void require_not_beyond(std::string_view option, std::string_view what, const Rational& value, const Rational& bound);

/// Throws: Error (usage) where neighbouring rows of the grid would be the same double at `end`.
void require_resolution(const Grid& grid, const Time& end);

}  // namespace tcb::sampler
