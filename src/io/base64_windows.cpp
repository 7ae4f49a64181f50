// Base64 by the library of Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// after windows.h, whose types it needs
#include <wincrypt.h>

#include <new>

#include "io/base64.hpp"

namespace tcb {

std::string in_base64(std::string_view bytes) {
  if (bytes.empty()) return "";
  const auto* const data = reinterpret_cast<const BYTE*>(bytes.data());
  const auto size = static_cast<DWORD>(bytes.size());
  constexpr DWORD form = CRYPT_STRING_BASE64 | CRYPT_STRING_NOCRLF;
  DWORD room = 0;
  if (::CryptBinaryToStringA(data, size, form, nullptr, &room) == 0) throw std::bad_alloc();
  std::string text(room, '\0');
  if (::CryptBinaryToStringA(data, size, form, text.data(), &room) == 0) throw std::bad_alloc();
  text.resize(room);  // without the NUL
  return text;
}

}  // namespace tcb
