// Gap rows: how many rows of a curve lie between keys that are far apart.
#include "run/gap_rows.hpp"

#include <algorithm>

#include "sample/build.hpp"
#include "sample/rows.hpp"

namespace tcb {
namespace {

constexpr std::size_t enough_steps = 100;
constexpr double far = 30;  ///< in median steps

/// The least number of two digits that is not below a positive one.
Rational rounded_up(const Rational& number) {
  Rational unit = 1;
  while (unit * 100 <= number) unit *= 10;
  while (unit * 10 > number) unit /= 10;
  return -floor(-number / unit) * unit;
}

}  // namespace

void GapRows::add_step(const Time& from, const Time& to) {
  if (limit_) return;
  steps_.push_back((to - from).hi);
  if (steps_.size() == enough_steps) set_limit();
}

void GapRows::add_steps(const SegmentBlock& block) {
  const std::vector<Time>& times = block.segments.times;
  for (std::size_t i = 0; i + 1 < times.size() && !limit_; ++i) add_step(times[i], times[i + 1]);
}

void GapRows::add_rows(const SampleBlock& block) {
  for (const auto& [segment, first, last] : block.parts) {
    if (limit_ && !((segment.end - segment.start).hi > *limit_)) continue;
    const Segment next{segment.number, segment.start, segment.end, rows_between_keys(segment, first, last)};
    if (next.rows == 0) continue;
    if (limit_) {
      take(next);
    } else if (!undecided_.empty() && undecided_.back().number == next.number) {
      undecided_.back().rows += next.rows;
    } else {
      undecided_.push_back(next);
    }
  }
}

/// All but those at the keys themselves.
std::uint64_t GapRows::rows_between_keys(const CurveSegment& segment, std::uint64_t first, std::uint64_t last) {
  const auto is_at_key = [&](std::uint64_t row) {
    locator_->locate(segment, row, row + 1, located_);
    const auto& at = located_.samples.front().at;
    return at.u == 0 || at.w == 0;
  };
  const std::uint64_t rows = last - first;
  return rows - (is_at_key(first) ? 1 : 0) - (rows > 1 && is_at_key(last - 1) ? 1 : 0);
}

void GapRows::set_limit() {
  if (steps_.empty()) return;
  std::ranges::sort(steps_);
  const std::size_t half = steps_.size() / 2;
  const double median =
      steps_.size() % 2 == 1 ? steps_[half] : steps_[half - 1] + (steps_[half] - steps_[half - 1]) / 2;
  limit_ = far * median * (1 + 0x1p-40);  // so that rounding makes no gap
  for (const Segment& segment : undecided_) {
    if (segment.duration() > *limit_) take(segment);
  }
  undecided_.clear();
}

void GapRows::take(const Segment& segment) {
  const bool goes_on = last_ && last_->number == segment.number;
  const double duration = segment.duration();
  if (!goes_on) ++found_.gaps;
  found_.rows += segment.rows;
  if (!last_ || duration > (found_.to - found_.from).hi) {
    found_.from = segment.from;
    found_.to = segment.to;
  }
  least_ = last_ ? std::min(least_, duration) : duration;
  last_ = segment;
}

std::optional<RowsInGaps> GapRows::found() {
  if (!limit_) set_limit();
  if (found_.rows == 0) return std::nullopt;
  const Rational limit = exact_time(Time(*limit_)), round = rounded_up(limit);
  found_.max_gap = nearest_double(round) < least_ ? round : limit;
  return found_;
}

}  // namespace tcb
