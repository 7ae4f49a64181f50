// Double pair: two doubles, or double-doubles, in the same operations; each result is the same as for one alone.
//
// Most operations take no longer for two doubles than for one. With GCC and Clang the two are a vector, which
// their optimizers do not make of two doubles; elsewhere, or where TCB_SPLINE_PLAIN_PAIRS is defined, they are two
// doubles.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "tcb/spline/double_double.hpp"

namespace tcb::spline {

#if defined(__GNUC__) && !defined(TCB_SPLINE_PLAIN_PAIRS)
using TwoDoubles = double __attribute__((vector_size(2 * sizeof(double))));
using TwoMasks = std::uint64_t __attribute__((vector_size(2 * sizeof(double))));

/// For each of the two: yes if a < b, else no.
inline TwoDoubles if_less(TwoDoubles a, TwoDoubles b, TwoDoubles yes, TwoDoubles no) { return a < b ? yes : no; }
inline TwoDoubles upper_half(TwoDoubles a) { return TwoDoubles(TwoMasks(a) & upper_half_mask); }
#else
struct TwoDoubles {
  double of[2];

  double operator[](std::size_t i) const { return of[i]; }
  friend TwoDoubles operator-(TwoDoubles a) { return {{-a[0], -a[1]}}; }
  friend TwoDoubles operator+(TwoDoubles a, TwoDoubles b) { return {{a[0] + b[0], a[1] + b[1]}}; }
  friend TwoDoubles operator-(TwoDoubles a, TwoDoubles b) { return {{a[0] - b[0], a[1] - b[1]}}; }
  friend TwoDoubles operator*(TwoDoubles a, TwoDoubles b) { return {{a[0] * b[0], a[1] * b[1]}}; }
  friend TwoDoubles operator/(TwoDoubles a, TwoDoubles b) { return {{a[0] / b[0], a[1] / b[1]}}; }
};

inline TwoDoubles if_less(TwoDoubles a, TwoDoubles b, TwoDoubles yes, TwoDoubles no) {
  return {{a[0] < b[0] ? yes[0] : no[0], a[1] < b[1] ? yes[1] : no[1]}};
}
inline TwoDoubles upper_half(TwoDoubles a) { return {{upper_half(a[0]), upper_half(a[1])}}; }
#endif

class DoublePair {
 public:
  DoublePair() = default;
  DoublePair(double both) : of_{both, both} {}  // NOLINT(google-explicit-constructor): a number used for both
  DoublePair(double first, double second) : of_{first, second} {}

  double operator[](std::size_t i) const { return of_[i]; }

  friend DoublePair upper_half(const DoublePair& a) { return DoublePair(spline::upper_half(a.of_)); }

  friend DoublePair operator-(const DoublePair& a) { return DoublePair(-a.of_); }
  friend DoublePair operator+(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ + b.of_); }
  friend DoublePair operator-(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ - b.of_); }
  friend DoublePair operator*(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ * b.of_); }
  friend DoublePair operator/(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ / b.of_); }
  friend DoublePair abs(const DoublePair& a) { return DoublePair(if_less(a.of_, TwoDoubles{}, -a.of_, a.of_)); }
  friend DoublePair sqrt(const DoublePair& a) { return {std::sqrt(a.of_[0]), std::sqrt(a.of_[1])}; }
  friend DoublePair min(const DoublePair& a, const DoublePair& b) {
    return DoublePair(if_less(b.of_, a.of_, b.of_, a.of_));
  }
  friend DoublePair max(const DoublePair& a, const DoublePair& b) {
    return DoublePair(if_less(a.of_, b.of_, b.of_, a.of_));
  }

  /// yes if a > 0, else no.
  friend DoublePair if_positive(const DoublePair& a, const DoublePair& yes, const DoublePair& no) {
    return DoublePair(if_less(TwoDoubles{}, a.of_, yes.of_, no.of_));
  }

 private:
  explicit DoublePair(TwoDoubles of) : of_(of) {}

  TwoDoubles of_;
};

/// yes if a > 0, else no, for one number.
template <class S>
S if_positive(const S& a, const S& yes, const S& no) {
  return a > S(0) ? yes : no;
}

/// Two double-doubles.
using DoubleDoublePair = DoubleDoubleOf<DoublePair>;

inline DoubleDoublePair sqrt(const DoubleDoublePair& value) {
  const DoublePair root = sqrt(value.hi);
  const DoubleDoublePair remainder = value - DoubleDoublePair(root) * DoubleDoublePair(root);
  return DoubleDoublePair::normalized(root, if_positive(root, remainder.hi / (2 * root), 0.0));
}

template <class S>
inline constexpr bool has_pairs = std::is_same_v<S, double> || std::is_same_v<S, DoubleDouble>;

inline DoublePair pair_of(double first, double second) { return {first, second}; }
inline DoubleDoublePair pair_of(const DoubleDouble& first, const DoubleDouble& second) {
  return {{first.hi, second.hi}, {first.lo, second.lo}};
}
inline double one_of(const DoublePair& pair, std::size_t i) { return pair[i]; }
inline DoubleDouble one_of(const DoubleDoublePair& pair, std::size_t i) { return {pair.hi[i], pair.lo[i]}; }

/// A number by its first double.
template <class D>
const D& rough(const D& number) {
  return number;
}
template <class D>
const D& rough(const DoubleDoubleOf<D>& number) {
  return number.hi;
}

}  // namespace tcb::spline
