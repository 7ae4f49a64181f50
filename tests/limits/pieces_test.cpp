// Pieces: the parts of an ease, and squares of what is measured on them.
#include "limits/pieces.hpp"

#include <gmock/gmock.h>

namespace tcb::limits {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// One segment from time 0 to 2 along the polynomials a + b u + c u^2, one for each channel.
spline::Segments<Rational> segment_of(const std::vector<std::vector<Rational>>& channels,
                                      spline::Warp<Rational> warp = {}) {
  spline::Segments<Rational> segment{channels.size(), {0, 2}, {}, {warp}};
  for (const auto& x : channels) {
    segment.cubics.push_back(spline::cubic<Rational>(x[0], x[0] + x[1] + x[2], x[1], x[1] + 2 * x[2]));
  }
  return segment;
}

std::vector<Piece<Rational>> all_pieces(const spline::Segments<Rational>& segment) {
  return pieces_of<Rational>(segment, 0, 0, 1);
}

Quotient<Rational> measured(const Piece<Rational>& piece, const Measure& measure) {
  return form_of<Rational>(piece, measure).quotient();
}

TEST(Pieces, an_ease_has_three_parts_that_meet_with_one_rate) {
  const Rational f = Rational(3) / 10, e = Rational(1) / 5;
  const auto segment = segment_of({{0, 1, 0}}, {f, e});
  const auto pieces = all_pieces(segment);
  ASSERT_THAT(pieces, SizeIs(3));
  EXPECT_EQ(pieces[0].duration, 2 * f);
  EXPECT_EQ(pieces[2].begin, 1 - e);
  EXPECT_EQ(value_at(pieces[0].parameter, Rational(1) / 3), Rational(1) / 45);  // at 1/10 of the duration
  EXPECT_EQ(value_at(pieces[1].parameter, Rational(2) / 5), Rational(7) / 15);
  EXPECT_EQ(value_at(pieces[2].parameter, Rational(1) / 2), Rational(29) / 30);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const auto& [before, after] = std::tie(pieces[i], pieces[i + 1]);
    EXPECT_EQ(value_at(before.parameter, Rational(1)), value_at(after.parameter, Rational(0)));
    EXPECT_EQ(value_at(derivative(before.parameter), Rational(1)) / before.size,
              value_at(derivative(after.parameter), Rational(0)) / after.size);
  }
}

TEST(Pieces, a_range_cuts_them) {
  const auto segment = segment_of({{0, 1, 0}}, {1, 0});
  const auto pieces = pieces_of<Rational>(segment, 0, 0, Rational(1) / 2);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].parameter, ElementsAre(0, 0, Rational(1) / 4));
  EXPECT_EQ(pieces[0].duration, 1);
}

TEST(Pieces, a_size_is_a_sum_of_squares_by_time) {
  const auto segment = segment_of({{1, 3, 0}, {0, 0, 4}});
  const auto pieces = all_pieces(segment);
  const Measure speed{"speed", Measure::Kind::size, 1, {0, 1}},
      acceleration{"acceleration", Measure::Kind::size, 2, {1}};
  EXPECT_EQ(measured(pieces[0], speed).at(0), Rational(9) / 4);
  EXPECT_EQ(measured(pieces[0], speed).at(1), Rational(9 + 64) / 4);
  EXPECT_EQ(measured(pieces[0], acceleration).at(Rational(1) / 2), 4);
}

TEST(Pieces, of_a_smallest_number_its_negative_is_measured) {
  const Measure smallest{"position_x", Measure::Kind::smallest, 0, {0}};
  const auto segment = segment_of({{1, 3, 0}});
  EXPECT_EQ(measured(all_pieces(segment)[0], smallest).at(1), -4);
}

TEST(Pieces, curvature_does_not_depend_on_time) {
  const Measure curvature{"curvature", Measure::Kind::curvature, 0, {0, 1}};
  for (const auto& warp : {spline::Warp<Rational>(), spline::Warp<Rational>(0, 1)}) {
    const auto segment = segment_of({{0, 1, 0}, {0, 0, 1}}, warp);  // a parabola of curvature 2
    const auto piece = all_pieces(segment)[0];
    EXPECT_EQ(measured(piece, curvature).at(0), 4);
  }
  const auto straight = segment_of({{0, 1, 2}, {5, 3, 6}});
  EXPECT_TRUE(form_of<Rational>(all_pieces(straight)[0], curvature).is_constant_zero());
}

TEST(Pieces, bounded_numbers_are_measured_within_their_errors) {
  const Rational tenth = Rational(1) / 10;
  spline::Segments<Rational> exact{2, {0, 1}, {}, {}};
  exact.cubics = {spline::cubic<Rational>(tenth, 4 * tenth, 7 * tenth, 2 * tenth),
                  spline::cubic<Rational>(3 * tenth, 9 * tenth, -4 * tenth, 12 * tenth)};
  const auto whole = pieces_of<Rational>(exact, 0, 0, 1);
  const auto part = pieces_of<Rational>(exact, 0, tenth, 7 * tenth);
  for (const Measure& measure :
       {Measure{"speed", Measure::Kind::size, 1, {0, 1}}, Measure{"acceleration_y", Measure::Kind::smallest, 2, {1}},
        Measure{"curvature", Measure::Kind::curvature, 0, {0, 1}}}) {
    for (const Piece<Rational>& piece : {whole[0], part[0]}) {
      const auto form = form_of<Bounded>(piece, measure);
      for (const double u : {0.0, 0.3, 1.0}) {
        const Bounded value = form.quotient().at(Bounded(u));
        const Rational scale = power_of_two(form.exponent), expected = measured(piece, measure).at(Rational(u)) / scale;
        EXPECT_LT(abs(Rational(value.value.hi) + Rational(value.value.lo) - expected), Rational(value.error));
        EXPECT_LT(value.error, 1e-25 * std::abs(value.value.hi));
      }
    }
  }
}

TEST(Pieces, numbers_beyond_the_range_of_doubles_are_scaled) {
  const Rational tiny = power_of_two(-1060);
  spline::Segments<Rational> exact{1, {0, tiny}, {}, {}};
  exact.cubics = {spline::cubic<Rational>(0, 1 / tiny, 1 / tiny, 1 / tiny)};
  const auto pieces = pieces_of<Rational>(exact, 0, 0, 1);
  const auto form = form_of<Bounded>(pieces[0], {"speed", Measure::Kind::size, 1, {0}});
  const Bounded value = form.quotient().at(Bounded(0.5));
  EXPECT_EQ(Rational(value.value.hi) * power_of_two(form.exponent), power_of_two(4 * 1060));
}

}  // namespace
}  // namespace tcb::limits
