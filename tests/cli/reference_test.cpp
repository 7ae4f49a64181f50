// The reference: help, manual page and completions show every option that is declared.
#include "cli/reference.hpp"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "cli/options.hpp"
#include "error.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ReferenceTest : public testing::Test {
 protected:
  /// Every name with its dashes.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const CLI::Option* option : app_->get_options()) {
      for (const auto& name : option->get_lnames()) all.push_back("--" + name);
      for (const auto& name : option->get_snames()) all.push_back("-" + name);
    }
    return all;
  }

  /// What a program says to a script on its standard input; nothing where there is no such program.
  static std::optional<std::string> run(const std::string& program, const std::string& script) {
    if (std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) != 0) return std::nullopt;
    const std::string file = testing::TempDir() + "tcbsample_completion";
    std::FILE* const out = std::fopen(file.c_str(), "w");
    std::fputs(script.c_str(), out);
    std::fclose(out);
    std::FILE* const pipe = ::popen((program + " " + file + " 2>&1").c_str(), "r");
    std::string said;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said += static_cast<char>(c);
    ::pclose(pipe);
    std::remove(file.c_str());
    return said;
  }

  TypedOptions typed_;
  std::unique_ptr<CLI::App> app_ = declare(typed_);
};

TEST_F(ReferenceTest, every_option_has_a_long_name_and_a_description) {
  for (const CLI::Option* option : app_->get_options()) {
    if (option->get_positional()) continue;
    EXPECT_FALSE(option->get_lnames().empty()) << option->get_name();
    EXPECT_FALSE(option->get_description().empty()) << option->get_name();
    EXPECT_FALSE(option->get_description().ends_with('.')) << option->get_name() << ": the manual adds the point";
  }
}

TEST_F(ReferenceTest, the_help_shows_every_option_in_80_columns) {
  const std::string help = help_text(*app_);
  for (const std::string& name : names())
    EXPECT_TRUE(std::regex_search(help, std::regex("\n  (-., )?(--[a-z-]+, )*" + name + "[ ,\n]"))) << name;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_THAT(help, StartsWith("Usage: tcbsample [OPTION]... [FILE]...\n"));
  EXPECT_THAT(help, HasSubstr("\n  -s, --step H\n      Samples every H of time from the first key;"));
  EXPECT_THAT(help, HasSubstr("\n  -V, --version\n")) << "a flag shows no value";
}

TEST_F(ReferenceTest, the_manual_shows_every_option_with_its_dashes_escaped) {
  const std::string page = generated_text(*app_, "man");
  for (std::string name : names()) {
    name = std::regex_replace(name, std::regex("-"), "\\-");
    EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
  }
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-s\\fR, \\fB\\-\\-step\\fR \\fIH\\fR\nSamples every H of time"));
  EXPECT_EQ(page.find("@OPTIONS@"), std::string::npos);
  EXPECT_FALSE(page.ends_with('\n')) << "whoever prints it ends the line";
}

TEST_F(ReferenceTest, bash_completes_options) {
  const auto said = run("bash", generated_text(*app_, "bash") +
                                    "\nCOMP_WORDS=(tcbsample --arc-); COMP_CWORD=1; _tcbsample; echo ${COMPREPLY[@]}"
                                    "\nCOMP_WORDS=(tcbsample -); COMP_CWORD=1; _tcbsample; echo ${#COMPREPLY[@]}"
                                    "\nCOMP_WORDS=(tcbsample a); COMPREPLY=(); _tcbsample; echo ${#COMPREPLY[@]}\n");
  if (!said) GTEST_SKIP();
  EXPECT_EQ(*said, "--arc-step --arc-count --arc-at\n" + std::to_string(names().size()) + "\n0\n");
}

TEST_F(ReferenceTest, zsh_and_fish_know_every_option_and_which_take_a_value) {
  const std::string zsh = generated_text(*app_, "zsh"), fish = generated_text(*app_, "fish");
  for (const std::string& name : names()) {
    EXPECT_THAT(zsh, HasSubstr("\n  '" + name + "["));
    EXPECT_THAT(fish,
                HasSubstr(name.starts_with("--") ? " -l " + name.substr(2) + " " : " -s " + name.substr(1) + " "));
  }
  EXPECT_THAT(zsh, StartsWith("#compdef tcbsample\n"));
  EXPECT_THAT(zsh, HasSubstr("]:H:_files' \\\n"));
  EXPECT_THAT(zsh, HasSubstr("'--version[Prints the version]' \\\n"));
  EXPECT_THAT(fish, HasSubstr("-l step -r -d '"));
  EXPECT_THAT(fish, HasSubstr("complete -c tcbsample -s V -l version -d 'Prints the version'"));
}

TEST_F(ReferenceTest, quotes_in_completions_are_closed) {
  for (const char* kind : {"zsh", "fish"}) {
    std::istringstream lines(generated_text(*app_, kind));
    for (std::string line; std::getline(lines, line);) EXPECT_EQ(std::ranges::count(line, '\'') % 2, 0) << line;
  }
}

TEST_F(ReferenceTest, another_kind_is_refused) {
  try {
    generated_text(*app_, "powershell");
    FAIL() << "it was not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_STREQ(error.what(), "--generate \"powershell\": expected man, bash, zsh or fish");
  }
}

TEST_F(ReferenceTest, the_version_has_the_name_and_three_numbers) {
  EXPECT_TRUE(std::regex_match(version_text(), std::regex("tcbsample [0-9]+\\.[0-9]+\\.[0-9]+"))) << version_text();
}

}  // namespace
}  // namespace tcb
