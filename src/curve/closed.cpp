// Closed curves: where the period comes from, and keys that come round again.
#include "curve/closed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "keys/parameterize.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

bool same_position(const Keys& a, const Keys& b) { return std::ranges::equal(a.position(0), b.position(0)); }

void require_same_tcb(const Keys& first, const Keys& last, const KeyStore& keys) {
  if (last.tcb(0) == first.tcb(0)) return;
  throw Error(
      Exit::data, TextPosition{"", keys.last_line(), 0},
      fmt::format("this key closes the curve at the position of line {}, but with another tension, continuity or "
                  "bias; expected the same; correct one of the two",
                  keys.first_line()));
}

/// The end that the period gives. Requires: a period.
Time end_by_period(const Keys& first, const Keys& last, const Rational& period) {
  const Time end = nearest_time(exact_time(first.times[0]) + period);
  if (end > last.times[0]) return end;
  throw Error(Exit::data,
              fmt::format("--period: the curve is closed before its last key, at time {}; expected a longer "
                          "period; correct it",
                          time_text(last.times[0])));
}

/// The key with its time moved.
Keys moved(Keys key, const Time& by) {
  key.times[0] = key.times[0] + by;
  return key;
}

}  // namespace

Time close(KeyStore& keys, const CurvePlan& plan, bool timed) {
  const Keys first = keys.key(0);
  Keys last = keys.key(keys.size() - 1);
  std::optional<Time> end;
  if (plan.period) end = end_by_period(first, first, *plan.period);
  if (keys.size() > 1 && same_position(first, last)) {
    require_same_tcb(first, last, keys);
    if (end && *end != last.times[0]) {
      throw Error(
          Exit::data, TextPosition{"", keys.last_line(), 0},
          fmt::format("this key repeats the position of line {} and so ends the period, but --period says another; "
                      "take one of them out",
                      keys.first_line()));
    }
    end = last.times[0];
    keys.drop_last();
    if (keys.size() > 0) last = keys.key(keys.size() - 1);
  } else if (end) {
    end = end_by_period(first, last, *plan.period);
  } else if (!timed) {
    const double step =
        parameter_step(last.position(0), first.position(0), plan.parameter.value_or(0), plan.rules.metric);
    end = Time((last.times[0] + Time(step)).hi);
  }
  if (keys.size() < 2) throw Error(Exit::data, "a closed curve needs two distinct keys at least; add keys");
  if (!end) {
    throw Error(Exit::data,
                "nothing says when the closed curve is back at its first key; expected --period, or a last row "
                "that repeats the first position; give one");
  }
  return *end;
}

LinkedKeys going_round(const KeyStore& keys, const Time& end) {
  const Keys first = keys.key(0);
  const Keys last = keys.key(keys.size() - 1);
  const Time period = end - first.times[0];
  Keys again = moved(first, period);
  again.times[0] = end;
  spline::append(again, moved(keys.key(1), period), 0, 1);
  auto source = [kept = keys.source(), again = std::optional<Keys>(std::move(again))]() mutable {
    std::optional<Keys> block = kept();
    return block ? block : std::exchange(again, std::nullopt);
  };
  return {std::move(source), moved(last, -period)};
}

}  // namespace tcb
