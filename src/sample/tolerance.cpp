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
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "sample/chord.hpp"
#include "sample/grid.hpp"
#include "sample/least_rows.hpp"
#include "sample/places.hpp"

namespace tcb {
namespace {

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
