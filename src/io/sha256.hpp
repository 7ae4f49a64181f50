// SHA-256 of bytes that go by, for provenance.
//
// Source: FIPS 180-4; computed by Nettle.
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

  /// In 64 hexadecimal digits, of all bytes so far; the next ones begin anew.
  std::string digest();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcb
