// Extrapolation: which place on the curve stands for a time before its first key or after its last.
#pragma once

#include <array>
#include <string_view>

#include "text/rational.hpp"

namespace tcb {

enum class Extrapolation { error, hold, linear, repeat, offset, oscillate };

struct NamedExtrapolation {
  std::string_view name;
  Extrapolation kind;
  std::string_view meaning;
};

/// Every way by name; the first is the default.
inline constexpr std::array extrapolations{
    NamedExtrapolation{"error", Extrapolation::error, "times outside the curve are refused"},
    NamedExtrapolation{"hold", Extrapolation::hold, "the curve rests at its end keys"},
    NamedExtrapolation{"linear", Extrapolation::linear, "it goes on straight, with the velocity of its ends"},
    NamedExtrapolation{"repeat", Extrapolation::repeat, "it starts again"},
    NamedExtrapolation{"offset", Extrapolation::offset, "it starts again from where it ended"},
    NamedExtrapolation{"oscillate", Extrapolation::oscillate, "it runs back and forth"},
};

/// How a time outside the curve relates to one inside.
struct Outside {
  Time t;                 ///< the time on the curve that stands for it
  double cycles = 0;      ///< for offset: how often last key - first key is to be added
  Time beyond = 0.0;      ///< for linear: how far it lies outside, negative before the first key
  bool holds = false;     ///< nothing moves here
  bool backward = false;  ///< time runs backward here
};

/// Requires: first < last; kind is not error, or t lies on the curve.
Outside map_to_curve(Extrapolation kind, const Time& first, const Time& last, const Time& t);

}  // namespace tcb
