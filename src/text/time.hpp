// Times: numbers of twice the precision of doubles, which hold nanoseconds since 1970 exactly.
#pragma once

#include "tcb/spline/scalar.hpp"

namespace tcb {

using Time = spline::Time<double>;

}  // namespace tcb
