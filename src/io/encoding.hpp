// Encodings: text in UTF-16, UTF-32 or Windows-1252 to UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stream/source.hpp"

namespace tcb {

/// The encoding that a byte order mark names, other than UTF-8; empty: none.
std::string_view encoding_of_mark(std::string_view beginning);

/// The encoding of texts that spreadsheets write without a mark; it has all printable characters of Latin-1.
inline constexpr std::string_view windows_1252 = "WINDOWS-1252";

/// A text in UTF-8; nothing if it is no text in this encoding, or if the system does not know that.
std::optional<std::string> in_utf8(std::string_view text, std::string_view encoding);

/// The bytes of a text in UTF-8, without a byte order mark; nothing if the system does not know the encoding.
/// Its pulls throw Error (data) for bytes that are no text in the encoding.
std::optional<Source<std::string>> in_utf8(Source<std::string> bytes, std::string_view encoding);

}  // namespace tcb
