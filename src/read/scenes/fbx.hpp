// FBX: the text of a file as a tree of nodes, and the keys of its animation curves as keys of channels.
//
// A node is a name, a list of values, and children in braces. An array is a node with the value *COUNT and one child
// "a" with its numbers. Comments run from a semicolon to the end of the line.
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
#include <optional>
#include <string_view>
#include <vector>

#include "read/memory_use.hpp"
#include "read/scenes/track_channel.hpp"

namespace tcb {

struct FbxNode {
  std::string_view name = {};
  std::string_view text = {};  ///< of its values, with commas between them
  std::uint64_t line = 0;
  std::vector<FbxNode> children = {};

  /// The first child of this name, or nullptr.
  const FbxNode* find(std::string_view child) const;
  /// Throws: Error (data) if it has no such child.
  const FbxNode& child(std::string_view child) const;
};

/// The values of a node, one after the other.
class FbxValues {
 public:
  /// Of a node, or of its array. Throws: Error (data) where the count of the array is no number; so does next() where
  /// it is not the number of values.
  explicit FbxValues(const FbxNode& node);

  bool at_end() const { return rest_.empty(); }
  std::uint64_t line() const { return line_; }  ///< of the next value
  /// The next value, a text without its quotes. Throws: Error (data) at the end.
  std::string_view next();
  /// The next value as a number. Throws: Error (data) for another one.
  WrittenNumber next_number();
  std::int64_t next_integer();

 private:
  void skip_blanks();
  void require_count() const;

  std::string_view rest_;
  std::uint64_t line_;
  std::optional<std::uint64_t> left_ = {};  ///< how many values of an array are left
};

/// The nodes of a file, as the children of one without a name; they refer to the text. Throws: Error (data).
FbxNode parse_fbx(std::string_view text, MemoryUse& memory);

enum class FbxSpan { constant, constant_next, linear, tcb, user, automatic };

struct FbxKey : TrackKey {
  FbxSpan span = FbxSpan::linear;
  WrittenNumber right = {}, next_left = {};  ///< slopes of user tangents, biases of automatic ones, in percent
  bool is_time_independent = false, clamps = false, clamps_progressively = false;

  bool is_tcb() const { return span == FbxSpan::tcb; }
};

/// What the head of a file decides.
struct FbxHead {
  std::int64_t version = 0;  ///< 7400 for 7.4
  std::int64_t ticks_per_second = 46'186'158'000;
};

using FbxCurve = TrackCurve<FbxKey>;

/// An AnimationCurve (version 7), and a Channel (version 6), which may be without keys. Throws: Error (data).
FbxCurve read_curve(const FbxNode& curve, const FbxHead& head);
FbxCurve read_old_curve(const FbxNode& channel, const FbxHead& head);

/// Throws: Error (data) where the times do not increase, and for tangents that the file does not decide.
TrackChannel channel_of(std::string_view name, const FbxCurve& curve);

}  // namespace tcb
