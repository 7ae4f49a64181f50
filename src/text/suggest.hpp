// Names and values typed by people: looked up in tables, taken apart, refused with the nearest known one.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

/// "; did you mean NAME?" with the known name nearest to `name`, or "" where none is near: within a
/// third of its letters changed, dropped, added or swapped for their other case.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

/// Throws: Error (usage): OPTION "VALUE": expected EXPECTED.
[[noreturn]] void refuse_value(std::string_view option, std::string_view value, std::string_view expected);

/// The parts of a text between separators, one at least.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The place of a name among known ones. Throws: Error (usage) naming the nearest.
std::size_t find_name(std::string_view option, const std::vector<std::string_view>& known, std::string_view name);

/// The row of a table whose `name` it is. Throws: Error (usage) naming the nearest.
template <class Table>
std::size_t find_named(std::string_view option, const Table& table, std::string_view name) {
  std::vector<std::string_view> known;
  std::ranges::transform(table, std::back_inserter(known), [](const auto& row) { return row.name; });
  return find_name(option, known, name);
}

}  // namespace tcb
