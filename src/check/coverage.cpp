// Coverage: how much of a curve the given rows cover, and which of the expected rows are missing.
#include "check/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "check/problems.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/fields.hpp"
#include "sample/rows.hpp"
#include "schema/texts.hpp"

namespace tcb {
namespace {

/// The number that is read from the text of a place.
double as_printed(const Time& place, const Notation& notation) {
  std::string text(longest_number_in(notation) + spare_room, '\0');
  text.resize(static_cast<std::size_t>(write_time(place, notation, text.data()) - text.data()));
  return parse_number(text).value_or(place.hi);
}

/// Decides which rows are the expected ones.
class RowMatcher {
 public:
  RowMatcher(std::span<const Time> expected, const Notation& notation, const Limits& limits)
      : expected_(expected), notation_(notation), limits_(limits) {
    if (!expected.empty()) rounding_ = billionth * (expected.back() - expected.front()).hi;
  }

  /// Whether a row here is the expected one with this index.
  bool is_row(std::size_t index, const Time& place) const {
    const Time& wanted = expected_[index];
    const double apart = std::abs((place - wanted).hi);
    if (apart <= rounding_ || apart < part_of_gap * gap(index)) return true;
    if (limits_.admit(distance(place.hi, wanted.hi))) return true;
    const bool is_rounded = notation_.kind == Notation::Kind::digits || notation_.kind == Notation::Kind::fixed;
    return is_rounded && as_printed(wanted, notation_) == place.hi;
  }

 private:
  static constexpr double billionth = 1e-9;
  static constexpr double part_of_gap = 0.125;  ///< more than two decimals round off at 24 rows per second

  /// From an expected row to the nearest other one, which may be at the same place; 0 if there is none.
  double gap(std::size_t index) const {
    const auto row = expected_.begin() + static_cast<std::ptrdiff_t>(index);
    const bool is_last = index + 1 == expected_.size();
    if (index == 0) return is_last ? 0 : (row[1] - *row).hi;
    const double before = (*row - row[-1]).hi;
    return is_last ? before : std::min(before, (row[1] - *row).hi);
  }

  std::span<const Time> expected_;
  const Notation& notation_;
  const Limits& limits_;
  double rounding_ = 0;  ///< differences up to this are those of rounding
};

}  // namespace

std::vector<Time> expected_places(const ExpectedSamples& expected, const Comparison& comparison,
                                  const ComparisonInputs& inputs, const KeptCurve& curve) {
  const std::vector<std::size_t> fields{field_of(inputs.columns.by_length ? "s" : "time")};
  const Schema& schema = inputs.kept.schema;
  CurveSettings rules = comparison.keys.rules;
  if (!rules.metric) rules.metric = expected.metric;
  const CurveRequest request{.samples = expected.samples.of({curve.group, curve.curve_info, {}}, schema),
                             .rules = rules,
                             .fields = fields,
                             .threads = inputs.threads};
  CurvePipeline pipeline(request, schema, inputs.kept.traits, *curve.curve_info);
  const PlacedCurve placed = pipeline.place(curve.keys());
  std::vector<Time> places;
  while (const std::optional<SampleBlock> block = placed.blocks()) {
    const Table rows = placed.evaluate(*block, fields);
    places.insert(places.end(), rows.cells.begin(), rows.cells.end());
  }
  std::ranges::sort(places, std::less<>());
  return places;
}

std::optional<std::string> rows_differ(std::span<const Time> expected, const Places& found, const SampleRows& rows,
                                       const Notation& notation, const Limits& limits) {
  std::vector<std::size_t> order(found.places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::less<>(), [&](std::size_t i) { return found.places[i]; });
  const RowMatcher matcher(expected, notation, limits);
  RowCounts counts{expected.size(), order.size()};
  const auto miss = [&](std::size_t row) {
    if (counts.missing++ == 0) counts.first_missing = time_text(expected[row]);
  };
  const auto refuse = [&](std::size_t index) {
    if (counts.surplus++ > 0) return;
    counts.first_surplus = time_text(found.places[index]);
    counts.surplus_line = rows.lines[found.rows[index]];
  };
  std::size_t row = 0, next = 0;
  while (row < expected.size() && next < order.size()) {
    const Time& place = found.places[order[next]];
    if (matcher.is_row(row, place)) {
      ++row;
      ++next;
    } else if (place < expected[row]) {
      refuse(order[next++]);
    } else {
      miss(row++);
    }
  }
  for (; row < expected.size(); ++row) miss(row);
  for (; next < order.size(); ++next) refuse(order[next]);
  if (counts.missing == 0 && counts.surplus == 0) return std::nullopt;
  if (!order.empty()) counts.last_found = time_text(found.places[order.back()]);
  return rows_not_as_expected(counts);
}

Coverage coverage_of(const KeptCurve& curve, const ComparisonInputs& inputs, const WholeCurve& whole,
                     const Places& found) {
  Coverage coverage{group_title(inputs.kept.schema.groups, curve.group), inputs.place_name()};
  coverage.first = inputs.columns.by_length ? Time(0.0) : whole.extent.first;
  coverage.last = inputs.columns.by_length ? Time(whole.curve->curve().length().value) : *whole.extent.last;
  coverage.rows = found.places.size();
  if (found.places.empty()) return coverage;
  const auto [least, most] = std::ranges::minmax(found.places, std::less<>());
  coverage.covered = {least, most};
  return coverage;
}

}  // namespace tcb
