// Where rows are on a golden curve: at the times that they print, or at exact arc lengths.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/point.hpp"
#include "sampling/sampler.hpp"

namespace tcb {

/// A row as the fast path places it.
struct FastRow {
  const CurveSegment& piece;
  const Sample& sample;
  std::uint64_t number;
};

/// The exact arc lengths of rows.
struct ArcPlaces {
  std::vector<Rational> places;  ///< one a row, or none; then row j is at
  Rational from, step;           ///< from + j step, or
  std::uint64_t intervals = 0;   ///< if this is not 0, the step is such a part of what lies from there to the end
  std::optional<Rational> to;    ///< the end of the range, where it is not the curve's
};

/// Those of the rows that are asked for; nothing where they are asked for by time.
std::optional<ArcPlaces> arc_places(const SamplingRequest& request, const Extent& extent);

template <class S>
S arc_place(const ArcPlaces& arc, std::uint64_t row, GoldenCurve<S>& curve) {
  if (row == Row::at_end) return arc.to ? scalar_of<S>(*arc.to) : curve.length();
  if (!arc.places.empty()) return scalar_of<S>(arc.places[row]);
  if (arc.intervals == 0) return scalar_of<S>(arc.from + arc.step * row);
  const S from = scalar_of<S>(arc.from);
  return from + (curve.length() - from) * S(row) / S(arc.intervals);
}

/// The spot at one end of a segment.
template <class S>
Spot<S> spot_at_key(GoldenCurve<S>& curve, std::size_t segment, bool end, bool with_length) {
  const std::size_t key = segment + (end ? 1 : 0);
  Spot<S> spot{segment, end ? spline::LocalParameter<S>{S(1), S(0)} : spline::LocalParameter<S>{S(0), S(-1)},
               S(end ? 1 : 0)};
  spot.t = curve.time(key);
  spot.at_start = !end;
  spot.at_end = end;
  if constexpr (spline::has_roots<S>) {
    if (with_length) spot.s = curve.length_to(key);
  }
  return spot;
}

/// Where the fast path says that a row is at a key, or next to one, rounding decides: a length that is printed as that
/// of a key is the key's.
template <class S>
std::optional<bool> end_by_length(const FastRow& row, const S& s, GoldenCurve<S>& curve) {
  if (row.number == Row::at_key) return false;
  const auto printed = [](const S& length) { return nearest_double(rational_of(length)); };
  const double shown = printed(s);
  if (shown <= printed(curve.length_to(row.piece.number))) return false;
  if (shown >= printed(curve.length_to(row.piece.number + 1))) return true;
  return std::nullopt;
}

template <class S>
Spot<S> spot_at_length(const FastRow& row, const ArcPlaces& arc, GoldenCurve<S>& curve) {
  const S s = arc_place(arc, row.number, curve);
  std::size_t segment = row.piece.number;
  if (const auto end = end_by_length(row, s, curve)) return spot_at_key(curve, segment, *end, true);
  spline::ArcInverse<S> inverse(curve.arc(segment), curve.length_to(segment), curve.length_to(segment + 1));
  Spot<S> spot{segment, inverse.at(s)};
  const GoldenSegment<S>& on = curve.segment(segment);
  spot.passed = on.warp.inverse(spot.at);
  spot.t = on.start + spot.passed * (on.end - on.start);
  spot.s = s;
  return spot;
}

template <class S>
S floor_of(const S& value) {
  return floor(value);
}

/// A time that is not on the curve, and the time on it that stands for it; as map_to_curve.
template <class S>
S mapped_time(Extrapolation kind, const S& first, const S& last, const S& t, GoldenOutside<S>& outside) {
  using enum Extrapolation;
  const S end = t < first ? first : last;
  if (kind == hold || first == last) outside.holds = true;
  if (kind == linear && first != last) outside.beyond = t - end;
  if (kind == hold || kind == linear || first == last) return end;
  const S period = last - first;
  const S periods = floor_of(S((t - first) / period));
  const S rest = t - first - periods * period;
  if (kind == offset) outside.cycles = periods;
  outside.backward = kind == oscillate && floor_of(S(periods / S(2))) * S(2) != periods;
  return outside.backward ? S(last - rest) : S(first + rest);
}

/// The segment on which the curve is at time t; of two that meet there, the one before if `left`.
template <class S>
std::size_t segment_at(const GoldenCurve<S>& curve, const S& t, bool left) {
  std::size_t low = 0, high = curve.size() - 1;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    const S& end = curve.time(middle + 1);
    (left ? end >= t : end > t) ? high = middle : low = middle + 1;
  }
  return low;
}

template <class S>
Spot<S> spot_at_time(const FastRow& row, const ExactCurve& exact, bool left, GoldenCurve<S>& curve) {
  const S t = scalar_of<S>(exact_number(row.sample.t, exact.decimal));
  const S& first = curve.time(0);
  const S& last = curve.time(curve.size());
  const CurveSegment& piece = row.piece;
  const bool inside = row.sample.t >= piece.start && row.sample.t <= piece.end;
  std::size_t segment = piece.number;
  Spot<S> spot;
  if (inside && (row.sample.t == piece.start || row.sample.t == piece.end)) {
    spot = spot_at_key(curve, segment, row.sample.t != piece.start, false);
  } else {
    const S on_curve = inside ? t : mapped_time(exact.extrapolation, first, last, t, spot.outside);
    if (!inside) segment = segment_at(curve, on_curve, left);
    const S& start = curve.time(segment);
    const S& end = curve.time(segment + 1);
    if (on_curve == start || on_curve == end) {
      const GoldenOutside<S> outside = spot.outside;
      spot = spot_at_key(curve, segment, on_curve != start, false);
      spot.outside = outside;
    } else {
      spot.segment = segment;
      spot.at = spline::TimeMap<S>(start, end, curve.segment(segment).warp)(on_curve);
      spot.passed = (on_curve - start) / (end - start);
    }
  }
  spot.t = t;
  return spot;
}

}  // namespace tcb
