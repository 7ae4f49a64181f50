// Errors of the pipeline, in the order of its stages.
#include "run/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

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

Error duration_of_frames(std::string_view time) {
  return {Exit::usage,
          fmt::format("the times in column {} are frames, which have no duration; expected their rate; give "
                      "it with {}, as in {} 24, or give frames without a unit",
                      in_quotes(time), option::input_fps, option::input_fps)};
}

}  // namespace tcb
