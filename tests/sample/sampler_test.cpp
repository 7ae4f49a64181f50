// Samplers: how many rows, where each, and when reading stops.
#include "sample/sampler.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace tcb {
namespace {

/// The times of all samples on the line x = t through keys at the given times.
std::vector<double> sample(const SamplingRequest& request, const std::vector<double>& keys, bool closed = false) {
  Extent extent{{keys.front()}, std::nullopt, std::nullopt, closed};
  if (needs_end(request)) extent.last = keys.back();
  if (needs_end(request)) extent.length = keys.back() - keys.front();
  const auto sampler = make_sampler(request, extent);
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < keys.size() && !sampler->done(); ++i) {
    const double h = keys[i + 1] - keys[i];
    const std::array cubics{spline::cubic<double>(keys[i], keys[i + 1], h, h)};
    const CurveSegment segment{
        keys[i], keys[i + 1], keys[i] - keys[0], keys[i + 1] - keys[0], cubics, {}, i + 2 == keys.size(), {}, {}, i};
    const auto add = [&](std::uint64_t row) {
      Located located;
      sampler->locate(segment, row, row + 1, located);
      times.push_back(located.samples.front().t.hi);
    };
    const SegmentRows run = sampler->place(segment);
    if (run.key) add(SpecialRow::at_key);
    for (std::uint64_t j = run.first; j < run.last; ++j) add(j);
    if (run.end) add(SpecialRow::at_end);
  }
  return times;
}

SamplingRequest request(Mode mode, const char* step, std::uint64_t count = 0) {
  SamplingRequest result;
  result.mode = mode;
  if (*step != 0) result.step = *parse_rational(step);
  result.count = count;
  return result;
}

using Times = std::vector<double>;

TEST(Sampler, counts_rows_exactly) {
  for (const std::uint64_t rows : {1U, 2U, 3U, 7U, 1000U}) {
    for (const Mode mode : {Mode::count, Mode::arc_count}) {
      const auto result = sample(request(mode, "", rows), {0.1, 0.35, 2.7});
      ASSERT_EQ(result.size(), rows);
      EXPECT_EQ(result.front(), 0.1);
      EXPECT_EQ(result.back(), rows > 1 ? 2.7 : 0.1);
    }
    EXPECT_EQ(sample(request(Mode::intervals, "", rows), {0.1, 0.35, 2.7}).size(), rows + 1);
  }
}

TEST(Sampler, keys_are_rows_without_near_doubles) {
  SamplingRequest asked = request(Mode::step, "1");
  asked.keys = true;
  EXPECT_EQ(sample(asked, {0, 1.5, 2.0000000001, 3.25}), (Times{0, 1, 1.5, 2.0000000001, 3, 3.25}));
  asked.from = Rational(1, 2);
  asked.to = Rational(3);
  EXPECT_EQ(sample(asked, {0, 1.5, 2, 3.25}), (Times{0.5, 1.5, 2, 2.5}));
  asked = request(Mode::count, "", 3);
  asked.keys = true;
  EXPECT_EQ(sample(asked, {0, 1, 3}), (Times{0, 1, 1.5, 3}));
}

TEST(Sampler, a_closed_curve_does_not_repeat_its_seam_in_counts) {
  EXPECT_EQ(sample(request(Mode::count, "", 4), {0, 1, 2}, true), (Times{0, 0.5, 1, 1.5}));
  EXPECT_EQ(sample(request(Mode::intervals, "", 4), {0, 1, 2}, true), (Times{0, 0.5, 1, 1.5, 2}));
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
