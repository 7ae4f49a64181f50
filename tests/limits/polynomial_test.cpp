// Polynomials: arithmetic at fractions, and Bernstein's form.
#include "limits/polynomial.hpp"

#include <gmock/gmock.h>

#include "numbers/rational.hpp"

namespace tcb::limits {
namespace {

using testing::ElementsAre;
using P = Polynomial<Rational>;

TEST(Polynomial, an_inner_polynomial_takes_the_place_of_x) {
  EXPECT_THAT(composed(P{1, 2, 3}, P{4, 5}), ElementsAre(57, 130, 75));
}

TEST(Polynomial, the_common_divisor_has_the_common_roots) {
  const P common = common_divisor(P{2, -3, 1}, P{3, -4, 1});  // roots 1 and 2, 1 and 3
  EXPECT_EQ(common.size(), 2U);
  EXPECT_EQ(value_at(common, Rational(1)), 0);
  EXPECT_EQ(common_divisor(P{2, -3, 1}, P{12, -7, 1}).size(), 1U);
  EXPECT_THAT(common_divisor(P{0}, P{2, 1, 0}), ElementsAre(2, 1));
}

TEST(Polynomial, bernsteins_form_of_any_degree) {
  EXPECT_THAT(bernstein(P{0, 0, 1}, 2), ElementsAre(0, 0, 1));
  EXPECT_THAT(bernstein(P{0, 0, 1}, 3), ElementsAre(0, 0, Rational(1) / 3, 1));
}

TEST(Polynomial, bernsteins_form_is_converted_back) {
  EXPECT_THAT(from_bernstein(bernstein(P{1, -2, 3, 5}, 3)), ElementsAre(1, -2, 3, 5));
}

TEST(Polynomial, forms_with_binomials_multiply) {
  const P x = with_binomials(P{0, 0, 1}), y = with_binomials(P{1, 0});  // x^2 (1 - x)
  EXPECT_THAT(product(x, y), ElementsAre(0, 0, 1, 0));
}

TEST(Polynomial, parts_have_forms_of_their_own) {
  const auto [left, right] = split(P{0, 0, 1}, Rational(1) / 3);
  EXPECT_THAT(left, ElementsAre(0, 0, Rational(1) / 9));
  EXPECT_THAT(right, ElementsAre(Rational(1) / 9, Rational(1) / 3, 1));
}

}  // namespace
}  // namespace tcb::limits
