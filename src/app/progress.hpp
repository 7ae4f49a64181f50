// What people are told on standard error while the work goes on: notes, errors, and how far it is.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "app/job.hpp"
#include "error.hpp"

namespace tcb {

/// What became of the files of a batch.
struct Summary {
  std::uint64_t done = 0, skipped = 0, failed = 0;
  std::uint64_t left_alone = 0;  ///< in folders, as no format's
  std::uint64_t rows = 0;
};

/// Threads: any number at once.
class Report {
 public:
  explicit Report(const Verbosity& verbosity) : verbosity_(verbosity) {}
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;
  /// Takes the progress off the terminal.
  ~Report();

  void note(const std::string& path, const std::string& text);
  void error(const Error& error);

  /// All that there is to do; 0 bytes: nobody can tell.
  void expect(std::uint64_t files, std::uintmax_t bytes);

  /// What has been done of it. A file that has ended was read as a whole, or nobody will read the rest.
  void add_read(std::size_t bytes);
  void add_rows(std::uint64_t rows);
  void add_file(std::uintmax_t bytes);

  /// What became of all; where all is well, people at a terminal are told.
  void summary(const Summary& summary);

 private:
  using Clock = std::chrono::steady_clock;

  void say(const std::string& line);
  void show();
  void clear();

  const Verbosity verbosity_;
  std::mutex mutex_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
  std::uint64_t files_ = 0, all_files_ = 0, rows_ = 0;
  std::uintmax_t read_ = 0, ended_ = 0, all_bytes_ = 0;
  std::size_t width_ = 0;  ///< of what stands on the terminal's last line
};

/// How far the work is, in a line: "41 %, 12 of 30 files, 1.2 of 2.9 GB, 1,234 rows, 85 MB/s, 0:20 left".
std::string progress_text(std::uint64_t files, std::uint64_t all_files, std::uintmax_t bytes, std::uintmax_t all_bytes,
                          std::uint64_t rows, double seconds);

}  // namespace tcb
