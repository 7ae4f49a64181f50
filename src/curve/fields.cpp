// Fields: what a row can show of a point of the curve.
#include "curve/fields.hpp"

#include <array>
#include <utility>

namespace tcb {
namespace {

Cell* write_one(Cell* row, const Cell& cell) {
  *row = cell;
  return row + 1;
}

Cell* write_optional(Cell* row, const std::optional<double>& value) {
  return write_one(row, value ? Cell(*value) : empty_cell);
}

Cell* write_time(Cell* row, Point& point) { return write_one(row, point.sample().t); }

void write_times(Cell* first, std::size_t width, const CurveSegment&, std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) first[i * width] = samples[i].t;
}

/// From a place at an end of the curve to one outside.
void go_on(Cell* position, Point& point, const Outside& outside) {
  for (std::size_t i = 0; i < point.piece().cubics.size(); ++i) {
    if (outside.beyond.hi != 0) position[i].hi += point.motion().velocity[i] * outside.beyond.hi;
    if (outside.cycles != 0) position[i].hi += outside.cycles * point.piece().cycle[i];
  }
}

Cell* write_position(Cell* row, Point& point) {
  Cell* const begin = row;
  for (const auto& x : point.piece().cubics) row = write_one(row, spline::position(x, point.sample().at));
  if (point.outside() != nullptr) go_on(begin, point, *point.outside());
  return row;
}

void write_positions(Cell* first, std::size_t width, const CurveSegment& piece, std::span<const Sample> samples) {
  for (const auto& x : piece.cubics) {
    Cell* cell = first++;
    const auto put = [&](double value) {
      *cell = value;
      cell += width;
    };
    for (std::size_t i = 0; i < samples.size();) {
      const auto& at = samples[i].at;
      if (i + 1 < samples.size() && spline::can_pair(at, samples[i + 1].at)) {
        const spline::DoublePair both = spline::positions(x, at, samples[i + 1].at);
        put(both[0]);
        put(both[1]);
        i += 2;
      } else {
        put(spline::position(x, at));
        ++i;
      }
    }
  }
}

/// The arc length from the curve's first key.
Cell* write_length(Cell* row, Point& point) {
  const auto& piece = point.piece();
  if (point.sample().s) return write_one(row, *point.sample().s);
  const auto into = point.arc().to(point.sample().at);
  return write_one(row, (piece.s_start + spline::DoubleDouble(into.value)).hi);
}

template <std::vector<double> spline::Derivatives<double>::*derivative>
Cell* write_derivative(Cell* row, Point& point) {
  for (const double value : point.motion().*derivative) row = write_one(row, value);
  return row;
}

Cell* write_speed(Cell* row, Point& point) { return write_one(row, point.shape().speed); }

Cell* write_tangent(Cell* row, Point& point) {
  const auto& shape = point.shape();
  for (const double value : point.motion().velocity) {
    row = write_one(row, shape.moves ? Cell(value / shape.speed) : empty_cell);
  }
  return row;
}

Cell* write_curvature(Cell* row, Point& point) { return write_optional(row, point.shape().curvature); }
Cell* write_torsion(Cell* row, Point& point) {
  return write_optional(row, spline::torsion(point.motion(), point.piece().metric));
}

Cell* write_segment(Cell* row, Point& point) { return write_one(row, static_cast<double>(point.piece().number)); }

/// The fraction of the segment's duration that has passed.
Cell* write_u(Cell* row, Point& point) {
  const auto& at = point.sample().at;
  return write_one(row, at.u == 0 || at.w == 0 ? at.u : point.piece().warp.inverse(at).hi);
}

Cell* write_key(Cell* row, Point& point) {
  const auto& at = point.sample().at;
  const auto number = static_cast<double>(point.piece().number);
  return write_one(row, at.u == 0   ? Cell(number)
                        : at.w == 0 ? Cell(static_cast<double>(point.piece().end_key))
                                    : empty_cell);
}

Cell* write_arc_error(Cell* row, Point& point) { return write_one(row, point.piece().s_error); }

using Motion = spline::Derivatives<double>;

constexpr std::array all_fields{
    Field{"time", "", CellKind::time, false, false, false, false, write_time, write_times},
    Field{"position", "", CellKind::real, true, false, false, false, write_position, write_positions},
    Field{"s", "", CellKind::real, false, true, true, false, write_length},
    Field{"velocity", "_v", CellKind::real, true, false, false, true, write_derivative<&Motion::velocity>},
    Field{"acceleration", "_a", CellKind::real, true, false, false, true, write_derivative<&Motion::acceleration>},
    Field{"jerk", "_j", CellKind::real, true, false, false, true, write_derivative<&Motion::jerk>},
    Field{"speed", "", CellKind::real, false, false, true, true, write_speed},
    Field{"tangent", "_t", CellKind::real, true, false, true, true, write_tangent},
    Field{"curvature", "", CellKind::real, false, false, true, true, write_curvature},
    Field{"torsion", "", CellKind::real, false, false, true, true, write_torsion},
    Field{"segment", "", CellKind::whole, false, false, false, true, write_segment},
    Field{"u", "", CellKind::real, false, false, false, true, write_u},
    Field{"key", "", CellKind::whole, false, false, false, false, write_key},
    Field{"arc_error", "", CellKind::real, false, true, true, false, write_arc_error},
};

}  // namespace

void Point::set(const CurveSegment& piece) {
  piece_ = &piece;
  has_arc_ = false;
}

void Point::set(const Sample& sample, const Outside* outside) {
  sample_ = &sample;
  outside_ = outside;
  has_motion_ = false;
  shape_.reset();
}

const spline::ArcLength<double>& Point::arc() {
  if (!std::exchange(has_arc_, true)) arc_.assign(piece_->cubics, piece_->metric);
  return arc_;
}

const spline::Derivatives<double>& Point::motion() {
  if (has_motion_) return motion_;
  has_motion_ = true;
  const auto& at = sample_->at;
  const double passed = at.u == 0 || at.w == 0 ? at.u : piece_->warp.inverse(at).hi;
  spline::set_derivatives<double>(motion_, piece_->cubics, at, piece_->warp, passed, (piece_->end - piece_->start).hi);
  const Outside outside = outside_ == nullptr ? Outside{} : *outside_;
  const double forth = outside.holds || piece_->start == piece_->end ? 0 : outside.backward ? -1 : 1;
  const double bends = outside.beyond.hi != 0 || forth == 0 ? 0 : 1;
  if (forth == 1 && bends == 1) return motion_;
  for (double& value : motion_.velocity) value = forth == 0 ? 0 : value * forth;
  for (double& value : motion_.acceleration) value = bends == 0 ? 0 : value;
  for (double& value : motion_.jerk) value = bends == 0 ? 0 : value * forth;
  return motion_;
}

const spline::Shape<double>& Point::shape() {
  if (!shape_) shape_ = spline::shape(motion(), piece_->metric);
  return *shape_;
}

std::span<const Field> fields() { return all_fields; }

std::size_t cells_in_row(std::span<const std::size_t> chosen, std::size_t channels) {
  std::size_t cells = 0;
  for (const std::size_t index : chosen) cells += all_fields[index].per_channel ? channels : 1;
  return cells;
}

void write_rows(Cell* rows, std::span<const std::size_t> chosen, const CurveSegment& piece, const Located& located,
                Point& point) {
  const std::size_t width = cells_in_row(chosen, piece.cubics.size());
  std::vector<std::pair<decltype(Field::write), Cell*>> by_row;  // and where in the first row
  Cell* first = rows;
  for (const std::size_t index : chosen) {
    const Field& field = all_fields[index];
    if (field.write_column != nullptr && located.outside.empty()) {
      field.write_column(first, width, piece, located.samples);
    } else {
      by_row.emplace_back(field.write, first);
    }
    first += cells_in_row({&index, 1}, piece.cubics.size());
  }
  if (by_row.empty()) return;
  point.set(piece);
  for (std::size_t i = 0; i < located.samples.size(); ++i) {
    point.set(located.samples[i], located.outside.empty() ? nullptr : &located.outside[i]);
    for (const auto& [write, cells] : by_row) write(cells + i * width, point);
  }
}

std::vector<OutputColumn> output_columns(std::span<const std::size_t> chosen, const Input& input) {
  std::vector<OutputColumn> columns;
  for (const std::size_t index : chosen) {
    const Field& field = all_fields[index];
    if (field.per_channel) {
      for (const std::string& channel : input.channels)
        columns.push_back({channel + std::string(field.suffix), field.kind});
    } else {
      columns.push_back({field.kind == CellKind::time ? input.time : std::string(field.name), field.kind});
    }
  }
  return columns;
}

}  // namespace tcb
