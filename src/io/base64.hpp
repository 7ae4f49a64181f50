// Base64: bytes as text; by Nettle, or by the library of Windows.
#pragma once

#include <string>
#include <string_view>

namespace tcb {

/// The bytes in Base64 with padding, in one line.
std::string in_base64(std::string_view bytes);

}  // namespace tcb
