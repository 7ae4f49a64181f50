// Places: the times or arc lengths of --at and --arc-at, as listed, in a file of numbers, or in a column of a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/typed_options.hpp"

namespace tcb {

/// Numbers, and ranges FIRST:LAST:STEP, separated by commas.
struct NumberedPlaces {
  std::vector<Rational> list;
  bool in_seconds = false;  ///< they have units of time, as in 30min
  bool are_dates = false;
};

/// Dates are read by the options for units. Throws: Error (usage); the caller adds the name of the option.
NumberedPlaces numbered_places(const std::string& text, const UnitOptions& units = {});

/// Stores the places of an option: numbers as above, or for @FILE and "-" those in a file or standard input. A column
/// of a file is only named. Throws: Error (usage); the caller adds the name of the option.
void store_places(TypedOptions& typed, std::string_view option, const std::string& text);

/// Reads the column of a file that an option names, if one does. Throws: Error.
void read_place_column(TypedOptions& typed);

}  // namespace tcb
