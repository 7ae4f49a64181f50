// Precision levels: every number of a row as exact arithmetic gives it, rounded once.
#include "exact/precision_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "error.hpp"
#include "exact/ball_rows.hpp"
#include "exact/errors.hpp"
#include "exact/level.hpp"
#include "numbers/print_number.hpp"

namespace tcb {

namespace {

/// The arc lengths of the rows of a request; nothing if it places them by time.
std::optional<ExactPlaces> arc_lengths(const SamplingRequest& request, const Extent& extent) {
  if (!by_length(request.mode)) return std::nullopt;
  ExactPlaces arc{request.places, 0, 0, 0, request.to};
  if (request.mode == Mode::arc_at) return arc;
  const Grid grid = spacing(request, extent).grid;
  arc.from = grid.start();
  arc.step = grid.step();
  const bool by_end = !request.to && needs_end(request) && grid.step() != 0;
  if (!by_end) return arc;
  const Rational steps = steps_between(arc.from, Rational(*extent.length), arc.step);
  arc.intervals = whole_number(numerator(steps));
  return arc;
}

}  // namespace

/// The times of the rows of a request on an exact curve.
class ExactTimes {
 public:
  ExactTimes(const ExactCurve& curve, const SamplingRequest& request, const Extent& extent,
             std::vector<Rational> places)
      : curve_(curve), request_(request), places_(std::move(places)) {
    const bool on_grid = request.mode == Mode::step || request.mode == Mode::count || request.mode == Mode::segments;
    if (curve.decimal && on_grid && places_.empty()) grid_.emplace(spacing(request, extent).grid);
  }

  /// Sets the times of a row, unless they are those of its samples.
  void set(FastRow& row) const {
    if (!curve_.decimal || by_length(request_.mode)) return;
    if (request_.mode == Mode::emit) {
      row.time = bounded(request_.from, row.segment, row.segment.number);
      row.end_time = bounded(request_.to, row.segment, row.segment.number + 1);
    } else {
      row.time = time(row);
    }
  }

 private:
  std::optional<Rational> time(const FastRow& row) const {
    const std::uint64_t segment = row.segment.number;
    if (!places_.empty()) return places_[row.number];
    if (row.number == SpecialRow::at_key) return key(segment);
    if (row.number == SpecialRow::at_end) return end(key(segment + 1));
    if (grid_) return grid_->start() + grid_->step() * row.number;
    if (request_.mode == Mode::per_segment && has_keys()) {
      return *key(segment) + (*key(segment + 1) - *key(segment)) * row.number / request_.count;
    }
    if (row.sample.at.u == 0) return key(segment);
    return row.sample.at.w == 0 ? key(segment + 1) : std::nullopt;
  }

  /// Whether keys have times that no distance makes.
  bool has_keys() const { return !curve_.exponent; }

  std::optional<Rational> key(std::uint64_t number) const {
    if (!has_keys()) return std::nullopt;
    return number < curve_.keys.size() ? curve_.keys.times[number] : curve_.end;
  }

  /// The end of the range, on a segment that ends at a key.
  std::optional<Rational> end(const std::optional<Rational>& key) const {
    if (request_.mode == Mode::per_segment || !request_.to) return key;
    return key ? std::min(*request_.to, *key) : *request_.to;
  }

  /// A bound of the range within a segment, or the time of the key with this number.
  std::optional<Rational> bounded(const std::optional<Rational>& bound, const CurveSegment& segment,
                                  std::uint64_t number) const {
    if (!has_keys()) return std::nullopt;
    return bound ? std::clamp(*bound, *key(segment.number), *key(segment.number + 1)) : key(number);
  }

  const ExactCurve& curve_;
  const SamplingRequest request_;
  std::vector<Rational> places_;
  std::optional<Grid> grid_;
};

namespace {

/// A level of floats.
struct FloatLevel {
  int digits;
  std::unique_ptr<AnyLevel> (*make)(const RowsOfCurve&);
};
constexpr std::array float_levels{FloatLevel{40, make_level<Float<40>>}, FloatLevel{80, make_level<Float<80>>},
                                  FloatLevel{200, make_level<Float<200>>}};

}  // namespace

/// What all rows of a request need, on any thread.
struct ExactRows::Request {
  Request(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& rounded,
          std::vector<Rational> exact_times)
      : rows{std::move(curve), {}, arc_lengths(request, extent), request.side()},
        times(rows.exact, request, extent, std::move(exact_times)),
        notation(rounded) {
    rows.facts = channel_facts(rows.exact);
  }

  RowsOfCurve rows;
  const ExactTimes times;
  const Notation notation;
};

/// The evaluation of rows on one thread, with what it keeps for later ones.
class ExactRows::Evaluation {
 public:
  explicit Evaluation(const Request& request)
      : rows_(request.rows), times_(request.times), notation_(request.notation) {}

  void add_row(FastRow row, std::span<const std::size_t> chosen, Table& table) {
    times_.set(row);
    if (!has_balls_) balls_ = BallRows::of(rows_, {chosen.begin(), chosen.end()});
    has_balls_ = true;
    const bool is_placed = balls_ != nullptr && balls_->set(row, notation_, cells_);
    if (!is_placed) cells_.assign(width(chosen), std::nullopt);
    counts_.by_bounds += cells_.size();
    if (!std::ranges::all_of(cells_, &std::optional<Printed>::has_value)) complete(row, chosen, is_placed);
    const auto overflows = [](const auto& one) { return !is_empty(one->cell) && !std::isfinite(one->cell.hi); };
    if (std::ranges::any_of(cells_, overflows)) refuse_overflow(row.sample);
    for (std::optional<Printed>& cell : cells_) append(*std::move(cell), table);
  }

  const LevelCounts& counts() const { return counts_; }

 private:
  /// A column of the current row; if it is rational, or the root of a rational, it can be computed as that where the
  /// row's place is rational.
  struct Column {
    CellKind kind;
    bool rational;
  };

  void append(Printed printed, Table& table) const {
    table.cells.push_back(printed.cell);
    if (has_texts()) table.texts.push_back(std::move(printed.text));
  }

  std::size_t width(std::span<const std::size_t> chosen) const {
    return cells_in_row(chosen, {rows_.exact.keys.channels, rows_.exact.channels.rotations});
  }

  bool is_rational(std::size_t field) const {
    return rows_.exact.is_rational() && fields()[field].is_rational && rows_.exact.rules.rotations.empty();
  }

  /// Sets the cells that balls leave open. They are nearly always halfway between two roundings, or 0, and are computed
  /// as rationals where they are rational; others in floats.
  void complete(const FastRow& row, std::span<const std::size_t> chosen, bool is_placed) {
    const auto is_open = [](const std::optional<Printed>& cell) { return !cell.has_value(); };
    const std::optional<bool> key_at_end = rows_.arc && is_placed ? balls_->key_at_end() : std::nullopt;
    const bool has_rational_place = !rows_.arc || key_at_end;
    std::vector<std::size_t> rational, others;
    for_each_field(chosen, [&](std::size_t index, std::span<std::optional<Printed>> cells) {
      if (std::ranges::none_of(cells, is_open)) return;
      (has_rational_place && is_rational(index) ? rational : others).push_back(index);
    });
    std::vector<Value> exact;
    if (!rational.empty()) exact = rational_values(row, rational, key_at_end);
    std::vector<Printed> by_floats;
    if (!others.empty()) by_floats = float_cells(row, others);
    counts_.by_bounds -= exact.size() + by_floats.size();
    counts_.exactly += exact.size();
    auto next_exact = exact.begin();
    auto next_float = by_floats.begin();
    for_each_field(chosen, [&](std::size_t index, std::span<std::optional<Printed>> cells) {
      if (std::ranges::none_of(cells, is_open)) return;
      const Rounding rounding(notation_, fields()[index].kind, row.segment.decimals);
      const bool is_exact = has_rational_place && is_rational(index);
      for (std::optional<Printed>& cell : cells) cell = is_exact ? rounding.exactly(*next_exact++) : *next_float++;
    });
  }

  /// Calls a function with each field and its cells of the current row.
  template <class F>
  void for_each_field(std::span<const std::size_t> chosen, F f) {
    std::size_t first = 0;
    for (const std::size_t& index : chosen) {
      const std::size_t size = width({&index, 1});
      f(index, std::span(cells_).subspan(std::exchange(first, first + size), size));
    }
  }

  /// The cells of some fields of a row by floats, or by rationals where floats leave them in doubt.
  std::vector<Printed> float_cells(const FastRow& row, std::span<const std::size_t> chosen) {
    std::vector<Column> columns;
    for (const std::size_t& index : chosen) {
      columns.insert(columns.end(), width({&index, 1}), {fields()[index].kind, is_rational(index)});
    }
    try {
      return cells_from(1, row, chosen, columns, float_values(0, row, chosen));
    } catch (const std::range_error&) {
      throw row_needs_more_digits(time_text(row.sample.t));
    }
  }

  bool has_texts() const {
    using enum Notation::Kind;
    return notation_.kind == digits || notation_.kind == fixed;
  }

  std::vector<Value> float_values(std::size_t level, const FastRow& row, std::span<const std::size_t> chosen) {
    if (floats_[level] == nullptr) floats_[level] = float_levels[level].make(rows_);
    return floats_[level]->values(row, chosen);
  }

  std::vector<Value> rational_values(FastRow row, std::span<const std::size_t> chosen, std::optional<bool> key_at_end) {
    row.key_at_end = key_at_end;
    if (rational_ == nullptr) rational_ = make_level<Rational>(rows_);
    return rational_->values(row, chosen);
  }

  /// The cells of a row by floats of a level and of the one below it; what they leave in doubt, by rationals, or by the
  /// levels above.
  std::vector<Printed> cells_from(std::size_t level, const FastRow& row, std::span<const std::size_t> chosen,
                                  std::span<const Column> columns, const std::vector<Value>& rough) {
    const bool last = level + 1 == float_levels.size();
    const LevelDigits digits{float_levels[level - 1].digits, float_levels[level].digits};
    const std::vector<Value> fine = float_values(level, row, chosen);
    const std::optional<bool> key_at_end = floats_[level]->key_at_end();
    const bool place_is_rational = !rows_.arc || key_at_end;
    std::vector<Value> exact;
    std::vector<Printed> cells;
    LevelCounts counts;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Rounding rounding(notation_, columns[i].kind, row.segment.decimals);
      const bool is_known = columns[i].kind == CellKind::time && !rows_.arc && (row.time || row.sample.t.lo != 0);
      ++(is_known ? counts.exactly : counts.by_floats);
      auto cell = is_known ? rounding.exactly({row.time ? *row.time : exact_time(row.sample.t)})
                           : rounding.between(rough[i], fine[i], digits);
      if (!cell && columns[i].rational && place_is_rational) {
        if (exact.empty()) exact = rational_values(row, chosen, key_at_end);
        cell = rounding.exactly(exact[i]);
        --counts.by_floats;
        ++counts.exactly;
      } else if (!cell) {
        if (!last) return cells_from(level + 1, row, chosen, columns, fine);
        cell = rounding.at_last(rough[i], fine[i], digits);
      }
      cells.push_back(std::move(*cell));
    }
    counts_ += counts;
    return cells;
  }

  const RowsOfCurve& rows_;
  const ExactTimes& times_;
  const Notation& notation_;
  std::unique_ptr<BallRows> balls_;            ///< null: the curve is not for balls
  bool has_balls_ = false;                     ///< balls_ is set
  std::vector<std::optional<Printed>> cells_;  ///< of the current row; nothing where they are not decided yet
  LevelCounts counts_;
  std::unique_ptr<AnyLevel> rational_;
  std::array<std::unique_ptr<AnyLevel>, float_levels.size()> floats_;
};

ExactRows::ExactRows(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& notation,
                     std::vector<Rational> times)
    : request_(std::make_unique<Request>(std::move(curve), request, extent, notation, std::move(times))) {}
ExactRows::~ExactRows() = default;

std::unique_ptr<ExactRows::Evaluation> ExactRows::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<Evaluation>(*request_);
  std::unique_ptr<Evaluation> evaluation = std::move(idle_.back());
  idle_.pop_back();
  return evaluation;
}

void ExactRows::give_back(std::unique_ptr<Evaluation> evaluation) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(evaluation));
}

LevelCounts ExactRows::counts() const {
  LevelCounts sum;
  for (const std::unique_ptr<Evaluation>& evaluation : idle_) sum += evaluation->counts();
  return sum;
}

Table ExactRows::evaluate(const SampleBlock& block, const Locator& locator, std::span<const std::size_t> chosen) {
  Table table;
  Located located;
  std::unique_ptr<Evaluation> evaluation = take();
  for (const auto& [segment, first, last] : block.parts) {
    locator.locate(segment, first, last, located);
    for (std::size_t i = 0; i < located.samples.size(); ++i) {
      const Sample* const end = located.ends.empty() ? nullptr : &located.ends[i];
      evaluation->add_row({segment, located.samples[i], first + i, end}, chosen, table);
    }
  }
  give_back(std::move(evaluation));
  return table;
}

}  // namespace tcb
