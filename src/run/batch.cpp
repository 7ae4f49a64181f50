// Batches: an output for each file, files that fail, and threads for large files.
#include <atomic>
#include <new>
#include <optional>

#include "run/errors.hpp"
#include "run/pipeline.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {
namespace {

/// Files of at least this size use all threads; smaller ones share them.
constexpr std::uintmax_t large_file = 4UL * 1024 * 1024;

/// The result of a file.
struct FileOutcome {
  std::uint64_t rows = 0;
  std::optional<Error> error = {};
  bool begun = true;
};

FileOutcome outcome_of(const InputFile& file, unsigned threads, const Convert& convert) {
  try {
    return {convert(file, threads), {}};
  } catch (const Error& error) {
    return {0, error.in(file.path)};
  } catch (const std::bad_alloc&) {
    return {0, out_of_memory().in(file.path)};
  } catch (const std::exception& error) {
    return {0, unexpected_failure(error.what()).in(file.path)};
  }
}

}  // namespace

Summary convert_all(const Inputs& inputs, bool fail_fast, unsigned threads, Report& report, const Convert& convert) {
  Summary summary;
  summary.ignored = inputs.others;
  // No file from here on is begun. All files before one that failed are, whichever thread is first.
  std::atomic<const InputFile*> stop = inputs.files.data() + inputs.files.size();
  const auto next_file = [&, next = inputs.files.begin()]() mutable -> std::optional<const InputFile*> {
    for (; next != inputs.files.end() && next->is_current; ++next) {
      ++summary.skipped;
      report.skip_file(next->size);
    }
    const InputFile* const file = inputs.files.data() + (next - inputs.files.begin());
    if (file >= stop) return std::nullopt;
    ++next;
    return file;
  };
  const auto work = [&](const InputFile* file) {
    if (file >= stop) return FileOutcome{.begun = false};
    FileOutcome outcome = outcome_of(*file, file->size >= large_file ? threads : 1, convert);
    if (!outcome.error || !fail_fast) return outcome;
    for (const InputFile* first = stop; file < first && !stop.compare_exchange_weak(first, file);) {
    }
    return outcome;
  };
  const Source<FileOutcome> outcomes = ordered_map(Source<const InputFile*>(next_file), work, threads);
  while (const std::optional<FileOutcome> outcome = outcomes()) {
    if (!outcome->begun) continue;
    summary.rows += outcome->rows;
    ++(outcome->error ? summary.failed : summary.done);
    if (outcome->error) report.error(*outcome->error);
  }
  return summary;
}

}  // namespace tcb
