// What stands beside keys in JSON: settings, names, the id; names that are nearly right are refused.
#include "input/json/settings.hpp"

#include <gmock/gmock.h>

#include "input/reading.hpp"

namespace tcb {
namespace {

JsonPart part(const std::string& text) {
  JsonPart result{{text}, true};
  result.chunk.path = "curves[2]";
  return result;
}

std::string refusal(const std::string& text) {
  return error_of([&] { read_beside(part(text)); });
}

TEST(JsonCurveInfo, settings_channels_and_id_are_read) {
  const JsonCurveInfo beside = read_beside(part(
      R"({"id":"a","keys":[],"preset":"vtk","ends":["zero","half"],"closed":true,"period":7.5,"channels":["x","y"]})"));
  EXPECT_EQ(beside.keys.id, "\"a");
  EXPECT_EQ(beside.keys.settings.preset, "vtk");
  EXPECT_EQ(beside.keys.settings.ends, "zero,half");
  EXPECT_EQ(beside.keys.settings.closed, true);
  EXPECT_EQ(beside.keys.settings.period, "7.5");
  EXPECT_THAT(beside.channels, testing::ElementsAre("x", "y"));
  EXPECT_EQ(read_beside(part(R"({"id":7})")).keys.id, "7");
  EXPECT_EQ(read_beside(part(R"({"id":null})")).keys.id, "");
}

TEST(JsonCurveInfo, other_members_are_passed_over_unless_they_are_nearly_known) {
  EXPECT_EQ(refusal(R"({"version":[1,{"preset":"x"}],"name":"n"})"), "no error");
  EXPECT_THAT(refusal(R"({"prest":"vtk"})"), testing::HasSubstr("curves[2].prest: no setting; did you mean preset?"));
  EXPECT_THAT(refusal(R"({"close":true})"), testing::HasSubstr("did you mean closed?"));
}

TEST(JsonCurveInfo, what_is_wrong_is_placed) {
  EXPECT_THAT(refusal("{\"closed\":\n \"maybe\"}"),
              testing::StartsWith("f:2:2: error: curves[2].closed: \"maybe\"; expected"));
  EXPECT_THAT(refusal(R"({"preset":"a","preset":"b"})"), testing::HasSubstr("a second time in one object"));
  EXPECT_THAT(refusal(R"({"channels":"x"})"), testing::HasSubstr("expected an array of names"));
  EXPECT_THAT(refusal(R"({"id":[1]})"), testing::HasSubstr("expected a text or a number"));
}

TEST(JsonCurveInfo, channels_are_known_before_the_keys_where_they_stand_before_them) {
  EXPECT_THAT(channels_before_keys(part(R"({"channels":["x"],"keys":)")), testing::ElementsAre("x"));
  EXPECT_THAT(channels_before_keys(part(R"({"keys":)")), testing::IsEmpty());
}

}  // namespace
}  // namespace tcb
