// Formats by the endings of outputs.
#include "schema/formats.hpp"

#include <algorithm>

namespace tcb {
namespace {

bool has_ending(std::string_view path, std::string_view ending) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  if (path.size() <= ending.size() || path[path.size() - ending.size() - 1] == '/') return false;
  return std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, lower);
}

}  // namespace

std::string_view compression_ending(std::string_view path) {
  for (const std::string_view ending : {".gz", ".zst"}) {
    if (has_ending(path, ending)) return ending;
  }
  return "";
}

std::string_view without_compression(std::string_view path) {
  return path.substr(0, path.size() - compression_ending(path).size());
}

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
