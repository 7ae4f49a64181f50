// Samples on a grid of times or of arc lengths: what the two have in common.
#include "sampling/on_grid.hpp"

#include <algorithm>
#include <utility>

namespace tcb {

OnGrid::OnGrid(const SamplingRequest& request, Spacing spacing)
    : spacing_(std::move(spacing)),
      policy_(request.end),
      keys_(request.keys),
      from_left_(request.from_left),
      max_rows_(request.max_rows),
      cut_(request.to.has_value()),
      near_(nearest_time(spacing_.grid.step()) * Time(1e-9)) {}

void OnGrid::require_bounds(const CurveSegment& piece, const Range& on) const {
  const Rational& from = spacing_.grid.start();
  if (piece.number == 0) require_not_before("--from", from, lower(on));
  if (!piece.last) return;
  require_not_beyond("--from", from, upper(on));
  if (cut_) require_not_beyond("--to", exact_time(*spacing_.end), upper(on));
}

/// How many rows of the grid lie on this piece or before it. A row at the piece's end belongs to it if it is the
/// last, if nothing lies between its ends, or if rows are looked at from the left.
std::uint64_t OnGrid::rows_up_to(const CurveSegment& piece, const Range& on, const Time& stop, bool final) const {
  const Grid& grid = spacing_.grid;
  const bool with_end = final || from_left_ || on.start == on.end;
  if (grid.is_single()) {
    const bool here = with_end ? grid.first() <= stop : grid.first() < stop;
    return here ? spacing_.rows : 0;
  }
  if (stop < grid.first()) return 0;
  if (spacing_.rows == Spacing::unlimited) {
    if (grid.rough_rows(stop) > static_cast<double>(max_rows_) * 0.99) {
      require_rows(steps_between(grid.start(), exact_time(stop), grid.step()), max_rows_, !final);
    }
    require_resolution(grid, stop);
  } else if (piece.last) {
    require_resolution(grid, stop);
  }
  return std::min(spacing_.rows, with_end ? grid.rows_through(stop) : grid.rows_before(stop));
}

/// Every key in the range becomes a row, and no other row is left beside it.
void OnGrid::add_keys(Run& run, const Range& on, const Time& stop, bool final) const {
  const Grid& grid = spacing_.grid;
  const auto beside = [&](std::uint64_t row, const Time& key) {
    const Time distance = grid.time(row) - key;
    return distance <= near_ && -distance <= near_;
  };
  run.key = on.start >= grid.first() - near_ && on.start <= stop;
  if (run.first < run.last && beside(run.first, on.start)) ++run.first;
  if (run.first < run.last && beside(run.last - 1, on.end)) --run.last;
  if (final && on.end <= stop + near_) run.end = true;
}

/// Notes what the steps leave out at the end, and keeps the end where that is wanted.
void OnGrid::finish(const Run& run, const Time& stop) {
  if (run.end || next_ == 0 || spacing_.rows != Spacing::unlimited) return;
  const Time last = spacing_.grid.time(next_ - 1);
  if (last < stop) left_out_ = exact_time(stop) - exact_time(last);
}

Run OnGrid::place(const CurveSegment& piece) {
  const Range on = range(piece);
  require_bounds(piece, on);
  const bool ends_here = cut_ && *spacing_.end <= on.end;
  const Time stop = ends_here ? *spacing_.end : on.end;
  const bool final = piece.last || ends_here;
  Run run{next_, std::max(next_, rows_up_to(piece, on, stop, final))};
  next_ = run.last;
  if (keys_) add_keys(run, on, stop, final);
  if (final) {
    finish(run, stop);
    run.end = run.end || (policy_ == EndPolicy::keep && left_out_);
    if (run.end) left_out_.reset();
  }
  done_ = ends_here || (next_ == spacing_.rows && !keys_);
  return run;
}

void OnGrid::set_coordinates(const CurveSegment& piece, std::uint64_t first, std::uint64_t last,
                             std::vector<Time>& coordinates) const {
  if (first < Row::at_key) return spacing_.grid.set_times(first, last, coordinates);
  const Range on = range(piece);
  const Time end = cut_ ? std::min(*spacing_.end, on.end) : on.end;
  coordinates.assign(1, first == Row::at_key ? on.start : end);
}

}  // namespace tcb
