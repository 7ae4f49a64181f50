// Decimals: from a double to the digits that stand for it, and from digits to the nearest double.
#include "text/decimal.hpp"

namespace tcb {

Decimal widened(const Decimal& decimal) {
  const int below = (static_cast<int>(std::bit_width(decimal.digits)) * 1233) >> 12;  // 1233 / 2^12: the logarithm of 2
  const int width = below + (decimal.digits >= whole_power_of_ten(below) ? 1 : 0);
  return {decimal.digits * whole_power_of_ten(17 - width), decimal.exponent - (17 - width)};
}

Decimal shortest(double value) {
  const Binary v(value);
  const bool odd = v.m % 2 != 0;
  const bool at_power_of_two = v.m == Binary::hidden && v.bits > Binary::hidden;  // near from below

  // In units of 10^-p the doubles that read back as the value fill an interval at least 1 and less than 10 wide: at
  // most one of its integers ends in 0, and is then shorter than all others. With 70 bits after the point no product
  // seems to be whole, or half, that is not.
  const int p = -(at_power_of_two ? floor_log10_of_three_quarters(v.q) : floor_log10_power_of_two(v.q));
  const Uint128 g = power_significand(p);
  const int shift = v.q + floor_log2_power_of_ten(p) + 5;
  constexpr int point = 70;
  const auto scaled = [&](std::uint64_t quarters) { return high_product(quarters << shift, g); };

  const Uint128 middle = scaled(4 * v.m);
  const Uint128 lower = scaled(4 * v.m - (at_power_of_two ? 1 : 2)) - (odd ? 0 : 1);  // an even m has its ends
  const Uint128 upper = scaled(4 * v.m + 2) - (odd ? 1 : 0);
  const auto below = static_cast<std::uint64_t>(lower >> point);
  const auto last = static_cast<std::uint64_t>(upper >> point);
  const auto whole = static_cast<std::uint64_t>(middle >> point);
  constexpr Uint128 almost_half = (Uint128{1} << (point - 1)) - 1;
  const auto nearest = static_cast<std::uint64_t>((middle + almost_half + whole % 2) >> point);

  const std::uint64_t round = last / 10 * 10;
  return widened({round > below ? round : std::max(nearest, below + 1), -p});
}

}  // namespace tcb
