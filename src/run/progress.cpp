// Progress: reports on standard error during the work: notes, errors, progress, and a summary.
#include "run/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "io/input_file.hpp"
#include "io/system.hpp"
#include "io/terminal.hpp"
#include "numbers/print_number.hpp"
#include "sample/rows.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr auto between_updates = std::chrono::milliseconds(100);

std::string size_text(double bytes) {
  constexpr std::array<std::string_view, 6> units{"B", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  return fmt::format("{:.{}f} {}", bytes, unit == 0 || bytes >= 99.5 ? 0 : 1, units[unit]);
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::lround(std::min(seconds, 1e9)));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// A part of the line. Where there is no room for all, those of the lowest importance are left out.
struct LinePart {
  int importance;
  std::string text;
};

std::string bar(double fraction) {
  constexpr std::size_t width = 20;
  std::string text(width, '-');
  const auto done = static_cast<std::size_t>(fraction * static_cast<double>(width));
  std::fill_n(text.begin(), std::min(done, width), '#');
  return "[" + text + "] ";
}

std::vector<LinePart> line_parts(const Progress& progress) {
  std::vector<LinePart> parts;
  const double done = std::min(progress.fraction.value_or(0), 1.0);
  if (progress.fraction) {
    parts.push_back({3, bar(done)});
    parts.push_back({9, fmt::format("{:.0f} %", std::floor(100 * done))});
  }
  constexpr double enough_to_estimate = 0.1;
  if (done >= enough_to_estimate && done < 1) {
    parts.push_back({8, fmt::format("{} left", duration_text(progress.seconds * (1 - done) / done))});
  }
  if (progress.all_files > 1) {
    parts.push_back(
        {7, fmt::format("{} of {} files", with_thousands(progress.files), with_thousands(progress.all_files))});
    if (!progress.file.empty()) parts.push_back({4, progress.file});
  }
  const auto rate = [&](double amount) { return amount / std::max(progress.seconds, 1e-3); };
  if (progress.rows > 0) {
    parts.push_back({6, fmt::format("{} rows", with_thousands(progress.rows))});
    const double rows = rate(static_cast<double>(progress.rows));
    parts.push_back({5, fmt::format("{} rows/s", with_thousands(static_cast<std::uint64_t>(rows)))});
  } else {
    const auto bytes = static_cast<double>(progress.bytes);
    parts.push_back({6, fmt::format("{} read", size_text(bytes))});
    parts.push_back({5, fmt::format("{}/s", size_text(rate(bytes)))});
  }
  return parts;
}

std::string line_of(const std::vector<LinePart>& parts) {
  std::string text;
  for (const LinePart& part : parts) text += (text.empty() || text.ends_with(' ') ? "" : ", ") + part.text;
  return text;
}

}  // namespace

std::string progress_text(const Progress& progress, std::size_t width) {
  std::vector<LinePart> parts = line_parts(progress);
  while (parts.size() > 1 && line_of(parts).size() > width) {
    parts.erase(std::ranges::min_element(parts, {}, &LinePart::importance));
  }
  return line_of(parts).substr(0, width);
}

Report::Report(const Verbosity& verbosity) : verbosity_(verbosity) {
  if (verbosity.progress) shows_ = std::jthread([this](const std::stop_token& stop) { show_until(stop); });
}

Report::~Report() {
  shows_ = {};
  clear();
}

void Report::note(const std::string& path, const Note& note) {
  if (note.is_important ? !verbosity_.quiet : verbosity_.notes)
    print(message_head(in_message(shown_name(path)), MessageKind::note, verbosity_.color) + in_message(note.text));
}

void Report::warning(const std::string& path, const Note& note) {
  if (!verbosity_.quiet)
    print(message_head(in_message(path), MessageKind::warning, verbosity_.color) + in_message(note.text));
}

void Report::error(const Error& error) { print(error_text(error, verbosity_.color)); }

void Report::expect(std::uint64_t files, std::uintmax_t bytes) {
  all_files_ = files;
  all_bytes_ = bytes;
}

std::shared_ptr<FileProgress> Report::begin_file(const std::string& path, std::uintmax_t size) {
  return std::make_shared<FileProgress>(*this, path, size);
}

void Report::skip_file(std::uintmax_t bytes) {
  const std::lock_guard lock(mutex_);
  ++files_;
  ended_ += bytes;
  show();
}

FileProgress::FileProgress(Report& report, std::string path, std::uintmax_t size)
    : report_(report), path_(std::move(path)), size_(size) {
  const std::lock_guard lock(report_.mutex_);
  report_.active_.push_back(this);
}

FileProgress::~FileProgress() {
  const std::lock_guard lock(report_.mutex_);
  report_.active_.remove(this);
  ++report_.files_;
  report_.ended_ += size_;
  report_.show();
}

Source<std::string> FileProgress::observe_bytes(Source<std::string> bytes) {
  if (!report_.verbosity_.progress) return bytes;
  return [this, bytes = std::move(bytes)]() -> std::optional<std::string> {
    std::optional<std::string> part = bytes();
    const std::lock_guard lock(report_.mutex_);
    at_end_ = !part;
    read_ += part ? part->size() : 0;
    report_.read_ += part ? part->size() : 0;
    report_.show();
    return part;
  };
}

Source<SampleBlock> FileProgress::observe_rows(Source<SampleBlock> samples, std::function<double()> expected,
                                               std::uint64_t& rows) {
  before_ = static_cast<double>(rows);
  return observed(std::move(samples), [this, expected = std::move(expected), &rows](const SampleBlock& block) {
    rows += block.rows();
    if (expected) expect_rows(before_ + expected());
    add_rows(block.rows());
  });
}

void FileProgress::expect_rows(double rows) {
  const std::lock_guard lock(report_.mutex_);
  expected_ = rows;
}

void FileProgress::add_rows(std::uint64_t rows) {
  if (!report_.verbosity_.progress) return;
  const std::lock_guard lock(report_.mutex_);
  rows_ += rows;
  report_.rows_ += rows;
  report_.show();
}

std::optional<double> FileProgress::fraction() const {
  if (expected_ <= 0 || (size_ == 0 && !at_end_)) return std::nullopt;
  const double rows = std::min(1.0, static_cast<double>(rows_) / expected_);
  const double bytes = at_end_ ? 1 : std::min(1.0, static_cast<double>(read_) / static_cast<double>(size_));
  return rows * bytes;
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

/// A single file has its own fraction; of several, the bytes of those that are done count, and of the others as many
/// as their fractions.
Progress Report::progress() const {
  const std::chrono::duration<double> passed = Clock::now() - start_;
  Progress progress{{}, files_, all_files_, {}, read_, rows_, passed.count()};
  if (all_files_ <= 1) {
    if (!active_.empty()) progress.fraction = active_.front()->fraction();
    return progress;
  }
  auto done = static_cast<double>(ended_);
  for (const FileProgress* file : active_) done += file->fraction().value_or(0) * static_cast<double>(file->size_);
  if (all_bytes_ > 0) progress.fraction = done / static_cast<double>(all_bytes_);
  if (!active_.empty()) progress.file = active_.front()->path_;
  return progress;
}

/// Prints the progress over the one before, ten times a second.
void Report::show() {
  const Clock::time_point now = Clock::now();
  if (!verbosity_.progress || now < next_) return;
  next_ = now + between_updates;
  constexpr std::size_t margin = 3;  // a full line would wrap, also one with the ^C of an interruption
  std::string text = progress_text(progress(), std::max(system::terminal_width(), 2 * margin) - margin);
  const std::size_t width = text.size();
  erase_when_interrupted(std::max(width, width_));
  text.resize(std::max(width, width_), ' ');
  (void)std::fputs(("\r" + text).c_str(), stderr);
  width_ = width;
}

void Report::show_until(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!never_.wait_for(lock, stop, between_updates, [&] { return stop.stop_requested(); })) show();
}

void Report::clear() {
  if (width_ == 0) return;
  (void)std::fputs(("\r" + std::string(width_, ' ') + "\r").c_str(), stderr);
  erase_when_interrupted(0);
  width_ = 0;
}

}  // namespace tcb
