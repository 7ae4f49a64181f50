// Missing cells: their treatments, and the texts that are signs of them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

/// The treatment of cells without a value.
enum class Missing { error, skip_row, skip_cell, break_curve };

/// The names of the treatments.
struct MissingName {
  std::string_view name;
  Missing value;
};
inline constexpr std::array missing_names{
    MissingName{"error", Missing::error}, MissingName{"skip-row", Missing::skip_row},
    MissingName{"skip-cell", Missing::skip_cell}, MissingName{"break", Missing::break_curve}};

/// Whether a cell is a sign of a missing one: an empty cell, NA, nan, null, a common sign such as
/// N/A, None or "-" in upper or lower case, or one of `more`, exactly.
bool is_missing_sign(std::string_view cell, const std::vector<std::string>& more);

}  // namespace tcb
