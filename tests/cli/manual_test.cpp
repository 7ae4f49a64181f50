// Manual: the pages show every row of the tables.

#include <gmock/gmock.h>

#include <regex>

#include "cli/command_line.hpp"
#include "cli/help.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

TEST(Manual, shows_every_option_with_its_dashes_escaped) {
  const std::string page = manual_page();
  for (std::string name : option_names()) {
    name = std::regex_replace(name, std::regex("-"), "\\-");
    EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
  }
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-s\\fR, \\fB\\-\\-step\\fR \\fIH\\fR\nSamples every H of time"));
  EXPECT_FALSE(page.ends_with('\n')) << "whoever prints it ends the line";
}

TEST(Manual, shows_every_preset_and_rule) {
  const std::string page = curves_page();
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
  for (const std::string& page : {manual_page(), curves_page()}) EXPECT_FALSE(std::regex_search(page, mark));
}

}  // namespace
}  // namespace tcb
