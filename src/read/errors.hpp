// Errors of inputs in any format: what their bytes are, times that are not numbers, and earlier outputs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// The first bytes.
Error two_byte_order_marks();
Error blank_beginning();

// All bytes.
Error nul_in_text();

// Times in words. `column` is the name of the column or of the member of JSON.
Error no_such_time(std::string_view column, std::string_view time);
/// A time has two columns, of seconds and of nanoseconds.
Error time_parts_not_whole(std::string_view time);
Error time_in_other_notation(std::string_view column, std::string_view time);

// Formats that are not text.
Error options_of_text(std::string_view format);

// Files without tracks.
Error file_without_tracks(std::string_view format);

// Earlier outputs.
Error no_provenance();

}  // namespace tcb
