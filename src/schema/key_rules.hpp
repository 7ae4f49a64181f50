// Key rules: how the cells of records become keys, and which are missing.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/parse_number.hpp"
#include "numbers/rational.hpp"
#include "tcb/spline/key.hpp"
#include "text/suggest.hpp"

namespace tcb {

/// The treatment of cells without a value.
enum class Missing { error, skip_row, skip_cell, break_curve };

inline constexpr auto missing_names = std::to_array<Named<Missing>>({{"error", Missing::error},
                                                                     {"skip-row", Missing::skip_row},
                                                                     {"skip-cell", Missing::skip_cell},
                                                                     {"break", Missing::break_curve}});

/// Besides those of is_missing(). Sources: pandas, R, SQL, Excel and LibreOffice, printf of Microsoft's C library,
/// Home Assistant, Praat.
inline constexpr std::array<std::string_view, 46> common_signs{
    "n/a",          "n.a.",   "n.a",     "#n/a",      "#n/a n/a", "#na",       "<na>",   "<n/a>",   "none",
    "nil",          "nul",    "undef",   "undefined", "missing",  "<missing>", "<null>", "(null)",  "[null]",
    "\\n",          "nat",    "+nan",    "-nan",      "nan(ind)", "-nan(ind)", "1.#ind", "-1.#ind", "1.#qnan",
    "-1.#qnan",     "#null!", "#div/0!", "#value!",   "#ref!",    "#name?",    "#num!",  "-",       "--undefined--",
    "unavailable",  "--",     "---",     "?",         "??",       ".",         "..",     "*",       "\xE2\x80\x93",
    "\xE2\x80\x94",
};

/// Whether a cell is one of these texts, or the number that one of them is.
inline bool is_one_of(std::string_view cell, const std::vector<std::string>& texts) {
  if (texts.empty()) return false;
  const std::optional<double> number = parse_number(cell);
  return std::ranges::any_of(
      texts, [&](const std::string& text) { return cell == text || (number && number == parse_number(text)); });
}

/// Whether a cell is a sign of a missing one: an empty cell, NA, nan, null, a common sign such as
/// N/A, None or "-" in upper or lower case, or one of `more`.
inline bool is_missing_sign(std::string_view cell, const std::vector<std::string>& more) {
  return is_missing(cell) || is_one_of(cell, more) ||
         std::ranges::any_of(common_signs, [&](std::string_view sign) { return same_in_any_case(cell, sign); });
}

/// Scales of tension, continuity and bias: as they are, or from 0 to 50 as 3ds Max shows them.
enum class TcbScale {
  unknown,  ///< as they are, and checked if the preset's product shows another scale
  none,     ///< as they are
  max3ds,   ///< from 0 to 50, with 25 for 0
};

/// Those that can be given.
inline constexpr auto tcb_scales =
    std::to_array<Named<TcbScale>>({{"3dsmax", TcbScale::max3ds}, {"none", TcbScale::none}});

/// (v - 25) / 25, exactly.
inline Rational from_0_to_50(const Rational& v) { return (v - 25) / 25; }

struct KeyRules {
  std::optional<spline::Tcb<double>> tcb = {};  ///< of keys that have none; nothing: that of the file, or 0
  Missing missing = Missing::error;
  bool counts_rows = false;                ///< rows without times that are skipped remain as gaps, as they count
  bool keeps_decimals = false;             ///< keys keep their numbers as written
  std::vector<std::string> signs = {};     ///< of missing cells, besides the common ones
  TcbScale tcb_scale = TcbScale::unknown;  ///< of the keys
};

}  // namespace tcb
