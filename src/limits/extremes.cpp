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
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "error.hpp"
#include "exact/ball.hpp"
#include "exact/rounding.hpp"

namespace tcb::limits {
namespace {

constexpr double rounding = 0x1p-40;  ///< relative: of the segments, and of hundreds of operations on them
constexpr double least = 1e-290;      ///< below it, squares may be 0

/// The power of a polynomial in Bernstein's form, times the binomials.
template <class S>
Polynomial<S> power_of_form(const Polynomial<S>& form, int power) {
  const Polynomial<S> base = with_binomials(form);
  Polynomial<S> result{S(1)};
  for (int i = 0; i < power; ++i) result = product(result, base);
  return result;
}

/// A measure over a part of a piece in Bernstein's form, and how far rounding may move that of doubles.
template <class S>
struct Form {
  Polynomial<S> over{S(0)}, base{S(0)};
  int power = 0;
  double slack = 0, base_slack = 0;
};

template <class S>
Form<S> form_of(const Measured<S>& x) {
  const std::size_t base_degree = x.base.size() - 1, of_power = base_degree * static_cast<std::size_t>(x.power);
  return {bernstein(x.over, std::max(x.over.size() - 1, of_power)), bernstein(x.base, base_degree), x.power,
          x.scale == 0 ? 0 : rounding * x.scale + least, rounding * x.base_scale};
}

/// The forms on [0, at] and [at, 1].
template <class S>
std::pair<Form<S>, Form<S>> split(const Form<S>& form, const S& at) {
  std::pair<Form<S>, Form<S>> parts{form, form};
  std::tie(parts.first.over, parts.second.over) = split(form.over, at);
  std::tie(parts.first.base, parts.second.base) = split(form.base, at);
  return parts;
}

Rational exactly(const spline::DoubleDouble& x) { return Rational(x.hi) + Rational(x.lo); }
Rational exactly(const Real& x) { return x.rational(); }

/// The ends of what a scalar may be, as numbers that are compared.
template <class Number, class S>
std::pair<Number, Number> ends_of(const S& x) {
  if constexpr (std::is_same_v<S, Number>) {
    return {x, x};
  } else if constexpr (std::is_same_v<Number, Rational>) {
    const Rational middle = exactly(x.middle()),
                   radius = exactly(Middle<std::decay_t<decltype(x.middle())>>::number(x.radius()));
    return {middle - radius, middle + radius};
  } else {
    const Number radius = x.widened(0x1p-95 * x.most()).radius();  // and the rounding of the sums
    return {x.middle() - radius, x.middle() + radius};
  }
}

const Rational& middle_of(const Rational& x) { return x; }
template <class M>
const M& middle_of(const BallOf<M>& x) {
  return x.middle();
}
bool is_above_zero(const Rational& x) { return x > 0; }
template <class M>
bool is_above_zero(const BallOf<M>& x) {
  return x.middle() > M() && !x.may_be_zero();
}
double rough(double x) { return x; }
double rough(const Rational& x) { return nearest_double(x); }
template <class M>
double rough(const BallOf<M>& x) {
  return x.rough();
}

/// A bound on a part; nothing where none is known. Rounding may keep it `doubt` away from the values.
template <class Number>
struct Bound {
  std::optional<Number> upper;
  Number doubt{};
};

/// A quotient is at most the largest of those of the coefficients, or of them with binomials.
template <class Number, class S>
Bound<Number> bound_of(const Form<S>& form) {
  Polynomial<S> x = form.over;
  if (form.power > 0) {
    x = with_binomials(x);
    const Polynomial<S> below = power_of_form(form.base, form.power);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!is_above_zero(below[i])) return {};
      x[i] = x[i] / below[i];
    }
  }
  const auto larger = [](const S& a, const S& b) { return middle_of(a) < middle_of(b); };
  const S& largest = *std::ranges::max_element(x, larger);
  Number upper = ends_of<Number>(largest).second;
  if constexpr (spline::bounds_errors<S>) {
    for (const S& other : x) {
      if ((largest - other).may_be_zero()) upper = std::max(upper, ends_of<Number>(other).second);
    }
  }
  return {upper, std::max(upper, -upper) * Number(0x1p-80)};
}
template <>
Bound<double> bound_of<double, double>(const Form<double>& form) {
  const int power = form.power;
  const double slack = form.slack, base_slack = form.base_slack;
  if (power == 0) return {*std::ranges::max_element(form.over) + slack, 8 * slack};
  Polynomial<double> base = form.base;
  for (double& x : base) x -= base_slack;
  const double smallest = *std::ranges::min_element(base);
  if (!(smallest > 0)) return {};  // it may be 0 there
  const Polynomial<double> below = power_of_form(base, power), above = with_binomials(form.over);
  double upper = 0, binomial = 1;
  for (std::size_t i = 0; i < above.size(); ++i) {
    upper = std::max(upper, (above[i] + slack * binomial) / below[i] * (1 + rounding));
    binomial *= static_cast<double>(above.size() - 1 - i) / static_cast<double>(i + 1);
  }
  return {upper, 8 * (slack / power_of(smallest, power) + power * upper * (base_slack / smallest + rounding))};
}

/// A value that is attained at the start of a part, or at its end; nothing where none is known.
template <class Number, class S>
std::optional<Number> value_at_end(const Form<S>& form, bool last) {
  const S &above = last ? form.over.back() : form.over.front(), &base = last ? form.base.back() : form.base.front();
  if constexpr (std::is_same_v<S, double>) {
    if (form.power == 0) return above - form.slack;
    return std::max(0.0, above - form.slack) / power_of(base + form.base_slack, form.power) * (1 - rounding);
  } else {
    if (form.power == 0) return ends_of<Number>(above).first;
    const S below = power_of(base, form.power);
    return is_above_zero(below) ? std::optional(ends_of<Number>(S(above / below)).first) : std::nullopt;
  }
}

/// Where a function on [0, 1] is no longer above 0, if it is at first and falls.
template <class F>
double falling_root(const F& f) {
  if (!(f(0) > 0)) return 0;
  if (f(1) > 0) return 1;
  double low = 0;
  for (double size = 0.5; size >= 0x1p-45; size /= 2) low += f(low + size) >= 0 ? size : 0;
  return low;
}

/// Where the largest value on [0, 1] probably is: the root of the derivative.
template <class S>
double likely_place(const Form<S>& form) {
  using spline::is_exactly_zero, spline::rough_max, std::abs;
  const auto differences = [](const Polynomial<S>& x) {
    Polynomial<S> result;
    for (std::size_t i = 1; i < x.size(); ++i) result.push_back(x[i] - x[i - 1]);
    return result;
  };
  const auto in_units = [](const Polynomial<S>& x) {  // near doubles, by rising powers
    S unit(0);
    for (const S& coefficient : x) unit = rough_max(unit, S(abs(coefficient)));
    Polynomial<double> result(x.size());
    if constexpr (spline::bounds_errors<S>) unit = without_radius(unit);
    if (is_exactly_zero(unit)) return result;
    for (std::size_t i = 0; i < x.size(); ++i) result[i] = rough(S(x[i] / unit));
    return from_bernstein(result);
  };
  if (form.over.size() == 1) return 0;
  if (form.power == 0) {
    return falling_root([rate = in_units(differences(form.over))](double u) { return value_at(rate, u); });
  }
  const Polynomial<double> over = in_units(form.over), base = in_units(form.base);
  return falling_root([&, over_rate = derivative(over), base_rate = derivative(base)](double u) {
    return value_at(over_rate, u) * value_at(base, u) - form.power * value_at(over, u) * value_at(base_rate, u);
  });
}

/// The simplest fraction between two numbers.
Rational simplest_within(const Rational& low, const Rational& high) {
  if (low > 0) return simplest_between(low, high);
  return high < 0 ? -simplest_between(-high, -low) : Rational(0);
}

/// The number within [low, high], if there is one that is far simpler than in other such intervals.
std::optional<Rational> simple_number(const Rational& low, const Rational& high) {
  const Rational simplest = simplest_within(low, high), size = denominator(simplest);
  return size * size * (high - low) <= Rational(0x1p-20) ? std::optional(simplest) : std::nullopt;
}

/// Whether a number is the maximum of a concave polynomial, at a place that may be irrational: there the polynomial
/// less the maximum has a double root.
bool is_maximum(const Polynomial<Rational>& x, const Rational& number) {
  const Polynomial<Rational> root = common_divisor(sum(x, {number}, Rational(-1)), derivative(x));
  return value_at(root, Rational(0)) * value_at(root, Rational(1)) <= 0;
}

bool is_concave(const Polynomial<Rational>& x) {
  const Polynomial<Rational> bend = derivative(derivative(x));
  return std::ranges::max(bernstein(bend, bend.size() - 1)) < 0;
}

/// A place near another one where a polynomial in Bernstein's form is largest on the part [begin, begin + size] of a
/// piece: at the simplest fraction of the piece, or better by a step of Newton's method.
Rational better_place(const Polynomial<Rational>& form, const Rational& near_place, const Rational& begin,
                      const Rational& size) {
  const Polynomial<Rational> rate = derivative(from_bernstein(form));
  const auto is_inside = [](const Rational& u) { return 0 <= u && u <= 1; };
  const Rational fraction = begin + near_place * size, near = std::min(Rational(0x1p-36), size / 4);
  const Rational simplest = fraction <= near ? Rational(0) : simplest_between(fraction - near, fraction + near);
  const Rational simple = (simplest - begin) / size;
  if (is_inside(simple) && value_at(rate, simple) == 0) return simple;
  const Rational bend = value_at(derivative(rate), near_place);
  if (bend == 0) return near_place;
  const Rational step = -value_at(rate, near_place) / bend;
  const bool is_quadratic = form.size() == 3;
  const Rational better = near_place + (is_quadratic ? step : Rational(nearest_double(step)));
  return is_inside(better) ? better : near_place;
}

/// Where a piece is: the numbers of its segment, and of its part of the ease.
struct Place {
  std::size_t segment, piece;
};

/// Searches the maximum of one measure by parts of pieces. Number: in which values are compared. Rationals find it, and
/// others the segments that may hold it.
template <class Number>
class Search {
 public:
  struct Attained {
    Number value;
    Place piece;
    Number place;  ///< on the piece
  };
  std::optional<Attained> best;

  /// How often parts are halved, and whether a bound that is then far from what is attained is taken, or Undecided.
  struct Depth {
    int deepest = 40;
    bool takes_far_bounds = true;
  };

  /// A bound on a piece; nothing where none is known. `attains`: the piece certainly exists. Throws: Undecided.
  template <class S>
  std::optional<Number> bound(const Form<S>& form, const Place& piece, const Depth& depth, bool attains = true) {
    piece_ = piece;
    depth_ = depth;
    splits_ = 0;
    const auto whole = bound_of<Number>(form);
    if (!attains) return whole.upper;
    attain(value_at_end<Number>(form, false), Number(0));
    attain(value_at_end<Number>(form, true), Number(1));
    return bound_part(form, whole, Number(0), Number(1), 0);
  }

  struct Part {
    std::size_t segment;
    std::optional<Number> upper;  ///< nothing: no bound is known
  };
  /// Adds a segment, the next one, to those that may hold the maximum.
  void add(std::size_t segment, const std::optional<Number>& upper) {
    if (is_below(upper)) return;
    parts_.push_back({segment, upper});
    if (parts_.size() >= 2 * kept_ + 64) kept_ = rest().size();
  }
  /// The segments that may hold the maximum.
  const std::vector<Part>& rest() {
    std::erase_if(parts_, [this](const Part& part) { return is_below(part.upper); });
    return parts_;
  }
  /// Whether a bound is below a value that is attained.
  bool is_below(const std::optional<Number>& upper) const { return upper && best && *upper < best->value; }

 private:
  static constexpr bool is_exact = std::is_same_v<Number, Rational>;

  void attain(const std::optional<Number>& value, const Number& place) {
    if (value && (!best || best->value < *value)) best = Attained{*value, piece_, place};
  }

  /// Bounds the part [begin, begin + size] of a piece. `whole`: what bound_of() has for it.
  template <class S>
  std::optional<Number> bound_part(const Form<S>& form, const Bound<Number>& whole, const Number& begin,
                                   const Number& size, int depth) {
    if (whole.upper && !(best->value < *whole.upper)) return whole.upper;
    Number at(likely_place(form));
    const bool is_inside = Number(0) < at && at < Number(1);
    if constexpr (std::is_same_v<S, Rational>) {
      if (is_inside) at = better_place(form.over, at, begin, size);
    }
    std::pair<Form<S>, Form<S>> parts;
    Bound<Number> before, after;
    const auto split_at = [&](const Number& place) {
      parts = split(form, scalar<S>(place));
      before = bound_of<Number>(parts.first);
      after = bound_of<Number>(parts.second);
      attain(value_at_end<Number>(parts.first, true), begin + place * size);
    };
    if (is_inside) split_at(at);
    const auto larger = [](const std::optional<Number>& x, const std::optional<Number>& y) {
      return x && y ? std::max(x, y) : std::nullopt;
    };
    std::optional<Number> upper = is_inside ? larger(before.upper, after.upper) : whole.upper;
    if (upper) {
      if (!(best->value < *upper)) return upper;
      const bool is_narrow = !(std::max(whole.doubt, before.doubt) < *upper - best->value);
      if (is_narrow || (depth == depth_.deepest && depth_.takes_far_bounds)) {
        if constexpr (std::is_same_v<S, Rational>) {
          const auto exact = is_inside ? simple_number(parts.first.over.back(), *upper) : std::nullopt;
          const Polynomial<Rational> x = exact ? from_bernstein(form.over) : Polynomial<Rational>{0};
          if (exact && !is_concave(x) && depth < 40) {  // a smaller part is
            split_at(Rational(1) / 2);
            return larger(bound_part(parts.first, before, begin, size / 2, depth + 1),
                          bound_part(parts.second, after, begin + size / 2, size / 2, depth + 1));
          }
          if (exact && is_maximum(x, *exact)) attain(upper = exact, begin + at * size);
        } else if constexpr (is_exact && std::is_same_v<S, Ball>) {
          throw Undecided();  // its results are never exact: it only shows that a part has no larger values
        }
        return upper;
      }
    }
    constexpr int deepest_without_bound = 10, most_splits = is_exact ? 2'000 : 1'000;
    const bool is_last_split = ++splits_ > most_splits;
    if (!is_exact && (is_last_split || (!upper && depth == deepest_without_bound))) return upper;
    if (is_last_split || depth == depth_.deepest) throw Undecided();
    if (!is_inside) {
      at = Number(0.5);
      split_at(at);
    }
    const auto left = bound_part(parts.first, before, begin, at * size, depth + 1);
    return left ? larger(left, bound_part(parts.second, after, begin + at * size, size - at * size, depth + 1)) : left;
  }
  template <class S>
  static S scalar(const Number& x) {
    if constexpr (is_exact) {
      return scalar_of<S>(x);
    } else {
      return S(x);
    }
  }

  Place piece_ = {};
  Depth depth_;
  int splits_ = 0;
  std::vector<Part> parts_;
  std::size_t kept_ = 0;
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
      if (low != 0 || high != 0) squares += power_of(std::max(-low, high), 2) * (1 + rounding) + least;
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
      const double scale = scale_of(rate, piece_, channel, order), slack = scale == 0 ? 0 : rounding * scale + least;
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

Rational exactly(const Time& time, const std::optional<FrameTimes>& frames) {
  const auto frame = frames ? frames->exact(time) : std::nullopt;
  return frame ? *frame : Rational(time.hi) + Rational(time.lo);
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

/// Lists the keys at which velocities jump.
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

  Ends ends_of(const std::vector<Piece<double>>& pieces) const {
    return {end_of(pieces.front(), 0), end_of(pieces.back(), 1)};
  }
  void add(const Ends& ends, const Time& start) {
    if (!first_) first_ = ends.start;
    if (before_) compare(*before_, ends.start, start);
    before_ = ends.end;
  }
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
      if (!(jump > rounding * std::max(out.sizes[i], in.sizes[i]))) continue;
      jumps.push_back(jump);
      corner.channels.push_back(channels_[i]);
    }
    corner.jump = root_of_squares(jumps);
    if (!jumps.empty()) found.push_back(std::move(corner));
  }

  const std::vector<std::size_t>& channels_;
  std::optional<End> first_, before_;
};

/// Bounds the segments that are left with double-doubles. Those that are beyond these keep the bounds by doubles.
std::vector<Search<spline::DoubleDouble>> with_balls(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                                                     std::vector<Search<double>>& rough) {
  using Number = spline::DoubleDouble;
  constexpr std::size_t few = 20;                           // segments, which need no bounds before the exact ones
  std::vector<std::span<const Search<double>::Part>> left;  // not yet bounded
  std::vector<bool> is_bounded;
  for (std::size_t k = 0; k < measures.size(); ++k) {
    left.emplace_back(rough[k].rest());
    is_bounded.push_back(!measures[k].is_of_direction() && left[k].size() > few);
  }
  std::vector<Search<Number>> searches(measures.size());
  using Known = std::vector<std::optional<Number>>;  // bounds on a segment, for the measures
  std::vector<Known> known;
  Repeats repeats;
  while (true) {
    std::optional<std::size_t> segment;
    bool is_needed = false;
    for (std::size_t k = 0; k < measures.size(); ++k) {
      if (left[k].empty() || (segment && *segment < left[k].front().segment)) continue;
      is_needed = is_bounded[k] || (is_needed && segment == left[k].front().segment);
      segment = left[k].front().segment;
    }
    if (!segment) return searches;
    std::vector<Piece<Ball>> pieces;
    Known once(measures.size());
    Known* found = &once;
    try {
      if (is_needed) {
        const spline::Segments<Ball> one = curve.in_balls(*segment);
        pieces = measured_pieces(curve, one);
        const bool may_repeat = !curve.from && !curve.to;
        const auto number = may_repeat ? repeats.find(one, 0, one.times[1] - one.times[0]) : std::nullopt;
        if (number == known.size()) known.push_back(once);
        if (number) found = &known[*number];
      }
    } catch (const Undecided&) {
    }
    for (std::size_t k = 0; k < measures.size(); ++k) {
      if (left[k].empty() || left[k].front().segment != *segment) continue;
      std::optional<Number>& upper = (*found)[k];
      try {
        if (is_bounded[k] && !upper && !pieces.empty()) {
          upper = largest_of(pieces, [&](const Piece<Ball>& piece) {
            return searches[k].bound(form_of(measured(piece, measures[k])), {}, {});
          });
        }
      } catch (const Undecided&) {
      }
      searches[k].add(*segment, upper ? upper : left[k].front().upper);
      left[k] = left[k].subspan(1);
    }
  }
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
    const RealPrecision precision(400);
    return bound_with_balls<Real>(search, high, piece, measure, place, false);
  } catch (const Undecided&) {
  }
  const RealPrecision precision(2000);
  return bound_with_balls<Real>(search, high, piece, measure, place, true);
}

/// The maximum among the segments that may hold it. Throws: Undecided where numbers are too far apart for any digits.
std::optional<Extreme> exact_maximum(std::vector<Search<spline::DoubleDouble>::Part> parts, const Measure& measure,
                                     const MeasuredCurve& curve) {
  const auto exact = [&](std::size_t segment) { return curve.exact(segment, measure.is_of_direction()); };
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

double root_of_squares(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  if (largest == 0 || !std::isfinite(largest)) return largest;
  const double unit = spline::power_of_two_below(largest);
  spline::DoubleDouble squares;
  for (const double x : numbers) squares = squares + spline::DoubleDouble(x / unit) * spline::DoubleDouble(x / unit);
  return sqrt(squares).hi * unit;
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
        const auto part = fractions(curve, exactly(start, curve.frames), exactly(end, curve.frames));
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
