// Help: every text shows every option of the table.
#include "cli/help.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "cli/command_line.hpp"

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

TEST(Help, defaults_are_shown) {
  EXPECT_THAT(help_text(), HasSubstr("(default: 1e9)\n"));
  EXPECT_THAT(help_text(), HasSubstr("(default: error)\n"));
}

TEST(Help, the_version_has_the_name_and_three_numbers) {
  EXPECT_TRUE(std::regex_match(version_text(), std::regex("tcbsample [0-9]+\\.[0-9]+\\.[0-9]+"))) << version_text();
}

}  // namespace
}  // namespace tcb
