// Errors of the pipeline, in the order of its stages.
#include "run/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "option_names.hpp"
#include "text/suggest.hpp"

namespace tcb {

Error parameter_with_times(std::string_view time) {
  return {Exit::data, fmt::format("column \"{}\" has times already; expected keys without times; remove {}, or choose "
                                  "the columns with {}",
                                  time, option::parameter, option::columns)};
}

Error group_without_places(const std::vector<std::string>& curve) {
  return {Exit::data, fmt::format("the file has no rows for the curve {}; expected rows for each curve; add some",
                                  fmt::join(curve, ", "))};
}

Error out_of_memory() { return {Exit::usage, "out of memory"}; }

Error unexpected_failure(const char* what) { return {Exit::usage, what}; }

}  // namespace tcb
