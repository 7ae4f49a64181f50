// How golden rows are asked for.
#pragma once

#include "text/notation.hpp"

namespace tcb {

struct GoldenOptions {
  bool decimal = false;  ///< a number of the input is the decimal that it is written as, not the double nearest to it
  Notation notation = {};
};

}  // namespace tcb
