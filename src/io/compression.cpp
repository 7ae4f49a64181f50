// Compression: gzip and Zstandard, by the ending of a name or by the first bytes, in a stream.
#include "io/compression.hpp"

#include <zlib.h>
#ifndef _WIN32
#include <zstd.h>
#include <zstd_errors.h>
#endif

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

#include "error.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::size_t part_size = 256UL * 1024;
constexpr std::string_view gzip_magic = "\x1F\x8B", zstandard_magic = "\x28\xB5\x2F\xFD";
constexpr std::string_view skippable_magic = "\x2A\x4D\x18";  ///< after a first byte from 0x50 to 0x5F
constexpr int gzip_window = 15 + 16;                          ///< the largest, in the format of gzip

/// What is left of bytes, and where compressed or decompressed ones go.
struct Buffers {
  std::string_view in;
  std::string out;
  std::size_t size = 0;  ///< of `out` that is filled
};

/// Calls a function of zlib for the bytes of buffers.
int call(int (*function)(z_stream*, int), z_stream& stream, Buffers& buffers, int flush) {
  const auto bytes_of = [](const char* text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text)); };
  stream.next_in = bytes_of(buffers.in.data());
  stream.avail_in = static_cast<uInt>(buffers.in.size());
  stream.next_out = bytes_of(buffers.out.data() + buffers.size);
  stream.avail_out = static_cast<uInt>(buffers.out.size() - buffers.size);
  const int result = function(&stream, flush);
  buffers.in.remove_prefix(buffers.in.size() - stream.avail_in);
  buffers.size = buffers.out.size() - stream.avail_out;
  return result;
}

/// Members of a gzip file, one after another; zeros after the last are padding.
class Gunzip {
 public:
  static constexpr std::string_view name = "gzip";

  Gunzip() {
    if (inflateInit2(&stream_, gzip_window) != Z_OK) throw std::bad_alloc();
  }
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;
  ~Gunzip() { inflateEnd(&stream_); }

  bool ended() const { return ended_; }

  /// Decompresses some bytes; false: they are broken.
  bool step(Buffers& buffers) {
    if (ended_) {
      const std::size_t next = buffers.in.find_first_not_of('\0');
      buffers.in.remove_prefix(std::min(next, buffers.in.size()));
      if (buffers.in.empty()) return true;
      inflateReset(&stream_);
    }
    const int result = call(inflate, stream_, buffers, Z_NO_FLUSH);
    ended_ = result == Z_STREAM_END;
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    return result == Z_OK || result == Z_STREAM_END || result == Z_BUF_ERROR;
  }

 private:
  z_stream stream_{};
  bool ended_ = false;
};

#ifdef _WIN32
/// Debian has no library of Zstandard for Windows.
[[noreturn]] void refuse_zstandard() {
  throw usage_error(
      "this build of the program has no Zstandard (.zst); expected gzip (.gz) or no compression; convert the input "
      "with zstd -d, or give the output another ending");
}

struct Unzstd {
  static constexpr std::string_view name = "Zstandard";

  Unzstd() { refuse_zstandard(); }
  bool ended() const { return false; }
  bool step(Buffers&) { return false; }
};
#else
/// Frames of a Zstandard file, one after another.
class Unzstd {
 public:
  static constexpr std::string_view name = "Zstandard";

  Unzstd() {
    if (stream_ == nullptr) throw std::bad_alloc();
  }

  bool ended() const { return ended_; }

  /// As of Gunzip. Throws: Error (data) for a window that needs too much memory.
  bool step(Buffers& buffers) {
    ZSTD_inBuffer in{buffers.in.data(), buffers.in.size(), 0};
    ZSTD_outBuffer out{buffers.out.data(), buffers.out.size(), buffers.size};
    const std::size_t result = ZSTD_decompressStream(stream_.get(), &out, &in);
    if (ZSTD_getErrorCode(result) == ZSTD_error_frameParameter_windowTooLarge)
      throw data_error(
          "the Zstandard data need a window of more than 128 MiB of memory; expected at most 128 MiB; decompress the "
          "file with zstd -d --long=31 first");
    if (ZSTD_isError(result) != 0) return false;
    buffers.in.remove_prefix(in.pos);
    buffers.size = out.pos;
    ended_ = result == 0;
    return true;
  }

 private:
  std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream_{ZSTD_createDStream(), ZSTD_freeDStream};
  bool ended_ = false;
};
#endif

/// The bytes of a file of one compression.
template <class Decoder>
Source<std::string> decoded(Source<std::string> bytes) {
  struct State {
    explicit State(Source<std::string> source) : bytes(std::move(source)) {}
    Source<std::string> bytes;
    Decoder decoder = {};
    std::string part = {};
    std::string_view left = {};
    bool at_end = false;
  };
  const auto state = std::make_shared<State>(std::move(bytes));
  return [state]() -> std::optional<std::string> {
    Buffers buffers{state->left, std::string(part_size, '\0')};
    while (buffers.size == 0) {
      if (buffers.in.empty() && !state->at_end) {
        auto more = state->bytes();
        state->at_end = !more;
        state->part = std::move(more).value_or("");
        buffers.in = state->part;
      }
      const bool was_ended = state->decoder.ended();
      if (buffers.in.empty() && was_ended && state->at_end) return std::nullopt;
      if (!state->decoder.step(buffers))
        throw data_error("the {} data are damaged; expected a valid file; copy or create it again", Decoder::name);
      const bool stuck = state->at_end && buffers.in.empty() && buffers.size == 0;
      if (stuck && !state->decoder.ended())
        throw data_error("the {} data end too early; expected a complete file; copy or create it again", Decoder::name);
    }
    state->left = buffers.in;
    buffers.out.resize(buffers.size);
    return std::move(buffers.out);
  };
}

/// Whether bytes begin a Zstandard file: a frame, or a skippable frame before it as pzstd writes it.
bool begins_zstandard(std::string_view bytes) {
  if (bytes.starts_with(zstandard_magic)) return true;
  return bytes.substr(0, 1) >= "\x50" && bytes.substr(0, 1) <= "\x5F" && bytes.substr(1).starts_with(skippable_magic);
}

}  // namespace

Compression compression_of(std::string_view path) {
  const std::string_view named = compression_ending(path);
  if (named.empty()) return Compression::none;
  return named == ".gz" ? Compression::gzip : Compression::zstandard;
}

Source<std::string> decompressed(Source<std::string> bytes) {
  std::string beginning;
  while (beginning.size() < zstandard_magic.size() && append_next(beginning, bytes)) {
  }
  const bool gzip = beginning.starts_with(gzip_magic), zstandard = begins_zstandard(beginning);
  bytes = preceded_by(std::move(beginning), std::move(bytes));
  if (gzip) return decoded<Gunzip>(std::move(bytes));
  if (zstandard) return decoded<Unzstd>(std::move(bytes));
  return bytes;
}

struct Compressor::State {
  virtual ~State() = default;
  /// Compresses some bytes; false: nothing is left to do.
  virtual bool step(Buffers& buffers, bool last) = 0;
};

namespace {

class Gzip : public Compressor::State {
 public:
  Gzip() {
    constexpr int memory = 8;            // zlib's default
    constexpr int level = Z_BEST_SPEED;  // the default takes five times as long for rows that are a tenth smaller
    if (deflateInit2(&stream_, level, Z_DEFLATED, gzip_window, memory, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;
  ~Gzip() override { deflateEnd(&stream_); }

  bool step(Buffers& buffers, bool last) override {
    const int result = call(deflate, stream_, buffers, last ? Z_FINISH : Z_NO_FLUSH);
    return stream_.avail_out == 0 || !buffers.in.empty() || (last && result != Z_STREAM_END);
  }

 private:
  z_stream stream_{};
};

#ifndef _WIN32
/// One frame with a checksum.
class Zstd : public Compressor::State {
 public:
  Zstd() {
    if (stream_ == nullptr) throw std::bad_alloc();
    (void)ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_checksumFlag, 1);
  }

  bool step(Buffers& buffers, bool last) override {
    ZSTD_inBuffer in{buffers.in.data(), buffers.in.size(), 0};
    ZSTD_outBuffer out{buffers.out.data(), buffers.out.size(), buffers.size};
    const std::size_t left = ZSTD_compressStream2(stream_.get(), &out, &in, last ? ZSTD_e_end : ZSTD_e_continue);
    if (ZSTD_isError(left) != 0) throw std::bad_alloc();
    buffers.in.remove_prefix(in.pos);
    buffers.size = out.pos;
    return !buffers.in.empty() || (last && left > 0);
  }

 private:
  std::unique_ptr<ZSTD_CStream, std::size_t (*)(ZSTD_CStream*)> stream_{ZSTD_createCStream(), ZSTD_freeCStream};
};
#endif

}  // namespace

Compressor::Compressor(Compression compression) {
  if (compression == Compression::gzip) {
    state_ = std::make_unique<Gzip>();
  } else {
#ifdef _WIN32
    refuse_zstandard();
#else
    state_ = std::make_unique<Zstd>();
#endif
  }
}

Compressor::~Compressor() = default;

std::string Compressor::add(std::string_view bytes, bool last) {
  Buffers buffers{bytes, std::string(part_size, '\0')};
  while (state_->step(buffers, last)) {
    if (buffers.size == buffers.out.size()) buffers.out.resize(2 * buffers.out.size());
  }
  buffers.out.resize(buffers.size);
  return std::move(buffers.out);
}

}  // namespace tcb
