// SampleBlock: many files, each to an output of its own, on all threads, and none in another's way.
#include "app/batch.hpp"

#include <atomic>
#include <optional>

#include "error.hpp"
#include "stream/stream.hpp"

namespace tcb {
namespace {

/// From this size on a file is worth all threads; smaller ones share them.
constexpr std::uintmax_t large_file = 4UL * 1024 * 1024;

/// What became of a file.
struct Outcome {
  std::uintmax_t size = 0;
  std::uint64_t rows = 0;
  std::optional<Error> error = {};
  bool begun = true;
};

Outcome outcome_of(const InputFile& file, unsigned threads, const Convert& convert) {
  try {
    return {file.size, convert(file, threads), {}};
  } catch (const Error& error) {
    return {file.size, 0, error.in(file.path)};
  } catch (const std::bad_alloc&) {
    return {file.size, 0, Error(Exit::usage, TextPosition{file.path}, "out of memory")};
  } catch (const std::exception& error) {
    return {file.size, 0, Error(Exit::usage, TextPosition{file.path}, error.what())};
  }
}

}  // namespace

Summary convert_all(const Inputs& inputs, const Job& plan, unsigned threads, Report& report, const Convert& convert) {
  Summary summary;
  summary.left_alone = inputs.left_alone;
  // No file from here on is begun: those before one that failed are, whichever thread found it first.
  std::atomic<const InputFile*> stop = inputs.files.data() + inputs.files.size();
  const auto next_file = [&, next = inputs.files.begin()]() mutable -> std::optional<const InputFile*> {
    for (; next != inputs.files.end() && next->is_current; ++next) {
      ++summary.skipped;
      report.add_file(next->size);
    }
    const InputFile* const file = inputs.files.data() + (next - inputs.files.begin());
    if (file >= stop) return std::nullopt;
    ++next;
    return file;
  };
  const auto work = [&](const InputFile* file) {
    if (file >= stop) return Outcome{.begun = false};
    Outcome outcome = outcome_of(*file, file->size >= large_file ? threads : 1, convert);
    if (!outcome.error || !plan.batch.fail_fast) return outcome;
    for (const InputFile* first = stop; file < first && !stop.compare_exchange_weak(first, file);) {
    }
    return outcome;
  };
  const Source<Outcome> outcomes = ordered_map(Source<const InputFile*>(next_file), work, threads);
  while (const std::optional<Outcome> outcome = outcomes()) {
    if (!outcome->begun) continue;
    report.add_file(outcome->size);
    summary.rows += outcome->rows;
    ++(outcome->error ? summary.failed : summary.done);
    if (outcome->error) report.error(*outcome->error);
  }
  return summary;
}

}  // namespace tcb
