// SHA-256 of bytes; by Nettle, or by the library of Windows.
//
// Source: FIPS 180-4.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace tcb {

class Sha256 {
 public:
  Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  ~Sha256();

  void add(std::string_view bytes);

  /// The checksum of all bytes so far, in 64 hexadecimal digits; the next bytes begin a new one.
  std::string digest();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcb
