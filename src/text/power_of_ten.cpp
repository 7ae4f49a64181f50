// Powers of ten to 128 bits, made by the compiler.
#include "text/power_of_ten.hpp"

namespace tcb {
namespace {

/// A significand of 256 bits, high 2^128 + low. The 342 steps below lose less than 12 of its last bits, so
/// that the upper 128 bits are right (a test compares them with exact integers).
struct Wide {
  Uint128 high, low;
};

constexpr Wide shifted_right(const Wide& w, int bits) {
  return {w.high >> bits, w.low >> bits | w.high << (128 - bits)};
}

/// The same number with its highest bit set, as powers of two do not matter here.
constexpr Wide normalized(Wide w) {
  while (w.high >> 127 == 0) w = {w.high << 1 | w.low >> 127, w.low << 1};
  return w;
}

constexpr Wide times_five(const Wide& w) {
  const Wide half = shifted_right(w, 1);
  const Wide eighth = shifted_right(w, 3);
  const Uint128 low = half.low + eighth.low;
  return normalized({half.high + eighth.high + (low < half.low ? 1 : 0), low});
}

constexpr Wide fifth(const Wide& w) {
  constexpr Uint128 fifth_of_2_to_128 = ~Uint128{0} / 5;  // and 1 over
  const Uint128 rest = w.high % 5;
  return normalized({w.high / 5, rest * fifth_of_2_to_128 + w.low / 5 + (rest + w.low % 5) / 5});
}

constexpr Uint128 rounded_up(const Wide& w) { return w.high + (w.low != 0 ? 1 : 0); }

constexpr auto make_significands() {
  std::array<Uint128, most_power - least_power + 1> table{};
  constexpr Wide one{Uint128{1} << 127, 0};
  auto entry = table.begin() - least_power;
  for (Wide w = one; entry != table.end(); w = times_five(w)) *entry++ = rounded_up(w);
  entry = table.begin() - least_power;
  for (Wide w = one; entry != table.begin();) *--entry = rounded_up(w = fifth(w));
  return table;
}

}  // namespace

constinit const std::array<Uint128, most_power - least_power + 1> power_significands = make_significands();

}  // namespace tcb
