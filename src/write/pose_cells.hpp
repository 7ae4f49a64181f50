// Pose cells: which cells of a row go into the columns of a format of poses.
#pragma once

#include <cstddef>
#include <vector>

#include "schema/pose_formats.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// For each column of the format, the number of the cell in rows of a time, if the format has one, and a position.
/// Requires: rotations are shown in the form of the format. Throws: Error (data) unless the rows have a position of
/// three channels, one rotation, and the other channels of the format.
std::vector<std::size_t> pose_cells(const PoseFormat& format, const Schema& schema);

}  // namespace tcb
