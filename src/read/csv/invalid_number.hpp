// Invalid numbers: why a cell of delimited text is not a number.
#pragma once

#include <string_view>

#include "error.hpp"
#include "numbers/parse_number.hpp"

namespace tcb {

/// The number of a cell is too large for a double.
Error number_beyond_doubles(std::string_view column, std::string_view cell);

/// Whether a text is a number with marks between thousands, such as 1,234.5, 1.234,5 or 1 234.
bool has_thousands_separators(std::string_view text);

/// A number without the unit after it, as in 2.35 m; any other text as it is.
std::string_view without_unit_of_number(std::string_view cell);

/// Why a cell of a column is not a number, which was expected. `marks` are those of the input.
/// Requires: it is not a sign of a missing number.
Error why_not_number(std::string_view column, std::string_view cell, const NumberMarks& marks);

}  // namespace tcb
