// Fitting: the columns of keys, what is refused, and the report.
#include "fit/fitting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Input input_of(std::vector<std::string> channels) {
  Input input;
  input.schema.time.is_given = true;
  input.schema.channels = std::move(channels);
  return input;
}

FitOptions within(std::vector<Tolerance> tolerances) {
  FitOptions options;
  options.tolerances = std::move(tolerances);
  return options;
}

std::string refusal(const Input& input, const FitOptions& options) {
  try {
    (void)keys_of_fit(input, {}, options);
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

TEST(Fitting, columns_carry_what_the_keys_do) {
  FitOptions options = within({{"", 1}});
  EXPECT_THAT(keys_of_fit(input_of({"x"}), {}, options).channels, ElementsAre("x", "tension", "bias"));
  EXPECT_THAT(keys_of_fit(input_of({"x", "y"}), {}, options).channels,
              ElementsAre("x", "y", "tension_x", "tension_y", "bias_x", "bias_y"));
  options.corner = 30;
  EXPECT_THAT(keys_of_fit(input_of({"x"}), {}, options).channels, ElementsAre("x", "tension", "continuity", "bias"));
  options.keys = FitKeys::hermite;
  EXPECT_THAT(keys_of_fit(input_of({"x"}), {}, options).channels, ElementsAre("x", "x_vin", "x_vout"));
  options.corner = {};
  EXPECT_THAT(keys_of_fit(input_of({"x"}), {}, options).channels, ElementsAre("x", "x_v"));
}

TEST(Fitting, rotations_are_left_out) {
  Input input = input_of({"x", "qx", "qy", "qz", "qw"});
  input.schema.rotations = {{{{{1, 2, 3, 4}}}}};
  EXPECT_THAT(keys_of_fit(input, {}, within({{"", 1}})).channels, ElementsAre("x", "tension", "bias"));
  input.schema.channels[0] = "q0";
  input.schema.rotations = {{{{{1, 2, 3, 4}}}}, {{{{0, 0, 0, 0}}}}};
  EXPECT_TRUE(refusal(input, within({{"", 1}})).starts_with("there are only rotations, which have no distances"));
}

TEST(Fitting, inputs_without_samples_are_refused) {
  const FitOptions options = within({{"", 1}});
  Input input = input_of({"x", "y"});
  EXPECT_EQ(refusal(input, options), "");
  EXPECT_EQ(refusal(input, within({{"x", 1}, {"", 2}})), "");
  input.facts.roles = {"tension"};
  input.schema.time.is_given = false;
  EXPECT_THAT(refusal(input, options), HasSubstr("there is no time column"));
}

TEST(Fitting, reports_add_up) {
  FitReport report;
  report.add({100, 10, 6, 0.5, 17});
  report.add({50, 5, 4, 0.25, 120});
  const Note note = note_of(report, within({{"", 0.1}}));
  EXPECT_TRUE(note.is_important);
  EXPECT_EQ(note.text,
            "150 samples, 15 keys, 10 times fewer; largest distance 0.05, on line 17; at least 10 keys are needed");
  EXPECT_THAT(note_of(report, within({{"x", 0.1}})).text, testing::HasSubstr("largest distance 0.5 of the tolerance"));
}

/// Two numbers, an angle, and a rotation.
Schema schema_of_drive() {
  Schema schema;
  schema.channels = {"x", "y", "heading", "qx", "qy", "qz", "qw"};
  schema.angles = {{{2, true}}};
  schema.rotations = {{{{{3, 4, 5, 6}}}}};
  return schema;
}

std::string channels_refusal(const Schema& schema, const FitOptions& options, const CurveSettings& rules = {}) {
  try {
    (void)fitted_channels(schema, rules, options);
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

TEST(FittedChannels, a_distance_is_that_of_the_metric) {
  FitOptions options = within({{"", 0.1}, {"heading", 2}});
  const FittedChannels fitted = fitted_channels(schema_of_drive(), {}, options);
  EXPECT_THAT(fitted.names, ElementsAre("x", "y", "heading"));
  ASSERT_EQ(fitted.groups.size(), 2U);
  EXPECT_THAT(fitted.groups[0].channels, ElementsAre(2));
  EXPECT_EQ(fitted.groups[0].tolerance, 2);
  EXPECT_THAT(fitted.groups[1].channels, ElementsAre(0, 1));
  EXPECT_THAT(channels_refusal(schema_of_drive(), within({{"", 0.1}})), HasSubstr("\"heading\" has no tolerance"));
  CurveSettings rules;
  rules.metric = {{"x"}, {}};
  EXPECT_THAT(channels_refusal(schema_of_drive(), options, rules), HasSubstr("\"y\" has no tolerance"));
  options.tolerances.push_back({"y", 1});
  EXPECT_THAT(fitted_channels(schema_of_drive(), rules, options).groups[2].channels, ElementsAre(0));
}

TEST(FittedChannels, rotations_have_a_limit_of_their_own) {
  FitOptions options = within({{"", 0.1}, {"heading", 2}});
  options.angle = 0.01;
  const FittedChannels fitted = fitted_channels(schema_of_drive(), {}, options);
  EXPECT_EQ(fitted.names.size(), 7U);
  EXPECT_EQ(fitted.groups.back().angle, 0.01);
  EXPECT_THAT(fitted.groups.back().channels, ElementsAre(3, 4, 5, 6));
  EXPECT_LT(fitted.groups.back().tolerance, 0.005);
  options.tolerances.push_back({"qx", 1});
  EXPECT_THAT(channels_refusal(schema_of_drive(), options), HasSubstr("expected one of x, y, heading"));
}

}  // namespace
}  // namespace tcb
