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

Error no_tracks() { return {Exit::data, "the file has no tracks; expected an object with keys"}; }

Error only_constant_tracks(const std::vector<std::string>& tracks) {
  return {Exit::data,
          fmt::format("no track has more than one key; expected one that changes; choose one of {} with {} to "
                      "read it all the same",
                      listed(tracks), option::only)};
}

Error no_such_track(std::string_view pattern, const std::vector<std::string>& tracks) {
  return Error(Exit::usage, fmt::format("no object or track is {}; expected one of {}; correct it, where * is any text "
                                        "and ? any character",
                                        in_quotes(pattern), listed(tracks)))
      .about(option::only);
}

Error file_without_tracks(std::string_view format) {
  return Error(Exit::usage,
               fmt::format("a file in the format {} has no tracks of several objects; expected a scene, such "
                           "as .lws; remove the option, or choose columns with {}",
                           format, option::columns))
      .about(option::only);
}

Error channel_without_key(std::string_view channel) {
  return {Exit::data,
          fmt::format("channel {} has no key at this time, where other channels have one; expected a key in "
                      "every channel; give {} skip-cell",
                      in_quotes(channel), option::missing)};
}

Error times_of_track_repeat(std::string_view time) {
  return {Exit::data, fmt::format("the key at {} seconds is not after the one before it; expected increasing times; "
                                  "correct the file",
                                  time)};
}

Error track_number_too_large(std::string_view number) {
  return {
      Exit::data,
      fmt::format("{} is beyond the range of doubles; expected less than 1.8e308 in size; correct the file", number)};
}

Error tracks_differ(std::string_view first, std::string_view other) {
  return Error(Exit::usage,
               fmt::format("{} has other channels than {}; expected tracks with the same channels; choose one "
                           "kind, such as */position",
                           in_quotes(other), in_quotes(first)))
      .about(option::only);
}

Error number_of_track_not_finite() {
  return {Exit::data, "a number of a key is infinite or no number; expected finite numbers; export the file again"};
}

Error chunk_too_short() {
  return {Exit::data,
          "a chunk of the file is longer or shorter than its content; expected a whole .3ds file; copy or export "
          "it again"};
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

Error not_an_ase() {
  return {Exit::data,
          fmt::format("the text is no ASCII export of 3ds Max; expected *3DSMAX_ASCIIEXPORT in its first line; "
                      "give another {}",
                      option::input_format)};
}

Error bezier_controller() {
  return {Exit::data,
          "the controller has Bezier keys, whose tangents have no documented unit; expected TCB or linear keys, or "
          "samples; change the controller in 3ds Max, or export samples"};
}

Error not_a_scene() {
  return {Exit::data,
          fmt::format("the text is no scene of LightWave; expected LWSC or LWMO in its first line; give another "
                      "{}",
                      option::input_format)};
}

Error file_ends_early() {
  return {Exit::data, "the file ends within an object; expected the rest; copy the file again"};
}

Error number_of_file_expected(std::string_view found) {
  return {Exit::data,
          fmt::format("{} is no number of a key or a rate; expected a number; correct the file", in_quotes(found))};
}

Error count_of_file_expected(std::string_view found) {
  return {Exit::data, fmt::format("{} is no count; expected a whole number; correct the file", in_quotes(found))};
}

Error scene_word_expected(std::string_view word, std::string_view found) {
  return {Exit::data, fmt::format("{} is here; expected {}, as in a motion of LightWave; correct the file",
                                  in_quotes(found), in_quotes(word))};
}

Error scene_key_count(std::size_t found, std::size_t expected) {
  return {Exit::data, fmt::format("there are {} keys or values; expected {}, the count above them; correct the file",
                                  found, expected)};
}

Error no_such_span(std::size_t number) {
  return {Exit::data,
          fmt::format("the span of the key is of type {}; expected 0 to 4 (TCB, Hermite, Bezier 1D, linear, "
                      "stepped), in version 2 no Hermite; correct the file",
                      number)};
}

Error bezier_2d_span() {
  return {Exit::data,
          "the span of the key is a Bezier 2D curve, which is no cubic in time; expected TCB, Hermite, Bezier "
          "1D, linear or stepped; change the key's curve in LightWave"};
}

Error step_too_short() {
  return {Exit::data,
          "the step to the key is shorter than doubles can distinguish; expected keys that are farther apart; "
          "remove one of them"};
}

Error no_provenance() {
  return {Exit::data, fmt::format("this file has no provenance; expected an output that was made with {}; give such a "
                                  "file",
                                  option::meta)};
}

}  // namespace tcb
