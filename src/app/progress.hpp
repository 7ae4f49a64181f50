// Progress: reports on standard error during the work: notes, errors, progress, and a summary.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "app/job.hpp"
#include "curve/rows.hpp"
#include "error.hpp"
#include "stream/source.hpp"

namespace tcb {

/// A fact about an input or its curves that a user may not expect, with values as in errors.
enum class NoteCode {
  reads_terminal,
  no_time_column,
  ignored_columns,   ///< names
  unchosen_columns,  ///< the same, where the positions were chosen
  remainder,         ///< distance of the end from the last row
  range_remainder,   ///< the same, where the range does not end at a key
  more_remainders,   ///< number of further curves with one
  rate_of_frames,    ///< name of the time column
  step,              ///< the step, as text
  skipped_rows,      ///< number
  made_times,        ///< the parameterization, as given
  other_program,     ///< the program of the earlier output, this program
};

struct Note {
  NoteCode code;
  std::vector<ErrorValue> values = {};
};

/// The functions that turn errors and notes into words.
struct Wording {
  std::string (*error)(const Error& error);
  std::string (*note)(const Note& note);
};

/// Counts of the files of a batch.
struct Summary {
  std::uint64_t done = 0, skipped = 0, failed = 0;
  std::uint64_t ignored = 0;  ///< files in folders with the ending of no format
  std::uint64_t rows = 0;
};

/// Writes on standard error. Threads: any number at once.
class Report {
 public:
  Report(const Verbosity& verbosity, const Wording& wording) : verbosity_(verbosity), wording_(wording) {}
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;
  /// Removes the progress from the terminal.
  ~Report();

  /// Notes of what the rows lack are always printed, unless it is quiet; others only on a terminal.
  void note(const std::string& path, const Note& note);
  void warning(const std::string& path, const Note& note);
  void error(const Error& error);

  /// The amount of work; 0 bytes: unknown.
  void expect(std::uint64_t files, std::uintmax_t bytes);

  /// The same bytes, or samples, counted as done. `rows` is increased by the number of samples.
  Source<std::string> observe_bytes(Source<std::string> bytes);
  Source<SampleBlock> observe_rows(Source<SampleBlock> samples, std::uint64_t& rows);
  /// Ends a file: all its bytes count as done, whether they were read or not.
  void add_file(std::uintmax_t bytes);

  /// Prints the counts of all files; if all of them are done, only with notes.
  void summary(const Summary& summary);

 private:
  using Clock = std::chrono::steady_clock;

  void add_read(std::size_t bytes);
  void add_rows(std::uint64_t rows);
  void print(const std::string& line);
  void show();
  void clear();

  const Verbosity verbosity_;
  const Wording wording_;
  std::mutex mutex_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
  std::uint64_t files_ = 0, all_files_ = 0, rows_ = 0;
  std::uintmax_t read_ = 0, ended_ = 0, all_bytes_ = 0;
  std::size_t width_ = 0;  ///< of the displayed progress
};

/// The progress as a line: "41 %, 12 of 30 files, 1.2 of 2.9 GB, 1,234 rows, 85 MB/s, 0:20 left".
std::string progress_text(std::uint64_t files, std::uint64_t all_files, std::uintmax_t bytes, std::uintmax_t all_bytes,
                          std::uint64_t rows, double seconds);

}  // namespace tcb
