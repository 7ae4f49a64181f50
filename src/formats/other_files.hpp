// Other files: those of other products, which are neither read nor written, with what converts them to keys.
#pragma once

#include <optional>
#include <string_view>

#include "error.hpp"

namespace tcb {

/// The error for a file of another product, which its first bytes tell; nothing for others.
std::optional<Error> other_file(std::string_view beginning);

/// Whether further bytes may complete the first bytes of such a file.
bool may_begin_other_file(std::string_view beginning);

/// The ending of the path if it belongs to a known format of files that the program does not write; otherwise empty.
std::string_view other_ending(std::string_view path);

}  // namespace tcb
