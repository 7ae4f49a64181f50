// SHA-256 and Base64 by the libraries of Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// after windows.h, whose types it needs
#include <bcrypt.h>
#include <fmt/format.h>
#include <wincrypt.h>
#undef near  // an empty macro

#include <array>
#include <cstdint>
#include <new>

#include "io/digest.hpp"

namespace tcb {

/// A reusable hash: its digest begins the next one.
struct Sha256::State {
  BCRYPT_ALG_HANDLE algorithm = nullptr;
  BCRYPT_HASH_HANDLE hash = nullptr;

  State() {
    const bool is_open = ::BCryptOpenAlgorithmProvider(&algorithm, BCRYPT_SHA256_ALGORITHM, nullptr, 0) == 0;
    if (!is_open) throw std::bad_alloc();
    begin();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    ::BCryptDestroyHash(hash);
    ::BCryptCloseAlgorithmProvider(algorithm, 0);
  }
  void begin() {
    if (::BCryptCreateHash(algorithm, &hash, nullptr, 0, nullptr, 0, 0) != 0) throw std::bad_alloc();
  }
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  constexpr std::size_t most = 1U << 30U;
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, most);
    auto* const data = reinterpret_cast<PUCHAR>(const_cast<char*>(part.data()));
    (void)::BCryptHashData(state_->hash, data, static_cast<ULONG>(part.size()), 0);
    bytes.remove_prefix(part.size());
  }
}

std::string Sha256::digest() {
  std::array<std::uint8_t, 32> digest{};
  (void)::BCryptFinishHash(state_->hash, digest.data(), static_cast<ULONG>(digest.size()), 0);
  ::BCryptDestroyHash(state_->hash);
  state_->begin();
  std::string text;
  for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

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
