// Dates: their forms, dates that do not exist, and back again.
#include "numbers/dates.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

constexpr std::int64_t noon = 1'709'208'000;  ///< of 2024-02-29 in UTC

/// The date that is read and written again in its own format; empty if it cannot be.
std::string again(std::string_view text, DateOrder order = DateOrder::ymd) {
  auto format = find_date_format(text);
  if (!format) return {};
  format->order = order;
  const auto seconds = read_date(text, order);
  return seconds ? date_text(*seconds, *format, {}).value_or("") : "";
}

TEST(Dates, have_the_format_of_databases_or_of_iso) {
  for (const char* text : {"2024-02-29T12:00:00Z", "2024-02-29 12:00:00", "2024-02-29 12:00:00.25", "2024-02-29",
                           "2024/02/29 12:00:00", "2024-02-29 12:00:00 UTC", "2024-02-29T12:00:00+01:00",
                           "2024-02-29 12:00:00-0730", "2024-02-29 12:00:00+01", "2024-02-29 12:00:00 +0000"}) {
    EXPECT_EQ(again(text), text);
  }
  EXPECT_EQ(again("2024-02-29 12:00"), "2024-02-29 12:00:00");
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

TEST(Dates, count_seconds_from_1970_in_utc) {
  EXPECT_EQ(read_date("2024-02-29 12:00:00", DateOrder::ymd), Rational(noon));
  EXPECT_EQ(read_date("2024-02-29 12:00:00 UTC", DateOrder::ymd), Rational(noon));
  EXPECT_EQ(read_date("2024-02-29 13:30:00+01:30", DateOrder::ymd), Rational(noon));
  EXPECT_EQ(read_date("2024-02-29 05:00:00.5-0700", DateOrder::ymd), Rational(noon) + Rational(1, 2));
}

TEST(Dates, without_a_time_of_day_are_written_without_midnight) {
  const DateFormat format = *find_date_format("2024-02-29");
  EXPECT_EQ(date_text(Rational(noon), format, {}), "2024-02-29 12:00:00");
  EXPECT_EQ(date_text(Rational(noon + 43'200), format, {}), "2024-03-01");
}

TEST(Dates, have_other_forms_in_no_text) {
  for (const char* text : {"", "2024", "2024-02", "24-02-29", "2024-02/29", "2024-02-29T", "2024-02-29T12",
                           "2024-02-29_12:00:00", "2024-02-29 12:00:00.", "2024-02-29 12:00:00 CET",
                           "2024-02-29 12:00:00+1", "2024-02-29  12:00:00", "1.2.24", "2024-02-29 12:00:00Zx"}) {
    EXPECT_FALSE(find_date_format(text)) << text;
  }
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
