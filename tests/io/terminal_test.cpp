// Terminals: colors of messages, by option and environment.
#include "io/terminal.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace tcb {
namespace {

/// A variable of the environment with a value for the time of a test; null: without.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { ::unsetenv(name_); }

 private:
  const char* name_;
};

TEST(Terminal, colors_depend_on_the_option_and_the_environment) {
  const Variable none("NO_COLOR", nullptr);
  {
    const Variable force("CLICOLOR_FORCE", "1"), dumb("TERM", "dumb");
    EXPECT_TRUE(colors_messages(ColorWhen::by_terminal));
    EXPECT_FALSE(colors_messages(ColorWhen::never));
    const Variable no("NO_COLOR", "1");
    EXPECT_FALSE(colors_messages(ColorWhen::by_terminal)) << "NO_COLOR is stronger";
    EXPECT_TRUE(colors_messages(ColorWhen::always)) << "the option is stronger than the environment";
  }
  const Variable off("CLICOLOR_FORCE", "0");
  testing::internal::CaptureStderr();
  EXPECT_FALSE(colors_messages(ColorWhen::by_terminal)) << "standard error is a file";
  testing::internal::GetCapturedStderr();
}

TEST(Terminal, only_the_place_and_the_kind_are_colored) {
  EXPECT_EQ(message_head("a.csv:1:2", MessageKind::error, false), "a.csv:1:2: error: ");
  EXPECT_EQ(message_head("a.csv:1:2", MessageKind::error, true), "\x1b[1ma.csv:1:2:\x1b[0m \x1b[1;31merror:\x1b[0m ");
  EXPECT_EQ(message_head("a.csv", MessageKind::warning, true), "\x1b[1ma.csv:\x1b[0m \x1b[1;35mwarning:\x1b[0m ");
  EXPECT_EQ(message_head("a.csv", MessageKind::note, true), "\x1b[1ma.csv:\x1b[0m \x1b[1;36mnote:\x1b[0m ");
}

}  // namespace
}  // namespace tcb
