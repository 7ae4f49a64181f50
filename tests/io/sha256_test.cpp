// SHA-256: the examples of the standard, and bytes in parts.
#include "io/sha256.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

// Source: FIPS 180-4, examples by NIST.
constexpr const char* abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* nothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";

TEST(Sha256, is_that_of_the_standard) {
  Sha256 sha256;
  EXPECT_EQ(sha256.digest(), nothing);
  sha256.add("abc");
  EXPECT_EQ(sha256.digest(), abc);
}

TEST(Sha256, takes_bytes_in_parts_and_begins_anew) {
  Sha256 sha256;
  for (const char* part : {"a", "", "bc"}) sha256.add(part);
  EXPECT_EQ(sha256.digest(), abc);
  EXPECT_EQ(sha256.digest(), nothing);
}

}  // namespace
}  // namespace tcb
