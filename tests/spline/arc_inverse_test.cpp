// Arc-length inverse: back to the length, near stops, and many lengths at once.
#include "tcb/spline/arc_inverse.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "plane_segments.hpp"

namespace tcb::spline {
namespace {

TEST(ArcInverse, gives_back_the_length) {
  for (const PlaneSegment& curve :
       {parabola, cusp, segment({0, 0}, {1, 0}, {5, 5}, {5, 5}), segment({0, 0}, {0, 0}, {4, 0}, {-4, 0})}) {
    const ArcLength<double> arc(curve, {});
    const double whole = arc.total().value;
    ArcInverse<double> inverse(arc, 0.0, whole);
    for (double s = 0; s <= whole; s += whole / 97) {
      EXPECT_NEAR(arc.to(inverse.at(s)).value, s, 1e-15 * whole);
    }
    EXPECT_EQ(inverse.at(whole).w, 0);
    EXPECT_EQ(inverse.at(0).u, 0);
  }
}

TEST(ArcInverse, does_not_depend_on_earlier_lengths) {
  const ArcLength<double> arc(parabola, {});
  ArcInverse<double> one_by_one(arc, 0.0, arc.total().value);
  for (double s = 1.4; s > 0; s -= 0.1) {
    ArcInverse<double> fresh(arc, 0.0, arc.total().value);
    EXPECT_EQ(one_by_one.at(s).u, fresh.at(s).u);
  }
}

TEST(ArcInverse, separates_places_near_a_flat_minimum_of_the_speed) {
  for (const double slowest : {1e-7, 5e-7, 1e-6, 2e-6, 1e-5}) {  // the root of the least speed, at the start
    const double drift = slowest * slowest;
    const PlaneSegment curve = segment({0, 0}, {1.0 / 3, drift}, {0, drift}, {1, drift});
    const ArcLength<double> arc(curve, {});
    const double whole = arc.total().value;
    ArcInverse<double> inverse(arc, 0.0, whole);
    double before = 0;
    for (double s = whole * 1e-19; s < whole * 1e-14; s *= 2) {
      const double u = inverse.at(s).u;
      EXPECT_GT(u, before) << slowest << " at " << s;
      before = u;
    }
  }
}

TEST(ArcInverse, gives_many_places_the_bits_of_each) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 100; ++i) {
    PlaneSegment curve;
    for (auto& x : curve) x = cubic<double>(uniform(random), uniform(random), uniform(random), uniform(random));
    const ArcLength<double> arc(curve, {});
    const DoubleDouble start(uniform(random)), end = start + DoubleDouble(arc.total().value);
    std::vector<DoubleDouble> lengths;
    for (int row = 0; row <= i % 13; ++row)
      lengths.push_back(start + DoubleDouble(arc.total().value * (uniform(random) + 1) / 2));
    std::vector<LocalParameter<double>> places(lengths.size());
    ArcInverse<double>(arc, start, end).at(lengths, places);
    for (std::size_t row = 0; row < lengths.size(); ++row) {
      const LocalParameter<double> alone = ArcInverse<double>(arc, start, end).at(lengths[row]);
      EXPECT_EQ(places[row].u, alone.u);
      EXPECT_EQ(places[row].w, alone.w);
    }
  }
}

}  // namespace
}  // namespace tcb::spline
