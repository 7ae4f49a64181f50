// Tolerance: few rows whose polyline stays near the curve, by a greedy search.
//
// From each row the next one is taken as far along as the chord between them keeps every point of the curve within the
// tolerance, by a bound (see sample/chord.hpp), not by samples. Whole segments are tried first. In the segment in which
// the row lies the search begins at the distance of the last two rows. It follows the departure, which grows with about
// the fourth power of the chord, so that its fourth root is nearly linear; where that does not help, it halves. A row
// between keys is where its time is printed, if rounding that matters. A rotation is tried at places of each segment
// against the arc between the rows at equal times. With a single metric channel the polyline is its graph over time,
// and the distance is taken at equal times.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "sample/build.hpp"
#include "sample/chord.hpp"
#include "sample/grid.hpp"
#include "sample/places.hpp"
#include "tcb/spline/derivatives.hpp"

namespace tcb {
namespace {

// How many rows any polyline within a tolerance of a curve has at least.

// A lower bound on the rows from the curvature, by which too many are refused before the search.
//
// Where a chord is within D of a part of the curve of length h in the local parameter, then across the chord the curve
// is a cubic p with |p| <= D there. By the inequality of the brothers Markov |p'| <= 18 D / h and |p''| <= 96 D / h^2.
// Of the velocity X' and the acceleration X'' at any place of that part only p' and p'' are across the chord, so
//   |X' ^ X''| <= |X'| 96 D / h^2 + |X''| 18 D / h
// which limits h. In a graph over time where |X''| >= m, the curve departs from the chord by m h^2 / 8 in all, which is
// at most 2 D. So a part of length L takes L / h chords, of which it may share the first and the last.
// Source: P. Borwein, T. Erdelyi, "Polynomials and Polynomial Inequalities", 1995, section 5.1.

inline constexpr int parts_of_segment = 16;

/// The longest part of a graph that one chord may cover, where its second derivative is `least` at least.
double longest_in_graph(double least, double tolerance) { return 4 * std::sqrt(tolerance / least); }

/// The longest part of a path that one chord may cover, where |X' ^ X''| >= least, |X'| <= speed and |X''| <= change.
double longest_on_path(double least, double speed, double change, double tolerance) {
  const double linear = 18 * change * tolerance;
  return (linear + std::sqrt(linear * linear + 4 * least * 96 * speed * tolerance)) / (2 * least);
}

/// |v ^ a|: the size of v times that of the part of a across it.
double wedge(const spline::MetricView<double>& v, const spline::MetricView<double>& a) {
  const double size = spline::norm(v);
  double along = 0, across2 = 0;
  for (std::size_t i = 0; i < v.size(); ++i) along += a[i] * (v[i] / size);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double across = a[i] - along * (v[i] / size);
    across2 += across * across;
  }
  return size * std::sqrt(across2);
}

/// How many chords the part around a place takes at least, without two that it may share with its neighbours. `at`:
/// memory to reuse.
double chords(const CurveSegment& segment, double middle, double tolerance, spline::Derivatives<double>& at) {
  constexpr double half = 0.5 / parts_of_segment;
  spline::set_derivatives<double>(at, segment.cubics, {middle, middle - 1}, {}, middle, 1);
  const spline::MetricView<double> v(at.velocity, segment.metric), a(at.acceleration, segment.metric),
      j(at.jerk, segment.metric);
  const double jerk = spline::norm(j), change = spline::norm(a) + half * jerk, speed = spline::norm(v) + half * change;
  double longest = 0, least = 0;
  if (v.size() == 1) {
    least = std::abs(a[0]) - half * jerk;
    longest = longest_in_graph(least, tolerance);
  } else {
    least = wedge(v, a) - half * speed * jerk;  // the derivative of X' ^ X'' is X' ^ X'''
    longest = longest_on_path(least, speed, change, tolerance);
  }
  const bool is_bound = least > 0 && std::isfinite(least) && longest >= 0;
  return is_bound ? std::max(2 * half / longest - 2, 0.0) : 0;
}

double least_rows(const KeptCurve& curve, double tolerance) {
  double sum = 2;
  spline::Derivatives<double> memory;
  for (std::uint64_t number = 0; number < curve.size(); ++number) {
    const CurveSegment segment = curve.segment(number);
    if (metric_size(segment) == 1 && !segment.warp.is_identity()) continue;  // its graph is not a cubic
    for (int part = 0; part < parts_of_segment; ++part)
      sum += chords(segment, (part + 0.5) / parts_of_segment, tolerance, memory);
  }
  return sum;
}

// A lower bound on the rows from points of the curve, which is much closer.
//
// If one chord is within D of three points A, X and B, then one of them, the middle one along the chord, is within 2 D
// of the segment between the others: the two ends are within D of the chord, so their segment is within D of it. So if
// each of the three is farther than 2 D from the segment between the others, a row lies between the first and the last
// of them. In a graph over time X is in the middle. Triples that share no more than end points need a row each.

/// Counts the rows that are needed. Points are added in their order along the curve; the more, the better the bound.
class NeededRows {
 public:
  explicit NeededRows(double tolerance) : tolerance_(tolerance) {}

  void add(const CurvePoint& point) {
    points_[size_++] = point;
    if (size_ >= 3 && no_chord_is_near(points_[0], points_[size_ / 2], point)) {
      ++between_;
      points_[0] = point;
      size_ = 1;
    } else if (size_ == points_.size()) {
      for (std::size_t i = 1; 2 * i < size_; ++i) points_[i] = points_[2 * i];
      size_ /= 2;
    }
  }

  /// With the rows at both ends.
  std::uint64_t count() const { return between_ + 2; }

 private:
  bool no_chord_is_near(const CurvePoint& a, const CurvePoint& x, const CurvePoint& b) const {
    double size = 0;
    for (const CurvePoint* point : {&a, &x, &b}) {
      for (const double number : point->x) size = std::max(size, std::abs(number));
    }
    const double least = 2 + 1e-9 + 0x1p-49 * size / tolerance_;  // with the rounding of positions
    if (a.x.size() == 1) return height(a, x, b) > least;
    const double least2 = least * least;
    return distance2(x, a, b) > least2 && distance2(a, x, b) > least2 && distance2(b, a, x) > least2;
  }

  /// How far x is from the line between the others at its time, in tolerances.
  double height(const CurvePoint& a, const CurvePoint& x, const CurvePoint& b) const {
    if (!(a.t < x.t && x.t < b.t)) return 0;
    const double part = ((x.t - a.t) / (b.t - a.t)).hi;
    return std::abs((x.x[0] - a.x[0]) / tolerance_ - part * ((b.x[0] - a.x[0]) / tolerance_));
  }

  /// The square of the distance of x from the segment between the others, in tolerances.
  double distance2(const CurvePoint& x, const CurvePoint& a, const CurvePoint& b) const {
    const auto difference = [&](const CurvePoint& p, const CurvePoint& q, std::size_t i) {
      return (p.x[i] - q.x[i]) / tolerance_;
    };
    double along = 0, length2 = 0, sum = 0;
    for (std::size_t i = 0; i < x.x.size(); ++i) {
      along += difference(x, a, i) * difference(b, a, i);
      length2 += difference(b, a, i) * difference(b, a, i);
    }
    const double part = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
    for (std::size_t i = 0; i < x.x.size(); ++i) {
      const double gap = difference(x, a, i) - part * difference(b, a, i);
      sum += gap * gap;
    }
    return sum;
  }

  double tolerance_;
  std::uint64_t between_ = 0;
  std::array<CurvePoint, 64> points_;  ///< since the last row that was counted; of more, every second one
  std::size_t size_ = 0;
};

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Finds row after row along a curve.
class Walker {
 public:
  Walker(const KeptCurve& curve, const CurveTolerance& tolerance, bool at_keys)
      : curve_(curve),
        tolerance_(tolerance),
        chord_(tolerance.distance),
        turns_(tolerance.angle * 0.99),
        at_keys_(at_keys),
        kept_(curve.segment(0)) {}

  void set_first(CurvePoint& place) { set(place, segment(0), 0); }

  /// Sets `to` to the next row: the farthest place that a chord from here may reach. Where keys between them are rows
  /// as well, the chords by these keys are near the curve, too.
  void set_next(const CurvePoint& from, CurvePoint& to) {
    set_start(from);
    set_farthest(from, next_corner(from), to);
    if (at_keys_ && !reaches_by_keys(from, to)) {
      set_start(from);
      set_farthest(from, next_key(from), to);
    }
    step_ = place_of(to) - place_of(from);
  }

  /// Adds the points at the quarters of the way between two places, and the second place.
  void add_points(NeededRows& needed, const CurvePoint& from, const CurvePoint& to) {
    const double start = place_of(from), end = place_of(to);
    for (const double part : {0.25, 0.5, 0.75}) {
      const double place = start + (end - start) * part;
      const double number = std::min(std::floor(place), static_cast<double>(curve_.size() - 1));
      set(tried_, segment(static_cast<std::uint64_t>(number)), place - number);
      needed.add(tried_);
    }
    needed.add(to);
  }

  /// Sets `place` to the key with this number, as the end of the segment before it.
  void set_key(CurvePoint& place, std::uint64_t number) { set(place, segment(number - 1), 1); }

  bool is_end(const CurvePoint& place) const { return place.segment + 1 == curve_.size() && place.u == 1; }

 private:
  /// A place on a segment, and the fourth root of how far the curve departs from the chord that ends there: at most 1
  /// where the chord is near the curve.
  struct Tried {
    double u, root;
  };

  /// A segment, until the next call.
  const CurveSegment& segment(std::uint64_t number) {
    if (number != kept_.number) kept_ = curve_.segment(number);
    return kept_;
  }

  /// In segments from the first key.
  static double place_of(const CurvePoint& point) { return static_cast<double>(point.segment) + point.u; }

  /// Of larger departures only that they are larger matters.
  static constexpr double most_followed = 16;

  /// Sets `to` to the farthest place that a chord from here may reach, up to the key `corner`.
  void set_farthest(const CurvePoint& from, std::uint64_t corner, CurvePoint& to) {
    std::uint64_t good = from.segment, step = 1;  // the keys that end the segments before `good` can be reached
    double last = 0;                              // the root at the key before `good`
    const auto reaches_key = [&](std::uint64_t number) {
      set_key(tried_, number);
      const double root = root_to(tried_);
      if (root <= 1) last = root;
      return root <= 1;
    };
    while (good < corner && reaches_key(std::min(good + step, corner))) {
      good = std::min(good + step, corner);
      step *= 2;
    }
    for (step /= 2; step > 0; step /= 2) {
      if (good + step < corner && reaches_key(good + step)) good += step;
    }
    if (good == corner) {
      set_key(to, corner);
    } else {
      set_within(from, good, last, to);
    }
  }

  /// Sets `to` to the farthest place on a segment, whose own end is out of reach. `root`: that of its start.
  void set_within(const CurvePoint& from, std::uint64_t number, double root, CurvePoint& to) {
    const CurveSegment segment = this->segment(number);
    const bool is_simple = is_cubic_on(number) && !tolerance_.limits_angle();
    const auto root_of = [&](double u) {
      if (is_simple) return std::sqrt(std::sqrt(chord_.departure(u)));
      set(tried_, segment, u);
      return root_to(tried_);
    };
    const double guess = place_of(from) + step_ - static_cast<double>(number);
    const Tried start = number == from.segment ? Tried{from.u, 0} : Tried{0, root};
    const Tried low = last_reached(start, guess, root_of);
    if (low.u == 0 && number > 0) {
      set_key(to, number);
    } else {
      set_printed(to, segment, low.u);
    }
    if (to.u != low.u && root_to(to) > 1) {
      const auto printed_root = [&](double u) {
        set_printed(tried_, segment, u);
        return root_to(tried_);
      };
      set_printed(to, segment, halved(number == from.segment ? from.u : 0, low.u, printed_root));
    }
    if (number == from.segment && to.u <= from.u)
      throw usage_error("the tolerance is too small: two rows would be the same; give a larger tolerance")
          .about("--tolerance");
  }

  /// The last place on a segment that was found to be reached, if `start` is and the end of the segment is not; `start`
  /// where none after it was found. `guess`: where that may be.
  template <class RootOf>
  static Tried last_reached(const Tried& start, double guess, const RootOf& root_of) {
    constexpr double least = 1 - 1e-4, aim = 1 - 3e-5;  // near enough: at most a ten-thousandth more rows
    Tried low = start, high{1, unlimited}, before = start, last = high;
    const auto is_narrow = [&] {
      const double middle = low.u + (high.u - low.u) / 2;
      if (!(low.u < middle && middle < high.u)) return true;  // no double is between them
      return low.u > start.u ? high.u - low.u <= 1e-9 * (low.u - start.u) : high.u - low.u <= 0x1p-48;
    };
    for (int step = 0; low.root < least && !is_narrow(); ++step) {
      const double secant = last.u + (aim - last.root) * (last.u - before.u) / (last.root - before.root);
      const double next = step == 0 && guess < high.u ? guess : secant;
      // Where the guess is not near, a farther place may be reached beyond one that is not.
      const bool is_near = step != 1 || (last.root > 0.9 && last.root < 1.15);
      const bool follows =
          is_near && step % 8 != 7 && next > low.u && next < high.u;  // not a number after an infinite root
      before = step == 0 ? start : last;
      last.u = follows ? next : low.u + (high.u - low.u) / 2;
      last.root = root_of(last.u);
      (last.root <= 1 ? low : high) = last;
    }
    return low;
  }

  /// The last place between two local parameters that 48 halvings reach.
  template <class RootOf>
  static double halved(double low, double high, const RootOf& root_of) {
    for (int halving = 0; halving < 48; ++halving) {
      const double middle = low + (high - low) / 2;
      (root_of(middle) <= 1 ? low : high) = middle;
    }
    return low;
  }

  /// Sets `place` to a local parameter of a segment; its memory is used again.
  static void set(CurvePoint& place, const CurveSegment& segment, double u) {
    place.segment = segment.number;
    place.u = u;
    place.t = u == 0 ? segment.start : u == 1 ? segment.end : time_on(segment, u);
    place.x.resize(metric_size(segment));
    for (std::size_t i = 0; i < place.x.size(); ++i) {
      place.x[i] = spline::position(metric_cubic(segment, i), {u, u - 1});
    }
  }

  /// The same, but at the time that its row prints, where rounding that moves it by more than limits allow for.
  void set_printed(CurvePoint& place, const CurveSegment& segment, double u) const {
    set(place, segment, u);
    const Time t = rounded_time(place.t, segment.decimals);
    const auto at = segment.time_map()(segment.precise(std::clamp(t, segment.start, segment.end)));
    const auto is_moved = [&](std::size_t i) {
      return std::abs(spline::position(metric_cubic(segment, i), at) - place.x[i]) > tolerance_.distance * 1e-10;
    };
    bool moves = false;
    for (std::size_t i = 0; i < place.x.size(); ++i) moves = moves || is_moved(i);
    if (!moves) return;
    place.u = at.u;
    place.t = t;
    for (std::size_t i = 0; i < place.x.size(); ++i) place.x[i] = spline::position(metric_cubic(segment, i), at);
  }

  /// Chords start here.
  void set_start(const CurvePoint& from) {
    from_ = &from;
    first_ = segment(from.segment);
    if (tolerance_.limits_distance()) chord_.set_start(from, first_);
  }

  /// Whether the departure of a chord from the start to this segment is that of one cubic.
  bool is_cubic_on(std::uint64_t number) const {
    const bool is_graph = from_->x.size() == 1;
    return number == from_->segment && tolerance_.limits_distance() && (!is_graph || first_.warp.is_identity());
  }

  /// The fourth root of how far the curve departs from the chord to a place; infinity where that is unknown.
  double root_to(const CurvePoint& to) {
    const bool limits_distance = tolerance_.limits_distance() && !is_cubic_on(to.segment);
    double departure = is_cubic_on(to.segment) ? chord_.departure(to.u) : 0;
    if (limits_distance) chord_.set_end(to);
    const bool limits_angle = tolerance_.limits_angle();
    if (limits_angle) turns_.set(turn_place(*from_), turn_place(to));
    if (!limits_distance && !limits_angle) return std::sqrt(std::sqrt(departure));
    for (std::uint64_t number = from_->segment; number <= to.segment && departure <= most_followed; ++number) {
      const double low = number == from_->segment ? from_->u : 0;
      const double high = number == to.segment ? to.u : 1;
      if (low >= high) continue;
      const CurveSegment& on = segment(number);
      if (limits_distance) departure = std::max(departure, chord_.departure(on, low, high));
      if (limits_angle) departure = std::max(departure, turns_.departure(on, low, high, most_followed));
    }
    return std::sqrt(std::sqrt(departure));
  }

  TurnPlace turn_place(const CurvePoint& place) { return {segment(place.segment), {place.u, place.u - 1}, place.t}; }

  /// The chords from key to key between two places are near the curve.
  bool reaches_by_keys(const CurvePoint& from, const CurvePoint& to) {
    for (std::uint64_t number = next_key(from); number <= to.segment; ++number) {
      set_key(tried_, number);
      if (root_to(tried_) > 1) return false;
      std::swap(key_, tried_);
      set_start(key_);
    }
    return root_to(to) <= 1;
  }

  /// The number of the first key after a place.
  static std::uint64_t next_key(const CurvePoint& from) { return from.segment + (from.u == 1 ? 2 : 1); }

  /// The number of the first key after a place where the curve has a corner, or of the last one.
  std::uint64_t next_corner(const CurvePoint& from) {
    if (corner_ >= next_key(from)) return corner_;
    corner_ = next_key(from);
    while (corner_ < curve_.size() && !(tolerance_.limits_distance() && is_corner(corner_))) ++corner_;
    return corner_;
  }

  /// The directions before and after a key differ, or it has none.
  bool is_corner(std::uint64_t number) const {
    const CurveSegment before = curve_.segment(number - 1);
    const CurveSegment after = curve_.segment(number);
    const bool graph = metric_size(before) == 1;
    const double h0 = graph ? (before.end - before.start).hi : 1;
    const double h1 = graph ? (after.end - after.start).hi : 1;
    double in2 = 0, out2 = 0, both = 0, size = 0;
    for (std::size_t i = 0; i < metric_size(before); ++i) {
      size = std::max({size, std::abs(metric_cubic(before, i).in / h0), std::abs(metric_cubic(after, i).out / h1)});
    }
    if (size == 0) return !graph;
    for (std::size_t i = 0; i < metric_size(before); ++i) {
      const double in = metric_cubic(before, i).in / h0 / size;
      const double out = metric_cubic(after, i).out / h1 / size;
      in2 += in * in;
      out2 += out * out;
      both += in * out;
    }
    constexpr double same = 1 - 1e-12;  // the cosine of an angle of a millionth
    if (graph) return std::abs(std::sqrt(in2) - std::sqrt(out2)) > 1e-9 * std::sqrt(in2) || both < 0;
    return !(both > 0 && both * both >= same * in2 * out2);
  }

  const KeptCurve& curve_;
  CurveTolerance tolerance_;
  Chord chord_;
  TurnChord turns_;
  bool at_keys_;
  CurveSegment kept_;                 ///< the last one used
  const CurvePoint* from_ = nullptr;  ///< where chords start
  CurveSegment first_{};              ///< the segment of that place
  CurvePoint tried_, key_;            ///< memory to reuse
  std::uint64_t corner_ = 0;          ///< the last one found
  double step_ = 0;                   ///< from the last row but one to the last one, in segments
};

/// Throws: Error (usage) where positions at a place are rounded by more than the tolerance.
void require_resolution(const CurvePoint& place, double tolerance) {
  for (const double number : place.x) {
    const double size = std::abs(number), rounding = (std::nextafter(size, unlimited) - size) / 2;
    if (rounding <= tolerance) continue;
    throw usage_error(
        "the tolerance is too small: a position of {} at {} is rounded by up to {:.4g}; give a larger tolerance",
        number, time_text(place.t), rounding)
        .about("--tolerance");
  }
}

}  // namespace

ToleranceRows rows_within_tolerance(const KeptCurve& curve, const CurveTolerance& tolerance, std::uint64_t max_rows,
                                    bool at_keys) {
  constexpr double most = 1e300;
  const double least = std::min(std::floor(least_rows(curve, tolerance.distance)), most);
  require_rows(Rational(least) - 1, max_rows, true);
  Walker walker(curve, tolerance, at_keys);
  std::vector<Time> times;
  CurvePoint place, next;
  walker.set_first(place);
  times.push_back(place.t);
  NeededRows needed(tolerance.distance);
  needed.add(place);
  require_resolution(place, tolerance.distance);
  for (std::uint64_t key = 1; key <= curve.size(); ++key) {
    walker.set_key(next, key);
    require_resolution(next, tolerance.distance);
  }
  while (!walker.is_end(place)) {
    walker.set_next(place, next);
    if (tolerance.limits_distance()) walker.add_points(needed, place, next);
    std::swap(place, next);
    require_resolution(place, tolerance.distance);
    times.push_back(rounded_time(place.t, curve.segment(place.segment).decimals));
    if (times.size() > max_rows) require_rows(Rational(times.size() - 1), max_rows);
  }
  return {std::move(times), std::max(static_cast<std::uint64_t>(least), needed.count())};
}

}  // namespace tcb
