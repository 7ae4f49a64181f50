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
    {"--units", "", "leave it out; write the numbers without units"},
    {"--like-input", "",
     "give --output-delimiter CHAR and --output-decimal MARK; for line ends of CR and LF, pipe the rows through "
     "sed 's/$/\\r/'"},
    {"--progress", "", "remove it, as the progress shows by itself on a terminal, where rows go to a file"},
    {"--no-progress", "", "give --quiet, which prints no notes either"},
    {"--generate", "columns", "give --explain, which tells the columns and their roles"},
    {"--generate", "positions", "give --explain, which tells the columns and their roles"},
    {"--from-meta", "", "--meta prints the whole command, quoted for a shell: paste it"},
    {"--input-format", "fbx", "nearly all FBX scenes are binary, which was never read; export the keys as CSV"},
    {"--input-format", "ase", "export the keys as CSV, or the scene as .3ds"},
    {"--output-format", "crazyswarm",
     "give --emit poly, and awk for the header, zeros and the yaw, as in tcbsample --emit poly FILE | awk -F, 'BEGIN "
     "{printf \"duration\"; for (i = 0; i < 32; ++i) printf \",%s^%d\", i < 24 ? substr(\"xyz\", int(i / 8) + 1, 1) : "
     "\"yaw\", i % 8; print \"\"} !/\\^/ {printf \"%s\", $2; for (i = 0; i < 32; ++i) {c = 3 + 4 * int(i / 8); printf "
     "\",%s\", (i % 8 > 3 || c > NF ? 0 : $(c + i % 8))} print \"\"}'"},
    {"--emit", "poly*",
     "give --emit poly, and awk for the zeros, as in tcbsample --emit poly FILE | awk -F, '{printf \"%s,%s\", $1, $2; "
     "for (c = 3; c <= NF; c += 4) for (k = 0; k < @N@; ++k) printf \",%s\", k < 4 ? $(c + k) : /\\^/ ? substr($c, 1, "
     "length($c) - 1) k : 0; print \"\"}'"},
    {"--fail-fast", "",
     "the exit code tells that files failed; to stop at the first one, run the program for each file, in a loop of the "
     "shell with || break"},
};

/// The number that a value has, in the place of * in that of a row.
std::optional<std::uint64_t> number_in(const RemovedName& row, std::string_view value) {
  const std::size_t place = row.value.find('*');
  return in_digits<std::uint64_t>(value.substr(place == std::string_view::npos ? 0 : place));
}

/// The text with a number in it.
std::string filled(std::string_view text, std::optional<std::uint64_t> number) {
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
    if (row.option != option || (!row.value.empty() && !matches(value, row.value))) return false;
    return !row.value.ends_with('*') || number_in(row, value);
  });
  if (found == std::end(table)) return std::nullopt;
  std::string name(option);
  if (!found->value.empty()) name += " " + std::string(value);
  return usage_error("{} is gone in this version; {}", name, filled(found->instead, number_in(*found, value)));
}

}  // namespace tcb
