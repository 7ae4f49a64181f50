// Camera path: the texts around the cameras of nerfstudio, and the rate of its frames.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "numbers/rational.hpp"
#include "sample/table.hpp"
#include "write/layout.hpp"

namespace tcb {

/// How rows are played as frames.
struct PlayedFrames {
  Rational rate;                         ///< in frames per second
  std::optional<Rational> seconds = {};  ///< of all; nothing: those of the rows
};

/// One row after the other is a camera, {"camera_to_world": 16 numbers, "fov", "aspect"}. The cameras are played in
/// seconds n h, with n their number and h the mean duration between them, as nerfstudio plays n frames at times i h.
/// Source: the viewer of nerfstudio, which reads and writes such files.
class CameraPath {
 public:
  /// `members`: those of a camera path that was read, as in Schema; empty: one without keyframes.
  explicit CameraPath(const std::string& members);

  /// Sets the head and the ends of rows.
  void complete(Layout& layout) const;

  /// Takes note of rows, in any order and from any thread. Requires: the first cell of each is its time.
  void add(const Table& rows, std::size_t cells_per_row);

  /// Sets the frames that were asked for, instead of the mean duration between rows.
  void set_frames(const PlayedFrames& frames) { frames_ = frames; }

  /// The text after the end of the list of rows. `unit`: that of times, in seconds.
  std::string tail(const Rational& unit) const;

 private:
  std::string members_;
  double aspect_ = 0;
  std::mutex mutex_;
  std::uint64_t rows_ = 0;
  Cell first_{}, last_{};  ///< times
  std::optional<PlayedFrames> frames_;
};

}  // namespace tcb
