// Rows of an exact curve, as the fast path places them, and their points at any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/exact_curve.hpp"
#include "exact/exact_keys.hpp"
#include "exact/rounding.hpp"
#include "sample/fields.hpp"
#include "sample/sampler.hpp"

namespace tcb {

/// Where a row by length is.
struct PlaceByLength {
  std::size_t segment;
  std::optional<bool> key_at_end = {};  ///< it is at a key, the one at the segment's end or at its start
  bool is_middle = false;               ///< it is in the middle of its segment, by the symmetry of the curve
};

/// A row as the fast path places it.
struct FastRow {
  const CurveSegment& segment;
  const Sample& sample;
  std::uint64_t number;
  const Sample* end = nullptr;               ///< of the piece that begins at the sample, if there is one
  const Outside* outside = nullptr;          ///< of the sample, if there are rows outside the curve
  const Motion* motion = nullptr;            ///< of the row, if it is at a pace
  std::optional<PlaceByLength> at_key = {};  ///< of a row by length that is at a key or in the middle
  ExactTimes exact = {};
  std::optional<PacePart<Rational>> part = {};  ///< of the length, for a row at a pace
};

/// The exact times or arc lengths of rows.
struct ExactPlaces {
  std::vector<Rational> places;  ///< one per row; if there are none, row j is at from + j step
  Rational from, step;
  std::uint64_t intervals = 0;    ///< if not 0, the step is the length from `from` to the end, divided by this number
  std::optional<Rational> to;     ///< the end of the range, where it is not the curve's
  std::optional<Pace> pace = {};  ///< rows are at times, and at parts of the curve's length

  /// The length of a row, if it is no fraction of the curve's.
  std::optional<Rational> length(std::uint64_t row) const {
    if (pace) return std::nullopt;
    if (row == SpecialRow::at_end) return to;
    if (row == SpecialRow::at_key || intervals != 0) return std::nullopt;
    return places.empty() ? from + step * row : places[row];
  }
};

/// Bounds on the error of the place of a row by length.
template <class S>
struct PlaceError {
  S place = S(0);  ///< in parts of the segment
  S eased = S(0);  ///< of its time, in parts of the duration, where the segment has an ease
  S part = S(0);   ///< in parts of the distance to a key or to a place where the curve nearly rests; at most 1
};

/// What the rows of a curve have in common at all scalars.
struct RowsOfCurve {
  ExactCurve exact;
  ChannelFacts facts;
  std::vector<std::size_t> metric;  ///< the channels that lengths measure
  std::vector<Rational> times;      ///< of the keys, and of the end of a closed curve, unless distances make them
  std::optional<ExactPlaces> arc;   ///< of rows that are placed by length
  spline::Side side;
};

/// Places of a segment: more than those at which a number of a row is the same, unless it is so everywhere, as these
/// are roots of polynomials of at most twelve degrees.
inline constexpr std::array inner_places{0.0546875, 0.109375, 0.171875, 0.234375, 0.328125, 0.4140625, 0.515625,
                                         0.578125,  0.671875, 0.765625, 0.859375, 0.890625, 0.9453125};

/// A number that is written for a cell of a row.
template <class S>
struct Written {
  Quantity<S> number;
  bool is_zero = false;  ///< as all keys show
};

/// Collects the numbers of a point.
template <class S>
class NumberWriter {
 public:
  NumberWriter(std::vector<Written<S>>& row, const ChannelFacts& facts) : row_(row), facts_(facts) {}
  void add(const S& value) { row_.push_back({{value}}); }
  void add(const Quantity<S>& value) { row_.push_back({value}); }
  void add_of_channel(const S& value, std::size_t channel, bool moves) {
    const bool is_zero = moves ? facts_.constant[channel] : facts_.zero[channel];
    row_.push_back({{is_zero ? S(0) : value}, is_zero});
  }

 private:
  std::vector<Written<S>>& row_;
  const ChannelFacts& facts_;
};
template <>
class CellWriter<Rational> : public NumberWriter<Rational> {
  using NumberWriter::NumberWriter;
};
template <>
class CellWriter<Bounded> : public NumberWriter<Bounded> {
  using NumberWriter::NumberWriter;
};
template <>
class CellWriter<spline::DoubleDouble> : public NumberWriter<spline::DoubleDouble> {
  using NumberWriter::NumberWriter;
};

/// The point of one row after another at a scalar.
template <class S>
class RowPoint {
 public:
  explicit RowPoint(const RowsOfCurve& rows) : rows_(rows), curve_(curve_at<S>(rows.exact)) {
    for (const Rational& cycle : rows.facts.cycle) cycle_.push_back(scalar_of<S>(cycle));
    if constexpr (spline::has_roots<S>) set_turns();
  }

  /// Sets the point of a row. Requires: the scalar has roots, or a row by length has `at_key`. Throws: Undecided where
  /// a scalar with roots does not decide the place of a row.
  void place(const FastRow& row) {
    outside_.reset();
    motion_.reset();
    key_at_end_.reset();
    place_error_ = {};
    if (row.at_key) {
      place_at_key(*row.at_key);
    } else if (!rows_.arc) {
      place_by_time(row);
    } else if constexpr (spline::has_roots<S>) {
      place_by_length(row);
    }
    if (row.part) set_motion(*row.part);
    point_.set(segment_, nullptr);
    set_sample(sample_);
    if (row.end != nullptr)
      end_ = row.exact.end_time ? sample_at(*row.exact.end_time) : sample_at(row.segment, row.end->t);
    point_.set_end(&end_);
  }

  /// Appends the numbers of a field at the point.
  void write(std::size_t field, std::vector<Written<S>>& row) {
    if (fields()[field].needs_lengths) set_length();
    field_writers<S>[field](point_, CellWriter<S>(row, rows_.facts));
    set_sample(sample_);
  }

  /// The place of a row by length.
  PlaceByLength place_of_row() const { return {segment_.number, key_at_end_}; }

  const PlaceError<S>& place_error() const { return place_error_; }

  /// Sets the point at a place between the keys of the segment of a row.
  void place_inside(std::size_t segment, double u) {
    outside_.reset();
    segment_ = this->segment(segment);
    sample_ = {};
    sample_.at = {S(u), S(u) - S(1)};
    sample_.t = segment_.start + (segment_.end - segment_.start) * S(u);
    point_.set(segment_, nullptr);
    point_.set(sample_, nullptr);
  }

  bool has_ease() const { return segment_.warp.has_ease(); }
  /// How large the terms of the position of a channel are.
  double scale(std::size_t channel) const requires std::is_same_v<S, spline::DoubleDouble> {
    const auto& [p0, out, c, c_low, p1, in, e, e_low, d] = segment_.cubics[channel];
    return std::abs(p0.hi) + std::abs(p1.hi) + std::abs(out.hi) + std::abs(in.hi) + std::abs(c.hi) + std::abs(d.hi);
  }
  /// More than what rounding leaves of terms that cancel, in a velocity, speed, acceleration or curvature at the point.
  S noise(std::size_t field) const requires spline::has_roots<S> {
    using std::abs;
    const std::string_view name = fields()[field].name;
    const auto& [u, w] = sample_.at;
    S v(0), a(0), square(0);
    for (const spline::Cubic<S>& x : segment_.cubics) {
      const S rate = spline::first_derivative(x, sample_.at), terms = abs(x.out) + abs(x.in) + abs(x.c) + abs(x.d);
      v = v + (sample_.at.near_start() ? S(abs(x.out) + u * terms) : S(abs(x.in) - w * terms));
      a = a + terms;
      square = square + rate * rate;
    }
    const S h = segment_.end - segment_.start, part(2 * rounding);
    const bool is_of_motion = motion_ && fields()[field].of_pace;
    if (name == "curvature" && square != S(0)) return a / square * part;
    if (is_of_motion || h == S(0)) return S(0);
    if (name == "velocity" || name == "speed") return v / h * part;
    return name == "acceleration" ? S(a / h / h * part) : S(0);
  }

  /// Whether the speed is that of the reversed curve, as it is at the places of each segment.
  bool is_symmetric() {
    const auto square_of_speed = [&](std::size_t number, double place) {
      const spline::Segments<S>& one = known(number).segments;
      const spline::LocalParameter<S> at{S(place), S(place) - S(1)};
      S square(0);
      for (const std::size_t i : rows_.metric) {
        const S rate = spline::first_derivative(one[0][i], at);
        square = square + rate * rate;
      }
      return square;
    };
    const auto are_equal = [](const S& a, const S& b) {
      if constexpr (spline::has_roots<S>) return abs(a - b) <= S(rounding) * (a + b);
      return a == b;
    };
    for (std::size_t before = curve_->size() / 2, after = curve_->size() - 1 - before; after < curve_->size();) {
      for (const double u : inner_places) {
        if (!are_equal(square_of_speed(before, u), square_of_speed(after, 1 - u))) return false;
      }
      if (before == 0) break;
      --before;
      ++after;
    }
    return true;
  }

 private:
  using Segment = CurveSegmentOf<S>;

  /// More than the error of a length over the length.
  static constexpr int digits = std::numeric_limits<S>::digits;
  inline static const double rounding = std::ldexp(1.0, digits == 102 ? -90 : 24 - digits);

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
    return known_.emplace(number, Known{curve_->segments(number, number + 1), {}}).first->second;
  }

  const spline::SegmentLength<S>& arc(std::size_t number) {
    Known& one = known(number);
    if (!one.arc) one.arc.emplace(one.segments[0], rows_.exact.rules.metric);
    return *one.arc;
  }

  /// Sets the point with its length.
  void set_length() {
    if constexpr (spline::has_roots<S>) {
      measured_ = sample_;
      if (!measured_.s) {
        const std::size_t number = segment_.number;
        measured_.s = length_to(number + (point_.at_end() ? 1 : 0));
        const bool is_inside = !point_.at_start() && !point_.at_end();
        if (is_inside)
          *measured_.s += sample_.at.u < S(0x1p-20) ? start_of_segment(sample_.at.u).total().value
                                                    : arc(number).to(sample_.at).value;
      }
      set_sample(measured_);
    }
  }

  void set_sample(const SampleOf<S>& sample) {
    point_.set(sample, outside_ ? &*outside_ : nullptr);
    point_.set_motion(motion_ ? &*motion_ : nullptr);
  }

  void set_motion(const PacePart<Rational>& part) {
    if constexpr (spline::has_roots<S>) {
      const S& length = length_to(curve_->size());
      motion_ = {S(0), scalar_of<S>(part.speed) * length, scalar_of<S>(part.acceleration) * length};
    }
  }

  /// The lengths of the current segment up to a place near its start, where a panel of it leaves few digits: those of a
  /// segment of its own.
  spline::SegmentLength<S> start_of_segment(const S& u) const {
    std::vector<spline::Cubic<S>> part;
    for (const spline::Cubic<S>& x : segment_.cubics) {
      const S chord = u * (x.out + u * (x.c + u * x.d)), in = u * (x.out + u * (S(2) * x.c + u * (S(3) * x.d)));
      part.push_back(spline::cubic<S>(S(0), chord, chord, S(x.out * u), in));
    }
    return spline::SegmentLength<S>(part, rows_.exact.rules.metric);
  }

  /// The place near the start of the current segment where a length from there is reached, to all digits of its size.
  S place_near_start(const S& length) const {
    const auto size_of = [](int halvings) {
      using std::ldexp;
      return S(ldexp(S(1), -halvings));
    };
    const auto is_beyond = [&](int halvings) {  // a channel goes as far, and so does the curve
      using std::abs;
      const S u = size_of(halvings);
      const auto goes_as_far = [&](const spline::Cubic<S>& x) {
        return abs(u * (x.out + u * (x.c + u * x.d))) >= length;
      };
      return std::ranges::any_of(rows_.metric, [&](std::size_t i) { return goes_as_far(segment_.cubics[i]); });
    };
    int beyond = 0, before = 1;
    for (; is_beyond(before); before *= 2) beyond = before;
    while (before - beyond > 1) {
      const int middle = (beyond + before) / 2;
      (is_beyond(middle) ? beyond : before) = middle;
    }
    const auto part = start_of_segment(size_of(beyond));
    return part.place(S(0), part.total().value, length).u * size_of(beyond);
  }

  /// The length from the curve's first key to the one with this number. The current segment stays known.
  const S& length_to(std::size_t key) {
    if (lengths_.empty()) {
      lengths_.push_back(S(0));
      errors_.push_back(S(0));
    }
    for (std::size_t i = lengths_.size(); i <= key; ++i) {
      const bool is_kept = has_room() || known_.contains(i - 1);
      if (!is_kept) passed_.assign(curve_->segments(i - 1, i)[0], rows_.exact.rules.metric);
      const spline::Length<S>& length = is_kept ? arc(i - 1).total() : passed_.total();
      lengths_.push_back(lengths_.back() + length.value);
      errors_.push_back(errors_.back() + length.error);
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

  void place_at_key(const PlaceByLength& place) {
    segment_ = segment(place.segment);
    if (place.is_middle) {
      const S half(0.5);
      sample_ = {};
      sample_.at = {half, -half};
      set_time_of_place();
    } else {
      sample_ = key_sample(*place.key_at_end);
    }
  }
  void set_time_of_place() {
    if constexpr (spline::has_roots<S>) {
      sample_.t = time_at(segment_, S(segment_.end - segment_.start), sample_.at);
    } else {  // requires: no ease
      sample_.t = segment_.start + (segment_.end - segment_.start) * sample_.at.u;
    }
  }

  S arc_length(const FastRow& fast) {
    const std::uint64_t row = fast.number;
    const ExactPlaces& arc = *rows_.arc;
    if (fast.part) return length_to(curve_->size()) * scalar_of<S>(fast.part->distance);
    if (const auto length = arc.length(row)) return scalar_of<S>(*length);
    if (row == SpecialRow::at_end) return length_to(segment_.number + 1);
    const S from = scalar_of<S>(arc.from);
    return from + (length_to(curve_->size()) - from) * scalar_of<S>(row) / scalar_of<S>(arc.intervals);
  }

  /// Whether a length is below (-1), at (0) or above (1) that of a key. One that is written is a key's only if it is so
  /// exactly: where the last floats do not tell them apart, and the length is so simple that this is no chance.
  int compare(const S& s, std::uint64_t row, std::size_t key) {
    const S length = length_to(key), difference = s - length, error = S(rounding) * length + errors_[key];
    if (difference > error) return 1;
    if (difference < -error) return -1;
    if (error == S(0)) return 0;
    constexpr int digits_of_last = 448;
    if (digits < digits_of_last) throw Undecided();
    const auto written = rows_.arc->length(row);
    if (!written) return 0;
    const S size = scalar_of<S>(denominator(*written));
    return S(2) * error * size * size <= S(0x1p-40) ? 0 : throw Undecided();
  }

  /// Lengths are computed only as far as they are needed. Where fast lengths have an error, the row may be on another
  /// segment.
  void place_by_length(const FastRow& row) {
    std::size_t number = row.segment.number;
    const auto at_key = [&](bool end) {
      segment_ = segment(number);
      sample_ = key_sample(end);
      key_at_end_ = end;
      sample_.s = length_to(number + (end ? 1 : 0));
    };
    if (row.number == SpecialRow::at_key) return at_key(false);
    if (row.number == SpecialRow::at_end && row.sample.at.w == 0) return at_key(true);
    if (row.part && row.part->distance == 0) {
      number = 0;
      return at_key(false);
    }
    const bool is_whole = row.part && row.part->distance == 1;
    if (is_whole || (rows_.arc->intervals != 0 && row.number == rows_.arc->intervals)) {
      number = curve_->size() - 1;
      while (number > 0 && arc(number).total().value == S(0)) --number;  // the earliest time of the length
      return at_key(true);
    }
    segment_ = segment(number);
    const S s = arc_length(row);
    while (number > 0 && compare(s, row.number, number) < 0) --number;
    while (number + 1 < curve_->size() && compare(s, row.number, number + 1) > 0) ++number;
    if (compare(s, row.number, number) <= 0) return at_key(false);
    if (compare(s, row.number, number + 1) >= 0) return at_key(true);
    segment_ = segment(number);
    sample_ = {};
    const S start = length_to(number), end = length_to(number + 1), into = s - start;
    if (into < S(0x1p-20) * (end - start)) {
      require_range(into / (end - start));
      sample_.at.u = place_near_start(into);
      sample_.at.w = sample_.at.u - S(1);
    } else {
      sample_.at = arc(number).place(start, end, s);
    }
    set_time_of_place();
    set_place_error(S(rounding) * s + errors_[number]);
    sample_.s = s;
  }

  /// Where lengths have an error, the place has that over the speed; less, where the curve nearly rests.
  void set_place_error(const S& error) {
    using std::abs;
    S speed(0), change(0), distance = std::min<S>(sample_.at.u, -sample_.at.w);
    for (const std::size_t i : rows_.metric) {
      const auto x = spline::local_derivatives(segment_.cubics[i], sample_.at);
      speed = std::max<S>(speed, abs(x.d1));
      change = std::max<S>(change, abs(x.d2));
    }
    auto& [place, eased, part] = place_error_;
    if (speed > S(0)) place = error / speed;
    if (change > S(0)) {
      const S at_rest = spline::square_root(error / change);
      place = speed > S(0) ? std::min<S>(place, at_rest) : at_rest;
    }
    eased = place / std::max<S>(distance, spline::square_root(place));
    if (change > S(0)) distance = std::min<S>(distance, speed / change);
    part = place < distance ? S(place / distance) : S(1);
  }

  /// Double-doubles lose digits of numbers far below 1, such as places next to a key.
  static void require_range(const S& place) {
    if constexpr (std::is_same_v<S, spline::DoubleDouble>) {
      if (std::abs(place.hi) < 0x1p-300) throw Undecided();
    }
  }

  S time(const Time& shown) const {
    if (!rows_.exact.decimal && !rows_.exact.channels.frames && shown.lo == 0) return scalar_of_double(shown.hi);
    return scalar_of<S>(exact_shown(shown));
  }
  static S scalar_of_double(double value) {
    if constexpr (spline::has_roots<S>) return S(value);
    return scalar_of<S>(Rational(value));
  }
  Rational exact_shown(const Time& shown) const {
    return exact_number(shown, rows_.exact.decimal, rows_.exact.channels.frames);
  }

  /// The sample at a time on the current segment.
  SampleOf<S> sample_at(const CurveSegment& fast, const Time& shown) const {
    if (shown == fast.start || shown == fast.end) return key_sample(shown != fast.start);
    return sample_inside(time(shown), [&] { return exact_shown(shown); });
  }

  SampleOf<S> sample_at(const Rational& exact) const {
    if (const auto end = key_at(exact)) return key_sample(*end);
    return sample_inside(scalar_of<S>(exact), [&] { return exact; });
  }

  /// The sample at a time on the current segment, as it is at this scalar, and as a rational by a function.
  SampleOf<S> sample_inside(const S& t, const auto& exact) const {
    const auto part = needs_ease_part() ? std::optional(ease_part(exact())) : std::nullopt;
    return {t, segment_.time_map()(t, part), std::nullopt, part};
  }

  /// Whether the current segment has an ease, between keys whose times no distance makes.
  bool needs_ease_part() const { return segment_.warp.has_ease() && !rows_.exact.exponent; }

  spline::Warp<Rational> exact_ease() const {
    const spline::Keys<Rational>& keys = rows_.exact.keys;
    const std::size_t number = segment_.number, next = number + 1 < keys.size() ? number + 1 : 0;
    return {keys.eases[number].out, keys.eases[next].in};
  }
  /// The part of the ease at a time on the current segment.
  spline::EasePart ease_part(const Rational& t) const {
    const Rational &start = rows_.times[segment_.number], &end = rows_.times[segment_.number + 1];
    return exact_ease().part(t - start, end - t, end - start, rows_.side);
  }
  /// The sample at the key at the end of the current segment, or at its start.
  SampleOf<S> key_sample(bool end) const {
    SampleOf<S> sample = sample_at_key(segment_, end);
    const spline::LocalParameter<Rational> place{end ? 1 : 0, end ? 0 : -1};
    if (needs_ease_part()) sample.part = exact_ease().part(place, rows_.side);
    return sample;
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
    const std::size_t number = row.segment.number;
    segment_ = segment(number);
    if (t != segment_.start) require_range(S(t - segment_.start) / S(segment_.end - segment_.start));
    const bool is_on_segment =
        !row.exact.time        ? shown >= row.segment.start && shown <= row.segment.end
        : rows_.exact.exponent ? t >= segment_.start && t <= segment_.end
                               : *row.exact.time >= rows_.times[number] && *row.exact.time <= rows_.times[number + 1];
    if (is_on_segment) {
      sample_ = row.exact.time ? sample_at(*row.exact.time) : sample_at(row.segment, shown);
    } else {
      place_outside(row.exact.time ? *row.exact.time : exact_shown(shown), t);
    }
    sample_.t = t;
  }

  /// Outside the curve, or on another segment. Times are rationals, where no distance makes them.
  void place_outside(const Rational& exact, const S& t) {
    const ExactCurve& curve = rows_.exact;
    if constexpr (spline::has_roots<S>) {
      if (curve.exponent) {
        const std::vector<S>& times = curve_->times();
        outside_ = map_to_curve<S>(curve.extrapolations, times.front(), times.back(), t);
        segment_ = segment(spline::segment_at_time<S>(times, outside_->t, rows_.side));
        sample_ = {t, segment_.time_map()(outside_->t)};
        return;
      }
    }
    const std::vector<Rational>& times = rows_.times;
    const OutsideOf<Rational> found = map_to_curve<Rational>(curve.extrapolations, times.front(), times.back(), exact);
    outside_ = {scalar_of<S>(found.t),
                scalar_of<S>(found.cycles),
                scalar_of<S>(found.beyond),
                found.holds,
                found.backward,
                found.odd};
    segment_ = segment(spline::segment_at_time<Rational>(times, found.t, rows_.side));
    sample_ = sample_at(found.t);
  }

  const RowsOfCurve& rows_;
  std::unique_ptr<const spline::CurveKeys<S>> curve_;
  std::map<std::size_t, Known> known_;
  spline::SegmentLength<S> passed_;
  std::vector<S> lengths_, errors_;  ///< up to each key, and bounds on their errors
  std::vector<S> cycle_;
  std::vector<spline::Quaternion<S>> turns_;
  Segment segment_;
  SampleOf<S> sample_, end_, measured_;
  std::optional<OutsideOf<S>> outside_;
  std::optional<MotionOf<S>> motion_;  ///< of a row at a pace
  PlaceError<S> place_error_;
  std::optional<bool> key_at_end_;  ///< of a row that is placed by length, where it is at a key
  Point<S> point_;
};

}  // namespace tcb
