// Ranking: which candidates fit, which are equivalent, in which order all are, and rules identified from numbers.
#include "check/ranking.hpp"

#include <gmock/gmock.h>

#include "comparing.hpp"

namespace tcb {
namespace {

using spline::EndRule;
using spline::TangentRule;
using testing::ElementsAre;

/// A candidate, identified by its tangents, with its largest error as a part of what is allowed.
Candidate candidate(std::size_t tangents, double largest, double excess, std::uint64_t rows_off = 0) {
  return {
      {static_cast<TangentRule>(tangents), EndRule::half, EndRule::half, false, 0}, largest, excess, rows_off, {}, {}};
}

std::vector<std::size_t> tangents(const Ranking& ranking) {
  std::vector<std::size_t> order;
  for (const Candidate& one : ranking.candidates) order.push_back(static_cast<std::size_t>(one.convention.tangents));
  return order;
}

TEST(Ranking, those_that_fit_come_first_the_most_usual_before_others) {
  const Ranking ranking = ranked({candidate(2, 1, 9, 9), candidate(4, 1e-16, 0), candidate(0, 2e-16, 0)}, 10, {});
  EXPECT_EQ(ranking.fitting, 2U);
  EXPECT_THAT(tangents(ranking), ElementsAre(0, 4, 2)) << "velocity + half is a preset";
}

TEST(Ranking, among_coarse_numbers_the_clearly_better_ones_fit) {
  const Ranking ranking = ranked({candidate(1, 9e-5, 0.9), candidate(2, 5e-5, 0.5)}, 10, {});
  EXPECT_EQ(ranking.fitting, 1U);
  EXPECT_THAT(tangents(ranking), ElementsAre(2, 1));
}

TEST(Ranking, if_none_fits_few_wrong_rows_rank_before_small_errors) {
  const Ranking ranking = ranked({candidate(1, 3, 9, 40), candidate(2, 5, 9, 1), candidate(3, 2, 9, 39)}, 40, {});
  EXPECT_EQ(ranking.fitting, 0U);
  EXPECT_THAT(tangents(ranking), ElementsAre(2, 3, 1));
}

/// Whether any of the conventions that fit has these rules, plain numbers and plain speeds.
bool fits(const Identification& identification, TangentRule tangents, EndRule ends) {
  const Ranking& ranking = identification.ranking;
  return std::any_of(ranking.candidates.begin(),
                     ranking.candidates.begin() + static_cast<std::ptrdiff_t>(ranking.fitting),
                     [&](const Candidate& one) {
                       const Convention& convention = one.convention;
                       return convention.tangents == tangents && convention.start == ends && convention.end == ends &&
                              !convention.equal_speed && convention.order == 0;
                     });
}

Identification identified(const Comparing& files) {
  return identify(files.comparison, read_positions(files.comparison));
}

// Keys of x = t at uneven times; velocities are 1 everywhere, but the tangent (D0 + D1)/2 of the uniform rule is 3/2.
constexpr auto uneven_keys = "t,x\n0,0\n1,1\n3,3\n4,4\n";

TEST(Identification, tries_no_equal_speed_where_keys_lack_positions) {
  const auto tried = [](const std::string& keys) {
    Comparing files(keys, "t,x,y\n0.5,0.5,1\n");
    files.comparison.keys.input.keys.missing = Missing::skip_cell;
    const Identification result = identified(files);
    EXPECT_TRUE(result.fits());
    return result.conventions;
  };
  const std::uint64_t of_sparse_keys = tried("t,x,y\n0,0,1\n1,1,\n3,3,1\n");
  EXPECT_EQ(tried("t,x,y\n0,0,1\n1,1,1\n3,3,1\n"), 2 * (of_sparse_keys - 1) + 2)
      << "with equal speeds and monotone timing also; straight lines have one timing";
}

TEST(Identification, of_a_straight_line_at_uneven_times) {
  Comparing files(uneven_keys, "t,x\n0.5,0.5\n1.5,1.5\n2.5,2.5\n");
  const Identification result = identified(files);
  ASSERT_TRUE(result.fits());
  EXPECT_EQ(result.rows, 3U);
  EXPECT_TRUE(fits(result, TangentRule::velocity, EndRule::chord));
  EXPECT_FALSE(fits(result, TangentRule::uniform, EndRule::chord));
  EXPECT_FALSE(fits(result, TangentRule::velocity, EndRule::zero));
}

TEST(Identification, of_tangents_that_ignore_the_times) {
  // The cubic with x = 1, 3 and tangents 3/2, 3/2 at a quarter of the segment, and the one with x = 0, 1 and tangents
  // 1, 3/2 at a half.
  Comparing files(uneven_keys, "t,x\n0.5,0.4375\n1.5,1.453125\n");
  const Identification result = identified(files);
  ASSERT_TRUE(result.fits());
  EXPECT_TRUE(fits(result, TangentRule::uniform, EndRule::chord));
  EXPECT_FALSE(fits(result, TangentRule::velocity, EndRule::chord));
}

TEST(Identification, compares_positions_only) {
  Comparing files(uneven_keys, "t,x,x_v\n0.5,0.5,77\n");
  files.comparison.fields = {field_of("position"), field_of("velocity")};
  const Identification result = identified(files);
  EXPECT_TRUE(result.fits());
  EXPECT_THAT(result.ignored, ElementsAre("x_v"));
  Comparing none(uneven_keys, "t,x_v\n0.5,1\n");
  none.comparison.fields = {field_of("velocity")};
  EXPECT_EQ(error_of([&] { identified(none); }).message(), no_position_column({"x"}).message());
}

TEST(Identification, needs_rows_on_the_curve_and_numbers_in_them) {
  Comparing outside(uneven_keys, "t,x\n9,0\n");
  const Error off = error_of([&] { identified(outside); });
  EXPECT_THAT(off.message(), testing::HasSubstr("no row is on the curve"));
  EXPECT_EQ(off.position().file, outside.path("rows.csv"));
  ASSERT_EQ(off.others().size(), 1U);
  EXPECT_TRUE(off.others()[0].message().starts_with("rows outside the curve: 1;")) << off.others()[0].message();
  Comparing empty(uneven_keys, "t,x\n0.5,nan\n");
  EXPECT_THAT(error_of([&] { identified(empty); }).message(), testing::HasSubstr("no row has a number"));
}

}  // namespace
}  // namespace tcb
