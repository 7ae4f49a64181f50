// SHA-256 of bytes, and bytes in Base64; by Nettle, or by the libraries of Windows.
//
// Source: FIPS 180-4; RFC 4648.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace tcb {

class Sha256 {
 public:
  Sha256();
  ~Sha256();

  void add(std::string_view bytes);

  /// The checksum of all bytes so far, in 64 hexadecimal digits; the next bytes begin a new one.
  std::string digest();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The bytes in Base64 with padding, in one line.
std::string in_base64(std::string_view bytes);

}  // namespace tcb
