// The curve of exact keys at any scalar.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "curve/keyed_curve.hpp"
#include "exact/exact_keys.hpp"
#include "exact/rounding.hpp"

namespace tcb {

/// The times of the keys at a scalar, and where a closed curve is back at the first one.
template <class S>
std::pair<std::vector<S>, std::optional<S>> exact_times(const ExactCurve& exact) {
  std::pair<std::vector<S>, std::optional<S>> result;
  auto& [times, end] = result;
  if (exact.end) end = scalar_of<S>(*exact.end);
  if (!exact.exponent) {
    for (const Rational& time : exact.keys.times) times.push_back(scalar_of<S>(time));
    return result;
  }
  if constexpr (spline::has_roots<S>) {
    const auto step = [&](std::size_t from, std::size_t to) {
      return parameter_step<S, Rational>(exact.keys.position(from), exact.keys.position(to), *exact.exponent,
                                         exact.rules.metric);
    };
    const std::size_t size = exact.keys.size();
    for (std::size_t i = 0; i < size; ++i) times.push_back(i == 0 ? S(0) : S(times.back() + step(i - 1, i)));
    if (exact.closed && !end) end = times.back() + step(size - 1, 0);
  }
  return result;
}

/// The curve at a scalar. Requires: exact.is_rational(), or a scalar with roots.
template <class S>
std::unique_ptr<const KeyedCurve<S>> curve_at(const ExactCurve& exact) {
  auto [times, end] = exact_times<S>(exact);
  spline::Keys<S> keys{exact.keys.channels, std::move(times), {}, {}, {}, {}};
  for (const Rational& position : exact.keys.positions) keys.positions.push_back(scalar_of<S>(position));
  for (const auto& tcb : exact.keys.tcbs) {
    keys.tcbs.push_back({scalar_of<S>(tcb.tension), scalar_of<S>(tcb.continuity), scalar_of<S>(tcb.bias)});
  }
  for (const auto& ease : exact.keys.eases) keys.eases.push_back({scalar_of<S>(ease.in), scalar_of<S>(ease.out)});
  keys.given = exact.keys.given;
  for (const auto& [in, out] : exact.keys.velocities) keys.velocities.push_back({scalar_of<S>(in), scalar_of<S>(out)});
  for (const auto& [x, y, z] : exact.keys.turns) {
    keys.turns.push_back({scalar_of<S>(x), scalar_of<S>(y), scalar_of<S>(z)});
  }
  const auto end_choice = [](const spline::EndChoice<Rational>& from) {
    spline::EndChoice<S> to{from.rule, {}};
    for (const Rational& value : from.velocity) to.velocity.push_back(scalar_of<S>(value));
    return to;
  };
  const spline::CurveRules<S> rules{
      exact.rules.tangents, end_choice(exact.rules.start), end_choice(exact.rules.end), exact.rules.equal_speed,
      exact.rules.metric,   exact.rules.rotations,         exact.rules.rotation_curve,  exact.rules.angles};
  return std::make_unique<const KeyedCurve<S>>(std::move(keys), exact.missing, rules, end);
}

}  // namespace tcb
