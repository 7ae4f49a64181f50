// Progress: the line of progress, notes and warnings.
#include "run/progress.hpp"
#include "sample/rows.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace {

using tcb::Progress;
using tcb::progress_text;

const Progress several{
    .fraction = 0.41, .files = 12, .all_files = 30, .bytes = 1'200'000'000, .rows = 1234, .seconds = 10};

TEST(Progress, the_line_has_what_is_known) {
  Progress progress = several;
  progress.file = "a.csv";
  EXPECT_EQ(progress_text(progress, 200),
            "[########------------] 41 %, 0:14 left, 12 of 30 files, a.csv, 1,234 rows, 123 rows/s");
  EXPECT_EQ(progress_text({.fraction = 0.5, .bytes = 500, .rows = 1, .seconds = 7200}, 200),
            "[##########----------] 50 %, 2:00:00 left, 1 rows, 0 rows/s");
  EXPECT_EQ(progress_text({.bytes = 2'000'000, .seconds = 1}, 200), "2.0 MB read, 2.0 MB/s") << "an unknown fraction";
  EXPECT_EQ(progress_text({.fraction = 0, .bytes = 1, .seconds = 2}, 200),
            "[--------------------] 0 %, 1 B read, 0 B/s");
  EXPECT_EQ(progress_text({.fraction = 0.09, .rows = 1, .seconds = 1}, 200),
            "[#-------------------] 9 %, 1 rows, 1 rows/s")
      << "too early to tell the time that is left";
}

TEST(Progress, not_all_of_the_work_is_done_before_the_end) {
  EXPECT_EQ(progress_text({.fraction = 0.999, .rows = 5, .seconds = 1}, 10), "99 %");
}

TEST(Progress, parts_are_left_out_where_the_line_would_be_too_long) {
  Progress progress = several;
  progress.file = "a/very/long/name/of/a/file.csv";
  std::size_t before = 200;
  for (std::size_t width = 100; width > 0; --width) {
    const std::string text = progress_text(progress, width);
    EXPECT_LE(text.size(), width);
    EXPECT_LE(text.size(), before);
    before = text.size();
  }
  EXPECT_EQ(progress_text(progress, 40), "41 %, 0:14 left, 12 of 30 files");
  EXPECT_EQ(progress_text(progress, 20), "41 %, 0:14 left");
  EXPECT_EQ(progress_text(progress, 4), "41 %");
  EXPECT_EQ(progress_text(progress, 2), "41");
}

TEST(Progress, sizes_have_at_most_three_digits) {
  EXPECT_EQ(progress_text({.bytes = 999'499, .seconds = 1}, 80), "999 kB read, 999 kB/s");
  EXPECT_EQ(progress_text({.bytes = 999'500, .seconds = 1}, 80), "1.0 MB read, 1.0 MB/s");
  EXPECT_EQ(progress_text({.bytes = 99'499, .seconds = 1}, 80), "99.5 kB read, 99.5 kB/s");
  EXPECT_EQ(progress_text({.bytes = 99'500, .seconds = 1}, 80), "100 kB read, 100 kB/s");
}

/// Blocks of one row.
tcb::Source<tcb::SampleBlock> rows(int count) {
  return [count]() mutable -> std::optional<tcb::SampleBlock> {
    if (count-- == 0) return std::nullopt;
    tcb::SampleBlock block;
    block.parts.push_back({{}, 0, 1});
    return block;
  };
}

TEST(Progress, the_fraction_is_that_of_rows_for_the_bytes_read) {
  tcb::Report report({.progress = true});
  report.expect(1, 100);
  const auto file = report.begin_file("a.csv", 100);
  std::vector<std::string> parts{std::string(25, 'a'), std::string(75, 'b')};
  const auto bytes = file->observe_bytes([&parts]() -> std::optional<std::string> {
    if (parts.empty()) return std::nullopt;
    std::string part = parts.front();
    parts.erase(parts.begin());
    return part;
  });
  EXPECT_FALSE(file->fraction()) << "the number of rows is unknown";
  (void)bytes();
  std::uint64_t count = 0;
  const auto samples = file->observe_rows(
      rows(5), [] { return 4.0; }, count);
  (void)samples();
  EXPECT_EQ(file->fraction(), 0.25 * 0.25);
  (void)samples();
  (void)bytes();
  EXPECT_EQ(file->fraction(), 0.5);
  for (int i = 0; i < 3; ++i) (void)samples();
  EXPECT_EQ(file->fraction(), 1.0) << "more rows than expected";
  EXPECT_EQ(count, 5U);
}

std::string errors_of(const tcb::Verbosity& verbosity) {
  testing::internal::CaptureStderr();
  tcb::Report report(verbosity);
  report.note("a.csv", {"an important note", true});
  report.note("a.csv", {"a note"});
  report.warning("old.csv", {"a warning"});
  return testing::internal::GetCapturedStderr();
}

TEST(Report, notes_and_warnings_depend_on_the_verbosity) {
  const std::string warning = "old.csv: warning: a warning\n", important = "a.csv: note: an important note\n";
  EXPECT_EQ(errors_of({}), important + warning);
  EXPECT_EQ(errors_of({.notes = true}), important + "a.csv: note: a note\n" + warning);
  EXPECT_EQ(errors_of({.quiet = true}), "");
}

}  // namespace
