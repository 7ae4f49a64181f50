// Reading of options: the words of a command line, and the errors of words that are wrong.

#include "cli/command_line.hpp"
#include "cli/help.hpp"
#include "cli/options.hpp"
#include "formats/formats.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

TEST(CommandLine, options_and_files_come_in_any_order) {
  const ResampleJob job = job_of({"a.csv", "-s", "0.5", "-", "--output-format=json", "b.csv"});
  EXPECT_THAT(job.files.files, ElementsAre("a.csv", "-", "b.csv"));
  EXPECT_EQ(job.samples.request.step, Rational(1, 2));
  EXPECT_EQ(job.rows.format, find_format("json"));
}

TEST(CommandLine, two_dashes_end_the_options) {
  EXPECT_THAT(job_of({"-n", "2", "--", "-n", "--step"}).files.files, ElementsAre("-n", "--step"));
}

TEST(CommandLine, a_value_may_be_negative) {
  const ResampleJob job = job_of({"-s1", "--from", "-1.5", "--to", "-.5", "--tcb", "-1,0,.5"});
  EXPECT_EQ(job.samples.request.from, Rational(-3, 2));
  EXPECT_EQ(job.samples.request.to, Rational(-1, 2));
  EXPECT_EQ(job.keys.input.keys.tcb, (spline::Tcb<double>{-1, 0, 0.5}));
}

TEST(CommandLine, rate_and_fps_are_one_option) {
  EXPECT_EQ(job_of({"--fps", "24"}).samples.request.step, job_of({"--rate", "24"}).samples.request.step);
}

TEST(CommandLine, a_flag_may_be_repeated_and_tolerances_are_joined) {
  EXPECT_EQ(stepped({"--hex", "--hex"}).rows.notation.kind, Notation::Kind::hex);
  EXPECT_EQ(job_of<CompareJob>({"--check", "a", "--abs", "1", "--abs", "x=2,y=3"}).comparison.abs.size(), 3U);
}

TEST(CommandLine, a_text_is_printed_whatever_other_values_are) {
  EXPECT_THAT(printed_text({"--help"}), StartsWith("Usage: tcbsample"));
  EXPECT_EQ(printed_text({"--help"}), printed_text({"--help", "a.csv", "--step", "x", "--version"}));
  EXPECT_EQ(printed_text({"--help"}), printed_text({"--generate", "x", "--help"}));
  EXPECT_EQ(printed_text({"-h"}), short_help_text());
  EXPECT_EQ(printed_text({"-qh", "--count=0"}), short_help_text());
  EXPECT_THAT(printed_text({"-V", "--count=0"}), StartsWith("tcbsample "));
  EXPECT_THAT(printed_text({"--generate", "fish"}), StartsWith("function "));
  EXPECT_THAT(printed_text({"--list-presets"}), StartsWith("PRESET "));
  EXPECT_THROW(printed_text({"-n", "2"}), std::bad_variant_access);
}

TEST(CommandLine, an_unknown_option_is_refused_with_the_nearest_one) {
  EXPECT_THAT(refusal({"--stop=1"}), StartsWith("unknown option --stop;"));
  EXPECT_EQ(refusal({"--frobnicate"}), "unknown option --frobnicate (--help lists all options)");
  EXPECT_EQ(refusal({"--Step", "1"}), "unknown option --Step; did you mean --step? (--help lists all options)");
  EXPECT_EQ(refusal({"-s", "1", "-x"}), "unknown option -x (--help lists all options)");
}

TEST(CommandLine, errors_of_syntax_name_the_option) {
  EXPECT_EQ(refusal({"-s", "1", "-s", "2"}), "--step: the option is repeated; expected it once; remove all but one");
  EXPECT_THAT(refusal({"-n", "2", ""}), StartsWith("the name of a file is empty;"));
}

TEST(CommandLine, no_option_takes_an_empty_value) {
  for (const OptionRow& row : option_table()) {
    if (row.kind == ValueKind::flag) continue;
    const std::string name(row.name);
    EXPECT_THAT(refusal({name, ""}), StartsWith(name + ": the value is empty;"));
    EXPECT_THAT(refusal({name + "="}), StartsWith(name + ": the value is missing;"));
  }
}

}  // namespace
}  // namespace tcb
