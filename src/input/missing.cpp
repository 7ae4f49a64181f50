// Missing cells: the table of the texts that programs and people write for them.
#include "input/missing.hpp"

#include <algorithm>

#include "input/columns.hpp"
#include "text/parse_number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Besides those of is_missing(). Sources: pandas, R, SQL, Excel and LibreOffice, printf of Microsoft's C library.
constexpr std::array<std::string_view, 44> common_signs{
    "n/a",          "n.a.",         "n.a",       "#n/a",   "#n/a n/a", "#na",       "<na>",
    "<n/a>",        "none",         "nil",       "nul",    "undef",    "undefined", "missing",
    "<missing>",    "<null>",       "(null)",    "[null]", "\\n",      "nat",       "+nan",
    "-nan",         "nan(ind)",     "-nan(ind)", "1.#ind", "-1.#ind",  "1.#qnan",   "-1.#qnan",
    "#null!",       "#div/0!",      "#value!",   "#ref!",  "#name?",   "#num!",     "-",
    "--",           "---",          "?",         "??",     ".",        "..",        "*",
    "\xE2\x80\x93", "\xE2\x80\x94",
};

}  // namespace

bool is_missing_sign(std::string_view cell, const std::vector<std::string>& more) {
  return is_missing(cell) || std::ranges::count(more, cell) > 0 ||
         std::ranges::any_of(common_signs, [&](std::string_view sign) { return same_in_any_case(cell, sign); });
}

}  // namespace tcb
