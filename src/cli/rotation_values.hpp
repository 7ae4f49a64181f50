// Values of rotations: from the text of --rotation and --rotation-output to their values, or to an error.
#pragma once

#include <string>
#include <vector>

#include "read/input_options.hpp"

namespace tcb {

// Both throw Error (usage) for any other text; the caller makes it an error about the option.

/// FORM=COLUMN:... for each rotation, or none.
std::vector<GivenRotation> rotations(const std::string& text, bool& none);

/// quaternion, axis-angle, matrix or euler=ORDER.
spline::RotationNotation rotation_form(const std::string& text);

}  // namespace tcb
