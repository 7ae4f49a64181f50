// Conventions: the ways in which programs make a curve of the same keys, and their names as rules and presets.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "check/inputs.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

/// How a program takes tension, continuity and bias from the three numbers of a key: which of them, and its sign.
struct TcbOrder {
  std::array<std::size_t, 3> source{0, 1, 2};
  std::array<bool, 3> negative{};

  bool is_plain() const { return source == std::array<std::size_t, 3>{0, 1, 2} && negative == std::array<bool, 3>{}; }
  spline::Tcb<double> of(const spline::Tcb<double>& tcb) const;
  std::string name() const;  ///< such as "T,-B,C"
};

/// An order, and the others that are equivalent to it for all keys.
struct TcbOrders {
  TcbOrder order;
  std::vector<std::string> same;  ///< names of the others
};

/// Number of all orders and signs.
inline constexpr std::size_t all_tcb_orders = 48;

/// The orders that differ for these keys, the usual one first.
std::vector<TcbOrders> distinct_orders(const KeptInput& kept);

/// A way to make a curve of keys.
struct Convention {
  spline::TangentRule tangents = {};
  spline::EndRule start = {}, end = {};
  bool equal_speed = false;
  std::size_t order = 0;                                     ///< index into the distinct orders
  std::optional<spline::RotationCurve> rotation_curve = {};  ///< nothing: no rotations are compared
  std::optional<spline::Preset> rotation_preset = {};        ///< whose rules rotations have, if not those of positions
  spline::Timing timing = spline::Timing::even;

  /// Straight lines, which have neither ends nor speeds nor tension, continuity and bias.
  bool is_linear() const { return tangents == spline::TangentRule::linear; }
};

struct ComparedParts {
  bool closed = false;                                      ///< curves without ends
  bool may_be_timed = true;                                 ///< keys can have monotone timing
  bool positions = true;                                    ///< numbers that are none of a rotation
  std::vector<spline::RotationCurve> rotation_curves = {};  ///< those that are tried; none: no rotations are compared
};

/// What is compared of these inputs; `rules` are those that are given. Requires: columns of positions alone.
ComparedParts compared_parts(const CurveSettings& rules, const ComparisonInputs& inputs);

/// All conventions with the same rule for both ends, the most usual first. With positions and rotations, rotations have
/// the rules of positions, or those of a preset.
std::vector<Convention> conventions(std::size_t orders, const ComparedParts& parts);

/// The convention with all pairs of different rules for the two ends, if these matter.
std::vector<Convention> with_mixed_ends(const Convention& convention);

/// The settings of a convention. Requires: `others` have no rules.
CurveSettings settings_of(const Convention& convention, CurveSettings others, const ComparedParts& parts);

/// RULE or RULE,RULE; nothing: the curve has no ends, or their rule does not matter.
std::optional<std::string> ends_of(const Convention& convention, const ComparedParts& parts);

/// Names of the presets that are this convention, in what is compared.
std::vector<std::string> presets_of(const Convention& convention, const ComparedParts& parts);

}  // namespace tcb
