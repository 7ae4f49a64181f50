// Batches: the files of a job into one output or each into its own, files that fail, and threads for large files.
#include "run/batch.hpp"

#include <fmt/format.h>

#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>

#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "io/system.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {

Error failure_of(const std::exception& failure) {
  if (const auto* const error = dynamic_cast<const Error*>(&failure)) return *error;
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&failure) != nullptr ||
                         dynamic_cast<const std::length_error*>(&failure) != nullptr;
  if (is_memory) return usage_error("out of memory");
  if (const auto* const refused = dynamic_cast<const std::system_error*>(&failure)) {
    return usage_error("the system refused a part of the work: {}", refused->code().message());
  }
  return usage_error("the program failed by a fault of its own, and wrote no output; report the command and its input");
}

namespace {

/// Files of at least this size use all threads; smaller ones share them.
constexpr std::uintmax_t large_file = 4UL * 1024 * 1024;

struct FileOutcome {
  std::uint64_t rows = 0;
  std::optional<Error> error = {};
};

FileOutcome outcome_of(const InputFile& file, unsigned threads, const Convert& convert) {
  try {
    return {convert(file, threads)};
  } catch (const std::exception& failure) {
    return {0, failure_of(failure).in(file.path)};
  }
}

}  // namespace

Summary convert_all(const Inputs& inputs, unsigned threads, Report& report, const Convert& convert) {
  Summary summary;
  summary.ignored = inputs.others;
  const auto next_file = [&, next = inputs.files.begin()]() mutable -> std::optional<const InputFile*> {
    for (; next != inputs.files.end() && next->is_current; ++next) {
      ++summary.skipped;
      report.skip_file(next->size);
    }
    return next == inputs.files.end() ? std::nullopt : std::optional(&*next++);
  };
  const auto work = [&](const InputFile* file) {
    return outcome_of(*file, file->size >= large_file ? threads : 1, convert);
  };
  const Source<FileOutcome> outcomes = ordered_map(Source<const InputFile*>(next_file), work, threads);
  while (const std::optional<FileOutcome> outcome = outcomes()) {
    summary.rows += outcome->rows;
    ++(outcome->error ? summary.failed : summary.done);
    if (outcome->error) report.error(*outcome->error);
  }
  return summary;
}

namespace {

void remove_left_temporaries(const Inputs& inputs, const OutputPaths& paths) {
  std::set<std::string> folders;
  for (const InputFile& file : inputs.files) folders.insert(folder_of(output_path(file, paths)));
  for (const std::string& folder : folders) tcb::remove_left_temporaries(folder);
}

Exit convert_each(const Inputs& inputs, const FilesJob& job, Report& report, const OpenOutput& open) {
  const OutputPaths& paths = job.files.outputs;
  const unsigned threads = job.threads.count();
  make_folder(*paths.folder);
  if (job.files.update) remove_left_temporaries(inputs, paths);
  const auto convert = [&](const InputFile& file, unsigned some) {
    const std::string path = output_path(file, paths);
    if (file.inside > 0) make_folder(folder_of(path));
    const ChangeWatch input(file.path);
    const std::unique_ptr<BatchOutput> output = open(path);
    const std::uint64_t rows = output->add(file, some);
    output->commit();
    if (const FileChange change = input.change(); change != FileChange::none) {
      system::make_older(path, file.path);
      const bool is_certain = change == FileChange::contents;  // else only its links, name or mode may have changed
      report.warning(
          file.path,
          {fmt::format("the file {} after it was read; its output has the earlier keys, and --update makes it again",
                       is_certain ? "changed" : "may have changed")});
    }
    return rows;
  };
  const InputFile& first = inputs.files.front();
  if (inputs.files.size() + inputs.others == 1 && !first.is_current) {  // its errors end the program
    in_file(shown_name(first.path), [&] { convert(first, threads); });
    return Exit::done;
  }
  const Summary summary = convert_all(inputs, threads, report, convert);
  report.summary(summary);
  return summary.failed == 0 ? Exit::done : Exit::data;
}

}  // namespace

Exit convert_files(const FilesJob& job, Report& report, const OpenOutput& open) {
  const OutputPaths& paths = job.files.outputs;
  if (paths.folder || paths.file != "-") remove_unfinished_when_interrupted();
  const unsigned threads = job.threads.count();
  const ThreadPool pool(threads);
  const Inputs inputs = find_inputs(job.files);
  std::uintmax_t bytes = 0;
  for (const InputFile& file : inputs.files) bytes += file.size;
  report.expect(inputs.files.size(), bytes);
  if (paths.folder) return convert_each(inputs, job, report, open);
  const std::unique_ptr<BatchOutput> output = open(paths.file);
  for (const InputFile& file : inputs.files) in_file(shown_name(file.path), [&] { output->add(file, threads); });
  output->commit();
  return Exit::done;
}

}  // namespace tcb
