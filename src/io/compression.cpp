// Compression: gzip and Zstandard, by the ending of a name or by the first bytes, in a stream.
#include "io/compression.hpp"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

#include "error.hpp"
#include "io/zstandard.hpp"
#include "text/file_ending.hpp"

namespace tcb {
namespace {

constexpr std::size_t part_size = 256UL * 1024;
constexpr std::string_view gzip_magic = "\x1F\x8B", zstandard_magic = "\x28\xB5\x2F\xFD";
constexpr std::string_view skippable_magic = "\x2A\x4D\x18";  ///< after a first byte from 0x50 to 0x5F
constexpr int gzip_window = 15 + 16;                          ///< the largest, in the format of gzip

Bytef* bytes_of(const char* text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text)); }

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
    stream_.next_in = bytes_of(buffers.in.data());
    stream_.avail_in = static_cast<uInt>(buffers.in.size());
    stream_.next_out = bytes_of(buffers.out.data() + buffers.size);
    stream_.avail_out = static_cast<uInt>(buffers.out.size() - buffers.size);
    const int result = inflate(&stream_, Z_NO_FLUSH);
    buffers.in.remove_prefix(buffers.in.size() - stream_.avail_in);
    buffers.size = buffers.out.size() - stream_.avail_out;
    ended_ = result == Z_STREAM_END;
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    return result == Z_OK || result == Z_STREAM_END || result == Z_BUF_ERROR;
  }

 private:
  z_stream stream_{};
  bool ended_ = false;
};

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

}  // namespace

Compression compression_of(std::string_view path) {
  const std::string_view named = compression_ending(path);
  if (named.empty()) return Compression::none;
  return named == ".gz" ? Compression::gzip : Compression::zstandard;
}

namespace {

/// Whether bytes begin a Zstandard file: a frame, or a skippable frame before it as pzstd writes it.
bool begins_zstandard(std::string_view bytes) {
  if (bytes.starts_with(zstandard_magic)) return true;
  return bytes.substr(0, 1) >= "\x50" && bytes.substr(0, 1) <= "\x5F" && bytes.substr(1).starts_with(skippable_magic);
}

}  // namespace

Source<std::string> decompressed(Source<std::string> bytes) {
  std::string beginning;
  while (beginning.size() < zstandard_magic.size()) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  const bool gzip = beginning.starts_with(gzip_magic), zstandard = begins_zstandard(beginning);
  bytes = preceded_by(std::move(beginning), std::move(bytes));
  if (gzip) return decoded<Gunzip>(std::move(bytes));
  return zstandard ? decoded<Unzstd>(std::move(bytes)) : bytes;
}

struct Compressor::State {
  z_stream gzip{};
  std::optional<Zstd> zstandard = {};

  /// Compresses some bytes; false: nothing is left to do.
  bool step(Buffers& buffers, bool last) {
    if (zstandard) return zstandard->step(buffers, last);
    gzip.next_in = bytes_of(buffers.in.data());
    gzip.avail_in = static_cast<uInt>(buffers.in.size());
    gzip.next_out = bytes_of(buffers.out.data() + buffers.size);
    gzip.avail_out = static_cast<uInt>(buffers.out.size() - buffers.size);
    const int result = deflate(&gzip, last ? Z_FINISH : Z_NO_FLUSH);
    buffers.in.remove_prefix(buffers.in.size() - gzip.avail_in);
    buffers.size = buffers.out.size() - gzip.avail_out;
    return gzip.avail_out == 0 || !buffers.in.empty() || (last && result != Z_STREAM_END);
  }
};

Compressor::Compressor(Compression compression) : state_(std::make_unique<State>()) {
  if (compression == Compression::zstandard) {
    state_->zstandard.emplace();
    return;
  }
  constexpr int memory = 8;            // zlib's default
  constexpr int level = Z_BEST_SPEED;  // the default takes five times as long for rows that are a tenth smaller
  if (deflateInit2(&state_->gzip, level, Z_DEFLATED, gzip_window, memory, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
}

Compressor::~Compressor() {
  if (!state_->zstandard) deflateEnd(&state_->gzip);
}

std::string Compressor::add(std::string_view bytes, bool last) {
  Buffers buffers{bytes, std::string(part_size, '\0')};
  while (state_->step(buffers, last)) {
    if (buffers.size == buffers.out.size()) buffers.out.resize(2 * buffers.out.size());
  }
  buffers.out.resize(buffers.size);
  return std::move(buffers.out);
}

}  // namespace tcb
