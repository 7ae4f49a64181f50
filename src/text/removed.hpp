// Removed names: options of earlier versions, and values of options, with what to do instead.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "error.hpp"

namespace tcb {

/// An option that is gone, or one of its values. To add one: its row in the table.
struct RemovedName {
  std::string_view option;   ///< its long name
  std::string_view value;    ///< the value that is gone, where * at its end is a number; empty: the option
  std::string_view instead;  ///< what to do; @N@ is the number that the option has, and @N+1@ the next one
};

std::span<const RemovedName> removed_names();

/// The error (usage) about an option, or about a value of one; nothing if it is not gone.
std::optional<Error> removed(std::string_view option, std::string_view value);

}  // namespace tcb
