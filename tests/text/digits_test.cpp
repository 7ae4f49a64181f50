// Eight digits at a time: the same as digit by digit.
#include "text/digits.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcb {
namespace {

std::string eight(std::uint64_t n) {
  const std::string digits = std::to_string(n);
  return std::string(8 - digits.size(), '0') + digits;
}

TEST(Digits, eight_digits_make_a_text_and_a_number) {
  for (std::uint64_t n = 0; n < 100'000'000; n = n < 200'000 ? n + 1 : n + 997) {
    const std::uint64_t digits = eight_digits(n);
    ASSERT_EQ(load<std::uint64_t>(eight(n).data()), digits | eight_zeros);
    ASSERT_EQ(number_of(digits), n);
    ASSERT_TRUE(are_digits(digits));
  }
  EXPECT_EQ(number_of(eight_digits(99'999'999)), 99'999'999U);
}

TEST(Digits, any_other_character_among_them_is_seen) {
  for (int place = 0; place < 8; ++place) {
    for (int c = 0; c < 256; ++c) {
      for (const char* rest : {"00000000", "99999999"}) {
        std::string text = rest;
        text[static_cast<std::size_t>(place)] = static_cast<char>(c);
        ASSERT_EQ(are_digits(load<std::uint64_t>(text.data()) ^ eight_zeros), c >= '0' && c <= '9')
            << place << ' ' << c;
      }
    }
  }
}

TEST(Digits, bytes_are_stored_in_order) {
  std::string text = "abcdefgh";
  store(text.data(), std::uint16_t{0x3130});
  EXPECT_EQ(text, "01cdefgh");
}

TEST(Digits, one_of_two_is_chosen) {
  EXPECT_EQ(choose(true, 1, 2), 1U);
  EXPECT_EQ(choose(false, 1, 2), 2U);
}

}  // namespace
}  // namespace tcb
