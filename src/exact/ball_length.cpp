// Lengths in balls: panels under one quadrature rule, with bounds on the errors of the rule and of its rounding.
//
// The bound of the rule is that of tcb/spline/detail/panel.hpp. On a smooth panel the quartic q under the root has no
// zero in the disc |z| <= R = 1.7. So with root = sqrt(q(0)) and rho = R + sqrt(R^2 - 1) the rule with n points errs by
// less than 64/15 * 4 root / (rho^2n - rho^(2n - 2)) < e root, where e bounds the relative error of one operation
// (2^-99 of double-doubles, two units of the last digit of other floats), and for |z| <= 1
//   sqrt(q) >= (1 - 1/R)^2 root > 0.16 root,   the sum of the sizes of the terms of q < (1 + 1/R)^4 root^2 < 7 root^2.
// Each operation errs by less than e of a term, so that q errs by less than 2^6 e root^2, its root by less than
// 2^9 e root, and the rule by less than 2^11 e root; sums of up to 500 terms add 2^11 e root. The coefficients of q
// have errors of their own. Where all derivatives are exactly 0 at an end, they are divided by the place, so that the
// panel there is smooth, too. Other cusps are in panels that are halved until their lengths have no effect.
#include "exact/ball_length.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <type_traits>
#include <utility>

namespace tcb {
namespace {

using spline::DoubleDouble;

constexpr double disc = 1.7;

/// A bound on the errors of a rule and of its rounding, per root and width: 2^-88 of double-doubles.
template <class M>
typename Middle<M>::Bound rule_error() {
  return Middle<M>::power_of_two(12 - Middle<M>::bits());
}

/// A Gauss-Legendre rule on [0, 1]. Each number errs by at most a unit of its last digit.
template <class M>
struct Rule {
  std::vector<M> node, weight;
  /// The weights that give coefficients of the polynomial through the nodes in Legendre polynomials: of the two orders
  /// in the middle, and the last two.
  std::array<std::vector<M>, 4> orders;
};

/// The Legendre polynomials P_n and P_(n-1) at x.
std::pair<Real, Real> legendre(int n, const Real& x) {
  Real before(1.0), value = x;
  for (int k = 2; k <= n; ++k) {
    const Real next = (Real(2.0 * k - 1) * x * value - Real(k - 1.0) * before) / Real(static_cast<double>(k));
    before = std::exchange(value, next);
  }
  return {value, before};
}
double legendre(int n, double x, double& slope) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
  slope = n * (x * value - before) / (x * x - 1);
  return value;
}

/// Roots by Newton's method, from x_i = cos(pi (i + 3/4)/(n + 1/2)), in doubles and then in more digits.
Rule<Real> make_rule(int n, int bits) {
  const std::vector<Real> numbers(static_cast<std::size_t>(n));
  Rule<Real> rule{numbers, numbers, {numbers, numbers, numbers, numbers}};
  for (int i = 0; i < n / 2; ++i) {
    double rough = spline::sine_cosine(3.14159265358979 * (i + 0.75) / (n + 0.5)).cosine, slope = 0;
    for (int step = 0; step < 6; ++step) {
      const double value = legendre(n, rough, slope);
      rough -= value / slope;
    }
    constexpr int guard = 60;
    std::vector<int> digits{bits + guard};  // of each step; the first one begins with those of a double
    while (digits.back() > 90) digits.push_back(digits.back() / 2 + 25);
    Real x(rough), rate;
    for (auto step = digits.rbegin(); step != digits.rend(); ++step) {
      const RealPrecision precision(*step);
      const auto [value, before] = legendre(n, x);
      const Real degree(static_cast<double>(n)), rest = Real(1.0) - x * x;
      const Real derivative = degree * (before - x * value) / rest, off = value / derivative;
      // The derivative at the root, by Legendre's equation; the next term has the square of `off`.
      rate = derivative - off * (Real(2.0) * x * derivative - degree * (degree + Real(1.0)) * value) / rest;
      x = x - off;
    }
    const RealPrecision wide(bits + guard);
    const Real weight = Real(1.0) / ((Real(1.0) - x * x) * rate * rate), left = halved(Real(1.0) - x),
               right = halved(Real(1.0) + x);
    const RealPrecision precision(bits);
    const auto first = static_cast<std::size_t>(i), last = static_cast<std::size_t>(n - 1 - i);
    rule.node[first] = left + Real();
    rule.node[last] = right + Real();
    rule.weight[first] = rule.weight[last] = weight + Real();
    for (const std::size_t last_order : {1U, 3U}) {
      const int odd = last_order == 1 ? n / 4 * 2 - 1 : n - 1;
      const auto [value, before] = legendre(odd, x);
      const Real of_even = Real(2.0 * odd - 1) * weight * before, of_odd = Real(2.0 * odd + 1) * weight * value;
      rule.orders[last_order - 1][first] = rule.orders[last_order - 1][last] = of_even;
      rule.orders[last_order][first] = -of_odd;
      rule.orders[last_order][last] = of_odd;
    }
  }
  return rule;
}

/// An even number of points, for the digits in use.
template <class M>
const Rule<M>& gauss_rule();
template <>
const Rule<Real>& gauss_rule() {
  thread_local std::map<int, Rule<Real>> known;
  const int bits = Real::bits();
  Rule<Real>& rule = known[bits];
  if (rule.node.empty()) rule = make_rule((bits * 10 / 32 + 5) / 2 * 2, bits);
  return rule;
}
template <>
const Rule<DoubleDouble>& gauss_rule() {
  static const Rule<DoubleDouble> rule = [] {
    const Rule<Real> exact = make_rule(32, 140);
    const auto rounded = [](const Real& number) {
      const RealPrecision precision(140);
      const double high = number.rough();
      return DoubleDouble::normalized(high, Real(number - Real(high)).rough());
    };
    Rule<DoubleDouble> result;
    for (const Real& node : exact.node) result.node.push_back(rounded(node));
    for (const Real& weight : exact.weight) result.weight.push_back(rounded(weight));
    for (std::size_t i = 0; i < exact.orders.size(); ++i) {
      for (const Real& weight : exact.orders[i]) result.orders[i].push_back(rounded(weight));
    }
    return result;
  }();
  return rule;
}

template <class M>
M power_of(const M& base, int exponent) {
  M power(1.0);
  for (int i = 0; i < exponent; ++i) power = power * (base < M(0.0) ? -base : base);
  return power;
}

template <class T>
T quartic(const spline::Quartic<T>& q, const T& z) {
  return q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * q[4])));
}

template <class B>
bool is_zero_at_end(std::span<const spline::Quadratic<B>> channels) {
  return std::ranges::all_of(channels, [](const auto& x) { return x.k0.is_zero(); });
}

template <class B>
spline::LocalParameter<B> local(std::size_t half, const B& place) {
  return half == 0 ? spline::LocalParameter<B>{place, place - B(1.0)}
                   : spline::LocalParameter<B>{place + B(1.0), place};
}

/// Whether a cubic moves in one direction: the Bernstein coefficients of its derivative have one sign.
template <class B>
bool is_monotone(const spline::Cubic<B>& x) {
  const std::array slopes{x.out, x.out + x.c, x.in};
  const auto has_sign = [&](bool negative) {
    return std::ranges::all_of(slopes, [&](const B& slope) {
      return slope.is_zero() || (!slope.may_be_zero() && (slope.rough() < 0) == negative);
    });
  };
  return has_sign(false) || has_sign(true);
}

/// The last panel that begins at a length or before it.
template <class Panel, class M>
const Panel& panel_at_length(const std::vector<Panel>& panels, const M& length) {
  const auto after =
      std::ranges::upper_bound(panels, length, {}, [](const Panel& panel) { return panel.before.middle(); });
  return after == panels.begin() ? *after : *(after - 1);
}

/// A quartic over its first coefficient, in doubles; without sense if that is 0.
spline::Quartic<double> relative(const spline::Quartic<DoubleDouble>& q) {
  spline::Quartic<double> result{};
  for (std::size_t i = 0; i < q.size(); ++i) result[i] = q[i].hi / q[0].hi;
  return result;
}
spline::Quartic<double> relative(const spline::Quartic<Real>& q) {
  spline::Quartic<double> result{};
  const double first = q[0].over_power_of_two(q[0].exponent());
  for (std::size_t i = 0; i < q.size(); ++i) result[i] = q[i].over_power_of_two(q[0].exponent()) / first;
  return result;
}

double rough_ratio(const DoubleDouble& a, const DoubleDouble& b) { return a.hi / b.hi; }
double rough_ratio(const Real& a, const Real& b) {
  return a.over_power_of_two(b.exponent()) / b.over_power_of_two(b.exponent());
}

}  // namespace

Ball ball_of(const RealBall& ball) {
  const ErrorBound& radius = ball.radius();
  constexpr int largest = 400;
  if (ball.most() >= ErrorBound::power_of_two(largest)) throw Undecided();
  const double high = ball.middle().rough();
  const Real rest = ball.middle() - Real(high);
  const double low = rest.rough();
  const ErrorBound error = radius + (rest - Real(low)).most() + rest.most() * ErrorBound::power_of_two(-100);
  const double bound =
      error == 0.0 ? 0
                   : std::ldexp(error.mantissa(), static_cast<int>(std::max<std::int64_t>(error.exponent(), -1000)));
  return Ball(spline::DoubleDouble::normalized(high, low)).widened(bound);
}
template <>
Ball from_ball<Ball>(const Ball& ball) {
  return ball;
}
template <>
RealBall from_ball<RealBall>(const Ball& ball) {
  return (RealBall(ball.middle().hi) + RealBall(ball.middle().lo)).widened(ball.radius());
}

/// A bound on |place|^zeros near a panel.
template <class M>
typename BallArc<M>::Bound BallArc<M>::farthest(const Panel& panel) const {
  Bound result = 1.0;
  const Bound distance = Ops::most(panel.middle) + Ops::most(panel.width) + Ops::most(panel.width);
  for (int i = 0; i < halves_[panel.half].zeros; ++i) result = result * distance;
  return Ops::up(result);
}

template <class M>
typename BallArc<M>::Panel BallArc<M>::panel(std::size_t half, const M& middle, const M& width) const {
  using std::sqrt;
  spline::Quartic<B> square{};
  for (const auto& channel : halves_[half].channels) spline::add_square(square, channel, B(middle), B(width));
  Panel result{half, middle, width};
  Bound largest = 0.0;  // of q for |z| <= 1
  for (std::size_t i = 0; i < square.size(); ++i) {
    result.square[i] = square[i].middle();
    result.spread = result.spread + square[i].radius();
    largest = largest + square[i].most();
  }
  double disc_power = disc;
  for (int i = 0; i < spline::squarings; ++i) disc_power *= disc_power;
  const bool is_clear = !Ops::is_zero(result.square[0]) && !Ops::is_negative(result.square[0]) &&
                        result.spread < Bound(0x1p-40) * Ops::least(result.square[0]);
  result.is_smooth = is_clear && spline::OtherTerms<double>(relative(result.square)).within(disc_power) < 0.99;
  if (result.is_smooth) {
    result.length = length(result, M(1.0));
  } else {
    const B most(Ops::number(Ops::up(sqrt(largest) * Ops::most(width) * farthest(result))));  // half of a bound
    result.length = most.widened(most.most());
  }
  return result;
}

/// Adds a panel that is smooth, or whose length is at most `negligible`; else its halves. A cusp takes about as many
/// panels as there are bits; where there are far more, the coefficients have too few digits.
template <class M>
void BallArc<M>::add(const Panel& panel, const Bound& negligible) {
  const int bits = Ops::bits();
  if (panels_.size() > 10 * static_cast<std::size_t>(bits)) throw Undecided();
  if (panel.is_smooth || panel.length.most() <= negligible ||
      Ops::most(panel.width) < Ops::power_of_two(-bits * 7 / 10)) {
    panels_.push_back(panel);
    panels_.back().before = total_;
    total_ += panel.length;
    return;
  }
  const M half = spline::halved(panel.width);
  add(this->panel(panel.half, panel.middle - half, half), negligible);
  add(this->panel(panel.half, panel.middle + half, half), negligible);
}

template <class M>
void BallArc<M>::assign(std::span<const spline::Cubic<B>> segment, std::span<const std::size_t> metric) {
  panels_.clear();
  total_ = B();
  monotone_.reset();
  std::size_t moving = 0;
  for (Half& half : halves_) {
    half.channels.clear();
    half.zeros = 0;
  }
  Bound longest = 0.0, error = 0.0;
  const std::size_t size = metric.empty() ? segment.size() : metric.size();
  for (std::size_t i = 0; i < size; ++i) {
    const spline::Cubic<B>& x = segment[metric.empty() ? i : metric[i]];
    const B two(2.0), three(3.0);
    if (!(x.out.is_zero() && x.c.is_zero() && x.d.is_zero())) {
      monotone_ = ++moving == 1 && is_monotone(x) ? std::optional(x) : std::nullopt;
    }
    halves_[0].channels.push_back({x.out, two * x.c, three * x.d});
    halves_[1].channels.push_back({x.in, two * x.e, three * x.d});
    error =
        error + x.out.radius() + x.in.radius() + Bound(2.0) * (x.c.radius() + x.e.radius()) + Bound(3.0) * x.d.radius();
    longest = longest + x.out.most() + x.in.most() + Bound(2.0) * (x.c.most() + x.e.most()) + Bound(3.0) * x.d.most();
  }
  if (longest == 0.0) return;
  for (std::size_t i = 0; i < halves_.size(); ++i) {
    Half& half = halves_[i];
    for (; half.zeros < 2 && is_zero_at_end<B>(half.channels); ++half.zeros) {
      for (auto& x : half.channels) x = {x.k1, x.k2, B()};
    }
    // Near a cusp the errors of the coefficients leave no panel smooth: one is short beside these errors, too.
    add(panel(i, M(i == 0 ? 0.25 : -0.25), M(0.25)),
        Ops::power_of_two(-Ops::bits() - 2) * longest + Bound(0.25) * error);
  }
  if (monotone_) total_ = abs(monotone_->p1 - monotone_->p0);
}

/// The rule on a panel from its start to z, without a bound.
template <class M>
M BallArc<M>::sum(const Panel& panel, const M& z) const {
  const Rule<M>& rule = gauss_rule<M>();
  const int zeros = halves_[panel.half].zeros;
  const M whole = z + M(1.0);
  M sum(0.0);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const M at = whole * rule.node[i] + M(-1.0);
    M speed = sqrt(quartic(panel.square, at));
    if (zeros > 0) speed = speed * power_of(M(panel.middle + panel.width * at), zeros);
    sum = sum + rule.weight[i] * speed;
  }
  return sum * whole * panel.width;
}

/// In double-doubles, by pairs.
template <>
DoubleDouble BallArc<DoubleDouble>::sum(const Panel& panel, const DoubleDouble& z) const {
  using spline::DoublePair;
  using Pair = spline::DoubleDoubleOf<DoublePair>;
  const auto both = [](const DoubleDouble& a, const DoubleDouble& b) {
    return Pair(DoublePair(a.hi, b.hi), DoublePair(a.lo, b.lo));
  };
  const auto& rule = gauss_rule<DoubleDouble>();
  spline::Quartic<Pair> q;
  std::ranges::transform(panel.square, q.begin(), [&](const DoubleDouble& x) { return both(x, x); });
  const int zeros = halves_[panel.half].zeros;
  const DoubleDouble whole = z + DoubleDouble(1.0);
  const Pair wholes = both(whole, whole);
  DoubleDouble sum(0.0);
  for (std::size_t i = 0; i < rule.node.size(); i += 2) {
    const Pair at = wholes * both(rule.node[i], rule.node[i + 1]) + Pair(DoublePair(-1.0));
    const Pair square = quartic(q, at);
    for (std::size_t j = 0; j < 2; ++j) {
      DoubleDouble speed = sqrt(DoubleDouble(square.hi[j], square.lo[j]));
      if (zeros > 0) speed = speed * power_of(panel.middle + panel.width * DoubleDouble(at.hi[j], at.lo[j]), zeros);
      sum = sum + rule.weight[i + j] * speed;
    }
  }
  return sum * whole * panel.width;
}

/// From the start of a smooth panel to z. The disc about the middle of that part, R times as wide as it, is within the
/// panel's disc. Where one channel moves in one direction, it is the difference of its positions: this has fewer digits
/// next to a rest, but floats have more of them, and the rule hundreds of points.
template <class M>
typename BallArc<M>::B BallArc<M>::length(const Panel& panel, const M& z) const {
  if (std::is_same_v<M, Real> && monotone_) {
    const auto position = [&](const M& at) {
      return spline::position(*monotone_, local(panel.half, B(panel.middle) + B(panel.width) * B(at)));
    };
    return abs(position(z) - position(M(-1.0)));
  }
  const M root = sqrt(panel.square[0]);
  const Bound width = Ops::most(panel.width) * (Ops::most(z + M(1.0)) + Bound(0x1p-40));
  return B(sum(panel, z))
      .widened(width * farthest(panel) *
               (rule_error<M>() * Ops::most(root) + Bound(7.0) * panel.spread / Ops::least(root)));
}

template <class M>
M BallArc<M>::speed(const Panel& panel, const M& z) const {
  const M speed = sqrt(quartic(panel.square, z)) * panel.width;
  const int zeros = halves_[panel.half].zeros;
  return zeros == 0 ? speed : speed * power_of(M(panel.middle + panel.width * z), zeros);
}

template <class M>
typename BallArc<M>::B BallArc<M>::to(const spline::LocalParameter<B>& place) const {
  if (place.u.is_zero() || panels_.empty()) return {};
  if (place.w.is_zero()) return total_;
  if (monotone_) return abs(spline::position(*monotone_, place) - monotone_->p0);
  const std::size_t half = M(0.5) < place.u.middle() ? 1 : 0;  // either will do in the middle
  const B& at = half == 0 ? place.u : place.w;
  const auto ends_before = [&](const Panel& panel) {
    return panel.half < half || (panel.half == half && panel.middle + panel.width < at.middle());
  };
  auto panel = std::ranges::find_if_not(panels_, ends_before);
  if (panel == panels_.end()) --panel;
  if (!panel->is_smooth) return panel->before + panel->length.widened(panel->length.most());
  const B z = (at - B(panel->middle)) / B(panel->width);
  if (!(z.most() < Bound(1 + 0x1p-40))) throw Undecided();
  const Bound largest_speed = Bound(2.7) * Ops::most(sqrt(panel->square[0]));  // sqrt(7), per root
  const Bound moved = largest_speed * Ops::most(panel->width) * farthest(*panel) * z.radius();
  return panel->before + length(*panel, z.middle()).widened(moved);
}

/// The place on a smooth panel at which a fraction of its length is reached, nearly.
template <class M>
double BallArc<M>::rough_place(const Panel& panel, double fraction) const {
  const auto q = relative(panel.square);
  const double middle = halves_[panel.half].zeros == 0 ? 0 : rough_ratio(panel.middle, panel.width);
  const auto speed = [&](double z) {
    return std::sqrt(quartic(q, z)) * power_of(middle + z, halves_[panel.half].zeros);
  };
  const auto sum = [&](double z) {
    const auto& rule = spline::gauss_rule<double, 16>();
    double total = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) total += rule.weight[i] * speed((z + 1) * rule.node[i] - 1);
    return total * (z + 1);
  };
  const double length = fraction * sum(1);
  double low = -1, high = 1, z = std::clamp(2 * fraction - 1, -1.0, 1.0);
  for (int step = 0; step < 60; ++step) {
    const double excess = sum(z) - length;
    (excess > 0 ? high : low) = z;
    double next = z - excess / speed(z);
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool is_settled = std::abs(next - z) < 0x1p-48;
    z = next;
    if (is_settled) break;
  }
  return z;
}

/// Where the search for a place on a smooth panel begins: next to a rest at its end, where lengths are a power of the
/// distance to it, with as many digits of that distance.
template <class M>
M BallArc<M>::first_guess(const Panel& panel, const B& into) const {
  const int zeros = halves_[panel.half].zeros;
  const M end(panel.half == 0 ? -1.0 : 1.0);
  const M part = panel.half == 0 ? into.middle() : (panel.length - into).middle();  // between the rest and the place
  const bool ends_at_rest = zeros > 0 && Ops::is_zero(panel.middle + panel.width * end);
  const double fraction = rough_ratio(part, panel.length.middle());
  if (!ends_at_rest || !(fraction > 0 && fraction < (zeros == 1 ? 0x1p-60 : 0x1p-90))) {
    return M(rough_place(panel, rough_ratio(into.middle(), panel.length.middle())));
  }
  const M speed_at_one = sqrt(quartic(panel.square, end)) * power_of(panel.width, zeros) * panel.width;
  const double power = (zeros + 1) * rough_ratio(part, speed_at_one);
  double distance = std::sqrt(power);
  for (int step = 0; zeros == 2 && step < 24; ++step) distance = std::sqrt(std::sqrt(power * distance));  // cube root
  return end + M(panel.half == 0 ? distance : -distance);
}

template <class M>
spline::LocalParameter<BallOf<M>> BallArc<M>::place(const B& length) const {
  if (panels_.empty()) throw Undecided();
  const Panel& panel = panel_at_length(panels_, length.middle());
  if (!panel.is_smooth) return local(panel.half, B(panel.middle).widened(Ops::most(panel.width)));
  const B into = length - panel.before;
  const int zeros = halves_[panel.half].zeros;
  M z = first_guess(panel, into);
  for (int known = zeros > 0 ? 8 : 48; known < Ops::bits(); known *= 2) {
    const M missing = into.middle() - this->length(panel, z).middle();
    z = z + missing / speed(panel, z);
  }
  // The speed v is at least half of v(z) up to a distance d from z, if the integral of |v'/v| over it is below ln 2:
  // each of the four zeros beyond R contributes at most d/2/(R - 1 - d), and `zeros` those at the end.
  const B rest = into - this->length(panel, z);
  const M at_z = speed(panel, z);
  if (!(at_z > M(0.0))) throw Undecided();
  const Bound distance = Ops::up(Bound(2.01) * rest.most() / Ops::least(at_z));
  const Bound to_end = Ops::least(panel.middle + panel.width * z) / Ops::most(panel.width);
  const bool is_clear =
      distance < Bound(0.01) && Ops::most(z) < Bound(1 + 0x1p-40) && (zeros == 0 || distance * Bound(17.0) < to_end);
  if (!is_clear) throw Undecided();
  return local(panel.half, B(panel.middle) + B(panel.width) * B(z, distance));
}

namespace {

template <class B>
using Polynomial = std::array<B, 4>;  ///< by the powers of u

template <class B>
B value(const Polynomial<B>& p, const B& u) {
  return p[0] + u * (p[1] + u * (p[2] + u * p[3]));
}

/// Sorted by size; those that may be equal are one.
template <class B>
std::vector<B> merged(std::vector<B> places) {
  std::ranges::sort(places, {}, &B::middle);
  std::vector<B> result;
  for (const B& place : places) {
    if (!result.empty() && (place - result.back()).may_be_zero()) {
      result.back() = result.back().widened((place - result.back()).most());
    } else {
      result.push_back(place);
    }
  }
  return result;
}

/// Adds the zeros of a quadratic from one place to another, and perhaps others next to these.
template <class B>
void add_zeros(const B& c0, const B& c1, const B& c2, const B& begin, const B& end, std::vector<B>& zeros) {
  const auto add = [&](const B& above, const B& below) {
    if (above.least() > below.most()) return;  // beyond 1
    const B zero = above / below, from_begin = zero - begin, to_end = end - zero;
    const auto is_negative = [](const B& x) { return !x.may_be_zero() && x.rough() < 0; };
    if (!is_negative(from_begin) && !is_negative(to_end)) zeros.push_back(zero);
  };
  if (c0.least() > c1.most() + c2.most()) return;
  if (c2.is_zero()) return c1.is_zero() ? void() : add(-c0, c1);
  const B square = c1 * c1 - B(4.0) * c0 * c2;
  if (square < B()) return;
  const B root = sqrt(square), half = halved(-c1 + (c1.rough() < 0 ? root : -root));
  add(half, c2);
  add(c0, half);
}

/// The angle of a rotation about one axis, over two: it is a cubic on each part of a segment between the places at
/// which the shorter way between two of its points changes sides, and it moves in one direction.
template <class B>
class AngleAboutAxis {
 public:
  struct Part {
    B begin, end;
    bool begins_at_rest, ends_at_rest;
    Polynomial<B> angle;
  };

  explicit AngleAboutAxis(const spline::RotationSegment<B>& rotation) {
    const std::array<B, 4> angles = angles_of(rotation.points());
    const auto way = [&](std::size_t from, std::size_t to) {
      const B change = angles[to] - angles[from];
      return Polynomial<B>{angles[from], change - turns_in(change), B(), B()};
    };
    if (rotation.curve() == spline::RotationCurve::slerp) {
      join({way(0, 3)}, B(), B(1.0));
    } else if (rotation.curve() == spline::RotationCurve::squad) {
      weight_ = {B(), B(2.0), B(-2.0)};
      join({way(0, 3), way(1, 2)}, B(), B(1.0));
    } else {
      weight_ = {B(), B(1.0), B()};
      join({way(0, 1), way(1, 2), way(2, 3)}, B(), B(1.0));
    }
  }

  const std::vector<Part>& parts() const { return parts_; }
  const Part& part_at(const B& place) const {
    const auto is_after = [&](const Part& part) { return place.middle() < part.end.middle(); };
    const auto found = std::ranges::find_if(parts_, is_after);
    return found == parts_.end() ? parts_.back() : *found;
  }

 private:
  static std::array<B, 4> angles_of(const std::array<spline::Quaternion<B>, 4>& points) {
    std::array<spline::Quaternion<B>, 4> turns;
    std::ranges::transform(points, turns.begin(), [&](const auto& q) { return conjugate(points[0]) * q; });
    const auto longest = std::ranges::max_element(turns, {}, [](const auto& q) {
      return dot(q, {q.x, q.y, q.z, B()}).middle();
    });
    const spline::Quaternion<B> axis = normalized(spline::Quaternion<B>{longest->x, longest->y, longest->z, B()});
    std::array<B, 4> angles;
    for (std::size_t i = 1; i < turns.size(); ++i) {
      const B sine = dot(turns[i], axis);
      angles[i] = sine.rough() < 0 ? -angle_of(-sine, turns[i].w) : angle_of(sine, turns[i].w);
    }
    return angles;
  }

  /// The whole turns that the shorter way leaves out. Throws: Undecided where the ways are about the same.
  static B turns_in(const B& angle) {
    const B turn = B(2.0) * spline::pi<B>();
    return turn * floor(angle / turn + B(0.5));
  }

  /// Joins each way with the next one, up to one.
  void join(const std::vector<Polynomial<B>>& ways, const B& begin, const B& end) {
    if (ways.size() == 1) return add(ways[0], begin, end);
    std::vector<Polynomial<B>> changes;
    std::vector<B> ends{begin, end};
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
      Polynomial<B>& change = changes.emplace_back();
      std::ranges::transform(ways[i + 1], ways[i], change.begin(), std::minus());
      constexpr int most_turns = 9;  // of half turns: more than three ways have together
      for (int turns = -most_turns; turns <= most_turns; turns += 2) {
        add_zeros(change[0] - B(turns) * spline::pi<B>(), change[1], change[2], begin, end, ends);
      }
    }
    ends = merged(std::move(ends));
    for (std::size_t part = 1; part < ends.size(); ++part) {
      const B middle((ends[part - 1] + ends[part]).middle());
      std::vector<Polynomial<B>> joined;
      for (std::size_t i = 0; i < changes.size(); ++i) {
        Polynomial<B> change = changes[i], way = ways[i];
        change[0] = change[0] - turns_in(value(change, halved(middle)));
        for (std::size_t power = 1; power < way.size(); ++power) {
          for (std::size_t k = 1; k <= std::min<std::size_t>(power, 2); ++k) {
            way[power] = way[power] + weight_[k] * change[power - k];
          }
        }
        joined.push_back(way);
      }
      join(joined, ends[part - 1], ends[part]);
    }
  }

  void add(const Polynomial<B>& angle, const B& begin, const B& end) {
    std::vector<B> rests, ends{begin, end};
    try {
      add_zeros(angle[1], B(2.0) * angle[2], B(3.0) * angle[3], begin, end, rests);
    } catch (const Undecided&) {  // it nearly rests, but does not turn back
    }
    std::ranges::copy(rests, std::back_inserter(ends));
    ends = merged(std::move(ends));
    const auto is_rest = [&](const B& place) {
      return std::ranges::any_of(rests, [&](const B& rest) { return (rest - place).may_be_zero(); });
    };
    for (std::size_t part = 1; part < ends.size(); ++part) {
      parts_.push_back({ends[part - 1], ends[part], is_rest(ends[part - 1]), is_rest(ends[part]), angle});
    }
  }

  std::array<B, 3> weight_;
  std::vector<Part> parts_;
};

}  // namespace

template <class B>
bool may_be_about_one_axis(const spline::RotationSegment<B>& rotation) {
  if (rotation.curve() == spline::RotationCurve::components || rotation.has_whole_turns()) return false;
  const auto& points = rotation.points();
  std::array<spline::Quaternion<B>, 3> turns;
  std::transform(points.begin() + 1, points.end(), turns.begin(),
                 [&](const auto& q) { return conjugate(points[0]) * q; });
  const auto size = [](const auto& q) { return q.x * q.x + (q.y * q.y + q.z * q.z); };
  const auto& longest = *std::ranges::max_element(turns, {}, [&](const auto& q) { return size(q).middle(); });
  return !size(longest).may_be_zero() && std::ranges::all_of(turns, [&](const auto& q) {
    return (q.x * longest.y - q.y * longest.x).may_be_zero() && (q.y * longest.z - q.z * longest.y).may_be_zero() &&
           (q.z * longest.x - q.x * longest.z).may_be_zero();
  });
}
template bool may_be_about_one_axis(const spline::RotationSegment<Ball>& rotation);
template bool may_be_about_one_axis(const spline::RotationSegment<RealBall>& rotation);

spline::RotationSegment<Ball> from_start(const spline::RotationSegment<RealBall>& rotation) {
  const auto rounded = [](const RealBall& number) { return ball_of(number); };
  std::array<spline::Quaternion<Ball>, 4> points{{{Ball(), Ball(), Ball(), Ball(1.0)}}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [x, y, z, w] = conjugate(rotation.points()[0]) * rotation.points()[i];
    const bool is_same = x.is_zero_at_last() && y.is_zero_at_last() && z.is_zero_at_last();
    points[i] = is_same ? points[0] : spline::Quaternion<Ball>{rounded(x), rounded(y), rounded(z), rounded(w)};
  }
  const auto& [x, y, z] = rotation.turn();
  return {rotation.curve(), points, {rounded(x), rounded(y), rounded(z)}};
}

namespace {

template <class B>
spline::RotationSegment<double> rough(const spline::RotationSegment<B>& rotation) {
  return rotation.template converted<double>([](const B& number) { return number.rough(); });
}

/// By divided differences at nodes around the place.
NearTurn near_turn(const spline::RotationSegment<RealBall>& rotation, NearTurn result) {
  std::array<spline::Vector3<RealBall>, NearTurn::nodes> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const RealBall u = RealBall(result.place) + RealBall(NearTurn::node(i));
    const auto [from, to] = rotation.pair_at(result.pair, u, RealBall(1.0) - u);
    const auto [x, y, z, w] = conjugate(from) * to;
    numbers[i] = {x, y, z};
  }
  for (std::size_t order = 1; order < numbers.size(); ++order) {
    for (std::size_t i = numbers.size() - 1; i >= order; --i) {
      const RealBall between(NearTurn::node(i) - NearTurn::node(i - order));
      for (std::size_t k = 0; k < 3; ++k) numbers[i][k] = (numbers[i][k] - numbers[i - 1][k]) / between;
    }
  }
  double left_out = 0;  // the next term, as an error of the second one
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) result.coefficients[i][k] = ball_of(numbers[i][k]);
  }
  for (const Ball& last : result.coefficients.back()) left_out += last.most();
  for (std::size_t i = 2; i < NearTurn::nodes; ++i) left_out *= NearTurn::reach;
  double along = 0, square = 0, least = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = result.coefficients[0][k].rough(), slope = result.coefficients[1][k].rough();
    along += value * slope;
    square += slope * slope;
    result.coefficients[1][k] = result.coefficients[1][k].widened(left_out);
  }
  result.nearest = -along / square;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = (result.coefficients[0][k] + Ball(result.nearest) * result.coefficients[1][k]).rough();
    least += value * value;
  }
  result.width = std::sqrt(least / square);
  return result;
}

/// The turns where the dot product of two points is below this.
constexpr double nearly_opposite = 0x1p-26 - 1;

}  // namespace

std::vector<NearTurn> near_turns(std::span<const spline::RotationSegment<RealBall>> rotations) {
  std::vector<NearTurn> result;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    for (std::size_t pair = 0; pair < rotations[i].pairs(); ++pair) {
      for (const double place : rough(rotations[i]).opposite_places(pair, nearly_opposite)) {
        result.push_back(near_turn(rotations[i], {i, pair, place}));
      }
    }
  }
  return result;
}

/// The rates of all rotations at a distance from a center, or near it.
template <class M>
std::vector<BallOf<M>> BallTurn<M>::rates(const Center& center, const B& distance) const {
  std::vector<B> rates;
  const B u = B(center.place) + distance;
  for (std::size_t i = 0; i < rotations_.size(); ++i) {
    const spline::LocalParameter<B> place{u, u - B(1.0)};
    spline::Vector3<B> rate;
    if constexpr (std::is_same_v<M, DoubleDouble>) {
      const NearTurn* const near = center.near;
      if (near != nullptr && near->rotation == i && (distance + B(near->nearest)).most() < NearTurn::reach) {
        using T = spline::Dual<B>;
        const auto join = [&](std::size_t pair, const spline::Quaternion<T>& from, const spline::Quaternion<T>& to,
                              const T& part, const T& left) {
          if (pair != near->pair) return spline::RotationSegment<B>::join_shorter(pair, from, to, part, left);
          const T from_place(distance + B(near->nearest), B(1.0));
          std::array<T, 3> vector;
          for (std::size_t k = 0; k < 3; ++k) {
            T& sum = vector[k] = near->coefficients.back()[k];
            for (std::size_t node = NearTurn::nodes - 1; node-- > 0;) {
              sum = T(near->coefficients[node][k]) + (from_place - T(B(NearTurn::node(node)))) * sum;
            }
          }
          const T square = vector[0] * vector[0] + (vector[1] * vector[1] + vector[2] * vector[2]), size = sqrt(square);
          const auto [sine, cosine] = sine_cosine(part * angle_of(size, -sqrt(T(B(1.0)) - square)));
          const T factor = sine / size;
          return from * spline::Quaternion<T>{vector[0] * factor, vector[1] * factor, vector[2] * factor, cosine};
        };
        rate = rotations_[i].rate(place, join);
      } else {
        rate = rotations_[i].rate(place);
      }
    } else {
      rate = rotations_[i].rate(place);
    }
    std::ranges::copy(rate, std::back_inserter(rates));
  }
  return rates;
}

template <class M>
typename BallTurn<M>::Distance BallTurn<M>::distance(const Panel& panel, const B& z) {
  const B scale(panel.scale);
  if (!panel.is_graded) return {scale * z, scale};
  const B left = B(4.0) - B(3.0) * z;
  return {B(4.0) * scale * (B(1.0) + B(3.0) * z) / left, B(60.0) * scale / (left * left)};
}

/// The speed by z.
template <class M>
typename BallTurn<M>::B BallTurn<M>::speed(const Panel& panel, const B& z) const {
  const auto [value, slope] = distance(panel, z);
  const std::vector<B> all = rates(centers_[panel.center], value);
  return sqrt(std::inner_product(all.begin(), all.end(), all.begin(), B())) * abs(slope);
}

/// The angle from the start of a panel to a place.
template <class M>
typename BallTurn<M>::B BallTurn<M>::sum(const Panel& panel, const B& z) const {
  const B begin(panel.begin), width = z - begin;
  const B way = panel.end < panel.begin ? -width : width;
  if (panel.is_constant) return speed(panel, B(spline::halved(panel.begin + panel.end))) * way;
  const Rule<M>& rule = gauss_rule<M>();
  B sum;
  const Bound rounding = Ops::power_of_two(-(Ops::bits() + 6));  // of nodes and weights
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    sum += B(rule.weight[i], rounding) * speed(panel, begin + width * B(rule.node[i], rounding));
  }
  return sum * way;
}

/// Sets the length of a panel, and returns whether the rule errs by no more than a negligible length, or noise. The
/// coefficients of the polynomial through the speeds at the nodes decrease about as powers of a number: from the middle
/// ones to the last ones, and as much from these to half of those that the rule misses.
template <class M>
bool BallTurn<M>::measure(Panel& panel, const Bound& negligible) const {
  panel.last_distance = distance(panel, B(panel.end)).value.middle();
  if (panel.is_constant) {
    panel.length = sum(panel, B(panel.end));
    return true;
  }
  const Rule<M>& rule = gauss_rule<M>();
  const B begin(panel.begin), width = B(panel.end) - begin;
  B sum;
  Bound noise = 0.0;
  M fastest(0.0);
  std::vector<M> speeds;
  std::array<M, 4> coefficients{};
  const Bound rounding = Ops::power_of_two(-(Ops::bits() + 6));  // of nodes and weights
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const B speed = this->speed(panel, begin + width * B(rule.node[i], rounding));
    sum += B(rule.weight[i], rounding) * speed;
    noise = std::max(noise, speed.radius());
    speeds.push_back(speed.middle());
    fastest = std::max(fastest, speed.middle());
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      coefficients[k] = coefficients[k] + rule.orders[k][i] * speed.middle();
    }
  }
  panel.speeds.clear();
  for (const M& speed : speeds) panel.speeds.push_back(Ops::is_zero(fastest) ? 0 : rough_ratio(speed, fastest));
  const auto largest = [&](std::size_t k) {
    return std::max(Ops::most(coefficients[k]), Ops::most(coefficients[k + 1]));
  };
  const Bound middle = largest(0), last = largest(2);
  const bool is_noise = last <= Bound(64.0) * noise;
  const Bound factor = last < middle ? Bound(last / middle) : Bound(1.0);
  const Bound error = Ops::up(is_noise ? last : last * factor * factor * Bound(16.0)) * Ops::most(width.middle());
  panel.length = (sum * abs(width)).widened(error);
  return is_noise || error <= negligible || panel.length.most() <= negligible;
}

/// The part of a panel in which a fraction of its length lies, nearly, by the polynomial through the speeds.
/// Source: H. Wang, S. Xiang, "On the convergence rates of Legendre approximation",
/// doi:10.1090/S0025-5718-2011-02549-4,
///   for the weights of the barycentric formula.
template <class M>
double BallTurn<M>::rough_place(const Panel& panel, double fraction) {
  if (panel.speeds.empty()) return fraction;
  const Rule<M>& rule = gauss_rule<M>();
  std::vector<double> nodes, weights;
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    nodes.push_back(rough_ratio(rule.node[i], M(1.0)));
    weights.push_back(rough_ratio(rule.weight[i], M(1.0)));
  }
  const auto speed = [&](double at) {
    double above = 0, below = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (at == nodes[i]) return panel.speeds[i];
      const double weight = std::sqrt(nodes[i] * (1 - nodes[i]) * weights[i]) / (at - nodes[i]);
      above += i % 2 == 0 ? weight * panel.speeds[i] : -weight * panel.speeds[i];
      below += i % 2 == 0 ? weight : -weight;
    }
    return above / below;
  };
  const auto sum = [&](double to) {
    double total = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) total += weights[i] * speed(to * nodes[i]);
    return total * to;
  };
  const double length = fraction * sum(1);
  double low = 0, high = 1, at = std::clamp(fraction, 0.0, 1.0);
  for (int step = 0; step < 60; ++step) {
    const double excess = sum(at) - length;
    (excess > 0 ? high : low) = at;
    double next = at - excess / speed(at);
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool is_settled = std::abs(next - at) < 0x1p-48;
    at = next;
    if (is_settled) break;
  }
  return at;
}

/// Adds a panel if the rule is accurate on it; else its parts.
template <class M>
void BallTurn<M>::add(Panel panel, int depth, const Bound& negligible) {
  const double size = centers_[panel.center].size;
  const bool is_wide = size > 0 && panel.touches() && Ops::most(panel.scale) > Bound(16 * size);
  if (!is_wide && measure(panel, negligible)) {
    panel.before = total_;
    total_ += panel.length;
    panels_.push_back(panel);
    return;
  }
  if (depth > 3 * Ops::bits() || panels_.size() > 10 * static_cast<std::size_t>(Ops::bits())) throw Undecided();
  Panel first = panel, second = panel;
  if (!panel.touches()) {
    first.end = second.begin = spline::halved(panel.begin + panel.end);
  } else {
    const bool begins = Ops::is_zero(panel.begin);
    const bool is_smooth = depth < 2 && size == 0;
    Panel &inner = begins ? first : second, &outer = begins ? second : first;
    inner.scale = panel.scale * M(is_smooth ? 0x1p-2 : 0x1p-4);
    outer.scale = panel.scale * M(0x1p-4);
    outer.is_graded = true;
    (begins ? outer.begin : outer.end) = M(is_smooth ? 0.5 : 0.0);
  }
  add(first, depth + 1, negligible);
  add(second, depth + 1, negligible);
}

/// The place at which it rests near another one, by the secant method; where it does not, some place nearby.
template <class M>
M BallTurn<M>::rest_near(double place) const {
  B before(place), next = before + B(0x1p-26);
  const auto rates_at = [&](const B& u) { return rates({M(0.0)}, u); };
  const auto dot = [](const std::vector<B>& a, const std::vector<B>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), B());
  };
  try {
    std::vector<B> rates_before = rates_at(before);
    for (int step = 0; step < 5; ++step) {
      const std::vector<B> rates = rates_at(next);
      std::vector<B> change;
      std::ranges::transform(rates, rates_before, std::back_inserter(change), std::minus());
      const B moved = dot(rates, change) / dot(change, change) * (next - before);
      rates_before = rates;
      before = std::exchange(next, B((next - moved).middle()));
    }
  } catch (const Undecided&) {  // nearer than the digits show
  }
  return before.middle();
}

/// Each part as cubics of its own, which begin and end at rest where they do so exactly.
template <class M>
void BallTurn<M>::assign_cubics() {
  std::vector<AngleAboutAxis<B>> angles;
  std::vector<B> ends;
  for (const auto& rotation : rotations_) {
    angles.emplace_back(rotation);
    for (const auto& part : angles.back().parts()) ends.insert(ends.end(), {part.begin, part.end});
  }
  ends = merged(std::move(ends));
  for (std::size_t i = 1; i < ends.size(); ++i) {
    Cubics cubics{ends[i - 1], ends[i] - ends[i - 1], {}, total_};
    std::vector<spline::Cubic<B>> channels;
    for (const auto& angle : angles) {
      const auto& part = angle.part_at(B(spline::halved(ends[i - 1].middle() + ends[i].middle())));
      const auto& p = part.angle;
      const auto slope = [&](const B& u) {
        return B(2.0) * cubics.width * (p[1] + u * (B(2.0) * p[2] + u * (B(3.0) * p[3])));
      };
      const B square = B(2.0) * cubics.width * cubics.width, cube = square * cubics.width;
      spline::Cubic<B> x;
      x.p0 = B(2.0) * value(p, ends[i - 1]), x.p1 = B(2.0) * value(p, ends[i]);
      x.out = part.begins_at_rest && angles.size() == 1 ? B() : slope(ends[i - 1]);
      x.in = part.ends_at_rest && angles.size() == 1 ? B() : slope(ends[i]);
      x.c = square * (p[2] + B(3.0) * ends[i - 1] * p[3]), x.e = square * (p[2] + B(3.0) * ends[i] * p[3]);
      x.d = cube * p[3];
      channels.push_back(x);
    }
    cubics.arc.assign(channels, {});
    total_ += cubics.arc.total();
    cubics_.push_back(std::move(cubics));
  }
}

/// The places next to which the speed changes fast: where two points are nearly opposite, where it is 0, or nearly so,
/// where a constant rate begins or ends, and, as it may do so there, both ends and the middle. `speed`: in doubles.
template <class M>
std::vector<typename BallTurn<M>::Center> BallTurn<M>::centers(const std::function<double(double)>& speed) const {
  std::vector<Center> result{{M(0.0)}, {M(0.5)}, {M(1.0)}};
  for (const NearTurn& near : near_) result.push_back({M(near.place) + M(near.nearest), near.width, &near});
  for (const auto& rotation : rotations_) {
    for (const B& place : rotation.constant_part()) result.push_back({place.middle()});
  }
  std::vector<double> speeds;
  for (int i = 0; i <= rough_parts; ++i) speeds.push_back(speed(static_cast<double>(i) / rough_parts));
  const double small = 0x1p-10 * *std::ranges::max_element(speeds);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, speeds.size() - 1);
    if (!(speeds[i] <= speeds[before] && speeds[i] <= speeds[after])) continue;
    double low = static_cast<double>(before) / rough_parts, high = static_cast<double>(after) / rough_parts;
    for (int third = 0; third < 80; ++third) {  // the speed decreases and then increases
      const double left = low + (high - low) / 3, right = high - (high - low) / 3;
      (speed(left) < speed(right) ? high : low) = speed(left) < speed(right) ? right : left;
    }
    if (speed(low) < small) result.push_back({rest_near(low)});
  }
  std::erase_if(result, [](const Center& center) { return center.place < M(0.0) || M(1.0) < center.place; });
  std::ranges::sort(result, {}, &Center::place);
  const auto is_same = [](const Center& a, const Center& b) { return a.place == b.place; };
  result.erase(std::unique(result.begin(), result.end(), is_same), result.end());
  return result;
}

/// Whether all rotations turn at a constant rate between two places.
template <class M>
bool BallTurn<M>::is_constant(const M& begin, const M& end) const {
  const M middle = spline::halved(begin + end);
  return std::ranges::all_of(rotations_, [&](const auto& rotation) {
    const auto [from, to] = rotation.constant_part();
    return from.middle() < middle && middle < to.middle();
  });
}

/// The places at which a constant rate begins or ends are known but for an error, in which the speed is at most twice
/// that next to it.
template <class M>
void BallTurn<M>::assign(std::span<const spline::RotationSegment<B>> rotations, bool about_axes,
                         std::vector<NearTurn> near) {
  rotations_ = rotations;
  near_ = std::move(near);
  panels_.clear();
  cubics_.clear();
  total_ = B();
  if (about_axes) return assign_cubics();
  std::vector<spline::RotationSegment<double>> doubles;
  std::ranges::transform(rotations, std::back_inserter(doubles), rough<B>);
  const auto speed = [&](double u) {
    double square = 0;
    for (const auto& rotation : doubles) {
      for (const double rate : rotation.rate({u, u - 1})) square += rate * rate;
    }
    return std::sqrt(square);
  };
  for (const auto& rotation : doubles) {
    for (std::size_t pair = 0; std::is_same_v<M, DoubleDouble> && near_.empty() && pair < rotation.pairs(); ++pair) {
      if (!rotation.opposite_places(pair, 0x1p-46 - 1).empty()) throw Undecided();
    }
  }
  double whole = 0, fastest = 0;
  for (int i = 0; i <= rough_parts; ++i) {
    const double here = speed(static_cast<double>(i) / rough_parts);
    whole += here / (rough_parts + 1);
    fastest = std::max(fastest, here);
  }
  if (!std::isfinite(whole)) throw Undecided();
  Bound doubt = 0.0;
  for (const auto& rotation : rotations) {
    for (const B& place : rotation.constant_part()) {
      if (place.middle() > M(0.0) && place.middle() < M(1.0)) doubt = doubt + Bound(4.0) * place.radius();
    }
  }
  total_ = total_.widened(doubt * Bound(fastest));
  centers_ = centers(speed);
  const Bound negligible = Ops::power_of_two(14 - Ops::bits()) * Bound(whole);
  for (std::size_t i = 0; i + 1 < centers_.size(); ++i) {
    const M &from = centers_[i].place, &to = centers_[i + 1].place, half = spline::halved(to - from);
    const bool constant = is_constant(from, to);
    add({i, half, M(0.0), M(1.0), constant}, 0, negligible);
    add({i + 1, -half, M(1.0), M(0.0), constant}, 0, negligible);
  }
}

template <class M>
typename BallTurn<M>::B BallTurn<M>::to(const spline::LocalParameter<B>& place) const {
  if (place.w.is_zero()) return total_;
  const M u = place.u.middle();
  if (!cubics_.empty()) {
    auto part =
        std::ranges::find_if(cubics_, [&](const Cubics& cubics) { return u < (cubics.begin + cubics.width).middle(); });
    if (part == cubics_.end()) --part;
    return part->before + part->arc.to(local(0, (place.u - part->begin) / part->width));
  }
  auto panel = std::ranges::find_if(
      panels_, [&](const Panel& one) { return u < centers_[one.center].place + one.last_distance; });
  if (panel == panels_.end()) --panel;
  const B distance = place.u - B(centers_[panel->center].place), scale(panel->scale);
  const B z = panel->is_graded ? B(4.0) * (distance - scale) / (B(12.0) * scale + B(3.0) * distance) : distance / scale;
  return panel->before + sum(*panel, z).widened(panel->length.radius());
}

/// By Newton's method, or by halves where it leaves the panel; the speed at both ends of the ball of the place shows
/// that it does not change much there.
template <class M>
typename BallTurn<M>::Place BallTurn<M>::place(const B& length) const {
  if (!cubics_.empty()) {
    const Cubics& part = panel_at_length(cubics_, length.middle());
    return {M(0.0), part.begin + part.width * part.arc.place(length - part.before).u};
  }
  const Panel& panel = panel_at_length(panels_, length.middle());
  const B into = length - panel.before;
  const bool ascends = panel.begin < panel.end;
  M low = ascends ? panel.begin : panel.end, high = ascends ? panel.end : panel.begin;
  const double part = rough_place(panel, rough_ratio(into.middle(), panel.length.middle()));
  B z = B(panel.begin + (panel.end - panel.begin) * M(part));
  const int most_steps = Ops::bits() + 40;
  for (int step = 0; step < most_steps; ++step) {
    if (!(low < z.middle() && z.middle() < high)) z = B(spline::halved(low + high));
    const B rest = into - sum(panel, z), speed = B(this->speed(panel, z).middle());
    const Bound distance = Ops::up(Bound(2.01) * (rest.most() + panel.length.radius()) / Ops::least(speed.middle()));
    if (Ops::most(rest.middle()) <= rest.radius()) {
      if (!(distance < Ops::power_of_two(-(Ops::bits() * 6 / 10)))) throw Undecided();
      for (const bool below : {true, false}) {  // no step brings it nearer
        const B side(Ops::number(distance));
        if (!(this->speed(panel, below ? z - side : z + side) > halved(speed))) throw Undecided();
      }
      return {centers_[panel.center].place, this->distance(panel, z.widened(distance)).value};
    }
    (Ops::is_negative(rest.middle()) == ascends ? high : low) = z.middle();
    const B step_to_rest = B(rest.middle()) / speed;
    z = B((ascends ? z + step_to_rest : z - step_to_rest).middle());
  }
  throw Undecided();
}

template class BallArc<DoubleDouble>;
template class BallArc<Real>;
template class BallTurn<DoubleDouble>;
template class BallTurn<Real>;

}  // namespace tcb
