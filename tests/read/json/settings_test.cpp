// Settings in JSON: settings of the curve, channel names, the id; near misses of names; provenance.
#include <gmock/gmock.h>

#include "option_names.hpp"
#include "read/json/json_input.hpp"
#include "read/reading.hpp"

namespace tcb {
namespace {

JsonPart part(const std::string& text) {
  JsonPart result{{text}, true};
  result.chunk.path = "curves[2]";
  return result;
}

std::string refusal(const std::string& text) {
  return error_of([&] { read_curve_info(part(text)); });
}

TEST(JsonSettings, settings_channels_and_id_are_read) {
  const JsonCurveInfo found = read_curve_info(part(
      R"({"id":"a","keys":[],"preset":"vtk","ends":["zero","half"],"closed":true,"period":7.5,"channels":["x","y"]})"));
  EXPECT_EQ(found.curve_info.id, "\"a");
  EXPECT_EQ(found.curve_info.settings.preset, "vtk");
  EXPECT_EQ(found.curve_info.settings.ends, "zero,half");
  EXPECT_EQ(found.curve_info.settings.closed, true);
  EXPECT_EQ(found.curve_info.settings.period, "7.5");
  EXPECT_THAT(found.channels, testing::ElementsAre("x", "y"));
  EXPECT_EQ(read_curve_info(part(R"({"id":7})")).curve_info.id, "7");
  EXPECT_EQ(read_curve_info(part(R"({"id":null})")).curve_info.id, "");
}

TEST(JsonSettings, other_members_are_ignored_unless_they_are_near_misses) {
  EXPECT_EQ(refusal(R"({"version":[1,{"preset":"x"}],"name":"n"})"), "no error");
  EXPECT_THAT(refusal(R"({"prest":"vtk"})"),
              testing::HasSubstr("curves[2].prest: not a setting; did you mean preset?"));
  EXPECT_THAT(refusal(R"({"close":true})"), testing::HasSubstr("did you mean closed?"));
}

TEST(JsonSettings, errors_have_their_position) {
  EXPECT_THAT(refusal("{\"closed\":\n \"maybe\"}"),
              testing::StartsWith("f:2:2: error: curves[2].closed: \"maybe\"; expected"));
  EXPECT_THAT(refusal(R"({"preset":"a","preset":"b"})"), testing::HasSubstr("repeated in one object"));
  EXPECT_THAT(refusal(R"({"channels":"x"})"), testing::HasSubstr("expected an array of names"));
  EXPECT_THAT(refusal(R"({"id":[1]})"), testing::HasSubstr("expected a text or a number"));
}

TEST(JsonSettings, channels_before_the_keys_are_read_before_them) {
  EXPECT_THAT(channels_before_keys(part(R"({"channels":["x"],"keys":)")), testing::ElementsAre("x"));
  EXPECT_THAT(channels_before_keys(part(R"({"keys":)")), testing::IsEmpty());
}

TEST(JsonSettings, an_option_is_an_error_about_that_option) {
  try {
    read_curve_info(part(R"({"no_ease":true})"));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::setting_is_option);
    EXPECT_EQ(error.option(), option::no_ease);
    EXPECT_EQ(std::get<std::string>(error.values().at(0)), "curves[2].no_ease");
  }
}

TEST(JsonProvenance, is_the_member_meta_of_the_text_or_of_its_last_line) {
  const std::string meta = R"("meta":{"program":"p 1","options":["a","b"],"inputs":[{"name":"n","sha256":"0f"}]})";
  for (const std::string& text : {"{\"rows\":[{\"t\":0}]," + meta + "}\n", "{\"t\":0}\n{" + meta + "}\n"}) {
    const EarlierOutput found = json_provenance(text);
    EXPECT_EQ(found.program, "p 1");
    EXPECT_THAT(found.options, testing::ElementsAre("a", "b"));
    EXPECT_THAT(found.inputs, testing::ElementsAre(testing::Pair("n", "0f")));
  }
  EXPECT_EQ(json_provenance("{\"t\":0}\n").program, "");
  EXPECT_EQ(json_provenance("{\"t\":").program, "");
}

}  // namespace
}  // namespace tcb
