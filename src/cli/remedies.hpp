// Words for errors: from codes, subjects and values to what was wrong, what was expected, and the remedy.
#pragma once

#include <string>

#include "app/progress.hpp"
#include "error.hpp"

namespace tcb {

/// "FILE:LINE:COLUMN: error: MESSAGE", or "tcbsample: error: MESSAGE" where there is no file; a line for each error.
std::string error_text(const Error& error);

/// What is wrong, what was expected, and the remedy, separated by "; ".
std::string error_message(const Error& error);

/// The long name of an option, with its dashes.
std::string_view option_name(Option option);

/// A note as a sentence.
std::string note_text(const Note& note);

}  // namespace tcb
