// From segments of the curve to rows: which samples lie on each, and the cells of their rows.
#include "sample/rows.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "sample/build.hpp"
#include "sample/fields.hpp"
#include "sample/sampler.hpp"

namespace tcb {
namespace {

/// Takes the segments in order and has the sampler place the rows on each.
class Placer {
 public:
  Placer(Source<SegmentBlock> segments, std::shared_ptr<Sampler> sampler, CurveChannels channels, spline::Side side)
      : blocks_(std::move(segments)), sampler_(std::move(sampler)), channels_(std::move(channels)), side_(side) {}

  std::optional<SampleBlock> next() {
    while (placed_.empty() && !segment_follows()) {
      if (sampler_->done()) return std::nullopt;
      std::optional<SegmentBlock> more = blocks_();
      if (!more) return std::nullopt;
      block_ = std::make_shared<const SegmentBlock>(std::move(*more));
      index_ = 0;
    }
    SampleBlock result{block_, {}, first_};
    result.parts.reserve(most_parts_);
    for (std::uint64_t room = SampleBlock::most_rows; room > 0;) {
      if (placed_.empty() && !segment_follows()) break;
      if (placed_.empty()) place_next();
      if (placed_.empty()) continue;
      SampleBlock::Part& part = placed_.front();
      const std::uint64_t size = std::min(room, part.last - part.first);
      result.parts.push_back({part.segment, part.first, part.first + size});
      part.first += size;
      room -= size;
      if (part.first == part.last) placed_.pop_front();
    }
    first_ = first_ && result.parts.empty();
    most_parts_ = std::max(most_parts_, result.parts.size());
    return result;
  }

 private:
  bool segment_follows() const { return block_ != nullptr && index_ < block_->segments.size() && !sampler_->done(); }

  void place_next() {
    const auto& segments = block_->segments;
    const std::size_t i = index_++;
    const spline::DoubleDouble s_start = s_;
    if (!block_->lengths.empty()) {
      s_ = s_ + spline::DoubleDouble(block_->lengths[i].value);
      s_error_ += block_->lengths[i].error;
      require_length(s_, segments.times[i + 1]);
    }
    const bool last = block_->last && index_ == segments.size();
    CurveSegment segment{.start = segments.times[i],
                         .end = segments.times[i + 1],
                         .s_start = s_start,
                         .s_end = s_,
                         .cubics = segments[i],
                         .metric = channels_.metric,
                         .last = last,
                         .warp = segments.warp(i),
                         .number = number_++,
                         .s_error = s_error_,
                         .rotations = segments.rotations_of(i),
                         .rotation_columns = channels_.rotations,
                         .angles = channels_.angles,
                         .frames = channels_.frames ? &*channels_.frames : nullptr,
                         .side = side_};
    if (last && block_->closes) segment.end_key = 0;
    decimals_ = std::max({decimals_, decimals_of(segment.start), decimals_of(segment.end)});
    segment.decimals = decimals_;
    const SegmentRows run = sampler_->place(segment);
    if (run.key) placed_.push_back({segment, SpecialRow::at_key, SpecialRow::at_key + 1});
    if (run.first < run.last) placed_.push_back({segment, run.first, run.last});
    if (run.end) placed_.push_back({segment, SpecialRow::at_end, SpecialRow::at_end + 1});
  }

  Source<SegmentBlock> blocks_;
  std::shared_ptr<Sampler> sampler_;
  CurveChannels channels_;
  spline::Side side_;
  std::shared_ptr<const SegmentBlock> block_;
  std::size_t index_ = 0;
  std::uint64_t number_ = 0;
  std::deque<SampleBlock::Part> placed_;  ///< rows that are not in a block yet
  std::size_t most_parts_ = 0;            ///< of the blocks so far
  spline::DoubleDouble s_;
  double s_error_ = 0;
  int decimals_ = 0;  ///< of the times so far
  bool first_ = true;
};

}  // namespace

void refuse_overflow(const Sample& sample) {
  throw data_error(
      "{} has a number beyond the range of doubles; expected less than 1.8e308 in size; scale the keys down",
      std::isfinite(sample.t.hi) ? "the row at time " + time_text(sample.t) : "the time of a row");
}

std::uint64_t SampleBlock::rows() const {
  std::uint64_t rows = 0;
  for (const Part& part : parts) rows += part.last - part.first;
  return rows;
}

Source<SampleBlock> place(Source<SegmentBlock> segments, std::shared_ptr<Sampler> sampler, CurveChannels channels,
                          spline::Side side) {
  const auto placer = std::make_shared<Placer>(std::move(segments), std::move(sampler), std::move(channels), side);
  return [placer] { return placer->next(); };
}

std::vector<Cell> evaluate(const SampleBlock& block, const Locator& locator, std::span<const std::size_t> chosen) {
  if (block.parts.empty()) return {};
  const std::size_t width = cells_in_row(chosen, shape_of(block.parts.front().segment));
  std::vector<Cell> cells(block.rows() * width);
  Cell* rows = cells.data();
  Located located;
  Point<double> point;
  for (const auto& [segment, first, last] : block.parts) {
    locator.locate(segment, first, last, located);
    write_rows(rows, width, chosen, segment, located, point);
    Cell* const end = rows + located.samples.size() * width;
    const auto beyond = std::find_if(rows, end, [](const Cell& cell) { return !std::isfinite(cell.hi); });
    if (beyond != end) refuse_overflow(located.samples[static_cast<std::size_t>(beyond - rows) / width]);
    rows = end;
  }
  return cells;
}

namespace {

/// The gaps of each channel, in order.
class GapsOfChannels {
 public:
  explicit GapsOfChannels(const std::vector<spline::ChannelGap>& gaps) {
    for (const spline::ChannelGap& gap : gaps) {
      if (gap.channel >= channels_.size()) channels_.resize(gap.channel + 1);
      channels_[gap.channel].push_back(gap);
    }
  }

  /// The gap of a channel in which a segment lies, or null.
  const spline::ChannelGap* find(std::size_t channel, std::uint64_t segment) const {
    if (channel >= channels_.size()) return nullptr;
    const std::vector<spline::ChannelGap>& gaps = channels_[channel];
    const auto next = std::ranges::upper_bound(gaps, segment, {}, &spline::ChannelGap::first);
    return next != gaps.begin() && segment < std::prev(next)->last ? &*std::prev(next) : nullptr;
  }

 private:
  std::vector<std::vector<spline::ChannelGap>> channels_;
};

/// Whether a sample on a segment within a gap is at a key of the channel.
bool is_at_key(const spline::ChannelGap& gap, std::uint64_t segment, const Sample& sample) {
  if (gap.last == spline::ChannelGap::no_key) return false;
  return (segment == gap.first && sample.at.u == 0) || (segment + 1 == gap.last && sample.at.w == 0);
}

void empty_gaps(Table& table, const SampleBlock& block, const Locator& locator, const GapsOfChannels& gaps,
                const std::vector<CellOfChannel>& cells) {
  Located located;
  std::size_t row = 0;
  for (const auto& [segment, first, last] : block.parts) {
    const std::size_t begin = row * cells.size();
    row += static_cast<std::size_t>(last - first);
    located.samples.clear();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const spline::ChannelGap* const gap = gaps.find(cells[i].channel, segment.number);
      if (gap == nullptr) continue;
      if (located.samples.empty()) locator.locate(segment, first, last, located);
      for (std::size_t k = 0; k < located.samples.size(); ++k) {
        if (cells[i].is_position && is_at_key(*gap, segment.number, located.samples[k])) continue;
        const std::size_t cell = begin + k * cells.size() + i;
        table.cells[cell] = empty_cell;
        if (!table.texts.empty()) table.texts[cell].clear();
      }
    }
  }
}

}  // namespace

Evaluate without_gaps(Evaluate evaluate, std::shared_ptr<const Locator> locator,
                      const std::vector<spline::ChannelGap>& gaps) {
  return [evaluate = std::move(evaluate), locator = std::move(locator), of_channels = GapsOfChannels(gaps)](
             const SampleBlock& block, std::span<const std::size_t> chosen) {
    Table table = evaluate(block, chosen);
    if (block.parts.empty()) return table;
    empty_gaps(table, block, *locator, of_channels, cells_of_channels(chosen, shape_of(block.parts.front().segment)));
    return table;
  };
}

Evaluate fast_rows(std::shared_ptr<const Locator> locator) {
  return [locator = std::move(locator)](const SampleBlock& block, std::span<const std::size_t> chosen) {
    return Table{evaluate(block, *locator, chosen)};
  };
}

}  // namespace tcb
