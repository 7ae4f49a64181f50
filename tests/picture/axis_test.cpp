// Axis: bases, ticks and their texts.
#include "picture/axis.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace tcb {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts(const Axis& axis, double most) {
  std::vector<std::string> all;
  for (const Tick& tick : axis.ticks(most)) all.push_back(tick.text);
  return all;
}

Interval interval(double low, double high) { return {Time(low), Time(high)}; }

TEST(Axis, ticks_are_round_numbers) {
  EXPECT_THAT(texts(Axis(interval(0, 13), 0), 8), ElementsAre("0", "2", "4", "6", "8", "10", "12"));
  EXPECT_THAT(texts(Axis(interval(-0.12, 0.31), 0), 6), ElementsAre("-0.1", "0", "0.1", "0.2", "0.3"));
  EXPECT_THAT(texts(Axis(interval(0, 4e9), 0), 3), ElementsAre("0", "2G", "4G"));
  EXPECT_THAT(texts(Axis(interval(2e-9, 7e-9), 0), 3), ElementsAre("2e-9", "4e-9", "6e-9"));
}

TEST(Axis, two_ticks_tell_the_scale_of_the_shortest_axis) {
  for (const double high : {1.0, 1.9, 3.0, 4.5, 9.9})
    EXPECT_EQ(Axis(interval(0.4, high), 0).ticks(2).size(), 2U) << high;
}

TEST(Axis, ticks_are_within_the_axis_and_not_too_many) {
  for (const double size : {1e-7, 0.3, 1.0, 7.5, 86400.0, 3e12}) {
    const Axis axis(interval(-size / 3, size), 0.05);
    for (double most = 2; most < 12; ++most) {
      const auto ticks = axis.ticks(most);
      EXPECT_LE(ticks.size(), most);
      EXPECT_GE(ticks.front().value, axis.low() - 1e-6 * size);
      EXPECT_LE(ticks.back().value, axis.low() + axis.length() + 1e-6 * size);
    }
  }
}

TEST(Axis, equal_digits_are_in_the_title) {
  const Axis nanoseconds({Time(1731931200000000000.0), Time(1731931208560000000.0)}, 0);
  EXPECT_EQ(nanoseconds.title("t"), "t − 1731931200000000000");
  EXPECT_THAT(texts(nanoseconds, 5), ElementsAre("0", "2G", "4G", "6G", "8G"));
  EXPECT_EQ(Axis(interval(-2000000000.5, -1999999999.5), 0).title("y [m]"), "y [m] + 2000000001");
  EXPECT_EQ(Axis(interval(5, 7), 0).title("x"), "x");
}

TEST(Axis, a_single_number_is_in_its_middle) {
  EXPECT_THAT(texts(Axis(interval(5, 5), 0), 6), testing::Contains("5"));
  EXPECT_GT(Axis(interval(0, 0), 0).length(), 0);
}

TEST(Axis, numbers_at_the_ends_of_the_range_of_doubles_have_ticks) {
  EXPECT_THAT(texts(Axis(interval(0, 3e-310), 0), 4), ElementsAre("0", "1e-310", "2e-310", "3e-310"));
  EXPECT_THAT(texts(Axis(interval(0, 1e-323), 0), 3), ElementsAre("0", "5e-324"));  // 1e-323 is 9.88e-324
  EXPECT_THAT(texts(Axis(interval(0, 1.5e308), 0.06), 3), ElementsAre("0", "1e308"));
  EXPECT_THAT(texts(Axis(interval(1.7e308, 1.7e308), 0.06), 3), ElementsAre("1e308", "2e308"));
  const Axis near_one(interval(1e308, 1.0000001e308), 0);
  EXPECT_EQ(near_one.title("x"), "x − 1e308");
  EXPECT_THAT(texts(near_one, 3), ElementsAre("0", "5e300", "1e301"));
  const Axis lowest({Time(-1.7976931348623157e308), Time(-1.7976e308)}, 0);
  EXPECT_TRUE(std::isfinite(lowest.low()) && std::isfinite(lowest.length()));
  EXPECT_EQ(Axis(interval(0, 1e-310), 0.05, 1.0).length(), 2e-200);  // beside an axis of length 1
}

TEST(Axis, whole_numbers_become_decimals) {
  EXPECT_EQ(decimal_text("-1", -3), "-0.001");
  EXPECT_EQ(decimal_text("25", -1), "2.5");
  EXPECT_EQ(decimal_text("25", 2), "2500");
  EXPECT_EQ(decimal_text("0", -2), "0");
}

/// An axis of times in seconds in a notation.
Axis times(double low, double high, TimeNotation notation, const DateFormat& dates = {}) {
  return {interval(low, high), TimeScale{notation, 25, dates}};
}

TEST(Axis, dates_of_one_day_are_in_the_title) {
  const Axis axis = times(1709287200, 1709292600, TimeNotation::zoned_date);  // 2024-03-01 10:00 to 11:30
  EXPECT_EQ(axis.title("time"), "time, 2024-03-01");
  EXPECT_THAT(texts(axis, 7), ElementsAre("10:00", "10:15", "10:30", "10:45", "11:00", "11:15", "11:30"));
  EXPECT_EQ(axis.ticks(7)[1].value - axis.low(), 900);
}

TEST(Axis, days_begin_in_the_zone_of_the_dates) {
  const DateFormat dates{.before_clock = ' ', .zone = "+01:00"};
  const Axis axis = times(1709247600, 1709420400, TimeNotation::zoned_date, dates);  // midnight, two days
  EXPECT_THAT(texts(axis, 3), ElementsAre("2024-03-01", "2024-03-02", "2024-03-03"));
  EXPECT_THAT(texts(axis, 5), ElementsAre("2024-03-01 00:00", "2024-03-01 12:00", "2024-03-02 00:00",
                                          "2024-03-02 12:00", "2024-03-03 00:00"));
}

TEST(Axis, months_begin_at_their_first_day) {
  const Axis axis = times(1704844800, 1727654400, TimeNotation::zoned_date);  // 2024-01-10 to 2024-09-30
  EXPECT_THAT(texts(axis, 5), ElementsAre("2024-03-01", "2024-05-01", "2024-07-01", "2024-09-01"));
}

TEST(Axis, ticks_are_multiples_of_one_step) {
  EXPECT_THAT(texts(Axis(interval(0.4, 9.9), 0), 3), ElementsAre("4", "8"));
  EXPECT_THAT(texts(Axis(interval(0, 1.8e6), 0), 4), ElementsAre("0", "500k", "1M", "1.5M"));
}

TEST(Axis, timecode_and_clock_times_have_round_ticks) {
  EXPECT_THAT(texts(times(3600, 3601, TimeNotation::smpte), 6),
              ElementsAre("01:00:00:00", "01:00:00:05", "01:00:00:10", "01:00:00:15", "01:00:00:20", "01:00:01:00"));
  EXPECT_THAT(texts(times(59.5, 60.5, TimeNotation::clock), 3), ElementsAre("00:00:59.5", "00:01:00", "00:01:00.5"));
}

TEST(Axis, large_times_are_seconds_after_the_first) {
  TimeScale scale;
  scale.units_per_second = 1'000'000'000;
  const Axis axis({Time(1731931200000000000.0), Time(1731931208560000000.0)}, scale);
  EXPECT_EQ(axis.title("t"), "t, seconds after 1731931200");
  EXPECT_THAT(texts(axis, 5), ElementsAre("0", "2", "4", "6", "8"));
  EXPECT_EQ(axis.from_base(Time(1731931201000000000.0)), 1);
  EXPECT_EQ(Axis(interval(0, 3e9), scale).title("t"), "t, seconds");
}

TEST(Axis, any_times_have_two_ticks_or_more) {
  for (const TimeNotation notation : {TimeNotation::clock, TimeNotation::smpte, TimeNotation::zoned_date}) {
    for (const double size : {0.0, 1e-7, 0.04, 1.0, 61.0, 5000.0, 86400.0, 1e6, 3e8, 2e9}) {
      for (double most = 2; most < 9; ++most) {
        EXPECT_GE(times(86399.5, 86399.5 + size, notation).ticks(most).size(), 2U) << size << " " << most;
      }
    }
  }
}

}  // namespace
}  // namespace tcb
