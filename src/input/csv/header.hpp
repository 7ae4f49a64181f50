// The beginning of delimited text: its header, and which column is what.
#pragma once

#include "input/csv/records.hpp"
#include "input/input.hpp"

namespace tcb {

/// What the beginning of a delimited input tells.
struct DelimitedHead {
  Dialect dialect;
  Columns columns;
  spline::Tcb<double> tcb = {};  ///< of keys that carry none
  char decimal = '.';
  Missing missing = Missing::error;
  bool keeps_decimals = false;
};

/// Dialect and columns, from the header if there is one and the first two records after it; what was read from the
/// first record of numbers on is left in `rest`. Throws: Error (data).
DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest);

}  // namespace tcb
