// Identifying: which convention made someone's samples.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/candidate.hpp"
#include "compare/pairs.hpp"

namespace tcb {

struct Identified : Compared {
  bool closed = false;
  std::uint64_t rows = 0;              ///< that were compared
  std::vector<TcbOrders> orders = {};  ///< those that make a difference to these keys
  std::uint64_t conventions = 0;       ///< how many there are with them
  Ranking ranking = {};

  bool fits() const { return ranking.precision.has_value(); }
};

/// Compares the positions with those of every convention. Of many rows and keys, 1,000 rows and 256 keys choose the 64
/// best and all that fit, which are then compared with all. Throws: Error as check().
Identified identify(const Job& plan);

}  // namespace tcb
