// Fields: the one table of the quantities that a row can show, for doubles and for exact scalars.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "curve/point.hpp"
#include "input/input.hpp"
#include "sampling/sampler.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb {

/// What the cells of a column are, which decides how they are written.
enum class CellKind { time, real, whole };

/// The name and kind of a column of the output.
struct OutputColumn {
  std::string name;
  CellKind kind = CellKind::real;
};

/// A number of a row. A time beyond 2^53 needs both parts.
using Cell = spline::DoubleDouble;

/// The cell of a number that is not defined.
inline constexpr Cell empty_cell{0, std::numeric_limits<double>::quiet_NaN()};
inline bool is_empty(const Cell& cell) { return cell.lo != cell.lo; }

struct Field {
  std::string_view name;
  std::string_view suffix = {};  ///< of a column's name, for a field with a column for each channel
  CellKind kind = CellKind::real;
  bool per_channel = false;    ///< a column for each channel, named after it; otherwise one
  bool needs_lengths = false;  ///< the segments before it have to be measured
  bool over_metric = false;    ///< it is a length or a speed over the metric channels
  bool has_side = false;       ///< at a key it may differ from one side to the other
  bool is_exact = true;        ///< it has an exact value, which is rounded once
  bool is_rational = true;     ///< for rational keys at a rational time it is rational, or the root of a rational
};

/// Receives the numbers of a point, one cell after another. For exact scalars see exact/precision_levels.
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
void write_time(Point<S>& point, CellWriter<S> out) {
  out.add(point.sample().t);
}
template <class S>
void write_position(Point<S>& point, CellWriter<S> out) {
  for (std::size_t i = 0; i < point.segment().cubics.size(); ++i) out.add_of_channel(point.position(i), i, false);
}
template <class S>
void write_length(Point<S>& point, CellWriter<S> out) {
  out.add(point.length());
}
template <class S, std::vector<S> spline::Derivatives<S>::*derivative>
void write_derivative(Point<S>& point, CellWriter<S> out) {
  const std::vector<S>& values = point.derivatives().*derivative;
  for (std::size_t i = 0; i < values.size(); ++i) out.add_of_channel(values[i], i, true);
}
template <class S>
void write_speed(Point<S>& point, CellWriter<S> out) {
  out.add(point.speed());
}
template <class S>
void write_tangent(Point<S>& point, CellWriter<S> out) {
  for (std::size_t i = 0; i < point.segment().cubics.size(); ++i) out.add(point.tangent(i));
}
template <class S>
void write_curvature(Point<S>& point, CellWriter<S> out) {
  out.add(point.curvature());
}
template <class S>
void write_torsion(Point<S>& point, CellWriter<S> out) {
  out.add(point.torsion());
}
template <class S>
void write_segment(Point<S>& point, CellWriter<S> out) {
  out.add(static_cast<S>(point.segment().number));
}
template <class S>
void write_u(Point<S>& point, CellWriter<S> out) {
  out.add(point.u());
}
template <class S>
void write_key(Point<S>& point, CellWriter<S> out) {
  out.add(point.key());
}
template <class S>
void write_arc_error(Point<S>& point, CellWriter<S> out) {
  out.add(static_cast<S>(point.segment().s_error));
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

/// To add a field: its function, and a row. The order is that of fields in help and manual.
template <class S>
inline constexpr std::array field_table{
    FieldOf<S>{{.name = "time", .kind = CellKind::time}, write_time<S>, write_times},
    FieldOf<S>{{.name = "position", .per_channel = true}, write_position<S>, write_positions},
    FieldOf<S>{{.name = "s", .needs_lengths = true, .over_metric = true, .is_rational = false}, write_length<S>},
    FieldOf<S>{{.name = "velocity", .suffix = "_v", .per_channel = true, .has_side = true},
               write_derivative<S, &spline::Derivatives<S>::velocity>},
    FieldOf<S>{{.name = "acceleration", .suffix = "_a", .per_channel = true, .has_side = true},
               write_derivative<S, &spline::Derivatives<S>::acceleration>},
    FieldOf<S>{{.name = "jerk", .suffix = "_j", .per_channel = true, .has_side = true},
               write_derivative<S, &spline::Derivatives<S>::jerk>},
    FieldOf<S>{{.name = "speed", .over_metric = true, .has_side = true}, write_speed<S>},
    FieldOf<S>{{.name = "tangent", .suffix = "_t", .per_channel = true, .over_metric = true, .has_side = true},
               write_tangent<S>},
    FieldOf<S>{{.name = "curvature", .over_metric = true, .has_side = true}, write_curvature<S>},
    FieldOf<S>{{.name = "torsion", .over_metric = true, .has_side = true}, write_torsion<S>},
    FieldOf<S>{{.name = "segment", .kind = CellKind::whole, .has_side = true}, write_segment<S>},
    FieldOf<S>{{.name = "u", .has_side = true}, write_u<S>},
    FieldOf<S>{{.name = "key", .kind = CellKind::whole}, write_key<S>},
    FieldOf<S>{
        {.name = "arc_error", .needs_lengths = true, .over_metric = true, .is_exact = false, .is_rational = false},
        write_arc_error<S>},
};

std::span<const FieldOf<double>> fields();

/// The number of cells of these fields in a row.
std::size_t cells_in_row(std::span<const std::size_t> chosen, std::size_t channels);

/// Writes fields of the samples on a segment, row after row. `point` is memory to reuse.
void write_rows(Cell* rows, std::span<const std::size_t> chosen, const CurveSegment& segment, const Located& located,
                Point<double>& point);

/// The columns of these fields.
std::vector<OutputColumn> output_columns(std::span<const std::size_t> chosen, const Input& input);

}  // namespace tcb
