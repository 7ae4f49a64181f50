// Manual: the page shows every option of the table.
#include "cli/manual.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "cli/command_line.hpp"

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
  EXPECT_EQ(page.find("@OPTIONS@"), std::string::npos);
  EXPECT_FALSE(page.ends_with('\n')) << "whoever prints it ends the line";
}

}  // namespace
}  // namespace tcb
