// How golden rows are asked for.
#pragma once

#include "format/notation.hpp"

namespace tcb::golden {

struct Options {
  bool decimal = false;  ///< a number of the input is the decimal that it is written as, not the double nearest to it
  format::Notation notation = {};
};

}  // namespace tcb::golden
