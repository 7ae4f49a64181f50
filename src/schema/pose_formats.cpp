// Pose formats: the columns of lines of poses, as recordings of robots and benchmarks of odometry have them.
#include "schema/pose_formats.hpp"

#include <array>

namespace tcb {
namespace {

constexpr std::array<std::string_view, 8> tum_columns{"t", "x", "y", "z", "qx", "qy", "qz", "qw"};
constexpr std::array<std::string_view, 8> euroc_columns{"t", "x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr std::array<std::string_view, 9> euroc_others{"velocity_x",  "velocity_y",  "velocity_z",
                                                       "gyro_bias_x", "gyro_bias_y", "gyro_bias_z",
                                                       "acc_bias_x",  "acc_bias_y",  "acc_bias_z"};
constexpr std::array<std::string_view, 12> kitti_columns{"r11", "r12", "r13", "x",   "r21", "r22",
                                                         "r23", "y",   "r31", "r32", "r33", "z"};

constexpr std::array<std::string_view, 13> camera_columns{"r11", "r12", "r13", "x",   "r21", "r22", "r23",
                                                          "y",   "r31", "r32", "r33", "z",   "fov"};
constexpr std::array<std::string_view, 1> camera_others{"render_time"};

}  // namespace

constexpr PoseFormat tum_poses{tum_columns, {}, spline::RotationForm::quaternion, TimeUnit::s};
constexpr PoseFormat euroc_poses{
    euroc_columns, euroc_others, spline::RotationForm::quaternion, TimeUnit::ns,
    "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"};
constexpr PoseFormat kitti_poses{kitti_columns, {}, spline::RotationForm::matrix, std::nullopt};
constexpr PoseFormat nerfstudio_poses{
    camera_columns, camera_others, spline::RotationForm::matrix, std::nullopt, "", true};

std::vector<std::string_view> rotation_columns_of(const PoseFormat& format) {
  if (format.form == spline::RotationForm::quaternion) return {"qx", "qy", "qz", "qw"};
  return {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"};
}

GivenRotation rotation_of(const PoseFormat& format) {
  GivenRotation rotation;
  rotation.notation.form = format.form;
  for (const std::string_view name : rotation_columns_of(format)) rotation.columns.emplace_back(name);
  return rotation;
}

}  // namespace tcb
