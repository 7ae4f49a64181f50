// Golden rows: every number of a row is what exact arithmetic gives, rounded once.
#include "golden/golden_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "format/number.hpp"

namespace tcb::golden {
namespace {

using format::CellKind;

/// The floats, each with twice the digits of the one before.
template <class S>
using CurveAt = std::unique_ptr<Curve<S>>;
using Ladder = std::tuple<CurveAt<Float<40>>, CurveAt<Float<80>>, CurveAt<Float<160>>, CurveAt<Float<320>>>;

}  // namespace

class Rows::Evaluation {
 public:
  Evaluation(ExactCurve curve, std::optional<ArcPlaces> arc, bool left, const format::Notation& notation)
      : exact_(std::move(curve)), arc_(std::move(arc)), left_(left), notation_(notation) {}

  void add_row(const FastRow& row, std::span<const std::size_t> chosen, Table& table) {
    const bool rational = exact_.is_rational() && !arc_;
    const std::size_t first = table.cells.size();
    std::vector<std::size_t> hard;  // fields that floats have to give, and where their cells are to go
    std::vector<std::size_t> places;
    for (const std::size_t field : chosen) {
      const Field& known = fields()[field];
      const std::size_t columns = known.per_channel ? exact_.keys.channels : 1;
      if (rational && quantity<Rational>(field).rational) {
        const std::size_t one[] = {field};
        for (const Value& value : values(rational_, row, one))
          put(table, Rounding(notation_, known.kind).exactly(value));
        continue;
      }
      hard.push_back(field);
      for (std::size_t i = 0; i < columns; ++i) {
        places.push_back(table.cells.size());
        put(table, {format::empty_cell});
      }
    }
    if (!hard.empty()) settle(row, hard, places, table);
    for (std::size_t i = first; i < table.cells.size(); ++i) require_finite(row, table.cells[i]);
  }

 private:
  template <class S>
  static const Quantity<S>& quantity(std::size_t field) {
    return *std::ranges::find(quantities<S>, fields()[field].name, &Quantity<S>::name);
  }

  void put(Table& table, Printed printed) const {
    table.cells.push_back(printed.cell);
    if (has_texts()) table.texts.push_back(std::move(printed.text));
  }
  bool has_texts() const {
    using enum format::Notation::Kind;
    return notation_.kind == digits || notation_.kind == fixed;
  }

  /// The values of some fields, worked out at a scalar.
  template <class S>
  std::vector<Value> values(CurveAt<S>& curve, const FastRow& row, std::span<const std::size_t> chosen) const {
    if (curve == nullptr) curve = std::make_unique<Curve<S>>(exact_);
    Spot<S> spot;
    if constexpr (spline::has_roots<S>) {
      if (arc_) spot = spot_at_length(row, *arc_, *curve);
    }
    if (!arc_) spot = spot_at_time(row, exact_, left_, *curve);
    const Point<S> point(*curve, std::move(spot));
    std::vector<Value> result;
    for (const std::size_t field : chosen) (point.*quantity<S>(field).append)(result);
    return result;
  }

  void settle(const FastRow& row, std::span<const std::size_t> chosen, std::span<const std::size_t> places,
              Table& table) {
    std::vector<CellKind> kinds;
    for (const std::size_t field : chosen) {
      const Field& known = fields()[field];
      kinds.insert(kinds.end(), known.per_channel ? exact_.keys.channels : 1, known.kind);
    }
    std::vector<Printed> printed;
    try {
      printed = climb<1>(row, chosen, kinds, values(std::get<0>(ladder_), row, chosen));
    } catch (const std::range_error&) {
      throw Error(Exit::data,
                  fmt::format("the row at time {} has a number that cannot be worked out to so many digits; expected "
                              "fewer; give a smaller number to --digits or --fixed",
                              format::time_text(row.sample.t)));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      table.cells[places[i]] = printed[i].cell;
      if (has_texts()) table.texts[places[i]] = printed[i].text;
    }
  }

  template <std::size_t level>
  std::vector<Printed> climb(const FastRow& row, std::span<const std::size_t> chosen, std::span<const CellKind> kinds,
                             const std::vector<Value>& rough) {
    std::vector<Value> fine = values(std::get<level>(ladder_), row, chosen);
    std::vector<Printed> printed;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Rounding rounding(notation_, kinds[i]);
      if constexpr (level + 1 == std::tuple_size_v<Ladder>) {
        printed.push_back(rounding.at_last(rough[i], fine[i]));
      } else {
        auto certain = rounding.between(rough[i], fine[i]);
        if (!certain) return climb<level + 1>(row, chosen, kinds, fine);
        printed.push_back(std::move(*certain));
      }
    }
    return printed;
  }

  static void require_finite(const FastRow& row, const format::Cell& cell) {
    if (format::is_empty(cell) || std::isfinite(cell.hi)) return;
    refuse_overflow(row.sample);
  }

  ExactCurve exact_;
  std::optional<ArcPlaces> arc_;
  bool left_;
  format::Notation notation_;
  CurveAt<Rational> rational_;
  Ladder ladder_;
};

bool has_field(std::string_view name) {
  return std::ranges::count(quantities<Rational>, name, &Quantity<Rational>::name) > 0;
}

Rows::Rows(ExactCurve curve, std::optional<ArcPlaces> arc, bool left, const format::Notation& notation)
    : evaluation_(std::make_unique<Evaluation>(std::move(curve), std::move(arc), left, notation)) {}
Rows::~Rows() = default;

Table Rows::evaluate(const Batch& batch, const sampler::Locator& locator, std::span<const std::size_t> chosen) {
  Table table;
  sampler::Located located;
  for (const auto& [piece, first, last] : batch.parts) {
    locator.locate(piece, first, last, located);
    for (std::size_t i = 0; i < located.samples.size(); ++i) {
      evaluation_->add_row({piece, located.samples[i], first + i}, chosen, table);
    }
  }
  return table;
}

}  // namespace tcb::golden
