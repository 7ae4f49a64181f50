// Settings in JSON: settings of the curve, channel names, the id; near misses of names.
#include "read/json/settings.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

/// The settings of an object as the third of "curves".
FileSettings settings_of(const std::string& object) {
  const Json json(R"({"curves":[0,0,)" + object + "]}", {1, 1}, 1000);
  const std::size_t curves = *json.member(1, "curves"), curve = json.values(curves)[2];
  JsonTable table{.value = curve, .path = "curves[2].keys", .is_own = true};
  table.around = {{1, static_cast<std::uint32_t>(curves), 0}, {static_cast<std::uint32_t>(curve), 0, 9}};
  return JsonSettings(json, {&table, 1}).around(table, {});
}

std::string refusal(const std::string& text) {
  return error_of([&] { settings_of(text); });
}

TEST(JsonSettings, settings_channels_and_id_are_read) {
  const FileSettings found = settings_of(
      R"({"id":"a","keys":[],"preset":"vtk","ends":["zero","half"],"closed":true,"period":7.5,"channels":["x","y"]})");
  EXPECT_EQ(found.curve_info.id, "\"a");
  EXPECT_EQ(found.curve_info.settings.preset, spline::Preset::vtk);
  EXPECT_EQ(found.curve_info.settings.ends.value().value.last.rule, spline::EndRule::half);
  EXPECT_EQ(found.curve_info.settings.closed.value().value, true);
  EXPECT_EQ(found.curve_info.settings.period.value().value.value, Rational(15, 2));
  EXPECT_THAT(found.channels, testing::ElementsAre("x", "y"));
  EXPECT_EQ(settings_of(R"({"id":7})").curve_info.id, "7");
  EXPECT_EQ(settings_of(R"({"id":null})").curve_info.id, "");
}

TEST(JsonSettings, of_two_objects_the_outer_one_has_priority_and_its_note) {
  const FileSettings found =
      settings_of(R"({"ends":"zero","channels":["x","y"],"params":{"ends":"natural","channels":["a","b"]}})");
  EXPECT_THAT(found.channels, testing::ElementsAre("x", "y"));
  EXPECT_THAT(found.notes, testing::ElementsAre(testing::StartsWith("the file sets curves[2].ends to zero; ")));
}

TEST(JsonSettings, an_object_around_several_tables_has_the_same_settings_for_each) {
  for (const std::string tension :
       {R"("tension":0.5)", R"("k_tension":0.5,"k_continuity":0,"k_bias":0)", R"("tcb":{"t":0.5,"c":0,"b":0})"}) {
    const std::string text = R"({"m":1,"fps":24,"closed":true,"preset":"vtk",)" + tension + R"(,"a":0})";
    const Json json(text, {1, 1}, 1000);
    JsonTable table{.value = *json.member(1, "a"), .path = "a"};
    table.around = {{1, static_cast<std::uint32_t>(table.value), 0}};
    JsonSettings settings(json, {&table, 1});
    for (int i = 0; i < 3; ++i) {
      const FileSettings found = settings.around(table, {});
      EXPECT_EQ(found.tcb.value().tension, 0.5) << text;
      EXPECT_EQ(found.frame_rate, "24");
      EXPECT_EQ(found.curve_info.settings.closed.value().value, true);
      EXPECT_EQ(found.curve_info.settings.preset, spline::Preset::vtk);
    }
  }
}

TEST(JsonSettings, a_rate_that_no_option_takes_is_a_number_without_use) {
  EXPECT_EQ(settings_of(R"({"fps":1000000000})").frame_rate, "1000000000");
  for (const std::string rate : {"1e300", "1000000001", "0", "1e-320"}) {
    EXPECT_EQ(settings_of(R"({"fps":)" + rate + "}").frame_rate, "") << rate;
  }
}

TEST(JsonSettings, a_list_of_names_and_values_is_read_as_members) {
  EXPECT_EQ(settings_of(R"({"params":[{"name":"tension","value":0.5}]})").tcb.value().tension, 0.5);
  EXPECT_FALSE(settings_of(R"({"params":[{"name":"tension"}]})").tcb);
}

TEST(JsonSettings, other_members_are_ignored_unless_they_are_near_misses) {
  EXPECT_EQ(refusal(R"({"version":[1,{"preset":"x"}],"name":"n"})"), "no error");
  EXPECT_THAT(refusal(R"({"prest":"vtk"})"),
              testing::HasSubstr("curves[2].prest: there is no such setting; did you mean preset?"));
  EXPECT_THAT(refusal(R"({"closd":true})"), testing::HasSubstr("did you mean closed?"));
}

TEST(JsonSettings, errors_have_their_position) {
  EXPECT_THAT(refusal("{\"closed\":\n \"maybe\"}"),
              testing::StartsWith("f:2:2: error: curves[2].closed: found \"maybe\"; expected"));
  EXPECT_THAT(refusal(R"({"preset":"gte","preset":"vtk"})"), testing::HasSubstr("has this member twice"));
  EXPECT_THAT(refusal(R"({"channels":"x"})"), testing::HasSubstr("not an array of names"));
  EXPECT_THAT(refusal(R"({"channels":["x","x"]})"),
              testing::StartsWith("f:1:28: error: curves[2].channels: two names are \"x\"; expected different ones"));
  EXPECT_THAT(refusal(R"({"channels":["t"]})"), testing::HasSubstr("\"t\" is the name of a role"));
  EXPECT_THAT(refusal(R"({"tension":{"a":1}})"),
              testing::StartsWith("f:1:27: error: curves[2].tension: this is not a number; expected one"));
  EXPECT_THAT(refusal(R"({"id":[1]})"), testing::HasSubstr("not a text or a number"));
}

TEST(JsonSettings, an_option_is_an_error_that_names_it) {
  EXPECT_THAT(refusal(R"({"no_ease":true})"),
              testing::AllOf(testing::StartsWith("f:1:17: error: curves[2].no_ease: this is an option"),
                             testing::EndsWith("remove it, and give --no-ease")));
}

}  // namespace
}  // namespace tcb
