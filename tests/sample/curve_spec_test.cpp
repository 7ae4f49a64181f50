// The settings of a curve: what names and texts become, and what is refused.
#include "sample/curve_spec.hpp"

#include <gtest/gtest.h>

#include <string>

#include "error.hpp"
#include "option_names.hpp"

namespace tcb {
namespace {

CurveSettings ends(std::string text) {
  CurveSettings settings;
  settings.ends = TextSetting{std::move(text), {option::ends}};
  return settings;
}

std::string refusal(const CurveSettings& settings, const std::vector<std::string>& channels = {"x", "y"}) {
  try {
    (void)make_spec(settings, channels);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.message();
  }
  return "nothing";
}

TEST(MakeSpec, a_preset_sets_both_rules_and_options_override_each) {
  CurveSettings settings;
  settings.preset = TextSetting{"vtk"};
  EXPECT_EQ(name_of(make_spec(settings).rules.tangents), "interval");
  EXPECT_EQ(name_of(make_spec(settings).rules.start.rule), "zero");
  settings.ends = TextSetting{"chord,cry"};
  EXPECT_EQ(name_of(make_spec(settings).rules.start.rule), "chord");
  EXPECT_EQ(name_of(make_spec(settings).rules.end.rule), "cry");
}

TEST(MakeSpec, velocities_have_a_number_for_each_channel) {
  const auto rules = make_spec(ends("velocity=1:-2,velocity=3,4")).rules;
  EXPECT_EQ(rules.start.velocity, (std::vector<double>{1, -2}));
  EXPECT_EQ(rules.end.velocity, (std::vector<double>{3, 4}));
  EXPECT_EQ(refusal(ends("velocity=1,zero")),
            "--ends: the velocity has 1 numbers; expected 2, one for each of x, y; correct it");
}

TEST(MakeSpec, unknown_names_are_refused_with_the_nearest) {
  CurveSettings settings;
  settings.preset = TextSetting{"gtee"};
  EXPECT_TRUE(refusal(settings).ends_with("; did you mean gte?")) << refusal(settings);
  EXPECT_TRUE(refusal(ends("naturel")).ends_with("; did you mean natural?"));
  settings = {};
  settings.metric = TextSetting{"z", {option::metric}};
  EXPECT_EQ(refusal(settings),
            "--metric: there is no channel \"z\"; expected some of x, y, by name or by number from 1");
}

TEST(MakeSpec, contradictions_are_refused) {
  CurveSettings settings = ends("zero");
  settings.closed = Setting<bool>{true, {option::closed}};
  EXPECT_EQ(refusal(settings), "--ends: a closed curve has no ends; remove --ends or --closed");
  EXPECT_EQ(refusal(ends("zero,zero,zero")),
            "--ends: there are 3 rules; expected one for both ends, or one for each end; remove some");
  EXPECT_EQ(refusal(ends("zero=3")), "--ends: \"zero=3\" has a value; expected only a rule; remove it");
  settings = {};
  settings.period = TextSetting{"-1", {option::period}};
  EXPECT_EQ(refusal(settings), "--period: \"-1\" is not a period; expected a decimal or a ratio above 0, such as 7.5");
}

TEST(MakeSpec, an_error_about_a_setting_of_a_file_is_at_its_position) {
  CurveSettings settings;
  settings.ends = TextSetting{"zero", {"ends", {"", 7, 3}}};
  settings.closed = Setting<bool>{true, {"closed", {"", 8, 3}}};
  try {
    (void)make_spec(settings);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::data);
    EXPECT_EQ(error.position().line, 7U);
    EXPECT_EQ(error.message(), "ends: a closed curve has no ends; remove ends or closed");
  }
  settings.closed->origin = {option::closed};
  EXPECT_EQ(refusal(settings), "ends: a closed curve has no ends; remove ends or --closed") << "a wrong command line";
}

TEST(Merged, settings_of_the_command_line_replace_those_of_the_input) {
  CurveSettings of_input;
  of_input.preset = TextSetting{"vtk"};
  of_input.tangents = TextSetting{"uniform"};
  of_input.closed = Setting<bool>{true};
  of_input.period = TextSetting{"3"};
  CurveSettings typed;
  EXPECT_EQ(merged(typed, of_input).tangents->value, "uniform");
  EXPECT_EQ(merged(typed, of_input).period->value, "3");
  typed.tangents = TextSetting{"kb1984"};
  EXPECT_EQ(merged(typed, of_input).tangents->value, "kb1984");
  EXPECT_EQ(merged(typed, of_input).preset->value, "vtk");
  typed = {};
  typed.preset = TextSetting{"gte"};
  EXPECT_FALSE(merged(typed, of_input).tangents) << "a preset sets all rules";
  typed.closed = Setting<bool>{false};
  EXPECT_FALSE(merged(typed, of_input).period);
}

}  // namespace
}  // namespace tcb
