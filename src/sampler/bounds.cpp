// The checks that a request fits the curve, each with its message.
#include "sampler/bounds.hpp"

#include <fmt/format.h>

#include "error.hpp"

namespace tcb::sampler {
namespace {

/// A rational as a person reads it: the nearest double, shortest.
std::string text(const Rational& value) {
  const Time time = nearest_time(value);
  return time.lo == 0 ? fmt::format("{}", time.hi) : (Integer(time.hi) + Integer(time.lo)).str();
}

[[noreturn]] void refuse(std::string_view option, std::string_view side, std::string_view what, const Rational& value,
                         const Rational& bound) {
  throw Error(Exit::usage, fmt::format("{} {} lies {} {}, at {}; give a value within the curve", option, text(value),
                                       side, what, text(bound)));
}

}  // namespace

void require_not_before(std::string_view option, std::string_view what, const Rational& value, const Rational& bound) {
  if (value < bound) refuse(option, "before", what, value, bound);
}

void require_not_beyond(std::string_view option, std::string_view what, const Rational& value, const Rational& bound) {
  if (value > bound) refuse(option, "beyond", what, value, bound);
}

void require_resolution(const Grid& grid, const Time& end) {
  if (grid.resolves(end)) return;
  throw Error(Exit::usage,
              fmt::format("the step {} is too small: near {} two rows would get the same number; give a larger step",
                          text(grid.step()), text(exact_time(end))));
}

}  // namespace tcb::sampler
