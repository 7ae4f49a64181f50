// Help: every text shows every option of the table, the manual every rule, and the JSON both.
#include "cli/help.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <sstream>

#include "cli/command_line.hpp"
#include "cli/options.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Help, the_help_shows_every_option_in_80_columns) {
  const std::string help = help_text();
  for (const std::string& name : option_names())
    EXPECT_TRUE(std::regex_search(help, std::regex("\n  (-., )?(--[a-z-]+, )*" + name + "[ ,\n]"))) << name;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_THAT(help, StartsWith("Usage: tcbsample [OPTION]... [FILE]...\n"));
  EXPECT_THAT(help, HasSubstr("\n  -s, --step H\n      Samples every H of time from the first key;"));
  EXPECT_THAT(help, HasSubstr("\n  -V, --version\n")) << "a flag shows no value";
}

TEST(Help, the_short_help_is_a_screen_with_the_options_that_people_need) {
  std::istringstream lines(short_help_text());
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_LE(count, 36U);
  for (const std::string_view name : {"--golden", "--check", "--identify", "--rotation", "--closed", "--from", "--to",
                                      "--max-gap", "--no-overshoot", "--limits"}) {
    EXPECT_THAT(short_help_text(), HasSubstr(name));
  }
}

TEST(Help, defaults_are_shown) {
  EXPECT_THAT(help_text(), HasSubstr("(default: 1e9)\n"));
  EXPECT_THAT(help_text(), HasSubstr("(default: error)\n"));
}

TEST(Help, the_version_has_the_name_and_three_numbers) {
  EXPECT_TRUE(std::regex_match(version_text(), std::regex("tcbsample [0-9]+\\.[0-9]+\\.[0-9]+"))) << version_text();
}

TEST(Manual, shows_every_option_with_its_dashes_escaped) {
  const std::string page = generated_text(Generated::manual);
  for (std::string name : option_names()) {
    name = std::regex_replace(name, std::regex("-"), "\\-");
    EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
  }
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-s\\fR, \\fB\\-\\-step\\fR \\fIH\\fR\nSamples every H of time"));
  EXPECT_FALSE(page.ends_with('\n')) << "whoever prints it ends the line";
}

TEST(Manual, shows_every_preset_and_rule) {
  const std::string page = generated_text(Generated::curves);
  const auto expect_entry = [&page](std::string_view name) {
    EXPECT_THAT(page, HasSubstr(".TP\n.B " + std::regex_replace(std::string(name), std::regex("-"), "\\-")));
  };
  for (const auto& row : spline::presets) expect_entry(row.name);
  for (const auto& row : spline::tangent_rules<double>) expect_entry(row.name);
  for (const auto& row : spline::end_rules<double>) expect_entry(row.name);
  for (const auto& row : spline::rotation_curves) expect_entry(row.name);
}

TEST(Manual, fills_every_mark_of_its_texts) {
  const std::regex mark("@[A-Z]+@");
  EXPECT_TRUE(std::regex_search(manual_template, mark) && std::regex_search(curves_template, mark));
  for (const std::string& page : {generated_text(Generated::manual), generated_text(Generated::curves)})
    EXPECT_FALSE(std::regex_search(page, mark));
}

TEST(Tables, options_and_presets_are_json) {
  const auto tables = nlohmann::json::parse(generated_text(Generated::tables));
  EXPECT_EQ("tcbsample " + tables["version"].get<std::string>(), version_text());
  ASSERT_EQ(tables["options"].size(), option_table().size());
  for (const auto& option : tables["options"]) {
    const OptionRow& row = row_of(option["name"].get<std::string>());
    EXPECT_EQ(option["other_name"], row.other_name);
    EXPECT_EQ(option["kind"] == "flag", row.kind == ValueKind::flag) << row.name;
    EXPECT_EQ(option["known"].empty(), row.known == nullptr) << row.name;
  }
  ASSERT_EQ(tables["presets"].size(), spline::presets.size());
  EXPECT_EQ(tables["presets"][0]["name"], spline::presets[0].name);
  EXPECT_EQ(printed_text({"--generate", "tables"}), generated_text(Generated::tables));
}

}  // namespace
}  // namespace tcb
