// Formats by the endings of outputs.
#include "schema/formats.hpp"

#include <algorithm>

namespace tcb {

std::optional<FormatId> find_output_format(std::string_view path) {
  path = without_compression(path);
  for (const Format& format : formats) {
    if (format.can_write && has_ending(path, format.ending)) return format.id;
  }
  return std::nullopt;
}

std::string_view other_ending(std::string_view path) {
  path = without_compression(path);
  const auto found = std::ranges::find_if(other_endings, [&](auto ending) { return has_ending(path, ending); });
  return found == other_endings.end() ? "" : *found;
}

}  // namespace tcb
