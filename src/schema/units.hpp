// Units: factors of the numbers of keys, and the unit of their times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "schema/columns.hpp"
#include "schema/key_rules.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// The factor of a channel's positions.
struct ChannelScale {
  std::string channel;
  Rational factor;
};

/// What is requested of units.
struct UnitOptions {
  std::optional<TimeUnit> time = {};        ///< nothing: that of the column's name, if it has one
  std::optional<Rational> frame_rate = {};  ///< the times are frames, so many of them a second
  std::vector<ChannelScale> scales = {};    ///< factors of channels
  bool of_samples = false;                  ///< times are frames only where the column's name says so
};

/// Sets the notation of the times, by the first of them, and the factors of the numbers. Throws: Error (data) for
/// timecode without a rate, units of time that contradict each other, and a channel that no column is.
void set_units(KeyRules& rules, const UnitOptions& options, const Columns& columns, std::string_view first_time);

/// The meaning of records once their times have the unit to which set_units() converts them. Throws: Error (data) for
/// a unit of times that records do not have.
Schema with_unit(Schema schema, const UnitOptions& options);

}  // namespace tcb
