// Progress: the line of progress, notes and warnings.
#include "app/progress.hpp"

#include <gtest/gtest.h>

#include <string>

#include "cli/remedies.hpp"

namespace {

using tcb::progress_text;

TEST(Report, the_line_shows_the_progress) {
  EXPECT_EQ(progress_text(12, 30, 1'200'000'000, 2'900'000'000, 1234, 10.0),
            "41 %, 12 of 30 files, 1.2 GB of 2.9 GB, 1,234 rows, 120 MB/s, 0:14 left");
  EXPECT_EQ(progress_text(0, 1, 500, 1000, 0, 7200.0), "50 %, 500 B of 1.0 kB, 0 B/s, 2:00:00 left");
}

TEST(Report, an_unknown_remaining_time_is_omitted) {
  EXPECT_EQ(progress_text(0, 1, 2'000'000, 0, 0, 1.0), "2.0 MB, 2.0 MB/s");
  EXPECT_EQ(progress_text(0, 1, 2'000'000, 2'000'000, 1'000'000, 2.0), "100 %, 2.0 MB, 1,000,000 rows, 1.0 MB/s");
  EXPECT_EQ(progress_text(0, 2, 0, 1000, 0, 2.0), "0 %, 0 of 2 files, 0 B of 1.0 kB, 0 B/s");
}

TEST(Report, sizes_have_at_most_three_digits) {
  EXPECT_EQ(progress_text(0, 1, 999'499, 0, 0, 1.0), "999 kB, 999 kB/s");
  EXPECT_EQ(progress_text(0, 1, 999'500, 0, 0, 1.0), "1.0 MB, 1.0 MB/s");
  EXPECT_EQ(progress_text(0, 1, 99'499, 0, 0, 1.0), "99.5 kB, 99.5 kB/s");
  EXPECT_EQ(progress_text(0, 1, 99'500, 0, 0, 1.0), "100 kB, 100 kB/s");
}

std::string errors_of(const tcb::Verbosity& verbosity) {
  testing::internal::CaptureStderr();
  tcb::Report report(verbosity, {tcb::error_text, tcb::note_text});
  report.note("a.csv", {tcb::NoteCode::ignored_columns, {std::vector<std::string>{"note, extra", "b"}}});
  report.note("a.csv", {tcb::NoteCode::unchosen_columns, {std::vector<std::string>{"c"}}});
  report.warning("old.csv", {tcb::NoteCode::other_program, {"tcbsample 1", "tcbsample 2"}});
  return testing::internal::GetCapturedStderr();
}

TEST(Report, notes_and_warnings_depend_on_the_verbosity) {
  const std::string warning =
      "old.csv: warning: made by tcbsample 1; this is tcbsample 2, whose last digits may differ\n";
  const std::string loss =
      "a.csv: note: ignored: note, extra, b; --columns gives them roles, as in carry=NAME or position=NAME:NAME\n";
  EXPECT_EQ(errors_of({}), loss + warning);
  EXPECT_EQ(errors_of({.notes = true}), loss + "a.csv: note: ignored, as --columns chooses others: c\n" + warning);
  EXPECT_EQ(errors_of({.quiet = true}), "");
}

}  // namespace
