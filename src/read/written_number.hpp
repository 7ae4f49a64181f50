// Written numbers: numbers of a file, with what is written there.
#pragma once

#include <string>

#include "numbers/rational.hpp"

namespace tcb {

/// A number, and its decimal or ratio, which is exact.
struct WrittenNumber {
  double value = 0;
  std::string decimal = "0";
};

inline Rational exact_number(const WrittenNumber& number) {
  return parse_rational(number.decimal).value_or(Rational(number.value));
}

}  // namespace tcb
