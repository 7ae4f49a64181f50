// Corners: the keys at which velocities change by more than 2^-40 of their size, which is more than rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "limits/extremes.hpp"
#include "limits/form.hpp"
#include "tcb/spline/double_double.hpp"

namespace tcb::limits {

/// The root of a sum of squares, which do not overflow.
inline double root_of_squares(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  if (largest == 0 || !std::isfinite(largest)) return largest;
  const double unit = spline::power_of_two_below(largest);
  spline::DoubleDouble squares;
  for (const double x : numbers) squares = squares + spline::DoubleDouble(x / unit) * spline::DoubleDouble(x / unit);
  return sqrt(squares).hi * unit;
}

/// Finds the corners of a curve, segment after segment.
class Corners {
 public:
  /// The velocities at an end of a segment, and the sizes of their terms.
  struct End {
    std::vector<double> velocities, sizes;
  };
  struct Ends {
    End start, end;
  };

  explicit Corners(const std::vector<std::size_t>& channels) : channels_(channels) {}

  std::vector<Corner> found;

  /// Of a segment, by its pieces.
  Ends ends_of(const std::vector<Piece<double>>& pieces) const {
    return {end_of(pieces.front(), 0), end_of(pieces.back(), 1)};
  }
  /// Adds the next segment, which starts at this time.
  void add(const Ends& ends, const Time& start) {
    if (!first_) first_ = ends.start;
    if (before_) compare(*before_, ends.start, start);
    before_ = ends.end;
  }
  /// The curve is closed, and back at its start at this time.
  void close(const Time& end) {
    if (first_) compare(*before_, *first_, end);
  }

 private:
  End end_of(const Piece<double>& piece, double at) const {
    End end;
    for (const std::size_t channel : channels_) {
      const Polynomial<double> rate = rate_of(piece, channel, 1);
      end.velocities.push_back(value_at(rate, at));
      end.sizes.push_back(scale_of(rate, piece, channel, 1));
    }
    return end;
  }

  void compare(const End& in, const End& out, const Time& time) {
    Corner corner{time, 0, {}, in.velocities, out.velocities};
    std::vector<double> jumps;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const double jump = std::abs(out.velocities[i] - in.velocities[i]);
      if (!(jump > relative_rounding * std::max(out.sizes[i], in.sizes[i]))) continue;
      jumps.push_back(jump);
      corner.channels.push_back(channels_[i]);
    }
    corner.jump = root_of_squares(jumps);
    if (!jumps.empty()) found.push_back(std::move(corner));
  }

  const std::vector<std::size_t>& channels_;
  std::optional<End> first_, before_;
};

}  // namespace tcb::limits
