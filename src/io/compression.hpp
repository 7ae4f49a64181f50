// Compression: gzip and Zstandard, by the ending of a name or by the first bytes, in a stream.
//
// Source: RFC 1952 and RFC 8878; computed by zlib and libzstd.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "stream/source.hpp"

namespace tcb {

enum class Compression { none, gzip, zstandard };

/// The compression that the ending of a path names: .gz or .zst, in upper or lower case.
Compression compression_of(std::string_view path);

/// The bytes of a file, decompressed if its first bytes are those of gzip or Zstandard, in parts of at most 256 KiB.
/// Several files in one become one. Throws: Error (data) for data that are broken or end too early.
Source<std::string> decompressed(Source<std::string> bytes);

/// Compresses a file. The bytes do not depend on how they were divided, nor on the time.
class Compressor {
 public:
  /// Requires: a compression. Throws: std::bad_alloc.
  explicit Compressor(Compression compression);
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
  ~Compressor();

  /// The compressed bytes that are ready after these; the rest with the last of them.
  std::string add(std::string_view bytes, bool last = false);

  struct State;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace tcb
