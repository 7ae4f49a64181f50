// Reports of limits: maxima as decimals around them, as text and as JSON.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "limits/extremes.hpp"

namespace tcb::limits {

/// A maximum, and whether it is within its limit.
struct LimitResult {
  std::vector<std::string> curve;  ///< NAME=VALUE for each column of its group
  Measure measure;
  std::optional<Extreme> extreme;  ///< nothing: no time of the curve is measured
  std::optional<Rational> limit = {};
  bool passed = true;
  bool is_broken = false;  ///< by a jump of the velocity
};

struct CornerOfCurve {
  std::vector<std::string> curve;
  Corner corner;
};

struct LimitsReport {
  std::string keys;  ///< name of their file
  std::vector<std::string> channels;
  std::vector<LimitResult> results = {};
  std::vector<CornerOfCurve> corners = {};

  std::optional<Rational> first = {};  ///< the time of the first key
  bool has_ends_by_seconds = false;    ///< an end rule depends on a duration, so that other times make another curve

  bool passed() const { return std::ranges::all_of(results, &LimitResult::passed); }
  /// The result that is nearest to its limit, or beyond it the farthest; without limits the first one.
  const LimitResult* tightest() const;
};

/// Two decimals of at most 15 digits, which differ by one unit of the last digit, unless the bounds do not allow that.
struct DecimalBounds {
  Rational low, high;
};

/// Decimals around a number within bounds; with `root`, around the root of one.
DecimalBounds decimal_bounds(const Rational& low, const Rational& high, bool root);

/// The report in a few words, as text, and as a JSON object.
std::string in_short(const LimitsReport& report);
std::string text(const LimitsReport& report);
std::string json(const LimitsReport& report);

}  // namespace tcb::limits
