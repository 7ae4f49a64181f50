// Errors of exact rows.
#include "exact/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"

namespace tcb {

Error decimal_too_long() {
  return {Exit::data,
          fmt::format("a number has more digits than {0} takes; expected at most 10,000; shorten it, or remove {0}",
                      option::exact_input)};
}

Error row_needs_more_digits(std::string_view time) {
  return {Exit::data,
          fmt::format("the row at time {} has a number that cannot be computed to the requested digits; request fewer "
                      "with {} or {}",
                      time, option::digits, option::fixed)};
}

}  // namespace tcb
