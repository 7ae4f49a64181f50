// Pairs: two doubles that go through the same operations side by side, each as if alone.
//
// Most operations take a processor no longer for both than for one. Written with the vector types of GCC and Clang.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tcb::spline {

class DoublePair {
 public:
  DoublePair() = default;
  DoublePair(double both) : of_{both, both} {}  // NOLINT(google-explicit-constructor): a number goes with both
  DoublePair(double first, double second) : of_{first, second} {}

  double operator[](std::size_t i) const { return of_[i]; }

  friend DoublePair upper_half(const DoublePair& a) { return DoublePair(Vector(Bits(a.of_) & 0xFFFF'FFFF'F800'0000)); }

  friend DoublePair operator-(const DoublePair& a) { return DoublePair(-a.of_); }
  friend DoublePair operator+(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ + b.of_); }
  friend DoublePair operator-(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ - b.of_); }
  friend DoublePair operator*(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ * b.of_); }
  friend DoublePair operator/(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ / b.of_); }
  friend DoublePair abs(const DoublePair& a) { return DoublePair(a.of_ < Vector{} ? -a.of_ : a.of_); }
  friend DoublePair sqrt(const DoublePair& a) { return {std::sqrt(a.of_[0]), std::sqrt(a.of_[1])}; }
  friend DoublePair min(const DoublePair& a, const DoublePair& b) { return DoublePair(b.of_ < a.of_ ? b.of_ : a.of_); }
  friend DoublePair max(const DoublePair& a, const DoublePair& b) { return DoublePair(a.of_ < b.of_ ? b.of_ : a.of_); }

  /// yes where a > 0, else no.
  friend DoublePair if_positive(const DoublePair& a, const DoublePair& yes, const DoublePair& no) {
    return DoublePair(a.of_ > Vector{} ? yes.of_ : no.of_);
  }

 private:
  using Vector = double __attribute__((vector_size(2 * sizeof(double))));
  using Bits = std::uint64_t __attribute__((vector_size(2 * sizeof(double))));
  explicit DoublePair(Vector of) : of_(of) {}

  Vector of_;
};

/// The same of one number.
template <class S>
S if_positive(const S& a, const S& yes, const S& no) {
  return a > S(0) ? yes : no;
}

}  // namespace tcb::spline
