// Other files: those of other products, which are not read, with what converts them to keys.
#pragma once

#include <optional>
#include <string_view>
#include <unordered_set>

#include "error.hpp"

namespace tcb {

/// The error for a file of another product, which its first bytes tell; nothing for others.
std::optional<Error> other_file(std::string_view beginning);

/// Whether further bytes may complete the first bytes of such a file.
bool may_begin_other_file(std::string_view beginning);

/// The error for JSON of another product, which the names of members tell; nothing for others. `type`: of the whole, or
/// of its first element. `records`: the option with the path of its list and a blank, or empty.
std::optional<Error> other_json(const std::unordered_set<std::string_view>& members, std::string_view type,
                                std::string_view records);

/// The ending of the path if it is that of such files; otherwise empty.
std::string_view ending_of_other_file(std::string_view path);

}  // namespace tcb
