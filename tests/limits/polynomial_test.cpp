// Polynomials: arithmetic at fractions in Bernstein's form.
#include "limits/polynomial.hpp"

#include <gmock/gmock.h>

#include "numbers/rational.hpp"

namespace tcb::limits {
namespace {

using testing::ElementsAre;
using P = Polynomial<Rational>;

const P line{0, 1}, square{0, 0, 1};  // x, x^2

TEST(Polynomial, products_and_sums_have_the_degree_that_they_need) {
  EXPECT_THAT(product(line, line), ElementsAre(0, 0, 1));
  EXPECT_THAT(product(square, P{1, 0}), ElementsAre(0, 0, Rational(1) / 3, 0));  // x^2 (1 - x)
  EXPECT_THAT(sum(square, line, Rational(2)), ElementsAre(0, 1, 3));
  EXPECT_THAT(sum(P{5}, square), ElementsAre(5, 5, 6));
  EXPECT_THAT(of_degree(square, 3), ElementsAre(0, 0, Rational(1) / 3, 1));
  EXPECT_THAT(power_of(line, 3), ElementsAre(0, 0, 0, 1));
}

TEST(Polynomial, a_derivative_has_one_degree_less) {
  EXPECT_THAT(derivative(square), ElementsAre(0, 2));
  EXPECT_THAT(derivative(P{7}), ElementsAre(0));
}

TEST(Polynomial, an_inner_polynomial_takes_the_place_of_x) {
  EXPECT_THAT(composed(square, square), ElementsAre(0, 0, 0, 0, 1));
  EXPECT_THAT(composed(square, P{4, 9}), ElementsAre(16, 36, 81));  // (4 + 5x)^2
}

TEST(Polynomial, parts_have_forms_of_their_own) {
  const auto [left, right] = split(square, Rational(1) / 3);
  EXPECT_THAT(left, ElementsAre(0, 0, Rational(1) / 9));
  EXPECT_THAT(right, ElementsAre(Rational(1) / 9, Rational(1) / 3, 1));
  EXPECT_EQ(value_at(square, Rational(1) / 3), Rational(1) / 9);
}

}  // namespace
}  // namespace tcb::limits
