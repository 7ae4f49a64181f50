// Keys as exact numbers, and the curves that they make at any scalar.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "curve/keyed_curve.hpp"
#include "exact/rounding.hpp"
#include "input/input.hpp"
#include "sampling/extrapolation.hpp"
#include "tcb/spline/window.hpp"
#include "text/decimal_time.hpp"

namespace tcb {

/// The rules with exact numbers.
spline::CurveRules<Rational> exact_rules(const spline::CurveRules<double>& rules, bool decimal);

/// A curve without any rounding.
struct ExactCurve {
  spline::Keys<Rational> keys;  ///< the times have no meaning where distances make them
  std::vector<bool> missing;    ///< which positions are; empty: none
  spline::CurveRules<Rational> rules;
  std::optional<double> exponent;  ///< of the distances that make the times
  bool closed = false;
  std::optional<Rational> end;  ///< when a closed curve is back at its first key, unless a distance gives it
  Extrapolation extrapolation = Extrapolation::error;
  bool decimal = false;  ///< numbers are the decimals that they are written as

  /// All numbers are rational: no distance makes a time or a tangent.
  bool is_rational() const { return !exponent && !rules.equal_speed; }
};

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
  const auto end_choice = [](const spline::EndChoice<Rational>& from) {
    spline::EndChoice<S> to{from.rule, {}};
    for (const Rational& value : from.velocity) to.velocity.push_back(scalar_of<S>(value));
    return to;
  };
  const spline::CurveRules<S> rules{exact.rules.tangents, end_choice(exact.rules.start), end_choice(exact.rules.end),
                                    exact.rules.equal_speed, exact.rules.metric};
  return std::make_unique<const KeyedCurve<S>>(std::move(keys), exact.missing, rules, end);
}

/// What is certain about the channels of a curve from its keys alone.
struct ChannelFacts {
  Rational extent = 0;          ///< how far a key is from the first one in a channel, at most
  std::vector<bool> constant;   ///< all keys have the same position there
  std::vector<bool> zero;       ///< all keys have the position 0 there
  std::vector<Rational> cycle;  ///< last key - first key there
};
ChannelFacts channel_facts(const ExactCurve& exact);

/// Keys made exact as they go by.
class ExactKeys {
 public:
  /// `decimal`: a number is the decimal that it is written as, not the double nearest to it.
  explicit ExactKeys(bool decimal) : decimal_(decimal) {}

  /// Throws: Error (data) for a decimal with too many digits.
  void add(const KeyBlock& block);

  /// Gives the keys of a block, the last one that was added, the times that their distances make, rounded once.
  void set_times(KeyBlock& block, double exponent, std::span<const std::size_t> metric);

  /// When a closed curve is back at its first key by the distance to it.
  Time time_back(double exponent, std::span<const std::size_t> metric) const;

  std::size_t size() const { return keys_.size(); }

  /// Requires: a key.
  const Rational& first_time() const { return keys_.times[0]; }

  /// The curve of the first `size` keys; where it is closed, its end is the time of the key after them, or `end`.
  ExactCurve curve(std::size_t size, const spline::CurveRules<double>& rules, const std::optional<Rational>& end) const;

 private:
  template <class Numbers>
  void add_velocities(const Keys& keys, std::size_t key, const Numbers& number);

  bool decimal_;
  spline::Keys<Rational> keys_;
  std::vector<bool> missing_;
  Rational time_;  ///< of the last key, where distances make it: exactly that of a float
};

}  // namespace tcb
