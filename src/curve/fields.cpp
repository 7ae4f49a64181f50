// Fields: rows of doubles, by columns where that saves time.
#include "curve/fields.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tcb {

void write_times(Cell* first, std::size_t width, const CurveSegment&, std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) first[i * width] = samples[i].t;
}

void write_positions(Cell* first, std::size_t width, const CurveSegment& segment, std::span<const Sample> samples) {
  const bool has_rotations = !segment.rotations.empty();
  for (std::size_t i = 0; i < segment.rotations.size(); ++i) {
    const auto [x_cell, y_cell, z_cell, w_cell] = segment.rotation_channels[i];
    Cell* row = first;
    for (const Sample& sample : samples) {
      const auto [x, y, z, w] = segment.rotations[i].at(sample.at);
      row[x_cell] = x;
      row[y_cell] = y;
      row[z_cell] = z;
      row[w_cell] = w;
      row += width;
    }
  }
  for (const auto& x : segment.cubics) {
    Cell* cell = first++;
    if (has_rotations && segment.is_rotation(static_cast<std::size_t>(&x - segment.cubics.data()))) continue;
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

std::span<const FieldOf<double>> fields() { return field_table<double>; }

std::size_t field_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(fields(), name, &Field::name) - fields().begin());
}

std::size_t cells_in_row(std::span<const std::size_t> chosen, const RowShape& shape) {
  std::size_t cells = 0;
  for (const std::size_t index : chosen) {
    const Field& field = fields()[index];
    const std::size_t channels = shape.channels - (field.of_motion ? 4 * shape.rotations : 0);
    cells += field.columns * (field.per_channel ? channels : field.per_rotation ? shape.rotations : 1);
  }
  return cells;
}

void write_rows(Cell* rows, std::span<const std::size_t> chosen, const CurveSegment& segment, const Located& located,
                Point<double>& point) {
  const std::size_t width = cells_in_row(chosen, shape_of(segment));
  std::vector<std::pair<decltype(FieldOf<double>::write), Cell*>> by_row;  // and the cell in the first row
  Cell* first = rows;
  for (const std::size_t index : chosen) {
    const FieldOf<double>& field = fields()[index];
    if (field.write_column != nullptr && located.outside.empty()) {
      field.write_column(first, width, segment, located.samples);
    } else {
      by_row.emplace_back(field.write, first);
    }
    first += cells_in_row({&index, 1}, shape_of(segment));
  }
  if (by_row.empty()) return;
  point.set(segment);
  for (std::size_t i = 0; i < located.samples.size(); ++i) {
    point.set(located.samples[i], located.outside.empty() ? nullptr : &located.outside[i]);
    point.set_end(located.ends.empty() ? nullptr : &located.ends[i]);
    for (const auto& [write, cells] : by_row) write(point, CellWriter<double>(cells + i * width));
  }
}

namespace {

/// What follows the channel's name in one of the field's columns.
std::string column_suffix(const Field& field, std::size_t column) {
  if (field.columns == 1) return std::string(field.suffix);
  if (field.odd_suffix.empty()) return std::string(field.suffix) + std::to_string(column);
  return std::string(column % 2 == 0 ? field.suffix : field.odd_suffix) + std::to_string(column / 2);
}

/// The channels that are not numbers of a rotation.
std::vector<std::string> moving_channels(const Input& input) {
  std::vector<std::string> channels;
  for (std::size_t i = 0; i < input.channels.size(); ++i) {
    const auto has = [&](const spline::RotationChannels& four) { return std::ranges::count(four, i) > 0; };
    if (std::ranges::none_of(input.rotations, has)) channels.push_back(input.channels[i]);
  }
  return channels;
}

}  // namespace

std::vector<OutputColumn> output_columns(std::span<const std::size_t> chosen, const Input& input) {
  std::vector<OutputColumn> columns;
  for (const std::size_t index : chosen) {
    const Field& field = fields()[index];
    if (field.per_channel) {
      for (const std::string& channel : field.of_motion ? moving_channels(input) : input.channels) {
        for (std::size_t i = 0; i < field.columns; ++i)
          columns.push_back({channel + column_suffix(field, i), field.kind});
      }
    } else if (field.per_rotation) {
      for (std::size_t rotation = 0; rotation < input.rotations.size(); ++rotation) {
        const std::string number = input.rotations.size() == 1 ? "" : std::to_string(rotation + 1);
        for (std::size_t i = 0; i < field.columns; ++i) {
          const std::string axis = field.columns == 1 ? "" : std::string("_") + "xyz"[i];
          columns.push_back({std::string(field.name) + number + axis, field.kind});
        }
      }
    } else {
      const bool is_time_of_sample = field.kind == CellKind::time && !field.of_piece;
      columns.push_back({is_time_of_sample ? input.time : std::string(field.name), field.kind});
    }
  }
  return columns;
}

}  // namespace tcb
