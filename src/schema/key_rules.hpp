// Key rules: how the cells of records become keys.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/rational.hpp"
#include "schema/missing.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

/// Scales of tension, continuity and bias: as they are, or from 0 to 50 as 3ds Max shows them.
enum class TcbScale {
  unknown,  ///< as they are, and checked if the preset's product shows another scale
  none,     ///< as they are
  max3ds,   ///< from 0 to 50, with 25 for 0
};

/// The names of the scales that can be given.
struct TcbScaleName {
  std::string_view name;
  TcbScale scale;
};
inline constexpr std::array tcb_scales{TcbScaleName{"3dsmax", TcbScale::max3ds}, TcbScaleName{"none", TcbScale::none}};

/// (v - 25) / 25, exactly.
inline Rational from_0_to_50(const Rational& v) { return (v - 25) / 25; }

/// How cells become keys.
struct KeyRules {
  std::optional<spline::Tcb<double>> tcb = {};  ///< of keys that have none; nothing: that of the file, or 0
  Missing missing = Missing::error;
  bool keeps_decimals = false;             ///< keys keep their numbers as written
  std::vector<std::string> signs = {};     ///< of missing cells, besides the common ones
  TcbScale tcb_scale = TcbScale::unknown;  ///< of the keys
};

}  // namespace tcb
