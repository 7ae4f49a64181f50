// Pose cells: which cells of a row go into the columns of a format of poses.
#include "write/pose_cells.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "sample/cells.hpp"
#include "write/errors.hpp"

namespace tcb {

std::vector<std::size_t> pose_cells(const PoseFormat& format, const Schema& schema) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  const auto cells = position_cells(schema.channels.size(), rotations);
  std::vector<std::string_view> names;  // of the cells of a row
  if (format.unit) names.emplace_back("t");
  const std::vector<std::string_view> numbers = rotation_columns_of(format);
  std::size_t positions = 0;
  for (const PositionCell& cell : cells) {
    if (cell.rotation != PositionCell::none) {
      names.push_back(numbers[cell.number]);
    } else {
      names.push_back(positions < axes.size() ? axes[positions] : "");
      ++positions;
    }
  }
  if (positions != axes.size() || rotations.size() != 1) {
    throw not_a_pose(positions, rotations.size(), format_of(format.format).name);
  }
  std::vector<std::size_t> order;
  for (const std::string_view column : format.columns) {
    order.push_back(static_cast<std::size_t>(std::ranges::find(names, column) - names.begin()));
  }
  return order;
}

}  // namespace tcb
