// What samples are asked for, as exact numbers; and the table of the ways to ask.
#pragma once

#include <cstdint>
#include <optional>

#include "sampler/rational.hpp"

namespace tcb::sampler {

enum class Mode { step, count, segments, arc_step, arc_count };

struct Request {
  Mode mode = Mode::step;
  Rational step;                     ///< time or arc length between rows: step, arc_step
  std::uint64_t count = 0;           ///< rows, or for segments the intervals between them
  std::optional<Rational> from, to;  ///< where to begin and end, in time, or in arc length for the arc modes
};

/// Samples are placed by arc length, so every segment has to be measured.
constexpr bool by_length(Mode mode) { return mode == Mode::arc_step || mode == Mode::arc_count; }

/// The curve's last key, or its length, must be known before the first row.
constexpr bool needs_end(Mode mode) { return mode != Mode::step && mode != Mode::arc_step; }

}  // namespace tcb::sampler
