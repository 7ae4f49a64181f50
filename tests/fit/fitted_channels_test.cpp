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

Job job_within(std::vector<Tolerance> tolerances) {
  Job job;
  job.fit.tolerances = std::move(tolerances);
  return job;
}

std::string refusal(const Schema& schema, const Job& job) {
  try {
    (void)fitted_channels(schema, job);
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

TEST(FittedChannels, a_distance_is_that_of_the_metric) {
  Job job = job_within({{"", 0.1}, {"heading", 2}});
  const FittedChannels fitted = fitted_channels(schema_of_drive(), job);
  EXPECT_THAT(fitted.names, ElementsAre("x", "y", "heading"));
  ASSERT_EQ(fitted.groups.size(), 2U);
  EXPECT_THAT(fitted.groups[0].channels, ElementsAre(2));
  EXPECT_EQ(fitted.groups[0].tolerance, 2);
  EXPECT_THAT(fitted.groups[1].channels, ElementsAre(0, 1));
  EXPECT_EQ(refusal(schema_of_drive(), job_within({{"", 0.1}})), channel_without_tolerance("heading").message());
  job.curve.metric = TextSetting{"x"};
  EXPECT_EQ(refusal(schema_of_drive(), job), channel_without_tolerance("y").message());
  job.fit.tolerances.push_back({"y", 1});
  EXPECT_THAT(fitted_channels(schema_of_drive(), job).groups[2].channels, ElementsAre(0));
}

TEST(FittedChannels, rotations_have_a_limit_of_their_own) {
  Job job = job_within({{"", 0.1}, {"heading", 2}});
  job.fit.angle = 0.01;
  const FittedChannels fitted = fitted_channels(schema_of_drive(), job);
  EXPECT_EQ(fitted.names.size(), 7U);
  EXPECT_EQ(fitted.groups.back().angle, 0.01);
  EXPECT_THAT(fitted.groups.back().channels, ElementsAre(3, 4, 5, 6));
  EXPECT_LT(fitted.groups.back().tolerance, 0.005);
  job.fit.tolerances.push_back({"qx", 1});
  EXPECT_EQ(refusal(schema_of_drive(), job),
            "--fit: " + tolerance_of_unknown_channel("qx", {"x", "y", "heading"}).message());
}

}  // namespace
}  // namespace tcb
