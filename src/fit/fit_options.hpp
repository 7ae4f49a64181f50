// Fit options: within which limits recordings are fitted, and what the keys carry.
#pragma once

#include <optional>
#include <vector>

#include "numbers/rational.hpp"
#include "run/job.hpp"

namespace tcb {

enum class FitKeys;  // in fit/fit.hpp

/// How recordings are fitted.
struct FitOptions {
  std::vector<Tolerance> tolerances;
  std::optional<double> angle;       ///< of rotations from the samples, in radians; nothing: they are not fitted
  FitKeys keys = {};                 ///< nothing given: tension, continuity and bias
  std::optional<double> corner;      ///< in degrees: where the samples turn by more, the curve may have a corner
  std::vector<Rational> kept_times;  ///< of samples that become keys in any case
  GroupedPlaces grouped_kept_times;  ///< instead of kept_times, if groups have their own
};

}  // namespace tcb
