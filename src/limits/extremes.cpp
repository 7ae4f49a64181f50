// Extremes: the certified maximum of a measure over a curve.
//
// On a piece a measure is a polynomial, or a quotient of two, in Bernstein's form: its coefficients bound it, and the
// first and the last one are attained (Form). Search divides pieces where the maximum probably is, until no bound is
// far above the best value that is attained. extremes() does this with doubles, for all segments. Of those that are
// left, with_balls() bounds many with double-doubles, and exact_maximum() the last few with rationals, or where a
// direction is measured with floats of many digits.
#include "limits/extremes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/exact_keys.hpp"
#include "limits/ball.hpp"
#include "limits/form.hpp"
#include "limits/search.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::limits {
namespace {

// The keys at which velocities change by more than 2^-40 of their size, which is more than rounding.

/// The root of a sum of squares, which do not overflow.
double root_of_squares(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  if (largest == 0 || !std::isfinite(largest)) return largest;
  const double unit = spline::power_of_two_below(largest);
  spline::DoubleDouble squares;
  for (const double x : numbers) squares = squares + spline::DoubleDouble(x / unit) * spline::DoubleDouble(x / unit);
  return sqrt(squares).hi * unit;
}

/// Finds the corners of a curve, segment after segment.
class Corners {
 public:
  /// The velocities at an end of a segment, and the sizes of their terms.
  struct End {
    std::vector<double> velocities, sizes;
  };
  struct Ends {
    End start, end;
  };

  explicit Corners(const std::vector<std::size_t>& channels) : channels_(channels) {}

  std::vector<Corner> found;

  /// Of a segment, by its pieces.
  Ends ends_of(const std::vector<Piece<double>>& pieces) const {
    return {end_of(pieces.front(), 0), end_of(pieces.back(), 1)};
  }
  /// Adds the next segment, which starts at this time.
  void add(const Ends& ends, const Time& start) {
    if (!first_) first_ = ends.start;
    if (before_) compare(*before_, ends.start, start);
    before_ = ends.end;
  }
  /// The curve is closed, and back at its start at this time.
  void close(const Time& end) {
    if (first_) compare(*before_, *first_, end);
  }

 private:
  End end_of(const Piece<double>& piece, double at) const {
    End end;
    for (const std::size_t channel : channels_) {
      const Polynomial<double> rate = rate_of(piece, channel, 1);
      end.velocities.push_back(value_at(rate, at));
      end.sizes.push_back(scale_of(rate, piece, channel, 1));
    }
    return end;
  }

  void compare(const End& in, const End& out, const Time& time) {
    Corner corner{time, 0, {}, in.velocities, out.velocities};
    std::vector<double> jumps;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const double jump = std::abs(out.velocities[i] - in.velocities[i]);
      if (!(jump > relative_rounding * std::max(out.sizes[i], in.sizes[i]))) continue;
      jumps.push_back(jump);
      corner.channels.push_back(channels_[i]);
    }
    corner.jump = root_of_squares(jumps);
    if (!jumps.empty()) found.push_back(std::move(corner));
  }

  const std::vector<std::size_t>& channels_;
  std::optional<End> first_, before_;
};

/// The largest of the bounds on pieces; nothing where one is not known.
template <class S, class BoundOn>
auto largest_of(const std::vector<Piece<S>>& pieces, const BoundOn& bound_on) {
  auto largest = bound_on(pieces.front());
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const auto bound = bound_on(pieces[i]);
    largest = largest && bound ? std::max(largest, bound) : std::nullopt;
  }
  return largest;
}

/// Bounds of the derivatives of the channels of a piece, with room for rounding.
class Ranges {
 public:
  explicit Ranges(const Piece<double>& piece) : piece_(piece), known_(4 * piece.cubics.size()) {}

  /// No value of the measure is larger; nothing where none is known.
  std::optional<double> bound_of(const Measure& measure) {
    if (measure.is_of_direction()) return std::nullopt;
    double squares = 0;
    for (const std::size_t channel : measure.channels) {
      const auto [low, high] = of(channel, measure.derivative);
      if (!measure.is_size()) return measure.kind == Measure::Kind::smallest ? -low : high;
      if (low != 0 || high != 0)
        squares += power_of(std::max(-low, high), 2) * (1 + relative_rounding) + smallest_square;
    }
    return squares;
  }

 private:
  using Range = std::pair<double, double>;

  const Range& of(std::size_t channel, int order) {
    std::optional<Range>& range = known_[4 * channel + static_cast<std::size_t>(order)];
    if (!range) {
      const Polynomial<double> rate = rate_of(piece_, channel, order), form = bernstein(rate, rate.size() - 1);
      const auto [low, high] = std::ranges::minmax_element(form);
      const double slack = slack_of(scale_of(rate, piece_, channel, order));
      range = Range{*low - slack, *high + slack};
    }
    return *range;
  }

  const Piece<double>& piece_;
  std::vector<std::optional<Range>> known_;
};

/// A bound on a piece by doubles, which also tells the search of values that are attained.
std::optional<double> bound_on(const Piece<double>& piece, const Measure& measure, Ranges& ranges,
                               Search<double>& search) {
  const std::optional<double> rough = ranges.bound_of(measure);
  if (search.is_below(rough)) return rough;
  const Measured<double> x = measured(piece, measure);
  if (!std::isfinite(x.scale)) return std::nullopt;  // doubles do not bound it
  constexpr double shortest = 0x1p-40;               // of pieces that certainly exist, whatever the rounding
  return search.bound(form_of(x), {}, {}, piece.size > shortest);
}

/// Segments that have occurred before, by all their numbers.
class Repeats {
 public:
  /// The number of an equal segment, or of this one; nothing for further ones, when there are many.
  template <class S>
  std::optional<std::size_t> find(const spline::Segments<S>& segments, std::size_t number, const S& duration) {
    bytes_.clear();
    add(duration);
    for (const auto& [begin, size, parameter] : parts_of(segments.warp(number))) {
      for (const S& x : parameter) add(x);
    }
    for (const spline::Cubic<S>& x : segments[number]) {
      for (const S& coefficient : {x.p0, x.out, x.c, x.c_low, x.d, x.in}) add(coefficient);
    }
    const auto known = known_.find(bytes_);
    if (known != known_.end()) return known->second;
    constexpr std::size_t most = 5000;
    if (known_.size() == most) return std::nullopt;
    return known_.emplace(bytes_, known_.size()).first->second;
  }

 private:
  void add(double x) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(x);
    bytes_.append(bytes.data(), bytes.size());
  }
  void add(const Ball& x) {
    for (const double part : {x.middle().hi, x.middle().lo, x.radius()}) add(part);
  }

  std::string bytes_;
  std::unordered_map<std::string, std::size_t> known_;
};

/// Where a curve rests at a place at which it has a curvature before and after it, so that this has no bound; its
/// velocity has a factor that is 0 there.
std::optional<Rational> sharp_rest(const Piece<Rational>& piece, const Measure& measure) {
  Polynomial<Rational> common{0};
  for (const std::size_t channel : measure.channels) {
    common = common_divisor(common, derivative(piece.cubics[channel]));
  }
  if (common.size() != 2) return std::nullopt;
  const Rational root = -common[0] / common[1];
  Rational low = 0, high = 1;
  if (root < value_at(piece.parameter, low) || root > value_at(piece.parameter, high)) return std::nullopt;
  if (root == value_at(piece.parameter, high)) return high;
  for (int i = 0; i < 60 && value_at(piece.parameter, low) != root; ++i) {
    const Rational middle = (low + high) / 2;
    (value_at(piece.parameter, middle) <= root ? low : high) = middle;
  }
  return low;
}

/// The fractions of the duration of a segment that are measured; nothing: none.
template <class S>
std::optional<std::pair<S, S>> fractions(const MeasuredCurve& curve, const S& start, const S& end) {
  std::pair<S, S> part(0, 1);
  if (curve.from) {
    const S from = scalar_of<S>(*curve.from);
    if (end <= from) return std::nullopt;
    if (start < from) part.first = (from - start) / (end - start);
  }
  if (curve.to) {
    const S to = scalar_of<S>(*curve.to);
    if (start >= to) return std::nullopt;
    if (to < end) part.second = (to - start) / (end - start);
  }
  return part;
}

/// The pieces of a segment of its own that are measured.
template <class S>
std::vector<Piece<S>> measured_pieces(const MeasuredCurve& curve, const spline::Segments<S>& one) {
  const S duration = one.times[1] - one.times[0];
  const auto range = fractions(curve, one.times[0], one.times[1]);
  if (!range) return {};
  return pieces_of(one, 0, duration == S(0) ? S(1) : duration, range->first, range->second);
}

/// Bounds the segments that are left with double-doubles. Those that are beyond these keep the bounds by doubles.
std::vector<Search<spline::DoubleDouble>> with_balls(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                                                     std::vector<Search<double>>& rough) {
  using Number = spline::DoubleDouble;
  constexpr std::size_t few = 20;                           // segments, which need no bounds before the exact ones
  std::vector<std::span<const Search<double>::Part>> left;  // not yet bounded
  std::vector<bool> is_bounded;
  std::vector<std::size_t> segments;  // that are left of any measure
  for (std::size_t k = 0; k < measures.size(); ++k) {
    left.emplace_back(rough[k].rest());
    is_bounded.push_back(!measures[k].is_of_direction() && left[k].size() > few);
    for (const auto& part : left[k]) segments.push_back(part.segment);
  }
  std::ranges::sort(segments);
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  std::vector<Search<Number>> searches(measures.size());
  using Known = std::vector<std::optional<Number>>;  // bounds on a segment, for the measures
  std::vector<Known> known;
  Repeats repeats;
  for (const std::size_t segment : segments) {
    const auto is_left = [&](std::size_t k) { return !left[k].empty() && left[k].front().segment == segment; };
    bool is_needed = false;
    for (std::size_t k = 0; k < measures.size(); ++k) is_needed = is_needed || (is_bounded[k] && is_left(k));
    std::vector<Piece<Ball>> pieces;
    Known once(measures.size());
    Known* found = &once;
    try {
      if (is_needed) {
        const spline::Segments<Ball> one = curve.in_balls(segment);
        pieces = measured_pieces(curve, one);
        const bool may_repeat = !curve.from && !curve.to;
        const auto number = may_repeat ? repeats.find(one, 0, one.times[1] - one.times[0]) : std::nullopt;
        if (number == known.size()) known.push_back(once);
        if (number) found = &known[*number];
      }
    } catch (const Undecided&) {
    }
    for (std::size_t k = 0; k < measures.size(); ++k) {
      if (!is_left(k)) continue;
      std::optional<Number>& upper = (*found)[k];
      try {
        if (is_bounded[k] && !upper && !pieces.empty()) {
          upper = largest_of(pieces, [&](const Piece<Ball>& piece) {
            return searches[k].bound(form_of(measured(piece, measures[k])), {}, {});
          });
        }
      } catch (const Undecided&) {
      }
      searches[k].add(segment, upper ? upper : left[k].front().upper);
      left[k] = left[k].subspan(1);
    }
  }
  return searches;
}

/// Bounds the change of a direction on a piece with balls. The place on the piece where it has no bound, if there is
/// one. Throws: Undecided where that needs more digits.
template <class M>
std::optional<Rational> bound_with_balls(Search<Rational>& search, std::optional<Rational>& high,
                                         const Piece<Rational>& piece, const Measure& measure, const Place& place,
                                         bool is_last) {
  using S = BallOf<M>;
  const Measured<S> x = measured_direction<S>(piece, measure, [](const Polynomial<Rational>& of) {
    Polynomial<S> result(of.size());
    std::ranges::transform(of, result.begin(), scalar_of<S>);
    return result;
  });
  const auto rest = x.power == 3 ? sharp_rest(piece, measure) : std::nullopt;
  if (!rest) high = std::max(high, search.bound(form_of(x), place, {Middle<M>::bits() * 3 / 10, is_last}));
  return rest;
}

/// Bounds a piece with as many digits as it needs, as bound_with_balls() does.
std::optional<Rational> bound_exactly(Search<Rational>& search, std::optional<Rational>& high,
                                      const Piece<Rational>& piece, const Measure& measure, const Place& place) {
  if (!measure.is_of_direction()) {
    high = std::max(high, search.bound(form_of(measured(piece, measure)), place, {600, true}));
    return std::nullopt;
  }
  try {
    return bound_with_balls<spline::DoubleDouble>(search, high, piece, measure, place, false);
  } catch (const Undecided&) {
  }
  try {
    return bound_with_balls<WideFloat>(search, high, piece, measure, place, false);
  } catch (const Undecided&) {
  }
  return bound_with_balls<LastFloat>(search, high, piece, measure, place, true);
}

/// The maximum among the segments that may hold it. Throws: Undecided where numbers are too far apart for any digits.
std::optional<Extreme> exact_maximum(std::vector<Search<spline::DoubleDouble>::Part> parts, const Measure& measure,
                                     const MeasuredCurve& curve) {
  const auto exact = [&](std::size_t segment) { return curve.exact(segment); };
  const auto extreme_at = [&](Extreme extreme, const Place& of_piece, const Rational& place) {
    const spline::Segments<Rational> one = exact(of_piece.segment);
    const Piece<Rational> piece = measured_pieces(curve, one)[of_piece.piece];
    if (measure.is_of_direction() && !extreme.is_unbounded) extreme.low = measured(piece, measure).at(place);
    const Rational fraction = piece.begin + place * piece.size;
    extreme.time = one.times[0] + fraction * (one.times[1] - one.times[0]);
    extreme.side = place == 1 ? spline::Side::left : spline::Side::right;
    const bool is_between_parts = measure.derivative > 1 && (place == 0 || place == 1);  // of an ease
    extreme.is_at_key = fraction == 0 || fraction == 1 || is_between_parts;
    const Rational u = value_at(piece.parameter, place);
    for (const Polynomial<Rational>& x : piece.cubics) extreme.position.push_back(nearest_double(value_at(x, u)));
    return extreme;
  };
  std::ranges::stable_sort(parts, [](const auto& a, const auto& b) {
    return b.upper && (!a.upper || *a.upper > *b.upper);  // those without a bound first
  });
  constexpr std::size_t few = 100, most = 2000;  // segments that are bounded with exact numbers
  Search<Rational> search;
  std::optional<Rational> high;
  std::vector<std::vector<Polynomial<Rational>>> bounded;  // pieces, which repeat where a motion does
  const auto may_matter = [&](std::size_t i) {             // for 15 digits, or for the limit
    if (!parts[i].upper || !search.best) return i < most;
    const Rational upper = exactly(*parts[i].upper), &value = search.best->value;
    if (measure.limit && value <= *measure.limit && *measure.limit < upper) return true;
    return i < most && upper > value + abs(value) * Rational(0x1p-70);
  };
  std::size_t i = 0;
  for (; i < parts.size() && (i < few || may_matter(i)); ++i) {
    const std::vector<Piece<Rational>> pieces = measured_pieces(curve, exact(parts[i].segment));
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      std::vector<Polynomial<Rational>> numbers{{pieces[k].duration}, pieces[k].parameter};
      for (const std::size_t channel : measure.channels) numbers.push_back(pieces[k].cubics[channel]);
      if (std::ranges::find(bounded, numbers) != bounded.end()) continue;
      if (bounded.size() < most) bounded.push_back(std::move(numbers));
      const Place place{parts[i].segment, k};
      const auto rest = bound_exactly(search, high, pieces[k], measure, place);
      if (rest) return extreme_at({.is_unbounded = true}, place, *rest);
    }
  }
  if (!search.best) return std::nullopt;
  if (i < parts.size()) {
    if (!parts[i].upper) throw Undecided();
    high = std::max(*high, exactly(*parts[i].upper));
  }
  const auto& [value, piece, place] = *search.best;
  return extreme_at({value, std::max(value, *high), {}}, piece, place);
}

}  // namespace

bool Corner::turns(const std::vector<std::size_t>& compared, const std::vector<std::size_t>& measured) const {
  std::vector<double> before, after, change;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (std::ranges::count(measured, compared[i]) == 0) continue;
    before.push_back(in[i]);
    after.push_back(out[i]);
  }
  const double before_size = root_of_squares(before), after_size = root_of_squares(after);
  if (before_size == 0 || after_size == 0) return false;
  for (std::size_t i = 0; i < before.size(); ++i) change.push_back(before[i] / before_size - after[i] / after_size);
  return root_of_squares(change) > 0x1p-40;
}

Extremes extremes(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                  const std::vector<std::size_t>& channels) {
  struct Known {
    std::vector<std::optional<double>> upper;  ///< bounds for the measures
    Corners::Ends ends;
  };
  std::vector<Search<double>> searches(measures.size());
  Corners corners(channels);
  Repeats repeats;
  std::vector<Known> known;
  const auto found_on = [&](const std::vector<Piece<double>>& pieces) {
    Known found{{}, corners.ends_of(pieces)};
    std::vector<Ranges> ranges(pieces.begin(), pieces.end());
    for (std::size_t k = 0; k < measures.size(); ++k) {
      found.upper.push_back(largest_of(pieces, [&](const Piece<double>& piece) {
        return bound_on(piece, measures[k], ranges[static_cast<std::size_t>(&piece - pieces.data())], searches[k]);
      }));
    }
    return found;
  };
  const Source<SegmentBlock> blocks = curve.segments();
  std::size_t segment = 0;
  Time end;
  while (const std::optional<SegmentBlock> block = blocks()) {
    const spline::Segments<double>& segments = block->segments;
    for (std::size_t i = 0; i < segments.size(); ++i, ++segment) {
      const Time start = segments.times[i];
      end = segments.times[i + 1];
      const Time elapsed = curve.frames ? curve.frames->elapsed(end) - curve.frames->elapsed(start) : end - start;
      const double duration = elapsed.hi > 0 ? elapsed.hi : 1.0;
      std::pair<double, double> range(0, 1);
      std::optional<std::size_t> number;
      if (curve.from || curve.to) {
        const auto part =
            fractions(curve, exact_number(start, false, curve.frames), exact_number(end, false, curve.frames));
        if (!part) continue;
        range = {nearest_double(part->first), nearest_double(part->second)};
      } else {
        number = repeats.find(segments, i, duration);
      }
      Known once;
      const bool is_new = !number || *number == known.size();
      if (is_new) {
        const std::vector<Piece<double>> pieces = pieces_of(segments, i, duration, range.first, range.second);
        if (pieces.empty()) continue;
        once = found_on(pieces);
      }
      if (is_new && number) known.push_back(once);
      const Known& found = is_new ? once : known[*number];
      for (std::size_t k = 0; k < measures.size(); ++k) searches[k].add(segment, found.upper[k]);
      corners.add(found.ends, start);
    }
  }
  if (curve.closed && !curve.from && !curve.to) corners.close(end);
  Extremes result;
  std::vector<Search<spline::DoubleDouble>> left = with_balls(curve, measures, searches);
  for (std::size_t k = 0; k < measures.size(); ++k) {
    try {
      result.maxima.push_back(exact_maximum(left[k].rest(), measures[k], curve));
    } catch (const Undecided&) {
      result.maxima.push_back(Extreme{.is_unproved = true});
    }
  }
  result.corners = std::move(corners.found);
  return result;
}

}  // namespace tcb::limits
