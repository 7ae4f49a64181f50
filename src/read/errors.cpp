// Errors of inputs in any format: what their bytes are, times that are not numbers, and earlier outputs.
#include "read/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error two_byte_order_marks() {
  return {Exit::data, "the text begins with two byte order marks; expected at most one; remove one"};
}

Error blank_beginning() {
  return {
      Exit::data,
      "the first 64 MiB are blank; expected keys; remove the blank lines, or check whether the file is the right one"};
}

Error nul_in_text() {
  return {Exit::data,
          "this is a NUL byte; expected text in UTF-8; convert the input, for example with iconv -f UTF-16 -t UTF-8"};
}

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

Error options_of_text(std::string_view format) {
  return Error(Exit::usage,
               fmt::format("{}, {}, {}, {}, {} and {} have no effect on an input in the format {}; remove them",
                           option::delimiter, option::header, option::no_header, option::comment, option::decimal,
                           option::thousands, format));
}

Error file_without_tracks(std::string_view format) {
  return Error(Exit::usage,
               fmt::format("a file in the format {} has no tracks of several objects; expected a scene, such "
                           "as .lws; remove the option, or choose columns with {}",
                           format, option::columns))
      .about(option::only);
}

Error no_provenance() {
  return {Exit::data, fmt::format("this file has no provenance; expected an output that was made with {}; give such a "
                                  "file",
                                  option::meta)};
}

}  // namespace tcb
