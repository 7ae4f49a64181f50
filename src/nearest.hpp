// The known name nearest to an unknown one, for "did you mean".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tcb {

/// "; did you mean NAME?" with the known name nearest to `name`, or "" where none is near: within a
/// third of its letters changed, dropped, added or swapped for their other case.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

}  // namespace tcb
