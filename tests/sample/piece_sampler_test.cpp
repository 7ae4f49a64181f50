// Pieces: a row for each segment in the range, cut where the range begins and ends, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "error.hpp"
#include "sample/sampler.hpp"

namespace tcb {
namespace {

/// The pieces of the line x = t through keys at the given times.
struct Pieces {
  std::vector<double> starts, ends, first_u, last_w;
  std::size_t segments_read = 0;
};

SamplingRequest request(const char* from = "", const char* to = "") {
  SamplingRequest result;
  result.mode = Mode::emit;
  result.count = 1;
  if (*from != 0) result.from = *parse_rational(from);
  if (*to != 0) result.to = *parse_rational(to);
  return result;
}

Pieces pieces_of(const SamplingRequest& asked, const std::vector<double>& keys,
                 const spline::Warp<double>& last_warp = {}) {
  const auto sampler = make_sampler(asked, {{keys.front()}, std::nullopt, std::nullopt});
  Pieces result;
  for (std::size_t i = 0; i + 1 < keys.size() && !sampler->done(); ++i) {
    const double h = keys[i + 1] - keys[i];
    const std::array cubics{spline::cubic<double>(keys[i], keys[i + 1], h, h)};
    const bool last = i + 2 == keys.size();
    const CurveSegment segment{
        keys[i], keys[i + 1], 0.0, 0.0, cubics, {}, last, last ? last_warp : spline::Warp<double>(), {}, i};
    ++result.segments_read;
    const SegmentRows run = sampler->place(segment);
    EXPECT_FALSE(run.key || run.end);
    Located located;
    sampler->locate(segment, run.first, run.last, located);
    EXPECT_EQ(located.samples.size(), located.ends.size());
    for (std::size_t row = 0; row < located.samples.size(); ++row) {
      result.starts.push_back(located.samples[row].t.hi);
      result.ends.push_back(located.ends[row].t.hi);
      result.first_u.push_back(located.samples[row].at.u);
      result.last_w.push_back(located.ends[row].at.w);
    }
  }
  return result;
}

std::string refusal(const SamplingRequest& asked, const std::vector<double>& keys,
                    const spline::Warp<double>& last_warp = {}) {
  try {
    pieces_of(asked, keys, last_warp);
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

using Times = std::vector<double>;

TEST(Pieces, each_segment_is_one) {
  const Pieces all = pieces_of(request(), {1, 2, 4});
  EXPECT_EQ(all.starts, (Times{1, 2}));
  EXPECT_EQ(all.ends, (Times{2, 4}));
  EXPECT_EQ(all.first_u, (Times{0, 0}));
  EXPECT_EQ(all.last_w, (Times{0, 0}));
}

TEST(Pieces, the_range_cuts_the_first_and_the_last) {
  const Pieces part = pieces_of(request("1.5", "3"), {1, 2, 4, 5});
  EXPECT_EQ(part.starts, (Times{1.5, 2}));
  EXPECT_EQ(part.ends, (Times{2, 3}));
  EXPECT_EQ(part.first_u, (Times{0.5, 0}));
  EXPECT_EQ(part.last_w, (Times{0, -0.5}));
  const Pieces inner = pieces_of(request("2.5", "3"), {1, 2, 4, 5});
  EXPECT_EQ(inner.starts, Times{2.5});
  EXPECT_EQ(inner.ends, Times{3});
}

TEST(Pieces, a_range_from_key_to_key_has_whole_segments_only) {
  const Pieces part = pieces_of(request("2", "4"), {1, 2, 4, 5});
  EXPECT_EQ(part.starts, Times{2});
  EXPECT_EQ(part.ends, Times{4});
}

TEST(Pieces, no_segment_after_the_range_is_read) {
  EXPECT_EQ(pieces_of(request("", "4"), {1, 2, 4, 5, 6}).segments_read, 2U);
  EXPECT_EQ(pieces_of(request("", "3"), {1, 2, 4, 5, 6}).segments_read, 2U);
}

TEST(Pieces, a_range_outside_the_curve_or_without_duration_is_refused) {
  const std::string none =
      "no part of the curve lies between --from and --to; expected a longer range; correct --from or --to";
  EXPECT_EQ(refusal(request("0.5"), {1, 2, 4}),
            "--from: time 0.5 is before the first key, at 1; give a time on the curve");
  EXPECT_EQ(refusal(request("", "0.5"), {1, 2, 4}),
            "--to: time 0.5 is before the first key, at 1; give a time on the curve");
  EXPECT_EQ(refusal(request("4.5"), {1, 2, 4}),
            "--from: time 4.5 is after the last key, at 4; give a time on the curve");
  EXPECT_EQ(refusal(request("", "4.5"), {1, 2, 4}),
            "--to: time 4.5 is after the last key, at 4; give a time on the curve");
  EXPECT_EQ(refusal(request("4"), {1, 2, 4}), none);
  EXPECT_EQ(refusal(request("", "1"), {1, 2, 4}), none);
  EXPECT_EQ(refusal(request("3", "3"), {1, 2, 4}), none);
  EXPECT_EQ(refusal(request("1", "4"), {1, 2, 4}), "");
}

TEST(Pieces, ease_is_refused_in_the_range_only) {
  const spline::Warp<double> warp(0.5, 0);
  EXPECT_THAT(refusal(request(), {1, 2, 4}, warp),
              testing::StartsWith("segment 1, from the key at time 2 to the key at 4, has ease"));
  EXPECT_EQ(refusal(request("", "2"), {1, 2, 4}, warp), "");
}

TEST(Pieces, more_than_the_largest_number_of_rows_are_refused) {
  SamplingRequest two = request();
  two.max_rows = 2;
  EXPECT_EQ(refusal(two, {1, 2, 4}), "");
  EXPECT_EQ(refusal(two, {1, 2, 4, 5}), "3 rows are requested; expected at most 2; request fewer, or raise --max-rows");
  EXPECT_EQ(refusal(two, {1, 2, 4, 5, 6}),
            "at least 3 rows are requested; expected at most 2; request fewer, or raise --max-rows");
}

}  // namespace
}  // namespace tcb
