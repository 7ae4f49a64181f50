// Formats: the list of all of them, with their halves that read and write.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "schema/format.hpp"

namespace tcb {

/// All formats. The first is the default for output.
std::span<const Format> formats();

/// The format with this name, or nullptr.
const Format* find_format(std::string_view name);

/// The format that can be written and whose ending the path has, in upper or lower case, before that of compressed
/// files; or nullptr.
const Format* find_output_format(std::string_view path);

/// The endings of the formats that can be read, and of those that can be written.
std::vector<std::string_view> input_endings();
std::vector<std::string_view> output_endings();

}  // namespace tcb
