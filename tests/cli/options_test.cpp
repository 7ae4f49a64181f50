// The command line: how arguments become what was typed, and the refusal of those that are unknown.
#include "cli/options.hpp"

#include <gmock/gmock.h>

#include "error.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

Invocation parsed(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "tcbsample");
  return parse(static_cast<int>(arguments.size()), arguments.data());
}

std::string refusal(std::vector<const char*> arguments) {
  try {
    parsed(std::move(arguments));
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.what();
  }
  return "no error";
}

TEST(Options, options_and_files_come_in_any_order) {
  const Job plan = parsed({"a.csv", "-s", "0.5", "-", "--output-format=json", "b.csv"}).plan;
  EXPECT_THAT(plan.files, ElementsAre("a.csv", "-", "b.csv"));
  EXPECT_EQ(plan.sampling.step, Rational(1, 2));
  EXPECT_EQ(plan.output_format, FormatId::json);
}

TEST(Options, two_dashes_end_the_options) {
  EXPECT_THAT(parsed({"-n", "2", "--", "-n", "--step"}).plan.files, ElementsAre("-n", "--step"));
}

TEST(Options, a_value_may_be_negative) {
  const Job plan = parsed({"-s1", "--from", "-1.5", "--to", "-.5", "--tcb", "-1,0,.5"}).plan;
  EXPECT_EQ(plan.sampling.from, Rational(-3, 2));
  EXPECT_EQ(plan.sampling.to, Rational(-1, 2));
  EXPECT_EQ(plan.input.tcb, (spline::Tcb<double>{-1, 0, 0.5}));
}

TEST(Options, rate_and_fps_are_one_option) {
  EXPECT_EQ(parsed({"--fps", "24"}).plan.sampling.step, parsed({"--rate", "24"}).plan.sampling.step);
}

TEST(Options, help_version_and_generated_texts_need_no_plan) {
  EXPECT_THAT(parsed({"--help"}).text.value_or(""), testing::StartsWith("Usage: tcbsample"));
  EXPECT_EQ(parsed({"-h"}).text, parsed({"--help", "a.csv", "--step", "x"}).text);
  EXPECT_THAT(parsed({"-V"}).text.value_or(""), testing::StartsWith("tcbsample "));
  EXPECT_THAT(parsed({"--generate", "fish"}).text.value_or(""), testing::StartsWith("complete "));
  EXPECT_FALSE(parsed({"-n", "2"}).text);
}

TEST(Options, an_unknown_option_is_refused_with_the_nearest_one) {
  EXPECT_EQ(refusal({"--stop", "1"}), "unknown option --stop; did you mean --step? (--help lists all options)");
  EXPECT_EQ(refusal({"--stop=1"}), "unknown option --stop; did you mean --step? (--help lists all options)");
  EXPECT_EQ(refusal({"--frobnicate"}), "unknown option --frobnicate (--help lists all options)");
  EXPECT_EQ(refusal({"-s", "1", "-x"}), "unknown option -x (--help lists all options)");
}

TEST(Options, an_option_without_its_value_or_given_twice_is_refused_by_name) {
  EXPECT_THAT(refusal({"--step"}), testing::AllOf(testing::StartsWith("--step"), testing::EndsWith("; see --help")));
  EXPECT_EQ(refusal({"-s", "1", "-s", "2"}), "--step is there more than once; expected it once; take one out");
}

TEST(Options, what_the_plan_refuses_is_refused_here) {
  EXPECT_THAT(refusal({"a.csv"}), testing::StartsWith("nothing says where the samples are"));
}

}  // namespace
}  // namespace tcb
