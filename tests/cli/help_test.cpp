// Help: every text shows every option of the table.

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "cli/options.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class HelpTest : public testing::Test {
 protected:
  /// Every name with its dashes.
  static std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const OptionRow& row : option_table()) {
      for (const std::string_view name : row.all_names()) all.emplace_back(name);
    }
    return all;
  }

  /// What a program prints for a script; nothing where there is no such program.
  static std::optional<std::string> run(const std::string& program, const std::string& script) {
    if (std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) != 0) return std::nullopt;
    const std::string file = testing::TempDir() + "tcbsample_completion" + std::to_string(::getpid());
    std::FILE* const out = std::fopen(file.c_str(), "w");
    std::fputs(script.c_str(), out);
    std::fclose(out);
    std::FILE* const pipe = ::popen((program + " " + file + " 2>&1").c_str(), "r");
    std::string printed;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) printed += static_cast<char>(c);
    ::pclose(pipe);
    std::remove(file.c_str());
    return printed;
  }
};

TEST_F(HelpTest, the_help_shows_every_option_in_80_columns) {
  const std::string help = help_text();
  for (const std::string& name : names())
    EXPECT_TRUE(std::regex_search(help, std::regex("\n  (-., )?(--[a-z-]+, )*" + name + "[ ,\n]"))) << name;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_THAT(help, StartsWith("Usage: tcbsample [OPTION]... [FILE]...\n"));
  EXPECT_THAT(help, HasSubstr("\n  -s, --step H\n      Samples every H of time from the first key;"));
  EXPECT_THAT(help, HasSubstr("\n  -V, --version\n")) << "a flag shows no value";
}

TEST_F(HelpTest, the_manual_shows_every_option_with_its_dashes_escaped) {
  const std::string page = generated_text(Generated::manual);
  for (std::string name : names()) {
    name = std::regex_replace(name, std::regex("-"), "\\-");
    EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
  }
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-s\\fR, \\fB\\-\\-step\\fR \\fIH\\fR\nSamples every H of time"));
  EXPECT_EQ(page.find("@OPTIONS@"), std::string::npos);
  EXPECT_FALSE(page.ends_with('\n')) << "whoever prints it ends the line";
}

TEST_F(HelpTest, bash_completes_options) {
  const auto printed = run("bash", generated_text(Generated::bash) +
                                       "\nCOMP_WORDS=(tcbsample --arc-); COMP_CWORD=1; _tcbsample; echo ${COMPREPLY[@]}"
                                       "\nCOMP_WORDS=(tcbsample -); COMP_CWORD=1; _tcbsample; echo ${#COMPREPLY[@]}"
                                       "\nCOMP_WORDS=(tcbsample a); COMPREPLY=(); _tcbsample; echo ${#COMPREPLY[@]}\n");
  if (!printed) GTEST_SKIP();
  EXPECT_EQ(*printed, "--arc-step --arc-count --arc-at\n" + std::to_string(names().size()) + "\n0\n");
}

TEST_F(HelpTest, bash_completes_names_that_are_values) {
  const auto printed = run("bash", generated_text(Generated::bash) +
                                       "\nCOMP_WORDS=(tcbsample --missing skip); COMP_CWORD=2; _tcbsample; echo "
                                       "${COMPREPLY[@]}\n");
  if (!printed) GTEST_SKIP();
  EXPECT_EQ(*printed, "skip-row skip-cell\n");
}

TEST_F(HelpTest, defaults_are_shown) {
  EXPECT_THAT(help_text(), HasSubstr("default 1e9\n"));
  EXPECT_THAT(help_text(), HasSubstr("default gte\n"));
}

TEST_F(HelpTest, zsh_and_fish_have_every_option_and_its_values) {
  const std::string zsh = generated_text(Generated::zsh), fish = generated_text(Generated::fish);
  for (const std::string& name : names()) {
    EXPECT_THAT(zsh, HasSubstr("\n  '" + name + "["));
    EXPECT_THAT(fish,
                HasSubstr(name.starts_with("--") ? " -l " + name.substr(2) + " " : " -s " + name.substr(1) + " "));
  }
  EXPECT_THAT(zsh, StartsWith("#compdef tcbsample\n"));
  EXPECT_THAT(zsh, HasSubstr("]:H: ' \\\n"));
  EXPECT_THAT(zsh, HasSubstr("'--version[Prints the version]' \\\n"));
  EXPECT_THAT(fish, HasSubstr("-l step -x -d '"));
  EXPECT_THAT(zsh, HasSubstr(":SIDE:(right left)' \\\n"));
  EXPECT_THAT(zsh, HasSubstr(":DIR:_files -/' \\\n"));
  EXPECT_THAT(fish, HasSubstr("-l side -x -a 'right left' -d '"));
  EXPECT_THAT(fish, HasSubstr("complete -c tcbsample -s V -l version -d 'Prints the version'"));
}

TEST_F(HelpTest, quotes_in_completions_are_closed) {
  for (const Generated kind : {Generated::zsh, Generated::fish}) {
    std::istringstream lines(generated_text(kind));
    for (std::string line; std::getline(lines, line);) EXPECT_EQ(std::ranges::count(line, '\'') % 2, 0) << line;
  }
}

TEST_F(HelpTest, the_version_has_the_name_and_three_numbers) {
  EXPECT_TRUE(std::regex_match(version_text(), std::regex("tcbsample [0-9]+\\.[0-9]+\\.[0-9]+"))) << version_text();
}

}  // namespace
}  // namespace tcb
