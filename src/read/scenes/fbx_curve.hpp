// FBX curves: the keys of an animation curve of FBX as keys of a channel.
//
// A key decides the span after it: constant, linear, or a cubic. The tangents of a cubic are
//   TCB        by the preset fbx
//   user       the slopes of the file, per second
//   automatic  by the neighbours, with the flags time-independent, clamp and clamp-progressive, and with a bias
// Where all keys of a channel are TCB, the rules of the preset apply; otherwise the file decides all its velocities.
// Tangents with weights are no cubics in time, and are refused.
// Source: the enumerations of the FBX SDK, and the values of curves as MotionBuilder and Maya evaluate them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "read/scenes/fbx_nodes.hpp"
#include "read/scenes/tracks.hpp"

namespace tcb {

enum class FbxSpan { constant, constant_next, linear, tcb, user, automatic };

struct FbxKey {
  WrittenNumber time, value;  ///< time in seconds
  FbxSpan span = FbxSpan::linear;
  WrittenNumber tension = {}, continuity = {}, bias = {};
  WrittenNumber right = {}, next_left = {};  ///< slopes of user tangents, biases of automatic ones, in percent
  bool is_time_independent = false, clamps = false, clamps_progressively = false;
  std::uint64_t line = 0;
};

/// What the head of a file decides.
struct FbxHead {
  std::int64_t version = 0;  ///< 7400 for 7.4
  std::int64_t ticks_per_second = 46'186'158'000;
};

struct FbxCurve {
  std::vector<FbxKey> keys = {};
  std::string_view before = {}, after = {};  ///< extrapolations, or nothing where the file has none
};

/// An AnimationCurve (version 7), and a Channel (version 6), which may be without keys. Throws: Error (data).
FbxCurve read_curve(const FbxNode& curve, const FbxHead& head);
FbxCurve read_old_curve(const FbxNode& channel, const FbxHead& head);

/// Throws: Error (data) where the times do not increase, and for tangents that the file does not decide.
TrackChannel channel_of(std::string_view name, const FbxCurve& curve);

}  // namespace tcb
