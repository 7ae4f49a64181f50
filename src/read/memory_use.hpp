// Memory use: the memory that a reader keeps of an input, within a limit.
//
// Readers of rows keep a part of the input, whose size does not depend on that of the file. Those that must keep what
// they read, as of scenes and of tables in JSON, count it here.
#pragma once

#include <cstdint>

#include "error.hpp"

namespace tcb {

/// On every machine, so that a file that is read on one is read on all.
inline constexpr std::uint64_t default_max_memory = 1ULL << 30;

/// The memory that one reader keeps.
class MemoryUse {
 public:
  explicit MemoryUse(std::uint64_t most) : most_(most) {}

  /// Counts bytes before they are kept. Throws: Error (data) where all are more than the limit.
  void add(std::uint64_t bytes) {
    if (bytes > most_ - used_) {
      constexpr std::uint64_t mebibyte = 1ULL << 20;
      throw data_error(
          "reading the input needs more than {} MiB of memory, as the format is kept as a whole; expected less; check "
          "whether the file is the right one, or give more to --max-memory, as in {}GiB",
          most_ / mebibyte, most_ / (1024 * mebibyte) * 2 + 2);
    }
    used_ += bytes;
  }

  /// Bytes that were counted are not kept any more.
  void remove(std::uint64_t bytes) { used_ -= bytes; }

 private:
  std::uint64_t most_, used_ = 0;
};

}  // namespace tcb
