// Fields: what a row can show of a point of the curve.
#include "fields.hpp"

#include <array>
#include <utility>

namespace tcb {
namespace {

using format::Cell;
using format::CellKind;

void append_optional(std::vector<Cell>& row, const std::optional<double>& value) {
  row.push_back(value ? Cell(*value) : format::empty_cell);
}

void append_time(std::vector<Cell>& row, Point& point) { row.push_back(point.sample().t); }

void append_position(std::vector<Cell>& row, Point& point) {
  const auto& piece = point.piece();
  const auto& sample = point.sample();
  const sampler::Outside& outside = sample.outside;
  const bool goes_on = outside.beyond.hi != 0;
  for (std::size_t i = 0; i < piece.cubics.size(); ++i) {
    double position = spline::position(piece.cubics[i], sample.at);
    if (goes_on) position += point.motion().velocity[i] * outside.beyond.hi;
    if (outside.cycles != 0) position += outside.cycles * piece.cycle[i];
    row.emplace_back(position);
  }
}

/// The arc length from the curve's first key.
void append_length(std::vector<Cell>& row, Point& point) {
  const auto& piece = point.piece();
  if (point.sample().s) {
    row.emplace_back(*point.sample().s);
    return;
  }
  const auto into = point.arc().to(point.sample().at);
  row.emplace_back((piece.s_start + spline::Twice(into.value)).hi);
}

template <std::vector<double> spline::Motion<double>::*derivative>
void append_derivative(std::vector<Cell>& row, Point& point) {
  for (const double value : point.motion().*derivative) row.emplace_back(value);
}

void append_speed(std::vector<Cell>& row, Point& point) { row.emplace_back(point.shape().speed); }

void append_tangent(std::vector<Cell>& row, Point& point) {
  const auto& shape = point.shape();
  for (const double value : point.motion().velocity) {
    row.push_back(shape.moves ? Cell(value / shape.speed) : format::empty_cell);
  }
}

void append_curvature(std::vector<Cell>& row, Point& point) { append_optional(row, point.shape().curvature); }
void append_torsion(std::vector<Cell>& row, Point& point) {
  append_optional(row, spline::torsion(point.motion(), point.piece().metric));
}

void append_segment(std::vector<Cell>& row, Point& point) {
  row.emplace_back(static_cast<double>(point.piece().number));
}

/// The fraction of the segment's duration that has passed.
void append_u(std::vector<Cell>& row, Point& point) {
  const auto& at = point.sample().at;
  row.emplace_back(at.u == 0 || at.w == 0 ? at.u : point.piece().warp.inverse(at).hi);
}

void append_key(std::vector<Cell>& row, Point& point) {
  const auto& at = point.sample().at;
  const auto number = static_cast<double>(point.piece().number);
  row.push_back(at.u == 0   ? Cell(number)
                : at.w == 0 ? Cell(static_cast<double>(point.piece().end_key))
                            : format::empty_cell);
}

void append_arc_error(std::vector<Cell>& row, Point& point) { row.emplace_back(point.piece().s_error); }

using Motion = spline::Motion<double>;

constexpr std::array all_fields{
    Field{"time", "", CellKind::time, false, false, false, false, append_time},
    Field{"position", "", CellKind::real, true, false, false, false, append_position},
    Field{"s", "", CellKind::real, false, true, true, false, append_length},
    Field{"velocity", "_v", CellKind::real, true, false, false, true, append_derivative<&Motion::velocity>},
    Field{"acceleration", "_a", CellKind::real, true, false, false, true, append_derivative<&Motion::acceleration>},
    Field{"jerk", "_j", CellKind::real, true, false, false, true, append_derivative<&Motion::jerk>},
    Field{"speed", "", CellKind::real, false, false, true, true, append_speed},
    Field{"tangent", "_t", CellKind::real, true, false, true, true, append_tangent},
    Field{"curvature", "", CellKind::real, false, false, true, true, append_curvature},
    Field{"torsion", "", CellKind::real, false, false, true, true, append_torsion},
    Field{"segment", "", CellKind::whole, false, false, false, true, append_segment},
    Field{"u", "", CellKind::real, false, false, false, true, append_u},
    Field{"key", "", CellKind::whole, false, false, false, false, append_key},
    Field{"arc_error", "", CellKind::real, false, true, true, false, append_arc_error},
};

}  // namespace

void Point::set(const sampler::Piece& piece) {
  piece_ = &piece;
  has_arc_ = false;
}

void Point::set(const sampler::Sample& sample) {
  sample_ = &sample;
  has_motion_ = false;
  shape_.reset();
}

const spline::ArcLength<double>& Point::arc() {
  if (!std::exchange(has_arc_, true)) arc_.assign(piece_->cubics, piece_->metric);
  return arc_;
}

const spline::Motion<double>& Point::motion() {
  if (has_motion_) return motion_;
  has_motion_ = true;
  const auto& at = sample_->at;
  const auto& outside = sample_->outside;
  const double passed = at.u == 0 || at.w == 0 ? at.u : piece_->warp.inverse(at).hi;
  spline::set_motion<double>(motion_, piece_->cubics, at, piece_->warp, passed, (piece_->end - piece_->start).hi);
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

std::vector<format::OutputColumn> output_columns(std::span<const std::size_t> chosen, const format::Input& input) {
  std::vector<format::OutputColumn> columns;
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
