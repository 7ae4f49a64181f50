// Progress: reports on standard error during the work: notes, errors, progress, and a summary.
#include "app/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "io/input_file.hpp"

namespace tcb {
namespace {

constexpr auto between_updates = std::chrono::milliseconds(100);

/// The number of columns of the terminal.
std::size_t terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

/// A size with three digits and its unit.
std::string size_text(double bytes) {
  constexpr std::array<std::string_view, 6> units{"B", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  return fmt::format("{:.{}f} {}", bytes, unit == 0 || bytes >= 99.5 ? 0 : 1, units[unit]);
}

std::string thousands(std::uint64_t count) {
  std::string text = fmt::format("{}", count);
  for (std::size_t left = text.size(); left > 3; left -= 3) text.insert(left - 3, ",");
  return text;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::lround(std::min(seconds, 1e9)));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::string progress_text(std::uint64_t files, std::uint64_t all_files, std::uintmax_t bytes, std::uintmax_t all_bytes,
                          std::uint64_t rows, double seconds) {
  const auto done = static_cast<double>(bytes);
  const auto all = static_cast<double>(all_bytes);
  const bool partly = bytes < all_bytes;
  std::string text;
  if (all_bytes > 0) text += fmt::format("{:.0f} %, ", partly ? 100 * done / all : 100);
  if (all_files > 1) text += fmt::format("{} of {} files, ", thousands(files), thousands(all_files));
  text += partly ? fmt::format("{} of {}", size_text(done), size_text(all)) : size_text(done);
  if (rows > 0) text += fmt::format(", {} rows", thousands(rows));
  text += fmt::format(", {}/s", size_text(done / seconds));
  if (partly && bytes > 0) text += fmt::format(", {} left", duration_text(seconds * (all - done) / done));
  return text;
}

Report::~Report() { clear(); }

void Report::note(const std::string& path, const Note& note) {
  constexpr std::array losses{NoteCode::ignored_columns, NoteCode::remainder, NoteCode::range_remainder,
                              NoteCode::more_remainders, NoteCode::rate_of_frames};
  const bool is_loss = std::ranges::count(losses, note.code) > 0;
  if (is_loss ? !verbosity_.quiet : verbosity_.notes)
    print(fmt::format("{}: note: {}", shown_name(path), wording_.note(note)));
}

void Report::warning(const std::string& path, const Note& note) {
  if (!verbosity_.quiet) print(fmt::format("{}: warning: {}", path, wording_.note(note)));
}

void Report::error(const Error& error) { print(wording_.error(error)); }

void Report::expect(std::uint64_t files, std::uintmax_t bytes) {
  all_files_ = files;
  all_bytes_ = bytes;
}

Source<std::string> Report::observe_bytes(Source<std::string> bytes) {
  return mapped(std::move(bytes), [this](std::string part) {
    add_read(part.size());
    return part;
  });
}

Source<SampleBlock> Report::observe_rows(Source<SampleBlock> samples, std::uint64_t& rows) {
  return mapped(std::move(samples), [this, &rows](SampleBlock block) {
    rows += block.rows();
    add_rows(block.rows());
    return block;
  });
}

void Report::add_read(std::size_t bytes) {
  if (!verbosity_.progress) return;
  const std::lock_guard lock(mutex_);
  read_ += bytes;
  show();
}

void Report::add_rows(std::uint64_t rows) {
  if (!verbosity_.progress) return;
  const std::lock_guard lock(mutex_);
  rows_ += rows;
  show();
}

void Report::add_file(std::uintmax_t bytes) {
  if (!verbosity_.progress) return;
  const std::lock_guard lock(mutex_);
  ++files_;
  ended_ += bytes;
  show();
}

void Report::summary(const Summary& summary) {
  const bool all_done = summary.skipped + summary.failed + summary.ignored == 0;
  if (verbosity_.quiet || (all_done && !verbosity_.notes)) return;
  const std::chrono::duration<double> passed = Clock::now() - start_;
  std::string text = fmt::format("tcbsample: {} done, {} skipped, {} failed, {} rows, {:.1f} seconds", summary.done,
                                 summary.skipped, summary.failed, summary.rows, passed.count());
  if (summary.ignored > 0) text += fmt::format("; {} other files left alone", summary.ignored);
  print(text);
}

/// Removes the progress, then prints a line.
void Report::print(const std::string& line) {
  const std::lock_guard lock(mutex_);
  clear();
  (void)std::fputs((line + "\n").c_str(), stderr);
}

/// Prints the progress over the one before, ten times a second.
void Report::show() {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + between_updates;
  const std::chrono::duration<double> passed = now - start_;
  std::string text = progress_text(files_, all_files_, std::max(read_, ended_), all_bytes_, rows_, passed.count());
  text.resize(std::min(text.size(), terminal_width() - 1));  // a full line would wrap
  const std::size_t width = text.size();
  text.resize(std::max(width, width_), ' ');
  (void)std::fputs(("\r" + text).c_str(), stderr);
  width_ = width;
}

void Report::clear() {
  if (width_ == 0) return;
  (void)std::fputs(("\r" + std::string(width_, ' ') + "\r").c_str(), stderr);
  width_ = 0;
}

}  // namespace tcb
