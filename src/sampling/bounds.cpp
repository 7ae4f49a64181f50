// The checks that a request fits the curve, each with its message.
#include "sampling/bounds.hpp"

#include <fmt/format.h>

#include "error.hpp"

namespace tcb {
namespace {

constexpr std::string_view outside_in_time = "give one within the curve, or --extrapolate";
constexpr std::string_view outside_in_length = "give one within the curve";

[[noreturn]] void refuse(std::string_view option, std::string_view side, const Rational& value, const Bound& bound) {
  throw Error(Exit::usage, fmt::format("{} {} lies {} {}, at {}; {}", option, text(value), side, bound.what,
                                       text(bound.value), bound.remedy));
}

}  // namespace

std::string text(const Rational& value) {
  const Time time = nearest_time(value);
  return time.lo == 0 ? fmt::format("{}", time.hi) : whole_text(Rational(time.hi) + Rational(time.lo));
}

Bound first_key(const Time& time) { return {"the first key", exact_time(time), outside_in_time}; }
Bound last_key(const Time& time) { return {"the last key", exact_time(time), outside_in_time}; }
Bound curve_start() { return {"the start", 0, outside_in_length}; }
Bound curve_length(double length) { return {"the curve's length", exact_time({length}), outside_in_length}; }

void require_not_before(std::string_view option, const Rational& value, const Bound& bound) {
  if (value < bound.value) refuse(option, "before", value, bound);
}

void require_not_beyond(std::string_view option, const Rational& value, const Bound& bound) {
  if (value > bound.value) refuse(option, "beyond", value, bound);
}

void require_resolution(const Grid& grid, const Time& end) {
  if (grid.resolves(end)) return;
  throw Error(Exit::usage,
              fmt::format("the step {} is too small: near {} two rows would get the same number; give a larger step",
                          text(grid.step()), text(exact_time(end))));
}

}  // namespace tcb
