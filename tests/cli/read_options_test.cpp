// Reading of options: the words of a command line, and the errors of words that are wrong.

#include <fmt/format.h>

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

TEST(CommandLine, guessed_options_name_those_that_are_meant) {
  EXPECT_EQ(refusal({"--format=json"}),
            "unknown option --format; did you mean -f for the output, or -i for the input? (--help lists all options)");
  EXPECT_THAT(refusal({"--loop"}), StartsWith("unknown option --loop; did you mean --closed or --extrapolate repeat?"));
  EXPECT_THAT(refusal({"--dt", "1"}), StartsWith("unknown option --dt; did you mean --step?"));
  EXPECT_THAT(refusal({"--linear"}), StartsWith("unknown option --linear; did you mean --tangents linear?"));
  EXPECT_THAT(refusal({"--bias", "1"}), StartsWith("unknown option --bias; did you mean --tcb?"));
}

TEST(CommandLine, errors_of_syntax_name_the_option) {
  EXPECT_EQ(refusal({"-s", "1", "-s", "2"}), "--step: the option is repeated; expected it once; remove all but one");
  EXPECT_THAT(refusal({"-n", "2", ""}), StartsWith("the name of a file is empty;"));
}

/// The words that begin with each name of each option with a value; the option and the rest of a word follow.
template <class Test>
void for_each_valued_name(Test test) {
  for (const OptionRow& row : option_table()) {
    if (row.kind == ValueKind::flag) continue;
    for (const std::string_view name : row.all_names()) test(std::string(row.name), std::string(name));
  }
}

TEST(CommandLine, no_option_takes_an_empty_value_or_the_next_word_for_it) {
  for_each_valued_name([](const std::string& option, const std::string& name) {
    const auto message = StartsWith(option + ": the value is empty;");
    EXPECT_THAT(refusal({name, ""}), message);
    EXPECT_THAT(refusal({name, "", "keys.csv"}), message);
    EXPECT_THAT(refusal({name + "="}), message);
    EXPECT_THAT(refusal({name + "=", "keys.csv"}), message);
    EXPECT_THAT(refusal({"-n", "2", "keys.csv", name + "=", "1"}), message);
    if (name.starts_with("--")) return;
    EXPECT_THAT(refusal({"-q" + name.substr(1) + "=", "keys.csv"}), message);
  });
}

TEST(CommandLine, no_option_takes_another_option_for_its_value) {
  for_each_valued_name([](const std::string& option, const std::string& name) {
    if (row_of(option).kind == ValueKind::attached) return;
    for (const char* const next : {"--golden", "--count", "--count=3", "-n", "-n3", "-qn3", "--"}) {
      EXPECT_THAT(refusal({name, next, "keys.csv"}),
                  StartsWith(fmt::format("{}: the value is missing before {};", option, next)));
    }
    EXPECT_THAT(refusal({name}), StartsWith(option + ": the value is missing;"));
  });
}

TEST(CommandLine, a_value_may_look_like_an_option_in_its_own_word) {
  EXPECT_EQ(stepped({"--output=--count"}).files.outputs.file, "--count");
  EXPECT_EQ(stepped({"-o-n"}).files.outputs.file, "-n");
  EXPECT_EQ(stepped({"--from", "-0"}).samples.request.from, Rational(0));
  EXPECT_EQ(stepped({"--comment", "-"}).keys.input.delimited.comment, "-");
  EXPECT_EQ(stepped({"-o", "-"}).files.outputs.file, "-");
}

TEST(CommandLine, the_value_of_a_letter_may_follow_an_equals_sign) {
  EXPECT_EQ(stepped({"-o=a.csv"}).files.outputs.file, "a.csv");
  EXPECT_EQ(stepped({"-qo=a.csv"}).files.outputs.file, "a.csv");
  EXPECT_EQ(stepped({"-d=="}).keys.input.delimited.delimiter, '=');
  EXPECT_THAT(job_of({"-n", "2", "--", "-o="}).files.files, ElementsAre("-o="));
}

}  // namespace
}  // namespace tcb
