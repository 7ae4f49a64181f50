// Sample columns: the columns of samples of a curve, which have the names that the program gives them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schema/columns.hpp"

namespace tcb {

/// The names that samples of a curve are expected to have.
struct SampleNames {
  std::string time;                      ///< of the time column, if it is not one of the usual names
  std::vector<std::string> groups = {};  ///< of the group columns, if they are there
  std::vector<std::string> labels = {};  ///< of columns to ignore
  std::size_t time_place = 0;            ///< where columns have no names: how many are before the time, without groups
  std::vector<Renaming> maps = {};       ///< of columns of the samples
  std::string_view times_only = {};      ///< nothing is read but the groups and `time`, which this option names
};

/// The columns of samples: the time, the groups, and every other column of numbers as a channel, whatever its name.
/// Throws: Error (data) as find_columns.
Columns find_sample_columns(std::span<const std::string> given, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless);

}  // namespace tcb
