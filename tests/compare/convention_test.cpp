// Conventions: orders and signs of tension, continuity and bias, and how conventions are asked for.
#include "compare/convention.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// One curve whose keys have these.
KeptCurves with(std::vector<spline::Tcb<double>> tcbs) {
  KeptCurves kept;
  KeyBlock block;
  block.keys.tcbs = std::move(tcbs);
  kept.curves.push_back({{}, nullptr, {block}});
  return kept;
}

TEST(TcbOrder, takes_each_from_where_its_name_says) {
  const TcbOrder order{{1, 0, 2}, {false, true, false}};
  EXPECT_EQ(order.name(), "C,-T,B");
  EXPECT_EQ(order.of({1, 2, 3}), (spline::Tcb<double>{2, -1, 3}));
}

TEST(TcbOrders, are_48_where_all_matter) {
  const auto orders = distinct_orders(with({{0.1, 0.2, 0.3}}));
  EXPECT_EQ(orders.size(), 48U);
  EXPECT_TRUE(orders[0].order.is_plain());
  EXPECT_EQ(orders[1].order.name(), "T,B,C") << "no sign before any sign";
  EXPECT_EQ(orders[6].order.name(), "-T,C,B");
}

TEST(TcbOrders, that_make_no_difference_count_once) {
  const auto none = distinct_orders(with({{0, 0, 0}, {0, 0, 0}}));
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(none[0].same.size(), 47U);
  // Of one number, the place and the sign matter, and nothing else.
  const auto tension = distinct_orders(with({{0.5, 0, 0}}));
  EXPECT_EQ(tension.size(), 6U);
  EXPECT_THAT(tension[0].same, testing::Contains("T,-B,-C"));
  EXPECT_EQ(tension[0].same.size(), 7U);
}

TEST(Conventions, are_all_rules_but_a_given_velocity) {
  EXPECT_EQ(conventions(48, false).size(), 48U * 2 * 7 * 9);
  EXPECT_EQ(conventions(1, true).size(), 2U * 7) << "a closed curve has no ends";
}

TEST(Conventions, are_asked_for_by_name) {
  const Convention vtk{2, 4, 4, false, 0};
  EXPECT_EQ(name_of(vtk, false), "tangents interval, ends zero");
  EXPECT_THAT(presets_of(vtk, false), ElementsAre("vtk"));
  EXPECT_THAT(presets_of({2, 4, 4, true, 0}, false), IsEmpty()) << "no preset makes speeds equal";
  const CurveSettings settings = settings_of(vtk, {}, false);
  EXPECT_EQ(settings.tangents, "interval");
  EXPECT_EQ(settings.ends, "zero");
  EXPECT_FALSE(settings_of(vtk, {}, true).ends);
  EXPECT_EQ(name_of({2, 4, 0, false, 0}, false), "tangents interval, ends zero,half");
  EXPECT_EQ(with_mixed_ends(vtk).size(), 9U * 8);
}

}  // namespace
}  // namespace tcb
