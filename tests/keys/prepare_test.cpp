// Preparing keys: angles that are refused, and whether rows show negative ones; angles that are likely.
#include "keys/prepare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error.hpp"
#include "keys/curves.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

/// Keys of one channel, on lines from 2 on.
Source<KeyBlock> keys_with_angles(const std::vector<double>& angles) {
  KeyBlock block;
  block.keys.channels = 1;
  for (const double angle : angles) {
    block.keys.times.emplace_back(static_cast<double>(block.size()));
    block.keys.positions.push_back(angle);
    block.text_positions.lines.push_back(block.size() + 2);
  }
  return [block, done = false]() mutable -> std::optional<KeyBlock> {
    return std::exchange(done, true) ? std::nullopt : std::optional(block);
  };
}

/// The message of the error of keys with these angles; "": they are taken.
std::string refusal(const std::vector<double>& angles, bool degrees) {
  try {
    (void)with_clear_turns(keys_with_angles(angles),
                           {.rotations = {}, .angles = {{{0, degrees}}}, .channels = {"heading"}})();
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

TEST(Angles, half_a_turn_between_keys_is_refused_in_any_turn) {
  EXPECT_THAT(refusal({0, 180}, true), HasSubstr("exactly half a turn"));
  EXPECT_THAT(refusal({-90, 90}, true), HasSubstr("exactly half a turn"));
  EXPECT_THAT(refusal({10, 550}, true), HasSubstr("exactly half a turn"));
  EXPECT_THAT(refusal({0, 3.141592653589793}, false), HasSubstr("exactly half a turn"));
  EXPECT_EQ(refusal({0, 179.999, 0.001, 360}, true), "");
  EXPECT_EQ(refusal({0, 3.14159, 6.28}, false), "");
}

TEST(Angles, beyond_what_the_unit_allows_are_refused) {
  EXPECT_THAT(refusal({0, 7}, false), HasSubstr("at most one turn"));
  EXPECT_THAT(refusal({0, 4e6}, true), HasSubstr("at most 10000 turns"));
  EXPECT_THAT(refusal({0, std::nan("")}, true), HasSubstr("is missing"));
}

TEST(Angles, rows_show_negative_ones_where_a_key_does) {
  for (const double last : {30.0, -30.0}) {
    const auto [again, angles] = with_signs(keys_with_angles({10, 20, last}), {{{0, true}}});
    EXPECT_EQ(angles[0].is_signed, last < 0);
    EXPECT_EQ(again()->keys.positions, (std::vector<double>{10, 20, last}));
    EXPECT_FALSE(again());
  }
}

/// The likely angles among keys of one channel, as for --angle.
std::string likely(const std::string& name, const std::vector<double>& values, bool named = true) {
  Schema schema;
  schema.named = named;
  schema.channels = {name};
  ObservedChannels channels(schema, false);
  channels.add(*keys_with_angles(values)());
  std::string text;
  for (const auto& [channel, degrees] : channels.likely_angles()) text += channel + (degrees ? "=degrees" : "=radians");
  return text;
}

TEST(LikelyAngles, jump_by_more_than_half_a_turn) {
  EXPECT_EQ(likely("yaw", {350, 10}), "yaw=degrees");
  EXPECT_EQ(likely("imu.heading", {-179, 179}), "imu.heading=degrees");
  EXPECT_EQ(likely("roll", {3.1, -3.1}), "roll=radians");
  EXPECT_EQ(likely("pitch", {0, 6.2}), "pitch=radians");
  EXPECT_EQ(likely("yaw", {0, 180, 0}), "");
  EXPECT_EQ(likely("yaw", {0, 3, 0}), "");
  EXPECT_EQ(likely("x", {350, 10}), "x=degrees");
  EXPECT_EQ(likely("x", {3.1, -3.1}), "") << "small coordinates";
}

TEST(LikelyAngles, may_have_names_of_other_numbers_or_none_where_they_are_within_one_turn) {
  for (const char* name : {"lon", "longitude", "COG", "course", "track", "rx", "ry", "rz", "pan", "theta", "hue"}) {
    EXPECT_EQ(likely(name, {350, 10}), std::string(name) + "=degrees");
    EXPECT_EQ(likely(name, {361, 10}), "") << name;
    EXPECT_EQ(likely(name, {-190, 10}), "") << name;
  }
  for (const char* name : {"rotateX", "rotation_z"}) {
    EXPECT_EQ(likely(name, {190, -160}), std::string(name) + "=degrees");
    EXPECT_EQ(likely(name, {190, -10}), "") << name << " may make half a turn";
    EXPECT_EQ(likely(name, {720, 370}), "") << name << " counts turns";
  }
  EXPECT_EQ(likely("x", {350, 10}, false), "x=degrees") << "the name is of a column without one";
  EXPECT_EQ(likely("x", {361, 10}, false), "");
  EXPECT_EQ(likely("x", {6, 0}, false), "") << "radians are like other small numbers";
  EXPECT_EQ(likely("joint_3", {170, 180, -179.9}), "joint_3=degrees") << "by the numbers alone";
  EXPECT_EQ(likely("joint_3", {3.1, -3.1}), "joint_3=radians");
  EXPECT_EQ(likely("R", {255, 0}) + likely("torque", {100, -120}), "") << "not beside the end of a turn";
}

}  // namespace
}  // namespace tcb
