// Faults of an input: gathered until there are enough of them to be worth a person's while, then thrown as one.
#pragma once

#include "input/input.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// Keys without faults. Where there are any, the input is read on for more, up to ten, and to its end otherwise;
/// a live one, whose end may be far, only as far as it was read.
/// Throws: Error (data) with all that were found.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live);

/// Throws: Error (data) with all of them. Requires: one at least.
[[noreturn]] void refuse(std::vector<Error> faults);

}  // namespace tcb
