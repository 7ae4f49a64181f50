// Looking a curve up anywhere: it is kept whole, and rows may come in any order, also outside it.
#include "lookup.hpp"

#include <algorithm>
#include <utility>

namespace tcb {

using sampler::Piece;
using spline::Time;
using spline::Twice;

WholeCurve::WholeCurve(const Source<Stretch>& stretches, std::vector<std::size_t> metric) : metric_(std::move(metric)) {
  Twice s;
  while (std::optional<Stretch> stretch = stretches()) {
    if (stretch->segments.size() == 0) continue;
    s_.push_back(s);
    for (const double length : stretch->lengths) s = s + Twice(length);
    stretches_.push_back(std::move(*stretch));
  }
  const auto first = stretches_.front().segments[0];
  const auto last = stretches_.back().segments[stretches_.back().segments.size() - 1];
  for (std::size_t i = 0; i < first.size(); ++i) cycle_.push_back(last[i].p1 - first[i].p0);
}

Piece WholeCurve::piece_at(const Time<double>& t) const {
  const auto after = std::ranges::upper_bound(stretches_, t, {},
                                              [](const Stretch& stretch) { return stretch.segments.times.front(); });
  const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - stretches_.begin() - 1, 0));
  const Stretch& stretch = stretches_[index];
  const auto& times = stretch.segments.times;
  const auto next = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  const auto i = static_cast<std::size_t>(next - times.begin() - 1);
  Twice s = s_[index];
  for (std::size_t k = 0; k < i && !stretch.lengths.empty(); ++k) s = s + Twice(stretch.lengths[k]);
  const Twice s_end = stretch.lengths.empty() ? s : s + Twice(stretch.lengths[i]);
  const bool last = index + 1 == stretches_.size() && i + 1 == stretch.segments.size();
  return {times[i], times[i + 1], s, s_end, stretch.segments[i], metric_, last, stretch.segments.warp(i), cycle_};
}

Source<Batch> look_up(std::shared_ptr<const WholeCurve> curve, std::shared_ptr<const sampler::Anywhere> rows) {
  return [curve = std::move(curve), rows = std::move(rows), j = std::uint64_t{0}]() mutable -> std::optional<Batch> {
    if (j == rows->size()) return std::nullopt;
    Batch batch{curve, {}, j == 0};
    const std::uint64_t end = j + std::min(Batch::most_rows, rows->size() - j);
    for (; j < end; ++j) batch.parts.push_back({curve->piece_at(rows->on_curve(j).t), {j, j + 1}});
    return batch;
  };
}

}  // namespace tcb
