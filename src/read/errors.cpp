// Errors of inputs in any format: what their bytes are, times that are not numbers, and earlier outputs.
#include "read/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error compressed_input(std::string_view compression, std::string_view command) {
  return {Exit::data, fmt::format("the file is compressed with {}; expected text, or a file compressed with gzip or "
                                  "Zstandard; decompress it, as in {} FILE | tcbsample",
                                  compression, command)};
}

Error input_in_other_format(std::string_view format) {
  return {Exit::data,
          fmt::format("this is {}; expected text with a key in each row, or JSON; export the keys as CSV or "
                      "JSON",
                      format)};
}

Error table_in_other_format(std::string_view format, std::string_view function) {
  return {Exit::data,
          fmt::format("this is {}; expected text with a key in each row, or JSON; convert it, as in python3 -c 'import "
                      "pandas, sys; pandas.{}(sys.argv[1]).to_csv(sys.stdout, index=False)' FILE | tcbsample",
                      format, function)};
}

Error text_not_in_utf8(std::string_view encoding) {
  return {Exit::data,
          fmt::format("the text is in {}; expected UTF-8; convert it, for example with iconv -f {} -t UTF-8", encoding,
                      encoding)};
}

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

Error not_an_npy() {
  return {Exit::data, fmt::format("the file is no array of NumPy; expected one that numpy.save wrote; give another {}",
                                  option::input_format)};
}

Error npy_ends_early() {
  return {Exit::data, "the array ends early; expected as many rows as its header has; save it again"};
}

Error npy_header_unknown(std::string_view text) {
  return {Exit::data,
          fmt::format("the header of the array has {}; expected that of versions 1 to 3 of the format; save the "
                      "array again with numpy.save",
                      in_quotes(text))};
}

Error npy_column_not_a_number(std::string_view column, std::string_view type) {
  return {Exit::data, fmt::format("the array{} is of type {}; expected floats of 32 or 64 bits, integers or booleans; "
                                  "convert it, as with array.astype(float)",
                                  column.empty() ? "" : fmt::format(" has column {}, which", in_quotes(column)), type)};
}

Error npy_of_other_shape(std::size_t dimensions, bool is_structured) {
  return {Exit::data,
          fmt::format("the {}array has {} dimensions; expected {}; change its shape, as with numpy.column_stack",
                      is_structured ? "structured " : "", dimensions, is_structured ? "1" : "2, a row for each key")};
}

Error no_provenance() {
  return {Exit::data, fmt::format("this file has no provenance; expected an output that was made with {}; give such a "
                                  "file",
                                  option::meta)};
}

}  // namespace tcb
