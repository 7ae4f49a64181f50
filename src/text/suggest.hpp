// Suggestions: the known name nearest to one that is misspelt; texts split at a separator.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

/// The known name nearest to `name`, or "" where none is near: within a third of the letters of the longer one changed,
/// dropped or added. Upper and lower case are different letters.
std::string nearest_name(std::string_view name, std::span<const std::string_view> known);

/// The known name that is probably meant, or "": the nearest one; else the only one that has the same letters, begins
/// with `name`, or contains it.
std::string_view likely_name(std::string_view name, std::span<const std::string_view> known);

/// The parts of a text between separators, one at least.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace tcb
