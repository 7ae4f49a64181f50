// Powers by square roots alone: the same bits on every machine, which no library's pow promises.
#pragma once

#include <cstdint>

#include "tcb/spline/scalar.hpp"

namespace tcb::spline {

/// x^exponent. With exponent = n + 0.b1 b2 b3... in binary, x^0.b1b2b3... is the nested root
/// sqrt(x^b1 sqrt(x^b2 sqrt(x^b3 ...))), worked out from inside.
/// Requires: x > 0, 0 <= exponent <= 16. Promises: right to some 2^-95.
inline DoubleDouble power(const DoubleDouble& x, double exponent) {
  constexpr int fraction_bits = 62;  // the bits left out change the exponent by less than 2^-62
  DoubleDouble whole_part(1);
  for (; exponent >= 1; exponent -= 1) whole_part = whole_part * x;
  auto bits = static_cast<std::uint64_t>(exponent * 0x1p62);
  const DoubleDouble root_of_x = sqrt(x);
  DoubleDouble root(1);
  for (int bit = 0; bit < fraction_bits; ++bit, bits >>= 1) {
    root = (bits & 1U) != 0 ? sqrt(root) * root_of_x : sqrt(root);
  }
  return whole_part * root;
}

}  // namespace tcb::spline
