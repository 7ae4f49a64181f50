// Keys as exact numbers: what a golden curve is made from.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "input/input.hpp"
#include "sampling/extrapolation.hpp"
#include "tcb/spline/window.hpp"
#include "text/rational.hpp"

namespace tcb {

/// A double's own value; with `decimal` its shortest decimal. IndexedCurve numbers of times are what they are.
Rational exact_number(const Time& time, bool decimal);

/// The rules with exact numbers.
spline::CurveRules<Rational> exact_rules(const spline::CurveRules<double>& rules, bool decimal);

/// What a curve is, without any rounding.
struct ExactCurve {
  spline::Keys<Rational> keys;  ///< the times say nothing where distances make them
  std::vector<bool> missing;    ///< which positions are; empty: none
  spline::CurveRules<Rational> rules;
  std::optional<double> exponent;  ///< of the distances that make the times
  bool closed = false;
  std::optional<Rational> end;  ///< when a closed curve is back at its first key, unless a distance says it
  Extrapolation extrapolation = Extrapolation::error;
  bool decimal = false;  ///< numbers are the decimals that they are written as

  /// All numbers are rational: no distance makes a time or a tangent.
  bool is_rational() const { return !exponent && !rules.equal_speed; }
};

/// Keys made exact as they go by.
class ExactKeys {
 public:
  /// `decimal`: a number is the decimal that it is written as, not the double nearest to it.
  explicit ExactKeys(bool decimal) : decimal_(decimal) {}

  /// Throws: Error (data) for a decimal with more digits than are taken.
  void add(const KeyBlock& block);

  /// Gives the keys of a block, the last one that was added, the times that their distances make, rounded once.
  void set_times(KeyBlock& block, double exponent, std::span<const std::size_t> metric);

  /// When a curve that is closed is back at its first key by the distance to it.
  Time time_back(double exponent, std::span<const std::size_t> metric) const;

  std::size_t size() const { return keys_.size(); }

  /// Requires: a key.
  const Rational& first_time() const { return keys_.times[0]; }

  /// The keys without those behind the first `size`, and when a closed curve is back, by its last key or by `end`.
  ExactCurve curve(std::size_t size, const spline::CurveRules<double>& rules, const std::optional<Rational>& end) const;

 private:
  bool decimal_;
  spline::Keys<Rational> keys_;
  std::vector<bool> missing_;
  Rational time_;  ///< of the last key, where distances make it: exactly that of a float
};

}  // namespace tcb
