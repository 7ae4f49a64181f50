// Errors of the pipeline, in the order of its stages.
#include "run/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <new>
#include <stdexcept>
#include <system_error>

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

Error failure_of(const std::exception& failure) {
  if (const auto* const error = dynamic_cast<const Error*>(&failure)) return *error;
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&failure) != nullptr ||
                         dynamic_cast<const std::length_error*>(&failure) != nullptr;
  if (is_memory) return usage_error("out of memory");
  if (const auto* const refused = dynamic_cast<const std::system_error*>(&failure)) {
    return usage_error("the system refused a part of the work: {}", refused->code().message());
  }
  return usage_error("the program failed by a fault of its own, and wrote no output; report the command and its input");
}

Error duration_of_frames(std::string_view time) {
  return {Exit::usage,
          fmt::format("the times in column {} are frames, which have no duration; expected their rate; give "
                      "it with {}, as in {} 24, or give frames without a unit",
                      in_quotes(time), option::input_fps, option::input_fps)};
}

}  // namespace tcb
