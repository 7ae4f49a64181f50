// Search: the maximum of a measure over pieces. A piece is divided where the maximum probably is, and each part again,
// until its bound is not far above the best value that is attained, or below it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/rounding.hpp"
#include "limits/form.hpp"

namespace tcb::limits {

/// The simplest fraction between two numbers.
inline Rational simplest_within(const Rational& low, const Rational& high) {
  if (low > 0) return simplest_between(low, high);
  return high < 0 ? -simplest_between(-high, -low) : Rational(0);
}

/// The number within [low, high], if there is one that is far simpler than in other such intervals.
inline std::optional<Rational> simple_number(const Rational& low, const Rational& high) {
  const Rational simplest = simplest_within(low, high), size = denominator(simplest);
  return size * size * (high - low) <= Rational(0x1p-20) ? std::optional(simplest) : std::nullopt;
}

/// Whether a number is the maximum of a concave polynomial, at a place that may be irrational: there the polynomial
/// less the maximum has a double root.
inline bool is_maximum(const Polynomial<Rational>& x, const Rational& number) {
  const Polynomial<Rational> root = common_divisor(sum(x, {number}, Rational(-1)), derivative(x));
  return value_at(root, Rational(0)) * value_at(root, Rational(1)) <= 0;
}

inline bool is_concave(const Polynomial<Rational>& x) {
  const Polynomial<Rational> bend = derivative(derivative(x));
  return std::ranges::max(bernstein(bend, bend.size() - 1)) < 0;
}

/// A place near another one where a polynomial in Bernstein's form is largest on the part [begin, begin + size] of a
/// piece: at the simplest fraction of the piece, or better by a step of Newton's method.
inline Rational better_place(const Polynomial<Rational>& form, const Rational& near_place, const Rational& begin,
                             const Rational& size) {
  const Polynomial<Rational> rate = derivative(from_bernstein(form));
  const auto is_inside = [](const Rational& u) { return 0 <= u && u <= 1; };
  const Rational fraction = begin + near_place * size, near = std::min(Rational(0x1p-36), size / 4);
  const Rational simplest = fraction <= near ? Rational(0) : simplest_between(fraction - near, fraction + near);
  const Rational simple = (simplest - begin) / size;
  if (is_inside(simple) && value_at(rate, simple) == 0) return simple;
  const Rational bend = value_at(derivative(rate), near_place);
  if (bend == 0) return near_place;
  const Rational step = -value_at(rate, near_place) / bend;
  const bool is_quadratic = form.size() == 3;
  const Rational better = near_place + (is_quadratic ? step : Rational(nearest_double(step)));
  return is_inside(better) ? better : near_place;
}

/// Where a piece is: the numbers of its segment, and of its part of the ease.
struct Place {
  std::size_t segment, piece;
};

/// Searches the maximum of one measure by parts of pieces. Number: in which values are compared. Rationals find it, and
/// others the segments that may hold it.
template <class Number>
class Search {
 public:
  struct Attained {
    Number value;
    Place piece;
    Number place;  ///< on the piece
  };
  std::optional<Attained> best;

  /// How often parts are halved, and whether a bound that is then far from what is attained is taken, or Undecided.
  struct Depth {
    int deepest = 40;
    bool takes_far_bounds = true;
  };

  /// A bound on a piece; nothing where none is known. `attains`: the piece certainly exists. Throws: Undecided.
  template <class S>
  std::optional<Number> bound(const Form<S>& form, const Place& piece, const Depth& depth, bool attains = true) {
    piece_ = piece;
    depth_ = depth;
    splits_ = 0;
    const auto whole = bound_of<Number>(form);
    if (!attains) return whole.upper;
    attain(value_at_end<Number>(form, false), Number(0));
    attain(value_at_end<Number>(form, true), Number(1));
    return bound_part(form, whole, Number(0), Number(1), 0);
  }

  struct Part {
    std::size_t segment;
    std::optional<Number> upper;  ///< nothing: no bound is known
  };
  /// Adds a segment, the next one, to those that may hold the maximum.
  void add(std::size_t segment, const std::optional<Number>& upper) {
    if (is_below(upper)) return;
    parts_.push_back({segment, upper});
    if (parts_.size() >= 2 * kept_ + 64) kept_ = rest().size();
  }
  /// The segments that may hold the maximum.
  const std::vector<Part>& rest() {
    std::erase_if(parts_, [this](const Part& part) { return is_below(part.upper); });
    return parts_;
  }
  /// Whether a bound is below a value that is attained.
  bool is_below(const std::optional<Number>& upper) const { return upper && best && *upper < best->value; }

 private:
  static constexpr bool is_exact = std::is_same_v<Number, Rational>;

  void attain(const std::optional<Number>& value, const Number& place) {
    if (value && (!best || best->value < *value)) best = Attained{*value, piece_, place};
  }

  /// Bounds the part [begin, begin + size] of a piece. `whole`: what bound_of() has for it.
  template <class S>
  std::optional<Number> bound_part(const Form<S>& form, const Bound<Number>& whole, const Number& begin,
                                   const Number& size, int depth) {
    if (whole.upper && !(best->value < *whole.upper)) return whole.upper;
    Number at(likely_place(form));
    const bool is_inside = Number(0) < at && at < Number(1);
    if constexpr (std::is_same_v<S, Rational>) {
      if (is_inside) at = better_place(form.over, at, begin, size);
    }
    std::pair<Form<S>, Form<S>> parts;
    Bound<Number> before, after;
    const auto split_at = [&](const Number& place) {
      parts = split(form, scalar<S>(place));
      before = bound_of<Number>(parts.first);
      after = bound_of<Number>(parts.second);
      attain(value_at_end<Number>(parts.first, true), begin + place * size);
    };
    if (is_inside) split_at(at);
    const auto larger = [](const std::optional<Number>& x, const std::optional<Number>& y) {
      return x && y ? std::max(x, y) : std::nullopt;
    };
    std::optional<Number> upper = is_inside ? larger(before.upper, after.upper) : whole.upper;
    if (upper) {
      if (!(best->value < *upper)) return upper;
      const bool is_narrow = !(std::max(whole.doubt, before.doubt) < *upper - best->value);
      if (is_narrow || (depth == depth_.deepest && depth_.takes_far_bounds)) {
        if constexpr (std::is_same_v<S, Rational>) {
          const auto exact = is_inside ? simple_number(parts.first.over.back(), *upper) : std::nullopt;
          const Polynomial<Rational> x = exact ? from_bernstein(form.over) : Polynomial<Rational>{0};
          if (exact && !is_concave(x) && depth < 40) {  // a smaller part is
            split_at(Rational(1) / 2);
            return larger(bound_part(parts.first, before, begin, size / 2, depth + 1),
                          bound_part(parts.second, after, begin + size / 2, size / 2, depth + 1));
          }
          if (exact && is_maximum(x, *exact)) attain(upper = exact, begin + at * size);
        } else if constexpr (is_exact && std::is_same_v<S, Ball>) {
          throw Undecided();  // its results are never exact: it only shows that a part has no larger values
        }
        return upper;
      }
    }
    constexpr int deepest_without_bound = 10, most_splits = is_exact ? 2'000 : 1'000;
    const bool is_last_split = ++splits_ > most_splits;
    if (!is_exact && (is_last_split || (!upper && depth == deepest_without_bound))) return upper;
    if (is_last_split || depth == depth_.deepest) throw Undecided();
    if (!is_inside) {
      at = Number(0.5);
      split_at(at);
    }
    const auto left = bound_part(parts.first, before, begin, at * size, depth + 1);
    return left ? larger(left, bound_part(parts.second, after, begin + at * size, size - at * size, depth + 1)) : left;
  }
  template <class S>
  static S scalar(const Number& x) {
    if constexpr (is_exact) {
      return scalar_of<S>(x);
    } else {
      return S(x);
    }
  }

  Place piece_ = {};
  Depth depth_;
  int splits_ = 0;
  std::vector<Part> parts_;
  std::size_t kept_ = 0;
};

}  // namespace tcb::limits
