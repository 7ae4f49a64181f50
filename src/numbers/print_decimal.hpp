// Printing decimals of more digits than doubles have: in full, or rounded.
#pragma once

#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"

namespace tcb {

/// Writes a long decimal at out, shortest, or rounded as printf's %.*f and %.*g would, and returns the end of the text.
/// Needs longest_number_in(notation) bytes at out.
char* write_decimal(LongDecimal decimal, const Notation& notation, char* out);

}  // namespace tcb
