// Samplers: how many rows, where each, and what is refused.
#include "sample/sampler.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "error.hpp"

namespace tcb {
namespace {

/// The times and places of all samples on the line x = t through keys at the given times.
struct Sampled {
  std::vector<double> times, positions;
  double remainder = 0;
};

Sampled sample(const SamplingRequest& request, const std::vector<double>& keys, bool closed = false) {
  Extent extent{{keys.front()}, std::nullopt, std::nullopt, closed};
  if (needs_end(request)) extent.last = keys.back();
  if (needs_end(request)) extent.length = keys.back() - keys.front();
  const auto sampler = make_sampler(request, extent);
  Sampled result;
  for (std::size_t i = 0; i + 1 < keys.size() && !sampler->done(); ++i) {
    const double h = keys[i + 1] - keys[i];
    const std::array cubics{spline::cubic<double>(keys[i], keys[i + 1], h, h)};
    const CurveSegment segment{
        keys[i], keys[i + 1], keys[i] - keys[0], keys[i + 1] - keys[0], cubics, {}, i + 2 == keys.size(), {}, {}, i};
    const auto add = [&](std::uint64_t row) {
      Located located;
      sampler->locate(segment, row, row + 1, located);
      const Sample& at = located.samples.front();
      result.times.push_back(at.t.hi);
      result.positions.push_back(spline::position(cubics[0], at.at));
    };
    const SegmentRows run = sampler->place(segment);
    if (run.key) add(SpecialRow::at_key);
    for (std::uint64_t j = run.first; j < run.last; ++j) add(j);
    if (run.end) add(SpecialRow::at_end);
  }
  if (sampler->remainder()) result.remainder = nearest_time(*sampler->remainder()).hi;
  return result;
}

SamplingRequest request(Mode mode, const char* step, std::uint64_t count = 0) {
  SamplingRequest result;
  result.mode = mode;
  if (*step != 0) result.step = *parse_rational(step);
  result.count = count;
  return result;
}

std::string refused_request(const SamplingRequest& asked, const std::vector<double>& keys) {
  try {
    sample(asked, keys);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.message();
  }
  return "nothing";
}

using Times = std::vector<double>;

TEST(Sampler, steps_from_the_first_key_to_the_last) {
  EXPECT_EQ(sample(request(Mode::step, "0.1"), {0, 0.3, 0.4}).times, (Times{0, 0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(sample(request(Mode::step, "0.25"), {1, 1.6}).times, (Times{1, 1.25, 1.5}));
}

TEST(Sampler, counts_rows_exactly) {
  for (const std::uint64_t rows : {1U, 2U, 3U, 7U, 1000U}) {
    for (const Mode mode : {Mode::count, Mode::arc_count}) {
      const auto result = sample(request(mode, "", rows), {0.1, 0.35, 2.7});
      ASSERT_EQ(result.times.size(), rows);
      EXPECT_EQ(result.times.front(), 0.1);
      EXPECT_EQ(result.times.back(), rows > 1 ? 2.7 : 0.1);
    }
    EXPECT_EQ(sample(request(Mode::segments, "", rows), {0.1, 0.35, 2.7}).times.size(), rows + 1);
  }
}

TEST(Sampler, arc_steps_are_equal_distances) {
  const auto result = sample(request(Mode::arc_step, "0.5"), {1, 1.75, 3});
  EXPECT_EQ(result.positions, (Times{1, 1.5, 2, 2.5, 3}));
}

TEST(Sampler, from_and_to_bound_the_rows) {
  SamplingRequest asked = request(Mode::step, "0.5");
  asked.from = Rational(3, 4);
  asked.to = Rational(2);
  EXPECT_EQ(sample(asked, {0, 1, 5}).times, (Times{0.75, 1.25, 1.75}));
  asked = request(Mode::count, "", 3);
  asked.from = Rational(1);
  asked.to = Rational(2);
  EXPECT_EQ(sample(asked, {0, 5}).times, (Times{1, 1.5, 2}));
  asked = request(Mode::arc_count, "", 3);
  asked.from = Rational(1);
  EXPECT_EQ(sample(asked, {0, 5}).positions, (Times{1, 3, 5}));
}

TEST(Sampler, end_policies_do_what_their_names_say) {
  const std::vector<std::pair<EndPolicy, Times>> table{{EndPolicy::drop, {0, 1.5, 3, 4.5, 6}},
                                                       {EndPolicy::keep, {0, 1.5, 3, 4.5, 6, 7}},
                                                       {EndPolicy::fit, {0, 1.4, 2.8, 4.2, 5.6, 7}},
                                                       {EndPolicy::fit_down, {0, 1.4, 2.8, 4.2, 5.6, 7}},
                                                       {EndPolicy::fit_up, {0, 1.75, 3.5, 5.25, 7}}};
  for (const auto& [policy, expected] : table) {
    for (const Mode mode : {Mode::step, Mode::arc_step}) {
      SamplingRequest asked = request(mode, "1.5");
      asked.end = policy;
      const auto result = sample(asked, {0, 2.5, 7});
      ASSERT_EQ(result.positions.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(result.positions[i], expected[i]);
      EXPECT_EQ(result.remainder, policy == EndPolicy::drop ? 1 : 0);
    }
  }
}

TEST(Sampler, no_policy_changes_steps_that_meet_the_end) {
  for (const auto& named : end_policies) {
    SamplingRequest asked = request(Mode::step, "0.1");
    asked.end = named.policy;
    EXPECT_EQ(sample(asked, {0, 0.3}).times, (Times{0, 0.1, 0.2, 0.3})) << named.name;
  }
}

TEST(Sampler, keys_are_rows_without_near_doubles) {
  SamplingRequest asked = request(Mode::step, "1");
  asked.keys = true;
  EXPECT_EQ(sample(asked, {0, 1.5, 2.0000000001, 3.25}).times, (Times{0, 1, 1.5, 2.0000000001, 3, 3.25}));
  asked.from = Rational(1, 2);
  asked.to = Rational(3);
  EXPECT_EQ(sample(asked, {0, 1.5, 2, 3.25}).times, (Times{0.5, 1.5, 2, 2.5}));
  asked = request(Mode::count, "", 3);
  asked.keys = true;
  EXPECT_EQ(sample(asked, {0, 1, 3}).times, (Times{0, 1, 1.5, 3}));
}

TEST(Sampler, per_segment_divides_every_segment) {
  EXPECT_EQ(sample(request(Mode::per_segment, "", 3), {0, 0.3, 3.3}).times, (Times{0, 0.1, 0.2, 0.3, 1.3, 2.3, 3.3}));
}

TEST(Sampler, a_closed_curve_does_not_repeat_its_seam_in_counts) {
  EXPECT_EQ(sample(request(Mode::count, "", 4), {0, 1, 2}, true).times, (Times{0, 0.5, 1, 1.5}));
  EXPECT_EQ(sample(request(Mode::segments, "", 4), {0, 1, 2}, true).times, (Times{0, 0.5, 1, 1.5, 2}));
}

TEST(Sampler, rows_at_keys_are_on_the_requested_side) {
  for (const bool left : {true, false}) {
    SamplingRequest asked = request(Mode::step, "1");
    asked.from_left = left;
    const auto sampler = make_sampler(asked, {{0.0}, {}, {}});
    const std::array cubics{spline::cubic<double>(0, 1, 1, 1)};
    EXPECT_EQ(sampler->place({0.0, 1.0, {}, {}, cubics, {}, false}).last, left ? 2U : 1U);
    EXPECT_EQ(sampler->place({1.0, 2.0, {}, {}, cubics, {}, true, {}, {}, 1}).last, 3U) << "the last key: left";
  }
}

TEST(Sampler, counts_the_rows_that_it_refuses) {
  SamplingRequest asked = request(Mode::step, "1e-300");
  EXPECT_EQ(refused_request(asked, {1, 5}),
            "4.00e300 rows are requested; expected at most 1000000000; request fewer, or raise --max-rows");
  asked = request(Mode::count, "", 12);
  asked.max_rows = 11;
  EXPECT_EQ(refused_request(asked, {1, 5}),
            "12 rows are requested; expected at most 11; request fewer, or raise --max-rows");
}

TEST(Sampler, refuses_to_leave_the_curve) {
  SamplingRequest asked = request(Mode::step, "1");
  asked.from = Rational(-1);
  EXPECT_EQ(refused_request(asked, {0, 5}),
            "--from: time -1 is before the first key, at 0; give a time on the curve, or --extrapolate");
  asked.from = Rational(6);
  EXPECT_EQ(refused_request(asked, {0, 5}),
            "--from: time 6 is after the last key, at 5; give a time on the curve, or --extrapolate");
  asked.from.reset();
  asked.to = Rational(11, 2);
  EXPECT_EQ(refused_request(asked, {0, 5}),
            "--to: time 5.5 is after the last key, at 5; give a time on the curve, or --extrapolate");
}

TEST(Sampler, refuses_steps_that_round_away) {
  EXPECT_EQ(refused_request(request(Mode::step, "1e-8"), {1e9, 1e9 + 1}),
            "the step 1e-08 is too small: two rows near 1000000001 would coincide; give a larger step");
}

TEST(Sampler, stops_reading_after_the_last_row) {
  SamplingRequest asked = request(Mode::step, "1");
  asked.to = Rational(2);
  const auto sampler = make_sampler(asked, {{0.0}, {}, {}});
  const std::array cubics{spline::cubic<double>(0, 3, 3, 3)};
  EXPECT_EQ(sampler->place({0.0, 3.0, 0.0, 3.0, cubics, {}, false}).last, 3U);
  EXPECT_TRUE(sampler->done());
}

}  // namespace
}  // namespace tcb
