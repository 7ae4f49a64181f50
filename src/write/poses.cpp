// Poses: the cells of rows that the columns of a format of poses have.
#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "schema/pose_formats.hpp"
#include "schema/schema.hpp"
#include "text/utf8.hpp"
#include "write/output_format.hpp"

namespace tcb {
namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// The names of channels besides the position that a format has: those that it needs, and those that may follow.
std::vector<std::string_view> other_channels(const PoseFormat& format) {
  std::vector<std::string_view> channels;
  if (!format.has_others) return channels;
  const std::vector<std::string_view> numbers = rotation_columns_of(format);
  for (const std::string_view column : format.columns) {
    if (std::ranges::count(axes, column) + std::ranges::count(numbers, column) == 0) channels.push_back(column);
  }
  channels.insert(channels.end(), format.others.begin(), format.others.end());
  return channels;
}

std::vector<std::string_view> names_of_cells(const Format& of, const Schema& schema) {
  const PoseFormat& format = *of.poses;
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  const std::vector<std::string_view> numbers = rotation_columns_of(format), others = other_channels(format);
  std::vector<std::string_view> names;
  if (of.fields.starts_with("time")) names.emplace_back("t");
  std::size_t positions = 0;
  for (const PositionCell& cell : position_cells(schema.channels.size(), rotations)) {
    if (cell.rotation != PositionCell::none) {
      names.push_back(numbers[cell.number]);
    } else if (std::ranges::count(others, schema.channels[cell.channel]) > 0) {
      names.emplace_back(schema.channels[cell.channel]);
    } else {
      names.push_back(positions < axes.size() ? axes[positions] : "");
      ++positions;
    }
  }
  if (positions != axes.size() || rotations.size() != 1) {
    throw data_error(
        "each row of {} is a pose, but the curve has channels of position: {}, rotations: {}; expected 3 channels and "
        "1 rotation; choose them with --columns and --rotation, or give another format, such as csv, to "
        "--output-format",
        of.name, positions, rotations.size());
  }
  return names;
}

}  // namespace

std::vector<std::size_t> pose_cells(const Format& of, const Schema& schema) {
  const PoseFormat& format = *of.poses;
  const std::vector<std::string_view> names = names_of_cells(of, schema);
  std::vector<std::size_t> order;
  const auto find = [&](std::string_view column) {
    const auto found = std::ranges::find(names, column);
    if (found != names.end()) order.push_back(static_cast<std::size_t>(found - names.begin()));
    return found != names.end();
  };
  for (const std::string_view column : format.columns) {
    if (!find(column))
      throw data_error(
          "no channel is {}, which every row of {} has; expected a column of that name; add one, or give another "
          "format to --output-format",
          in_quotes(column), of.name);
  }
  if (!other_channels(format).empty()) std::ranges::for_each(format.others, find);
  return order;
}

extern const OutputFormat pose_output{.layout = delimited_layout, .has_groups = false, .has_labels = false};

}  // namespace tcb
