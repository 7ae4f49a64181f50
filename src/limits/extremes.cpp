// Extremes: the certified maximum of a measure over a curve.
#include "limits/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <type_traits>
#include <utility>

#include "error.hpp"
#include "exact/ball.hpp"
#include "exact/rounding.hpp"

namespace tcb::limits {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 0x1p-40;      ///< relative: of the segments, and of hundreds of operations on them
constexpr std::size_t most_parts = 2000;  ///< that are bounded with rationals

/// The power of a polynomial in Bernstein's form, times the binomials.
template <class S>
Polynomial<S> power_of(const Polynomial<S>& form, int power) {
  const Polynomial<S> base = with_binomials(form);
  Polynomial<S> result{S(1)};
  for (int i = 0; i < power; ++i) result = product(result, base);
  return result;
}

/// The numbers of a segment and of a piece of it.
struct Place {
  std::size_t segment, piece;
};

/// A part of a piece with a measure on it in Bernstein's form, and how far rounding may move that.
struct Candidate {
  Polynomial<double> over{0}, base{0};
  int power = 0;
  bool is_certain = true;  ///< the piece is not so short that exact numbers may have none
  double slack = 0, base_slack = 0;
  double begin = 0, size = 1;                  ///< of the part
  double upper = infinity, doubt = 0;          ///< a bound, and how far rounding may move it
  const std::vector<Place>* places = nullptr;  ///< of all pieces with this measure
  Place place = {};                            ///< one of them

  /// A quotient is at most the largest of those of the coefficients, or of them with binomials.
  void set_bound() {
    upper = infinity;
    doubt = 0;
    if (power == 0) {
      upper = *std::ranges::max_element(over) + slack;
      doubt = 8 * slack;
      return;
    }
    Polynomial<double> least = base;
    for (double& x : least) x -= base_slack;
    const double smallest = *std::ranges::min_element(least);
    if (!(smallest > 0)) return;  // it may be 0 there
    const Polynomial<double> below = power_of(least, power), above = with_binomials(over);
    upper = -infinity;
    double binomial = 1;
    for (std::size_t i = 0; i < over.size(); ++i) {
      const double most = above[i] + slack * binomial;
      upper = std::max(upper, std::max(0.0, most) / below[i] * (1 + rounding));
      binomial *= static_cast<double>(over.size() - 1 - i) / static_cast<double>(i + 1);
    }
    doubt = 8 * (slack / std::pow(smallest, power) + power * upper * (base_slack / smallest + rounding));
  }
  /// The largest value at its ends, at least.
  double attained() const {
    const auto at_end = [&](double x, double y) {
      return power == 0 ? x - slack : std::max(0.0, x - slack) / std::pow(y + base_slack, power) * (1 - rounding);
    };
    return std::max(at_end(over.front(), base.front()), at_end(over.back(), base.back()));
  }
  bool is_narrow(double other) const { return !is_certain || upper - other <= doubt; }
  bool operator<(const Candidate& other) const { return upper < other.upper; }
};

/// An order of measures in which only equal ones are equivalent.
struct ByMeasure {
  bool operator()(const Candidate& a, const Candidate& b) const {
    const auto numbers = [](const Candidate& x) {
      return std::tie(x.upper, x.power, x.over, x.base, x.slack, x.base_slack, x.is_certain);
    };
    return numbers(a) < numbers(b);
  }
};

/// The parts that may hold the maximum of one measure.
class Search {
 public:
  explicit Search(const Measure& measure) : measure_(&measure) {}

  void add(const Piece<double>& piece, std::size_t segment) {
    const Measured<double> x = measured(piece, *measure_);
    constexpr double least = 1e-290;      // below it, squares may be 0
    constexpr double shortest = 0x1p-40;  // of pieces that are certain
    const std::size_t base_degree = x.base.size() - 1, of_power = base_degree * static_cast<std::size_t>(x.power);
    Candidate one;
    if (std::isfinite(x.scale)) {
      one.over = bernstein(x.over, std::max(x.over.size() - 1, of_power));
      one.base = bernstein(x.base, base_degree);
      one.power = x.power;
      one.is_certain = piece.size > shortest;
      one.slack = x.scale == 0 ? 0 : rounding * x.scale + least;
      one.base_slack = rounding * x.base_scale;
      if (!may_be_largest(one)) return;
    } else {
      one.slack = infinity;  // doubles do not bound it
    }
    std::vector<Place>& places = pieces_[one];
    if (places.size() <= most_parts) places.push_back({segment, piece.number});
    if (pieces_.size() < 2 * kept_ + 64) return;
    std::erase_if(pieces_, [this](const auto& other) { return !(other.first.upper >= attained_); });
    kept_ = pieces_.size();
  }

  /// The parts that are left, those with the largest bounds first; if there are more than `most_parts`, the last one
  /// bounds those that are not among them. Outlived by this, for their places.
  std::vector<Candidate> rest() {
    std::vector<Candidate> final;
    std::priority_queue<Candidate> queue;
    for (const auto& [piece, places] : pieces_) {
      Candidate whole = piece;
      whole.places = &places;
      queue.push(std::move(whole));
    }
    while (!queue.empty() && final.size() <= most_parts) {
      const Candidate top = queue.top();
      queue.pop();
      if (!(top.upper >= attained_)) break;
      constexpr double smallest = 0x1p-30, smallest_without_bound = 0x1p-10;
      const bool is_small = top.size <= (std::isfinite(top.upper) ? smallest : smallest_without_bound);
      if (!std::isfinite(top.slack) || is_small || top.is_narrow(attained_)) {
        for (const Place& place : *top.places) {
          if (final.size() > most_parts) break;
          final.push_back(top);
          final.back().place = place;
        }
        continue;
      }
      const auto [left, right] = halves(top.over);
      const auto [base_left, base_right] = halves(top.base);
      for (const bool second : {false, true}) {
        Candidate half = top;
        half.size = top.size / 2;
        if (second) half.begin += half.size;
        half.over = second ? right : left;
        half.base = second ? base_right : base_left;
        if (may_be_largest(half)) queue.push(std::move(half));
      }
    }
    std::erase_if(final, [this](const Candidate& one) { return !(one.upper >= attained_); });
    return final;
  }

 private:
  /// Whether a part may have the largest value, by its bound, which is set.
  bool may_be_largest(Candidate& part) {
    part.set_bound();
    if (!(part.upper > attained_)) return false;
    if (part.is_certain) attained_ = std::max(attained_, part.attained());
    return true;
  }

  const Measure* measure_;
  std::map<Candidate, std::vector<Place>, ByMeasure> pieces_;  ///< those with the same measure are bounded once
  std::size_t kept_ = 0;
  double attained_ = -infinity;
};

Rational exactly(const spline::DoubleDouble& x) { return Rational(x.hi) + Rational(x.lo); }
Rational exactly(const Real& x) { return x.rational(); }

Rational at_least(const Rational& x) { return x; }
template <class M>
Rational at_least(const BallOf<M>& x) {
  return exactly(x.middle()) - exactly(Middle<M>::number(x.radius()));
}
bool is_above_zero(const Rational& x) { return x > 0; }
template <class M>
bool is_above_zero(const BallOf<M>& x) {
  return x.middle() > M() && !x.may_be_zero();
}
double rough(const Rational& x) { return nearest_double(x); }
template <class M>
double rough(const BallOf<M>& x) {
  return x.rough();
}

/// The largest coefficient, at most.
Rational largest_of(const Polynomial<Rational>& x) { return *std::ranges::max_element(x); }
template <class M>
Rational largest_of(const Polynomial<BallOf<M>>& x) {
  const BallOf<M> largest(std::ranges::max_element(x, {}, &BallOf<M>::middle)->middle());
  Rational most = exactly(largest.middle());
  for (const BallOf<M>& coefficient : x) {
    if (!(largest - coefficient).may_be_zero()) continue;  // it is below
    most = std::max(most, exactly(coefficient.middle()) + exactly(Middle<M>::number(coefficient.radius())));
  }
  return most;
}

/// The part of a measure on [begin, begin + size].
template <class S>
Measured<S> part_of(const Measured<S>& x, const Rational& begin, const Rational& size) {
  const S first = scalar_of<S>(begin), width = scalar_of<S>(size);
  return {limits::part_of(x.over, first, width), limits::part_of(x.base, first, width), x.power};
}

/// A bound on [0, 1]: the largest coefficient of Bernstein's form; nothing where it has none.
template <class S>
std::optional<Rational> bound_of(const Measured<S>& x) {
  const std::size_t base_degree = x.base.size() - 1, of_power = base_degree * static_cast<std::size_t>(x.power);
  Polynomial<S> above = bernstein(x.over, std::max(x.over.size() - 1, of_power));
  if (x.power > 0) {
    above = with_binomials(above);
    const Polynomial<S> below = power_of(bernstein(x.base, base_degree), x.power);
    for (std::size_t i = 0; i < above.size(); ++i) {
      if (!is_above_zero(below[i])) return std::nullopt;
      above[i] = above[i] / below[i];
    }
  }
  return largest_of(above);
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
  if (!(*bound_of(Measured<Rational>{derivative(rate)}) < 0)) return std::nullopt;
  const Polynomial<Rational> root = common_divisor(sum(x, {simplest}, Rational(-1)), rate);
  return value_at(root, Rational(0)) * value_at(root, Rational(1)) <= 0 ? std::optional(simplest) : std::nullopt;
}

/// Bounds parts of pieces with exact numbers.
class ExactSearch {
 public:
  std::optional<Extreme> best;
  Rational place;  ///< of the best, in its piece
  std::size_t best_candidate = 0;

  /// A part is halved at most `deepest` times. A bound that is then far from what is attained is taken, or is
  /// Undecided.
  template <class S>
  void add(const Measured<S>& x, const Candidate& part, std::size_t number, int deepest, bool takes_far_bounds) {
    candidate_ = number;
    deepest_ = deepest;
    takes_far_bounds_ = takes_far_bounds;
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
  template <class S>
  void bound(const Measured<S>& x, const Rational& begin, const Rational& size, int depth) {
    static const Rational close = Rational(0x1p-80), half = Rational(1) / 2;
    const Rational at = likely_place(x, begin, size);
    const S value = x.at(scalar_of<S>(at));
    attain(at_least(value), begin + at * size);
    const std::optional<Rational> before = bound_of(part_of(x, 0, at)), after = bound_of(part_of(x, at, 1 - at));
    if (before && after) {
      const Rational most = std::max(*before, *after);
      if (most <= best->high) return;
      const bool is_close = most - best->low <= close * abs(most);
      if (is_close || (depth == deepest_ && takes_far_bounds_)) {
        if constexpr (std::is_same_v<S, Rational>) {
          if (const auto exact = simple_maximum(x.over, value, most)) return attain(*exact, begin + at * size);
        } else if constexpr (std::is_same_v<S, Ball>) {
          throw Undecided();  // its results are never exact: it only shows that a part has no larger values
        }
        best->high = std::max(best->high, most);
        return;
      }
    }
    if (depth == deepest_) throw Undecided();
    attain(at_least(x.at(scalar_of<S>(half))), begin + half * size);  // so that a half that rests may be left out
    const auto bound_half = [&](const Rational& first) {
      bound(part_of(x, first, half), begin + first * size, size * half, depth + 1);
    };
    const bool is_first = at < half;  // the half that has the largest value, probably
    bound_half(is_first ? Rational(0) : half);
    bound_half(is_first ? half : Rational(0));
  }

  /// Where the largest value on [0, 1] probably is: the root of the derivative. Of a polynomial, where it is one at the
  /// simplest fraction of the piece near it, or better by a step of Newton's method.
  template <class S>
  static Rational likely_place(const Measured<S>& x, const Rational& begin, const Rational& size) {
    using spline::is_exactly_zero;
    const auto largest_of = [](const Polynomial<S>& of, std::size_t first) {
      using spline::rough_max;
      S largest(0);
      for (std::size_t i = first; i < of.size(); ++i) largest = rough_max(largest, S(abs(of[i])));
      return largest;
    };
    const S largest = largest_of(x.over, x.power == 0 ? 1 : 0), largest_base = largest_of(x.base, 0);
    if (is_exactly_zero(largest)) return 0;
    const auto in_units = [](const Polynomial<S>& of, const S& unit) {
      Polynomial<double> result(of.size());
      for (std::size_t i = 0; i < of.size(); ++i) result[i] = rough(of[i] / unit);
      return result;
    };
    const Polynomial<S> exact = derivative(x.over);
    const Polynomial<double> rate = in_units(exact, largest), base = in_units(x.base, largest_base);
    const Polynomial<double> over = x.power == 0 ? Polynomial<double>{0} : in_units(x.over, largest);
    const auto grows = [&](double u) {
      return value_at(rate, u) * value_at(base, u) > x.power * value_at(over, u) * value_at(derivative(base), u);
    };
    if (!grows(0)) return 0;
    if (grows(1)) return 1;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      if (middle == low || middle == high) break;
      (grows(middle) ? low : high) = middle;
    }
    const Rational rough(low);
    if constexpr (std::is_same_v<S, Rational>) {
      const auto is_inside = [](const Rational& u) { return 0 <= u && u <= 1; };
      const Rational fraction = begin + rough * size, near = std::min(Rational(0x1p-36), size / 4);
      const Rational simplest = fraction <= near ? Rational(0) : simplest_between(fraction - near, fraction + near);
      const Rational simple = (simplest - begin) / size;
      if (is_inside(simple) && value_at(exact, simple) == 0) return simple;
      const Rational bend = value_at(derivative(exact), rough);
      if (bend == 0) return rough;
      const Rational step = -value_at(exact, rough) / bend;
      const bool is_quadratic = x.over.size() == 3;
      const Rational better = rough + (is_quadratic ? step : Rational(nearest_double(step)));
      return is_inside(better) ? better : rough;
    }
    return rough;
  }

  int deepest_ = 0;
  bool takes_far_bounds_ = false;
  std::size_t candidate_ = 0;
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
      const Polynomial<double> rate = rate_of(piece, channel, 1);
      result.push_back({value_at(rate, at_end ? 1.0 : 0.0), scale_of(rate, piece, channel, 1)});
    }
    return result;
  }

  void compare(const std::vector<End>& in, const std::vector<End>& out, const Time& time) {
    Corner corner{time};
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      corner.in.push_back(in[i].velocity);
      corner.out.push_back(out[i].velocity);
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

/// Bounds a part of a piece with balls. The place on the piece where a curvature has no bound, if there is one. Throws:
/// Undecided where that needs more digits.
template <class M>
std::optional<Rational> add_with_balls(ExactSearch& search, const Piece<Rational>& piece, const Measure& measure,
                                       const Candidate& part, std::size_t number, bool is_last) {
  using S = BallOf<M>;
  const auto balls = [](const Polynomial<Rational>& of) {
    Polynomial<S> result(of.size());
    std::ranges::transform(of, result.begin(), scalar_of<S>);
    return result;
  };
  const auto measured_with_balls = [&] {
    if (measure.is_of_direction()) return measured_direction<S>(piece, measure, balls);
    Piece<S> same{piece.number,
                  scalar_of<S>(piece.begin),
                  scalar_of<S>(piece.size),
                  scalar_of<S>(piece.duration),
                  balls(piece.parameter),
                  std::vector<Polynomial<S>>(piece.cubics.size())};
    for (const std::size_t channel : measure.channels) same.cubics[channel] = balls(piece.cubics[channel]);
    return measured(same, measure);
  };
  const Measured<S> x = measured_with_balls();
  const auto rest = x.power == 3 ? sharp_rest(piece, measure) : std::nullopt;
  if (!rest) search.add(x, part, number, Middle<M>::bits() * 3 / 10, is_last);
  return rest;
}

/// The maximum among the parts that may hold it. Throws: Undecided where numbers are too far apart for any digits.
std::optional<Extreme> exact_maximum(const std::vector<Candidate>& parts, const Measure& measure,
                                     const MeasuredCurve& curve) {
  const auto piece_of = [&](const Candidate& part) -> std::optional<Piece<Rational>> {
    const spline::Segments<Rational> one = curve.exact(part.place.segment, measure.is_of_direction());
    const Rational duration = one.times[1] - one.times[0];
    const auto range = fractions(curve, one.times[0], one.times[1]).value_or(std::pair<Rational, Rational>(0, 1));
    const auto pieces = pieces_of(one, 0, duration == 0 ? Rational(1) : duration, range.first, range.second);
    const auto found = std::ranges::find(pieces, part.place.piece, &Piece<Rational>::number);
    return found == pieces.end() ? std::nullopt : std::optional(*found);
  };
  const auto extreme_at = [&](Extreme extreme, const Candidate& part, const Rational& place) {
    const Piece<Rational> piece = *piece_of(part);
    const Rational fraction = piece.begin + place * piece.size;
    const spline::Segments<Rational> one = curve.exact(part.place.segment, measure.is_of_direction());
    extreme.time = one.times[0] + fraction * (one.times[1] - one.times[0]);
    extreme.is_at_key = fraction == 0 || fraction == 1;
    if (fraction == 1) extreme.side = spline::Side::left;
    const Rational u = value_at(piece.parameter, place);
    for (const Polynomial<Rational>& x : piece.cubics) extreme.position.push_back(nearest_double(value_at(x, u)));
    return extreme;
  };
  ExactSearch search;
  const auto add_with_enough_digits = [&](const Piece<Rational>& piece, const Candidate& part, std::size_t number) {
    try {
      return add_with_balls<spline::DoubleDouble>(search, piece, measure, part, number, false);
    } catch (const Undecided&) {
    }
    if (!measure.is_of_direction()) {
      search.add(measured(piece, measure), part, number, 600, true);
      return std::optional<Rational>();
    }
    try {
      const RealPrecision precision(400);
      return add_with_balls<Real>(search, piece, measure, part, number, false);
    } catch (const Undecided&) {
    }
    const RealPrecision precision(2000);
    return add_with_balls<Real>(search, piece, measure, part, number, true);
  };
  std::vector<std::vector<Polynomial<Rational>>> bounded;  // parts, which repeat where a motion does
  for (std::size_t i = 0; i < std::min(parts.size(), most_parts); ++i) {
    const auto piece = piece_of(parts[i]);
    if (!piece) continue;
    std::vector<Polynomial<Rational>> part{{piece->duration, Rational(parts[i].begin), Rational(parts[i].size)},
                                           piece->parameter};
    for (const std::size_t channel : measure.channels) part.push_back(piece->cubics[channel]);
    if (std::ranges::find(bounded, part) != bounded.end()) continue;
    bounded.push_back(std::move(part));
    const auto rest = add_with_enough_digits(*piece, parts[i], i);
    if (rest) return extreme_at({.is_unbounded = true}, parts[i], *rest);
  }
  if (!search.best) return std::nullopt;
  Extreme& best = *search.best;
  if (measure.is_of_direction()) best.low = measured(*piece_of(parts[search.best_candidate]), measure).at(search.place);
  if (parts.size() > most_parts) {
    if (!std::isfinite(parts.back().upper)) throw Undecided();
    best.high = std::max(best.high, Rational(parts.back().upper));
  }
  return extreme_at(best, parts[search.best_candidate], search.place);
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
  Extremes result;
  for (std::size_t k = 0; k < measures.size(); ++k) {
    try {
      result.maxima.push_back(exact_maximum(searches[k].rest(), measures[k], curve));
    } catch (const Undecided&) {
      result.maxima.push_back(Extreme{.is_unproved = true});
    }
  }
  result.corners = std::move(corners.found);
  return result;
}

}  // namespace tcb::limits
