// Ranking: the conventions of programs, how precise given numbers are, and which conventions fit them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/inputs.hpp"
#include "sample/build.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {

// conventions.cpp

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
std::vector<TcbOrders> distinct_orders(const KeptCurves& kept);

/// A way to make a curve of keys.
struct Convention {
  spline::TangentRule tangents = spline::TangentRule::velocity;
  spline::EndRule start = spline::EndRule::half, end = spline::EndRule::half;
  bool equal_speed = false;
  std::size_t order = 0;                                     ///< index into the distinct orders
  std::optional<spline::RotationCurve> rotation_curve = {};  ///< nothing: no rotations are compared
  std::optional<spline::Preset> rotation_preset = {};        ///< whose rules rotations have, if not those of positions
};

/// What is compared.
struct ComparedParts {
  bool closed = false;                                      ///< curves without ends
  bool positions = true;                                    ///< numbers that are none of a rotation
  std::vector<spline::RotationCurve> rotation_curves = {};  ///< those that are tried; none: no rotations are compared
};

/// What is compared of these inputs; `rules` are those that are given. Requires: columns of positions alone.
ComparedParts compared_parts(const CurveSettings& rules, const ComparisonInputs& inputs);

/// All conventions with the same rule for both ends, the most usual first. With positions and rotations, rotations have
/// the rules of positions, or those of a preset.
std::vector<Convention> conventions(std::size_t orders, const ComparedParts& parts);

/// The same convention with all pairs of different rules for the two ends.
std::vector<Convention> with_mixed_ends(const Convention& convention);

/// The settings of a convention. Requires: `others` have no rules.
CurveSettings settings_of(const Convention& convention, CurveSettings others, const ComparedParts& parts);

/// RULE or RULE,RULE.
std::string ends_of(const Convention& convention);

/// Names of the presets that are this convention, in what is compared.
std::vector<std::string> presets_of(const Convention& convention, const ComparedParts& parts);

// precision.cpp

/// Why a number may differ from the exact one, from the finest to the coarsest.
enum class Precision : std::uint8_t { rounding, printed_digits, single };
inline constexpr std::size_t precisions = 3;

/// How far a number may be off for each precision; 0 if that cannot be the reason.
using Allowance = std::array<double, precisions>;

/// Allowances for the numbers of one column. Rounding: 2^-40 of the largest number of the column or of the keys,
/// `size`. Printed digits: a unit in the last place that the column shows, in decimals or in significant digits.
/// Single: 2^-20 of the largest, if no number has more than nine digits or all are in single precision.
std::vector<Allowance> allowances(std::span<const double> column, double size);

/// Given rows of a curve, and the precision of their numbers.
struct GivenSamples {
  const KeptCurve* curve;
  SampleRows rows;
  std::vector<std::uint64_t> numbers;  ///< of these rows, from 1
  std::vector<Allowance> allowances;   ///< of each compared column, row after row
};

std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& inputs);

std::uint64_t count_rows(const std::vector<GivenSamples>& samples);

/// An evenly spread subset of all rows; if there are many keys, of the rows on the first keys.
struct Subset {
  std::vector<GivenSamples> samples;
  std::vector<KeptCurve> curves;  ///< the first keys of the curves that were cut
  bool all = false;               ///< it has all rows
};

/// At most 1,000 rows, fewer if several curves of rotations are tried, on 256 keys if the curve is open and has times,
/// so that its beginning is also a curve.
Subset subset_of(const std::vector<GivenSamples>& samples, const ComparisonInputs& inputs, const ComparedParts& parts);

// ranking.cpp

/// A convention, and how well it agrees with the samples.
struct Candidate {
  Convention convention;
  double largest = 0;                       ///< error of a position
  std::array<double, precisions> excess{};  ///< the largest error in allowances of each precision
  std::uint64_t rows_off = 0;               ///< rows with an error beyond all allowances
  std::optional<Difference> first, worst;   ///< of the first of these rows; the largest of all
};

/// The candidates by agreement: those that fit and are equivalent here, the most usual first; then those that are off
/// in at most a quarter of the rows, by the number of these rows; then the others; each part by the largest error.
struct Ranking {
  std::vector<Candidate> candidates;
  std::size_t fitting = 0;
  std::optional<Precision> precision;  ///< the finest with which any fits
};
Ranking ranked(std::vector<Candidate> candidates, std::uint64_t rows, const ComparedParts& parts);

struct Identification : ComparisonSummary {
  ComparedParts parts = {};
  std::uint64_t rows = 0;              ///< number of rows compared
  std::vector<TcbOrders> orders = {};  ///< the orders that differ for these keys
  std::uint64_t conventions = 0;       ///< number of conventions compared
  Ranking ranking = {};

  bool fits() const { return ranking.precision.has_value(); }
};

/// Compares the positions with those of every convention. If there are more, a subset of 1,000 rows and 256
/// keys selects the 64 best conventions and all that fit, which are then compared with all rows. Throws: Error as
/// check().
Identification identify(const Comparison& comparison);
Identification identify(const Comparison& comparison, ComparisonInputs inputs);

/// Reads both files, and drops what is not a position. Throws: Error, naming the file.
ComparisonInputs read_positions(const Comparison& comparison, FileProgress* progress = nullptr);

/// Compares the samples with the best convention. `observe` as for check().
Check check_best(const Comparison& comparison, const Identification& found, ComparisonInputs inputs,
                 const std::function<void(const CheckedPair& pair)>& observe);

}  // namespace tcb
