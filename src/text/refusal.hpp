// Refusals: a header on its way out; include utf8.hpp.
#pragma once

#include "text/utf8.hpp"

namespace tcb {

inline std::string shown(std::string_view text) { return in_quotes(text); }
inline std::size_t find_foreign(std::string_view text) { return find_invalid_utf8(text); }

/// Why a cell is no number where one was expected. `decimal`: the mark that numbers were expected to have.
std::string no_number(std::string_view cell, char decimal);

/// What is said of a byte that is no UTF-8.
std::string foreign_byte(char byte);

}  // namespace tcb
