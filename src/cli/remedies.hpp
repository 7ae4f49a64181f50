// Words for errors of the command line: from codes, subjects and values to sentences with the remedy.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "error.hpp"

namespace tcb {

/// The words of a code. {0}, {1}, … are its values, lists joined by ", "; {q0}, {q1}, … its texts in quotes, cut to a
/// length that fits a line; {c0}, {c1}, … columns by name or number. {subject} is the option that the error
/// is about, as --NAME; {nearest} suggests the name in the list that is nearest to {0}, if any is.
struct Words {
  ErrorCode code;
  std::string_view text;
};

/// A row for each code.
std::span<const Words> remedies();

}  // namespace tcb
