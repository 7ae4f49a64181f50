// Ranking: which candidates fit, which cannot be told apart, and in which order all are.
#include "compare/candidate.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

using testing::ElementsAre;

/// A candidate, told apart by its tangents, with its largest error in allowances of each precision.
Candidate candidate(std::size_t tangents, double largest, std::array<double, 3> excess, std::uint64_t rows_off = 0) {
  return {{static_cast<spline::TangentRule>(tangents), {}, {}, false, 0}, largest, excess, rows_off, {}, {}};
}

std::vector<std::size_t> tangents(const Ranking& ranking) {
  std::vector<std::size_t> order;
  for (const Candidate& one : ranking.candidates) order.push_back(static_cast<std::size_t>(one.convention.tangents));
  return order;
}

TEST(Ranking, those_that_fit_come_first_the_most_usual_before_others) {
  const Ranking ranking = ranked(
      {candidate(2, 1, {9, 9, 9}, 9), candidate(4, 1e-16, {0.1, 0.1, 0.1}), candidate(0, 2e-16, {0.2, 0.2, 0.2})}, 10,
      false);
  EXPECT_EQ(ranking.fitting, 2U);
  EXPECT_EQ(ranking.precision, 0U);
  EXPECT_THAT(tangents(ranking), ElementsAre(0, 4, 2)) << "velocity + half is a preset";
}

TEST(Ranking, among_coarse_numbers_the_clearly_better_ones_fit) {
  const Ranking ranking = ranked({candidate(1, 9e-5, {99, 0.9, 9}), candidate(2, 5e-5, {55, 0.5, 9})}, 10, false);
  EXPECT_EQ(ranking.precision, 1U);
  EXPECT_EQ(ranking.fitting, 1U);
  EXPECT_THAT(tangents(ranking), ElementsAre(2, 1));
}

TEST(Ranking, where_none_fits_few_wrong_rows_count_for_more_than_a_small_error) {
  const Ranking ranking = ranked(
      {candidate(1, 3, {9, 9, 9}, 40), candidate(2, 5, {9, 9, 9}, 1), candidate(3, 2, {9, 9, 9}, 39)}, 40, false);
  EXPECT_FALSE(ranking.precision);
  EXPECT_EQ(ranking.fitting, 0U);
  EXPECT_THAT(tangents(ranking), ElementsAre(2, 3, 1));
}

}  // namespace
}  // namespace tcb
