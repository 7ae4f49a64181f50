// Zstandard for Windows, where Debian has no library of it: an error.
#include "error.hpp"
#include "io/zstandard.hpp"

namespace tcb {

namespace {

[[noreturn]] void refuse() {
  throw usage_error(
      "this build of the program has no Zstandard (.zst); expected gzip (.gz) or no compression; convert the input "
      "with zstd -d, or give the output another ending");
}

}  // namespace

struct Unzstd::State {};
struct Zstd::State {};

Unzstd::Unzstd() { refuse(); }
Unzstd::~Unzstd() = default;
bool Unzstd::ended() const { return false; }
bool Unzstd::step(Buffers&) { return false; }

Zstd::Zstd() { refuse(); }
Zstd::~Zstd() = default;
bool Zstd::step(Buffers&, bool) { return false; }

}  // namespace tcb
