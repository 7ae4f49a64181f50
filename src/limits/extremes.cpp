// Extremes: the certified maximum of a measure over a curve.
#include "limits/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "error.hpp"
#include "exact/rounding.hpp"

namespace tcb::limits {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 0x1p-40;      ///< relative: of the segments, and of hundreds of operations on them
constexpr std::size_t most_parts = 2000;  ///< that are bounded with rationals

/// A part of a piece of a segment with a measure on it in Bernstein's form, and how far rounding may move that.
struct Candidate {
  std::size_t segment, piece;  ///< their numbers
  Polynomial<double> value;
  bool is_certain = true;  ///< the piece is not so short that exact numbers may have none
  double slack = 0;
  double begin = 0, size = 1;  ///< of the part
  double upper = infinity;     ///< a bound

  /// The largest value at its ends, at least.
  double attained() const { return std::max(value.front(), value.back()) - slack; }
  bool is_narrow(double other) const { return !is_certain || upper - other <= 8 * slack; }
  bool operator<(const Candidate& other) const { return upper < other.upper; }
};

/// The parts that may hold the maximum of one measure.
class Search {
 public:
  explicit Search(const Measure& measure) : measure_(&measure) {}

  void add(const Piece<double>& piece, std::size_t segment) {
    const Measured<double> x = measured(piece, *measure_);
    constexpr double least = 1e-290;      // below it, squares may be 0
    constexpr double shortest = 0x1p-40;  // of pieces that are certain
    Candidate one{segment, piece.number, bernstein(x.value, x.value.size() - 1), piece.size > shortest};
    one.slack = x.scale == 0 ? 0 : rounding * x.scale + least;
    if (!std::isfinite(x.scale)) {
      candidates_.push_back(std::move(one));  // doubles do not bound it
      return;
    }
    add(std::move(one));
    if (candidates_.size() < 2 * kept_ + 64) return;
    std::erase_if(candidates_, [this](const Candidate& other) { return !(other.upper >= attained_); });
    kept_ = candidates_.size();
  }

  /// The parts that are left, those with the largest bounds first; if there are more than `most_parts`, the last one
  /// bounds those that are not among them.
  std::vector<Candidate> rest() {
    std::vector<Candidate> final;
    std::priority_queue<Candidate> queue({}, std::exchange(candidates_, {}));
    while (!queue.empty() && final.size() <= most_parts) {
      Candidate top = queue.top();
      queue.pop();
      if (!(top.upper >= attained_)) break;
      constexpr double smallest = 0x1p-30;
      if (!std::isfinite(top.slack) || top.size <= smallest || top.is_narrow(attained_)) {
        final.push_back(std::move(top));
        continue;
      }
      const auto [left, right] = halves(top.value);
      for (const bool second : {false, true}) {
        Candidate half = top;
        half.size = top.size / 2;
        if (second) half.begin += half.size;
        half.value = second ? right : left;
        add(std::move(half));
      }
      for (Candidate& half : candidates_) queue.push(std::move(half));
      candidates_.clear();
    }
    std::erase_if(final, [this](const Candidate& one) { return !(one.upper >= attained_); });
    return final;
  }

 private:
  void add(Candidate&& one) {
    one.upper = *std::ranges::max_element(one.value) + one.slack;
    if (!(one.upper > attained_)) return;
    if (one.is_certain) attained_ = std::max(attained_, one.attained());
    candidates_.push_back(std::move(one));
  }

  const Measure* measure_;
  std::vector<Candidate> candidates_;
  std::size_t kept_ = 0;
  double attained_ = -infinity;
};

/// x on [begin, begin + size], as a polynomial on [0, 1].
Polynomial<Rational> part_of(const Polynomial<Rational>& x, const Rational& begin, const Rational& size) {
  Polynomial<Rational> part = shifted(x, begin);
  Rational power = 1;
  for (Rational& coefficient : part) {
    coefficient *= power;
    power *= size;
  }
  return part;
}

/// A bound of x on [0, 1]: the largest coefficient of Bernstein's form.
Rational bound_of(const Polynomial<Rational>& x) {
  const Polynomial<Rational> form = bernstein(x, x.size() - 1);
  return *std::max_element(form.begin(), form.end());
}

/// The simplest fraction between two numbers.
Rational simplest_within(const Rational& low, const Rational& high) {
  if (low > 0) return simplest_between(low, high);
  return high < 0 ? -simplest_between(-high, -low) : Rational(0);
}

/// The maximum on [0, 1], which is within [low, high], if it is a simple fraction; its place may be irrational. There x
/// less the maximum has a double root, and x is concave.
std::optional<Rational> simple_maximum(const Polynomial<Rational>& x, const Rational& low, const Rational& high) {
  const Rational simplest = simplest_within(low, high), size = denominator(simplest);
  if (size * size * (high - low) > Rational(0x1p-20)) return std::nullopt;  // as simple as that of any such interval
  const Polynomial<Rational> rate = derivative(x);
  if (!(bound_of(derivative(rate)) < 0)) return std::nullopt;
  const Polynomial<Rational> root = common_divisor(sum(x, {simplest}, Rational(-1)), rate);
  return value_at(root, Rational(0)) * value_at(root, Rational(1)) <= 0 ? std::optional(simplest) : std::nullopt;
}

/// Bounds parts of pieces with rationals.
class ExactSearch {
 public:
  std::optional<Extreme> best;
  Rational place;  ///< of the best, in its piece
  std::size_t best_candidate = 0;

  void add(const Polynomial<Rational>& x, const Candidate& part, std::size_t number) {
    candidate_ = number;
    bound(part_of(x, Rational(part.begin), Rational(part.size)), Rational(part.begin), Rational(part.size), 0);
  }

 private:
  void attain(const Rational& value, const Rational& where) {
    if (best && value <= best->low) return;
    best = Extreme{value, best ? std::max(best->high, value) : value, {}};
    place = where;
    best_candidate = candidate_;
  }

  /// Bounds the part [begin, begin + size], on which the measure is x(0) to x(1): in this form its coefficients have
  /// the size of what changes on the part, whatever they have on the piece. Where the derivative is nearly 0 at an end,
  /// the coefficients of Bernstein's form are nearly the value there at most.
  void bound(const Polynomial<Rational>& x, const Rational& begin, const Rational& size, int depth) {
    static const Rational close = Rational(0x1p-80), half = Rational(1) / 2;
    const Rational at = likely_place(x, begin, size), value = value_at(x, at);
    attain(value, begin + at * size);
    const Rational most = std::max(at < 1 ? bound_of(part_of(x, at, 1 - at)) : value,
                                   at > 0 ? bound_of(part_of(x, Rational(0), at)) : value);
    constexpr int deepest = 120;
    if (most <= best->low) return;
    if (depth == deepest || most - best->low <= close * abs(most)) {
      if (const auto exact = simple_maximum(x, value, most)) return attain(*exact, begin + at * size);
      best->high = std::max(best->high, most);
      return;
    }
    const auto bound_half = [&](const Rational& first) {
      bound(part_of(x, first, half), begin + first * size, size * half, depth + 1);
    };
    const bool is_first = at < half;  // the half that has the largest value, probably
    bound_half(is_first ? Rational(0) : half);
    bound_half(is_first ? half : Rational(0));
  }

  /// Where the largest value on [0, 1] probably is: the root of the derivative, where it is one at the simplest
  /// fraction of the piece near it, or better by a step of Newton's method.
  static Rational likely_place(const Polynomial<Rational>& x, const Rational& begin, const Rational& size) {
    Rational largest = 0;
    for (std::size_t i = 1; i < x.size(); ++i) largest = std::max(largest, abs(x[i]));
    if (largest == 0) return 0;
    const Polynomial<Rational> exact = derivative(x);
    Polynomial<double> rate(exact.size());
    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] = nearest_double(exact[i] / largest);
    if (!(value_at(rate, 0.0) > 0)) return 0;
    if (value_at(rate, 1.0) > 0) return 1;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      if (middle == low || middle == high) break;
      (value_at(rate, middle) > 0 ? low : high) = middle;
    }
    const auto is_inside = [](const Rational& u) { return 0 <= u && u <= 1; };
    const Rational rough(low), fraction = begin + rough * size, near = std::min(Rational(0x1p-36), size / 4);
    const Rational simplest = fraction <= near ? Rational(0) : simplest_between(fraction - near, fraction + near);
    const Rational simple = (simplest - begin) / size;
    if (is_inside(simple) && value_at(exact, simple) == 0) return simple;
    const Rational bend = value_at(derivative(exact), rough);
    if (bend == 0) return rough;
    const Rational step = -value_at(exact, rough) / bend;
    const bool is_quadratic = x.size() == 3;
    const Rational better = rough + (is_quadratic ? step : Rational(nearest_double(step)));
    return is_inside(better) ? better : rough;
  }

  std::size_t candidate_ = 0;
};

Rational exactly(const Time& time, const std::optional<FrameTimes>& frames) {
  const auto frame = frames ? frames->exact(time) : std::nullopt;
  return frame ? *frame : Rational(time.hi) + Rational(time.lo);
}

/// The fractions of the duration of a segment that are measured; nothing: none.
std::optional<std::pair<Rational, Rational>> fractions(const MeasuredCurve& curve, const Rational& start,
                                                       const Rational& end) {
  if ((curve.from && end <= *curve.from) || (curve.to && start >= *curve.to)) return std::nullopt;
  Rational first = 0, last = 1;
  if (curve.from && start < *curve.from) first = (*curve.from - start) / (end - start);
  if (curve.to && *curve.to < end) last = (*curve.to - start) / (end - start);
  return std::pair(first, last);
}

/// Lists the keys at which velocities jump.
class Corners {
 public:
  explicit Corners(const std::vector<std::size_t>& channels) : channels_(channels) {}

  std::vector<Corner> found;

  void add(const std::vector<Piece<double>>& pieces, const Time& start) {
    if (pieces.empty()) return;
    const std::vector<End> out = ends(pieces.front(), false);
    if (first_.empty()) first_ = out;
    if (!before_.empty()) compare(before_, out, start);
    before_ = ends(pieces.back(), true);
  }
  void close(const Time& end) {
    if (!first_.empty()) compare(before_, first_, end);
  }

 private:
  struct End {
    double velocity, size;
  };

  std::vector<End> ends(const Piece<double>& piece, bool at_end) const {
    std::vector<End> result;
    for (const std::size_t channel : channels_) {
      const auto [rate, sizes] = rate_of(piece, channel, 1);
      result.push_back({value_at(rate, at_end ? 1.0 : 0.0), sizes});
    }
    return result;
  }

  void compare(const std::vector<End>& in, const std::vector<End>& out, const Time& time) {
    Corner corner{time, 0, {}};
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const double jump = std::abs(out[i].velocity - in[i].velocity);
      if (!(jump > rounding * std::max(out[i].size, in[i].size))) continue;
      corner.jump = std::hypot(corner.jump, jump);
      corner.channels.push_back(channels_[i]);
    }
    if (!corner.channels.empty()) found.push_back(std::move(corner));
  }

  const std::vector<std::size_t>& channels_;
  std::vector<End> first_, before_;
};

/// The maximum among the parts that may hold it.
std::optional<Extreme> exact_maximum(const std::vector<Candidate>& parts, const Measure& measure,
                                     const MeasuredCurve& curve,
                                     const std::function<const spline::Segments<Rational>&(std::size_t)>& segment) {
  const auto piece_of = [&](const Candidate& part) -> std::optional<Piece<Rational>> {
    const spline::Segments<Rational>& one = segment(part.segment);
    const Rational duration = one.times[1] - one.times[0];
    const auto range = fractions(curve, one.times[0], one.times[1]).value_or(std::pair<Rational, Rational>(0, 1));
    const auto pieces = pieces_of(one, 0, duration == 0 ? Rational(1) : duration, range.first, range.second);
    const auto found = std::ranges::find(pieces, part.piece, &Piece<Rational>::number);
    return found == pieces.end() ? std::nullopt : std::optional(*found);
  };
  ExactSearch search;
  for (std::size_t i = 0; i < std::min(parts.size(), most_parts); ++i) {
    if (const auto piece = piece_of(parts[i])) search.add(measured(*piece, measure).value, parts[i], i);
  }
  if (!search.best) return std::nullopt;
  Extreme& best = *search.best;
  if (parts.size() > most_parts) {
    if (!std::isfinite(parts.back().upper)) {
      throw data_error("numbers are too far apart to bound; expected fewer such keys");
    }
    best.high = std::max(best.high, Rational(parts.back().upper));
  }
  const Candidate& part = parts[search.best_candidate];
  const Piece<Rational> piece = *piece_of(part);
  const Rational fraction = piece.begin + search.place * piece.size;
  const spline::Segments<Rational>& one = segment(part.segment);
  best.time = one.times[0] + fraction * (one.times[1] - one.times[0]);
  best.is_at_key = fraction == 0 || fraction == 1;
  if (fraction == 1) best.side = spline::Side::left;
  for (const Polynomial<Rational>& x : piece.cubics) {
    best.position.push_back(nearest_double(value_at(x, search.place)));
  }
  return search.best;
}

}  // namespace

Extremes extremes(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                  const std::vector<std::size_t>& channels) {
  std::vector<Search> searches(measures.begin(), measures.end());
  Corners corners(channels);
  const Source<SegmentBlock> blocks = curve.segments();
  std::size_t number = 0;
  Time end;
  while (const std::optional<SegmentBlock> block = blocks()) {
    const spline::Segments<double>& segments = block->segments;
    for (std::size_t i = 0; i < segments.size(); ++i, ++number) {
      const Time start = segments.times[i];
      end = segments.times[i + 1];
      double first = 0, last = 1;
      if (curve.from || curve.to) {
        const auto part = fractions(curve, exactly(start, curve.frames), exactly(end, curve.frames));
        if (!part) continue;
        first = nearest_double(part->first);
        last = nearest_double(part->second);
      }
      const Time duration = curve.frames ? curve.frames->elapsed(end) - curve.frames->elapsed(start) : end - start;
      const std::vector<Piece<double>> pieces =
          pieces_of(segments, i, duration.hi > 0 ? duration.hi : 1.0, first, last);
      for (Search& search : searches) {
        for (const Piece<double>& piece : pieces) search.add(piece, number);
      }
      corners.add(pieces, start);
    }
  }
  if (curve.closed && !curve.from && !curve.to) corners.close(end);
  std::map<std::size_t, spline::Segments<Rational>> exact;
  const auto exact_segment = [&](std::size_t segment) -> const spline::Segments<Rational>& {
    const auto found = exact.find(segment);
    return found != exact.end() ? found->second : exact.emplace(segment, curve.exact(segment)).first->second;
  };
  Extremes result;
  for (std::size_t k = 0; k < measures.size(); ++k) {
    result.maxima.push_back(exact_maximum(searches[k].rest(), measures[k], curve, exact_segment));
  }
  result.corners = std::move(corners.found);
  return result;
}

}  // namespace tcb::limits
