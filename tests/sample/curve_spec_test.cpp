// The settings of a curve: what names become, and those of a command line and of an input together.
#include "sample/curve_spec.hpp"
#include "tcb/spline/rules.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

TEST(MakeSpec, a_preset_sets_both_rules_and_options_override_each) {
  CurveSettings settings;
  settings.preset = spline::Preset::vtk;
  EXPECT_EQ(name_of(make_spec(settings).rules.tangents), "interval");
  EXPECT_EQ(name_of(make_spec(settings).rules.start.rule), "zero");
  settings.ends = {ends_in("chord,cry"), {}};
  EXPECT_EQ(name_of(make_spec(settings).rules.start.rule), "chord");
  EXPECT_EQ(name_of(make_spec(settings).rules.end.rule), "cry");
}

TEST(Merged, settings_of_the_command_line_replace_those_of_the_input) {
  CurveSettings of_input;
  of_input.preset = spline::Preset::vtk;
  of_input.tangents = spline::TangentRule::uniform;
  of_input.closed = Setting<bool>{true};
  of_input.period = {period_in("3"), {}};
  CurveSettings typed;
  EXPECT_EQ(merged(typed, of_input).tangents, spline::TangentRule::uniform);
  EXPECT_EQ(merged(typed, of_input).period->value.value, Rational(3));
  typed.tangents = spline::TangentRule::kb1984;
  EXPECT_EQ(merged(typed, of_input).tangents, spline::TangentRule::kb1984);
  EXPECT_EQ(merged(typed, of_input).preset, spline::Preset::vtk);
  typed = {};
  typed.preset = spline::Preset::gte;
  EXPECT_FALSE(merged(typed, of_input).tangents) << "a preset sets all rules";
  typed.closed = Setting<bool>{false};
  EXPECT_FALSE(merged(typed, of_input).period);
}

}  // namespace
}  // namespace tcb
