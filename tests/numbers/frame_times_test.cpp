// Frame times: frames are found by their doubles, and elapsed times have the digits that these omit.
#include "numbers/frame_times.hpp"
#include "numbers/decimal_time.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>

namespace tcb {
namespace {

const Rational ntsc_rate(30000, 1001);

/// A double-double as a rational.
Rational value(const Time& time) { return Rational(time.hi) + Rational(time.lo); }

TEST(FrameTimes, a_double_nearest_to_a_frame_is_the_frame) {
  const FrameTimes frames(ntsc_rate);
  for (const std::int64_t frame : {0, 1, 2, 15, 107892, 2589408, -7}) {
    const Rational exact = Rational(frame) / ntsc_rate;
    EXPECT_EQ(frames.exact(nearest_double(exact)), exact) << frame;
  }
  EXPECT_EQ(frames.exact(nearest_double(Rational(25, 2) / ntsc_rate)), Rational(25, 2) / ntsc_rate);  // half a frame
  EXPECT_FALSE(frames.exact(std::nextafter(nearest_double(Rational(15) / ntsc_rate), 1)));
  EXPECT_FALSE(frames.exact(Time(0.1)));
  EXPECT_FALSE(frames.exact(Time(1e300)));
}

TEST(FrameTimes, elapsed_times_do_not_depend_on_how_far_from_0_frames_are) {
  const FrameTimes all(ntsc_rate);
  const Time hour = nearest_double(Rational(107892) / ntsc_rate);
  const FrameTimes frames = all.from(hour), early = all.from(0.0);
  for (const std::int64_t frame : {0, 1, 2, 15, 1001, 30000}) {
    const Rational exact = Rational(frame) / ntsc_rate;
    const Time time = nearest_double(exact + Rational(107892) / ntsc_rate);
    EXPECT_EQ(frames.elapsed(time), early.elapsed(nearest_double(exact))) << frame;
    EXPECT_LE(abs(value(frames.elapsed(time)) - exact), exact * Rational(0x1p-99)) << frame;
    EXPECT_EQ(frames.time(frames.elapsed(time)), time) << frame;
  }
}

TEST(FrameTimes, decimals_are_what_their_texts_name) {
  const FrameTimes all = FrameTimes::decimals();
  EXPECT_EQ(*all.exact(0.1), Rational(1, 10));
  const FrameTimes late = all.from(1714564800.0), early = all.from(0.0);
  for (const double part : {0.1, 0.25, 0.7, 3.000001}) {
    EXPECT_EQ(late.elapsed(1714564800.0 + part), early.elapsed(part)) << part;
    EXPECT_EQ(late.key_time(late.elapsed(1714564800.0 + part)), Time(1714564800.0 + part));
  }
  const Time nanoseconds = *parse_long_time("1714564800.123456789", 1714564800.123456789);
  EXPECT_EQ(late.elapsed(nanoseconds), early.elapsed(0.123456789));
  EXPECT_EQ(late.key_time(late.elapsed(nanoseconds)), nanoseconds);
}

TEST(FrameTimes, elapsed_times_of_decimals_depend_on_their_differences_alone) {
  std::mt19937_64 random(20240301);
  const auto time_of = [](std::int64_t units, int decimals) {  // by its text
    const std::string text = fmt::format("{}e-{}", units, decimals);
    const double nearest = std::strtod(text.c_str(), nullptr);
    return parse_long_time(text, nearest).value_or(Time(nearest));
  };
  // Below which number they are, about a fourth of them negative; the most decimals leave them below 2^63.
  constexpr std::array<std::pair<std::int64_t, int>, 3> kinds{{{2'300'000'000, 6}, {10, 9}, {4'200'000'000'000, 6}}};
  for (std::size_t i = 0; i < 20'000; ++i) {
    const std::int64_t most = kinds[i % kinds.size()].first;
    const int most_decimals = kinds[i % kinds.size()].second;
    const auto decimals = static_cast<int>(random() % (static_cast<unsigned>(most_decimals) + 1));
    std::int64_t unit = 1;
    for (int k = 0; k < decimals; ++k) unit *= 10;
    const auto number = [&] {
      return static_cast<std::int64_t>(random() % std::uint64_t(most * unit)) - most / 4 * unit;
    };
    const std::int64_t origin = number(), units = number();
    const Time elapsed = FrameTimes::decimals().from(time_of(origin, decimals)).elapsed(time_of(units, decimals));
    const Rational exact = Rational(units - origin) / Rational(unit);
    EXPECT_LE(abs(value(elapsed) - exact), abs(exact) * Rational(0x1p-99)) << units << ' ' << origin << ' ' << decimals;
    const Time early = FrameTimes::decimals().from(0.0).elapsed(time_of(units - origin, decimals));
    EXPECT_EQ(elapsed, early) << units << ' ' << origin << ' ' << decimals;
  }
}

TEST(FrameTimes, times_between_frames_are_doubles) {
  const FrameTimes frames = FrameTimes(ntsc_rate).from(nearest_double(Rational(107892) / ntsc_rate));
  const Time between = 3600.123456789;
  EXPECT_FALSE(frames.exact(between));
  EXPECT_LE(abs(value(frames.elapsed(between)) - (Rational(3600.123456789) - Rational(107892) / ntsc_rate)),
            Rational(0x1p-80));
  EXPECT_EQ(frames.time(frames.elapsed(between)), between);
}

TEST(FrameTimes, a_rate_with_too_many_digits_has_doubles) {
  const FrameTimes frames(Rational(std::int64_t{1} << 50, 3));
  EXPECT_FALSE(frames.exact(Time(1.0)));
  EXPECT_EQ(frames.elapsed(Time(1.5)), Time(1.5));
  EXPECT_EQ(frames.from(1.5).elapsed(Time(1.5)), Time(1.5));
}

}  // namespace
}  // namespace tcb
