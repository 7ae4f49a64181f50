// Terminals: a line that is erased when the program is interrupted, and colors of messages.
#include "io/terminal.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

#include "error.hpp"
#include "io/system.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

std::atomic<std::size_t> line_width{0};

struct KindStyle {
  std::string_view word, style;
};

/// In the order of MessageKind: red, magenta, cyan.
constexpr std::array kind_styles{KindStyle{"error:", "\x1b[1;31m"}, KindStyle{"warning:", "\x1b[1;35m"},
                                 KindStyle{"note:", "\x1b[1;36m"}};

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

void erase_when_interrupted(std::size_t width) { line_width = width; }

void end_interrupted() {
  std::array<char, 512> blanks{};
  constexpr std::size_t echoed = 2;  // ^C, which the terminal shows after the line
  const std::size_t size = std::min(line_width + echoed, blanks.size() - 2);
  blanks.fill(' ');
  blanks[0] = blanks[size + 1] = '\r';
  if (line_width > 0) (void)system::write(system::standard_error, {blanks.data(), size + 2});
  system::end_now(static_cast<int>(Exit::interrupted));
}

bool colors_messages(ColorWhen when) {
  if (when != ColorWhen::by_terminal) return when == ColorWhen::always;
  if (!variable("NO_COLOR").empty()) return false;
  const std::string_view forced = variable("CLICOLOR_FORCE");
  if (!forced.empty() && forced != "0") return true;
  return system::has_colors();
}

std::string message_head(std::string_view where, MessageKind kind, bool colored) {
  const auto& [word, style] = kind_styles.at(static_cast<std::size_t>(kind));
  const std::string place(where);
  if (!colored) return place + ": " + std::string(word) + " ";
  return "\x1b[1m" + place + ":\x1b[0m " + std::string(style) + std::string(word) + "\x1b[0m ";
}

std::string error_text(const Error& error, bool colored) {
  const TextPosition& position = error.position();
  std::string where = position.file.empty() ? "tcbsample" : in_message(position.file);
  if (!position.file.empty() && position.line != 0) {
    where += ":" + std::to_string(position.line);
    if (position.column != 0) where += ":" + std::to_string(position.column);
  }
  std::string text = message_head(where, MessageKind::error, colored) + in_message(error.message());
  for (const Error& other : error.others()) text += "\n" + error_text(other, colored);
  return text;
}

}  // namespace tcb
