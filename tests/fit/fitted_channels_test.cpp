// Fitted channels: their limits, and what is refused.
#include "fit/fitted_channels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error.hpp"
#include "fit/errors.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

/// Two numbers, an angle, and a rotation.
Schema schema_of_drive() {
  Schema schema;
  schema.channels = {"x", "y", "heading", "qx", "qy", "qz", "qw"};
  schema.angles = {{2, true}};
  schema.rotations = {{{{{3, 4, 5, 6}}}}};
  return schema;
}

FitOptions within(std::vector<Tolerance> tolerances) {
  FitOptions options;
  options.tolerances = std::move(tolerances);
  return options;
}

std::string refusal(const Schema& schema, const FitOptions& options, const CurveSettings& rules = {}) {
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
  EXPECT_EQ(refusal(schema_of_drive(), within({{"", 0.1}})), channel_without_tolerance("heading").message());
  CurveSettings rules;
  rules.metric = TextSetting{"x"};
  EXPECT_EQ(refusal(schema_of_drive(), options, rules), channel_without_tolerance("y").message());
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
  EXPECT_EQ(refusal(schema_of_drive(), options),
            "--fit: " + tolerance_of_unknown_channel("qx", {"x", "y", "heading"}).message());
}

}  // namespace
}  // namespace tcb
