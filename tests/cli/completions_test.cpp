// Completions: every option and the names of its values, in the shells that are installed.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "cli/command_line.hpp"
#include "cli/options.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CompletionTest : public testing::Test {
 protected:
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

TEST_F(CompletionTest, bash_completes_options) {
  const auto printed = run("bash", generated_text(Generated::bash) +
                                       "\nCOMP_WORDS=(tcbsample --arc-); COMP_CWORD=1; _tcbsample; echo ${COMPREPLY[@]}"
                                       "\nCOMP_WORDS=(tcbsample -); COMP_CWORD=1; _tcbsample; echo ${#COMPREPLY[@]}"
                                       "\nCOMP_WORDS=(tcbsample a); COMPREPLY=(); _tcbsample; echo ${#COMPREPLY[@]}\n");
  if (!printed) GTEST_SKIP();
  EXPECT_EQ(*printed, "--arc-step --arc-count --arc-at\n" + std::to_string(option_names().size()) + "\n0\n");
}

TEST_F(CompletionTest, bash_completes_names_that_are_values) {
  const auto printed = run("bash", generated_text(Generated::bash) +
                                       "\nCOMP_WORDS=(tcbsample --missing skip); COMP_CWORD=2; _tcbsample; echo "
                                       "${COMPREPLY[@]}\n");
  if (!printed) GTEST_SKIP();
  EXPECT_EQ(*printed, "skip-row skip-cell\n");
}

TEST_F(CompletionTest, zsh_and_fish_have_every_option_and_its_values) {
  const std::string zsh = generated_text(Generated::zsh), fish = generated_text(Generated::fish);
  for (const std::string& name : option_names()) {
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

TEST_F(CompletionTest, quotes_in_completions_are_closed) {
  for (const Generated kind : {Generated::zsh, Generated::fish}) {
    std::istringstream lines(generated_text(kind));
    for (std::string line; std::getline(lines, line);) EXPECT_EQ(std::ranges::count(line, '\'') % 2, 0) << line;
  }
}

}  // namespace
}  // namespace tcb
