// The order of keys: where curves break off, times that repeat, and times that go back.
#pragma once

#include <array>
#include <string_view>

#include "input/input.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// What becomes of keys with equal times.
enum class Duplicates { error, first, last, break_curve };

/// How --duplicates names them.
struct DuplicatesName {
  std::string_view name;
  Duplicates way;
};
inline constexpr std::array duplicates_names{
    DuplicatesName{"error", Duplicates::error}, DuplicatesName{"first", Duplicates::first},
    DuplicatesName{"last", Duplicates::last}, DuplicatesName{"break", Duplicates::break_curve}};

/// The same keys without gaps, which leave breaks; a break between two blocks stands at the front of the later one.
Source<KeyBlock> without_gaps(Source<KeyBlock> blocks);

/// The keys whose times increase up to the next break. Times that go back, and those that repeat where that is
/// an error, are faults of the block. To find the last of equal times, one key is held back.
Source<KeyBlock> in_order(Source<KeyBlock> blocks, Duplicates duplicates);

}  // namespace tcb
