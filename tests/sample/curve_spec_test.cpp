// The settings of a curve: what names and texts become, and what is refused.
#include "sample/build.hpp"

#include <gtest/gtest.h>

#include <string>

#include "cli/remedies.hpp"
#include "error.hpp"

namespace tcb {
namespace {

CurveSettings ends(std::string text) {
  CurveSettings settings;
  settings.ends = std::move(text);
  return settings;
}

std::string refusal(const CurveSettings& settings, const std::vector<std::string>& channels = {"x", "y"}) {
  try {
    (void)make_spec(settings, channels);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error_message(error);
  }
  return "nothing";
}

TEST(MakeSpec, a_preset_sets_both_rules_and_options_override_each) {
  CurveSettings settings;
  settings.preset = "vtk";
  EXPECT_EQ(name_of(make_spec(settings).rules.tangents), "interval");
  EXPECT_EQ(name_of(make_spec(settings).rules.start.rule), "zero");
  settings.ends = "chord,cry";
  EXPECT_EQ(name_of(make_spec(settings).rules.start.rule), "chord");
  EXPECT_EQ(name_of(make_spec(settings).rules.end.rule), "cry");
}

TEST(MakeSpec, velocities_have_a_number_for_each_channel) {
  const auto rules = make_spec(ends("velocity=1:-2,velocity=3,4")).rules;
  EXPECT_EQ(rules.start.velocity, (std::vector<double>{1, -2}));
  EXPECT_EQ(rules.end.velocity, (std::vector<double>{3, 4}));
  EXPECT_EQ(refusal(ends("velocity=1,zero")),
            "--ends: a velocity of 1 numbers; expected 2, one for each of x, y; correct it");
}

TEST(MakeSpec, unknown_names_are_refused_with_the_nearest) {
  CurveSettings settings;
  settings.preset = "gtee";
  EXPECT_TRUE(refusal(settings).ends_with("; did you mean gte?")) << refusal(settings);
  EXPECT_TRUE(refusal(ends("naturel")).ends_with("; did you mean natural?"));
  settings = {};
  settings.metric = "z";
  EXPECT_EQ(refusal(settings), "--metric: no channel \"z\"; expected some of x, y, or numbers from 1");
}

TEST(MakeSpec, contradictions_are_refused) {
  CurveSettings settings = ends("zero");
  settings.closed = true;
  EXPECT_EQ(refusal(settings), "--ends has no effect on a closed curve, which has no ends; remove one of them");
  EXPECT_EQ(refusal(ends("zero,zero,zero")),
            "--ends zero,zero,zero: 3 rules; expected one, or one for the start and one for the end");
  EXPECT_EQ(refusal(ends("zero=3")), "--ends zero=3: expected no value for this rule; remove it");
  settings = {};
  settings.period = "-1";
  EXPECT_EQ(refusal(settings), "--period \"-1\": expected a decimal or a ratio above 0, such as 7.5");
}

TEST(Merged, settings_of_the_command_line_replace_those_of_the_input) {
  CurveSettings of_input;
  of_input.preset = "vtk";
  of_input.tangents = "uniform";
  of_input.closed = true;
  of_input.period = "3";
  CurveSettings typed;
  EXPECT_EQ(merged(typed, of_input).tangents, "uniform");
  EXPECT_EQ(merged(typed, of_input).period, "3");
  typed.tangents = "kb1984";
  EXPECT_EQ(merged(typed, of_input).tangents, "kb1984");
  EXPECT_EQ(merged(typed, of_input).preset, "vtk");
  typed = {};
  typed.preset = "gte";
  EXPECT_EQ(merged(typed, of_input).tangents, std::nullopt) << "a preset sets all rules";
  typed.closed = false;
  EXPECT_EQ(merged(typed, of_input).period, std::nullopt);
}

}  // namespace
}  // namespace tcb
