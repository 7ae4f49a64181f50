// Angles of rotations in balls.
//
// Where each rotation of a segment is about one axis, its angle is a cubic in a few parts of the segment
// (axis_angle.hpp), and the length is that of the path of all angles (BallArc). Else the segment is divided into panels
// that become shorter towards the places where the speed changes fast, until one quadrature rule is accurate on each
// (BallTurn). Where two points that the curve joins are nearly opposite, the turn between them is a polynomial that
// floats of many digits determine (near_turn.hpp).
#include "exact/ball_turn.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <utility>

#include "exact/axis_angle.hpp"
#include "exact/ball.hpp"
#include "exact/ball_quadrature.hpp"

namespace tcb {

using spline::DoubleDouble;

namespace {

/// The rate of a rotation near a turn that is known there, at a distance from its place.
spline::Vector3<Ball> rate_near(const NearTurn& near, const spline::RotationSegment<Ball>& rotation,
                                const spline::LocalParameter<Ball>& place, const Ball& distance) {
  using T = spline::Dual<Ball>;
  const auto join = [&](std::size_t pair, const spline::Quaternion<T>& from, const spline::Quaternion<T>& to,
                        const T& part, const T& left) {
    if (pair != near.pair) return spline::RotationSegment<Ball>::join_shorter(pair, from, to, part, left);
    const T from_place(distance, Ball(1.0));
    std::array<T, 3> vector;
    for (std::size_t k = 0; k < 3; ++k) {
      T& sum = vector[k] = near.coefficients.back()[k];
      for (std::size_t node = NearTurn::nodes - 1; node-- > 0;) {
        sum = T(near.coefficients[node][k]) + (from_place - T(Ball(NearTurn::node(node)))) * sum;
      }
    }
    const T square = vector[0] * vector[0] + (vector[1] * vector[1] + vector[2] * vector[2]), size = sqrt(square);
    const auto [sine, cosine] = sine_cosine(part * angle_of(size, -sqrt(T(Ball(1.0)) - square)));
    const T factor = sine / size;
    return from * spline::Quaternion<T>{vector[0] * factor, vector[1] * factor, vector[2] * factor, cosine};
  };
  return rotation.rate(place, join);
}
/// Floats have enough digits for the turn between the points themselves.
spline::Vector3<RealBall> rate_near(const NearTurn&, const spline::RotationSegment<RealBall>& rotation,
                                    const spline::LocalParameter<RealBall>& place, const RealBall&) {
  return rotation.rate(place);
}

/// The polynomial through the speeds at the nodes of the rule, by the barycentric formula.
/// Source: H. Wang, S. Xiang, "On the convergence rates of Legendre approximation",
///   doi:10.1090/S0025-5718-2011-02549-4, for its weights.
template <class M>
std::function<double(double)> polynomial_through(const std::vector<double>& speeds) {
  const BallRule<M>& rule = ball_rule<M>();
  std::vector<double> nodes, weights;
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double node = rough_ratio(rule.node[i], M(1.0)), weight = rough_ratio(rule.weight[i], M(1.0));
    nodes.push_back(node);
    weights.push_back((i % 2 == 0 ? 1 : -1) * std::sqrt(node * (1 - node) * weight));
  }
  return [speeds, nodes, weights](double at) {
    double above = 0, below = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (at == nodes[i]) return speeds[i];
      const double weight = weights[i] / (at - nodes[i]);
      above += weight * speeds[i];
      below += weight;
    }
    return above / below;
  };
}

}  // namespace

template <class M>
std::vector<BallOf<M>> BallTurn<M>::rates(const Center& center, const B& distance) const {
  std::vector<B> rates;
  const B u = B(center.place) + distance;
  const spline::LocalParameter<B> place{u, u - B(1.0)};
  const NearTurn* const near = center.near;
  for (std::size_t i = 0; i < rotations_.size(); ++i) {
    const bool is_near =
        near != nullptr && near->rotation == i && (distance + B(near->nearest)).most() < Bound(NearTurn::reach);
    const auto rate =
        is_near ? rate_near(*near, rotations_[i], place, distance + B(near->nearest)) : rotations_[i].rate(place);
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
  const BallRule<M>& rule = ball_rule<M>();
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
  const BallRule<M>& rule = ball_rule<M>();
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
  return is_noise || error <= negligible;
}

/// Adds a panel if the rule is accurate on it; else its parts.
template <class M>
void BallTurn<M>::add(Panel panel, int depth, const Bound& negligible) {
  const double size = centers_[panel.center].size;
  const bool is_wide = size > 0 && !panel.is_graded && Ops::most(panel.scale) > Bound(16 * size);
  if (!is_wide && measure(panel, negligible)) {
    panel.before = total_;
    total_ += panel.length;
    panels_.push_back(panel);
    return;
  }
  if (depth > 3 * Ops::bits() || panels_.size() > 10 * static_cast<std::size_t>(Ops::bits())) throw Undecided();
  Panel first = panel, second = panel;
  if (panel.is_graded) {
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

/// The place near another one at which the rotations rest, by the secant method; some place nearby if they do not.
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

/// Divides the segment into parts on which each angle about an axis is one cubic, from rest or to rest where it is so
/// exactly.
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
/// and where a constant rate begins or ends; also both ends and the middle, where it may do so. `speed`: in doubles.
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

/// The places at which a constant rate begins or ends have an error; within it the speed is at most twice that next to
/// it.
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
  std::ranges::transform(rotations, std::back_inserter(doubles), in_doubles<B>);
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
    const B at = (place.u - part->begin) / part->width;
    return part->before + part->arc.to({at, at - B(1.0)});
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
  double part = rough_ratio(into.middle(), panel.length.middle());
  if (!panel.speeds.empty()) part = rough_place(polynomial_through<M>(panel.speeds), part);
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

template class BallTurn<DoubleDouble>;
template class BallTurn<Real>;

}  // namespace tcb
