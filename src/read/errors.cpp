// Errors of inputs in any format: what their bytes are, times that are not numbers, and earlier outputs.
#include "read/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
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

Error input_is_npy() {
  return {Exit::data, "this is a NumPy file; expected text; convert it, for example with numpy.savetxt"};
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

Error no_provenance() {
  return {Exit::data, fmt::format("this file has no provenance; expected an output that was made with {}; give such a "
                                  "file",
                                  option::meta)};
}

}  // namespace tcb
