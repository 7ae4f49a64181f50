// Turning pieces: rotations by angles that have keys of their own, as keyframes whose cubics are near enough to them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "error.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "write/output_format.hpp"

namespace tcb {

inline constexpr std::size_t numbers_of_piece = 4;  ///< of a channel: position and velocity at both ends

using Rotation = spline::Quaternion<double>;

/// Of the unit of the angles.
inline double radians_of(const EulerTrack& euler) { return euler.degrees ? 3.14159265358979323846 / 180 : 1; }

struct TurningRotation {
  Rotation q, velocity;
};

/// The rotation by turns around axes, at angles and their velocities in the order of the turns.
inline TurningRotation turned(const EulerTrack& euler, const std::array<double, 3>& angles,
                              const std::array<double, 3>& velocities) {
  const auto& [bx, by, bz, bw] = euler.before;
  const auto& [ax, ay, az, aw] = euler.after;
  TurningRotation value{{bx, by, bz, bw}, {}};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    constexpr double largest = 1e6;  // of angles that sines are computed of
    if (!(std::abs(angles[i]) <= largest)) {
      throw data_error("an angle of a rotation is {}; expected at most 1e6 in size; take full turns off the angles",
                       angles[i]);
    }
    const auto [sine, cosine] = spline::sine_cosine_of_half(angles[i], euler.degrees);
    const double half_speed = velocities[i] * radians_of(euler) / 2;
    std::array<double, 3> turn{}, change{};
    turn[euler.turns[i].axis] = sine;
    change[euler.turns[i].axis] = cosine * half_speed;
    const Rotation q{turn[0], turn[1], turn[2], cosine}, dq{change[0], change[1], change[2], -sine * half_speed};
    value = {value.q * q, value.velocity * q + value.q * dq};
  }
  const Rotation after{ax, ay, az, aw};
  return {value.q * after, value.velocity * after};
}

/// A part of a piece of angles that are cubics in time.
class TurningPiece {
 public:
  /// `row`: a start, a duration, and positions and velocities of channels.
  TurningPiece(const EulerTrack& euler, std::span<const double> row) : euler_(&euler), row_(row) {}

  double start() const { return row_[0] + first_ * row_[1]; }
  double end() const { return row_[0] + last_ * row_[1]; }

  /// At a place from 0 to 1, with the velocity per part.
  TurningRotation at(double place) const {
    std::array<double, 3> angles{}, velocities{};
    const double u = first_ + place * (last_ - first_), v = 1 - u;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const auto [p, d, q, e] = numbers(i);
      angles[i] = v * v * ((1 + 2 * u) * p + u * d) + u * u * ((1 + 2 * v) * q - v * e);
      velocities[i] = (last_ - first_) * (6 * u * v * (q - p) + v * (v - 2 * u) * d + u * (u - 2 * v) * e);
    }
    return turned(*euler_, angles, velocities);
  }

  /// Appends parts on which the cubic between both ends, made a rotation, is near enough.
  void divide(std::vector<TurningPiece>& parts) const {
    constexpr double shortest = 0x1p-24;  // of the piece
    const auto is_in_one_float = static_cast<float>(start()) == static_cast<float>(end());
    if (is_near() || is_in_one_float) return parts.push_back(*this);
    if (last_ - first_ < shortest) {
      throw data_error(
          "the rotation turns too often within the segment at {} for an animation; expected slower angles; give "
          "samples, as by --fps",
          row_[0]);
    }
    TurningPiece part = *this;
    part.last_ = (first_ + last_) / 2;
    part.divide(parts);
    part.first_ = part.last_;
    part.last_ = last_;
    part.divide(parts);
  }

 private:
  /// The positions and velocities of an angle at both ends of the piece.
  std::array<double, 4> numbers(std::size_t turn) const {
    const std::size_t at = 2 + numbers_of_piece * euler_->turns[turn].channel;
    return {row_[at], row_[at + 1] * row_[1], row_[at + 2], row_[at + 3] * row_[1]};
  }

  bool is_near() const {
    // Turns are slow, so that the derivatives vary little, and the error is largest near the middle.
    double turns = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [p, d, q, e] = numbers(i);  // the control points of the velocity are d, 3 (q - p) - d - e, e
      turns += std::max({std::abs(d), std::abs(3 * (q - p) - d - e), std::abs(e)}) * (last_ - first_);
    }
    constexpr double eighth = 0.79, limit = 0.01 / 180 * 3.14159265358979323846 / 4;  // half of half the angle
    if (!(turns * radians_of(*euler_) <= eighth)) return false;
    const auto [q0, v0] = at(0);
    const auto [q1, v1] = at(1);
    return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&, &q0 = q0, &v0 = v0, &q1 = q1, &v1 = v1](double u) {
      const double v = 1 - u;
      const Rotation cubic =
          q0 * (v * v * (1 + 2 * u)) + v0 * (v * v * u) + q1 * (u * u * (1 + 2 * v)) + v1 * (-u * u * v);
      const Rotation off = spline::normalized(cubic) + -at(u).q;
      return dot(off, off) <= limit * limit;
    });
  }

  const EulerTrack* euler_;
  std::span<const double> row_;
  double first_ = 0, last_ = 1;  ///< of the piece
};

}  // namespace tcb
