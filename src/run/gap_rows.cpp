// Gap rows: how many rows of a curve lie between keys that are far apart.
#include "run/gap_rows.hpp"

#include <algorithm>

#include "sample/build.hpp"
#include "sample/rows.hpp"

namespace tcb {
namespace {

constexpr std::size_t enough_steps = 100;
constexpr double far = 30;  ///< in median steps

/// The number with the fewest digits, two at least, that is not below the first one and is below the second.
Rational short_number_between(const Rational& low, const Rational& high) {
  Rational unit = 1;
  while (unit * 100 <= low) unit *= 10;
  while (unit * 10 > low) unit /= 10;
  const auto rounded_up = [&] { return -floor(-low / unit) * unit; };
  while (rounded_up() >= high) unit /= 10;
  return rounded_up();
}

}  // namespace

void GapRows::add_steps(std::span<const Time> times) {
  for (std::size_t i = 0; i + 1 < times.size() && !limit_; ++i) {
    steps_.push_back((times[i + 1] - times[i]).hi);
    if (steps_.size() == enough_steps) end_steps();
  }
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

/// All but those at the keys themselves, or outside the curve.
std::uint64_t GapRows::rows_between_keys(const CurveSegment& segment, std::uint64_t first, std::uint64_t last) {
  const auto rows_at_keys = [&](std::uint64_t from, std::uint64_t to) -> std::uint64_t {
    locator_->locate(segment, from, to, located_);
    const auto is_at_key = [](const Sample& sample) { return sample.at.u == 0 || sample.at.w == 0; };
    return static_cast<std::uint64_t>(std::ranges::count_if(located_.samples, is_at_key));
  };
  const std::uint64_t rows = last - first;
  if (!in_order_) return rows - rows_at_keys(first, last);
  return rows - rows_at_keys(first, first + 1) - (rows > 1 ? rows_at_keys(last - 1, last) : 0);
}

void GapRows::end_steps() {
  if (limit_ || steps_.empty()) return;
  std::ranges::sort(steps_);
  const std::size_t half = steps_.size() / 2;
  const double median =
      steps_.size() % 2 == 1 ? steps_[half] : steps_[half - 1] + (steps_[half] - steps_[half - 1]) / 2;
  limit_ = far * median * (1 + 0x1p-40);  // so that the rounding of times makes no gap
  for (const Segment& segment : undecided_) {
    if (segment.duration() > *limit_) take(segment);
  }
  undecided_.clear();
}

void GapRows::take(const Segment& segment) {
  const bool is_first = rows_ == 0;
  rows_ += segment.rows;
  if (is_first || segment.duration() > longest_.duration()) longest_ = segment;
  least_ = is_first ? segment.duration() : std::min(least_, segment.duration());
}

std::optional<RowsInGaps> GapRows::found() {
  end_steps();
  if (rows_ == 0) return std::nullopt;
  const Rational& factor = retiming_.factor;
  const auto of_keys = [&](const Time& time) {
    return nearest_time(retiming_.origin + (exact_time(time) - retiming_.origin) / factor + zero_);
  };
  return RowsInGaps{rows_, of_keys(longest_.from), of_keys(longest_.to),
                    short_number_between(exact_time(Time(*limit_)) / factor, exact_time(Time(least_)) / factor)};
}

}  // namespace tcb
