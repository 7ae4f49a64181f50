// Lengths in balls: panels under one quadrature rule, with bounds on the errors of the rule and of its rounding.
//
// The bound of the rule is that of tcb/spline/detail/panel.hpp. On a smooth panel the quartic q under the root has no
// zero in the disc |z| <= R = 1.7. So with root = sqrt(q(0)) the rule errs by less than 2^-99 root, and for |z| <= 1
//   sqrt(q) >= (1 - 1/R)^2 root > 0.16 root,   the sum of the sizes of the terms of q < (1 + 1/R)^4 root^2 < 7 root^2.
// Double-doubles err by less than 2^-99 of a term in each operation, so that q errs by less than 2^-93 root^2, its root
// by less than 2^-90 root, and the rule by less than 2^-88 root. The coefficients of q have errors of their own.
// Where all derivatives are exactly 0 at an end, they are divided by the place, so that the panel there is smooth, too.
// Other cusps are in panels that are halved until their lengths have no effect.
#include "exact/ball_length.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "exact/rounding.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

constexpr std::size_t points = 32;
/// With rho = R + sqrt(R^2 - 1) the rule errs by at most 64/15 * 4 root / (rho^64 - rho^62) < 2^-99 root.
constexpr double disc = 1.7;
constexpr double rule_error = 0x1p-88;  ///< per root and width, with that of rounding

/// The Gauss-Legendre rule in double-doubles, rounded from more digits.
const spline::GaussRule<DoubleDouble, points>& gauss_rule() {
  static const spline::GaussRule<DoubleDouble, points> rule = [] {
    const auto& exact = spline::gauss_rule<Float<40>, points>();
    const auto rounded = [](const Float<40>& number) {
      const auto high = static_cast<double>(number);
      return DoubleDouble::normalized(high, static_cast<double>(Float<40>(number - high)));
    };
    spline::GaussRule<DoubleDouble, points> result;
    std::ranges::transform(exact.node, result.node.begin(), rounded);
    std::ranges::transform(exact.weight, result.weight.begin(), rounded);
    return result;
  }();
  return rule;
}

double high_of(double number) { return number; }
double high_of(const DoubleDouble& number) { return number.hi; }
template <class T>
T converted(const DoubleDouble& number) {
  if constexpr (std::is_same_v<T, double>) {
    return number.hi;
  } else {
    return number;
  }
}

template <class T>
T power_of(const T& base, int exponent) {
  T power(1.0);
  for (int i = 0; i < exponent; ++i) power = power * (high_of(base) < 0 ? -base : base);
  return power;
}

template <class T>
T quartic(const spline::Quartic<T>& q, const T& z) {
  return q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * q[4])));
}

/// The speed at z on a panel, which is at this place, over the width of the panel.
template <class T>
T speed_on(const spline::Quartic<T>& q, const T& place, int zeros, const T& z) {
  using std::sqrt;
  const T root = sqrt(quartic(q, z));
  return zeros == 0 ? root : root * power_of(place, zeros);
}

bool is_zero_at_end(std::span<const spline::Quadratic<Ball>> channels) {
  return std::ranges::all_of(channels, [](const auto& x) { return x.k0.is_zero(); });
}

spline::LocalParameter<Ball> local(std::size_t half, const Ball& place) {
  return half == 0 ? spline::LocalParameter<Ball>{place, place - Ball(1.0)}
                   : spline::LocalParameter<Ball>{place + Ball(1.0), place};
}

/// The last panel that begins at a length or before it.
template <class Panel>
const Panel& panel_at_length(const std::vector<Panel>& panels, double length) {
  const auto after =
      std::ranges::upper_bound(panels, length, {}, [](const Panel& panel) { return panel.before.middle().hi; });
  return after == panels.begin() ? *after : *(after - 1);
}

}  // namespace

BallArc::Panel BallArc::panel(std::size_t half, double middle, double width) const {
  spline::Quartic<Ball> square{};
  for (const auto& channel : halves_[half].channels) spline::add_square(square, channel, Ball(middle), Ball(width));
  Panel result{half, middle, width, {}, 0, 0, {}};
  spline::Quartic<double> rounded{};
  double largest = 0;  // of q for |z| <= 1
  for (std::size_t i = 0; i < square.size(); ++i) {
    result.square[i] = square[i].middle();
    rounded[i] = square[i].middle().hi;
    result.spread += square[i].radius();
    largest += square[i].most();
  }
  constexpr double clear = 0x1p-40;
  const double at_middle = rounded[0];
  double disc_power = disc;
  for (int i = 0; i < spline::squarings; ++i) disc_power *= disc_power;
  const bool is_smooth = at_middle > 0 && result.spread < clear * at_middle &&
                         spline::OtherTerms<double>(rounded).within(disc_power) < 0.99;
  const double farthest = power_of(std::abs(middle) + 2 * width, halves_[half].zeros);
  if (is_smooth) {
    result.root = std::sqrt(at_middle);
    result.length = length(result, DoubleDouble(1.0));
  } else {
    const double most = std::sqrt(largest) * width * farthest * (1 + 0x1p-40);  // half of a bound on the length
    result.length = Ball(most).widened(most);
  }
  return result;
}

/// Adds a panel that is smooth, or whose length is at most `negligible`; else its halves. A cusp takes some 100 panels;
/// where there are far more, the coefficients have too few digits.
void BallArc::add(const Panel& panel, double negligible) {
  constexpr std::size_t most_panels = 1000;
  if (panels_.size() > most_panels) throw Undecided();
  if (panel.is_smooth() || panel.length.most() <= negligible || panel.width < 0x1p-70) {
    panels_.push_back(panel);
    panels_.back().before = total_;
    total_ += panel.length;
    return;
  }
  const double half = panel.width / 2;
  add(this->panel(panel.half, panel.middle - half, half), negligible);
  add(this->panel(panel.half, panel.middle + half, half), negligible);
}

void BallArc::assign(std::span<const spline::Cubic<Ball>> segment, std::span<const std::size_t> metric) {
  panels_.clear();
  total_ = Ball();
  for (Half& half : halves_) {
    half.channels.clear();
    half.zeros = 0;
  }
  double longest = 0;
  const std::size_t size = metric.empty() ? segment.size() : metric.size();
  for (std::size_t i = 0; i < size; ++i) {
    const spline::Cubic<Ball>& x = segment[metric.empty() ? i : metric[i]];
    const Ball two(2.0), three(3.0);
    halves_[0].channels.push_back({x.out, two * x.c, three * x.d});
    halves_[1].channels.push_back({x.in, two * x.e, three * x.d});
    longest += x.out.most() + x.in.most() + 2 * x.c.most() + 2 * x.e.most() + 3 * x.d.most();
  }
  if (longest == 0) return;
  for (std::size_t i = 0; i < halves_.size(); ++i) {
    Half& half = halves_[i];
    for (; half.zeros < 2 && is_zero_at_end(half.channels); ++half.zeros) {
      for (auto& x : half.channels) x = {x.k1, x.k2, Ball()};
    }
    add(panel(i, i == 0 ? 0.25 : -0.25, 0.25), 0x1p-102 * longest);
  }
}

/// The rule on a panel from its start to z, without a bound.
template <class T>
T BallArc::sum(const Panel& panel, const T& z) const {
  const auto& rule = gauss_rule();
  spline::Quartic<T> q;
  std::ranges::transform(panel.square, q.begin(), converted<T>);
  const int zeros = halves_[panel.half].zeros;
  const T whole = z + T(1.0);
  T sum(0.0);
  for (std::size_t i = 0; i < points; ++i) {
    const T at = whole * converted<T>(rule.node[i]) + T(-1.0);
    sum = sum + converted<T>(rule.weight[i]) * speed_on(q, T(T(panel.middle) + T(panel.width) * at), zeros, at);
  }
  return sum * whole * T(panel.width);
}

/// In double-doubles, by pairs.
template <>
DoubleDouble BallArc::sum(const Panel& panel, const DoubleDouble& z) const {
  using spline::DoublePair;
  using Pair = spline::DoubleDoubleOf<DoublePair>;
  const auto both = [](const DoubleDouble& a, const DoubleDouble& b) {
    return Pair(DoublePair(a.hi, b.hi), DoublePair(a.lo, b.lo));
  };
  const auto& rule = gauss_rule();
  spline::Quartic<Pair> q;
  std::ranges::transform(panel.square, q.begin(), [&](const DoubleDouble& x) { return both(x, x); });
  const int zeros = halves_[panel.half].zeros;
  const DoubleDouble whole = z + DoubleDouble(1.0);
  const Pair wholes = both(whole, whole);
  DoubleDouble sum(0.0);
  for (std::size_t i = 0; i < points; i += 2) {
    const Pair at = wholes * both(rule.node[i], rule.node[i + 1]) + Pair(DoublePair(-1.0));
    const Pair square = quartic(q, at);
    for (std::size_t j = 0; j < 2; ++j) {
      DoubleDouble speed = sqrt(DoubleDouble(square.hi[j], square.lo[j]));
      if (zeros > 0) {
        const DoubleDouble place =
            DoubleDouble(panel.middle) + DoubleDouble(panel.width) * DoubleDouble(at.hi[j], at.lo[j]);
        speed = speed * power_of(place, zeros);
      }
      sum = sum + rule.weight[i + j] * speed;
    }
  }
  return sum * whole * DoubleDouble(panel.width);
}

/// From the start of a smooth panel to z. The disc about the middle of that part, R times as wide as it, is within the
/// panel's disc.
Ball BallArc::length(const Panel& panel, const DoubleDouble& z) const {
  const double root = panel.root, width = panel.width * (std::abs(z.hi + 1) + 0x1p-40);
  const double farthest = power_of(std::abs(panel.middle) + 2 * panel.width, halves_[panel.half].zeros);
  return Ball(sum(panel, z)).widened(width * farthest * (rule_error * root + 7 * panel.spread / root));
}

DoubleDouble BallArc::speed(const Panel& panel, const DoubleDouble& z) const {
  return speed_on(panel.square, DoubleDouble(panel.middle) + DoubleDouble(panel.width) * z, halves_[panel.half].zeros,
                  z) *
         panel.width;
}

Ball BallArc::to(const spline::LocalParameter<Ball>& place) const {
  if (place.u.is_zero() || panels_.empty()) return {};
  if (place.w.is_zero()) return total_;
  const std::size_t half = place.near_start() ? 0 : 1;
  const Ball& at = half == 0 ? place.u : place.w;
  const auto ends_before = [&](const Panel& panel) {
    return panel.half < half || (panel.half == half && panel.middle + panel.width < at.middle().hi);
  };
  auto panel = std::ranges::find_if_not(panels_, ends_before);
  if (panel == panels_.end()) --panel;
  if (!panel->is_smooth()) return panel->before + panel->length.widened(panel->length.most());
  const Ball z = (at - Ball(panel->middle)) / Ball(panel->width);
  if (!(z.most() < 1 + 0x1p-40)) throw Undecided();
  const double farthest = power_of(std::abs(panel->middle) + 2 * panel->width, halves_[half].zeros);
  constexpr double largest_speed = 2.7;  // sqrt(7), per root
  const double moved = largest_speed * panel->root * panel->width * farthest * z.radius();
  return panel->before + length(*panel, z.middle()).widened(moved);
}

/// The place on a smooth panel at which a length from its start is reached, nearly.
double BallArc::rough_place(const Panel& panel, double length) const {
  double low = -1, high = 1, z = std::clamp(2 * length / panel.length.middle().hi - 1, -1.0, 1.0);
  for (int step = 0; step < 60; ++step) {
    const double excess = sum<double>(panel, z) - length;
    (excess > 0 ? high : low) = z;
    double next = z - excess / speed(panel, DoubleDouble(z)).hi;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool is_settled = std::abs(next - z) < 0x1p-48;
    z = next;
    if (is_settled) break;
  }
  return z;
}

spline::LocalParameter<Ball> BallArc::place(const Ball& length) const {
  if (panels_.empty()) throw Undecided();
  const Panel& panel = panel_at_length(panels_, length.middle().hi);
  if (!panel.is_smooth()) return local(panel.half, Ball(panel.middle).widened(panel.width));
  const Ball into = length - panel.before;
  const DoubleDouble rough(rough_place(panel, into.middle().hi));
  const DoubleDouble missing = into.middle() - sum(panel, rough);
  const DoubleDouble z = rough + missing / speed(panel, rough);
  // The speed v is at least half of v(z) up to a distance d from z, if the integral of |v'/v| over it is below ln 2:
  // each of the four zeros beyond R contributes at most d/2/(R - 1 - d), and `zeros` those at the end.
  const Ball rest = into - this->length(panel, z);
  const double at_z = speed(panel, z).hi, distance = 2.01 * rest.most() / at_z;
  const double to_end = std::abs(panel.middle + panel.width * z.hi) / panel.width;
  const int zeros = halves_[panel.half].zeros;
  const bool is_clear =
      at_z > 0 && distance < 0.01 && std::abs(z.hi) < 1 + 0x1p-40 && (zeros == 0 || distance < to_end / 16);
  if (!is_clear) throw Undecided();
  return local(panel.half, Ball(panel.middle) + Ball(panel.width) * Ball(z, distance));
}

Ball BallTurn::speed(const Ball& u) const {
  Ball square;
  for (const auto& rotation : rotations_) {
    const auto [x, y, z] = rotation.rate({u, u - Ball(1.0)});
    square += x * x + (y * y + z * z);
  }
  return sqrt(square);
}

Ball BallTurn::sum(const Ball& begin, const Ball& width) const {
  const auto& rule = gauss_rule();
  Ball sum;
  constexpr double rounding = 0x1p-106;  // of nodes and weights
  for (std::size_t i = 0; i < points; ++i) {
    sum += Ball(rule.weight[i], rounding) * speed(begin + width * Ball(rule.node[i], rounding));
  }
  return sum * width;
}

/// Adds the halves of a panel if the rule agrees with them, which for panels as short as these err by far less than the
/// rule on the whole; else their halves.
void BallTurn::add(const Panel& panel, double negligible) {
  const double half = panel.width / 2;
  std::array<Panel, 2> halves{{{panel.begin, half, sum(Ball(panel.begin), Ball(half))},
                               {panel.begin + half, half, sum(Ball(panel.begin + half), Ball(half))}}};
  const double difference = std::abs((halves[0].length + halves[1].length - panel.length).middle().hi);
  for (Panel& part : halves) {
    if (difference > negligible && panel.width > 0x1p-20) {
      add(part, negligible);
    } else if (difference > negligible) {
      throw Undecided();
    } else {
      part.length = part.length.widened(difference);
      part.before = total_;
      total_ += part.length;
      panels_.push_back(part);
    }
  }
}

void BallTurn::assign(std::span<const spline::RotationSegment<Ball>> rotations) {
  rotations_ = rotations;
  panels_.clear();
  total_ = Ball();
  const Ball whole = sum(Ball(), Ball(1.0));
  add({0, 1, whole}, 0x1p-86 * whole.most());
}

Ball BallTurn::to(const spline::LocalParameter<Ball>& place) const {
  if (place.w.is_zero()) return total_;
  auto panel = std::ranges::upper_bound(panels_, place.u.middle().hi, {}, &Panel::begin);
  if (panel != panels_.begin()) --panel;
  return panel->before + sum(Ball(panel->begin), place.u - Ball(panel->begin)).widened(panel->length.radius());
}

/// By Newton's method; the speed at both ends of the ball of the place shows that it does not change much there.
spline::LocalParameter<Ball> BallTurn::place(const Ball& length) const {
  const Panel& panel = panel_at_length(panels_, length.middle().hi);
  const Ball into = length - panel.before, begin(panel.begin);
  Ball u = begin + Ball(panel.width) * Ball((into / panel.length).middle());
  for (int step = 0; step < 40; ++step) {
    const Ball rest = into - sum(begin, u - begin);
    const double speed = this->speed(u).middle().hi, distance = 2.01 * (rest.most() + panel.length.radius()) / speed;
    if (std::abs(rest.middle().hi) <= rest.radius() && distance < 0x1p-60) {  // no step brings it nearer
      for (const double side : {-distance, distance}) {
        if (!(this->speed(u + Ball(side)) > Ball(speed / 2))) throw Undecided();
      }
      return local(0, Ball(u.middle(), distance));
    }
    u = Ball((u + Ball(rest.middle()) / Ball(speed)).middle());
    if (!(u.middle().hi > 0 && u.middle().hi < 1)) throw Undecided();
  }
  throw Undecided();
}

}  // namespace tcb
