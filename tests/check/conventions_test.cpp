// Conventions: orders and signs of tension, continuity and bias, and the settings of conventions.
#include <gmock/gmock.h>

#include "check/conventions.hpp"

namespace tcb {
namespace {

using spline::EndRule;
using spline::Preset;
using spline::RotationCurve;
using spline::TangentRule;
using testing::ElementsAre;
using testing::IsEmpty;

/// One curve whose keys have these.
KeptInput with(std::vector<spline::Tcb<double>> tcbs) {
  KeptInput kept;
  KeyBlock block;
  block.keys.tcbs = std::move(tcbs);
  kept.curves.push_back({{}, nullptr, {block}});
  return kept;
}

TEST(TcbOrder, takes_each_parameter_as_its_name_shows) {
  const TcbOrder order{{1, 0, 2}, {false, true, false}};
  EXPECT_EQ(order.name(), "C,-T,B");
  EXPECT_EQ(order.of({1, 2, 3}), (spline::Tcb<double>{2, -1, 3}));
}

TEST(TcbOrders, are_48_if_all_have_an_effect) {
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
  EXPECT_EQ(conventions(48, {}).size(), 48U * (2 * 7 * 9 + 1) + 1)
      << "nerfstudio has its own timing, and straight lines have no T, C, B";
  EXPECT_EQ(conventions(1, {.closed = true}).size(), 2U * 7 + 2) << "a closed curve has no ends";
}

TEST(Conventions, the_most_usual_come_first) {
  const auto all = conventions(2, {});
  EXPECT_EQ(presets_of(all.front(), {}).at(0), "tcb");
  EXPECT_EQ(all.back().order, 1U);
  EXPECT_TRUE(all[all.size() - 4].equal_speed);
  EXPECT_EQ(presets_of(all.back(), {}).at(0), "nerfstudio");
}

TEST(Conventions, have_settings_and_presets) {
  const Convention vtk{TangentRule::interval, EndRule::zero, EndRule::zero, false, 0};
  EXPECT_THAT(presets_of(vtk, {}), ElementsAre("vtk"));
  Convention equal_speed = vtk;
  equal_speed.equal_speed = true;
  EXPECT_THAT(presets_of(equal_speed, {}), IsEmpty()) << "no preset makes speeds equal";
  const CurveSettings settings = settings_of(vtk, {}, {});
  EXPECT_EQ(settings.tangents, TangentRule::interval);
  EXPECT_EQ(settings.ends->value.last.rule, EndRule::zero);
  EXPECT_FALSE(settings_of(vtk, {}, {.closed = true}).ends);
}

TEST(Conventions, of_rotations_have_a_curve_and_the_rules_that_presets_give_them) {
  using enum RotationCurve;
  const ComparedParts both{.rotation_curves = {squad, casteljau}};
  const ComparedParts turns{.positions = false, .rotation_curves = {squad, slerp}};
  EXPECT_EQ(conventions(1, both).size(), 2U * 7 * 9 * 2 + 3 + 2) << "vtk, 3dsmax as nel, cryengine, nerfstudio";
  EXPECT_EQ(conventions(2, turns).size(), 2U * 2 * 7 * 9 + 1 + 2) << "slerp has no tangents";
  const Convention nel{
      TangentRule::interval_c, EndRule::natural_tension, EndRule::natural_tension, false, 0, squad, Preset::nel};
  EXPECT_THAT(presets_of(nel, both), ElementsAre("3dsmax", "nel"));
  const CurveSettings settings = settings_of(nel, {}, both);
  EXPECT_EQ(settings.rotation_curve, squad);
  EXPECT_EQ(settings.rotation_preset, Preset::nel);
  const Convention mirror{TangentRule::interval_c, EndRule::mirror, EndRule::mirror, false, 0, squad};
  EXPECT_THAT(presets_of(mirror, both), ElementsAre("lib3ds2"));
  EXPECT_THAT(presets_of(mirror, turns), ElementsAre("3dsmax", "nel", "cryengine", "lib3ds2"));
}

TEST(Conventions, may_have_different_rules_at_the_ends) {
  const Convention mixed{TangentRule::interval, EndRule::zero, EndRule::half, false, 0};
  EXPECT_EQ(ends_of(mixed, {}), "zero,half");
  EXPECT_EQ(ends_of(mixed, {.closed = true}), std::nullopt);
  EXPECT_THAT(presets_of(mixed, {}), IsEmpty());
  EXPECT_THAT(presets_of(mixed, {.closed = true}), testing::Contains("vtk")) << "a closed curve has no ends";
  EXPECT_EQ(with_mixed_ends(mixed).size(), 9U * 8);
}

}  // namespace
}  // namespace tcb
