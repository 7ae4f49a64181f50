// NumPy's files, version 1.0: a head of fixed size, and the rows as doubles, the lowest byte first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/layout.hpp"

namespace tcb {

/// The head of an array of doubles, rows x columns in C order. Promises: as long for any number of rows.
/// Source: NumPy, "numpy.lib.format", version 1.0 of the format.
std::string npy_head(std::size_t columns, std::uint64_t rows);

/// Rows behind such a head, which says no rows until it is known how many there are.
Layout npy_layout(const std::vector<OutputColumn>& columns);

}  // namespace tcb
