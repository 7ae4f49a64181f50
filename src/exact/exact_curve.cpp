// The curve of exact keys at any scalar: keys, rules and rotations converted.
#include "exact/exact_curve.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/rounding.hpp"
#include "tcb/spline/rotation_notation.hpp"

namespace tcb {
namespace {

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

/// Converts the quaternions of keys that give a rotation in another form, and their turns. Requires: `keys` has those
/// of the rounded numbers, which decide the signs of the quaternions, and which keys have a turn.
template <class S>
void convert_rotation(const ExactRotation& exact, spline::Keys<S>& keys) {
  const auto& [columns, notation, relative, in_parent] = exact.rotation;
  spline::Quaternion<S> before{S(0), S(0), S(0), S(1)};
  for (std::size_t key = 0; key < exact.numbers.size(); ++key) {
    spline::RotationNumbers<S> numbers;
    std::ranges::transform(exact.numbers[key], numbers.begin(), [](const Rational& x) { return scalar_of<S>(x); });
    spline::Quaternion<S> q = spline::quaternion_from(numbers, notation);
    if (relative) {
      const std::size_t own = key % keys.size();  // the turn to a key that repeats the first one is the first one's
      if (key > 0 && columns.turn && numbers[3] != S(0)) {
        spline::TurnVector<S>& turn = keys.turns[own * keys.turns_per_key() + *columns.turn];
        const bool has_turn = turn != spline::TurnVector<S>{};
        if (has_turn) turn = spline::turn_vector_from(numbers, notation.degrees, before, in_parent);
      }
      q = before = spline::after_turn(before, q, in_parent);
    }
    const std::size_t first = key * keys.channels;
    if (key == keys.size() || keys.is_missing(key, columns.channels[0])) continue;
    std::array<S*, 4> rounded;
    std::ranges::transform(columns.channels, rounded.begin(),
                           [&](std::size_t i) { return &keys.positions[first + i]; });
    const auto& [x, y, z, w] = rounded;
    if (dot(q, {*x, *y, *z, *w}) < S(0)) q = -q;
    std::tie(*x, *y, *z, *w) = std::tie(q.x, q.y, q.z, q.w);
  }
}

/// The keys of a curve at a scalar.
template <class S>
spline::Keys<S> exact_keys(const ExactCurve& exact, std::vector<S> times) {
  spline::Keys<S> keys;
  keys.channels = exact.keys.channels;
  keys.given = exact.keys.given;
  keys.missing = exact.keys.missing;
  keys.times = std::move(times);
  const auto number = [](const Rational& value) { return scalar_of<S>(value); };
  keys.positions.reserve(exact.keys.positions.size());
  std::ranges::transform(exact.keys.positions, std::back_inserter(keys.positions), number);
  for (const auto& [tension, continuity, bias] : exact.keys.tcbs) {
    keys.tcbs.push_back({number(tension), number(continuity), number(bias)});
  }
  for (const auto& [in, out] : exact.keys.eases) keys.eases.push_back({number(in), number(out)});
  for (const auto& [in, out] : exact.keys.velocities) keys.velocities.push_back({number(in), number(out)});
  for (const auto& [x, y, z] : exact.keys.turns) keys.turns.push_back({number(x), number(y), number(z)});
  if constexpr (spline::has_roots<S>) {
    for (const ExactRotation& rotation : exact.converted) convert_rotation(rotation, keys);
  }
  return keys;
}

}  // namespace

template <class S>
std::unique_ptr<const spline::CurveKeys<S>> curve_at(const ExactCurve& exact) {
  auto [times, end] = exact_times<S>(exact);
  auto rules = spline::converted<S>(exact.rules, [](const Rational& value) { return scalar_of<S>(value); });
  return std::make_unique<const spline::CurveKeys<S>>(exact_keys<S>(exact, std::move(times)), std::move(rules), end);
}

template std::unique_ptr<const spline::CurveKeys<Rational>> curve_at(const ExactCurve& exact);
template std::unique_ptr<const spline::CurveKeys<Ball>> curve_at(const ExactCurve& exact);
template std::unique_ptr<const spline::CurveKeys<RealBall>> curve_at(const ExactCurve& exact);

template class spline::CurveKeys<Rational>;
template class spline::CurveKeys<Ball>;
template class spline::CurveKeys<RealBall>;

}  // namespace tcb
