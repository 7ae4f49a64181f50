// Chords: how far a curve departs from them, by bounds on polynomials.
#include "sample/chord.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tcb/spline/derivatives.hpp"

namespace tcb {
namespace {

// Bernstein form: polynomials over [0, 1] by coefficients that bound them.
//
//   p(s) = sum of b_k C(N,k) s^k (1 - s)^(N - k), of degree N
// The values of p lie between the least and the largest b_k; b_0 and b_N are its values at both ends.
// Source: R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", 2012.

/// Coefficients, as many as the degree and one more.
template <std::size_t Size>
using Bernstein = std::array<double, Size>;

/// The polynomial with the coefficients of 1, s, s^2, ...
template <std::size_t Size>
Bernstein<Size> bernstein(std::array<double, Size> power) {
  double binomial = 1;
  for (std::size_t k = 1; k < Size; ++k) {
    binomial = binomial * static_cast<double>(Size - k) / static_cast<double>(k);
    power[k] /= binomial;
  }
  for (std::size_t step = 1; step < Size; ++step) {
    for (std::size_t k = Size - 1; k >= step; --k) power[k] += power[k - 1];
  }
  return power;
}

/// The parts of a polynomial before and after `s`, each over [0, 1] again: de Casteljau's algorithm.
template <std::size_t Size>
std::pair<Bernstein<Size>, Bernstein<Size>> divided_at(Bernstein<Size> whole, double s) {
  std::pair<Bernstein<Size>, Bernstein<Size>> parts;
  for (std::size_t left = Size; left-- > 0;) {
    parts.first[Size - 1 - left] = whole[0];
    parts.second[left] = whole[left];
    for (std::size_t k = 0; k < left; ++k) whole[k] += s * (whole[k + 1] - whole[k]);
  }
  return parts;
}

/// The factors of r^k, where p(s) = (1 - s)^N times their sum, and r = s / (1 - s).
template <std::size_t Size>
std::array<double, Size> scaled_powers(Bernstein<Size> p) {
  double binomial = 1;
  for (std::size_t k = 1; k < Size; ++k) {
    binomial = binomial * static_cast<double>(Size - k) / static_cast<double>(k);
    p[k] *= binomial;
  }
  return p;
}

/// The differences of successive coefficients, which are the coefficients of the derivative divided by the degree.
template <std::size_t Size>
Bernstein<Size - 1> differences(const Bernstein<Size>& p) {
  Bernstein<Size - 1> result;
  for (std::size_t k = 0; k + 1 < Size; ++k) result[k] = p[k + 1] - p[k];
  return result;
}

/// A maximum of a polynomial near `s`, by Newton's method; without one nearby, some place between the ends.
template <std::size_t Size>
double stationary_place(const Bernstein<Size>& p, double s) {
  constexpr double margin = 1.0 / 64, degree = Size - 1;
  const auto first = differences(p);
  const auto slope = scaled_powers(first);
  const auto bend = scaled_powers(differences(first));
  const auto sum = [](const auto& powers, double r) {
    double result = 0;
    for (std::size_t k = powers.size(); k-- > 0;) result = result * r + powers[k];
    return result;
  };
  for (int step = 0; step < 6; ++step) {
    const double r = s / (1 - s), second = sum(bend, r);
    if (!(second < 0)) break;
    const double next = std::clamp(s - (1 - s) * sum(slope, r) / ((degree - 1) * second), margin, 1 - margin);
    const bool found = next - s < 1e-5 && s - next < 1e-5;  // the next step would be less than 1e-9
    s = next;
    if (found) break;
  }
  return s;
}

/// The maximum over [0, 1] of a polynomial and of `known`, or more: by two parts in 10^10 at most, unless `parts` parts
/// are too few to show that.
template <std::size_t Size>
double upper_bound(const Bernstein<Size>& p, double known, int& parts) {
  const auto top = std::ranges::max_element(p);
  known = std::max({known, p.front(), p.back()});
  if (!(*top > known * (1 + 1e-10))) return std::max(known, *top);
  if (--parts <= 0) return *top;
  const double middle = static_cast<double>(top - p.begin()) / static_cast<double>(Size - 1);
  const auto [before, after] = divided_at(p, stationary_place(p, middle));
  return upper_bound(after, upper_bound(before, known, parts), parts);
}

using Powers = Chord::Powers;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_parts = 1 << 10;  // that one bound tries; a cubic comes near the limit at a few places only

double square(double number) { return number * number; }

/// |q|^2 of a part q.
std::array<double, 7> squared_norm(const std::vector<Powers>& part) {
  std::array<double, 7> sum{};
  for (const Powers& q : part) {
    sum[0] += q[0] * q[0];
    sum[1] += 2 * q[0] * q[1];
    sum[2] += 2 * q[0] * q[2] + q[1] * q[1];
    sum[3] += 2 * (q[0] * q[3] + q[1] * q[2]);
    sum[4] += 2 * q[1] * q[3] + q[2] * q[2];
    sum[5] += 2 * q[2] * q[3];
    sum[6] += q[3] * q[3];
  }
  return sum;
}

/// The maximum of |q|^2 where q is the whole part between two points of the chord, if it has one maximum only.
std::optional<double> single_maximum(const std::vector<Powers>& part) {
  double aa = 0, ab = 0, bb = 0;
  for (const Powers& q : part) {
    aa += q[1] * q[1];
    ab -= q[1] * q[3];
    bb += q[3] * q[3];
  }
  if (aa == 0 && bb == 0) return 0;
  if (3 * ab + aa < 0 && 2 * bb + ab - aa > 0) return std::nullopt;
  double low = 0, high = 1, s = 0.5;
  for (int step = 0; step < 60 && high - low > 1e-9; ++step) {
    const double slope = aa + s * (3 * ab - 2 * aa + s * (2 * bb - 5 * ab - s * (3 * bb)));
    const double bend = 3 * ab - 2 * aa + s * (2 * (2 * bb - 5 * ab) - s * (9 * bb));
    (slope > 0 ? low : high) = s;
    const double next = s - slope / bend;
    const bool inside = next > low && next < high;
    const double before = s;
    s = inside ? next : low + (high - low) / 2;
    if (std::abs(s - before) < 1e-9) break;
  }
  return square(s * (1 - s)) * (aa + s * (2 * ab + s * bb));
}

/// The largest square over [0, 1] of a cubic with these powers, at its ends and where its derivative is 0.
double largest_square(const Powers& cubic) {
  const auto square_at = [&](double s) { return square(cubic[0] + s * (cubic[1] + s * (cubic[2] + s * cubic[3]))); };
  double largest = std::max(square_at(0), square_at(1));
  const auto try_place = [&](double s) {
    if (s > 0 && s < 1) largest = std::max(largest, square_at(s));
  };
  const double c1 = cubic[1], c2 = cubic[2], c3 = cubic[3];
  const double discriminant = c2 * c2 - 3 * c1 * c3;
  if (discriminant < 0) return largest;
  const double sum = -(c2 + std::copysign(std::sqrt(discriminant), c2));  // 3 c3 s^2 + 2 c2 s + c1 = 0
  try_place(sum / (3 * c3));
  try_place(c1 / sum);
  return largest;
}

/// The squared distances of a part of the curve from the line of the chord and from its two points, and its place along
/// the chord.
struct Distances {
  Bernstein<7> line, first, last;
  Bernstein<4> along;

  bool is_between(double from, double to) const {
    return std::ranges::all_of(along, [=](double place) { return place >= from && place <= to; });
  }

  /// A bound on the squared distance from the chord, or infinity if none that is at most `limit` was found. Requires:
  /// the part begins within the limit.
  double bound(double length, double limit, int& parts) const {
    double least = std::min(std::ranges::max(first), std::ranges::max(last));
    if (is_between(0, length)) least = std::min(least, std::ranges::max(line));
    if (least <= limit) return least;
    if (--parts <= 0) return infinity;
    const auto [line0, line1] = divided_at(line, 0.5);
    const auto [first0, first1] = divided_at(first, 0.5);
    const auto [last0, last1] = divided_at(last, 0.5);
    const auto [along0, along1] = divided_at(along, 0.5);
    const Distances before{line0, first0, last0, along0}, after{line1, first1, last1, along1};
    if (!(after.at_start(length) <= limit)) return infinity;
    const double half = before.bound(length, limit, parts);
    if (half == infinity) return infinity;
    return std::max(half, after.bound(length, limit, parts));
  }

  double at_start(double length) const {
    if (along[0] < 0) return first[0];
    return along[0] > length ? last[0] : line[0];
  }
};

/// A bound on squared distances in units of its limit.
double in_limits(double bound, double limit2) {
  return bound <= std::numeric_limits<double>::max() ? bound / limit2 : infinity;
}

}  // namespace

Chord::Chord(double tolerance) {
  constexpr int most = 1022;  // so that the scale and its reciprocal are normal
  const int exponent = std::clamp(std::ilogb(tolerance), -most, most);
  scale_ = std::ldexp(1.0, -exponent);
  tolerance_ = tolerance * scale_;
}

void Chord::set_start(const CurvePoint& from, const CurveSegment& segment) {
  from_ = &from;
  direction_.resize(from.x.size());
  expand(start_, segment, from.u);
  first_limit2_ = limit2(segment);
}

void Chord::set_end(const CurvePoint& to) {
  to_ = &to;
  for (std::size_t i = 0; i < direction_.size(); ++i) direction_[i] = (to.x[i] - from_->x[i]) * scale_;
  set_direction();
}

/// The length of the chord, and its direction instead of its extent.
void Chord::set_direction() {
  double norm2 = 0;
  for (const double part : direction_) norm2 += part * part;
  constexpr double least = 1e-200, most = 1e200;  // so that squares neither underflow nor overflow
  double largest = 1;
  if (!(norm2 > least && norm2 < most)) {
    largest = 0;
    for (const double part : direction_) largest = std::max(largest, std::abs(part));
    length_ = 0;
    if (largest == 0) return;
    norm2 = 0;
    for (double& part : direction_) {
      part /= largest;
      norm2 += part * part;
    }
  }
  const double norm = std::sqrt(norm2), inverse = 1 / norm;
  for (double& part : direction_) part *= inverse;
  length_ = largest * norm;
}

double Chord::departure(double u) {
  const double size = u - from_->u;
  if (direction_.size() == 1) {
    // In the graph of a cubic over its local parameter, the chord takes away what is linear.
    const auto [x0, x1, x2, x3] = start_[0];
    const double c2 = x2 * size * size, c3 = x3 * size * size * size;
    return in_limits(largest_square({0, -c2 - c3, c2, c3}), first_limit2_);
  }
  for (std::size_t i = 0; i < direction_.size(); ++i) {
    direction_[i] = size * (start_[i][1] + size * (start_[i][2] + size * start_[i][3]));
  }
  set_direction();
  return in_limits(across(start_, size, true, first_limit2_), first_limit2_);
}

double Chord::departure(const CurveSegment& segment, double low, double high) {
  const double limit = limit2(segment);
  if (direction_.size() == 1) return in_limits(on_graph(segment, low, high), limit);
  expand(expansion_, segment, low);
  return in_limits(across(expansion_, high - low, false, limit), limit);
}

double Chord::limit2(const CurveSegment& segment) const {
  constexpr double rounding = 0x1p-51;  // of positions, in units of the largest position or tangent
  double size = 0;
  for (std::size_t i = 0; i < direction_.size(); ++i) {
    const auto& x = metric_cubic(segment, i);
    size = std::max({size, std::abs(x.p0), std::abs(x.p1), std::abs(x.out), std::abs(x.in)});
  }
  return square(tolerance_ * (1 - 1e-9) - std::min(rounding * size * scale_, tolerance_ / 4));
}

void Chord::expand(std::vector<Powers>& powers, const CurveSegment& segment, double low) const {
  const spline::LocalParameter<double> at{low, low - 1};
  const bool is_start = segment.number == from_->segment && low == from_->u;
  powers.resize(direction_.size());
  for (std::size_t i = 0; i < powers.size(); ++i) {
    const spline::Cubic<double>& x = metric_cubic(segment, i);
    const auto [d1, d2, d3] = spline::local_derivatives(x, at);
    const double start = is_start ? 0 : spline::position(x, at) - from_->x[i];
    powers[i] = {start * scale_, d1 * scale_, d2 / 2 * scale_, d3 / 6 * scale_};
  }
}

/// The bound on the square of the distance from the chord of a part of a path that has this size in the local
/// parameter. `is_whole`: the chord joins its ends.
double Chord::across(const std::vector<Powers>& expansion, double size, bool is_whole, double limit2) {
  across_.resize(direction_.size());
  Powers along{};
  const double size2 = size * size, size3 = size2 * size;
  for (std::size_t i = 0; i < across_.size(); ++i) {
    const Powers& x = expansion[i];
    across_[i] = {x[0], x[1] * size, x[2] * size2, x[3] * size3};
    for (std::size_t k = 0; k < along.size(); ++k) along[k] += across_[i][k] * direction_[i];
  }
  for (std::size_t i = 0; i < across_.size(); ++i) {
    for (std::size_t k = 0; k < along.size(); ++k) across_[i][k] -= along[k] * direction_[i];
  }
  Distances distances{{}, {}, {}, bernstein<4>(along)};
  const double beyond = 1e-5 * tolerance_;  // adds 1e-10 of the squared tolerance to a squared distance
  const bool is_between = distances.is_between(-beyond, length_ + beyond);
  if (is_between && is_whole) {
    if (const auto found = single_maximum(across_)) return *found;
  }
  distances.line = bernstein<7>(squared_norm(across_));
  int parts = most_parts;
  if (is_between) return upper_bound(distances.line, 0, parts);
  across_.emplace_back(along);
  distances.first = bernstein<7>(squared_norm(across_));
  across_.back()[0] -= length_;
  distances.last = bernstein<7>(squared_norm(across_));
  return distances.at_start(length_) <= limit2 ? distances.bound(length_, limit2, parts) : infinity;
}

/// In each part of the warp u = start + b s + c s^2 + d s^3, where s is linear in time; with ease d = 0.
double Chord::on_graph(const CurveSegment& segment, double low, double high) {
  int parts = most_parts;
  double found = 0, start = low;
  Time passed = segment.warp.inverse({low, low - 1});
  for (const double next : {segment.warp.end_of_first_part(), segment.warp.start_of_last_part(), high}) {
    const double end = std::min(next, high);
    if (!(end > start)) continue;
    const Time until = segment.warp.inverse({end, end - 1});
    const double duration = (until - passed).hi;
    const double d = segment.warp.third_derivative() * duration * duration * duration / 6;
    const double at_middle = segment.warp.second_derivative(((passed + until) * Time(0.5)).hi);
    const double c = at_middle * duration * duration / 2 - 1.5 * d;
    expand(expansion_, segment, start);
    found = std::max(
        found, on_part_of_graph({end - start - c - d, c, d}, place(segment, passed), place(segment, until), parts));
    start = end;
    passed = until;
  }
  return found;
}

/// The fraction of the chord's duration at a fraction of the segment's.
double Chord::place(const CurveSegment& segment, const Time& passed) const {
  if (to_->t == from_->t) return 0;
  const Time start = segment.precise(segment.start), from = segment.precise(from_->t);
  return ((start - from + passed * segment.duration()) / (segment.precise(to_->t) - from)).hi;
}

/// Where u has these coefficients of s, s^2 and s^3, and the chord is at `first` and `last` of its duration at the ends
/// of s.
double Chord::on_part_of_graph(const std::array<double, 3>& u, double first, double last, int& parts) const {
  const auto [x0, x1, x2, x3] = expansion_[0];
  const auto [b, c, d] = u;
  const double height = (to_->x[0] - from_->x[0]) * scale_;
  const std::array<double, 7> gap{x0 - height * first,
                                  x1 * b - height * (last - first),
                                  x1 * c + x2 * b * b,
                                  2 * x2 * b * c + x3 * b * b * b,
                                  x2 * c * c + 3 * x3 * b * b * c,
                                  3 * x3 * b * c * c,
                                  x3 * c * c * c};
  if (c == 0 && d == 0) return largest_square({gap[0], gap[1], gap[2], gap[3]});
  const auto bounded_square = [&parts](auto numbers) {
    const double above = upper_bound(numbers, 0, parts);
    for (double& number : numbers) number = -number;
    return square(upper_bound(numbers, above, parts));
  };
  if (d == 0) return bounded_square(bernstein<7>(gap));
  return bounded_square(bernstein<10>(
      {gap[0], gap[1], gap[2], gap[3] + x1 * d, gap[4] + 2 * x2 * b * d, gap[5] + d * (2 * x2 * c + 3 * x3 * b * b),
       gap[6] + d * (x2 * d + 6 * x3 * b * c), 3 * d * x3 * (c * c + b * d), 3 * d * d * x3 * c, d * d * d * x3}));
}

}  // namespace tcb
