// Errors of times in words, in any format.
#include "read/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error no_such_time(std::string_view column, std::string_view time) {
  return {Exit::data, fmt::format("{}: the time {} does not exist; expected a date of the calendar, a time of day "
                                  "without leap seconds, and a frame number that is below the frame rate and is not "
                                  "dropped; correct it",
                                  column, in_quotes(time))};
}

Error time_parts_not_whole(std::string_view time) {
  return {Exit::data,
          fmt::format("{}: the two columns of the time are not whole seconds and nanoseconds; expected whole "
                      "numbers, of nanoseconds from 0 to 999999999; correct the cells, or give {} time=NAME",
                      time, option::columns)};
}

Error time_in_other_notation(std::string_view column, std::string_view time) {
  return {Exit::data,
          fmt::format("{}: {} is not in the notation of the first time; expected all times in one notation; "
                      "convert it",
                      column, in_quotes(time))};
}

}  // namespace tcb
