// Row estimate: about how many rows a curve will have, by the part of it that is known.
#include "run/row_estimate.hpp"

#include <algorithm>

#include "numbers/decimal_time.hpp"
#include "sample/build.hpp"

namespace tcb {

RowEstimate::RowEstimate(const SamplingRequest& request, const Extent& extent)
    : request_(request), first_(extent.first) {
  if (!by_segment(request.mode)) spacing_ = spacing(request, extent);
}

void RowEstimate::add(const KeyBlock& block) {
  if (!block.keys.times.empty()) end_ = block.keys.times.back();
  segments_ += block.size();
}

void RowEstimate::add(const SegmentBlock& block) {
  if (!block.segments.times.empty()) made_ = block.segments.times.back();
  for (const auto& length : block.lengths) length_ += length.value;
}

void RowEstimate::add_all(const Extent& extent, std::uint64_t segments) {
  end_ = made_ = *extent.last;
  length_ = extent.length.value_or(0);
  segments_ = segments;
}

double RowEstimate::rows() const {
  const auto segments = static_cast<double>(segments_);
  const double keys = request_.keys ? segments + 1 : 0;
  if (!spacing_) return segments * static_cast<double>(request_.count) + keys + 1;
  Time end = end_;
  if (by_length(request_.mode)) end = Time(length_ * ((end_ - first_) / (made_ - first_)).hi);
  if (spacing_->end) end = std::min(end, nearest_time(*spacing_->end));
  const double rows = spacing_->grid.is_single() ? 1 : std::max(1.0, spacing_->grid.rough_rows(end));
  return std::min(rows, static_cast<double>(spacing_->rows)) + keys;
}

}  // namespace tcb
