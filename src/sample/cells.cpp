// Cells: which cells of a row show the position.
#include "sample/cells.hpp"

#include <algorithm>

namespace tcb {
namespace {

/// The cell of a channel that has one.
PositionCell cell_of_channel(std::size_t channel, std::span<const RotationColumns> rotations) {
  PositionCell cell{channel};
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const auto own = std::ranges::find(rotations[i].channels, channel);
    if (own == rotations[i].channels.end()) continue;
    cell.rotation = i;
    cell.number = static_cast<std::size_t>(own - rotations[i].channels.begin());
  }
  return cell;
}

}  // namespace

std::vector<PositionCell> position_cells(std::size_t channels, std::span<const RotationColumns> rotations) {
  std::size_t count = channels;
  for (const RotationColumns& rotation : rotations) {
    count += rotation.shown.numbers() - rotation.channels.size();
  }
  std::vector<PositionCell> cells(count);
  std::vector<bool> taken(count);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    for (std::size_t k = 0; !rotations[i].shown.is_quaternion() && k < rotations[i].shown.numbers(); ++k) {
      cells[rotations[i].places[k]] = {PositionCell::none, i, k};
      taken[rotations[i].places[k]] = true;
    }
  }
  auto next = taken.begin();
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const PositionCell cell = cell_of_channel(channel, rotations);
    if (cell.rotation != PositionCell::none && !rotations[cell.rotation].shown.is_quaternion()) continue;
    next = std::find(next, taken.end(), false);
    cells[static_cast<std::size_t>(next - taken.begin())] = cell;
    ++next;
  }
  return cells;
}

}  // namespace tcb
