// Limits: which maxima are asked for, and what they may be at most.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numbers/rational.hpp"

namespace tcb {

/// A measure by its name, such as speed or velocity_x, and its limits, if it has any.
struct Limit {
  std::string name;
  std::optional<Rational> least, most;  ///< of a number; only `most`, and no `least`: of its size
};

/// What --limits and --retime ask for.
struct LimitOptions {
  std::vector<Limit> limits;  ///< none: all maxima, without limits
  bool fits = false;          ///< with --retime: times may become shorter
};

}  // namespace tcb
