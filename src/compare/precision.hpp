// The precision of someone's numbers: how far each may be from the exact one by rounding and printing alone.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace tcb {

/// What may part a number from the exact one, the finest first.
inline constexpr std::array<std::string_view, 3> precisions{"rounding", "the printed digits", "single precision"};

/// How far a number may be off for each of them; 0 where that cannot be the reason.
using Allowance = std::array<double, precisions.size()>;

/// Of the numbers of one column, one each. Rounding: 2^-40 of the largest number of the column or of the keys, `size`.
/// Printed digits: a unit in the last place that the column shows, in decimals or in significant digits.
/// Single precision: 2^-20 of the largest, where no number has more than nine digits or all are single precision.
std::vector<Allowance> allowances(std::span<const double> column, double size);

}  // namespace tcb
