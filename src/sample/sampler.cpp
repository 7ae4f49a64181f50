// Samplers: on a grid of times or of arc lengths, at equal intervals within every segment, and pieces.
#include "sample/sampler.hpp"

#include <algorithm>
#include <cstddef>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "tcb/spline/arc_inverse.hpp"

namespace tcb {
namespace {

/// Of times, or of arc lengths.
struct Range {
  Time start, end;
};

/// Samples on a grid of times, or of arc lengths: of these each at the smallest time at which the curve has that
/// length.
class OnGrid : public Sampler {
 public:
  OnGrid(const SamplingRequest& request, const Extent& extent)
      : request_(request),
        by_length_(by_length(request.mode)),
        spacing_(spacing(request, extent)),
        first_(spacing_.grid.time(0)),
        end_(spacing_.end ? std::optional(nearest_time(*spacing_.end)) : std::nullopt),
        near_(Time(nearest_double(spacing_.grid.step())) * Time(1e-9)) {
    const Grid& grid = spacing_.grid;
    const bool has_last = by_length_ && extent.last_moving != 0 && !request.to && spacing_.rows != Spacing::unlimited;
    if (has_last && grid.start() + grid.step() * (spacing_.rows - 1) == *spacing_.end) end_row_on_ = extent.last_moving;
  }

  SegmentRows place(const CurveSegment& segment) override {
    const Range on = range(segment);
    require_bounds(segment, on);
    const int digits = decimals(segment);
    const bool ends_here = request_.to && end(digits) <= on.end;
    const Time stop = ends_here ? end(digits) : on.end;
    const bool final = segment.last || ends_here;
    SegmentRows run{next_, std::max(next_, rows_up_to(segment, on, stop, final))};
    next_ = run.last;
    if (request_.keys) add_keys(run, segment, on, stop, final);
    if (final) {
      finish(run, stop, digits);
      run.end = run.end || (request_.end == EndPolicy::keep && remainder_);
      if (run.end) remainder_.reset();
    }
    done_ = ends_here || (next_ == spacing_.rows && !request_.keys);
    return run;
  }

  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override {
    set_coordinates(segment, first, last, located.coordinates);
    if (by_length_) {
      locate_lengths(segment, located);
      // A row that is there for a key is at its time, also at the end of a hold.
      const bool is_key =
          first == SpecialRow::at_end && request_.keys && located.coordinates[0] >= Time(segment.s_end.hi);
      const bool is_end = last == spacing_.rows && segment.number == end_row_on_;
      if (is_key || is_end) located.samples.back() = {segment.end, {1, 0}, located.coordinates.back().hi};
      return;
    }
    const spline::TimeMap<double> locate = segment.time_map();
    located.samples.resize(located.coordinates.size());
    for (std::size_t i = 0; i < located.samples.size(); ++i) {
      Sample& sample = located.samples[i];
      sample.t = located.coordinates[i];
      sample.at = locate(segment.precise(sample.t));
      sample.s.reset();
    }
  }

  ExactTimes exact_times(std::uint64_t row, const ExactKeyTimes* keys) const override {
    if (row < SpecialRow::at_key) return {spacing_.grid.start() + spacing_.grid.step() * row};
    if (keys == nullptr) return {row == SpecialRow::at_end ? request_.to : std::nullopt};
    return {row == SpecialRow::at_key ? keys->start : request_.to ? std::min(*request_.to, keys->end) : keys->end};
  }
  bool done() const override { return done_; }
  std::optional<Rational> remainder() const override { return remainder_; }

 private:
  /// The segment's range of the coordinate of the grid.
  Range range(const CurveSegment& segment) const {
    if (by_length_) return {{segment.s_start.hi}, {segment.s_end.hi}};
    return {segment.start, segment.end};
  }
  /// How many decimals the coordinate has there, where doubles do not hold them.
  int decimals(const CurveSegment& segment) const { return by_length_ ? only_doubles : segment.decimals; }

  /// Row 0 of the grid, and the end that the request has of its own.
  Time first(int decimals) const { return decimals != 0 ? spacing_.grid.time(0, decimals) : first_; }
  Time end(int decimals) const { return decimals != 0 ? nearest_time(*spacing_.end, decimals) : *end_; }

  /// Throws: Error where the range of the request leaves the curve.
  void require_bounds(const CurveSegment& segment, const Range& on) const {
    if (request_.origin && !by_length_) return;
    if (segment.number > 0 && !segment.last) return;
    const Rational& from = spacing_.grid.start();
    const auto bound = [&](const Time& end) { return by_length_ ? exact_time(end) : request_.exact(end); };
    const RangeEnds ends = by_length_ ? RangeEnds::of_length : RangeEnds::of_keys;
    const Rational zero = by_length_ ? Rational(0) : request_.zero;
    if (segment.number == 0) require_not_before("--from", from + zero, ends, bound(on.start) + zero);
    if (!segment.last) return;
    require_not_after("--from", from + zero, ends, bound(on.end) + zero);
    if (!request_.to) return;
    const Rational to = request_.key_times ? *request_.to : request_.exact(end(decimals(segment)));
    require_not_after("--to", to + zero, ends, bound(on.end) + zero);
  }

  /// How many rows of the grid lie on this segment or before it. A row at the segment's end belongs to it if it is the
  /// last, if it has no duration, or if rows at keys belong to the segment before.
  std::uint64_t rows_up_to(const CurveSegment& segment, const Range& on, const Time& stop, bool final) const {
    const Grid& grid = spacing_.grid;
    const int digits = decimals(segment);
    const Time start = first(digits);
    const bool has_end_row = segment.number == end_row_on_;
    const bool with_end = final || request_.from_left || on.start == on.end || has_end_row;
    if (grid.is_single()) {
      const bool here = with_end ? start <= stop : start < stop;
      return here ? spacing_.rows : 0;
    }
    if (stop < start) return 0;
    const bool is_unlimited = spacing_.rows == Spacing::unlimited;
    if (is_unlimited && grid.rough_rows(stop) > static_cast<double>(request_.max_rows) * 0.99) {
      require_rows((request_.exact(stop) - grid.start()) / grid.step(), request_.max_rows, !final);
    }
    if (is_unlimited || segment.last) require_resolution(grid, stop, digits);
    const std::uint64_t rows = segment.number < end_row_on_ ? spacing_.rows - 1 : spacing_.rows;
    return std::min({rows, spacing_.most, with_end ? grid.rows_through(stop, digits) : grid.rows_before(stop, digits)});
  }

  /// Every key in the range becomes a row, on the segment that rows at keys belong to, and no other row is left near
  /// it.
  void add_keys(SegmentRows& run, const CurveSegment& segment, const Range& on, const Time& stop, bool final) const {
    const Grid& grid = spacing_.grid;
    const int decimals = this->decimals(segment);
    const auto is_near = [&](std::uint64_t row, const Time& key) {
      const Time distance = grid.time(row, decimals) - key;
      return distance <= near_ && -distance <= near_;
    };
    const auto is_in_range = [&](const Time& key) { return key >= first(decimals) - near_ && key <= stop + near_; };
    run.key = (!request_.from_left || segment.number == 0) && is_in_range(on.start) && on.start <= stop;
    if (run.first < run.last && is_near(run.first, on.start)) ++run.first;
    if (run.first < run.last && is_near(run.last - 1, on.end)) --run.last;
    if ((request_.from_left || final) && is_in_range(on.end)) run.end = true;
  }

  /// Sets how far the end of the range is from the last row.
  void finish(const SegmentRows& run, const Time& stop, int decimals) {
    if (run.end || next_ == 0 || spacing_.rows != Spacing::unlimited) return;
    const Time last = spacing_.grid.time(next_ - 1, decimals);
    if (last < stop) remainder_ = request_.exact(stop) - exact_time(last);
  }
  /// Replaces `coordinates` with those of some rows on this segment.
  void set_coordinates(const CurveSegment& segment, std::uint64_t first, std::uint64_t last,
                       std::vector<Time>& coordinates) const {
    const int digits = decimals(segment);
    if (first < SpecialRow::at_key) return spacing_.grid.set_times(first, last, digits, coordinates);
    const Range on = range(segment);
    const Time end = request_.to ? std::min(this->end(digits), on.end) : on.end;
    coordinates.assign(1, first == SpecialRow::at_key ? on.start : end);
  }

  SamplingRequest request_;
  bool by_length_;
  Spacing spacing_;
  Time first_;  ///< row 0, and the end, in doubles
  std::optional<Time> end_;
  Time near_;  ///< a row this near to a key is that key
  std::uint64_t next_ = 0;
  bool done_ = false;
  std::optional<Rational> remainder_;
  std::optional<std::size_t> end_row_on_;  ///< the segment at whose end the last row is, if it is at the whole length
};

/// Samples at equal intervals within every segment: the inbetweens of the paper.
class PerSegment : public Sampler {
 public:
  explicit PerSegment(const SamplingRequest& request) : request_(request) {}

  SegmentRows place(const CurveSegment& segment) override {
    require_rows(Rational(segment.number + 1) * request_.count, request_.max_rows, !segment.last);
    if (segment.start < segment.end) require_resolution(grid(segment), segment.end, segment.decimals);
    const bool left = request_.from_left;
    return {1, request_.count, !left || segment.number == 0, left || segment.last};
  }
  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override {
    const spline::TimeMap<double> locate = segment.time_map();
    const Grid grid = this->grid(segment);
    fill(located, first, last, [&](std::uint64_t row) -> Sample {
      if (row == SpecialRow::at_key) return {segment.start, {0, -1}};
      if (row == SpecialRow::at_end) return {segment.end, {1, 0}};
      const Time t = nearest_time(grid.start() + grid.step() * row, segment.decimals);
      return {t, locate(segment.precise(t))};
    });
  }

  ExactTimes exact_times(std::uint64_t row, const ExactKeyTimes* keys) const override {
    if (keys == nullptr) return {};
    if (row >= SpecialRow::at_key) return {row == SpecialRow::at_key ? keys->start : keys->end};
    return {keys->start + (keys->end - keys->start) * row / request_.count};
  }
  bool done() const override { return false; }

 private:
  /// Row 0 on a segment, and the step.
  Grid grid(const CurveSegment& segment) const {
    const Rational start = request_.exact(segment.start);
    return {start, (request_.exact(segment.end) - start) / request_.count};
  }

  SamplingRequest request_;
};

/// A row for each segment, or for the piece of it that lies in the range of the request.
class PieceSampler : public Sampler {
 public:
  explicit PieceSampler(const SamplingRequest& request) : request_(request) {}

  SegmentRows place(const CurveSegment& segment) override {
    if (!request_.origin && (segment.number == 0 || segment.last)) require_bounds(segment);
    const auto [start, end] = range(segment);
    done_ = request_.to && nearest_time(*request_.to, segment.decimals) <= segment.end;
    const bool has_row = start < end;
    if (has_row && !segment.warp.is_identity()) {
      throw data_error(
          "segment {}, from the key at time {} to the key at {}, has ease, so it is not cubic in time; expected keys "
          "without ease; give --no-ease, or a sampling option instead of --emit",
          segment.number, time_text(segment.start), time_text(segment.end));
    }
    if (has_row && ++rows_ > request_.max_rows) require_rows(Rational(rows_ - 1), request_.max_rows, !segment.last);
    if (rows_ == 0 && (done_ || segment.last) && !request_.origin)
      throw usage_error(
          "no part of the curve lies between --from and --to; expected a longer range; correct --from or --to");
    return {segment.number, segment.number + (has_row ? 1 : 0)};
  }

  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override {
    const spline::TimeMap<double> locate = segment.time_map();
    const auto [start, end] = range(segment);
    const auto at = [&](const Time& t) -> Sample { return {t, locate(segment.precise(t))}; };
    fill(located, first, last, [&, start = start](std::uint64_t) { return at(start); });
    located.ends.assign(last - first, at(end));
  }

  ExactTimes exact_times(std::uint64_t, const ExactKeyTimes* keys) const override {
    if (keys == nullptr) return {};
    const auto bound = [&](const std::optional<Rational>& given, const Rational& key) {
      return given ? std::clamp(*given, keys->start, keys->end) : key;
    };
    return {bound(request_.from, keys->start), bound(request_.to, keys->end)};
  }

  bool done() const override { return done_; }

 private:
  /// The part of the segment in the range of the request; it has no duration where there is none.
  Range range(const CurveSegment& segment) const {
    const auto bound = [&](const std::optional<Rational>& given, const Time& key) {
      return given ? std::clamp(nearest_time(*given, segment.decimals), segment.start, segment.end) : key;
    };
    return {bound(request_.from, segment.start), bound(request_.to, segment.end)};
  }

  /// Throws: Error where the range leaves the curve.
  void require_bounds(const CurveSegment& segment) const {
    const auto require = [&](std::string_view option, const std::optional<Rational>& given) {
      if (!given) return;
      const Rational time = *given + request_.zero;
      const auto bound = [&](const Time& end) { return request_.exact(end) + request_.zero; };
      if (segment.number == 0) require_not_before(option, time, RangeEnds::of_pieces, bound(segment.start));
      if (segment.last) require_not_after(option, time, RangeEnds::of_pieces, bound(segment.end));
    };
    require("--from", request_.from);
    require("--to", request_.to);
  }

  SamplingRequest request_;
  std::uint64_t rows_ = 0;
  bool done_ = false;
};

}  // namespace

/// A length that rounds to that of a key is at the key.
void locate_lengths(const CurveSegment& segment, Located& located) {
  located.arc.assign(segment.cubics, segment.metric);
  located.places.resize(located.coordinates.size());
  located.arc.places(segment.s_start, segment.s_end, located.coordinates, located.places);
  const Time duration = segment.duration();
  located.samples.clear();
  for (std::size_t i = 0; i < located.coordinates.size(); ++i) {
    const Time& s = located.coordinates[i];
    const auto& at = located.places[i];
    if (s <= Time(segment.s_start.hi) || at.u == 0) {
      located.samples.push_back({segment.start, {0, -1}, s.hi});
    } else if (s >= Time(segment.s_end.hi) || at.w == 0) {
      located.samples.push_back({segment.end, {1, 0}, s.hi});
    } else {
      located.samples.push_back({time_at(segment, duration, at), at, s.hi});
    }
  }
}

std::unique_ptr<Sampler> make_sampler(const SamplingRequest& request, const Extent& extent) {
  if (request.mode == Mode::per_segment) return std::make_unique<PerSegment>(request);
  if (request.mode == Mode::emit) return std::make_unique<PieceSampler>(request);
  return std::make_unique<OnGrid>(request, extent);
}

}  // namespace tcb
