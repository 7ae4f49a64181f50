// Progress: reports on standard error during the work: notes, errors, progress, and a summary.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "error.hpp"
#include "run/job.hpp"
#include "stream/source.hpp"

namespace tcb {

struct SampleBlock;

/// A fact about an input or its curves that a user may not expect.
struct Note {
  std::string text;
  bool is_important = false;  ///< printed unless it is quiet; other notes only on a terminal
};

struct Summary {
  std::uint64_t done = 0, skipped = 0, failed = 0;
  std::uint64_t ignored = 0;  ///< files in folders with the ending of no format
  std::uint64_t rows = 0;
};

struct Progress {
  std::optional<double> fraction = {};  ///< of the work; nothing: unknown
  std::uint64_t files = 0, all_files = 1;
  std::string file = {};  ///< the one at hand
  std::uintmax_t bytes = 0;
  std::uint64_t rows = 0;
  double seconds = 0;
};

/// The progress in at most `width` characters: "[####------] 41 %, 0:14 left, 12 of 30 files, a.csv, 1,234 rows,
/// 123 rows/s", without the least important parts where it would be longer.
std::string progress_text(const Progress& progress, std::size_t width);

class FileProgress;

/// Writes on standard error. Threads: any number at once.
class Report {
 public:
  explicit Report(const Verbosity& verbosity);
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;
  /// Removes the progress from the terminal.
  ~Report();

  /// Important notes are printed unless it is quiet, the others only on a terminal.
  void note(const std::string& path, const Note& note);
  void warning(const std::string& path, const Note& note);
  void error(const Error& error);

  /// The amount of work; 0 bytes: unknown.
  void expect(std::uint64_t files, std::uintmax_t bytes);

  /// A file whose work begins; it ends with the result. 0 bytes: unknown.
  std::shared_ptr<FileProgress> begin_file(const std::string& path, std::uintmax_t size);
  void skip_file(std::uintmax_t bytes);

  /// Prints the counts of all files; if all of them are done, only with notes.
  void summary(const Summary& summary);

 private:
  friend class FileProgress;
  using Clock = std::chrono::steady_clock;

  Progress progress() const;
  void print(const std::string& line);
  void show();
  void clear();
  /// Shows the progress again and again, also while nothing is read and no row is done.
  void show_until(const std::stop_token& stop);

  const Verbosity verbosity_;
  std::mutex mutex_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
  std::list<const FileProgress*> active_;
  std::uint64_t files_ = 0, all_files_ = 0, rows_ = 0;  ///< rows and bytes: also those of active files
  std::uintmax_t read_ = 0, ended_ = 0, all_bytes_ = 0;
  std::size_t width_ = 0;  ///< of the displayed progress
  std::condition_variable_any never_;
  std::jthread shows_;  ///< where there is progress; it ends before the other members
};

/// The work on one file: its bytes, and then rows, where their number is known. Threads: those of the report.
class FileProgress {
 public:
  FileProgress(Report& report, std::string path, std::uintmax_t size);
  FileProgress(const FileProgress&) = delete;
  FileProgress& operator=(const FileProgress&) = delete;
  ~FileProgress();

  /// Passes bytes, or samples, on and counts them. `expected`: about the number of rows of this curve by the bytes read
  /// so far; may be null. `rows` is increased by the number of samples. Requires: this outlives the sources.
  Source<std::string> observe_bytes(Source<std::string> bytes);
  Source<SampleBlock> observe_rows(Source<SampleBlock> samples, std::function<double()> expected, std::uint64_t& rows);

  /// The number of all rows or of other equal parts of the work, and that some of them are done.
  void expect_rows(double rows);
  void add_rows(std::uint64_t rows);

  /// How much of the work is done; nothing: unknown.
  std::optional<double> fraction() const;

 private:
  friend class Report;

  Report& report_;
  const std::string path_;
  const std::uintmax_t size_;
  std::uintmax_t read_ = 0;
  std::uint64_t rows_ = 0;
  double before_ = 0, expected_ = 0;  ///< rows of earlier curves, and of all up to this one; 0: unknown
  bool at_end_ = false;               ///< all bytes were read
};

}  // namespace tcb
