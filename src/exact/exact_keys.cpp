// Keys as exact numbers, and the curves that they make at any scalar.
#include "exact/exact_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "error.hpp"
#include "exact/exact_curve.hpp"
#include "exact/float_scalar.hpp"
#include "keys/prepare.hpp"
#include "numbers/decimal_time.hpp"
#include "tcb/spline/closing.hpp"
#include "tcb/spline/rotation_notation.hpp"

namespace tcb {

/// The power of a distance between exact positions, as the square of the distance is exact.
template <class S>
struct ExactDistancePower {
  explicit ExactDistancePower(const Rational&) {}
  void add_square(const Rational& a, const Rational& b) { sum_ += (b - a) * (b - a); }
  /// By the nested roots of spline::power_by_roots(). Requires: 0 <= exponent < 2^53.
  S power(double exponent) const {
    S x = spline::square_root(scalar_of<S>(sum_)), whole_part(1.0), root(1.0);
    double whole = std::floor(exponent), rest = exponent - whole;
    int bits = 0;
    for (; rest != std::floor(rest); rest *= 2) ++bits;
    const S root_of_x = spline::square_root(x);
    for (auto left = static_cast<std::uint64_t>(rest); bits > 0; --bits, left >>= 1) {
      root = (left & 1U) != 0 ? S(spline::square_root(root) * root_of_x) : S(spline::square_root(root));
    }
    for (auto left = static_cast<std::uint64_t>(whole); left > 0; left >>= 1, x = x * x) {
      if ((left & 1U) != 0) whole_part = whole_part * x;
    }
    return whole_part * root;
  }

 private:
  Rational sum_ = 0;
};
template <>
struct DistancePower<spline::DoubleDouble> : ExactDistancePower<spline::DoubleDouble> {
  using ExactDistancePower::ExactDistancePower;
};
template <unsigned bits>
struct DistancePower<Float<bits>> : ExactDistancePower<Float<bits>> {
  using ExactDistancePower<Float<bits>>::ExactDistancePower;
};

namespace {

/// The numbers of one key of a block.
class Numbers {
 public:
  Numbers(const KeyBlock& block, std::size_t key, bool decimal)
      : block_(block), key_(key), per_key_(block.decimals.size() / block.size()), decimal_(decimal) {}

  /// Whether the key has a number at this index as written.
  bool has(std::size_t index) const { return index < per_key_ && !block_.decimals[key_ * per_key_ + index].empty(); }

  /// The number at this index among the key's decimals. Requires: not missing.
  Rational operator()(std::size_t index, const Time& nearest) const {
    return of(index < per_key_ ? block_.decimals[key_ * per_key_ + index] : std::string_view(), nearest);
  }

  /// One of the numbers of its given rotations.
  Rational of_rotation(std::size_t rotation, std::size_t number, double nearest) const {
    const std::size_t given = block_.rotations.numbers.size() / block_.size();
    const std::size_t index = (key_ * given + rotation) * spline::RotationNumbers<double>().size() + number;
    return of(block_.rotations.decimals.empty() ? std::string_view() : block_.rotations.decimals[index], nearest);
  }

 private:
  Rational of(std::string_view text, const Time& nearest) const {
    if (!decimal_ || text.empty()) return exact_number(nearest, decimal_);
    if (text.find('x') != std::string_view::npos) return exact_number(nearest, false);  // hexadecimal is exact
    if (const auto number = parse_rational(text)) return *number;
    throw data_error(
        "a number has more digits than --exact-input takes; expected at most 10,000; shorten it, or remove "
        "--exact-input")
        .at({"", block_.line(key_), 0});
  }

  const KeyBlock& block_;
  std::size_t key_, per_key_;
  bool decimal_;
};

/// Tension, continuity and bias in a channel: its own where they are written, or else those of the key.
spline::Tcb<Rational> exact_tcb(const spline::Tcb<double>& tcb, const Numbers& number, std::size_t channel,
                                std::size_t channels) {
  const auto exact = [&](NumberOfKey::Kind own, std::size_t common, double nearest) {
    const std::size_t index = NumberOfKey::of_channel(own, channel, channels);
    return number(number.has(index) ? index : common, nearest);
  };
  return {exact(NumberOfKey::tension_of, NumberOfKey::tension, tcb.tension),
          exact(NumberOfKey::continuity_of, NumberOfKey::continuity, tcb.continuity),
          exact(NumberOfKey::bias_of, NumberOfKey::bias, tcb.bias)};
}

/// A time and the time that a distance makes, to some 90 digits.
Rational later(const Rational& time, std::span<const Rational> from, std::span<const Rational> to,
               std::span<const std::size_t> metric, double exponent) {
  return time + rational_of(parameter_step<LongFloat, Rational>(from, to, exponent, metric));
}

/// Last key - first key in a channel of an open curve, among the keys that have a position there.
Rational cycle(const ExactCurve& exact, std::size_t channel) {
  const auto is_missing = [&](std::size_t key) { return exact.keys.is_missing(key, channel); };
  std::size_t first = 0, last = exact.keys.size() - 1;
  while (is_missing(first)) ++first;
  while (is_missing(last)) --last;
  return exact.keys.position(last)[channel] - exact.keys.position(first)[channel];
}

}  // namespace

spline::CurveRules<Rational> exact_rules(const spline::CurveRules<double>& rules, bool decimal) {
  return spline::converted<Rational>(rules, [&](double value) { return exact_number(value, decimal); });
}

Rational exact_number(const Time& time, bool decimal, const std::optional<FrameTimes>& frames) {
  const auto frame = frames ? frames->exact(time) : std::nullopt;
  return frame ? *frame : exact_number(time, decimal);
}

ChannelFacts channel_facts(const ExactCurve& exact) {
  const std::size_t channels = exact.keys.channels;
  ChannelFacts facts{std::vector<bool>(channels, true), std::vector<bool>(channels, true),
                     std::vector<Rational>(channels, 0)};
  for (std::size_t i = 0; i < exact.keys.positions.size(); ++i) {
    const std::size_t channel = i % channels;
    if (exact.keys.positions[i] != exact.keys.positions[channel]) facts.constant[channel] = false;
    if (exact.keys.positions[i] != 0) facts.zero[channel] = false;
  }
  for (std::size_t i = 0; i < exact.keys.given.size(); ++i) {
    if (exact.keys.given[i]) facts.constant[i] = facts.zero[i] = false;
  }
  const bool has_velocities = !exact.rules.start.velocity.empty() || !exact.rules.end.velocity.empty();
  if (has_velocities) facts.constant = facts.zero = std::vector<bool>(channels, false);  // the ends move the curve
  const std::vector<bool> in_rotations = spline::in_rotations(exact.channels.rotations, channels);
  for (std::size_t i = 0; i < channels; ++i) {
    if (in_rotations[i]) facts.constant[i] = facts.zero[i] = false;  // turns move numbers that all keys have alike
  }
  for (std::size_t i = 0; i < channels && !exact.closed; ++i) facts.cycle[i] = cycle(exact, i);
  return facts;
}

/// Adds the velocities of a key. A missing one is 0, and has no effect.
template <class Numbers>
void ExactKeys::add_velocities(const Keys& keys, std::size_t key, const Numbers& number) {
  keys_.given = keys.given;
  for (std::size_t i = 0; !keys.velocities.empty() && i < keys.channels; ++i) {
    const auto exact = [&](NumberOfKey::Kind kind, double value) {
      return std::isnan(value) ? Rational(0) : number(NumberOfKey::of_channel(kind, i, keys.channels), value);
    };
    const auto& [in, out] = keys.velocities[key * keys.channels + i];
    keys_.velocities.push_back({exact(NumberOfKey::velocity_in_of, in), exact(NumberOfKey::velocity_out_of, out)});
  }
}

bool ExactKeys::is_converted(std::size_t channel) const {
  return std::ranges::any_of(converted_,
                             [&](const ExactRotation& exact) { return exact.rotation.columns.has(channel); });
}

void ExactKeys::add(const KeyBlock& block) {
  const spline::Keys<double>& keys = block.keys;
  keys_.channels = keys.channels;
  for (std::size_t key = 0; key < keys.size(); ++key) {
    const Numbers number(block, key, decimal_);
    const bool is_written = decimal_ && number.has(NumberOfKey::time);
    keys_.times.push_back(is_written ? number(NumberOfKey::time, keys.times[key])
                                     : exact_number(keys.times[key], decimal_, frames_));
    for (std::size_t i = 0; i < (keys.has_channel_tcbs() ? keys.channels : 1); ++i) {
      keys_.tcbs.push_back(exact_tcb(keys.tcb(key, i), number, i, keys.channels));
    }
    if (!keys.eases.empty()) {
      const spline::Ease<double>& ease = keys.eases[key];
      keys_.eases.push_back({number(NumberOfKey::ease_in, ease.in), number(NumberOfKey::ease_out, ease.out)});
    }
    add_velocities(keys, key, number);
    for (std::size_t i = 0; i < converted_.size(); ++i) {
      const auto& given = block.rotations.numbers[key * converted_.size() + i];
      spline::RotationNumbers<Rational>& exact = converted_[i].numbers.emplace_back();
      for (std::size_t j = 0; j < converted_[i].rotation.notation.numbers(); ++j) {
        if (!std::isnan(given[j])) exact[j] = number.of_rotation(i, j, given[j]);
      }
    }
    const std::size_t turns = keys.turns_per_key();
    for (const auto& [x, y, z] : std::span(keys.turns).subspan(key * turns, turns)) {
      keys_.turns.push_back({exact_number(x, false), exact_number(y, false), exact_number(z, false)});
    }
    for (std::size_t i = 0; i < keys.channels; ++i) {
      const double position = keys.position(key)[i];
      keys_.missing.push_back(std::isnan(position));
      if (keys_.missing.back()) {
        keys_.positions.emplace_back(0);
      } else if (is_converted(i)) {
        keys_.positions.push_back(exact_number(position, false));
      } else {
        keys_.positions.push_back(number(NumberOfKey::position + i, position));
      }
    }
  }
}

void ExactKeys::set_times(KeyBlock& block, double exponent, std::span<const std::size_t> metric) {
  std::size_t key = keys_.size() - block.keys.size();
  for (Time& time : block.keys.times) {
    if (key > 0) time_ = later(time_, keys_.position(key - 1), keys_.position(key), metric, exponent);
    time = nearest_double(time_);
    ++key;
  }
}

Time ExactKeys::time_back(double exponent, std::span<const std::size_t> metric) const {
  const auto last = keys_.position(keys_.size() - 1);
  return nearest_double(later(time_, last, keys_.position(0), metric, exponent));
}

ExactCurve ExactKeys::curve(std::size_t size, const spline::CurveRules<double>& rules,
                            const std::optional<Rational>& end) const {
  ExactCurve curve;
  spline::append(curve.keys, keys_, 0, size);
  curve.converted = converted_;
  curve.rules = exact_rules(rules, decimal_);
  if (size < keys_.size()) {  // the key that repeats the first one
    spline::Keys<Rational> first, repeated;
    spline::append(first, keys_, 0, 1);
    spline::append(repeated, keys_, size, size + 1);
    spline::join_seam(curve.keys, spline::with_signs_of(first, std::move(repeated), curve.rules.rotations));
  }
  curve.end = size < keys_.size() ? std::optional(keys_.times[size]) : end;
  curve.decimal = decimal_;
  return curve;
}

// The curve at any scalar: keys, rules and rotations converted.

namespace {

/// The times of the keys at a scalar, and where a closed curve is back at the first one.
template <class S>
std::pair<std::vector<S>, std::optional<S>> exact_times(const ExactCurve& exact) {
  std::pair<std::vector<S>, std::optional<S>> result;
  auto& [times, end] = result;
  if (exact.end) end = scalar_of<S>(*exact.end);
  if (!exact.exponent) {
    for (const Rational& time : exact.keys.times) times.push_back(scalar_of<S>(time));
    return result;
  }
  if constexpr (spline::has_roots<S>) {
    const auto step = [&](std::size_t from, std::size_t to) {
      return parameter_step<S, Rational>(exact.keys.position(from), exact.keys.position(to), *exact.exponent,
                                         exact.rules.metric);
    };
    const std::size_t size = exact.keys.size();
    for (std::size_t i = 0; i < size; ++i) times.push_back(i == 0 ? S(0) : S(times.back() + step(i - 1, i)));
    if (exact.closed && !end) end = times.back() + step(size - 1, 0);
  }
  return result;
}

/// Converts the quaternions of keys that give a rotation in another form, and their turns. Requires: `keys` has those
/// of the rounded numbers, which decide the signs of the quaternions, and which keys have a turn.
template <class S>
void convert_rotation(const ExactRotation& exact, spline::Keys<S>& keys) {
  const auto& [columns, notation, relative, in_parent] = exact.rotation;
  spline::Quaternion<S> before{S(0), S(0), S(0), S(1)};
  for (std::size_t key = 0; key < exact.numbers.size(); ++key) {
    spline::RotationNumbers<S> numbers;
    std::ranges::transform(exact.numbers[key], numbers.begin(), [](const Rational& x) { return scalar_of<S>(x); });
    spline::Quaternion<S> q = spline::quaternion_from(numbers, notation);
    if (relative) {
      const std::size_t own = key % keys.size();  // the turn to a key that repeats the first one is the first one's
      if (key > 0 && columns.turn && numbers[3] != S(0)) {
        spline::TurnVector<S>& turn = keys.turns[own * keys.turns_per_key() + *columns.turn];
        const bool has_turn = turn != spline::TurnVector<S>{};
        if (has_turn) turn = spline::turn_vector_from(numbers, notation.degrees, before, in_parent);
      }
      q = before = spline::after_turn(before, q, in_parent);
    }
    const std::size_t first = key * keys.channels;
    if (key == keys.size() || keys.is_missing(key, columns.channels[0])) continue;
    std::array<S*, 4> rounded;
    std::ranges::transform(columns.channels, rounded.begin(),
                           [&](std::size_t i) { return &keys.positions[first + i]; });
    const auto& [x, y, z, w] = rounded;
    if (dot(q, {*x, *y, *z, *w}) < S(0)) q = -q;
    std::tie(*x, *y, *z, *w) = std::tie(q.x, q.y, q.z, q.w);
  }
}

template <class S>
spline::Keys<S> exact_keys(const ExactCurve& exact, std::vector<S> times) {
  spline::Keys<S> keys;
  keys.channels = exact.keys.channels;
  keys.given = exact.keys.given;
  keys.missing = exact.keys.missing;
  keys.times = std::move(times);
  const auto number = [](const Rational& value) { return scalar_of<S>(value); };
  keys.positions.reserve(exact.keys.positions.size());
  std::ranges::transform(exact.keys.positions, std::back_inserter(keys.positions), number);
  for (const auto& [tension, continuity, bias] : exact.keys.tcbs) {
    keys.tcbs.push_back({number(tension), number(continuity), number(bias)});
  }
  for (const auto& [in, out] : exact.keys.eases) keys.eases.push_back({number(in), number(out)});
  for (const auto& [in, out] : exact.keys.velocities) keys.velocities.push_back({number(in), number(out)});
  for (const auto& [x, y, z] : exact.keys.turns) keys.turns.push_back({number(x), number(y), number(z)});
  if constexpr (spline::has_roots<S>) {
    for (const ExactRotation& rotation : exact.converted) convert_rotation(rotation, keys);
  }
  return keys;
}

}  // namespace

template <class S>
std::unique_ptr<const spline::CurveKeys<S>> curve_at(const ExactCurve& exact) {
  auto [times, end] = exact_times<S>(exact);
  auto rules = spline::converted<S>(exact.rules, [](const Rational& value) { return scalar_of<S>(value); });
  return std::make_unique<const spline::CurveKeys<S>>(exact_keys<S>(exact, std::move(times)), std::move(rules), end,
                                                      spline::part<S>, exact.gaps);
}

template std::unique_ptr<const spline::CurveKeys<Rational>> curve_at(const ExactCurve& exact);
template std::unique_ptr<const spline::CurveKeys<Bounded>> curve_at(const ExactCurve& exact);
template std::unique_ptr<const spline::CurveKeys<spline::DoubleDouble>> curve_at(const ExactCurve& exact);
template std::unique_ptr<const spline::CurveKeys<ShortFloat>> curve_at(const ExactCurve& exact);
template std::unique_ptr<const spline::CurveKeys<LongFloat>> curve_at(const ExactCurve& exact);

template class spline::CurveKeys<Rational>;
template class spline::CurveKeys<Bounded>;
template class spline::CurveKeys<spline::DoubleDouble>;
template class spline::CurveKeys<ShortFloat>;
template class spline::CurveKeys<LongFloat>;

}  // namespace tcb
