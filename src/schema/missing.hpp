// Missing cells: their treatments, and the texts that are signs of them.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/parse_number.hpp"
#include "text/suggest.hpp"

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

/// Besides those of is_missing(). Sources: pandas, R, SQL, Excel and LibreOffice, printf of Microsoft's C library.
inline constexpr std::array<std::string_view, 44> common_signs{
    "n/a",          "n.a.",         "n.a",       "#n/a",   "#n/a n/a", "#na",       "<na>",
    "<n/a>",        "none",         "nil",       "nul",    "undef",    "undefined", "missing",
    "<missing>",    "<null>",       "(null)",    "[null]", "\\n",      "nat",       "+nan",
    "-nan",         "nan(ind)",     "-nan(ind)", "1.#ind", "-1.#ind",  "1.#qnan",   "-1.#qnan",
    "#null!",       "#div/0!",      "#value!",   "#ref!",  "#name?",   "#num!",     "-",
    "--",           "---",          "?",         "??",     ".",        "..",        "*",
    "\xE2\x80\x93", "\xE2\x80\x94",
};

/// Whether a cell is a sign of a missing one: an empty cell, NA, nan, null, a common sign such as
/// N/A, None or "-" in upper or lower case, or one of `more`, exactly.
inline bool is_missing_sign(std::string_view cell, const std::vector<std::string>& more) {
  return is_missing(cell) || std::ranges::count(more, cell) > 0 ||
         std::ranges::any_of(common_signs, [&](std::string_view sign) { return same_in_any_case(cell, sign); });
}

}  // namespace tcb
