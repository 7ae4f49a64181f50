// Rows of an exact curve, as the fast path places them, and their points at any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "exact/ball_length.hpp"
#include "exact/exact_curve.hpp"
#include "exact/exact_keys.hpp"
#include "exact/rounding.hpp"
#include "sample/fields.hpp"
#include "sample/sampler.hpp"

namespace tcb {

/// A row as the fast path places it.
struct FastRow {
  const CurveSegment& segment;
  const Sample& sample;
  std::uint64_t number;
  const Sample* end = nullptr;          ///< of the piece that begins at the sample, if there is one
  const Outside* outside = nullptr;     ///< of the sample, if there are rows outside the curve
  std::optional<bool> key_at_end = {};  ///< it is at a key, the one at the segment's end or at its start
  bool is_middle = false;               ///< it is in the middle of its segment, by the symmetry of the curve
  ExactTimes exact = {};
};

/// The exact times or arc lengths of rows.
struct ExactPlaces {
  std::vector<Rational> places;  ///< one per row; if there are none, row j is at from + j step
  Rational from, step;
  std::uint64_t intervals = 0;  ///< if not 0, the step is the length from `from` to the end, divided by this number
  std::optional<Rational> to;   ///< the end of the range, where it is not the curve's
};

/// What the rows of a curve have in common at all levels.
struct RowsOfCurve {
  ExactCurve exact;
  ChannelFacts facts;
  std::optional<ExactPlaces> arc;  ///< of rows that are placed by length
  spline::Side side;
};

/// Places of a segment: more than any number of a row has zeros, as these are roots of polynomials of at most ten
/// degrees, but for rotations, whose numbers are not 0 at all of them by chance.
inline constexpr std::array inner_places{0.0546875, 0.140625, 0.234375, 0.328125, 0.4140625, 0.515625,
                                         0.578125,  0.671875, 0.765625, 0.859375, 0.9453125};

/// Whether fields need the length up to a point.
inline bool needs_lengths(std::span<const std::size_t> chosen) {
  return std::ranges::any_of(chosen, [](std::size_t i) { return fields()[i].needs_lengths; });
}

/// The double that a length is printed as.
template <class S>
double printed_length(const S& length);

/// The point of one row after another at a scalar.
template <class S>
class RowPoint {
 public:
  explicit RowPoint(const RowsOfCurve& rows) : rows_(rows), curve_(curve_at<S>(rows.exact)) {
    for (const Rational& cycle : rows.facts.cycle) cycle_.push_back(scalar_of<S>(cycle));
    if constexpr (spline::has_roots<S>) set_turns();
  }

  /// Requires: where rows are placed by length and the scalar has no roots, the row is at a key. `measured`: lengths of
  /// the point are needed.
  Point<S>& place(const FastRow& row, bool measured) {
    outside_.reset();
    if (!rows_.arc) {
      place_by_time(row);
    } else if constexpr (spline::has_roots<S>) {
      place_by_length(row);
    } else {
      segment_ = segment(row.segment.number);
      sample_ = sample_at_key(segment_, *row.key_at_end);
    }
    point_.set(segment_, measured && !sample_.s ? measured_arc() : nullptr);
    point_.set(sample_, outside_ ? &*outside_ : nullptr);
    if (row.end != nullptr)
      end_ = row.exact.end_time ? sample_at(*row.exact.end_time) : sample_at(row.segment, row.end->t);
    point_.set_end(&end_);
    return point_;
  }

  /// Whether the speed is that of the reversed curve, as it is at the places of each segment.
  bool is_symmetric() {
    const auto square_of_speed = [&](std::size_t number, double place) {
      const spline::Segments<S>& one = known(number).segments;
      const spline::LocalParameter<S> at{S(place), S(place) - S(1)};
      const std::vector<std::size_t>& metric = rows_.exact.rules.metric;
      S square(0);
      for (std::size_t i = 0; i < one.channels; ++i) {
        if (!metric.empty() && std::ranges::find(metric, i) == metric.end()) continue;
        const S rate = spline::first_derivative(one[0][i], at);
        square = square + rate * rate;
      }
      return square;
    };
    for (std::size_t before = curve_->size() / 2, after = curve_->size() - 1 - before; after < curve_->size();) {
      for (const double u : inner_places) {
        if (!(square_of_speed(before, u) - square_of_speed(after, 1 - u)).may_be_zero()) return false;
      }
      if (before == 0) break;
      --before;
      ++after;
    }
    return true;
  }

  /// The point at a place between the keys of the segment of the row that was placed last; null if the row was not on
  /// it, or if positions are not analytic functions of the place, by whole turns.
  Point<S>* place_inside(const FastRow& row, double u) {
    const auto changes = [](const S& place) { return place > S(0) && place < S(1); };
    const bool is_outside = !rows_.arc && !(row.sample.t >= row.segment.start && row.sample.t <= row.segment.end);
    if (is_outside || row.end != nullptr) return nullptr;
    outside_.reset();
    segment_ = segment(row.segment.number);
    for (const auto& rotation : segment_.rotations) {
      const auto [from, to] = rotation.constant_part();
      if (changes(from) || changes(to)) return nullptr;
    }
    sample_ = {};
    sample_.at = {S(u), S(u) - S(1)};
    sample_.t = time_at(segment_, S(segment_.end - segment_.start), sample_.at);
    point_.set(segment_, nullptr);
    point_.set(sample_, nullptr);
    return &point_;
  }

  std::optional<bool> key_at_end() const {
    if (sample_.at.u == S(0)) return false;
    return sample_.at.w == S(0) ? std::optional(true) : std::nullopt;
  }

 private:
  using Segment = CurveSegmentOf<S>;

  /// A computed segment, with its lengths if they were requested.
  struct Known {
    spline::Segments<S> segments;
    std::optional<spline::SegmentLength<S>> arc;
  };

  bool has_room() const {
    constexpr std::size_t most_kept = 64, most_cubics = 4096;  // a cubic may take a kilobyte
    return known_.size() < most_kept && known_.size() * rows_.exact.keys.channels < most_cubics;
  }

  Known& known(std::size_t number) {
    if (const auto found = known_.find(number); found != known_.end()) return found->second;
    if (!has_room()) known_.clear();
    spline::Segments<S> segments = curve_->segments(number, number + 1);
    if constexpr (spline::bounds_errors<S>) set_zeros(segments, number);
    return known_.emplace(number, Known{std::move(segments), {}}).first->second;
  }

  /// Sets coefficients to 0 that are exactly 0, which bounds alone do not show.
  void set_zeros(spline::Segments<S>& segments, std::size_t number) {
    constexpr std::array coefficients{&spline::Cubic<S>::out, &spline::Cubic<S>::c, &spline::Cubic<S>::in,
                                      &spline::Cubic<S>::e, &spline::Cubic<S>::d};
    constexpr std::array exact_coefficients{&spline::Cubic<Rational>::out, &spline::Cubic<Rational>::c,
                                            &spline::Cubic<Rational>::in, &spline::Cubic<Rational>::e,
                                            &spline::Cubic<Rational>::d};
    const auto may_be_zero = [&](const spline::Cubic<S>& cubic) {
      return std::ranges::any_of(coefficients, [&](auto one) { return (cubic.*one).may_be_zero(); });
    };
    const bool is_rational = rows_.exact.is_rational() && rows_.exact.rules.rotations.empty();
    if (!is_rational || std::ranges::none_of(segments.cubics, may_be_zero)) return;
    if (exact_curve_ == nullptr) exact_curve_ = curve_at<Rational>(rows_.exact);
    const spline::Segments<Rational> exact = exact_curve_->segments(number, number + 1);
    for (std::size_t i = 0; i < exact.cubics.size(); ++i) {
      for (std::size_t one = 0; one < coefficients.size(); ++one) {
        if (exact.cubics[i].*exact_coefficients[one] == 0) segments.cubics[i].*coefficients[one] = S(0);
      }
    }
  }

  const spline::SegmentLength<S>& arc(std::size_t number) {
    Known& one = known(number);
    if (!one.arc) one.arc = measured(one.segments);  // only now: some scalars throw
    return *one.arc;
  }

  spline::SegmentLength<S> measured(const spline::Segments<S>& one) const {
    spline::SegmentLength<S> arc;
    arc.assign(one[0], rows_.exact.rules.metric);
    return arc;
  }

  /// Sets the length at the start of the sample's segment, or at its end if the sample is there, and returns the
  /// lengths on the segment; null if the sample is at a key.
  const spline::SegmentLength<S>* measured_arc() {
    if constexpr (spline::has_roots<S>) {
      const bool at_end = sample_.at.w == S(0);
      (at_end ? segment_.s_end : segment_.s_start) = length_to(segment_.number + (at_end ? 1 : 0));
      return at_end || sample_.at.u == S(0) ? nullptr : &arc(segment_.number);
    } else {
      return nullptr;
    }
  }

  /// The length from the curve's first key to the one with this number. The current segment stays known.
  const S& length_to(std::size_t key) {
    if (lengths_.empty()) lengths_.push_back(S(0));
    for (std::size_t i = lengths_.size(); i <= key; ++i) {
      const bool is_kept = has_room() || known_.contains(i - 1);
      const S length = is_kept ? arc(i - 1).total().value : measured(curve_->segments(i - 1, i)).total().value;
      lengths_.push_back(lengths_.back() + length);
    }
    return lengths_[key];
  }

  void set_turns() {
    const auto first = curve_->segments(0, 1), last = curve_->segments(curve_->size() - 1, curve_->size());
    for (std::size_t i = 0; i < first.rotations.size(); ++i) {
      turns_.push_back(last.rotations[i].at({S(1), S(0)}) * spline::conjugate(first.rotations[i].at({S(0), S(-1)})));
    }
  }

  Segment segment(std::size_t number) {
    const spline::Segments<S>& one = known(number).segments;
    const bool last = number + 1 == curve_->size();
    Segment segment{one.times[0], one.times[1], S(0),   S(0),   one[0], rows_.exact.rules.metric,
                    last,         one.warp(0),  cycle_, number, 0,      last && curve_->is_closed() ? 0 : number + 1};
    segment.rotations = one.rotations_of(0);
    segment.rotation_columns = rows_.exact.channels.rotations;
    segment.angles = rows_.exact.channels.angles;
    segment.turns = turns_;
    segment.side = rows_.side;
    return segment;
  }

  S arc_length(std::uint64_t row) {
    const ExactPlaces& arc = *rows_.arc;
    if (row == SpecialRow::at_end) return arc.to ? scalar_of<S>(*arc.to) : length_to(segment_.number + 1);
    if (!arc.places.empty()) return scalar_of<S>(arc.places[row]);
    if (arc.intervals == 0) return scalar_of<S>(arc.from + arc.step * row);
    const S from = scalar_of<S>(arc.from);
    return from + (length_to(curve_->size()) - from) * S(row) / S(arc.intervals);
  }

  void place_at_key(bool end, const S& s) {
    sample_ = sample_at_key(segment_, end);
    sample_.s = s;
  }

  /// The fast path may have a row at a key, or next to one where rounding decides: a length that is printed as that of
  /// a key is the key's. Where fast lengths have an error, the row may be on another segment. Lengths are computed only
  /// as far as they are needed.
  void place_by_length(const FastRow& row) {
    segment_ = segment(row.segment.number);
    segment_.s_start = length_to(segment_.number);
    if (row.number == SpecialRow::at_key) return place_at_key(false, segment_.s_start);
    if (row.number == SpecialRow::at_end && row.sample.at.w == 0) {
      segment_.s_end = length_to(segment_.number + 1);
      return place_at_key(true, segment_.s_end);
    }
    const S s = arc_length(row.number);
    if (row.is_middle) {
      const spline::LocalParameter<S> middle{S(0.5), S(-0.5)};
      sample_ = {time_at(segment_, S(segment_.end - segment_.start), middle), middle, s};
      return;
    }
    const double shown = printed_length(s);
    std::size_t number = segment_.number;
    while (number > 0 && shown < printed_length(length_to(number))) --number;
    while (number + 1 < curve_->size() && shown > printed_length(length_to(number + 1))) ++number;
    if (number != segment_.number) segment_ = segment(number);
    segment_.s_start = length_to(number);
    if (shown <= printed_length(segment_.s_start)) return place_at_key(false, segment_.s_start);
    segment_.s_end = length_to(number + 1);
    if (shown >= printed_length(segment_.s_end)) return place_at_key(true, segment_.s_end);
    spline::LocalParameter<S> at;
    arc(segment_.number).places(segment_.s_start, segment_.s_end, {&s, 1}, {&at, 1});
    sample_ = {time_at(segment_, S(segment_.end - segment_.start), at), at, s};
  }

  S time(const Time& shown) const {
    if (!rows_.exact.decimal && !rows_.exact.channels.frames && shown.lo == 0) return S(shown.hi);
    return scalar_of<S>(exact_shown(shown));
  }
  Rational exact_shown(const Time& shown) const {
    return exact_number(shown, rows_.exact.decimal, rows_.exact.channels.frames);
  }

  /// The sample at a time on the current segment.
  SampleOf<S> sample_at(const CurveSegment& fast, const Time& shown) const {
    if (shown == fast.start || shown == fast.end) return sample_at_key(segment_, shown != fast.start);
    return sample_inside(time(shown), [&] { return exact_shown(shown); });
  }

  SampleOf<S> sample_at(const Rational& exact) const {
    if (const auto end = key_at(exact)) return sample_at_key(segment_, *end);
    return sample_inside(scalar_of<S>(exact), [&] { return exact; });
  }

  /// The sample at a time on the current segment, as it is at this scalar, and as a rational by a function.
  SampleOf<S> sample_inside(const S& t, const auto& exact) const {
    const auto part = needs_ease_part() ? std::optional(ease_part(exact())) : std::nullopt;
    return {t, segment_.time_map()(t, part), std::nullopt, part};
  }

  /// Whether the current segment has an ease, between keys whose times no distance makes.
  bool needs_ease_part() const { return segment_.warp.has_ease() && !rows_.exact.exponent; }

  /// The part of the ease at a time on the current segment.
  spline::EasePart ease_part(const Rational& t) const {
    const ExactCurve& curve = rows_.exact;
    const std::size_t number = segment_.number, next = number + 1 < curve.keys.size() ? number + 1 : 0;
    const Rational &start = curve.keys.times[number], end = next > 0 ? curve.keys.times[next] : *curve.end;
    const spline::Warp<Rational> warp(curve.keys.eases[number].out, curve.keys.eases[next].in);
    return warp.part(t - start, end - t, end - start, rows_.side);
  }

  /// Whether a time is that of the key at the end of the current segment, or at its start; nothing for others.
  std::optional<bool> key_at(const Rational& exact) const {
    const ExactCurve& curve = rows_.exact;
    const std::size_t next = segment_.number + 1;
    if (curve.exponent) return std::nullopt;
    if (exact == curve.keys.times[segment_.number]) return false;
    const bool is_end = next < curve.keys.size() ? exact == curve.keys.times[next] : curve.end == exact;
    return is_end ? std::optional(true) : std::nullopt;
  }

  /// A row whose exact time is known may lie beside the segment on which its rounded time is.
  void place_by_time(const FastRow& row) {
    const Time& shown = row.sample.t;
    const S t = row.exact.time ? scalar_of<S>(*row.exact.time) : time(shown);
    segment_ = segment(row.segment.number);
    const bool is_on_segment = row.exact.time ? key_at(*row.exact.time) || (t >= segment_.start && t <= segment_.end)
                                              : shown >= row.segment.start && shown <= row.segment.end;
    if (is_on_segment) {
      sample_ = row.exact.time ? sample_at(*row.exact.time) : sample_at(row.segment, shown);
    } else {
      const std::vector<S>& times = curve_->times();
      outside_ = map_to_curve<S>(rows_.exact.extrapolations, times.front(), times.back(), t);
      segment_ = segment(spline::segment_at_time<S>(times, outside_->t, rows_.side));
      std::optional<spline::EasePart> part;
      if (needs_ease_part()) {
        const auto& keys = rows_.exact.keys.times;
        const Rational exact = row.exact.time ? *row.exact.time : exact_shown(shown);
        const Rational end = rows_.exact.end.value_or(keys.back());
        part = ease_part(map_to_curve<Rational>(rows_.exact.extrapolations, keys.front(), end, exact).t);
      }
      sample_ = {t, segment_.time_map()(outside_->t, part), std::nullopt, part};
    }
    sample_.t = t;
  }

  const RowsOfCurve& rows_;
  std::unique_ptr<const spline::CurveKeys<S>> curve_;
  std::unique_ptr<const spline::CurveKeys<Rational>> exact_curve_;  ///< null until it is needed
  std::map<std::size_t, Known> known_;
  std::vector<S> lengths_;
  std::vector<S> cycle_;
  std::vector<spline::Quaternion<S>> turns_;
  Segment segment_;
  SampleOf<S> sample_, end_;
  std::optional<OutsideOf<S>> outside_;
  Point<S> point_;
};

}  // namespace tcb
