// Key: its tension, continuity, bias, ease and velocities, and which channels of keys are rotations and angles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tcb::spline {

/// Tension, continuity and bias of a key. Usually in [-1, 1], but not limited to it.
template <class S>
struct Tcb {
  S tension{};
  S continuity{};
  S bias{};
  friend bool operator==(const Tcb&, const Tcb&) = default;
};

/// How slowly the curve arrives at a key and leaves it, each in [0, 1]; 0 has no effect. See ease.hpp.
template <class S>
struct Ease {
  S in{};
  S out{};
};

/// The velocities of a key in one channel, per unit of time: in the segment before it and in the one after it.
template <class S>
struct Velocity {
  S in{};
  S out{};
  friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// The side of a key from which a curve is seen; derivatives differ at a key with a corner.
enum class Side : std::uint8_t { left, right };

/// The channels that together are a rotation: those of the numbers x, y, z, w of a quaternion.
using RotationChannels = std::array<std::size_t, 4>;

/// A rotation of keys: the channels of its quaternion, and which of the turns of a key is its own.
struct KeyRotation {
  RotationChannels channels{};
  std::optional<std::size_t> turn = {};  ///< the number of its turns among those of a key; nothing: it has none

  bool has(std::size_t channel) const { return std::ranges::count(channels, channel) > 0; }
  friend bool operator==(const KeyRotation&, const KeyRotation&) = default;
};

/// Which of so many channels are numbers of these rotations.
template <class Rotations>
std::vector<bool> in_rotations(const Rotations& rotations, std::size_t channels) {
  std::vector<bool> are_in(channels);
  for (const KeyRotation& rotation : rotations) {
    for (const std::size_t channel : rotation.channels) are_in[channel] = true;
  }
  return are_in;
}

/// A channel whose numbers are angles: they turn the shorter way from key to key.
struct AngleChannel {
  std::size_t channel = 0;
  bool degrees = false;  ///< else radians
};

/// Which of so many channels are neither numbers of these rotations nor these angles.
template <class Rotations, class Angles>
std::vector<bool> plain_channels(const Rotations& rotations, const Angles& angles, std::size_t channels) {
  std::vector<bool> are_plain = in_rotations(rotations, channels);
  are_plain.flip();
  for (const AngleChannel& angle : angles) are_plain[angle.channel] = false;
  return are_plain;
}

/// Half the angle of a turn along its axis, in the frame before it.
template <class S>
using TurnVector = std::array<S, 3>;

}  // namespace tcb::spline
