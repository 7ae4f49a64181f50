// Curve labels: the column that distinguishes the curves of keys whose times do not increase.
#pragma once

#include <string>
#include <vector>

#include "schema/columns.hpp"
#include "schema/key_block.hpp"

namespace tcb {

/// The columns that may distinguish curves.
struct CurveLabels {
  std::vector<Mark> marks = {};            ///< of keys
  std::vector<std::string> channels = {};  ///< names of channels, if they have any; only those of whole numbers count

  /// The name of a column such that times increase within each of its values, if they do not increase overall; empty:
  /// there is none. `texts`: only columns of text.
  std::string distinguishing(const KeyBlock& block, bool texts) const;
};

}  // namespace tcb
