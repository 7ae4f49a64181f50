// Dates: their forms, dates that do not exist, and back again.
#include "numbers/dates.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

namespace tcb {
namespace {

constexpr std::int64_t noon = 1'709'208'000;  ///< of 2024-02-29 in UTC

/// The date at a time; empty where there is none.
std::string date_text(const Rational& seconds, const DateFormat& format) {
  return TimeWords(TimeNotation::date, 1, {}, format).text(nearest_time(seconds, 30)).value_or("");
}

/// The date that is read and written again in its own format; empty if it cannot be.
std::string again(std::string_view text, DateOrder order = DateOrder::ymd) {
  auto format = find_date_format(text);
  if (!format) return {};
  format->order = order;
  const auto seconds = read_date(text, order);
  return seconds ? date_text(*seconds, *format) : "";
}

TEST(Dates, have_the_format_of_databases_or_of_iso) {
  for (const char* text : {"2024-02-29T12:00:00Z", "2024-02-29 12:00:00", "2024-02-29 12:00:00.25", "2024-02-29",
                           "2024/02/29 12:00:00", "2024-02-29 12:00:00 UTC", "2024-02-29T12:00:00+01:00",
                           "2024-02-29 12:00:00-0730", "2024-02-29 12:00:00+01", "2024-02-29 12:00:00 +0000"}) {
    EXPECT_EQ(again(text), text);
  }
  EXPECT_EQ(again("2024-02-29 12:00"), "2024-02-29 12:00:00");
}

TEST(Dates, have_times_of_day_with_am_or_pm) {
  for (const char* text : {"2024-02-29 12:00:00 AM", "2024-02-29 12:59:59.5 PM", "2024-02-29 01:00:00pm",
                           "2024-02-29 11:30:00a", "2024-02-29 11:30:00 p.m.", "2024-02-29 07:00:00 PM UTC"}) {
    EXPECT_EQ(again(text), text);
  }
  EXPECT_EQ(again("5/1/2021 1:05:00 PM", DateOrder::mdy), "5/1/2021 1:05:00 PM");
  EXPECT_EQ(read_date("2024-02-29 12:00 AM", DateOrder::ymd), noon - 43'200);
  EXPECT_EQ(read_date("2024-02-29 12:00 PM", DateOrder::ymd), noon);
  for (const char* text : {"2024-02-29 00:30 AM", "2024-02-29 13:00 PM"}) EXPECT_FALSE(read_date(text, DateOrder::ymd));
  for (const char* text : {"2024-02-29 11:30 XM", "2024-02-29 11:30 PMs"}) EXPECT_FALSE(find_date_format(text));
  EXPECT_EQ(half_of_day("11:30a"), "a");
  EXPECT_EQ(half_of_day("0 days 11:30"), "");
}

TEST(Dates, have_months_as_names) {
  for (const char* text :
       {"29 Feb 2024", "29-FEB-2024 12:00:00", "2024-Feb-29 12:00:00.5", "29feb2024", "01 March 2024"}) {
    EXPECT_EQ(again(text, find_date_format(text)->order), text);
    EXPECT_EQ(read_date(text, DateOrder::mdy), read_date(text, DateOrder::ymd));
  }
  EXPECT_EQ(read_date("01-Mar-2024", DateOrder::dmy), read_date("2024-03-01", DateOrder::ymd));
  EXPECT_EQ(date_text(noon + 86'400, *find_date_format("29-FEB-2024")), "01-MAR-2024 12:00:00");
  for (const char* text : {"30-Feb-2024", "29-Fex-2024", "29 2 2024", "2922024", "Feb-29-2024", "29Feb-2024"}) {
    EXPECT_FALSE(read_date(text, DateOrder::dmy)) << text;
  }
}

TEST(Dates, with_the_year_last_have_the_order_that_is_requested) {
  EXPECT_EQ(find_date_format("01.02.2024 12:00")->order, DateOrder::dmy);
  EXPECT_EQ(again("29.02.2024 12:00:00", DateOrder::dmy), "29.02.2024 12:00:00");
  EXPECT_EQ(again("2/29/2024 8:05:00", DateOrder::mdy), "2/29/2024 8:05:00");
  EXPECT_EQ(again("02/29/2024", DateOrder::dmy), "") << "there is no month 29";
  EXPECT_EQ(read_date("01.02.2024", DateOrder::dmy), read_date("2024-02-01", DateOrder::ymd));
  EXPECT_EQ(read_date("01.02.2024", DateOrder::mdy), read_date("2024-01-02", DateOrder::ymd));
  EXPECT_FALSE(read_date("01.02.2024", DateOrder::ymd));
}

TEST(Dates, with_years_of_two_digits_have_the_order_that_is_requested) {
  EXPECT_TRUE(find_date_format("29.02.24")->needs_order());
  EXPECT_TRUE(find_date_format("29-Feb-24")->needs_order());
  for (const auto& [text, order] :
       std::vector<std::pair<const char*, DateOrder>>{{"29.02.24 12:00", DateOrder::dmy},
                                                      {"2/29/24 12:00", DateOrder::mdy},
                                                      {"24-02-29 12:00", DateOrder::ymd},
                                                      {"29-Feb-24 12:00", DateOrder::dmy},
                                                      {"24-Feb-29 12:00", DateOrder::ymd}}) {
    EXPECT_EQ(read_date(text, order), Rational(noon)) << text;
  }
  EXPECT_EQ(read_date("01.01.69", DateOrder::dmy), read_date("1969-01-01", DateOrder::ymd));
  EXPECT_EQ(read_date("01.01.68", DateOrder::dmy), read_date("2068-01-01", DateOrder::ymd));
  EXPECT_EQ(read_date("1.2.24", DateOrder::ymd), std::nullopt) << "the year has two digits";
  EXPECT_EQ(date_text(Rational(noon), *find_date_format("29.02.24")), "29.02.2024 12:00:00");
}

TEST(Dates, count_seconds_from_1970_in_utc) {
  EXPECT_EQ(read_date("2024-02-29 12:00:00", DateOrder::ymd), Rational(noon));
  EXPECT_EQ(read_date("2024-02-29 12:00:00 UTC", DateOrder::ymd), Rational(noon));
  EXPECT_EQ(read_date("2024-02-29 13:30:00+01:30", DateOrder::ymd), Rational(noon));
  EXPECT_EQ(read_date("2024-02-29 05:00:00.5-0700", DateOrder::ymd), Rational(noon) + Rational(1, 2));
}

TEST(Dates, without_a_time_of_day_are_written_without_midnight) {
  const DateFormat format = *find_date_format("2024-02-29");
  EXPECT_EQ(date_text(Rational(noon), format), "2024-02-29 12:00:00");
  EXPECT_EQ(date_text(Rational(noon + 43'200), format), "2024-03-01");
}

TEST(Dates, have_other_forms_in_no_text) {
  for (const char* text : {"", "2024", "2024-02", "4-02-9", "2024-02/29", "2024-02-29T", "2024-02-29T12",
                           "2024-02-29_12:00:00", "2024-02-29 12:00:00.", "2024-02-29 12:00:00 CET",
                           "2024-02-29 12:00:00+1", "2024-02-29  12:00:00", "1.2.4", "2024-02-29 12:00:00Zx"}) {
    EXPECT_FALSE(find_date_format(text)) << text;
  }
}

TEST(Dates, of_the_usual_form_have_the_same_seconds) {
  std::mt19937 random(20241126);
  const auto number = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  int read = 0;
  for (int i = 0; i < 20'000; ++i) {
    const DateOrder order = std::array{DateOrder::ymd, DateOrder::dmy, DateOrder::mdy}[static_cast<std::size_t>(i % 3)];
    const std::string day = order == DateOrder::ymd
                                ? fmt::format("{:04}-{:02}-{:02}", number(9999), number(13), number(32))
                                : fmt::format("{:02}.{:02}.{:04}", number(32), number(13), number(9999));
    const std::string fraction = i % 4 == 0 ? fmt::format(".{}", number(999)) : i % 4 == 1 ? "." : "";
    const bool has_zone = i % 2 == 0;
    const std::string text = fmt::format("{}{}{:02}:{:02}:{:02}{}{}", day, i % 5 == 0 ? 'T' : ' ', number(24),
                                         number(60), number(60), fraction, has_zone ? "Z" : "");
    const auto usual = read_usual_date(text, order, has_zone);
    if (!usual) continue;
    ++read;
    const auto part = usual->fraction.empty() ? Rational(0) : *parse_rational("0." + std::string(usual->fraction));
    EXPECT_EQ(read_date(text, order), Rational(usual->seconds) + part) << text;
    EXPECT_EQ(find_date_format(text)->zone.empty(), !has_zone) << text;
  }
  EXPECT_GT(read, 5'000);
  EXPECT_FALSE(read_usual_date("2024-02-29 12:00:00+01:00", DateOrder::ymd, true));
  EXPECT_FALSE(read_usual_date("2024-02-30 12:00:00", DateOrder::ymd, false));
}

TEST(Dates, that_do_not_exist_have_no_seconds) {
  for (const char* text : {"2023-02-29", "2024-13-01", "2024-00-01", "2024-01-01 24:00:00", "2024-01-01 00:00:60",
                           "2024-01-01T00:00:00+24:00"}) {
    EXPECT_TRUE(find_date_format(text)) << text;
    EXPECT_FALSE(read_date(text, DateOrder::ymd)) << text;
  }
}

}  // namespace
}  // namespace tcb
