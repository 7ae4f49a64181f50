// From pieces of the curve to rows: which samples lie on each, and the cells of their rows.
#include "curve/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "error.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

/// Walks over the pieces of segment_blocks and asks the sampler for the rows on each.
class Placer {
 public:
  Placer(Source<SegmentBlock> segment_blocks, std::shared_ptr<Sampler> sampler, std::vector<std::size_t> metric)
      : stretches_(std::move(segment_blocks)), sampler_(std::move(sampler)), metric_(std::move(metric)) {}

  std::optional<SampleBlock> next() {
    while (left_.empty() && !piece_follows()) {
      if (sampler_->done()) return std::nullopt;
      std::optional<SegmentBlock> more = stretches_();
      if (!more) return std::nullopt;
      stretch_ = std::make_shared<const SegmentBlock>(std::move(*more));
      segment_ = 0;
    }
    SampleBlock batch{stretch_, {}, first_};
    batch.parts.reserve(most_parts_);
    for (std::uint64_t room = SampleBlock::most_rows; room > 0;) {
      if (left_.empty() && !piece_follows()) break;
      if (left_.empty()) place_next();
      if (left_.empty()) continue;
      SampleBlock::Part& part = left_.front();
      const std::uint64_t size = std::min(room, part.last - part.first);
      batch.parts.push_back({part.piece, part.first, part.first + size});
      part.first += size;
      room -= size;
      if (part.first == part.last) left_.pop_front();
    }
    first_ = first_ && batch.parts.empty();
    most_parts_ = std::max(most_parts_, batch.parts.size());
    return batch;
  }

 private:
  bool piece_follows() const {
    return stretch_ != nullptr && segment_ < stretch_->segments.size() && !sampler_->done();
  }

  void place_next() {
    const auto& segments = stretch_->segments;
    const std::size_t i = segment_++;
    const spline::DoubleDouble s_start = s_;
    if (!stretch_->lengths.empty()) {
      s_ = s_ + spline::DoubleDouble(stretch_->lengths[i].value);
      s_error_ += stretch_->lengths[i].error;
      require_length(s_, segments.times[i + 1]);
    }
    const bool last = stretch_->last && segment_ == segments.size();
    CurveSegment piece{segments.times[i],
                       segments.times[i + 1],
                       s_start,
                       s_,
                       segments[i],
                       metric_,
                       last,
                       segments.warp(i),
                       {},
                       number_++,
                       s_error_};
    if (last && stretch_->closes) piece.end_key = 0;
    const Run run = sampler_->place(piece);
    if (run.key) left_.push_back({piece, Row::at_key, Row::at_key + 1});
    if (run.first < run.last) left_.push_back({piece, run.first, run.last});
    if (run.end) left_.push_back({piece, Row::at_end, Row::at_end + 1});
  }

  Source<SegmentBlock> stretches_;
  std::shared_ptr<Sampler> sampler_;
  std::vector<std::size_t> metric_;
  std::shared_ptr<const SegmentBlock> stretch_;
  std::size_t segment_ = 0;
  std::uint64_t number_ = 0;
  std::deque<SampleBlock::Part> left_;  ///< rows of the last piece that are not in a batch yet
  std::size_t most_parts_ = 0;          ///< of the batches so far
  spline::DoubleDouble s_;
  double s_error_ = 0;
  bool first_ = true;
};

}  // namespace

void refuse_overflow(const Sample& sample) {
  throw Error(Exit::data, fmt::format("the row at time {} has a number beyond the range of doubles; expected less than "
                                      "1.8e308 in size; scale the keys down",
                                      time_text(sample.t)));
}

std::uint64_t SampleBlock::rows() const {
  std::uint64_t rows = 0;
  for (const Part& part : parts) rows += part.last - part.first;
  return rows;
}

Source<SampleBlock> place(Source<SegmentBlock> segment_blocks, std::shared_ptr<Sampler> sampler,
                          std::vector<std::size_t> metric) {
  const auto placer = std::make_shared<Placer>(std::move(segment_blocks), std::move(sampler), std::move(metric));
  return [placer] { return placer->next(); };
}

std::vector<Cell> evaluate(const SampleBlock& batch, const Locator& locator, std::span<const std::size_t> chosen) {
  if (batch.parts.empty()) return {};
  const std::size_t width = cells_in_row(chosen, batch.parts.front().piece.cubics.size());
  std::vector<Cell> cells(batch.rows() * width);
  Cell* rows = cells.data();
  Located located;
  Point point;
  for (const auto& [piece, first, last] : batch.parts) {
    locator.locate(piece, first, last, located);
    write_rows(rows, chosen, piece, located, point);
    Cell* const end = rows + located.samples.size() * width;
    const auto beyond = std::find_if(rows, end, [](const Cell& cell) { return !std::isfinite(cell.hi); });
    if (beyond != end) refuse_overflow(located.samples[static_cast<std::size_t>(beyond - rows) / width]);
    rows = end;
  }
  return cells;
}

Evaluate fast_rows(std::shared_ptr<const Locator> locator) {
  return [locator = std::move(locator)](const SampleBlock& batch, std::span<const std::size_t> chosen) {
    return Table{evaluate(batch, *locator, chosen)};
  };
}

}  // namespace tcb
