// Fields: the one table of the quantities that a row can show, and the functions that write their cells, for doubles
// and for exact scalars.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "numbers/decimal_time.hpp"
#include "sample/point.hpp"
#include "sample/sampler.hpp"
#include "sample/table.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

/// Receives the numbers of a point, one cell after another. For exact scalars see exact/exact_rows.hpp.
template <class S>
class CellWriter;

template <>
class CellWriter<double> {
 public:
  explicit CellWriter(Cell* next) : next_(next) {}
  void add(const Cell& value) { *next_++ = value; }
  void add(const Quantity<double>& value) { add(value.defined ? Cell(value.value) : empty_cell); }
  /// One of a channel's numbers: a position, or with `moves` a derivative.
  void add_of_channel(double value, std::size_t, bool) { add(value); }

 private:
  Cell* next_;
};

template <class S>
void write_sample_time(Point<S>& point, CellWriter<S> out) {
  out.add(point.sample().t);
}
template <class S>
void write_position(Point<S>& point, CellWriter<S> out) {
  const CurveSegmentOf<S>& segment = point.segment();
  const std::span<const RotationColumns> rotations = segment.rotation_columns;
  std::vector<spline::RotationNumbers<S>> numbers(rotations.size());
  if constexpr (spline::has_roots<S>) {
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      numbers[i] = spline::numbers_of(point.rotation(i), rotations[i].shown);
    }
  }
  for (const PositionCell& cell : position_cells(segment.cubics.size(), rotations)) {
    if (cell.rotation == PositionCell::none) {
      const S position = point.position(cell.channel);
      const AngleColumn* const angle = segment.angle(cell.channel);
      using spline::wrapped;
      out.add_of_channel(angle == nullptr ? position : wrapped(position, angle->degrees, angle->is_signed),
                         cell.channel, false);
    } else if (cell.channel != PositionCell::none) {
      out.add_of_channel(numbers[cell.rotation][cell.number], cell.channel, false);
    } else {
      out.add(numbers[cell.rotation][cell.number]);
    }
  }
}
/// A derivative of the channels that are in no rotation; empty where it is not defined.
template <class S>
void write_derivative(Point<S>& point, CellWriter<S> out, const std::vector<S>& values, bool defined = true) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (point.is_in_rotation(i)) continue;
    if (defined) {
      out.add_of_channel(values[i], i, true);
    } else {
      out.add(Quantity<S>{values[i], false});
    }
  }
}
template <class S>
void write_velocity(Point<S>& point, CellWriter<S> out) {
  write_derivative(point, out, point.row_velocity(), point.has_row_velocity());
}
template <class S>
void write_acceleration(Point<S>& point, CellWriter<S> out) {
  write_derivative(point, out, point.row_acceleration(), point.has_row_acceleration());
}
template <class S>
void write_jerk(Point<S>& point, CellWriter<S> out) {
  write_derivative(point, out, point.derivatives().jerk);
}
template <class S>
void write_tangent(Point<S>& point, CellWriter<S> out) {
  for (std::size_t i = 0; i < point.segment().cubics.size(); ++i) {
    if (!point.is_in_rotation(i)) out.add(point.tangent(i));
  }
}
template <class S>
void write_angular_velocity(Point<S>& point, CellWriter<S> out) {
  if constexpr (spline::has_roots<S>) {
    for (std::size_t i = 0; i < point.segment().rotations.size(); ++i) {
      for (const S& number : point.angular_velocity(i)) out.add(Quantity<S>{number, point.has_row_velocity()});
    }
  }
}
template <class S>
void write_angular_speed(Point<S>& point, CellWriter<S> out) {
  if constexpr (spline::has_roots<S>) {
    for (std::size_t i = 0; i < point.segment().rotations.size(); ++i) {
      const auto [x, y, z] = point.angular_velocity(i);
      out.add(Quantity<S>{S(spline::square_root(x * x + (y * y + z * z))), point.has_row_velocity()});
    }
  }
}

// Pieces: the cubics from a sample to the end of its piece, in three forms, with their duration and length.
//
// With the piece from t0 to t1, h = t1 - t0, and X a channel:
//   hermite  X(t0), X'(t0), X(t1), X'(t1)
//   bezier   X(t0), X(t0) + h X'(t0) / 3, X(t1) - h X'(t1) / 3, X(t1)
//   poly     c0, c1, c2, c3 with X(t) = c0 + c1 (t - t0) + c2 (t - t0)^2 + c3 (t - t0)^3
// Requires: a segment without ease.
// Promises: positions are those of samples at t0 and t1. For doubles each other number is within 2 ulp of the exact
//   one; on a part of a segment, within 4 ulp of its largest term.

/// The time of a sample; at a key that of the key.
template <class S>
const spline::Time<S>& time_of(const CurveSegmentOf<S>& segment, const SampleOf<S>& sample) {
  return sample.at.u == S(0) ? segment.start : sample.at.w == S(0) ? segment.end : sample.t;
}
template <class S>
const spline::Time<S>& piece_start(const Point<S>& point) {
  return time_of(point.segment(), point.sample());
}
template <class S>
const spline::Time<S>& piece_end(const Point<S>& point) {
  return time_of(point.segment(), point.end());
}

/// The time from a piece's start to its end, before it is rounded.
template <class S>
spline::Time<S> piece_time(const Point<S>& point) {
  const auto& segment = point.segment();
  return spline::elapsed<S>(segment.precise(piece_start(point)), segment.precise(piece_end(point)));
}

template <class S>
S piece_duration(const Point<S>& point) {
  const spline::Time<S>&start = piece_start(point), &end = piece_end(point);
  if constexpr (std::is_same_v<S, double>) {
    if (is_long_decimal(start) || is_long_decimal(end)) {
      return nearest_double(exact_number(end, false) - exact_number(start, false));
    }
  }
  return spline::high_part<S>(piece_time(point));
}

/// A channel of the piece as a cubic of its own, between the positions of samples.
template <class S>
spline::Cubic<S> piece_cubic(const Point<S>& point, std::size_t channel) {
  const auto& segment = point.segment();
  const spline::Cubic<S>& whole = segment.cubics[channel];
  spline::Cubic<S> cubic =
      spline::expanded_part(whole, segment.precise(segment.start), segment.precise(segment.end),
                            segment.precise(piece_start(point)), segment.precise(piece_end(point)));
  cubic.p0 = spline::position(whole, point.sample().at);
  cubic.p1 = spline::position(whole, point.end().at);
  return cubic;
}

/// A working value rounded; a zero is not negative.
template <class S>
S rounded_once(const spline::working_t<S>& value) {
  return spline::high_part<S>(value) + S(0);
}

/// The forms of the cubic of a piece that takes the time h.
template <class S>
using CubicForm = std::array<S, 4> (*)(const spline::Cubic<S>& x, const spline::working_t<S>& h);

template <class S>
std::array<S, 4> hermite_form(const spline::Cubic<S>& x, const spline::working_t<S>& h) {
  using W = spline::working_t<S>;
  return {x.p0, rounded_once<S>(W(x.out) / h), x.p1, rounded_once<S>(W(x.in) / h)};
}

template <class S>
std::array<S, 4> bezier_form(const spline::Cubic<S>& x, const spline::working_t<S>&) {
  using W = spline::working_t<S>;
  return {x.p0, rounded_once<S>(W(x.p0) + W(x.out) / W(3)), rounded_once<S>(W(x.p1) - W(x.in) / W(3)), x.p1};
}

template <class S>
std::array<S, 4> polynomial_form(const spline::Cubic<S>& x, const spline::working_t<S>& h) {
  using W = spline::working_t<S>;
  const W c = W(x.c) + W(x.c_low);
  return {x.p0, rounded_once<S>(W(x.out) / h), rounded_once<S>(c / h / h), rounded_once<S>(W(x.d) / h / h / h)};
}

/// The length of the piece over the metric channels. Lengths are not rational.
template <class S>
S piece_length(const Point<S>& point) {
  if constexpr (spline::has_roots<S>) {
    std::vector<spline::Cubic<S>> cubics;
    for (std::size_t i = 0; i < point.segment().cubics.size(); ++i) cubics.push_back(piece_cubic(point, i));
    spline::SegmentLength<S> length;
    length.assign(cubics, point.segment().metric);
    return length.total().value;
  } else {
    return S(0);
  }
}

/// The four numbers of a piece's cubic in a form, for each channel.
template <class S, CubicForm<S> form>
void write_cubics(Point<S>& point, CellWriter<S> out) {
  const auto h = piece_time(point);
  for (std::size_t i = 0; i < point.segment().cubics.size(); ++i) {
    for (const S& number : form(piece_cubic(point, i), h)) out.add_of_channel(number, i, false);
  }
}

/// Writes a column of all samples on a segment, in rows of `width` cells. Requires: they are on the curve.
using WriteColumn = void (*)(Cell* first, std::size_t width, const CurveSegment& segment,
                             std::span<const Sample> samples);
void write_times(Cell* first, std::size_t width, const CurveSegment& segment, std::span<const Sample> samples);
void write_positions(Cell* first, std::size_t width, const CurveSegment& segment, std::span<const Sample> samples);

/// A field with the function that writes its cells for a point at a scalar.
template <class S>
struct FieldOf : Field {
  void (*write)(Point<S>& point, CellWriter<S> out);
  WriteColumn write_column = nullptr;  ///< the same for doubles, where that saves time
};

/// The fields of samples, then those of pieces, of which those with columns for each channel are the forms in which a
/// cubic can be given. To add a field: a row, with a function if it has more than one number. The order is that of
/// fields in help and manual.
template <class S>
inline constexpr std::array field_table{
    FieldOf<S>{{.name = "time", .kind = CellKind::time}, write_sample_time<S>, write_times},
    FieldOf<S>{{.name = "position", .per_channel = true, .shows_rotations = true}, write_position<S>, write_positions},
    FieldOf<S>{{.name = "s", .needs_lengths = true, .over_metric = true, .is_rational = false},
               [](Point<S>& point, CellWriter<S> out) { out.add(point.length()); }},
    FieldOf<S>{
        {.name = "velocity", .suffix = "_v", .per_channel = true, .of_motion = true, .of_pace = true, .has_side = true},
        write_velocity<S>},
    FieldOf<S>{{.name = "acceleration",
                .suffix = "_a",
                .per_channel = true,
                .of_motion = true,
                .of_pace = true,
                .has_side = true},
               write_acceleration<S>},
    FieldOf<S>{{.name = "jerk", .suffix = "_j", .per_channel = true, .of_motion = true, .has_side = true},
               write_jerk<S>},
    FieldOf<S>{{.name = "speed", .over_metric = true, .of_pace = true, .has_side = true},
               [](Point<S>& point, CellWriter<S> out) { out.add(point.speed()); }},
    FieldOf<S>{{.name = "tangent",
                .suffix = "_t",
                .per_channel = true,
                .of_motion = true,
                .over_metric = true,
                .has_side = true},
               write_tangent<S>},
    FieldOf<S>{{.name = "curvature", .over_metric = true, .has_side = true},
               [](Point<S>& point, CellWriter<S> out) { out.add(point.curvature()); }},
    FieldOf<S>{{.name = "torsion", .over_metric = true, .has_side = true},
               [](Point<S>& point, CellWriter<S> out) { out.add(point.torsion()); }},
    FieldOf<S>{{.name = "angular_velocity",
                .per_rotation = true,
                .columns = 3,
                .of_pace = true,
                .has_side = true,
                .is_rational = false},
               write_angular_velocity<S>},
    FieldOf<S>{{.name = "angular_speed", .per_rotation = true, .of_pace = true, .has_side = true, .is_rational = false},
               write_angular_speed<S>},
    FieldOf<S>{{.name = "segment", .kind = CellKind::whole, .has_side = true},
               [](Point<S>& point, CellWriter<S> out) {
                 out.add(static_cast<S>(static_cast<double>(point.segment().number)));
               }},
    FieldOf<S>{{.name = "u", .has_side = true}, [](Point<S>& point, CellWriter<S> out) { out.add(point.u()); }},
    FieldOf<S>{{.name = "key", .kind = CellKind::whole},
               [](Point<S>& point, CellWriter<S> out) { out.add(point.key()); }},
    FieldOf<S>{
        {.name = "arc_error", .needs_lengths = true, .over_metric = true, .is_exact = false, .is_rational = false},
        [](Point<S>& point, CellWriter<S> out) { out.add(static_cast<S>(point.segment().s_error)); }},
    FieldOf<S>{{.name = "length", .of_piece = true, .over_metric = true, .is_rational = false},
               [](Point<S>& point, CellWriter<S> out) { out.add(piece_length(point)); }},
    FieldOf<S>{{.name = "start", .kind = CellKind::time, .of_piece = true}, write_sample_time<S>},
    FieldOf<S>{{.name = "duration", .kind = CellKind::duration, .of_piece = true},
               [](Point<S>& point, CellWriter<S> out) { out.add(piece_duration(point)); }},
    FieldOf<S>{
        {.name = "hermite", .suffix = "_p", .per_channel = true, .columns = 4, .odd_suffix = "_v", .of_piece = true},
        write_cubics<S, hermite_form<S>>},
    FieldOf<S>{{.name = "bezier", .suffix = "_b", .per_channel = true, .columns = 4, .of_piece = true},
               write_cubics<S, bezier_form<S>>},
    FieldOf<S>{{.name = "poly", .suffix = "^", .per_channel = true, .columns = 4, .of_piece = true},
               write_cubics<S, polynomial_form<S>>},
};

/// The functions of all fields, so that the names of the fields are in the program once, not for each scalar.
template <class S>
inline constexpr auto field_writers = [] {
  std::array<decltype(FieldOf<S>::write), field_table<S>.size()> all{};
  std::ranges::transform(field_table<S>, all.begin(), &FieldOf<S>::write);
  return all;
}();

template <class S>
RowShape shape_of(const CurveSegmentOf<S>& segment) {
  return {segment.cubics.size(), segment.rotation_columns};
}

/// Writes fields of the samples on a segment, row after row of `width` cells. `point` is memory to reuse.
void write_rows(Cell* rows, std::size_t width, std::span<const std::size_t> chosen, const CurveSegment& segment,
                const Located& located, Point<double>& point);

}  // namespace tcb
