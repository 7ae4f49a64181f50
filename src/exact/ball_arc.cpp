// Lengths of paths in balls: panels under one quadrature rule, with bounds on the errors of the rule and of its
// rounding.
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
#include "exact/ball_arc.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "exact/ball_quadrature.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

constexpr double disc = 1.7;

/// A bound on the errors of a rule and of its rounding, per root and width: 2^-88 of double-doubles.
template <class M>
typename Middle<M>::Bound rule_error() {
  return Middle<M>::power_of_two(12 - Middle<M>::bits());
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

/// Whether a cubic moves in one direction: its derivative has one sign at both ends, and no zero between them.
template <class B>
bool is_monotone(const spline::Cubic<B>& x) {
  const B middle = x.out + x.c;  // the derivative is out (1 - u)^2 + 2 middle u (1 - u) + in u^2
  const auto has_sign = [](const B& slope, bool negative) {
    return slope.is_zero() || (!slope.may_be_zero() && (slope.rough() < 0) == negative);
  };
  const auto is_clear = [](const B& excess) { return !excess.may_be_zero() && excess.rough() > 0; };
  return std::ranges::any_of(std::array{false, true}, [&](bool negative) {
    return has_sign(x.out, negative) && has_sign(x.in, negative) &&
           (has_sign(middle, negative) || is_clear(x.out * x.in - middle * middle));
  });
}

/// The coefficients of a quartic over the first one, in doubles. Requires: the first one is not 0.
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

}  // namespace

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
  const BallRule<M>& rule = ball_rule<M>();
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
  const auto& rule = ball_rule<DoubleDouble>();
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
    const auto q = relative(panel.square);
    const double middle = zeros == 0 ? 0 : rough_ratio(panel.middle, panel.width);
    const auto speed = [&](double place) {
      const double z = 2 * place - 1;
      return std::sqrt(quartic(q, z)) * power_of(middle + z, zeros);
    };
    return M(2 * rough_place(speed, rough_ratio(into.middle(), panel.length.middle())) - 1);
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

template class BallArc<DoubleDouble>;
template class BallArc<Real>;

}  // namespace tcb
