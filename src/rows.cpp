// From pieces of the curve to rows of text: which samples lie on each, what is known there, how it is printed.
#include "rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "format/number.hpp"
#include "spline/arc_length.hpp"

namespace tcb {
namespace {

using format::Cell;
using format::CellKind;
using sampler::Piece;
using sampler::Sample;

void append_time(std::vector<Cell>& row, const Piece&, const Sample& sample) { row.push_back(sample.t); }

void append_position(std::vector<Cell>& row, const Piece& piece, const Sample& sample) {
  const auto& [t, cycles, beyond, holds, backward] = sample.outside;
  const double local_beyond =
      beyond.hi == 0 ? 0 : (beyond / (piece.end - piece.start)).hi * piece.warp.slope(sample.at.u);
  for (std::size_t i = 0; i < piece.cubics.size(); ++i) {
    double position = spline::position(piece.cubics[i], sample.at);
    if (beyond.hi != 0) position += spline::first_derivative(piece.cubics[i], sample.at) * local_beyond;
    if (cycles != 0) position += cycles * piece.cycle[i];
    row.emplace_back(position);
  }
}

/// The arc length from the curve's first key.
void append_length(std::vector<Cell>& row, const Piece& piece, const Sample& sample) {
  if (sample.s) {
    row.emplace_back(*sample.s);
    return;
  }
  const double into = spline::length(spline::Speed<double>(piece.cubics, piece.metric), sample.at.u);
  row.emplace_back((piece.s_start + spline::Twice(into)).hi);
}

constexpr std::array all_fields{
    Field{"time", CellKind::time, false, false, append_time},
    Field{"position", CellKind::real, true, false, append_position},
    Field{"s", CellKind::real, false, true, append_length},
};

/// Walks over the pieces of stretches and asks the sampler for the samples on each.
class Placer {
 public:
  Placer(Source<Stretch> stretches, std::shared_ptr<sampler::Sampler> sampler, std::vector<std::size_t> metric)
      : stretches_(std::move(stretches)), sampler_(std::move(sampler)), metric_(std::move(metric)) {}

  std::optional<Batch> next() {
    while (stretch_ == nullptr || (segment_ == stretch_->segments.size() && is_empty(left_.run))) {
      if (sampler_->done()) return std::nullopt;
      std::optional<Stretch> more = stretches_();
      if (!more) return std::nullopt;
      stretch_ = std::make_shared<const Stretch>(std::move(*more));
      segment_ = 0;
    }
    Batch batch{stretch_, {}, first_};
    std::uint64_t room = Batch::most_rows;
    while (room > 0) {
      if (is_empty(left_.run)) {
        if (segment_ == stretch_->segments.size() || sampler_->done()) break;
        left_ = next_part();
      }
      const std::uint64_t size = std::min(room, left_.run.last - left_.run.first);
      if (size > 0) batch.parts.push_back({left_.piece, {left_.run.first, left_.run.first + size}});
      left_.run.first += size;
      room -= size;
    }
    if (sampler_->done() && is_empty(left_.run)) segment_ = stretch_->segments.size();
    first_ = first_ && batch.parts.empty();
    return batch;
  }

 private:
  static bool is_empty(const sampler::Run& run) { return run.first == run.last; }

  Batch::Part next_part() {
    const auto& segments = stretch_->segments;
    const std::size_t i = segment_++;
    const spline::Twice s_start = s_;
    if (!stretch_->lengths.empty()) s_ = s_ + spline::Twice(stretch_->lengths[i]);
    const bool last = stretch_->last && segment_ == segments.size();
    const Piece piece{
        segments.times[i], segments.times[i + 1], s_start, s_, segments[i], metric_, last, segments.warp(i), {}};
    return {piece, sampler_->place(piece)};
  }

  Source<Stretch> stretches_;
  std::shared_ptr<sampler::Sampler> sampler_;
  std::vector<std::size_t> metric_;
  std::shared_ptr<const Stretch> stretch_;
  std::size_t segment_ = 0;
  Batch::Part left_;  ///< samples of the last piece that are not in a batch yet
  spline::Twice s_;
  bool first_ = true;
};

[[noreturn]] void refuse_overflow(const Sample& sample) {
  std::string time;
  format::append_time(time, sample.t);
  throw Error(Exit::data, fmt::format("the row at time {} has a number beyond the range of doubles; expected less than "
                                      "1.8e308 in size; scale the keys down",
                                      time));
}

}  // namespace

std::span<const Field> fields() { return all_fields; }

std::vector<format::OutputColumn> output_columns(std::span<const std::size_t> chosen, const format::Input& input) {
  std::vector<format::OutputColumn> columns;
  for (const std::size_t index : chosen) {
    const Field& field = all_fields[index];
    if (field.per_channel) {
      for (const std::string& channel : input.channels) columns.push_back({channel, field.kind});
    } else {
      columns.push_back({field.kind == CellKind::time ? input.time : std::string(field.name), field.kind});
    }
  }
  return columns;
}

Source<Batch> place(Source<Stretch> stretches, std::shared_ptr<sampler::Sampler> sampler,
                    std::vector<std::size_t> metric) {
  const auto placer = std::make_shared<Placer>(std::move(stretches), std::move(sampler), std::move(metric));
  return [placer] { return placer->next(); };
}

std::vector<Cell> evaluate(const Batch& batch, const sampler::Locator& locator, std::span<const std::size_t> chosen) {
  std::vector<Cell> cells;
  for (const auto& [piece, run] : batch.parts) {
    for (std::uint64_t j = run.first; j < run.last; ++j) {
      const Sample sample = locator.locate(piece, j);
      const std::size_t row = cells.size();
      for (const std::size_t field : chosen) all_fields[field].append(cells, piece, sample);
      const auto is_finite = [](const Cell& cell) { return std::isfinite(cell.hi); };
      if (!std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(row), cells.end(), is_finite))
        refuse_overflow(sample);
    }
  }
  return cells;
}

}  // namespace tcb
