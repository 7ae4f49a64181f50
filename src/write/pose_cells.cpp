// Pose cells: which cells of a row go into the columns of a format of poses.
#include "write/pose_cells.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "sample/cells.hpp"
#include "write/errors.hpp"

namespace tcb {

namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// The names of channels besides the position that a format has: those that it needs, and those that may follow.
std::vector<std::string_view> other_channels(const PoseFormat& format) {
  std::vector<std::string_view> channels;
  if (format_of(format.format).family != FormatFamily::cameras) return channels;
  const std::vector<std::string_view> numbers = rotation_columns_of(format);
  for (const std::string_view column : format.columns) {
    if (std::ranges::count(axes, column) + std::ranges::count(numbers, column) == 0) channels.push_back(column);
  }
  channels.insert(channels.end(), format.others.begin(), format.others.end());
  return channels;
}

/// The names of the cells of a row in the format.
std::vector<std::string_view> names_of_cells(const PoseFormat& format, const Schema& schema) {
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  const std::vector<std::string_view> numbers = rotation_columns_of(format), others = other_channels(format);
  std::vector<std::string_view> names;
  if (format.has_time_in_rows()) names.emplace_back("t");
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
    throw not_a_pose(positions, rotations.size(), format_of(format.format).name);
  }
  return names;
}

}  // namespace

std::vector<std::size_t> pose_cells(const PoseFormat& format, const Schema& schema) {
  const std::vector<std::string_view> names = names_of_cells(format, schema);
  std::vector<std::size_t> order;
  const auto find = [&](std::string_view column) {
    const auto found = std::ranges::find(names, column);
    if (found != names.end()) order.push_back(static_cast<std::size_t>(found - names.begin()));
    return found != names.end();
  };
  for (const std::string_view column : format.columns) {
    if (!find(column)) throw channel_of_format_missing(column, format_of(format.format).name);
  }
  if (!other_channels(format).empty()) std::ranges::for_each(format.others, find);
  return order;
}

}  // namespace tcb
