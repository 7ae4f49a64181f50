// Units of time: their names for options, and how many of them a second has.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "text/rational.hpp"

namespace tcb {

enum class TimeUnit { s, ms, us, ns, minutes, hours, days, frames };

/// A second has units / seconds of a unit. A frame has no duration of its own.
struct TimeUnitRow {
  std::string_view name;
  TimeUnit unit;
  std::int64_t units, seconds = 1;
};

/// The units by their names for options, in the order of TimeUnit.
inline constexpr std::array time_units{
    TimeUnitRow{"s", TimeUnit::s, 1},
    TimeUnitRow{"ms", TimeUnit::ms, 1'000},
    TimeUnitRow{"us", TimeUnit::us, 1'000'000},
    TimeUnitRow{"ns", TimeUnit::ns, 1'000'000'000},
    TimeUnitRow{"min", TimeUnit::minutes, 1, 60},
    TimeUnitRow{"h", TimeUnit::hours, 1, 3'600},
    TimeUnitRow{"d", TimeUnit::days, 1, 86'400},
    TimeUnitRow{"frames", TimeUnit::frames, 1},
};

inline const TimeUnitRow& row_of(TimeUnit unit) { return time_units[static_cast<std::size_t>(unit)]; }

/// How many units a second has. Requires: not frames.
inline Rational units_per_second(TimeUnit unit) { return Rational(row_of(unit).units) / row_of(unit).seconds; }

}  // namespace tcb
