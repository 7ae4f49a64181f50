// What is said of a text that is refused: the text in quotes, what was expected, and the remedy.
#pragma once

#include <string>
#include <string_view>

namespace tcb {

/// Text as it is quoted in messages: cut to a length that fits a line, and with what cannot be shown as \xNN.
std::string shown(std::string_view text);

/// Why a cell is no number where one was expected. `decimal`: the mark that numbers were expected to have.
std::string no_number(std::string_view cell, char decimal);

/// Where a text is no UTF-8, or npos.
std::size_t find_foreign(std::string_view text);

/// What is said of a byte that is no UTF-8.
std::string foreign_byte(char byte);

/// Text with its control characters, which names of files and columns may have, as \xNN.
std::string in_one_line(std::string_view text);

}  // namespace tcb
