// Pairs: two doubles that go through the same operations side by side, each as if alone.
//
// Most operations take a processor no longer for both than for one. Written with the vector types of GCC and Clang.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tcb::spline {

class Pair {
 public:
  Pair() = default;
  Pair(double both) : of_{both, both} {}  // NOLINT(google-explicit-constructor): a number goes with both
  Pair(double first, double second) : of_{first, second} {}

  double operator[](std::size_t i) const { return of_[i]; }

  friend Pair upper_half(const Pair& a) { return Pair(Vector(Bits(a.of_) & 0xFFFF'FFFF'F800'0000)); }

  friend Pair operator-(const Pair& a) { return Pair(-a.of_); }
  friend Pair operator+(const Pair& a, const Pair& b) { return Pair(a.of_ + b.of_); }
  friend Pair operator-(const Pair& a, const Pair& b) { return Pair(a.of_ - b.of_); }
  friend Pair operator*(const Pair& a, const Pair& b) { return Pair(a.of_ * b.of_); }
  friend Pair operator/(const Pair& a, const Pair& b) { return Pair(a.of_ / b.of_); }
  friend Pair abs(const Pair& a) { return Pair(a.of_ < Vector{} ? -a.of_ : a.of_); }
  friend Pair sqrt(const Pair& a) { return {std::sqrt(a.of_[0]), std::sqrt(a.of_[1])}; }
  friend Pair min(const Pair& a, const Pair& b) { return Pair(b.of_ < a.of_ ? b.of_ : a.of_); }
  friend Pair max(const Pair& a, const Pair& b) { return Pair(a.of_ < b.of_ ? b.of_ : a.of_); }

  /// yes where a > 0, else no.
  friend Pair if_positive(const Pair& a, const Pair& yes, const Pair& no) {
    return Pair(a.of_ > Vector{} ? yes.of_ : no.of_);
  }

 private:
  using Vector = double __attribute__((vector_size(2 * sizeof(double))));
  using Bits = std::uint64_t __attribute__((vector_size(2 * sizeof(double))));
  explicit Pair(Vector of) : of_(of) {}

  Vector of_;
};

/// The same of one number.
template <class S>
S if_positive(const S& a, const S& yes, const S& no) {
  return a > S(0) ? yes : no;
}

}  // namespace tcb::spline
