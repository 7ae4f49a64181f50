// Notations of times: every form, times that do not exist, and back again for every frame of a day.
#include "numbers/time_notation.hpp"

#include <gtest/gtest.h>

#include "numbers/dates.hpp"

namespace tcb {
namespace {

using enum TimeNotation;

const Rational ntsc(30000, 1001);

std::optional<Rational> read(std::string_view text, const Rational& rate = 24) {
  const auto notation = find_notation(text);
  return notation ? read_time(text, *notation, rate) : std::nullopt;
}

/// The text of a time; empty where it has none.
std::string words(const Rational& seconds, TimeNotation notation, const Rational& rate,
                  std::optional<int> decimals = {}) {
  return TimeWords(notation, rate, decimals).text(nearest_time(seconds)).value_or("");
}

TEST(TimeNotation, is_found_by_the_form) {
  EXPECT_EQ(find_notation("1:02:03"), clock);
  EXPECT_EQ(find_notation("01:02:03.25"), clock);
  EXPECT_EQ(find_notation("01:02:03:04"), smpte);
  EXPECT_EQ(find_notation("01:02:03;04"), drop_frame);
  EXPECT_EQ(find_notation("2024-02-29T12:00:00Z"), zoned_date);
  EXPECT_EQ(find_notation("2024-02-29T12:00:00.5-07:30"), zoned_date);
  EXPECT_EQ(find_notation("2024-02-29 12:00:00"), date);
  EXPECT_EQ(find_notation("90:05.5"), clock);
  EXPECT_EQ(find_notation("0 days 00:00:01.5"), clock);
  EXPECT_EQ(find_notation("1 day, 0:00:01"), clock);
  EXPECT_EQ(find_notation("01:02:03:04.541"), smpte);
  for (const char* text : {"", "12", "1:2:3", "01:2", "01:02:03.", "2024-02-29T", "a", "01:02:03:4", "-01:02:03"}) {
    EXPECT_FALSE(find_notation(text)) << text;
  }
}

TEST(TimeNotation, has_exact_seconds) {
  EXPECT_EQ(read("01:02:03.25"), Rational(14893, 4));
  EXPECT_EQ(read("00:00:01:12"), Rational(3, 2));
  EXPECT_EQ(read("00:00:01:12.6"), Rational(3, 2) + Rational(1, 40));
  EXPECT_EQ(read("1:02"), Rational(62));
  EXPECT_EQ(read("90:05.5"), Rational(10811, 2));
  EXPECT_EQ(read("2 days 00:00:01.5"), Rational(345603, 2));
  EXPECT_EQ(read("1 day, 0:00:01"), Rational(86401));
  EXPECT_EQ(read("00:01:00;02", ntsc), Rational(1800) / ntsc);
  EXPECT_EQ(read("00:10:00;00", ntsc), Rational(17982) / ntsc);
  EXPECT_EQ(read("1970-01-01T00:00:00Z"), Rational(0));
  EXPECT_EQ(read("2024-02-29T12:00:00.5Z"), Rational(1709208000) + Rational(1, 2));
  EXPECT_EQ(read("2024-02-29T12:00:00+01:30"), Rational(1709202600));
  EXPECT_EQ(read("1969-12-31T23:59:59.75Z"), Rational(-1, 4));
}

TEST(TimeNotation, refuses_times_that_do_not_exist) {
  for (const char* text :
       {"00:60:00", "00:00:60", "00:00:00:24", "00:60:00:00", "2023-02-29T00:00:00Z", "2024-13-01T00:00:00Z",
        "2024-01-01T24:00:00Z", "2024-01-01T00:00:60Z", "2024-01-01T00:00:00+24:00", "00:00:00;00"}) {
    EXPECT_FALSE(read(text)) << text;
  }
  EXPECT_FALSE(read("00:01:00;00", ntsc)) << "dropped";
  EXPECT_FALSE(read("00:01:00;01", ntsc)) << "dropped";
  EXPECT_FALSE(read("00:00:00;00", Rational(24000, 1001))) << "nothing is dropped at that rate";
  EXPECT_FALSE(read("00:01:00;03", Rational(60000, 1001))) << "four numbers are dropped";
  EXPECT_TRUE(read("00:01:00;04", Rational(60000, 1001)));
}

TEST(TimeNotation, timecode_of_every_frame_of_a_day_comes_back) {
  const std::pair<Rational, TimeNotation> all[] = {
      {24, smpte},   {25, smpte},        {Rational(24000, 1001), smpte},
      {ntsc, smpte}, {ntsc, drop_frame}, {Rational(60000, 1001), drop_frame}};
  for (const auto& [rate, notation] : all) {
    std::string before;
    const std::uint64_t frames = whole_number(floor(rate * 86'400));
    for (std::uint64_t frame = 0; frame < frames; frame += 1 + frame % 89) {
      const std::string text = words(Rational(frame) / rate, notation, rate);
      ASSERT_LT(before, text) << frame;
      ASSERT_EQ(read_time(text, notation, rate), Rational(frame) / rate) << text;
      before = text;
    }
  }
}

TEST(TimeNotation, drop_frame_timecode_keeps_up_with_the_clock) {
  EXPECT_EQ(words(Rational(1800) / ntsc, drop_frame, ntsc), "00:01:00;02");
  EXPECT_EQ(words(Rational(17981) / ntsc, drop_frame, ntsc), "00:09:59;29");
  EXPECT_EQ(words(Rational(17982) / ntsc, drop_frame, ntsc), "00:10:00;00");
  EXPECT_EQ(words(Rational(107892) / ntsc, drop_frame, ntsc), "01:00:00;00");
  EXPECT_EQ(words(Rational(107892) / ntsc, smpte, ntsc), "00:59:56:12");
}

TEST(TimeNotation, words_have_the_decimals_of_the_time_or_those_asked_for) {
  EXPECT_EQ(words(Rational(14893, 4), clock, 1), "01:02:03.25");
  EXPECT_EQ(words(Rational(14893, 4), clock, 1, 3), "01:02:03.250");
  EXPECT_EQ(words(Rational(119999, 1000), clock, 1, 2), "00:02:00.00");
  EXPECT_EQ(words(Rational(-3, 2), clock, 1), "-00:00:01.5");
  EXPECT_EQ(words(Rational(-1, 4), clock, 1, 0), "00:00:00");
  EXPECT_EQ(words(Rational(-1, 4), zoned_date, 1, 1), "1969-12-31T23:59:59.8Z");
  EXPECT_EQ(words(Rational(-1e-60), zoned_date, 1), "1969-12-31T23:59:59." + std::string(60, '9') + "Z");
  EXPECT_EQ(words(360'000, clock, 1), "100:00:00");
  EXPECT_EQ(words(Rational(1e40), clock, 1), "");
  EXPECT_EQ(words(Rational(-1, 4), zoned_date, 1), "1969-12-31T23:59:59.75Z");
  EXPECT_EQ(words(1709208000, zoned_date, 1), "2024-02-29T12:00:00Z");
}

TEST(TimeNotation, times_between_frames_have_no_timecode) {
  EXPECT_EQ(words(Rational(1, 3), smpte, 24), "00:00:00:08");
  EXPECT_EQ(words(Rational(1, 5), smpte, 24), "");
  EXPECT_EQ(words(-1, smpte, 24), "");
}

TEST(TimeNotation, a_time_that_was_rounded_once_is_at_its_frame) {
  for (const Rational& rate : {Rational(24), ntsc, Rational(24000, 1001)}) {
    for (std::int64_t frame = 0; frame < 200000; frame += frame < 1000 ? 1 : 997) {
      ASSERT_EQ(whole_frame(exact_time(nearest_time(Rational(frame) / rate)), rate), Rational(frame));
    }
    EXPECT_EQ(whole_frame(Rational(31, 2) / rate, rate), std::nullopt);
  }
}

TEST(TimeNotation, a_fraction_may_follow_a_comma) {
  EXPECT_EQ(read_time("00:00:01,25", TimeNotation::clock, 1), Rational(5, 4));
  EXPECT_EQ(read_time("1970-01-01 00:00:01,5", TimeNotation::date, 1), Rational(3, 2));
  EXPECT_EQ(read_time("00:01,5", TimeNotation::clock, 1), Rational(3, 2));
  EXPECT_FALSE(find_notation("00,5")) << "a number";
}

TEST(TimeNotation, a_day_of_timecode_has_the_frames_that_are_not_dropped) {
  const Rational rate(30000, 1001);
  EXPECT_EQ(day_of(TimeNotation::clock, 1), Rational(86400));
  EXPECT_EQ(*day_of(TimeNotation::smpte, rate) * rate, Rational(2592000));
  EXPECT_EQ(*day_of(TimeNotation::drop_frame, rate) * rate, Rational(2589408));
  EXPECT_FALSE(day_of(TimeNotation::seconds, 1));
}

}  // namespace
}  // namespace tcb
