// Exact rows: every number of a row as exact arithmetic gives it, rounded once.
//
// See exact_rows.hpp for the order in which numbers are tried.
#include "exact/exact_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "error.hpp"
#include "exact/float_rows.hpp"
#include "exact/row_point.hpp"
#include "numbers/print_number.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"

namespace tcb {
namespace {

/// The arc lengths of the rows of a request; nothing if it places them by time.
std::optional<ExactPlaces> arc_lengths(const SamplingRequest& request, const Extent& extent) {
  if (!by_length(request)) return std::nullopt;
  ExactPlaces arc{request.places, 0, 0, 0, request.to, request.pace};
  if (request.pace) return arc;
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

/// The sizes of the numbers of a curve that are not 0, as doubles.
struct Sizes {
  double most = 0, least = std::numeric_limits<double>::infinity();

  void add(const Rational& number) {
    if (number == 0) return;
    const double size = std::abs(nearest_double(number));
    most = std::max(most, size);
    least = std::min(least, size);
  }
  /// Double-doubles hold all of them.
  bool are_in_range() const { return most < 0x1p1000 && least > 0x1p-900; }
  /// Sums keep digits of all of them.
  bool are_near() const { return most < 0x1p60 * least; }
};

Sizes sizes_of_positions(const spline::Keys<Rational>& keys) {
  Sizes sizes;
  for (std::size_t i = 0; i < keys.positions.size(); ++i) {
    sizes.add(keys.positions[i]);
    if (i >= keys.channels) sizes.add(keys.positions[i] - keys.positions[i - keys.channels]);
  }
  return sizes;
}
Sizes sizes_of_durations(const spline::Keys<Rational>& keys) {
  Sizes sizes;
  for (std::size_t i = 1; i < keys.times.size(); ++i) sizes.add(keys.times[i] - keys.times[i - 1]);
  return sizes;
}

/// More than which part of a number double-doubles lose by the rounding of times that are far from 0.
double part_of_far_times(std::span<const Rational> times) {
  Sizes sizes, durations;
  for (std::size_t i = 0; i < times.size(); ++i) {
    sizes.add(times[i]);
    if (i > 0) durations.add(times[i] - times[i - 1]);
  }
  return 0x1p-102 * sizes.most / durations.least;
}

Printed time_cell(const FastRow& row, const RowsOfCurve& curve, const Notation& notation) {
  const Time& shown = row.sample.t;
  const bool is_decimal = curve.exact.decimal || curve.exact.channels.frames;
  const bool is_shown = !row.exact.time && shown.lo == 0 && row.segment.decimals == 0 && !is_decimal;
  if (is_shown && !notation.is_rounded()) return {shown};
  const Rounding rounding(notation, CellKind::time, row.segment.decimals);
  if (is_shown) {
    if (auto printed = rounding.within(Bounded(shown.hi))) return *std::move(printed);
  }
  if (row.exact.time) return rounding.exactly({*row.exact.time});
  return rounding.exactly(
      {shown.lo == 0 ? exact_number(shown, curve.exact.decimal, curve.exact.channels.frames) : exact_time(shown)});
}

/// A number with a bound on its error, or the root of one.
Bounded root_of(const Quantity<Bounded>& number) {
  if (!number.root || number.value.is_zero()) return number.value;
  const Bounded square = abs(number.value);
  if (!(square.least() > 0x1p-900)) return {0.0, std::numeric_limits<double>::infinity()};
  const spline::DoubleDouble root = sqrt(square.value);
  const double error = 0x1p-98 * root.hi + square.error / std::sqrt(square.least());
  return {number.value.value.hi < 0 ? -root : root, error * (1 + 0x1p-48)};
}

using Cells = std::span<std::optional<Printed>>;

bool is_set(const std::optional<Printed>& cell) { return cell.has_value(); }

Rational exactly(const spline::DoubleDouble& number) { return Rational(number.hi) + Rational(number.lo); }

}  // namespace

/// What all rows of a request need, on any thread.
struct ExactRows::Request {
  Request(ExactCurve curve, const SamplingRequest& request, const Extent& extent, const Notation& rounded)
      : rows{std::move(curve), {}, {}, {}, arc_lengths(request, extent), request.side()}, notation(rounded) {
    rows.facts = channel_facts(rows.exact);
    rows.metric = rows.exact.rules.metric;
    if (rows.metric.empty()) {
      for (std::size_t i = 0; i < rows.exact.keys.channels; ++i) rows.metric.push_back(i);
    }
    rows.times = rows.exact.keys.times;
    if (rows.exact.end) rows.times.push_back(*rows.exact.end);
    if (rows.times.size() == 1) rows.times.push_back(rows.times.front());
    const Sizes positions = sizes_of_positions(rows.exact.keys), durations = sizes_of_durations(rows.exact.keys);
    if (!rows.exact.exponent) far_part = part_of_far_times(rows.times);
    is_for_double_doubles = positions.are_in_range() && durations.are_in_range() && far_part < 0x1p-60;
    keeps_digits = positions.are_near() && durations.are_near();
  }

  RowsOfCurve rows;
  const Notation notation;
  double far_part = 0;  ///< part_of_far_times()
  bool is_for_double_doubles = false;
  bool keeps_digits = false;  ///< a sum of double-doubles that is 0 is so exactly
};

/// The evaluation of rows on one thread, with what it keeps for later ones.
class ExactRows::Evaluation {
 public:
  Evaluation(const Request& request, std::span<const std::size_t> chosen)
      : rows_(request.rows),
        notation_(request.notation),
        chosen_(chosen.begin(), chosen.end()),
        keeps_digits_(request.keeps_digits),
        is_rational_curve_(rows_.exact.is_rational() && rows_.exact.rules.rotations.empty()),
        least_part_(std::max(request.far_part, 0x1p-84)),
        cells_(width(chosen)),
        may_be_zero_(cells_.size()) {
    if (request.is_for_double_doubles) double_doubles_.emplace(rows_);
    for (const std::size_t index : chosen_) {
      if (!is_rational(index) && !is_time(index)) irrational_.push_back(index);
    }
  }

  void add_row(FastRow row, const Locator& locator, Table& table) {
    if (rows_.exact.decimal && is_by_time()) row.exact = exact_times(row, locator);
    if (rows_.arc && rows_.arc->pace) row.part = part_of_row(row);
    std::ranges::fill(cells_, std::nullopt);
    is_placed_ = {};
    may_be_zero_.assign(cells_.size(), false);
    may_be_along_ = false;
    if (rows_.arc) set_place(row);
    has_rational_place_ = !rows_.arc || (row.at_key && (!row.at_key->is_middle || !has_warps()));
    set_known(row);
    set_bounded(row);
    set_estimated(row);
    if (!std::ranges::all_of(cells_, is_set)) complete(row);
    const auto overflows = [](const std::optional<Printed>& cell) {
      return !is_empty(cell->cell) && !std::isfinite(cell->cell.hi);
    };
    if (std::ranges::any_of(cells_, overflows)) refuse_overflow(row.sample);
    set_signs_of_zeros(row);
    for (std::optional<Printed>& cell : cells_) append(*std::move(cell), table);
  }

 private:
  struct AlongSegment {
    int rows = 0;                               ///< that were not decided without it
    std::vector<std::optional<Printed>> cells;  ///< that are the same all along; none until they are needed
  };
  struct Placed {
    bool bounded = false, exact = false, double_doubles = false, short_floats = false, long_floats = false;
  };

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

  void append(Printed printed, Table& table) const {
    table.cells.push_back(printed.cell);
    if (notation_.is_rounded()) table.texts.push_back(std::move(printed.text));
  }

  /// Whether rows are at times that are requested, also at a pace.
  bool is_by_time() const { return !rows_.arc || rows_.arc->pace; }

  PacePart<Rational> part_of_row(const FastRow& row) const {
    const ExactCurve& curve = rows_.exact;
    const Rational time =
        row.exact.time ? *row.exact.time : exact_number(row.sample.t, curve.decimal, curve.channels.frames);
    return rows_.arc->pace->at<Rational>(time, rows_.times.front(), rows_.times.back());
  }

  std::size_t width(std::span<const std::size_t> chosen) const {
    return cells_in_row(chosen, {rows_.exact.keys.channels, rows_.exact.channels.rotations});
  }

  bool has_warps() const { return !rows_.exact.keys.eases.empty() || rows_.exact.rules.timing != spline::Timing::even; }
  bool is_rational(std::size_t field) const {
    const bool is_of_length = rows_.arc && rows_.arc->pace && fields()[field].of_pace;
    return is_rational_curve_ && fields()[field].is_rational && !is_of_length;
  }
  bool is_bounded(std::size_t field) const { return has_rational_place_ && is_rational(field); }
  /// Whether a field is the time of a row that is placed by time.
  bool is_time(std::size_t field) const {
    return is_by_time() && fields()[field].kind == CellKind::time &&
           field_writers<double>[field] == write_sample_time<double>;
  }
  Rounding rounding(std::size_t field, const FastRow& row) const {
    return {notation_, fields()[field].kind, row.segment.decimals};
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
  template <class F>
  void for_each_open_field(const F& f) {
    for_each_field([&](const std::size_t& index, Cells cells) {
      if (!std::ranges::all_of(cells, is_set)) f(index, cells);
    });
  }

  /// The numbers of a field at a scalar.
  template <class S>
  std::vector<Written<S>> numbers(RowPoint<S>& point, std::size_t field) {
    std::vector<Written<S>> row;
    point.write(field, row);
    return row;
  }
  /// The numbers of fields without exact arithmetic.
  std::vector<Cell> in_doubles(const FastRow& row, std::span<const std::size_t> chosen) {
    Located located{{row.sample}};
    if (row.end != nullptr) located.ends = {*row.end};
    if (row.outside != nullptr) located.outside = {*row.outside};
    if (row.motion != nullptr) located.motions = {*row.motion};
    std::vector<Cell> cells(width(chosen));
    write_rows(cells.data(), cells.size(), chosen, row.segment, located, double_point_);
    return cells;
  }

  /// Finds where a row by length is. Throws: Error where no float decides it.
  void set_place(FastRow& row) {
    if (is_middle(row)) {
      row.at_key = {row.segment.number, std::nullopt, true};
      return;
    }
    std::optional<PlaceByLength> place;
    const auto try_to = [&](const auto& find) {
      try {
        if (!place) place = find();
      } catch (const Undecided&) {
      }
    };
    if (double_doubles_) {
      place_double_doubles(row);
      if (is_placed_.double_doubles) place = double_doubles_->place_of_row();
    }
    try_to([&] { return in_short(row).place_of_row(); });
    try_to([&] { return in_long(row).place_of_row(); });
    if (!place) refuse_digits(row);
    segment_ = place->segment;
    if (place->key_at_end) row.at_key = place;
  }

  /// Times, lengths between keys that are requested, and positions at keys.
  void set_known(const FastRow& row) {
    for_each_field([&](std::size_t index, Cells cells) {
      if (is_time(index)) {
        cells[0] = time_cell(row, rows_, notation_);
      } else if (rows_.arc && !row.at_key && fields()[index].name == "s") {
        if (const auto length = rows_.arc->length(row.number)) cells[0] = rounding(index, row).exactly({*length});
      } else if (fields()[index].name == "position" && is_at_plain_key(row)) {
        const spline::Keys<Rational>& keys = rows_.exact.keys;
        const auto position = keys.position((row.at_key->segment + (*row.at_key->key_at_end ? 1 : 0)) % keys.size());
        for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = rounding(index, row).exactly({position[i]});
      }
    });
  }
  /// Whether a row by length is at a key whose position is the row's.
  bool is_at_plain_key(const FastRow& row) const {
    const ExactCurve& exact = rows_.exact;
    return row.at_key && row.at_key->key_at_end && exact.rules.rotations.empty() && exact.rules.angles.empty() &&
           std::ranges::find(exact.keys.missing, true) == exact.keys.missing.end();
  }

  /// Cells that are rational, or roots of rationals, by bounds on their errors.
  void set_bounded(const FastRow& row) {
    for_each_open_field([&](std::size_t index, Cells cells) {
      if (!is_bounded(index)) return;
      if (!bounded_) bounded_.emplace(rows_);
      if (!std::exchange(is_placed_.bounded, true)) bounded_->place(row);
      const auto written = numbers(*bounded_, index);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const Quantity<Bounded>& number = written[i].number;
        cells[i] = number.defined ? rounding(index, row).within(root_of(number)) : Printed{empty_cell};
        const auto cell = static_cast<std::size_t>(&cells[i] - cells_.data());
        may_be_zero_[cell] = std::isfinite(number.value.error) && number.value.may_be_zero();
        may_be_along_ = may_be_along_ || (number.defined && number.value.may_be_zero());
      }
    });
  }

  /// Cells of double-doubles, with errors estimated by those of doubles.
  void set_estimated(const FastRow& row) {
    if (!double_doubles_ || (rows_.arc && !row.at_key && !is_placed_.double_doubles)) return;
    if (std::ranges::all_of(cells_, is_set)) return;
    const std::vector<std::size_t>& fields = has_rational_place_ ? irrational_ : chosen_;
    if (fields.empty()) return;
    if (!rows_.arc || row.at_key) place_double_doubles(row);
    if (!is_placed_.double_doubles) return;
    const std::vector<Cell> doubles = in_doubles(row, fields);
    auto next = doubles.begin();
    for_each_field([&](std::size_t index, Cells cells) {
      if (std::ranges::find(fields, index) == fields.end()) return;
      const auto given = std::span(next, cells.size());
      next += static_cast<std::ptrdiff_t>(cells.size());
      if (std::ranges::all_of(cells, is_set)) return;
      if (field_may_be_none(index) && may_rest(row)) return;
      const auto written = numbers(*double_doubles_, index);
      const double moved = place_part(index, row, double_doubles_->place_error()).hi;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i] = estimated(written[i], given[i], scale_of(index, i, row), moved, rounding(index, row));
      }
    });
  }

  /// How large the terms of a number are that double-doubles have placed; 0 where that is not known.
  double scale_of(std::size_t field, std::size_t channel, const FastRow& row) const {
    const double duration = row.segment.duration().hi;
    if (fields()[field].kind == CellKind::time) return duration;
    constexpr std::array<std::string_view, 4> derivatives{"position", "velocity", "acceleration", "jerk"};
    const auto* const order = std::ranges::find(derivatives, fields()[field].name);
    if (order == derivatives.end() || !rows_.exact.rules.rotations.empty()) return 0;
    double unit = 1;  // of time, to the power of the order
    for (const auto* lower = derivatives.begin(); lower != order; ++lower) unit *= duration;
    const double scale = double_doubles_->scale(channel) / unit;
    return std::isfinite(scale) ? scale : 0;
  }

  /// By which part of its scale a number of a field may move with the place of its row.
  template <class S>
  S place_part(std::size_t field, const FastRow& row, const PlaceError<S>& error) const {
    const std::string_view name = fields()[field].name;
    if (name == "s") return S(0);
    if (name == "position" && is_as_smooth_as_place(field)) return error.place;
    return is_as_smooth_as_place(field) ? row.segment.warp.is_identity() ? error.place : error.eased : error.part;
  }
  /// Times, and positions that are no rotations.
  bool is_as_smooth_as_place(std::size_t field) const {
    const std::string_view name = fields()[field].name;
    return name == "time" || name == "u" || (name == "position" && rows_.exact.rules.rotations.empty());
  }

  static bool field_may_be_none(std::size_t field) {
    const std::string_view name = fields()[field].name;
    return name == "tangent" || name == "curvature" || name == "torsion";
  }
  /// Whether the curve may rest at the row that double-doubles have placed, so that its shape there would be a quotient
  /// of errors.
  bool may_rest(const FastRow& row) {
    if (row.part) {
      const auto velocity = numbers(*double_doubles_, field_of("velocity"));
      return !velocity.empty() && !velocity[0].number.defined;
    }
    double scale = 0;
    for (std::size_t i = 0; i < rows_.exact.keys.channels; ++i) scale = std::max(scale, double_doubles_->scale(i));
    const double speed = numbers(*double_doubles_, field_of("speed"))[0].number.value.hi;
    return !(speed * row.segment.duration().hi > 0x1p-60 * scale);
  }

  void place_double_doubles(const FastRow& row) {
    try {
      double_doubles_->place(row);
      is_placed_.double_doubles = true;
    } catch (const Undecided&) {
    }
  }

  /// What double-doubles and doubles decide of a number, where its terms are as large as `scale`, and `moved` is its
  /// place_part(). Where they disagree on 0, or on whether there is a number, that is open.
  std::optional<Printed> estimated(const Written<spline::DoubleDouble>& written, const Cell& in_double, double scale,
                                   double moved, const Rounding& rounding) const {
    const auto& [number, is_zero] = written;
    if (is_zero) return rounding.exactly({0});
    const bool is_none = is_empty(in_double);
    if (!number.defined || is_none) {
      return !number.defined && is_none && keeps_digits_ ? std::optional(Printed{empty_cell}) : std::nullopt;
    }
    const spline::DoubleDouble& value = number.value;
    if (!std::isfinite(value.hi) || !std::isfinite(in_double.hi)) return std::nullopt;
    if (value.hi == 0 && in_double.hi == 0 && keeps_digits_) return rounding.exactly({0});
    if (value.hi == 0 || in_double.hi == 0 || std::abs(value.hi) < 0x1p-900) return std::nullopt;
    const double size = std::abs(value.hi);
    const double apart = std::abs((in_double - value).hi);
    return rounding.within(Bounded(value, std::max({0x1p50 * least_part_ * apart, least_part_ * size, 0x1p-92 * scale,
                                                    moved * std::max(size, scale)})));
  }

  /// Sets the cells that are open: rational ones exactly, and others by floats.
  void complete(const FastRow& row) {
    set_along(row);
    for_each_open_field([&](std::size_t index, Cells cells) {
      if (is_bounded(index)) {
        set_rationals(row, index, cells);
      } else {
        set_by_floats(row, index, cells, rounding(index, row));
      }
    });
  }

  void set_rationals(const FastRow& row, std::size_t index, Cells cells) {
    if (!exact_) exact_.emplace(rows_);
    if (!std::exchange(is_placed_.exact, true)) exact_->place(row);
    const auto written = numbers(*exact_, index);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto& [value, defined, root] = written[i].number;
      cells[i] = rounding(index, row).exactly({value, root, !defined});
    }
  }

  /// The error of a float is estimated by the numbers before it, in fewer digits.
  void set_by_floats(const FastRow& row, std::size_t index, Cells cells, const Rounding& rounding) {
    if (is_none(row, index)) {
      std::ranges::fill(cells, Printed{empty_cell});
      return;
    }
    static const Rational of_short = power_of_two(-160), of_long = power_of_two(-430);
    static const Rational short_part = power_of_two(-60), long_part = power_of_two(-300), between = power_of_two(-210);
    std::vector<std::optional<Rational>> first(cells.size()), second = first, third;
    if (double_doubles_ && is_placed_.double_doubles) {
      const auto written = numbers(*double_doubles_, index);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& number = written[i].number;
        if (number.defined && std::isfinite(number.value.hi)) first[i] = exactly(number.value);
      }
    } else {
      const std::vector<Cell> written = in_doubles(row, {&index, 1});
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!is_empty(written[i]) && std::isfinite(written[i].hi) && written[i].hi != 0) first[i] = exactly(written[i]);
      }
    }
    Rational moved;
    try {
      second = in_short(row).numbers(index);
      moved = place_part(index, row, in_short(row).place_error());
    } catch (const Undecided&) {
    }
    const auto scale_at = [&](std::size_t i) {
      return is_placed_.double_doubles ? Rational(scale_of(index, i, row)) : Rational(0);
    };
    const auto part_of = [](const Rational& value, const std::optional<Rational>& before, const Rational& part) {
      return before ? Rational(abs(value - *before) * part) : Rational(0);
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i] || !first[i] || !second[i]) continue;
      if (*first[i] == 0 && (*second[i] != 0 || !keeps_digits_)) continue;  // which may be the error of a 0
      const Rational size = abs(*second[i]), scale = scale_at(i);
      const Rational error = std::max({part_of(*second[i], first[i], short_part), Rational(size * of_short),
                                       Rational(moved * std::max(size, scale))});
      cells[i] = rounding.within(Known{*second[i], error});
    }
    if (std::ranges::all_of(cells, is_set)) return;
    try {
      third = in_long(row).numbers(index);
      moved = is_as_smooth_as_place(index) ? place_part(index, row, in_long(row).place_error()) : Rational(0);
      const Rational noise = in_long(row).noise(index);
      for (auto& number : third) {
        if (number && abs(*number) <= noise) number = 0;
      }
    } catch (const Undecided&) {
      refuse_digits(row);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i]) continue;
      if (!third[i]) {
        cells[i] = Printed{empty_cell};
      } else if (keeps_digits_ && second[i] == Rational(0)) {  // what is left in more digits are their errors
        cells[i] = rounding.exactly({0});
      } else {
        const bool has_second = second[i] && *second[i] != 0;
        const Rational error =
            has_second ? part_of(*third[i], second[i], between) : part_of(*third[i], first[i], long_part);
        const Rational size = abs(*third[i]), scale = scale_at(i);
        const Known known{*third[i],
                          std::max({error, Rational(size * of_long), Rational(moved * std::max(size, scale))})};
        cells[i] = rounding.within(known);
        if (!cells[i]) cells[i] = rounding.snapped(known);
      }
      if (!cells[i]) refuse_digits(row);
    }
  }

  /// Whether a field has no number, as the curve rests there, or does not bend.
  bool is_none(const FastRow& row, std::size_t field) {
    const std::string_view name = fields()[field].name;
    const std::string_view needed = name == "torsion"                          ? "curvature"
                                    : name == "tangent" || name == "curvature" ? "speed"
                                                                               : "";
    if (needed.empty()) return false;
    const bool is_paced = needed == "speed" && row.part;  // whose speed is not that of the curve
    const std::size_t index = field_of(is_paced ? "velocity" : needed);
    std::vector<std::optional<Printed>> found(width({&index, 1}));
    if (found.empty()) return false;
    set_by_floats(row, index, found, Rounding({}, CellKind::real));
    return is_empty(found[0]->cell) || (!is_paced && found[0]->is_zero);
  }
  [[noreturn]] static void refuse_digits(const FastRow& row) {
    throw data_error(
        "the row at time {} has a number that cannot be computed to the requested digits; request fewer with --digits "
        "or --fixed",
        time_text(row.sample.t));
  }

  /// A position that is 0 has the sign that it has without exact numbers, which have no -0: that of a key of -0.
  void set_signs_of_zeros(const FastRow& row) {
    const auto is_zero = [](const std::optional<Printed>& cell) { return cell->is_zero; };
    for_each_field([&](const std::size_t& index, Cells cells) {
      const Field& field = fields()[index];
      const bool has_positions = field.shows_rotations || (field.of_piece && field.per_channel);
      if (!has_positions || std::ranges::none_of(cells, is_zero)) return;
      const std::vector<Cell> inexact = in_doubles(row, {&index, 1});
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!is_zero(cells[i]) || inexact[i].hi != 0 || !std::signbit(inexact[i].hi)) continue;
        cells[i]->cell = Cell(-0.0);
        std::string& text = cells[i]->text;
        if (!text.empty()) text.insert(0, "-");
      }
    });
  }

  /// Sets the open cells of rational fields that are the same all along the segment of a row. That is looked up where
  /// several rows of a segment need it, or where it spares floats.
  void set_along(const FastRow& row) {
    if (!is_rational_curve_ || row.outside != nullptr || row.end != nullptr || row.at_key) return;
    const std::size_t segment = rows_.arc            ? segment_
                                : is_placed_.bounded ? bounded_->place_of_row().segment
                                                     : row.segment.number;
    constexpr std::size_t most_kept = 4096;
    if (along_.size() == most_kept) along_.clear();
    AlongSegment& along = along_[segment];
    constexpr int few = 8;
    if (!rows_.arc && (!may_be_along_ || ++along.rows < few)) return;
    if (along.cells.empty()) look_along(segment, along.cells);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::optional<Printed>& cell = along.cells[i];
      const bool is_needed = !cells_[i] && cell && (rows_.arc || is_empty(cell->cell) || may_be_zero_[i]);
      if (is_needed) cells_[i] = cell;
    }
  }

  void look_along(std::size_t segment, std::vector<std::optional<Printed>>& cells) {
    if (!exact_) exact_.emplace(rows_);
    is_placed_.exact = false;
    exact_->place_inside(segment, inner_places.front());
    const auto are_same = [](const Quantity<Rational>& a, const Quantity<Rational>& b) {
      return a.defined == b.defined && (!a.defined || (a.value == b.value && a.root == b.root));
    };
    for_each_field([&](const std::size_t& index, Cells of_field) {
      const Field& field = fields()[index];
      const bool jumps = exact_->has_ease() && (field.name == "acceleration" || field.name == "jerk");
      const bool is_of_place = is_rational(index) && field.kind == CellKind::real && !field.of_piece && !jumps;
      std::vector<Written<Rational>> first;
      std::vector<bool> is_same(of_field.size(), is_of_place);
      for (const double u : inner_places) {
        if (std::ranges::find(is_same, true) == is_same.end()) break;
        exact_->place_inside(segment, u);
        const auto here = numbers(*exact_, index);
        if (first.empty()) first = here;
        for (std::size_t i = 0; i < here.size(); ++i) {
          is_same[i] = is_same[i] && are_same(here[i].number, first[i].number);
        }
      }
      for (std::size_t i = 0; i < of_field.size(); ++i) {
        cells.emplace_back();
        if (!is_same[i]) continue;
        const auto& [value, defined, root] = first[i].number;
        cells.back() = Rounding(notation_, CellKind::real).exactly({value, root, !defined});
      }
    });
  }

  /// Whether a row is in the middle of a symmetric curve, and of a segment.
  bool is_middle(const FastRow& row) {
    const std::size_t keys = rows_.exact.keys.size(), segments = rows_.exact.closed ? keys : keys - 1;
    const bool may_be = rows_.arc->intervals != 0 && rows_.arc->from == 0 &&
                        row.number == rows_.arc->intervals - row.number && segments % 2 == 1 &&
                        row.segment.number == segments / 2;
    if (may_be && !is_symmetric_) {
      if (!exact_ && is_rational_curve_) exact_.emplace(rows_);
      is_symmetric_ = is_rational_curve_ ? exact_->is_symmetric() : long_floats().is_symmetric();
    }
    return may_be && *is_symmetric_;
  }

  FloatRows& long_floats() {
    if (long_floats_ == nullptr) long_floats_ = FloatRows::in_long(rows_);
    return *long_floats_;
  }
  /// The floats, at the current row. Throws: Undecided.
  FloatRows& in_short(const FastRow& row) {
    if (short_floats_ == nullptr) short_floats_ = FloatRows::in_short(rows_);
    return placed(*short_floats_, row, is_placed_.short_floats);
  }
  FloatRows& in_long(const FastRow& row) { return placed(long_floats(), row, is_placed_.long_floats); }
  static FloatRows& placed(FloatRows& floats, const FastRow& row, bool& is_placed) {
    if (!is_placed) floats.place(row);
    is_placed = true;
    return floats;
  }

  const RowsOfCurve& rows_;
  const Notation& notation_;
  const std::vector<std::size_t> chosen_;  ///< fields
  const bool keeps_digits_, is_rational_curve_;
  const double least_part_;                    ///< of a number, that its error is at least
  std::vector<std::size_t> irrational_ = {};   ///< of the fields
  std::vector<std::optional<Printed>> cells_;  ///< of the current row
  bool has_rational_place_ = false;            ///< the current row
  std::size_t segment_ = 0;                    ///< on which it is, if it is placed by length
  bool may_be_along_ = false;                  ///< a cell of the row may be 0 or empty all along its segment
  std::vector<bool> may_be_zero_;              ///< each cell, by its bound
  Placed is_placed_;                           ///< the current row, at these scalars
  Point<double> double_point_;
  std::optional<RowPoint<spline::DoubleDouble>> double_doubles_;  ///< nothing: they do not hold the curve
  std::optional<RowPoint<Bounded>> bounded_;                      ///< these are made when they are needed
  std::optional<RowPoint<Rational>> exact_;
  std::unique_ptr<FloatRows> short_floats_, long_floats_;
  std::optional<bool> is_symmetric_;
  std::map<std::size_t, AlongSegment> along_;  ///< of segments
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
      const Motion* const motion = located.motions.empty() ? nullptr : &located.motions[i];
      evaluation->add_row({segment, located.samples[i], first + i, end, outside, motion}, locator, table);
    }
  }
  give_back(std::move(evaluation));
  return table;
}

}  // namespace tcb
