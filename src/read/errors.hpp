// Errors of times in words, in any format.
#pragma once

#include <string_view>

#include "error.hpp"

namespace tcb {

// Times in words. `column` is the name of the column or of the member of JSON.
Error no_such_time(std::string_view column, std::string_view time);
/// A time has two columns, of seconds and of nanoseconds.
Error time_parts_not_whole(std::string_view time);
Error time_in_other_notation(std::string_view column, std::string_view time);

}  // namespace tcb
