// Zero bytes of words: a header on its way out, until input/csv has its own.
#pragma once

#include <cstdint>
#include <cstring>

namespace tcb {

constexpr std::uint64_t zero_bytes(std::uint64_t bytes) {
  return (bytes - 0x0101010101010101) & ~bytes & 0x8080808080808080;
}

template <class Word>
Word load(const char* text) {
  Word bytes;
  std::memcpy(&bytes, text, sizeof bytes);
  return bytes;
}

}  // namespace tcb
