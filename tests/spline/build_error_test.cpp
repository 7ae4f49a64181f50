// Build errors: a code, values and words for every kind of bad keys and rules, and no undefined behaviour.
#include "tcb/spline/build_error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "example_keys.hpp"
#include "tcb/spline/curve.hpp"

namespace tcb::spline {
namespace {

using enum BuildErrorCode;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The error of the example with a change. Fails where there is none.
template <class F>
BuildError error_with(F change) {
  Keys<double> keys = keys_of(example);
  CurveRules<double> rules;
  change(keys, rules);
  const auto result = Curve<double>::build(keys, rules);
  EXPECT_FALSE(result);
  return result ? BuildError{} : result.error();
}

template <class F>
BuildError closed_error(std::optional<double> period, F change) {
  Keys<double> keys = keys_of(example);
  change(keys);
  const auto end = period ? std::optional<DoubleDouble>(*period) : std::nullopt;
  const auto result = Curve<double>::build_closed(keys, {}, end);
  EXPECT_FALSE(result);
  return result ? BuildError{} : result.error();
}

TEST(BuildError, counts_must_agree) {
  const auto none = error_with([](auto& keys, auto&) { keys = {}; });
  EXPECT_EQ(none.code, no_keys);
  EXPECT_EQ(none.message(), "there are no keys; expected at least one");
  EXPECT_EQ(error_with([](auto& keys, auto&) { keys.channels = 0; }).code, no_channels);
  const auto positions = error_with([](auto& keys, auto&) { keys.channels = 2; });
  EXPECT_EQ(positions.code, positions_count);
  EXPECT_EQ(positions.message(), "the size of positions is 5; expected 10, one per key and channel");
  EXPECT_EQ(error_with([](auto& keys, auto&) { keys.channels = std::size_t{1} << 63; }).code, positions_count);
  EXPECT_EQ(error_with([](auto& keys, auto&) { keys.tcbs.pop_back(); }).code, tcbs_count);
  EXPECT_EQ(error_with([](auto& keys, auto&) { keys.eases.resize(7); }).code, eases_count);
}

TEST(BuildError, given_velocities_are_complete_and_finite) {
  const auto with = [](auto change) {
    return error_with([&](auto& keys, auto& rules) {
      keys.velocities.resize(keys.size());
      keys.given = {true};
      change(keys, rules);
    });
  };
  EXPECT_EQ(with([](auto& keys, auto&) { keys.velocities.pop_back(); }).code, velocities_count);
  EXPECT_EQ(with([](auto& keys, auto&) { keys.given = {true, false}; }).code, given_count);
  EXPECT_EQ(with([](auto& keys, auto&) { keys.velocities.clear(); }).code, given_count);
  const auto outgoing = with([](auto& keys, auto&) { keys.velocities[0].out = no_number; });
  EXPECT_EQ(outgoing.code, key_velocity_not_finite);
  EXPECT_EQ(outgoing.message(),
            "a velocity of key 0 in channel 0 is not finite; expected finite numbers, except before the first key and "
            "after the last (keys and channels count from 0)");
  EXPECT_EQ(with([](auto& keys, auto&) { keys.velocities[4].in = infinity; }).key, 4U);
  EXPECT_EQ(with([](auto&, auto& rules) { rules.equal_speed = true; }).code, equal_speed_with_velocities);
}

TEST(BuildError, times_must_be_finite_and_increase) {
  for (const double bad : {no_number, infinity, -infinity}) {
    const auto error = error_with([&](auto& keys, auto&) { keys.times[2] = bad; });
    EXPECT_EQ(error.code, time_not_finite);
    EXPECT_EQ(error.key, 2U);
  }
  for (const double bad : {1.0, 0.5, -7.0}) {
    const auto error = error_with([&](auto& keys, auto&) { keys.times[2] = bad; });
    EXPECT_EQ(error.code, times_not_increasing);
    EXPECT_EQ(
        error.message(),
        "the time of key 2 is not after that of the key before it; expected increasing times (keys count from 0)");
  }
  const auto error = error_with([](auto& keys, auto&) {
    keys.times[0] = -1e308;
    keys.times[4] = 1e308;
  });
  EXPECT_EQ(error.code, duration_overflow);
}

TEST(BuildError, numbers_must_be_finite_and_ease_within_0_and_1) {
  for (const double bad : {infinity, -infinity}) {
    const auto position = error_with([&](auto& keys, auto&) { keys.positions[3] = bad; });
    EXPECT_EQ(position.code, position_not_finite);
    EXPECT_EQ(position.message(),
              "the position of key 3 in channel 0 is infinite; expected a finite number, or NaN if it is missing "
              "(keys and channels count from 0)");
  }
  for (const double bad : {no_number, infinity, -infinity}) {
    EXPECT_EQ(error_with([&](auto& keys, auto&) { keys.tcbs[1].bias = bad; }).code, tcb_not_finite);
    EXPECT_EQ(error_with([&](auto& keys, auto&) { keys.common_tcb.tension = bad; }).code, common_tcb_not_finite);
  }
  for (const double bad : {no_number, -0.1, 1.5, infinity}) {
    const auto error = error_with([&](auto& keys, auto&) {
      keys.eases.resize(5);
      keys.eases[4].in = bad;
    });
    EXPECT_EQ(error.code, ease_out_of_range);
    EXPECT_EQ(error.key, 4U);
  }
}

TEST(BuildError, rules_must_fit_the_keys) {
  EXPECT_EQ(error_with([](auto&, auto& rules) { rules.tangents = static_cast<TangentRule>(99); }).code, unknown_rule);
  EXPECT_EQ(error_with([](auto&, auto& rules) { rules.end.rule = static_cast<EndRule>(99); }).code, unknown_rule);
  const auto metric = error_with([](auto&, auto& rules) { rules.metric = {0, 1}; });
  EXPECT_EQ(metric.code, metric_channel_missing);
  EXPECT_EQ(metric.message(),
            "the metric has channel 1; expected a number below 1, the number of channels (channels count from 0)");
  EXPECT_EQ(error_with([](auto&, auto& rules) { rules.start.rule = EndRule::velocity; }).code, velocity_count);
  EXPECT_EQ(error_with([](auto&, auto& rules) { rules.end = {EndRule::velocity, {1, 2}}; }).code, velocity_count);
  const auto velocity = error_with([](auto&, auto& rules) { rules.end.velocity = {1}; });
  EXPECT_EQ(velocity.code, velocity_count);
  EXPECT_EQ(velocity.message(),
            "the number of velocities of the end rule at key 4 is 1; expected 0 (keys count from 0)");
  EXPECT_EQ(error_with([](auto&, auto& rules) {
              rules.start = {EndRule::velocity, {no_number}};
            }).code,
            velocity_not_finite);
  EXPECT_EQ(error_with([](auto&, auto& rules) {
              rules.end = {EndRule::velocity, {infinity}};
            }).code,
            velocity_not_finite);
}

TEST(BuildError, a_channel_needs_a_position_and_no_ease_where_one_is_missing) {
  const auto none = error_with([](auto& keys, auto&) { keys.positions.assign(5, no_number); });
  EXPECT_EQ(none.code, channel_without_positions);
  const auto ease = error_with([](auto& keys, auto&) {
    keys.positions[2] = no_number;
    keys.eases.resize(5);
  });
  EXPECT_EQ(ease.code, ease_with_missing_positions);
  EXPECT_EQ(error_with([](auto& keys, auto&) { keys.missing = {true}; }).code, missing_count);
  EXPECT_EQ(error_with([](auto& keys, auto&) { keys.turns.resize(3); }).code, turns_count);
}

TEST(BuildError, monotone_timing_needs_every_position_and_neither_ease_nor_velocities) {
  const auto with_timing = [](auto change) {
    return error_with([&](auto& keys, auto& rules) {
             rules.timing = Timing::monotone;
             change(keys, rules);
           })
        .code;
  };
  EXPECT_EQ(with_timing([](auto& keys, auto&) { keys.positions[2] = no_number; }), timing_with_missing_positions);
  EXPECT_EQ(with_timing([](auto& keys, auto&) { keys.eases.resize(5); }), timing_with_ease);
  EXPECT_EQ(with_timing([](auto& keys, auto&) {
              keys.velocities.resize(5);
              keys.given = {true};
            }),
            timing_with_velocities);
  EXPECT_EQ(with_timing([](auto&, auto& rules) { rules.end = {EndRule::velocity, {1}}; }), timing_with_velocities);
}

TEST(BuildError, equal_speed_needs_every_position) {
  const auto by_nan = error_with([](auto& keys, auto& rules) {
    keys.positions[2] = no_number;
    rules.equal_speed = true;
  });
  EXPECT_EQ(by_nan.code, equal_speed_with_missing_positions);
  EXPECT_EQ(by_nan.message(),
            "some positions are missing, and equal speed needs all of them; expected equal speed only where no "
            "position is missing");
  const auto by_mask = error_with([](auto& keys, auto& rules) {
    keys.missing = {false, false, true, false, false};
    rules.equal_speed = true;
  });
  EXPECT_EQ(by_mask.code, equal_speed_with_missing_positions);
  Keys<double> keys = keys_of(example);
  keys.positions[2] = no_number;
  CurveRules<double> rules;
  rules.equal_speed = true;
  const auto closed = Curve<double>::build_closed(keys, rules, 9.0);
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().code, equal_speed_with_missing_positions);
}

TEST(BuildError, rotations_and_angles_must_fit_the_keys) {
  const auto with = [](auto change) {
    return error_with([&](Keys<double>& keys, CurveRules<double>& rules) {
      keys = {5, {0, 1}, {7, 0, 0, 0, 1, 8, 0, 0, 1, 0}, {}, {}, {}};
      rules.rotations = {{{1, 2, 3, 4}}};
      change(keys, rules);
    });
  };
  EXPECT_EQ(with([](auto&, auto& rules) { rules.rotations[0].channels[3] = 5; }).code, rotation_channel_missing);
  EXPECT_EQ(with([](auto&, auto& rules) { rules.rotations[0].channels[3] = 1; }).code, rotation_channel_shared);
  EXPECT_EQ(with([](auto&, auto& rules) { rules.angles = {{4, true}}; }).code, rotation_channel_shared);
  EXPECT_EQ(with([](auto&, auto& rules) { rules.rotations[0].turn = 0; }).code, rotation_turn_missing);
  EXPECT_EQ(with([](auto& keys, auto&) { keys.positions[2] = no_number; }).code, rotation_incomplete);
  EXPECT_EQ(with([](auto& keys, auto&) { keys.positions[4] = 0; }).code, rotation_zero);
  EXPECT_EQ(with([](auto&, auto& rules) { rules.metric = {0, 2}; }).code, metric_of_angles);
  EXPECT_EQ(with([](auto&, auto& rules) {
              rules.end = {EndRule::velocity, {1, 2, 3, 4, 5}};
            }).code,
            end_velocity_of_rotation);
  EXPECT_EQ(with([](auto& keys, auto&) {
              keys.velocities.resize(10);
              keys.given = {false, true, true, true, false};
            }).code,
            rotation_velocity_incomplete);
}

TEST(BuildError, closed_curves_need_two_keys_and_a_period) {
  const auto none = [](auto&) {};
  EXPECT_EQ(closed_error(std::nullopt, none).code, period_missing);
  for (const double bad : {no_number, infinity}) EXPECT_EQ(closed_error(bad, none).code, period_not_finite);
  for (const double bad : {6.0, 1.0, 0.0, -9.0}) EXPECT_EQ(closed_error(bad, none).code, period_too_short);
  const auto repeat_first = [](auto& keys) {
    keys.positions[4] = keys.positions[0];
    keys.tcbs[4] = keys.tcbs[0];
  };
  EXPECT_EQ(closed_error(7.0, repeat_first).code, period_contradicted);
  const auto differ = closed_error(std::nullopt, [](auto& keys) { keys.positions[4] = keys.positions[0]; });
  EXPECT_EQ(differ.code, seam_tcb_differs);
  EXPECT_EQ(differ.key, 4U);
  const auto in_channel = closed_error(std::nullopt, [](auto& keys) {
    keys = Keys<double>{2, {0, 1, 2}, {0, 0, 1, 1, 0, 0}, {{}, {}, {}, {}, {}, {1}}, {}, {}};
  });
  EXPECT_EQ(in_channel.code, seam_tcb_differs);
  EXPECT_EQ(in_channel.channel, 1U);
  const auto of_velocities = closed_error(std::nullopt, [](auto& keys) {
    keys = Keys<double>{1, {0, 1, 2}, {0, 1, 0}, {{}, {}, {}}, {}, {}, {{1, 1}, {0, 0}, {1, 2}}};
    keys.given = {true};
  });
  EXPECT_EQ(of_velocities.code, seam_velocity_differs);
  EXPECT_EQ(of_velocities.key, 2U);
  EXPECT_EQ(closed_error(9.0, [](auto& keys) { keys = keys_of({{0, 1, 0, 0, 0}}); }).code, closed_too_few_keys);
  EXPECT_EQ(closed_error(std::nullopt,
                         [](auto& keys) {
                           keys = keys_of({{0, 1, 0, 0, 0}, {1, 1, 0, 0, 0}});
                         })
                .code,
            closed_too_few_keys);
}

TEST(BuildError, an_overflow_is_an_error) {
  const auto error = error_with([](auto& keys, auto&) {
    keys.positions[1] = 1e308;
    keys.positions[2] = -1e308;
  });
  EXPECT_EQ(error.code, curve_overflow);
  const auto length = error_with([](auto& keys, auto&) {
    keys.channels = 5;
    keys.times = {0.0, 1.0};
    keys.positions = {0, 0, 0, 0, 0, 1e308, 1e308, 1e308, 1e308, 1e308};
    keys.tcbs = {{}, {}};
  });
  EXPECT_EQ(length.code, length_overflow);
}

TEST(BuildError, every_code_has_a_message_without_placeholders) {
  for (const auto& row : build_error_texts) {
    const std::string message = BuildError{.code = row.id}.message();
    EXPECT_EQ(message.find('{'), std::string::npos) << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
  }
}

TEST(BuildError, extreme_keys_give_an_error_or_finite_positions) {
  std::mt19937_64 random(6);
  const auto draw = [&] {
    constexpr std::array special{0.0,     -0.0,  1.0,    -1.0,      1e308,    -1e308,    1e-308, 5e-324,
                                 -5e-324, 1e150, 1e-150, no_number, infinity, -infinity, 0x1p53, 3.0};
    return special[random() % (random() % 8 == 0 ? special.size() : special.size() - 3)];
  };
  int built = 0;
  for (int round = 0; round < 20'000; ++round) {
    Keys<double> keys;
    keys.channels = 1 + random() % 2;
    const std::size_t size = random() % 5;
    double t = draw();
    for (std::size_t i = 0; i < size; ++i, t += random() % 2 ? 1.0 : std::abs(draw())) {
      keys.times.emplace_back(t);
      for (std::size_t c = 0; c < keys.channels; ++c) keys.positions.push_back(draw());
      if (round % 2 == 0) keys.tcbs.push_back({draw(), draw(), draw()});
    }
    CurveRules<double> rules;
    rules.tangents = static_cast<TangentRule>(random() % tangent_rules<double>.size());
    rules.start.rule = rules.end.rule = static_cast<EndRule>(random() % (end_rules<double>.size() - 1));
    rules.equal_speed = random() % 2 == 0;
    const auto result = random() % 2 == 0 ? Curve<double>::build(keys, rules)
                                          : Curve<double>::build_closed(keys, rules, DoubleDouble(std::abs(draw())));
    if (!result) {
      EXPECT_FALSE(result.error().message().empty());
      continue;
    }
    ++built;
    for (const double at : {result->start(), result->end(), (result->start() + result->end()) / 2}) {
      std::array<double, 2> x{};
      result->position(at, x);
      EXPECT_TRUE(is_finite(x[0]) && is_finite(x[1]));
      result->derivative(random() % 5, draw(), x);
      (void)result->at_length(draw(), x);
      (void)result->length_to(draw());
    }
  }
  EXPECT_GT(built, 1000);
}

}  // namespace
}  // namespace tcb::spline
