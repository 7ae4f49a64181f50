// Many files: the options that say which, and what is said while they are done.
#include "cli/batch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Options that mean something only where each file has an output of its own.
void require_folder(const TypedOptions& typed) {
  if (!typed.output_dir.empty()) return;
  const std::initializer_list<std::pair<const char*, bool>> given{{"--recursive", typed.recursive},
                                                                  {"--suffix", !typed.suffix.empty()},
                                                                  {"--update", typed.update},
                                                                  {"--fail-fast", typed.fail_fast}};
  for (const auto& [name, is_given] : given) {
    if (!is_given) continue;
    throw Error(
        Exit::usage,
        fmt::format("{} has no effect without --output-dir, an output for each file; give that, or take it out", name));
  }
}

}  // namespace

BatchOptions make_batch(const TypedOptions& typed) {
  require_folder(typed);
  if (typed.nul && typed.list.empty()) {
    throw Error(Exit::usage, "-0 has no effect without --files; give --files LIST, or take it out");
  }
  if (typed.list == "-" && std::ranges::count(typed.files, "-") > 0) {
    throw Error(Exit::usage,
                "--files - and the file - are both standard input; expected names or keys there; take one out");
  }
  if (typed.suffix.find('/') != std::string::npos) {
    refuse_value("--suffix", typed.suffix, "a part of a file's name, without /");
  }
  return {typed.list, typed.nul, typed.recursive, typed.suffix, typed.update, typed.fail_fast};
}

Verbosity make_talk(const TypedOptions& typed) {
  if (typed.progress && (typed.no_progress || typed.quiet)) {
    throw Error(Exit::usage, fmt::format("--progress and {} say the opposite; expected one of them; take one out",
                                         typed.no_progress ? "--no-progress" : "--quiet"));
  }
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const bool rows_go_there = typed.output.empty() && typed.output_dir.empty() && ::isatty(STDOUT_FILENO) != 0;
  const bool progress = terminal && (typed.progress || (!rows_go_there && !typed.no_progress && !typed.quiet));
  return {typed.quiet, terminal && !typed.quiet, progress};
}

}  // namespace tcb
