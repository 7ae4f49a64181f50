// Samplers: how many rows, where each, and what is refused.
#include "sampler/sampler.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "error.hpp"

namespace tcb::sampler {
namespace {

/// The times and places of all samples on the line x = t through keys at the given times.
struct Sampled {
  std::vector<double> times, positions;
};

Sampled sample(const Request& request, const std::vector<double>& keys) {
  Extent extent{{keys.front()}, std::nullopt, std::nullopt};
  if (needs_end(request.mode)) extent.last = keys.back();
  if (needs_end(request.mode)) extent.length = keys.back() - keys.front();
  const auto sampler = make_sampler(request, extent);
  Sampled result;
  for (std::size_t i = 0; i + 1 < keys.size() && !sampler->done(); ++i) {
    const double h = keys[i + 1] - keys[i];
    const std::array cubics{spline::cubic<double>(keys[i], keys[i + 1], h, h)};
    const Piece piece{keys[i], keys[i + 1], keys[i] - keys[0], keys[i + 1] - keys[0], cubics, {}, i + 2 == keys.size()};
    const Run run = sampler->place(piece);
    for (std::uint64_t j = run.first; j < run.last; ++j) {
      const Sample at = sampler->locate(piece, j);
      result.times.push_back(at.t.hi);
      result.positions.push_back(spline::position(cubics[0], at.at));
    }
  }
  return result;
}

Request request(Mode mode, const char* step, std::uint64_t count = 0) {
  Request result;
  result.mode = mode;
  if (*step != 0) result.step = *parse_rational(step);
  result.count = count;
  return result;
}

std::string refusal(const Request& asked, const std::vector<double>& keys) {
  try {
    sample(asked, keys);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.what();
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
  Request asked = request(Mode::step, "0.5");
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

TEST(Sampler, refuses_to_leave_the_curve) {
  Request asked = request(Mode::step, "1");
  asked.from = Rational(-1);
  EXPECT_EQ(refusal(asked, {0, 5}), "--from -1 lies before the first key, at 0; give one within the curve, or --extrapolate");
  asked.from = Rational(6);
  EXPECT_EQ(refusal(asked, {0, 5}), "--from 6 lies beyond the last key, at 5; give one within the curve, or --extrapolate");
  asked.from.reset();
  asked.to = Rational(11, 2);
  EXPECT_EQ(refusal(asked, {0, 5}), "--to 5.5 lies beyond the last key, at 5; give one within the curve, or --extrapolate");
}

TEST(Sampler, refuses_steps_that_round_away) {
  EXPECT_EQ(refusal(request(Mode::step, "1e-300"), {1, 5}),
            "the step 1e-300 is too small: near 5 two rows would get the same number; give a larger step");
}

TEST(Sampler, stops_reading_after_the_last_row) {
  Request asked = request(Mode::step, "1");
  asked.to = Rational(2);
  const auto sampler = make_sampler(asked, {{0.0}, {}, {}});
  const std::array cubics{spline::cubic<double>(0, 3, 3, 3)};
  EXPECT_EQ(sampler->place({0.0, 3.0, 0.0, 3.0, cubics, {}, false}).last, 3U);
  EXPECT_TRUE(sampler->done());
}

}  // namespace
}  // namespace tcb::sampler
