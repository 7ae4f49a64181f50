// Zstandard by libzstd.
#include <zstd.h>
#include <zstd_errors.h>

#include <new>

#include "error.hpp"
#include "io/zstandard.hpp"

namespace tcb {

struct Unzstd::State {
  std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream{ZSTD_createDStream(), ZSTD_freeDStream};
  bool ended = false;
};

Unzstd::Unzstd() : state_(std::make_unique<State>()) {
  if (state_->stream == nullptr) throw std::bad_alloc();
}
Unzstd::~Unzstd() = default;

bool Unzstd::ended() const { return state_->ended; }

bool Unzstd::step(Buffers& buffers) {
  ZSTD_inBuffer in{buffers.in.data(), buffers.in.size(), 0};
  ZSTD_outBuffer out{buffers.out.data(), buffers.out.size(), buffers.size};
  const std::size_t result = ZSTD_decompressStream(state_->stream.get(), &out, &in);
  if (ZSTD_getErrorCode(result) == ZSTD_error_frameParameter_windowTooLarge)
    throw data_error(
        "the Zstandard data need a window of more than 128 MiB of memory; expected at most 128 MiB; decompress the "
        "file with zstd -d --long=31 first");
  if (ZSTD_isError(result) != 0) return false;
  buffers.in.remove_prefix(in.pos);
  buffers.size = out.pos;
  state_->ended = result == 0;
  return true;
}

struct Zstd::State {
  std::unique_ptr<ZSTD_CStream, std::size_t (*)(ZSTD_CStream*)> stream{ZSTD_createCStream(), ZSTD_freeCStream};
};

Zstd::Zstd() : state_(std::make_unique<State>()) {
  if (state_->stream == nullptr) throw std::bad_alloc();
  (void)ZSTD_CCtx_setParameter(state_->stream.get(), ZSTD_c_checksumFlag, 1);
}
Zstd::~Zstd() = default;

bool Zstd::step(Buffers& buffers, bool last) {
  ZSTD_inBuffer in{buffers.in.data(), buffers.in.size(), 0};
  ZSTD_outBuffer out{buffers.out.data(), buffers.out.size(), buffers.size};
  const std::size_t left = ZSTD_compressStream2(state_->stream.get(), &out, &in, last ? ZSTD_e_end : ZSTD_e_continue);
  if (ZSTD_isError(left) != 0) throw std::bad_alloc();
  buffers.in.remove_prefix(in.pos);
  buffers.size = out.pos;
  return !buffers.in.empty() || (last && left > 0);
}

}  // namespace tcb
