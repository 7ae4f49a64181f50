// Extremes: the certified maximum of a measure over a curve.
//
// On a piece a measure is a polynomial, or a quotient of two, in Bernstein's form: its coefficients bound it, and the
// first and the last one are attained (Form). Search divides pieces where the maximum probably is, until no bound is
// above the best value that is attained. CurveSearch does this for all measures, segment after segment, with bounded
// double-doubles; what needs more digits is searched again with rationals. result_of() has the place of a maximum with
// the digits of its time, and its exact value there.
#include "limits/extremes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "exact/rounding.hpp"
#include "limits/pieces.hpp"
#include "limits/search.hpp"
#include "tcb/spline/scalar.hpp"

namespace tcb::limits {
namespace {

// The keys at which velocities change by more than 2^-40 of their size, which is more than the rounding of times.

constexpr double least_change = 0x1p-40;

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

/// A vector of the length 1.
std::vector<double> direction_of(std::vector<double> vector) {
  const double size = root_of_squares(vector);
  for (double& x : vector) x /= size;
  return vector;
}

/// The distance of two directions, or of one and the opposite of the other.
double distance(const std::vector<double>& a, const std::vector<double>& b, double sign = 1) {
  std::vector<double> change;
  for (std::size_t i = 0; i < a.size(); ++i) change.push_back(a[i] - sign * b[i]);
  return root_of_squares(change);
}

/// Finds the corners of a curve, segment after segment.
class Corners {
 public:
  Corners(const std::vector<std::size_t>& channels, const std::vector<Measure>& measures) : channels_(channels) {
    for (const Measure& one : measures) {
      if (one.kind == Measure::Kind::curvature) path_ = one.channels;
    }
  }

  std::vector<Corner> found;
  std::optional<std::size_t> sharp_rest;  ///< the first key at which the curve rests, and its path turns

  /// Adds the next segment by its pieces. `key`: the number of that at which it starts.
  template <class S>
  void add(const std::vector<Piece<S>>& pieces, std::size_t key, const Time& start) {
    End first = end_of(pieces.front(), 0);
    if (!first_) first_ = first;
    if (before_) compare(*before_, first, key, start);
    before_ = end_of(pieces.back(), 1);
  }
  /// The curve is closed, and back at its start at this time.
  void close(std::size_t key, const Time& end) {
    if (first_) compare(*before_, *first_, key, end);
  }

 private:
  /// At an end of a segment.
  struct End {
    std::vector<Bounded> velocities;
    bool rests = false;             ///< the channels of the path do
    std::vector<double> direction;  ///< of the path, if it has one
  };

  template <class S>
  End end_of(const Piece<S>& piece, int at) const {
    End end;
    const bool is_last = at == 1;
    const Polynomial<S> turn = derivative(piece.parameter);
    const S place = is_last ? piece.parameter.back() : piece.parameter.front();
    const S rate = (is_last ? turn.back() : turn.front()) / piece.duration;
    for (const std::size_t channel : channels_) {
      const Polynomial<S> controls = controls_of(piece.cubics[channel], 1);
      const S velocity = place == S(0) ? controls.front() : place == S(1) ? controls.back() : value_at(controls, place);
      end.velocities.push_back(scaled<Bounded>(velocity * rate, 0));
    }
    if (path_.empty()) return end;
    for (std::size_t i = 0; i < 3 && end.direction.empty(); ++i) {
      std::vector<S> vector;
      int unit = no_exponent;
      for (const std::size_t channel : path_) {
        vector.push_back(controls_of(piece.cubics[channel], 1)[is_last ? 2 - i : i]);
        if (is_above_zero(vector.back()) || is_above_zero(-vector.back())) {
          unit = std::max(unit, exponent_of(vector.back()));
        }
      }
      end.rests = end.rests || (i == 0 && unit == no_exponent);
      if (unit == no_exponent) continue;
      for (const S& x : vector) end.direction.push_back(scaled<Bounded>(x, unit).value.hi);
      end.direction = direction_of(std::move(end.direction));
    }
    return end;
  }

  void compare(const End& in, const End& out, std::size_t key, const Time& time) {
    Corner corner{time};
    std::vector<double> jumps;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const Bounded &before = in.velocities[i], &after = out.velocities[i], change = after - before;
      corner.in.push_back(before.value.hi);
      corner.out.push_back(after.value.hi);
      const double jump = std::abs(change.value.hi);
      const double size = std::max(std::abs(before.value.hi), std::abs(after.value.hi));
      if (change.may_be_zero() || !(jump > least_change * size)) continue;
      jumps.push_back(jump);
      corner.channels.push_back(channels_[i]);
    }
    corner.jump = root_of_squares(jumps);
    if (!jumps.empty()) found.push_back(std::move(corner));
    const bool may_turn = (in.rests || out.rests) && !in.direction.empty() && !out.direction.empty() && !sharp_rest;
    if (may_turn && distance(in.direction, out.direction) > least_change &&
        distance(in.direction, out.direction, -1) > least_change) {
      sharp_rest = key;
    }
  }

  const std::vector<std::size_t>& channels_;
  std::vector<std::size_t> path_;
  std::optional<End> first_, before_;
};

/// Bounds of the derivatives of the channels of a whole segment by doubles, with room for rounding.
class Ranges {
 public:
  explicit Ranges(const Piece<Bounded>& piece) : piece_(piece), known_(4 * piece.cubics.size()) {}

  /// Whether all values of the measure are less than a positive number.
  bool are_below(const Measure& measure, double value) {
    if (measure.kind == Measure::Kind::curvature) return curvature_is_below(measure.channels, value);
    return measure.kind != Measure::Kind::angular_speed && bound_of(measure) < value;
  }

 private:
  static constexpr double rounding = 0x1p-40;
  struct Range {
    double low, high;
  };

  /// No value of the measure is larger.
  double bound_of(const Measure& measure) {
    double squares = 0;
    for (const std::size_t channel : measure.channels) {
      const auto [low, high] = of(channel, measure.derivative);
      if (!measure.is_size()) return measure.kind == Measure::Kind::smallest ? -low : high;
      squares += std::max(low * low, high * high);
    }
    return squares * (1 + rounding);
  }

  /// The products of the coefficients of the velocity v: of the first with itself and the second one, and so on.
  struct Products {
    double aa, ab, ac, bb, bc, cc;
  };
  bool curvature_is_below(const std::vector<std::size_t>& channels, double square) const {
    std::vector<Polynomial<Bounded>> v;
    double largest = 0;
    for (const std::size_t channel : channels) {
      v.push_back(controls_of(piece_.cubics[channel], 1));
      for (const Bounded& x : v.back()) largest = std::max(largest, std::abs(x.value.hi));
    }
    const double unit = largest > 0 && std::isfinite(largest) ? spline::power_of_two_below(largest) : 0;
    if (unit == 0 || !std::isnormal(square * unit * unit)) return false;
    Products sum{};
    for (const Polynomial<Bounded>& x : v) {
      const double a = x[0].value.hi / unit, b = x[1].value.hi / unit, c = x[2].value.hi / unit;
      sum = {sum.aa + a * a, sum.ab + a * b, sum.ac + a * c, sum.bb + b * b, sum.bc + b * c, sum.cc + c * c};
    }
    constexpr int halvings = 12;
    return curvature_is_below(sum, rounding * (sum.aa + sum.bb + sum.cc), square * unit * unit, halvings);
  }
  /// |v ^ v'|^2 and |v|^2 are bounded by coefficients, the former by those of v ^ v': 2 a ^ b, a ^ c and 2 b ^ c. On a
  /// half v' is half as large.
  static bool curvature_is_below(const Products& x, double room, double square, int halvings) {
    const auto& [aa, ab, ac, bb, bc, cc] = x;
    const double least = std::min({aa, ab, (ac + 2 * bb) / 3, bc, cc}) - room;
    const double most = std::max({4 * (aa * bb - ab * ab), aa * cc - ac * ac, 4 * (bb * cc - bc * bc)});
    if (least > 0 && most + 8 * room * (aa + bb + cc) < square * (least * least * least)) return true;
    if (halvings == 0) return false;
    const double ad = (aa + ab) / 2, bd = (ab + bb) / 2, be = (bb + bc) / 2, ce = (bc + cc) / 2;  // d, e: of the halves
    const double ae = (ab + ac) / 2, cd = (ac + bc) / 2, dd = (ad + bd) / 2, ee = (be + ce) / 2, de = (ae + be) / 2;
    const double af = (ad + ae) / 2, df = (dd + de) / 2, ef = (de + ee) / 2, cf = (cd + ce) / 2, ff = (df + ef) / 2;
    return curvature_is_below({aa, ad, af, dd, df, ff}, room, square / 4, halvings - 1) &&
           curvature_is_below({ff, ef, cf, ee, ce, cc}, room, square / 4, halvings - 1);
  }

  const Range& of(std::size_t channel, int order) {
    std::optional<Range>& range = known_[4 * channel + static_cast<std::size_t>(order)];
    if (range) return *range;
    const Polynomial<Bounded> controls = controls_of(piece_.cubics[channel], order);
    Polynomial<double> x;
    double size = 0;
    for (const Bounded& control : controls) {
      x.push_back(control.value.hi);
      size += 8 * std::abs(control.value.hi);
    }
    double rate = 1;
    for (int i = 0; i < order; ++i) rate /= piece_.duration.value.hi;
    for (int i = 1; i < order; ++i) x = derivative(x);
    const auto [low, high] = std::ranges::minmax(x);
    const double room = rounding * size + 1e-300;
    range = Range{(low - room) * rate, (high + room) * rate};
    return *range;
  }

  const Piece<Bounded>& piece_;
  std::vector<std::optional<Range>> known_;
};

/// The place at which a curve rests and its velocity has a factor that is 0, so that its curvature has no bound.
std::optional<Rational> sharp_rest(const Piece<Rational>& piece, const Measure& measure) {
  std::vector<Polynomial<Rational>> v;
  for (const std::size_t channel : measure.channels) v.push_back(controls_of(piece.cubics[channel], 1));
  const auto bend = [](const Polynomial<Rational>& x) { return x[0] - 2 * x[1] + x[2]; };  // and slope, of u^2 and u
  const auto slope = [](const Polynomial<Rational>& x) { return 2 * (x[1] - x[0]); };
  // A common root is one of all b x - a y, which are linear, for a and b the coefficients of u^2 in x and y.
  const auto least = std::ranges::find_if(v, [](const auto& x) { return !is_zero(x); });
  if (least == v.end()) return std::nullopt;
  std::optional<Rational> root;
  for (const Polynomial<Rational>& x : v) {
    const Rational a = bend(*least), b = bend(x), rise = b * slope(*least) - a * slope(x);
    const bool is_linear = a == 0 && b == 0;
    const Polynomial<Rational>& line = is_zero(x) ? *least : x;
    if (is_linear && slope(line) != 0) root = -line[0] / slope(line);
    if (!is_linear && rise != 0) root = (a * x[0] - b * (*least)[0]) / rise;
    if (root) break;
  }
  const Rational first = piece.parameter.front(), last = piece.parameter.back();
  if (!root || *root < first || *root > last) return std::nullopt;
  if (std::ranges::any_of(v, [&](const auto& x) { return value_at(x, *root) != 0; })) return std::nullopt;
  if (*root == last) return Rational(1);
  Rational low = 0, size = 1;
  for (int i = 0; i < 60 && value_at(piece.parameter, low) != *root; ++i) {
    size /= 2;
    if (value_at(piece.parameter, Rational(low + size)) <= *root) low += size;
  }
  return low;
}

/// The maxima of the measures over a curve.
class CurveSearch {
 public:
  /// These outlive it.
  CurveSearch(const MeasuredCurve& curve, const std::vector<Measure>& measures,
              const std::vector<std::size_t>& channels)
      : curve_(curve), measures_(measures), corners_(channels, measures), found_(measures.size()) {}

  Extremes run() {
    constexpr std::size_t at_once = 64;
    for (std::size_t first = 0; first < curve_.size; first += at_once) {
      const std::size_t to = std::min(first + at_once, curve_.size);
      const auto bounded = curve_.bounded(first, to);
      for (std::size_t i = first; i < to; ++i) {
        if (bounded && has_digits(*bounded, i - first)) {
          add(*bounded, i - first, i);
        } else {
          add(exact(i), 0, i);
        }
      }
    }
    if (curve_.closed && !curve_.from && !curve_.to) corners_.close(curve_.size, curve_.key_time(curve_.size));
    Extremes result;
    for (std::size_t k = 0; k < measures_.size(); ++k) result.maxima.push_back(maximum(k));
    result.corners = std::move(corners_.found);
    return result;
  }

 private:
  /// A piece that needs more digits; its bound, if it has one.
  struct Open {
    PiecePlace piece;
    std::optional<Scaled> upper;
  };
  struct Found {
    Search search;
    std::vector<Open> open;
    std::size_t kept = 0;  ///< of these, when they were last looked through
  };

  /// Whether the coefficients of all channels have most of the digits of double-doubles.
  static bool has_digits(const spline::Segments<Bounded>& segments, std::size_t segment) {
    return std::ranges::all_of(segments[segment], [](const spline::Cubic<Bounded>& x) {
      const double size = std::abs(x.out.value.hi) + std::abs(x.in.value.hi) + std::abs(x.c.value.hi);
      return x.out.error + x.in.error + x.c.error <= 0x1p-60 * size && std::isfinite(size) &&
             x.p0.error + x.p1.error <= 0x1p-60 * (std::abs(x.p0.value.hi) + std::abs(x.p1.value.hi));
    });
  }

  /// The pieces of a segment that are measured. A time that is printed as that of a key is that of the key.
  template <class S>
  std::vector<Piece<S>> pieces(const spline::Segments<S>& segments, std::size_t segment, std::size_t number) const {
    S first(0), last(1);
    const S &start = segments.times[segment], &end = segments.times[segment + 1];
    const auto is_key = [this](const Rational& time, std::size_t key) {
      return nearest_time(time) == curve_.key_time(key);
    };
    if (curve_.from && !is_key(*curve_.from, number)) {
      const S from = scalar_of<S>(*curve_.from);
      if (end <= from || is_key(*curve_.from, number + 1)) return {};
      if (start < from) first = (from - start) / (end - start);
    }
    if (curve_.to && !is_key(*curve_.to, number + 1)) {
      const S to = scalar_of<S>(*curve_.to);
      if (start >= to || is_key(*curve_.to, number)) return {};
      if (to < end) last = (to - start) / (end - start);
    }
    return pieces_of(segments, segment, first, last);
  }

  template <class S>
  void add(const spline::Segments<S>& segments, std::size_t segment, std::size_t number) {
    const std::vector<Piece<S>> all = pieces(segments, segment, number);
    if (all.empty()) return;
    for (const Piece<S>& piece : all) {
      std::optional<Ranges> ranges;
      if constexpr (std::is_same_v<S, Bounded>) {
        if (piece.is_whole()) ranges.emplace(piece);
      }
      for (std::size_t k = 0; k < measures_.size(); ++k) {
        Found& found = found_[k];
        if (ranges && found.search.best) {
          const double rough = found.search.best->value.rough();
          if (std::isnormal(rough) && ranges->are_below(measures_[k], rough)) continue;
        }
        const PiecePlace place{number, piece.part};
        const auto bound = found.search.add(form_of<Bounded>(piece, measures_[k]), place);
        if (!bound.is_settled) leave_open(found, {place, bound.upper});
      }
    }
    corners_.add(all, number, curve_.key_time(number));
  }

  static void leave_open(Found& found, const Open& piece) {
    found.open.push_back(piece);
    if (found.open.size() < 2 * found.kept + 64) return;
    std::erase_if(found.open, [&](const Open& x) { return x.upper && found.search.is_near(*x.upper); });
    found.kept = found.open.size();
  }

  /// A segment exactly. Many are kept, as measures often need the same ones.
  const spline::Segments<Rational>& exact(std::size_t number) {
    constexpr std::size_t most = 1 << 16;  // cubics
    const auto known = exact_.find(number);
    if (known != exact_.end()) return known->second;
    if (!exact_.empty() && exact_.size() * exact_.begin()->second.channels > most) exact_.clear();
    return exact_.emplace(number, curve_.exact(number)).first->second;
  }

  /// A piece of an exact segment; nothing where it has no such piece.
  std::optional<Piece<Rational>> exact_piece(const PiecePlace& place) {
    for (Piece<Rational>& piece : pieces(exact(place.segment), 0, place.segment)) {
      if (piece.part == place.part) return std::move(piece);
    }
    return std::nullopt;
  }

  std::optional<Extreme> maximum(std::size_t k) {
    const Measure& measure = measures_[k];
    Found& found = found_[k];
    const auto rest = measure.kind == Measure::Kind::curvature ? corners_.sharp_rest : std::nullopt;
    std::ranges::stable_sort(found.open, [](const Open& a, const Open& b) {
      return b.upper && (!a.upper || *b.upper < *a.upper);  // those without a bound first
    });
    constexpr std::size_t most = 2000;  // pieces that are searched with rationals
    for (std::size_t i = 0; i < found.open.size(); ++i) {
      const auto& [place, upper] = found.open[i];
      if (upper && (i >= most || found.search.is_near(*upper))) {
        found.search.raise(*upper);
        continue;
      }
      if (i >= most) return Extreme{.is_unproved = true};
      const auto piece = exact_piece(place);
      if (!piece) continue;
      auto form = form_of<Rational>(*piece, measure, !curve_.is_rational);
      if (!curve_.is_rational) shorten(form);
      if (form.power == 3 && !(rest && *rest <= place.segment)) {
        if (const auto sharp = sharp_rest(*piece, measure)) return unbounded(place, *sharp);
      }
      if (!found.search.add(form, place).is_settled) return Extreme{.is_unproved = true};
    }
    if (rest) return unbounded_at_end_of(*rest - 1);
    if (!found.search.best) return std::nullopt;
    return result_of(*found.search.best, found.search.high.value_or(found.search.best->value).exact(), measure);
  }

  Extreme unbounded(const PiecePlace& place, const Rational& at) {
    Extreme extreme{.is_unbounded = true};
    set_place(extreme, *exact_piece(place), place.segment, at, false);
    return extreme;
  }
  Extreme unbounded_at_end_of(std::size_t segment) {
    return unbounded({segment, pieces(exact(segment), 0, segment).back().part}, 1);
  }

  /// `between_parts`: the measure jumps between the parts of an ease.
  void set_place(Extreme& extreme, const Piece<Rational>& piece, std::size_t segment, const Rational& at,
                 bool between_parts) {
    const spline::Segments<Rational>& one = exact(segment);
    const Rational fraction = piece.begin + at * piece.size;
    extreme.time = one.times[0] + fraction * (one.times[1] - one.times[0]);
    extreme.side = at == 1 ? spline::Side::left : spline::Side::right;
    extreme.is_at_key = fraction == 0 || fraction == 1 || (between_parts && (at == 0 || at == 1));
    if (!curve_.has_positions) return;
    const Rational u = value_at(piece.parameter, at);
    for (const spline::Cubic<Rational>& x : piece.cubics) {
      extreme.position.push_back(nearest_double(x.p0 + u * (x.out + u * (x.c + u * x.d))));
    }
  }

  /// The maximum near a place at which a value is attained, and not above `high`.
  Extreme result_of(const Search::Attained& best, Rational high, const Measure& measure) {
    const Piece<Rational> piece = *exact_piece(best.piece);
    const Quotient<Rational> form = form_of<Rational>(piece, measure, !curve_.is_rational).quotient();
    // The derivative is above 0, 0 or below 0 as this polynomial is.
    const Polynomial<Rational> slope = form.power == 0
                                           ? derivative(form.over)
                                           : sum(product(derivative(form.over), form.base),
                                                 product(form.over, derivative(form.base)), Rational(-form.power));
    Rational place = best.place;
    bool is_exact = place == 0 || place == 1;
    if (!is_exact) {
      place = nearer_root(slope, place);
      is_exact = value_at(slope, place) == 0;
    }
    Rational low = form.at(place);
    if (low < best.value.exact()) {
      place = best.place;
      low = form.at(place);
      is_exact = false;
    }
    high = std::max(high, low);
    if (high - low <= abs(low) * Rational(0x1p-60)) {
      if (is_exact && curve_.is_rational) {
        high = low;
      } else {
        static const Rational rounding = power_of_two(-380);
        const Rational least = curve_.is_rational ? low : low - abs(low) * rounding;
        static const Rational refined = power_of_two(-160);  // of a maximum that is near the place by Newton's method
        auto simple = simple_fraction({(least + high) / 2, (high - least) / 2});
        if (!simple) simple = simple_fraction({low, abs(low) * refined});
        if (simple && least <= *simple && *simple <= high) low = high = *simple;
      }
    }
    Extreme extreme{low, high, {}};
    set_place(extreme, piece, best.piece.segment, place, measure.derivative > 1);
    return extreme;
  }

  /// A root of a polynomial near a place, at a simple fraction, or by Newton's method.
  static Rational nearer_root(const Polynomial<Rational>& x, const Rational& near) {
    const auto is_inside = [](const Rational& u) { return 0 <= u && u <= 1; };
    const Rational unit = power_of_two(140);
    Rational place = near;
    const Polynomial<Rational> rate = derivative(x);
    for (int i = 0; i < 2; ++i) {
      const Rational rise = value_at(rate, place);
      if (rise == 0) break;
      const Rational next = floor((place - value_at(x, place) / rise) * unit) / unit;
      if (!is_inside(next) || abs(next - near) > Rational(0x1p-20)) break;
      place = next;
    }
    for (const int bits : {-100, -36}) {
      const Rational room = power_of_two(bits);
      if (place <= room) continue;
      const Rational simple = simplest_between(place - room, place + room);
      if (is_inside(simple) && value_at(x, simple) == 0) return simple;
    }
    return place;
  }

  const MeasuredCurve& curve_;
  const std::vector<Measure>& measures_;
  Corners corners_;
  std::vector<Found> found_;
  std::map<std::size_t, spline::Segments<Rational>> exact_;
};

}  // namespace

bool Corner::turns(const std::vector<std::size_t>& compared, const std::vector<std::size_t>& measured) const {
  std::vector<std::size_t> sorted = measured;
  std::ranges::sort(sorted);
  std::vector<double> before, after;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (!std::ranges::binary_search(sorted, compared[i])) continue;
    before.push_back(in[i]);
    after.push_back(out[i]);
  }
  if (root_of_squares(before) == 0 || root_of_squares(after) == 0) return false;
  return distance(direction_of(std::move(before)), direction_of(std::move(after))) > least_change;
}

Extremes extremes(const MeasuredCurve& curve, const std::vector<Measure>& measures,
                  const std::vector<std::size_t>& channels) {
  return CurveSearch(curve, measures, channels).run();
}

}  // namespace tcb::limits
