// Keys: append, and entries that all keys share.
#include "tcb/spline/keys.hpp"

#include <gtest/gtest.h>

#include "example_keys.hpp"

namespace tcb::spline {
namespace {

TEST(Keys, append_copies_a_range_of_keys) {
  Keys<double> from = keys_of(example);
  from.eases.assign(5, {0.25, 0.5});
  from.eases[3].in = 1;
  Keys<double> to;
  append(to, from, 1, 2);
  append(to, from, 3, 5);
  append(to, from, 2, 2);
  ASSERT_EQ(to.size(), 3U);
  EXPECT_EQ(to.channels, 1U);
  EXPECT_EQ(to.times[1].hi, 4);
  EXPECT_EQ(to.position(2)[0], 1);
  EXPECT_EQ(to.tcb(0), from.tcb(1));
  EXPECT_EQ(to.eases[1].in, 1);
}

TEST(Keys, without_entries_all_have_the_common_parameters) {
  Keys<double> keys;
  keys.times = {0.0, 1.0};
  keys.common_tcb = {0.5, 0, -1};
  EXPECT_EQ(keys.tcb(0), keys.tcb(1));
  EXPECT_EQ(keys.tcb(1).bias, -1);
}

}  // namespace
}  // namespace tcb::spline
