// Fields: rows of doubles, by columns where that saves time, and their columns.
#include "sample/fields.hpp"

#include <functional>
#include <string>

#include "schema/schema.hpp"

namespace tcb {
namespace {

std::vector<PositionCell> cells_of_channels(std::size_t channels, std::span<const RotationColumns> rotations) {
  std::vector<PositionCell> cells;
  for (std::size_t channel = 0; channel < channels; ++channel) cells.push_back({channel});
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    for (std::size_t k = 0; k < rotations[i].channels.size(); ++k) {
      PositionCell& cell = cells[rotations[i].channels[k]];
      cell.rotation = i;
      cell.number = k;
    }
  }
  return cells;
}

}  // namespace

std::vector<PositionCell> position_cells(std::size_t channels, std::span<const RotationColumns> rotations) {
  std::size_t count = channels;
  for (const RotationColumns& rotation : rotations) {
    count += rotation.shown.numbers() - rotation.channels.size();
  }
  std::vector<PositionCell> cells(count);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    for (std::size_t k = 0; !rotations[i].shown.is_quaternion() && k < rotations[i].shown.numbers(); ++k) {
      cells[rotations[i].places[k]] = {PositionCell::none, i, k};
    }
  }
  auto next = cells.begin();
  for (const PositionCell& cell : cells_of_channels(channels, rotations)) {
    if (cell.rotation != PositionCell::none && !rotations[cell.rotation].shown.is_quaternion()) continue;
    next = std::ranges::find(next, cells.end(), PositionCell::none, &PositionCell::rotation);
    *next++ = cell;
  }
  return cells;
}

void write_times(Cell* first, std::size_t width, const CurveSegment&, std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) first[i * width] = samples[i].t;
}

namespace {

/// Writes the column of a channel of all samples.
void write_channel(Cell* cell, std::size_t width, const CurveSegment& segment, std::size_t channel,
                   std::span<const Sample> samples) {
  const spline::Cubic<double>& x = segment.cubics[channel];
  const AngleColumn* const angle = segment.angle(channel);
  const auto put = [&](double value) {
    *cell = angle == nullptr ? value : spline::wrapped(value, angle->degrees, angle->is_signed);
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

/// Writes a rotation of all samples; `cells` are those of its numbers in a row.
void write_rotation(Cell* row, std::size_t width, const spline::RotationSegment<double>& rotation,
                    const spline::RotationNotation& shown, std::span<const std::size_t> cells,
                    std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    const auto numbers = spline::numbers_of(rotation.at(sample.at), shown);
    for (std::size_t i = 0; i < cells.size(); ++i) row[cells[i]] = numbers[i];
    row += width;
  }
}

}  // namespace

void write_positions(Cell* first, std::size_t width, const CurveSegment& segment, std::span<const Sample> samples) {
  const std::span<const RotationColumns> rotations = segment.rotation_columns;
  if (rotations.empty()) {
    for (std::size_t i = 0; i < segment.cubics.size(); ++i) write_channel(first + i, width, segment, i, samples);
    return;
  }
  std::vector<std::array<std::size_t, 9>> cells(rotations.size());  // of each rotation's numbers
  std::size_t next = 0;
  for (const PositionCell& cell : position_cells(segment.cubics.size(), rotations)) {
    if (cell.rotation == PositionCell::none) {
      write_channel(first + next, width, segment, cell.channel, samples);
    } else {
      cells[cell.rotation][cell.number] = next;
    }
    ++next;
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& shown = rotations[i].shown;
    write_rotation(first, width, segment.rotations[i], shown, std::span(cells[i]).first(shown.numbers()), samples);
  }
}

namespace {

/// A member of all fields, in their order.
template <class T>
constexpr auto of_all_fields(T member) {
  std::array<std::remove_cvref_t<std::invoke_result_t<T, const FieldOf<double>&>>, field_table<double>.size()> all{};
  std::ranges::transform(field_table<double>, all.begin(), member);
  return all;
}

}  // namespace

std::span<const Field> fields() {
  static constexpr std::array all = of_all_fields([](const Field& field) { return field; });
  return all;
}

std::span<const Field> named_fields() { return fields().first(field_of("length") + 1); }

std::size_t field_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(fields(), name, &Field::name) - fields().begin());
}

std::size_t cells_in_row(std::span<const std::size_t> chosen, const RowShape& shape) {
  std::size_t cells = 0;
  for (const std::size_t index : chosen) {
    const Field& field = fields()[index];
    std::size_t channels = shape.channels;
    for (const RotationColumns& rotation : shape.rotations) {
      if (field.of_motion) channels -= rotation.channels.size();
      if (field.shows_rotations) channels += rotation.shown.numbers() - rotation.channels.size();
    }
    cells += field.columns * (field.per_channel ? channels : field.per_rotation ? shape.rotations.size() : 1);
  }
  return cells;
}

void write_rows(Cell* rows, std::size_t width, std::span<const std::size_t> chosen, const CurveSegment& segment,
                const Located& located, Point<double>& point) {
  static constexpr std::array write_column = of_all_fields(&FieldOf<double>::write_column);
  std::vector<std::pair<decltype(FieldOf<double>::write), Cell*>> by_row;  // and the cell in the first row
  Cell* first = rows;
  for (const std::size_t index : chosen) {
    if (write_column[index] != nullptr && located.outside.empty()) {
      write_column[index](first, width, segment, located.samples);
    } else {
      by_row.emplace_back(field_writers<double>[index], first);
    }
    first += cells_in_row({&index, 1}, shape_of(segment));
  }
  if (by_row.empty()) return;
  point.set(segment);
  for (std::size_t i = 0; i < located.samples.size(); ++i) {
    point.set(located.samples[i], located.outside.empty() ? nullptr : &located.outside[i]);
    point.set_motion(located.motions.empty() ? nullptr : &located.motions[i]);
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

std::vector<std::string> position_names(const Schema& schema) {
  std::vector<std::string> names;
  for (const PositionCell& cell : position_cells(schema.channels.size(), rotation_columns(schema))) {
    names.push_back(cell.channel != PositionCell::none ? schema.channels[cell.channel]
                                                       : schema.rotations[cell.rotation].names[cell.number]);
  }
  return names;
}

}  // namespace

std::vector<CellOfChannel> cells_of_channels(std::span<const std::size_t> chosen, const RowShape& shape) {
  const std::vector<bool> are_in_rotations = spline::in_rotations(shape.rotations, shape.channels);
  std::vector<CellOfChannel> cells;
  for (const std::size_t index : chosen) {
    const Field& field = fields()[index];
    const std::size_t end = cells.size() + cells_in_row({&index, 1}, shape);
    if (field.shows_rotations) {
      for (const PositionCell& cell : position_cells(shape.channels, shape.rotations)) {
        cells.push_back({cell.channel, true});
      }
    }
    for (std::size_t i = 0; i < shape.channels && field.per_channel && !field.shows_rotations; ++i) {
      if (!field.of_motion || !are_in_rotations[i]) cells.insert(cells.end(), field.columns, {i});
    }
    cells.resize(end);
  }
  return cells;
}

std::vector<OutputColumn> output_columns(std::span<const std::size_t> chosen, const Schema& schema) {
  std::vector<OutputColumn> columns;
  for (const std::size_t index : chosen) {
    const Field& field = fields()[index];
    if (field.shows_rotations) {
      for (std::string& name : position_names(schema)) columns.push_back({std::move(name), field.kind});
    } else if (field.per_channel) {
      for (const std::string& channel : field.of_motion ? moving_channels(schema) : schema.channels) {
        for (std::size_t i = 0; i < field.columns; ++i)
          columns.push_back({channel + column_suffix(field, i), field.kind});
      }
    } else if (field.per_rotation) {
      for (std::size_t rotation = 0; rotation < schema.rotations.size(); ++rotation) {
        std::string name(field.name);
        if (schema.rotations.size() > 1) name += std::to_string(rotation + 1);
        if (field.columns == 1) columns.push_back({name, field.kind});
        for (std::size_t i = 0; field.columns > 1 && i < field.columns; ++i) {
          columns.push_back({(name + '_').append(1, "xyz"[i]), field.kind});
        }
      }
    } else {
      const bool is_time_of_sample = field.kind == CellKind::time && !field.of_piece;
      columns.push_back({is_time_of_sample ? schema.time.name : std::string(field.name), field.kind});
    }
  }
  return columns;
}

}  // namespace tcb
