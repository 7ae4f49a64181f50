// Curve needs: what a request needs of a curve before its first row, decided once.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sample/curve_spec.hpp"
#include "sample/request.hpp"

namespace tcb {

struct CurveNeeds {
  bool all_keys = false;       ///< every key is read before the first row; otherwise memory is constant
  bool random_access = false;  ///< segments are needed in any order, so the curve is kept
  bool lengths = false;        ///< every segment is measured
  bool whole_length = false;   ///< the length of the whole curve is known before the first row
  bool single_key = false;     ///< a single key is enough
  bool angle_signs = false;    ///< whether any angle is negative is known before the first row, from all keys
  MetricUse metric = MetricUse::nothing;
};

/// What is known of the keys of an input before they are read.
struct KeyFacts {
  bool timed = false;     ///< they have times; otherwise the parameter of the specification makes them
  bool may_miss = false;  ///< positions may be missing
};

/// `fields`: those of the rows. `exact`: numbers are computed exactly.
CurveNeeds curve_needs(const SamplingRequest& request, std::span<const std::size_t> fields, const CurveSpec& spec,
                       const KeyFacts& keys, bool exact);

/// As in "all keys before the first row, the length of each segment".
std::string in_words(const CurveNeeds& needs);

}  // namespace tcb
