// Curve options: how the keys of an input make curves.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "numbers/rational.hpp"

namespace tcb {

/// The treatment of keys with equal times.
enum class Duplicates { error, first, last, break_curve, spread };

struct DuplicatesName {
  std::string_view name;
  Duplicates value;
};
inline constexpr std::array duplicates_names{
    DuplicatesName{"error", Duplicates::error}, DuplicatesName{"first", Duplicates::first},
    DuplicatesName{"last", Duplicates::last}, DuplicatesName{"break", Duplicates::break_curve},
    DuplicatesName{"spread", Duplicates::spread}};

/// How the keys of an input make curves.
struct CurveOptions {
  Duplicates duplicates = Duplicates::error;
  bool sort = false;
  std::optional<Rational> max_gap = {};  ///< where keys are further apart in time, a new curve begins
  bool is_max_gap_in_seconds = false;    ///< it is a duration, not in the unit of the times
  bool any_order = false;                ///< keys stay in the order of the input, whatever their times
};

}  // namespace tcb
