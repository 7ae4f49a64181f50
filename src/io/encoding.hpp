// Encodings: text in UTF-16, UTF-32 or Windows-1252 to UTF-8, in the same way on all systems.
//
// Source: the Unicode Standard, chapter 3.9, and Microsoft's table of code page 1252.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stream/source.hpp"

namespace tcb {

enum class Encoding {
  utf8,
  utf16,
  utf32,
  windows_1252,  ///< which spreadsheets write without a mark; it has all printable characters of Latin-1
};

std::string_view name_of(Encoding encoding);

/// The encoding that a byte order mark names; nothing else than a mark is looked at.
Encoding encoding_of_mark(std::string_view beginning);

/// A text in UTF-8; nothing if it is no text in this encoding.
std::optional<std::string> in_utf8(std::string_view text, Encoding encoding);

/// The bytes of a text in UTF-8, without a byte order mark. Its pulls throw Error (data) for bytes that are no text in
/// the encoding, after the text before them.
Source<std::string> in_utf8(Source<std::string> bytes, Encoding encoding);

}  // namespace tcb
