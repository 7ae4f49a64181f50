// Formats: the list of all of them, with their halves that read and write; how the format of an input is found.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "schema/format.hpp"
#include "stream/source.hpp"

namespace tcb {

struct Input;
struct InputOptions;

/// All formats. The first is the default for output.
std::span<const Format> formats();

const Format* find_format(std::string_view name);

/// The format that can be written and whose ending the path has, in upper or lower case, before that of compressed
/// files; or nullptr.
const Format* find_output_format(std::string_view path);

/// The endings of the formats that can be read, and of those that can be written.
std::vector<std::string_view> input_endings();
std::vector<std::string_view> output_endings();

/// Opens an input: the format is the given one, else by the file's ending, else by the first byte that is not blank.
/// Throws: Error (data), without a file name.
Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& given);

/// The ending of the path if it belongs to a known format of files that the program does not write; otherwise empty.
std::string_view other_ending(std::string_view path);

}  // namespace tcb
