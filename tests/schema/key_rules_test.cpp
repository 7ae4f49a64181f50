// Missing cells: common signs of them, and signs that are given.
#include "schema/key_rules.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

TEST(MissingSign, common_signs_have_any_case) {
  for (const char* sign :
       {"",        "NA",      "nan",  "null",    "N/A", "n/a",    "#N/A", "None",     "NONE", "-", "--",          "?",
        "missing", "Missing", "<NA>", "#DIV/0!", "NaT", "1.#IND", "-nan", "-1.#QNAN", "\\N",  ".", "\xE2\x80\x93"}) {
    EXPECT_TRUE(is_missing_sign(sign, {})) << sign;
  }
  for (const char* text : {"0", "-0", "-1", "a", "nanx", "lost", "none of them", " ", "-999", "inf"}) {
    EXPECT_FALSE(is_missing_sign(text, {})) << text;
  }
}

TEST(MissingSign, given_signs_count_as_they_are_and_numbers_by_value) {
  EXPECT_TRUE(is_missing_sign("lost", {"lost", "-999"}));
  EXPECT_TRUE(is_missing_sign("-999", {"lost", "-999"}));
  EXPECT_FALSE(is_missing_sign("Lost", {"lost", "-999"}));
  EXPECT_TRUE(is_missing_sign("-999.0", {"lost", "-999"}));
  EXPECT_FALSE(is_missing_sign("-99.9", {"lost", "-999"}));
}

}  // namespace
}  // namespace tcb
