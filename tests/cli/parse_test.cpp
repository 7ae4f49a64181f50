// Command line: from words to options, texts instead of jobs, and errors of syntax.
#include "cli/command_line.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

TEST(CommandLine, options_and_files_come_in_any_order) {
  const Job job = job_of({"a.csv", "-s", "0.5", "-", "--output-format=json", "b.csv"});
  EXPECT_THAT(job.files, ElementsAre("a.csv", "-", "b.csv"));
  EXPECT_EQ(job.sampling.step, Rational(1, 2));
  EXPECT_EQ(job.output_format, FormatId::json);
}

TEST(CommandLine, two_dashes_end_the_options) {
  EXPECT_THAT(job_of({"-n", "2", "--", "-n", "--step"}).files, ElementsAre("-n", "--step"));
}

TEST(CommandLine, a_value_may_be_negative) {
  const Job job = job_of({"-s1", "--from", "-1.5", "--to", "-.5", "--tcb", "-1,0,.5"});
  EXPECT_EQ(job.sampling.from, Rational(-3, 2));
  EXPECT_EQ(job.sampling.to, Rational(-1, 2));
  EXPECT_EQ(job.input.tcb, (spline::Tcb<double>{-1, 0, 0.5}));
}

TEST(CommandLine, rate_and_fps_are_one_option) {
  EXPECT_EQ(job_of({"--fps", "24"}).sampling.step, job_of({"--rate", "24"}).sampling.step);
}

TEST(CommandLine, a_flag_may_be_repeated_and_tolerances_are_joined) {
  EXPECT_EQ(stepped({"--hex", "--hex"}).notation.kind, Notation::Kind::hex);
  EXPECT_EQ(job_of({"--check", "a", "--abs", "1", "--abs", "x=2,y=3"}).comparison->abs.size(), 3U);
}

TEST(CommandLine, a_text_is_printed_whatever_other_values_are) {
  EXPECT_THAT(parsed({"--help"}).text.value_or(""), StartsWith("Usage: tcbsample"));
  EXPECT_EQ(parsed({"-h"}).text, parsed({"--help", "a.csv", "--step", "x", "--version"}).text);
  EXPECT_EQ(parsed({"-h"}).text, parsed({"--generate", "x", "--help"}).text);
  EXPECT_THAT(parsed({"-V", "--count=0"}).text.value_or(""), StartsWith("tcbsample "));
  EXPECT_THAT(parsed({"--generate", "fish"}).text.value_or(""), StartsWith("complete "));
  EXPECT_THAT(parsed({"--list-presets"}).text.value_or(""), StartsWith("PRESET "));
  EXPECT_FALSE(parsed({"-n", "2"}).text);
}

TEST(CommandLine, an_unknown_option_is_refused_with_the_nearest_one) {
  EXPECT_EQ(refusal({"--stop", "1"}), "unknown option --stop; did you mean --step? (--help lists all options)");
  EXPECT_EQ(refusal({"--stop=1"}), "unknown option --stop; did you mean --step? (--help lists all options)");
  EXPECT_EQ(refusal({"--frobnicate"}), "unknown option --frobnicate (--help lists all options)");
  EXPECT_EQ(refusal({"-s", "1", "-x"}), "unknown option -x (--help lists all options)");
}

TEST(CommandLine, errors_of_syntax_name_the_option) {
  EXPECT_EQ(refusal({"--step"}), "--step: its value is missing; expected one as in --help; give it after the option");
  EXPECT_EQ(refusal({"-s", "1", "-s", "2"}), "--step is given more than once; expected it once; take one out");
  EXPECT_EQ(refusal({"-n", "2", "--hex=false"}), "--hex takes no value; take the value out");
  EXPECT_THAT(refusal({"-n", "2", ""}), StartsWith("an empty file name;"));
}

TEST(CommandLine, no_option_takes_an_empty_value) {
  for (const OptionRow& row : option_table()) {
    if (row.kind == ValueKind::flag) continue;
    const std::string name(row.long_name());
    EXPECT_THAT(refusal({name, ""}), StartsWith(name + ": an empty value;"));
    EXPECT_THAT(refusal({name + "="}), StartsWith(name + ": its value is missing;"));
  }
}

}  // namespace
}  // namespace tcb
