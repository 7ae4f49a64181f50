// Extrapolation: the time on the curve for a time outside it.
#include "sample/extrapolation.hpp"

#include <gtest/gtest.h>

namespace tcb {
namespace {

TEST(Extrapolation, maps_times_onto_the_curve) {
  const auto on_curve = [](Extrapolation kind, double t) {
    return map_to_curve<double>({kind, kind}, 10.0, 14.0, t).t.hi;
  };
  for (const auto& named : extrapolations) EXPECT_EQ(on_curve(named.value, 13), 13) << named.name;
  EXPECT_EQ(on_curve(Extrapolation::hold, 3), 10);
  EXPECT_EQ(on_curve(Extrapolation::hold, 33), 14);
  EXPECT_EQ(on_curve(Extrapolation::repeat, 15), 11);
  EXPECT_EQ(on_curve(Extrapolation::repeat, 9), 13);
  EXPECT_EQ(on_curve(Extrapolation::repeat, -3), 13);
  EXPECT_EQ(on_curve(Extrapolation::oscillate, 15), 13);
  EXPECT_EQ(on_curve(Extrapolation::oscillate, 19), 11);
  EXPECT_EQ(on_curve(Extrapolation::oscillate, 9), 11);
}

TEST(Extrapolation, gives_cycles_distance_and_direction) {
  EXPECT_EQ(map_to_curve<double>({Extrapolation::offset, Extrapolation::offset}, 10.0, 14.0, 23.0).cycles, 3);
  EXPECT_EQ(map_to_curve<double>({Extrapolation::offset, Extrapolation::offset}, 10.0, 14.0, 9.0).cycles, -1);
  EXPECT_EQ(map_to_curve<double>({Extrapolation::linear, Extrapolation::linear}, 10.0, 14.0, 9.0).beyond.hi, -1);
  EXPECT_EQ(map_to_curve<double>({Extrapolation::linear, Extrapolation::linear}, 10.0, 14.0, 16.5).beyond.hi, 2.5);
  EXPECT_TRUE(map_to_curve<double>({Extrapolation::hold, Extrapolation::hold}, 10.0, 14.0, 16.5).holds);
  EXPECT_TRUE(map_to_curve<double>({Extrapolation::oscillate, Extrapolation::oscillate}, 10.0, 14.0, 15.0).backward);
  EXPECT_FALSE(map_to_curve<double>({Extrapolation::oscillate, Extrapolation::oscillate}, 10.0, 14.0, 19.0).backward);
}

}  // namespace
}  // namespace tcb
