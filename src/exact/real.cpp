// Real: floats whose precision is chosen while the program runs, by whole numbers of Boost.Multiprecision.
#include "exact/real.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "numbers/large_rational.hpp"

namespace tcb {
namespace {

thread_local int bits_in_use = 192;
thread_local bool last_in_use = false;

constexpr int digits = std::numeric_limits<double>::digits;

/// Whole numbers of up to 512 bits are held in place: products of the first precisions.
using Whole =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      512, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                      std::allocator<boost::multiprecision::limb_type>>,
                                  boost::multiprecision::et_off>;

constexpr int limb_bits = 64;
static_assert(sizeof(boost::multiprecision::limb_type) * 8 == limb_bits);

/// The bits of the size of a whole number. Requires: not 0.
std::int64_t width(const Whole& whole) {
  const auto& limbs = whole.backend();
  const std::uint64_t top = limbs.limbs()[limbs.size() - 1];
  return limb_bits * static_cast<std::int64_t>(limbs.size() - 1) + static_cast<std::int64_t>(std::bit_width(top));
}

/// A number of this width over 2^width, truncated to the digits of a double.
double leading(const Whole& whole, std::int64_t width) {
  const auto& limbs = whole.backend();
  const std::size_t size = limbs.size();
  const int free = static_cast<int>(-width & (limb_bits - 1));  // bits of the first limb
  std::uint64_t top = limbs.limbs()[size - 1] << free;
  if (free > 0 && size > 1) top |= limbs.limbs()[size - 2] >> (limb_bits - free);
  const double value = static_cast<double>(top >> (limb_bits - digits)) * 0x1p-53;
  return limbs.sign() ? -value : value;
}

/// Times a power of two, truncated.
Whole shifted(const Whole& whole, std::int64_t bits) {
  if (bits >= 0) return Whole(whole << static_cast<std::uint64_t>(bits));
  return whole < 0 ? Whole(-(Whole(-whole) >> static_cast<std::uint64_t>(-bits)))
                   : Whole(whole >> static_cast<std::uint64_t>(-bits));
}

/// The greatest whole number whose square is at most `square`, by Newton's steps with twice the digits each.
Whole whole_root(const Whole& square) {
  constexpr std::int64_t of_double = 100;
  const std::int64_t bits = width(square);
  if (bits <= of_double) {
    Whole root(std::sqrt(static_cast<double>(square)));
    while (root * root > square) --root;
    while ((root + 1) * (root + 1) <= square) ++root;
    return root;
  }
  const std::int64_t cut = bits / 4;  // digits of the root that the first half of the digits does not give
  Whole root = (whole_root(Whole(square >> static_cast<std::uint64_t>(2 * cut))) + 1)
               << static_cast<std::uint64_t>(cut);
  for (;;) {  // from above, each step is nearer and none is below
    const Whole next = (root + square / root) >> 1U;
    if (next >= root) return root;
    root = next;
  }
}

/// The arc tangent of 1/n, times 2^bits, to one unit for each of its terms.
Whole arc_tangent_of_inverse(int n, int bits) {
  Whole power = (Whole(1) << static_cast<unsigned>(bits)) / n, sum = power;
  for (int odd = 3; power != 0; odd += 2) {
    power /= n * n;
    const Whole term = power / odd;
    if (odd % 4 == 3) {
      sum -= term;
    } else {
      sum += term;
    }
  }
  return sum;
}

}  // namespace

struct Real::Number {
  Whole whole;
};

Real::Real() = default;
Real::Real(const Real&) = default;
Real::Real(Real&&) noexcept = default;
Real& Real::operator=(const Real&) = default;
Real& Real::operator=(Real&&) noexcept = default;
Real::~Real() = default;

RealPrecision::RealPrecision(int bits, bool is_last)
    : bits_before_(std::exchange(bits_in_use, bits)), last_before_(std::exchange(last_in_use, is_last)) {}
RealPrecision::~RealPrecision() {
  bits_in_use = bits_before_;
  last_in_use = last_before_;
}

int Real::bits() { return bits_in_use; }
bool Real::is_last() { return last_in_use; }

Real::Real(Number number, std::int64_t exponent) {
  if (number.whole == 0) return;
  const Whole& whole = number.whole;
  const std::int64_t bits = width(whole);
  leading_ = leading(whole, bits);
  exponent_ = exponent;
  size_ = exponent + bits;
  number_ = std::make_shared<const Number>(std::move(number));
}

Real::Real(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  *this = Real(Number{Whole(static_cast<std::int64_t>(std::ldexp(mantissa, 53)))}, exponent - 53);
}

/// Whole limbs are cut off, so that some digits more may stay.
Real::Result Real::rounded(Number number, std::int64_t exponent) {
  if (number.whole == 0) return {{}, true};
  const std::int64_t excess = (width(number.whole) - bits_in_use) / limb_bits * limb_bits;
  bool is_exact = true;
  if (excess > 0) {
    auto& limbs = number.whole.backend();
    const std::size_t cut = static_cast<std::size_t>(excess / limb_bits), left = limbs.size() - cut;
    is_exact = std::all_of(limbs.limbs(), limbs.limbs() + cut, [](std::uint64_t limb) { return limb == 0; });
    std::copy_n(limbs.limbs() + cut, left, limbs.limbs());
    limbs.resize(static_cast<unsigned>(left), static_cast<unsigned>(left));
    exponent += excess;
  }
  return {Real(std::move(number), exponent), is_exact};
}

Real::Result Real::sum(const Real& a, const Real& b) {
  if (a.is_zero()) return {b, true};
  if (b.is_zero()) return {a, true};
  const std::int64_t distance = a.exponent() - b.exponent();
  if (std::abs(distance) > 2 * std::int64_t{bits_in_use} + 8) return {distance > 0 ? a : b, false};
  const bool a_is_finer = a.exponent_ < b.exponent_;
  const Real &fine = a_is_finer ? a : b, &coarse = a_is_finer ? b : a;
  const std::int64_t shift = coarse.exponent_ - fine.exponent_;
  if (shift == 0) return rounded({Whole(coarse.number_->whole + fine.number_->whole)}, fine.exponent_);
  return rounded({Whole(shifted(coarse.number_->whole, shift) + fine.number_->whole)}, fine.exponent_);
}

Real::Result Real::product(const Real& a, const Real& b) {
  if (a.is_zero() || b.is_zero()) return {{}, true};
  return rounded({Whole(a.number_->whole * b.number_->whole)}, a.exponent_ + b.exponent_);
}

Real::Result Real::quotient(const Real& a, const Real& b) {
  if (a.is_zero()) return {{}, true};
  const Whole &n = a.number_->whole, &d = b.number_->whole;
  const std::int64_t shift = std::max<std::int64_t>(0, bits_in_use + 2 - width(n) + width(d));
  Whole whole, rest;
  divide_qr(shifted(n, shift), d, whole, rest);
  Result result = rounded({std::move(whole)}, a.exponent_ - b.exponent_ - shift);
  result.is_exact = result.is_exact && rest == 0;
  return result;
}

Real::Result Real::root(const Real& a) {
  if (a.is_zero()) return {{}, true};
  std::int64_t shift = std::max<std::int64_t>(0, 2 * (std::int64_t{bits_in_use} + 1) - width(a.number_->whole));
  if (((a.exponent_ - shift) & 1) != 0) ++shift;
  const Whole square = shifted(a.number_->whole, shift);
  Whole whole = whole_root(square);
  const bool is_exact = whole * whole == square;
  Result result = rounded({std::move(whole)}, (a.exponent_ - shift) / 2);
  result.is_exact = result.is_exact && is_exact;
  return result;
}

Real::Result Real::nearest(const Rational& value) {
  const Rational divisor = denominator(value);
  Whole whole(integer(numerator(value)));
  if (divisor == 1) return rounded({std::move(whole)}, 0);
  return quotient(Real(Number{std::move(whole)}, 0), Real(Number{Whole(integer(divisor))}, 0));
}

Real operator-(const Real& a) { return a.is_zero() ? a : Real(Real::Number{Whole(-a.number_->whole)}, a.exponent_); }
Real operator+(const Real& a, const Real& b) { return Real::sum(a, b).value; }
Real operator-(const Real& a, const Real& b) { return Real::sum(a, -b).value; }
Real operator*(const Real& a, const Real& b) { return Real::product(a, b).value; }
Real operator/(const Real& a, const Real& b) { return Real::quotient(a, b).value; }
Real sqrt(const Real& a) { return Real::root(a).value; }
Real ldexp(const Real& a, std::int64_t exponent) {
  Real result = a;
  if (!a.is_zero()) {
    result.exponent_ += exponent;
    result.size_ += exponent;
  }
  return result;
}

std::strong_ordering operator<=>(const Real& a, const Real& b) {
  const auto sign = [](const Real& x) { return x.leading_ < 0 ? -1 : x.leading_ > 0 ? 1 : 0; };
  const int sign_a = sign(a), sign_b = sign(b);
  if (sign_a != sign_b || sign_a == 0) return sign_a <=> sign_b;
  if (a.size_ != b.size_) return sign_a * (a.size_ < b.size_ ? -1 : 1) <=> 0;
  if (a.leading_ != b.leading_)
    return a.leading_ < b.leading_ ? std::strong_ordering::less : std::strong_ordering::greater;
  const std::int64_t low = std::min(a.exponent_, b.exponent_);
  return shifted(a.number_->whole, a.exponent_ - low).compare(shifted(b.number_->whole, b.exponent_ - low)) <=> 0;
}

Real Real::floor() const {
  if (is_zero() || exponent_ >= 0) return *this;
  const Whole whole = shifted(number_->whole, exponent_);  // towards 0
  const bool is_below = number_->whole < 0 && shifted(whole, -exponent_) != number_->whole;
  return Real(Number{is_below ? Whole(whole - 1) : whole}, 0);
}

Rational Real::rational() const {
  if (is_zero()) return 0;
  if (exponent_ >= 0) return tcb::rational(Integer(shifted(number_->whole, exponent_)));
  return ratio(Integer(number_->whole), Integer(shifted(1, -exponent_)));
}

Real Real::pi() {
  thread_local std::map<int, Real> known;
  Real& pi = known[bits_in_use];
  if (!pi.is_zero()) return pi;
  constexpr int guard = 32;
  const int bits = bits_in_use + guard;
  const Whole quarter = 4 * arc_tangent_of_inverse(5, bits) - arc_tangent_of_inverse(239, bits);
  return pi = rounded({Whole(4 * quarter)}, -bits).value;
}

}  // namespace tcb
