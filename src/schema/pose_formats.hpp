// Pose formats: the columns of lines of poses, as recordings of robots and benchmarks of odometry have them.
//
// Source: the evaluation tools of the TUM RGB-D benchmark, the EuRoC MAV dataset, and the KITTI odometry benchmark.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "numbers/time_notation.hpp"
#include "schema/rotation_options.hpp"
#include "tcb/spline/rotation_form.hpp"

namespace tcb {

/// The columns of a format of poses: a time unless it has none, a position x, y, z, a rotation, and other channels by
/// their names.
struct PoseFormat {
  std::span<const std::string_view> columns;  ///< names, in order
  std::span<const std::string_view> others;   ///< names of columns that may follow; of lines, none is read
  spline::RotationForm form;                  ///< of the rotation
  std::optional<TimeUnit> unit;               ///< of the times; nothing: there are none
  std::string_view head = {};                 ///< the line above the rows of an output; empty: none
  bool has_others = false;                    ///< channels besides the position and the rotation
};

extern const PoseFormat tum_poses, euroc_poses, kitti_poses, nerfstudio_poses;

/// The names of the columns of its rotation, in the order of the rotation's numbers.
std::vector<std::string_view> rotation_columns_of(const PoseFormat& format);

/// The rotation of a format of poses, as keys give it.
GivenRotation rotation_of(const PoseFormat& format);

}  // namespace tcb
