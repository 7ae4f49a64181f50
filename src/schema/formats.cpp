// Formats: the table of their names, file endings and capabilities.
#include "schema/formats.hpp"

#include <algorithm>

#include "text/file_ending.hpp"

namespace tcb {

std::optional<FormatId> find_input_format(std::string_view path) {
  path = without_compression(path);
  for (const Format& format : formats) {
    if (format.can_read && path.ends_with(format.ending)) return format.id;
  }
  return std::nullopt;
}

namespace {

/// The endings of formats with a capability.
std::vector<std::string_view> endings(bool Format::*can) {
  std::vector<std::string_view> found;
  for (const Format& format : formats) {
    if (format.*can && std::ranges::count(found, format.ending) == 0) found.push_back(format.ending);
  }
  return found;
}

}  // namespace

std::vector<std::string_view> input_endings() { return endings(&Format::can_read); }

std::vector<std::string_view> output_endings() { return endings(&Format::can_write); }

std::optional<FormatId> find_output_format(std::string_view path) {
  path = without_compression(path);
  for (const Format& format : formats) {
    if (format.can_write && has_ending(path, format.ending)) return format.id;
  }
  return std::nullopt;
}

}  // namespace tcb
