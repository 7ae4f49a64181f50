// Removed names: the table of them, and the error that tells what to do instead.
#include "text/removed.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr RemovedName table[] = {
    {"--segments", "",
     "give --count @N+1@, or --count @N@ for the rows of a closed curve without the repeated first one"},
    {"--units", "", "leave it out; the error about a unit in a cell prints the sed command that removes it"},
    {"--like-input", "",
     "give --output-delimiter CHAR and --output-decimal MARK; for line ends of CR and LF, pipe the rows through "
     "sed 's/$/\\r/'"},
    {"--progress", "", "remove it, as the progress shows by itself on a terminal, where rows go to a file"},
    {"--no-progress", "", "give --quiet, which prints no notes either"},
    {"--generate", "columns", "give --explain, which tells the columns and their roles"},
    {"--generate", "positions", "give --explain, which tells the columns and their roles"},
    {"--from-meta", "", "--meta prints the whole command, quoted for a shell: paste it"},
    {"--fail-fast", "",
     "the exit code tells that files failed; to stop at the first one, run the program for each file, in a loop of the "
     "shell with || break"},
};

/// The text with the numbers of a value in it.
std::string filled(std::string_view text, std::string_view value) {
  const auto number = in_digits<std::uint64_t>(value);
  std::string result(text);
  for (const auto& [mark, next] : {std::pair<std::string_view, unsigned>{"@N@", 0}, {"@N+1@", 1}}) {
    const std::string name(mark.substr(1, mark.size() - 2));
    for (std::size_t at = 0; (at = result.find(mark, at)) != std::string::npos;) {
      result.replace(at, mark.size(), number ? std::to_string(*number + next) : name);
    }
  }
  return result;
}

}  // namespace

std::span<const RemovedName> removed_names() { return table; }

std::optional<Error> removed(std::string_view option, std::string_view value) {
  const auto found = std::ranges::find_if(table, [&](const RemovedName& row) {
    return row.option == option && (row.value.empty() || matches(value, row.value));
  });
  if (found == std::end(table)) return std::nullopt;
  std::string name(option);
  if (!found->value.empty()) name += " " + std::string(value);
  return usage_error("{} is gone in this version; {}", name, filled(found->instead, value));
}

}  // namespace tcb
