// Words for errors and notes: from codes, subjects and values to sentences with the remedy.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "error.hpp"
#include "run/progress.hpp"

namespace tcb {

/// The words of a code. {0}, {1}, … are its values, lists joined by ", "; {q0}, {q1}, … its texts in quotes, cut to a
/// length that fits a line; {c0}, {c1}, … columns by name or number. {subject} is the option, as --NAME, or the member
/// of JSON that the error is about; {nearest} suggests the name in the list that is nearest to {0}, if any is.
struct Words {
  ErrorCode code;
  std::string_view text;
};

/// A row for each code.
std::span<const Words> remedies();

/// "FILE:LINE:COLUMN: error: MESSAGE", or "tcbsample: error: MESSAGE" if there is no file; a line for each error.
std::string error_text(const Error& error);

/// The same with the place and the word "error" in color.
std::string colored_error_text(const Error& error);

/// The fault, what was expected, and the remedy, separated by "; ".
std::string error_message(const Error& error);

/// A note as a sentence.
std::string note_text(const Note& note);

}  // namespace tcb
