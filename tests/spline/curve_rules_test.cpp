// Curve rules: the channels of an empty metric, and the rules at another scalar.
#include "tcb/spline/curve_rules.hpp"
#include "tcb/spline/rules.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tcb::spline {
namespace {

using Metric = std::vector<std::size_t>;

TEST(CurveRules, an_empty_metric_has_a_meaning_for_every_kind_of_channel) {
  CurveRules<double> rules;
  EXPECT_EQ(metric_of(rules, 2), (Metric{0, 1}));
  rules.angles = {{0, true}};
  EXPECT_EQ(metric_of(rules, 2), (Metric{1}));
  EXPECT_EQ(metric_of(rules, 1), Metric{});
  rules.rotations = {{{1, 2, 3, 4}}};
  EXPECT_EQ(metric_of(rules, 6), (Metric{5}));
  EXPECT_EQ(metric_of(rules, 5), Metric{});
  rules.metric = {5};
  EXPECT_EQ(metric_of(rules, 7), (Metric{5}));
}

TEST(CurveRules, converted_rules_have_every_member) {
  CurveRules<double> rules{TangentRule::synfig, {EndRule::velocity, {1.5, 2}}, {EndRule::zero, {}}, true, {6}};
  rules.rotations = {{{1, 2, 3, 4}, 0}};
  rules.rotation_rules = {RotationCurve::slerp, TangentRule::uniform, EndRule::mirror};
  rules.angles = {{5, true}};
  rules.timing = Timing::monotone;
  rules.no_overshoot = true;
  const auto halves = [](double value) { return static_cast<float>(value / 2); };
  const auto& [tangents, start, end, equal_speed, metric, rotations, own, angles, timing, no_overshoot] =
      converted<float>(rules, halves);
  EXPECT_EQ(tangents, TangentRule::synfig);
  EXPECT_EQ(start.rule, EndRule::velocity);
  EXPECT_EQ(start.velocity, (std::vector<float>{0.75F, 1}));
  EXPECT_EQ(end.rule, EndRule::zero);
  EXPECT_TRUE(end.velocity.empty());
  EXPECT_TRUE(equal_speed);
  EXPECT_EQ(metric, Metric{6});
  EXPECT_EQ(rotations, rules.rotations);
  EXPECT_EQ(own.curve, RotationCurve::slerp);
  EXPECT_EQ(own.tangents, TangentRule::uniform);
  EXPECT_EQ(own.ends, EndRule::mirror);
  ASSERT_EQ(angles.size(), 1U);
  EXPECT_EQ(angles[0].channel, 5U);
  EXPECT_TRUE(angles[0].degrees);
  EXPECT_EQ(timing, Timing::monotone);
  EXPECT_TRUE(no_overshoot);
}

}  // namespace
}  // namespace tcb::spline
