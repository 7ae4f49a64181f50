// The checks that a request fits the curve, each with its message.
#pragma once

#include <string>
#include <string_view>

#include "sampling/grid.hpp"

namespace tcb {

/// A rational as a person reads it: the nearest double, shortest.
std::string text(const Rational& value);

/// An end of the curve, in time or in arc length.
struct Bound {
  std::string_view what;
  Rational value;
  std::string_view remedy;  ///< for a request that lies outside
};

Bound first_key(const Time& time);
Bound last_key(const Time& time);
Bound curve_start();
Bound curve_length(double length);

/// Throws: Error (usage) where `value`, given with `option`, lies before the bound.
void require_not_before(std::string_view option, const Rational& value, const Bound& bound);

/// Throws: Error (usage) where `value`, given with `option`, lies beyond the bound.
void require_not_beyond(std::string_view option, const Rational& value, const Bound& bound);

/// Throws: Error (usage) where neighbouring rows of the grid would be the same double at `end`.
void require_resolution(const Grid& grid, const Time& end);

}  // namespace tcb
