// Column options: which columns of records are read, and in which roles.
#pragma once

#include <optional>
#include <vector>

#include "schema/roles.hpp"
#include "schema/sample_columns.hpp"

namespace tcb {

/// Which columns of records are read, and in which roles.
struct ColumnOptions {
  std::vector<RoleRequest> roles = {};
  bool timeless = false;                    ///< no column is the time, unless by its name
  std::optional<SampleNames> samples = {};  ///< the records are samples of a curve, not keys
};

}  // namespace tcb
