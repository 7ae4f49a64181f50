// Places: the times or arc lengths of --at and --arc-at, as listed, in a file of numbers, or in a column of a file.
#pragma once

#include <string>
#include <string_view>

#include "cli/typed_options.hpp"

namespace tcb {

/// Stores the places of an option: numbers, dates, and ranges FIRST:LAST:STEP, separated by commas, or for @FILE and
/// "-" numbers in that file or standard input. A column of a file is only named. Throws: Error (usage); the caller adds
/// the name of the option.
void store_places(TypedOptions& typed, std::string_view option, const std::string& text);

/// Reads the column of a file that an option names, if one does. Throws: Error.
void read_place_column(TypedOptions& typed);

}  // namespace tcb
