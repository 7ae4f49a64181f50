// Errors of files: reading, decompressing, writing, and lists of inputs with their outputs.
#include "io/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"

namespace tcb {

Error cannot_open(std::string_view reason) { return {Exit::usage, fmt::format("cannot be opened: {}", reason)}; }

Error cannot_read(std::string_view reason) { return {Exit::usage, fmt::format("cannot be read: {}", reason)}; }

Error input_is_folder() {
  return {Exit::usage, fmt::format("this is a folder; expected a file; give {} and {} to process the files in it",
                                   option::recursive, option::output_dir)};
}

Error input_changed() {
  return {Exit::usage,
          "the file changed while it was read; expected a complete file; wait until it is written, or read what it "
          "holds so far through a pipe, as in cat FILE | tcbsample"};
}

Error compressed_data_damaged(std::string_view compression) {
  return {Exit::data,
          fmt::format("the {} data are damaged; expected a valid file; copy or create it again", compression)};
}

Error compressed_data_cut(std::string_view compression) {
  return {Exit::data,
          fmt::format("the {} data end too early; expected a complete file; copy or create it again", compression)};
}

Error zstandard_window_too_large() {
  return {Exit::data,
          "the Zstandard data need a window of more than 128 MiB of memory; expected at most 128 MiB; "
          "decompress the file with zstd -d --long=31 first"};
}

Error no_zstandard() {
  return {Exit::usage,
          "this build of the program has no Zstandard (.zst); expected gzip (.gz) or no compression; convert the input "
          "with zstd -d, or give the output another ending"};
}

Error cannot_write(std::string_view reason) { return {Exit::usage, fmt::format("cannot be written: {}", reason)}; }

Error cannot_create_folder(std::string_view reason) {
  return {Exit::usage, fmt::format("the folder cannot be created: {}", reason)};
}

Error cannot_create_temporary(std::string_view reason) {
  return {Exit::usage, fmt::format("this output needs a temporary file, which cannot be created: {}", reason)};
}

Error cannot_read_temporary(std::string_view reason) {
  return {Exit::usage, fmt::format("the temporary file of this output cannot be read back: {}", reason)};
}

Error nul_in_list() {
  return {Exit::usage, fmt::format("the list of files has a NUL byte; expected one name per line; give {} if the "
                                   "names end in NUL",
                                   option::null)};
}

Error empty_name_in_list() {
  return {Exit::usage,
          "the list of files has an empty name; expected a name before each NUL byte, as find -print0 "
          "prints them"};
}

Error long_name_in_list(std::size_t most) {
  return {Exit::usage,
          fmt::format("the list of files has a name of more than {} bytes; expected one name per line; give "
                      "{} if the names end in NUL",
                      most, option::null)};
}

Error empty_list() { return {Exit::usage, "the list of files has no names; expected one per line; add some"}; }

Error cannot_read_folder(std::string_view reason) {
  return {Exit::usage, fmt::format("the folder cannot be read: {}", reason)};
}

Error no_inputs_in_folders(std::uint64_t other_files, std::span<const std::string_view> endings) {
  if (other_files == 0) return {Exit::usage, "the folders hold no files; expected at least one; give other folders"};
  return {Exit::usage,
          fmt::format("the folders hold no input (other files: {}); expected names that end in one of {}; give {} to "
                      "take all files",
                      other_files, listed(endings), option::input_format)};
}

Error same_output(std::string_view output, std::string_view other_input) {
  return {Exit::usage, fmt::format("its output {} is also the output of {}; expected an output for each input; rename "
                                   "one of the inputs, or process them into different folders",
                                   output, other_input)};
}

Error output_is_input(std::string_view output) {
  return {Exit::usage, fmt::format("its output {} would replace an input; expected a different file; give another "
                                   "output",
                                   output)};
}

Error standard_input_without_name() {
  return {Exit::usage, fmt::format("standard input has no name, but {} names each output after its input; give {} "
                                   "instead",
                                   option::output_dir, option::output)};
}

}  // namespace tcb
