// Exact rows: every number of a row as exact arithmetic gives it, rounded once.
//
// Balls of double-doubles decide nearly all cells of a row. Those that they leave open are computed as rationals where
// they are rational; are 0 or empty where they are so all along the segment; or are computed in balls of floats with
// more and more digits (Level), until each is decided.
#include "exact/exact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "error.hpp"
#include "exact/ball_rows.hpp"
#include "exact/real.hpp"
#include "exact/row_point.hpp"
#include "numbers/print_number.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"

namespace tcb {

/// Collects the numbers of a point that are rational, or roots of rationals.
template <>
class CellWriter<Rational> {
 public:
  explicit CellWriter(std::vector<Value>& row) : row_(row) {}

  void add(const Rational& value) { row_.push_back({value}); }
  void add(const Quantity<Rational>& value) { row_.push_back({value.value, value.root, !value.defined}); }
  void add_of_channel(const Rational& value, std::size_t, bool) { add(value); }

 private:
  std::vector<Value>& row_;
};

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
  const Rational steps = (Rational(*extent.length) - arc.from) / arc.step;
  arc.intervals = whole_number(numerator(steps));
  return arc;
}

/// Bits of the floats with the least precision: more than the requested digits have, and at least some 38 digits.
int first_precision(const Notation& notation) {
  constexpr int least = 128, guard = 40, step = 64;
  const int needed = notation.count * 10 / 3 + guard;
  return std::max(least, (needed + step - 1) / step * step);
}

/// The precision beyond which none is used: that which distinguishes a number from 0 to some 400 digits beyond the size
/// of the curve. Its numbers may be of different sizes, and their powers more so.
int last_precision(const RowsOfCurve& rows) {
  constexpr int digits = 1536, most_of_sizes = 8192;  // bits
  std::int64_t least = 0, most = 0;
  const auto add = [&](const Rational& number) {
    if (number == 0) return;
    ErrorBound error;
    const std::int64_t exponent = Middle<Real>::nearest(number, error).exponent();
    least = std::min(least, exponent);
    most = std::max(most, exponent);
  };
  const spline::Keys<Rational>& keys = rows.exact.keys;
  for (std::size_t i = 0; i < keys.positions.size(); ++i) {
    add(keys.positions[i]);
    if (i >= keys.channels) add(keys.positions[i] - keys.positions[i - keys.channels]);
  }
  for (std::size_t i = 1; i < keys.times.size(); ++i) add(keys.times[i] - keys.times[i - 1]);
  return digits + 2 * static_cast<int>(std::min<std::int64_t>(most - least, most_of_sizes));
}

}  // namespace

/// What all rows of a request need, on any thread.
struct ExactRows::Request {
  Request(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& rounded)
      : rows{std::move(curve), {}, arc_lengths(request, extent), request.side()}, notation(rounded) {
    rows.facts = channel_facts(rows.exact);
  }

  RowsOfCurve rows;
  const Notation notation;
};

/// The evaluation of rows on one thread, with what it keeps for later ones.
class ExactRows::Evaluation {
 public:
  Evaluation(const Request& request, std::span<const std::size_t> chosen)
      : rows_(request.rows),
        notation_(request.notation),
        chosen_(chosen.begin(), chosen.end()),
        balls_(BallRows::in_double_doubles(rows_, chosen_)),
        cells_(width(chosen)) {}

  void add_row(FastRow row, const Locator& locator, Table& table) {
    if (rows_.exact.decimal && !rows_.arc) row.exact = exact_times(row, locator);
    std::ranges::fill(cells_, RowCell{});
    const bool is_placed = balls_ != nullptr && balls_->set(row, notation_, cells_);
    if (is_open()) complete(row, is_placed);
    const auto overflows = [](const RowCell& one) {
      return !is_empty(one.printed->cell) && !std::isfinite(one.printed->cell.hi);
    };
    if (std::ranges::any_of(cells_, overflows)) refuse_overflow(row.sample);
    set_signs_of_zeros(row);
    for (RowCell& cell : cells_) append(*std::move(cell.printed), table);
  }

 private:
  /// A precision of floats.
  struct Level {
    int bits;
    std::unique_ptr<BallRows> rows = nullptr;  ///< null until it is needed
  };

  static std::vector<Level> levels_of(const RowsOfCurve& rows, const Notation& notation) {
    std::vector<Level> levels;
    const int last = last_precision(rows);
    for (int bits = first_precision(notation); bits < last; bits *= 2) levels.push_back({bits});
    levels.push_back({last});
    return levels;
  }

  /// The exact times of a row on a curve whose keys are decimals.
  ExactTimes exact_times(const FastRow& row, const Locator& locator) const {
    const ExactCurve& curve = rows_.exact;
    if (curve.exponent) return locator.exact_times(row.number, nullptr);
    const std::vector<Rational>& times = curve.keys.times;
    const std::size_t next = row.segment.number + 1;
    const ExactKeyTimes keys{times[row.segment.number], next < times.size() ? times[next] : *curve.end};
    ExactTimes exact = locator.exact_times(row.number, &keys);
    if (exact.time) return exact;
    if (row.sample.at.u == 0) {
      exact.time = keys.start;
    } else if (row.sample.at.w == 0) {
      exact.time = keys.end;
    }
    return exact;
  }

  std::vector<Level>& levels() {
    if (levels_.empty()) levels_ = levels_of(rows_, notation_);
    return levels_;
  }
  Level& last() { return levels().back(); }

  static bool is_set(const RowCell& cell) { return cell.printed.has_value(); }
  bool is_open() const { return !std::ranges::all_of(cells_, is_set); }

  void append(Printed printed, Table& table) const {
    table.cells.push_back(printed.cell);
    if (notation_.is_rounded()) table.texts.push_back(std::move(printed.text));
  }

  std::size_t width(std::span<const std::size_t> chosen) const {
    return cells_in_row(chosen, {rows_.exact.keys.channels, rows_.exact.channels.rotations});
  }

  /// Calls a function with each field and its cells.
  template <class F>
  void for_each_field(const F& f) {
    std::size_t first = 0;
    for (const std::size_t& index : chosen_) {
      const auto cells = std::span(cells_).subspan(first, width({&index, 1}));
      first += cells.size();
      f(index, cells);
    }
  }

  bool is_rational(std::size_t field) const {
    return rows_.exact.is_rational() && fields()[field].is_rational && rows_.exact.rules.rotations.empty();
  }

  /// Sets the cells that double-doubles leave open. They are nearly always halfway between two roundings, or 0, and are
  /// computed as rationals where they are rational; others in more and more digits.
  void complete(FastRow row, bool is_placed) {
    row.is_middle = is_middle(row);
    if (!rows_.arc || is_placed) set_rationals(row, rows_.arc ? balls_->key_at_end() : std::nullopt);
    set_zeros(row);
    if (!is_open()) return;  // before levels are made
    for (Level& level : levels()) {
      if (!is_open()) return;
      const RealPrecision precision(level.bits, level.bits == last().bits);
      try {
        const bool has_place = rows_at(level).set(row, notation_, cells_);
        if (rows_.arc && has_place) set_rationals(row, level.rows->key_at_end());
      } catch (const Undecided&) {
        continue;
      }
      set_zeros(row);
    }
    if (!is_open()) return;
    throw data_error(
        "the row at time {} has a number that cannot be computed to the requested digits; request fewer with --digits "
        "or --fixed",
        time_text(row.sample.t));
  }

  /// A position that is 0 has the sign that it has without exact numbers, which have no -0: that of a key of -0.
  void set_signs_of_zeros(const FastRow& row) {
    const auto is_zero = [](const RowCell& cell) { return cell.printed->is_zero; };
    for_each_field([&](const std::size_t& index, std::span<RowCell> cells) {
      const Field& field = fields()[index];
      const bool has_positions = field.shows_rotations || (field.of_piece && field.per_channel);
      if (!has_positions || std::ranges::none_of(cells, is_zero)) return;
      Located located{{row.sample}};
      if (row.end != nullptr) located.ends = {*row.end};
      if (row.outside != nullptr) located.outside = {*row.outside};
      std::vector<Cell> inexact(cells.size());
      Point<double> point;
      write_rows(inexact.data(), inexact.size(), {&index, 1}, row.segment, located, point);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!is_zero(cells[i]) || inexact[i].hi != 0 || !std::signbit(inexact[i].hi)) continue;
        cells[i].printed->cell = Cell(-0.0);
        std::string& text = cells[i].printed->text;
        if (!text.empty()) text.insert(0, "-");
      }
    });
  }

  BallRows& rows_at(Level& level) {
    if (level.rows == nullptr) level.rows = BallRows::in_reals(rows_, chosen_);
    return *level.rows;
  }

  /// What the cells of a row are all along its segment. Double-doubles show it of nearly all numbers that are neither
  /// 0 nor empty.
  const std::vector<AlongSegment>& along(const FastRow& row) {
    const auto found = along_.find(row.segment.number);
    if (found != along_.end()) return found->second;
    constexpr std::size_t most_kept = 4096;
    if (along_.size() == most_kept) along_.clear();
    std::vector<AlongSegment> cells(cells_.size(), AlongSegment::open);
    try {
      if (balls_ != nullptr) balls_->look_along(row, cells);
    } catch (const Undecided&) {  // what it found holds
    }
    if (std::ranges::find(cells, AlongSegment::open) != cells.end()) {
      const RealPrecision precision(last().bits, true);
      rows_at(last()).look_along(row, cells);
    }
    return along_.emplace(row.segment.number, std::move(cells)).first->second;
  }

  /// Sets the open cells that are empty all along the segment of a row, or 0 all along it and perhaps at the row.
  void set_zeros(const FastRow& row) {
    const Time& t = row.sample.t;
    const bool is_on_segment = rows_.arc || (t >= row.segment.start && t <= row.segment.end);
    if (!is_on_segment || !is_open()) return;
    try {
      const std::vector<AlongSegment>& along = this->along(row);
      auto along_cell = along.begin();
      for_each_field([&](std::size_t index, std::span<RowCell> cells) {
        const Rounding rounding(notation_, fields()[index].kind, row.segment.decimals);
        for (RowCell& cell : cells) {
          const AlongSegment known = *along_cell++;
          if (cell.printed) continue;
          if (known == AlongSegment::empty) cell.printed = Printed{empty_cell};
          if (known == AlongSegment::zero && cell.may_be_zero) cell.printed = rounding.exactly({0});
        }
      });
    } catch (const Undecided&) {  // more digits decide
    }
  }

  /// Whether a row is in the middle of a symmetric curve, and of a segment.
  bool is_middle(const FastRow& row) {
    const std::size_t keys = rows_.exact.keys.size(), segments = rows_.exact.closed ? keys : keys - 1;
    const bool may_be = rows_.arc && rows_.arc->intervals != 0 && rows_.arc->from == 0 &&
                        row.number == rows_.arc->intervals - row.number && segments % 2 == 1 &&
                        row.segment.number == segments / 2;
    if (may_be && !is_symmetric_) {
      const RealPrecision precision(last().bits, true);
      try {
        is_symmetric_ = rows_at(last()).is_symmetric();
      } catch (const Undecided&) {
        is_symmetric_ = false;
      }
    }
    return may_be && *is_symmetric_;
  }

  /// Sets the open cells that are rational, if the place of the row is. `key_at_end`: where it is placed by length.
  void set_rationals(FastRow row, std::optional<bool> key_at_end) {
    if (rows_.arc && !key_at_end) return;
    row.key_at_end = key_at_end;
    for_each_field([&](const std::size_t& index, std::span<RowCell> cells) {
      if (!is_rational(index) || std::ranges::all_of(cells, is_set)) return;
      if (rational_ == nullptr) rational_ = std::make_unique<RowPoint<Rational>>(rows_);
      std::vector<Value> values;
      field_writers<Rational>[index](rational_->place(row, needs_lengths({&index, 1})), CellWriter<Rational>(values));
      const Rounding rounding(notation_, fields()[index].kind, row.segment.decimals);
      std::ranges::transform(values, cells.begin(),
                             [&](const Value& value) { return RowCell{rounding.exactly(value)}; });
    });
  }

  const RowsOfCurve& rows_;
  const Notation& notation_;
  const std::vector<std::size_t> chosen_;                     ///< fields
  std::unique_ptr<BallRows> balls_;                           ///< null: the curve is not for balls
  std::vector<RowCell> cells_;                                ///< of the current row
  std::unique_ptr<RowPoint<Rational>> rational_;              ///< null until it is needed
  std::vector<Level> levels_;                                 ///< none until they are needed
  std::optional<bool> is_symmetric_;                          ///< nothing until it is needed
  std::map<std::uint64_t, std::vector<AlongSegment>> along_;  ///< of segments: along()
};

ExactRows::ExactRows(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& notation)
    : request_(std::make_unique<Request>(std::move(curve), request, extent, notation)) {}
ExactRows::~ExactRows() = default;

std::unique_ptr<ExactRows::Evaluation> ExactRows::take(std::span<const std::size_t> chosen) {
  std::unique_lock lock(mutex_);
  if (idle_.empty()) {
    lock.unlock();
    return std::make_unique<Evaluation>(*request_, chosen);
  }
  std::unique_ptr<Evaluation> evaluation = std::move(idle_.back());
  idle_.pop_back();
  return evaluation;
}

void ExactRows::give_back(std::unique_ptr<Evaluation> evaluation) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(evaluation));
}

Table ExactRows::evaluate(const SampleBlock& block, const Locator& locator, std::span<const std::size_t> chosen) {
  Table table;
  Located located;
  std::unique_ptr<Evaluation> evaluation = take(chosen);
  for (const auto& [segment, first, last] : block.parts) {
    locator.locate(segment, first, last, located);
    for (std::size_t i = 0; i < located.samples.size(); ++i) {
      const Sample* const end = located.ends.empty() ? nullptr : &located.ends[i];
      const Outside* const outside = located.outside.empty() ? nullptr : &located.outside[i];
      evaluation->add_row({segment, located.samples[i], first + i, end, outside}, locator, table);
    }
  }
  give_back(std::move(evaluation));
  return table;
}

}  // namespace tcb
