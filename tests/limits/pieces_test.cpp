// Pieces: the parts of an ease, and squares of what is measured on them.
#include "limits/pieces.hpp"

#include <gmock/gmock.h>

namespace tcb::limits {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// One segment from time 0 to 2 along the polynomials a + b u + c u^2, one for each channel.
spline::Segments<Rational> segment_of(const std::vector<Polynomial<Rational>>& channels,
                                      spline::Warp<Rational> warp = {}) {
  spline::Segments<Rational> segment{channels.size(), {0, 2}, {}, {warp}};
  for (const auto& x : channels) {
    segment.cubics.push_back(spline::cubic<Rational>(x[0], x[0] + x[1] + x[2], x[1], x[1] + 2 * x[2]));
  }
  return segment;
}

std::vector<Piece<Rational>> all_pieces(const spline::Segments<Rational>& segment) {
  return pieces_of<Rational>(segment, 0, 2, 0, 1);
}

TEST(Pieces, an_ease_has_three_parts_that_meet_with_one_rate) {
  const Rational f = Rational(3) / 10, e = Rational(1) / 5;
  const auto pieces = all_pieces(segment_of({{0, 1, 0}}, {f, e}));
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
  const auto pieces = pieces_of<Rational>(segment_of({{0, 1, 0}}, {1, 0}), 0, 2, 0, Rational(1) / 2);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].parameter, ElementsAre(0, 0, Rational(1) / 4));
  EXPECT_EQ(pieces[0].duration, 1);
}

TEST(Pieces, a_size_is_a_sum_of_squares_by_time) {
  const auto pieces = all_pieces(segment_of({{1, 3, 0}, {0, 0, 4}}));
  const Measure speed{"speed", Measure::Kind::size, 1, {0, 1}},
      acceleration{"acceleration", Measure::Kind::size, 2, {1}};
  EXPECT_EQ(measured(pieces[0], speed).at(0), Rational(9) / 4);
  EXPECT_EQ(measured(pieces[0], speed).at(1), Rational(9 + 64) / 4);
  EXPECT_EQ(measured(pieces[0], acceleration).at(Rational(1) / 2), 4);
}

TEST(Pieces, of_a_smallest_number_its_negative_is_measured) {
  const Measure smallest{"position_x", Measure::Kind::smallest, 0, {0}};
  EXPECT_EQ(measured(all_pieces(segment_of({{1, 3, 0}}))[0], smallest).at(1), -4);
}

TEST(Pieces, curvature_does_not_depend_on_time) {
  const Measure curvature{"curvature", Measure::Kind::curvature, 0, {0, 1}};
  for (const auto& warp : {spline::Warp<Rational>(), spline::Warp<Rational>(0, 1)}) {
    const auto piece = all_pieces(segment_of({{0, 1, 0}, {0, 0, 1}}, warp))[0];  // a parabola of curvature 2
    EXPECT_EQ(measured(piece, curvature).at(0), 4);
  }
  const auto straight = all_pieces(segment_of({{0, 1, 2}, {5, 3, 6}}))[0];
  EXPECT_TRUE(is_zero(measured(straight, curvature).over));
}

TEST(Pieces, doubles_are_measured_within_their_scale) {
  const Measure curvature{"curvature", Measure::Kind::curvature, 0, {0, 1}};
  spline::Segments<double> segment{2, {0.0, 1.0}, {}, {}};
  segment.cubics = {spline::cubic<double>(0.1, 0.4, 0.7, 0.2), spline::cubic<double>(0.3, 0.9, -0.4, 1.1)};
  const auto fast = measured(pieces_of<double>(segment, 0, 1, 0, 1)[0], curvature);
  spline::Segments<Rational> exact{2, {0, 1}, {}, {}};
  for (const auto& x : segment.cubics) {
    const auto number = [](double value) { return Rational(value); };
    exact.cubics.push_back(spline::cubic<Rational>(number(x.p0), number(x.p1), number(x.out), number(x.in)));
  }
  const auto slow = measured(pieces_of<Rational>(exact, 0, 1, 0, 1)[0], curvature);
  for (const double u : {0.0, 0.3, 1.0}) {
    const double expected = nearest_double(slow.at(Rational(u)));
    EXPECT_NEAR(fast.at(u), expected, 0x1p-40 * fast.scale / std::pow(value_at(fast.base, u), 3));
    EXPECT_NEAR(fast.at(u), expected, 1e-13 * expected);
  }
}

}  // namespace
}  // namespace tcb::limits
