// Zstandard for Windows, where Debian has no library of it: an error.
#include "io/errors.hpp"
#include "io/zstandard.hpp"

namespace tcb {

struct Unzstd::State {};
struct Zstd::State {};

Unzstd::Unzstd() { throw no_zstandard(); }
Unzstd::~Unzstd() = default;
bool Unzstd::ended() const { return false; }
bool Unzstd::step(Buffers&) { return false; }

Zstd::Zstd() { throw no_zstandard(); }
Zstd::~Zstd() = default;
bool Zstd::step(Buffers&, bool) { return false; }

}  // namespace tcb
