// Terminals: a line that is erased when the program is interrupted, and colors of messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "error.hpp"

namespace tcb {

/// When the program is interrupted, the last line on standard error, which has so many characters, is erased; 0: none.
void erase_when_interrupted(std::size_t width);

/// Erases that line and ends the program with Exit::interrupted. Makes only calls that a handler of signals may make.
[[noreturn]] void end_interrupted();

enum class ColorWhen { by_terminal, always, never };

/// Whether messages on standard error are colored. By terminal: not with NO_COLOR; else with CLICOLOR_FORCE; else on a
/// terminal whose TERM is not dumb.
bool colors_messages(ColorWhen when);

enum class MessageKind { error, warning, note };

/// "WHERE: error: ", or with the place bold and the kind in its color.
std::string message_head(std::string_view where, MessageKind kind, bool colored);

/// "FILE:LINE:COLUMN: error: MESSAGE", or "tcbsample: error: MESSAGE" if there is no file; a line for the error, and
/// one for each that it holds.
std::string error_text(const Error& error, bool colored = false);

}  // namespace tcb
