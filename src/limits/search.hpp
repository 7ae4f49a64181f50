// Search: the maximum of a measure over pieces. A piece is divided where the maximum probably is, and each part again,
// until its bound is not above the best value that is attained, or nearer to it than reports show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "limits/pieces.hpp"

namespace tcb::limits {

/// A double-double times a power of two.
struct Scaled {
  spline::DoubleDouble value{};
  int exponent = 0;

  friend bool operator<(const Scaled& a, const Scaled& b) {
    if (a.exponent == b.exponent || !(a.value.hi * b.value.hi > 0)) return a.value < b.value;
    return ldexp(a.value, std::clamp(a.exponent - b.exponent, -900, 900)) < b.value;
  }
  Rational exact() const { return (Rational(value.hi) + Rational(value.lo)) * power_of_two(exponent); }
  double rough() const { return std::ldexp(value.hi, exponent); }
};

/// What may be above a value within what reports show.
inline Scaled slightly_above(const Scaled& x) { return {x.value + abs(x.value) * 0x1p-75, x.exponent}; }

template <class S>
std::pair<Form<S>, Form<S>> split(const Form<S>& form, const S& at) {
  std::pair<Form<S>, Form<S>> parts{form, form};
  std::tie(parts.first.over, parts.second.over) = split(form.over, at);
  for (const auto vectors : {&Form<S>::turning, &Form<S>::velocity}) {
    for (std::size_t i = 0; i < (form.*vectors).size(); ++i) {
      std::tie((parts.first.*vectors)[i], (parts.second.*vectors)[i]) = split((form.*vectors)[i], at);
    }
  }
  return parts;
}

/// The values of a form as bounded numbers times 2^exponent.
struct BoundedForm {
  Quotient<Bounded> values;
  int exponent;
  bool is_square;
};
template <class S>
BoundedForm bounded(const Form<S>& form) {
  Form<Bounded> result{.power = form.power, .is_square = form.is_square};
  const auto convert = [](const std::vector<Polynomial<S>>& from, std::vector<Polynomial<Bounded>>& to) {
    int unit = no_exponent;
    for (const Polynomial<S>& x : from) {
      for (const S& number : x) unit = std::max(unit, exponent_of(number));
    }
    if (unit == no_exponent) unit = 0;
    for (const Polynomial<S>& x : from) {
      to.emplace_back(x.size());
      std::ranges::transform(x, to.back().begin(), [unit](const S& number) { return scaled<Bounded>(number, unit); });
    }
    return unit;
  };
  std::vector<Polynomial<Bounded>> over;
  result.exponent = form.exponent - 2 * form.power * convert(form.velocity, result.velocity);
  if (form.turning.empty()) {
    result.exponent += convert({form.over}, over);
    result.over = over.front();
  } else {
    result.exponent += 2 * convert(form.turning, result.turning);
  }
  return {result.quotient(), result.exponent, result.is_square};
}

/// Where the largest value on [0, 1] probably is: where the derivative, if it is above 0 at first, falls below it.
inline double likely_place(const Quotient<Bounded>& form) {
  using Doubles = Polynomial<double>;
  const auto rough = [](const Polynomial<Bounded>& x) {
    Doubles result(x.size());
    std::ranges::transform(x, result.begin(), [](const Bounded& coefficient) { return coefficient.value.hi; });
    return result;
  };
  const Doubles over = rough(form.over), over_rate = derivative(over);
  const Doubles base = rough(form.base), base_rate = derivative(base);
  const auto slope = [&](double u) {
    if (form.power == 0) return value_at(over_rate, u);
    return value_at(over_rate, u) * value_at(base, u) - form.power * value_at(over, u) * value_at(base_rate, u);
  };
  if (!(slope(0) > 0)) return 0;
  if (slope(1) > 0) return 1;
  double low = 0;
  for (double size = 0.5; size >= 0x1p-48; size /= 2) low += slope(low + size) >= 0 ? size : 0;
  return low;
}

/// Where a piece is: the number of its segment, and its part of the ease.
struct PiecePlace {
  std::size_t segment;
  Part part;
};

/// Searches the maximum of one measure, piece after piece.
class Search {
 public:
  struct Attained {
    Scaled value;
    PiecePlace piece;
    Rational place;  ///< on the piece
  };
  std::optional<Attained> best;
  std::optional<Scaled> high;  ///< no larger value is on the pieces that are settled

  /// Whether a bound is not above the best value by what reports show.
  bool is_near(const Scaled& upper) const { return best && !(slightly_above(best->value) < upper); }

  void raise(const Scaled& upper) {
    if (!high || *high < upper) high = upper;
  }

  struct Bound {
    bool is_settled;
    std::optional<Scaled> upper = {};  ///< of a piece that is not settled; nothing where none is known
  };
  /// Searches a piece. It is not settled where that needs more digits.
  template <class S>
  Bound add(const Form<S>& form, const PiecePlace& piece) {
    const BoundedForm near = bounded(form);
    const Limits limits = bound_of(near);
    const Polynomial<Bounded>& base = near.values.base;
    if (form.power > 0 && (base.front().is_zero() || base.back().is_zero())) return {false};  // it may have no bound
    using Place = std::conditional_t<std::is_same_v<S, Rational>, Rational, spline::DoubleDouble>;
    attain(near, piece, false, Place(0.0));
    attain(near, piece, true, Place(1.0));
    std::vector<PartOf<S, Place>> parts{{limits, form, near.values, Place(0.0), Place(1.0)}};
    return {settle(std::move(parts), piece), limits.upper};
  }

 private:
  static Scaled upper(const Bounded& x, int exponent) { return {x.value + room(x), exponent}; }
  static Scaled lower(const Bounded& x, int exponent) { return {x.value + -room(x), exponent}; }
  static double room(const Bounded& x) { return x.error == 0 ? 0 : x.error + 0x1p-98 * std::abs(x.value.hi); }
  static bool is_known(const Bounded& x) { return std::isfinite(x.value.hi) && std::isfinite(x.error); }
  static const Rational& exact(const Rational& place) { return place; }
  static Rational exact(const spline::DoubleDouble& place) { return Rational(place.hi) + Rational(place.lo); }

  /// How long a split takes, in units of one of short numbers.
  static int work_of(const Form<Bounded>& /*form*/) { return 1; }
  static int work_of(const Form<Rational>& form) {
    unsigned bits = 0;
    for (const Rational& x : form.turning.empty() ? form.over : form.turning.front()) bits = std::max(bits, bits_of(x));
    const unsigned size = 1 + bits / 512;
    return static_cast<int>(size * size);
  }

  /// A bound, if one is known, and what the values of much smaller parts could have instead.
  struct Limits {
    std::optional<Scaled> upper = {};
    Scaled least = {};
  };
  /// A quotient is at most the largest of those of the coefficients.
  static Limits bound_of(const BoundedForm& form) {
    const auto& [over, base, power] = form.values;
    Polynomial<Bounded> x = over;
    if (power > 0) {
      const Polynomial<Bounded> below = of_degree(power_of(base, power), x.degree());
      x = of_degree(x, below.degree());
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (!is_above_zero(below[i])) return {};
        x[i] = x[i] / below[i];
      }
    }
    Limits largest;
    for (const Bounded& coefficient : x) {
      if (!is_known(coefficient)) return {};
      const Scaled one = upper(coefficient, form.exponent);
      if (largest.upper && !(*largest.upper < one)) continue;
      largest = {one, {coefficient.value + -16 * room(coefficient), form.exponent}};
    }
    return largest;
  }

  template <class Place>
  void attain(const BoundedForm& form, const PiecePlace& piece, bool last, const Place& place) {
    const auto& [over, base, power] = form.values;
    Bounded value = last ? over.back() : over.front();
    if (power > 0) value = value / power_of(last ? base.back() : base.front(), power);
    if (!is_known(value)) return;
    Scaled attained = lower(value, form.exponent);
    if (form.is_square && attained < Scaled()) attained = Scaled();
    if (!best || slightly_above(best->value) < attained) best = Attained{attained, piece, exact(place)};
  }

  /// A part of a piece that may have larger values than the best one. Those without a bound come before others.
  template <class S, class Place>
  struct PartOf : Limits {
    Form<S> form;
    Quotient<Bounded> values;
    Place begin, size;

    friend bool operator<(const PartOf& a, const PartOf& b) { return a.upper && (!b.upper || *a.upper < *b.upper); }
  };

  /// Divides the part with the largest bound until this is near the best value. Whether that needs no more digits.
  template <class S, class Place>
  bool settle(std::vector<PartOf<S, Place>> parts, const PiecePlace& piece) {
    constexpr bool is_exact = std::is_same_v<S, Rational>;
    for (int work = is_exact ? 4000 : 1000;;) {
      std::pop_heap(parts.begin(), parts.end());
      const PartOf<S, Place> part = std::move(parts.back());
      parts.pop_back();
      if (part.upper && is_near(*part.upper)) {
        raise(*part.upper);
        return true;
      }
      work -= work_of(part.form);
      if (work < 0 || (part.upper && !(best->value < part.least))) return false;
      double at = likely_place(part.values);
      if constexpr (is_exact) at = std::nearbyint(at * 0x1p12) * 0x1p-12;  // so that numbers stay short
      if (!(0 < at && at < 1)) at = 0.5;
      const Place first = part.size * Place(at), middle = part.begin + first;
      auto [left, right] = split(part.form, S(at));
      const BoundedForm before = bounded(left), after = bounded(right);
      attain(before, piece, true, middle);
      if (part.values.power > 0) {  // squares of bases may have been too small to divide by them
        attain(before, piece, false, part.begin);
        attain(after, piece, true, Place(part.begin + part.size));
      }
      const auto add = [&parts](Form<S>& form, const BoundedForm& near, const Place& begin, const Place& size) {
        parts.push_back({bound_of(near), std::move(form), near.values, begin, size});
        std::push_heap(parts.begin(), parts.end());
      };
      add(left, before, part.begin, first);
      add(right, after, middle, part.size - first);
    }
  }
};

}  // namespace tcb::limits
