// Conventions: in how many ways programs make a curve of the same keys.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "compare/kept.hpp"
#include "curve/settings.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

/// What a program takes for tension, continuity and bias: which of the keys' three, and with which sign.
struct TcbOrder {
  std::array<std::size_t, 3> source{0, 1, 2};
  std::array<bool, 3> negative{};

  bool is_plain() const { return source == std::array<std::size_t, 3>{0, 1, 2} && negative == std::array<bool, 3>{}; }
  spline::Tcb<double> of(const spline::Tcb<double>& tcb) const;
  std::string name() const;  ///< as in "T,-B,C"
};

/// Orders that make no difference to any of the keys count once, under the name of the first.
struct TcbOrders {
  TcbOrder order;
  std::vector<std::string> same;  ///< names of the others
};

/// All 48 orders and signs, the plain one first.
std::vector<TcbOrders> distinct_orders(const KeptCurves& kept);

struct Convention {
  spline::TangentRule tangents = spline::TangentRule::velocity;
  spline::EndRule start = spline::EndRule::half, end = spline::EndRule::half;
  bool equal_speed = false;
  std::size_t order = 0;  ///< index into the orders at hand
};

/// All conventions with some orders and with one rule for both ends, the most usual first; `closed`: curves have none.
std::vector<Convention> conventions(std::size_t orders, bool closed);

/// The same convention with all pairs of different rules for the two ends.
std::vector<Convention> with_mixed_ends(const Convention& convention);

/// The settings that ask for a convention, over others that do not say anything about rules.
CurveSettings settings_of(const Convention& convention, CurveSettings others, bool closed);

/// As --ends has them.
std::string ends_of(const Convention& convention);

/// As in "tangents velocity, ends half".
std::string name_of(const Convention& convention, bool closed);

/// The presets that it is.
std::vector<std::string> presets_of(const Convention& convention, bool closed);

}  // namespace tcb
