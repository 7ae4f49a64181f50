// Fitting: the columns of keys, what is refused, and the report.
#include "fit/fitting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error.hpp"
#include "fit/errors.hpp"
#include "sample/errors.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

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
  EXPECT_EQ(refusal(input, within({{"", 1}})), only_rotations().message());
}

TEST(Fitting, inputs_without_samples_are_refused) {
  const FitOptions options = within({{"", 1}});
  Input input = input_of({"x", "y"});
  EXPECT_EQ(refusal(input, options), "");
  EXPECT_EQ(refusal(input, within({{"x", 1}})), channel_without_tolerance("y").message());
  EXPECT_EQ(refusal(input, within({{"x", 1}, {"z", 1}})),
            "--fit: " + tolerance_of_unknown_channel("z", {"x", "y"}).message());
  EXPECT_EQ(refusal(input, within({{"x", 1}, {"", 2}})), "");
  input.facts.roles = {"tension"};
  EXPECT_EQ(refusal(input, options), fit_of_keys("tension").message());
  input.schema.time.is_given = false;
  EXPECT_EQ(refusal(input, options), fit_without_times().message());
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

}  // namespace
}  // namespace tcb
