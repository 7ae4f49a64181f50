// Zstandard: compressed bytes in a stream, by libzstd. A build for Windows has none; see zstandard_windows.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace tcb {

/// What is left of bytes, and where compressed or decompressed ones go.
struct Buffers {
  std::string_view in;
  std::string out;
  std::size_t size = 0;  ///< of `out` that is filled
};

/// Frames of a Zstandard file, one after another.
class Unzstd {
 public:
  static constexpr std::string_view name = "Zstandard";

  Unzstd();
  ~Unzstd();

  bool ended() const;

  /// Decompresses some bytes; false: they are broken. Throws: Error (data) for a window that needs too much memory.
  bool step(Buffers& buffers);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Compresses bytes to one frame with a checksum.
class Zstd {
 public:
  Zstd();
  ~Zstd();

  /// Compresses some bytes; false: nothing is left to do.
  bool step(Buffers& buffers, bool last);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcb
