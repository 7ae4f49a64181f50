// Pieces: three forms of a cubic, whole and cut, for doubles and for exact rationals.
#include "sample/fields.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact/rounding.hpp"

namespace tcb {
namespace {

template <class S>
using Form = std::array<S, 4>;

/// From P = 2 at t = 1 to P = -1 at t = 3, with the local tangents 1/2 and 5/2:
/// X = 2 + u/2 - 25/2 u^2 + 9 u^3 = -1 + 5/2 w + 29/2 w^2 + 9 w^3, u = (t - 1)/2, w = u - 1.
template <class S>
struct Example {
  std::array<spline::Cubic<S>, 1> cubics{
      spline::cubic<S>(S(2), S(-1), spline::working_t<S>(S(1) / S(2)), spline::working_t<S>(S(5) / S(2)))};
  CurveSegmentOf<S> segment{S(1), S(3), S(0), S(0), cubics, {}};
  SampleOf<S> first, last;
  Point<S> point;

  Example(const S& from, const S& to) : first(at(from)), last(at(to)) {
    point.set(segment);
    point.set(first, nullptr);
    point.set_end(&last);
  }
  SampleOf<S> at(const S& t) const { return {t, spline::TimeMap<S>(segment.start, segment.end)(t)}; }
};

template <class S>
Form<S> form(CubicForm<S> form, const Point<S>& point) {
  return form(piece_cubic(point, 0), spline::elapsed<S>(piece_start(point), piece_end(point)));
}

/// All numbers below are binary fractions of few bits, so doubles have them exactly.
template <class S>
void expect_forms() {
  const auto number = [](int numerator, int denominator) { return S(numerator) / S(denominator); };
  const Example<S> whole(S(1), S(3));
  EXPECT_EQ(form<S>(hermite_form<S>, whole.point), (Form<S>{S(2), number(1, 4), S(-1), number(5, 4)}));
  EXPECT_EQ(form<S>(polynomial_form<S>, whole.point), (Form<S>{S(2), number(1, 4), number(-25, 8), number(9, 8)}));
  EXPECT_EQ(piece_duration(whole.point), S(2));
  // X(1.5) = 2 + 1/8 - 25/32 + 9/64 with u = 1/4; X' = 1/4 - 25/8 + 27/32; X''/2 = -25/8 + 27/16.
  // X(2.5) with u = 3/4; X' = 1/4 - 75/8 + 243/32.
  const Example<S> part(number(3, 2), number(5, 2));
  const Form<S> hermite{number(95, 64), number(-65, 32), number(-55, 64), number(-49, 32)};
  EXPECT_EQ(form<S>(hermite_form<S>, part.point), hermite);
  EXPECT_EQ(form<S>(polynomial_form<S>, part.point), (Form<S>{hermite[0], hermite[1], number(-23, 16), number(9, 8)}));
  EXPECT_EQ(piece_duration(part.point), S(1));
  const Example<S> end(number(5, 2), S(3));
  EXPECT_EQ(form<S>(polynomial_form<S>, end.point), (Form<S>{hermite[2], hermite[3], number(31, 16), number(9, 8)}));
}

TEST(Pieces, forms_are_exact_for_rationals) { expect_forms<Rational>(); }
TEST(Pieces, forms_of_few_bits_are_exact_for_doubles) { expect_forms<double>(); }

TEST(Pieces, handles_are_a_third_of_the_velocity_away) {
  const auto number = [](int numerator, int denominator) { return Rational(numerator, denominator); };
  const Example<Rational> whole(1, 3);
  EXPECT_EQ(form<Rational>(bezier_form<Rational>, whole.point), (Form<Rational>{2, number(13, 6), number(-11, 6), -1}));
  const Example<Rational> part(number(3, 2), number(5, 2));
  const Form<Rational> handles = form<Rational>(bezier_form<Rational>, part.point);
  EXPECT_EQ(handles[1], number(95, 64) - number(65, 96));
  EXPECT_EQ(handles[2], number(-55, 64) + number(49, 96));
  const Example<double> doubles(1, 3);
  EXPECT_EQ(form<double>(bezier_form<double>, doubles.point), (Form<double>{2, 13.0 / 6, -11.0 / 6, -1}));
}

TEST(Pieces, a_length_is_that_of_the_part) {
  const std::array cubics{spline::cubic<double>(0, 4, 4, 4), spline::cubic<double>(1, 4, 3, 3)};
  const CurveSegment segment{0.0, 2.0, 0.0, 0.0, cubics, {}};
  const spline::TimeMap<double> at(segment.start, segment.end);
  const Sample first{0.5, at(0.5)}, start{0.0, at(0.0)}, last{2.0, at(2.0)};
  Point<double> point;
  point.set(segment);
  point.set(start, nullptr);
  point.set_end(&last);
  EXPECT_EQ(piece_length(point), 5);
  point.set(first, nullptr);
  EXPECT_EQ(piece_length(point), 3.75);
}

TEST(Pieces, a_duration_is_the_exact_difference_of_the_times) {
  const std::array cubics{spline::cubic<double>(0, 1, 1, 1)};
  const auto duration = [&](const Time& start, const Time& end) {
    const CurveSegment segment{start, end, 0.0, 0.0, cubics, {}};
    const Sample first = sample_at_key(segment, false), last = sample_at_key(segment, true);
    Point<double> point;
    point.set(segment);
    point.set(first, nullptr);
    point.set_end(&last);
    return piece_duration(point);
  };
  const auto decimal = [](const char* text) { return *parse_long_time(text, std::stod(text)); };
  EXPECT_EQ(duration(0.1, 0.3), 0.3 - 0.1);
  EXPECT_EQ(duration({1731931200000000000, 0}, {1731931200000000000, 7}), 7);
  EXPECT_EQ(duration(decimal("1731931200.123456789"), decimal("1731931200.123456790")), 1e-9);
}

TEST(Pieces, a_zero_is_not_negative) {
  const std::array cubics{spline::cubic<double>(1, 1, -0.0, -0.0)};
  const CurveSegment segment{0.0, 1.0, 0.0, 0.0, cubics, {}};
  const Sample first = sample_at_key(segment, false), last = sample_at_key(segment, true);
  Point<double> point;
  point.set(segment);
  point.set(first, nullptr);
  point.set_end(&last);
  for (const double number : form<double>(hermite_form<double>, point)) EXPECT_FALSE(std::signbit(number));
  for (const double number : form<double>(polynomial_form<double>, point)) EXPECT_FALSE(std::signbit(number));
}

}  // namespace
}  // namespace tcb
