// Golden rows: every number of a row is what exact arithmetic gives, rounded once.
#include "exact/golden_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "exact/places.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

/// The floats, each with twice the digits of the one before.
template <class S>
using CurveAt = std::unique_ptr<GoldenCurve<S>>;
using Ladder = std::tuple<CurveAt<Float<40>>, CurveAt<Float<80>>, CurveAt<Float<160>>, CurveAt<Float<320>>>;

}  // namespace

class GoldenRows::Evaluation {
 public:
  Evaluation(ExactCurve curve, std::optional<ArcPlaces> arc, bool left, const Notation& notation)
      : exact_(std::move(curve)), arc_(std::move(arc)), left_(left), notation_(notation) {}

  void add_row(const FastRow& row, std::span<const std::size_t> chosen, Table& table) {
    std::vector<Column> columns;
    for (const std::size_t field : chosen) {
      const Field& known = fields()[field];
      const bool rational = exact_.is_rational() && !arc_ && quantity<Rational>(field).rational;
      columns.insert(columns.end(), known.per_channel ? exact_.keys.channels : 1, {known.kind, rational});
    }
    std::vector<Printed> cells;
    try {
      cells = climb<1>(row, chosen, columns, values(std::get<0>(ladder_), row, chosen));
    } catch (const std::range_error&) {
      throw Error(Exit::data,
                  fmt::format("the row at time {} has a number that cannot be worked out to so many digits; expected "
                              "fewer; give a smaller number to --digits or --fixed",
                              time_text(row.sample.t)));
    }
    for (Printed& printed : cells) {
      if (!is_empty(printed.cell) && !std::isfinite(printed.cell.hi)) refuse_overflow(row.sample);
      table.cells.push_back(printed.cell);
      if (has_texts()) table.texts.push_back(std::move(printed.text));
    }
  }

 private:
  /// A column of the row at hand; where it is rational, or the root of a rational, there are more digits than floats
  /// have.
  struct Column {
    CellKind kind;
    bool rational;
  };

  template <class S>
  static const Quantity<S>& quantity(std::size_t field) {
    return *std::ranges::find(quantities<S>, fields()[field].name, &Quantity<S>::name);
  }

  bool has_texts() const {
    using enum Notation::Kind;
    return notation_.kind == digits || notation_.kind == fixed;
  }

  /// The values of some fields, worked out at a scalar.
  template <class S>
  std::vector<Value> values(CurveAt<S>& curve, const FastRow& row, std::span<const std::size_t> chosen) const {
    if (curve == nullptr) curve = std::make_unique<GoldenCurve<S>>(exact_);
    Spot<S> spot;
    if constexpr (spline::has_roots<S>) {
      if (arc_) spot = spot_at_length(row, *arc_, *curve);
    }
    if (!arc_) spot = spot_at_time(row, exact_, left_, *curve);
    const GoldenPoint<S> point(*curve, std::move(spot));
    std::vector<Value> result;
    for (const std::size_t field : chosen) (point.*quantity<S>(field).append)(result);
    return result;
  }

  /// The cells of a row by floats of a level and of the one below it; what they leave in doubt, by rationals, or by the
  /// levels above.
  template <std::size_t level>
  std::vector<Printed> climb(const FastRow& row, std::span<const std::size_t> chosen, std::span<const Column> columns,
                             const std::vector<Value>& rough) {
    constexpr bool last = level + 1 == std::tuple_size_v<Ladder>;
    const std::vector<Value> fine = values(std::get<level>(ladder_), row, chosen);
    std::vector<Value> exact;
    std::vector<Printed> cells;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Rounding rounding(notation_, columns[i].kind);
      auto cell = rounding.between(rough[i], fine[i]);
      if (!cell && columns[i].rational) {
        if (exact.empty()) exact = values(rational_, row, chosen);
        cell = rounding.exactly(exact[i]);
      } else if (!cell) {
        if constexpr (!last) return climb<level + 1>(row, chosen, columns, fine);
        cell = rounding.at_last(rough[i], fine[i]);
      }
      cells.push_back(std::move(*cell));
    }
    return cells;
  }

  ExactCurve exact_;
  std::optional<ArcPlaces> arc_;
  bool left_;
  Notation notation_;
  CurveAt<Rational> rational_;
  Ladder ladder_;
};

bool has_field(std::string_view name) {
  return std::ranges::count(quantities<Rational>, name, &Quantity<Rational>::name) > 0;
}

GoldenRows::GoldenRows(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& notation)
    : evaluation_(
          std::make_unique<Evaluation>(std::move(curve), arc_places(request, extent), request.from_left, notation)) {}
GoldenRows::~GoldenRows() = default;

Table GoldenRows::evaluate(const SampleBlock& batch, const Locator& locator, std::span<const std::size_t> chosen) {
  Table table;
  Located located;
  for (const auto& [piece, first, last] : batch.parts) {
    locator.locate(piece, first, last, located);
    for (std::size_t i = 0; i < located.samples.size(); ++i) {
      evaluation_->add_row({piece, located.samples[i], first + i}, chosen, table);
    }
  }
  return table;
}

}  // namespace tcb
