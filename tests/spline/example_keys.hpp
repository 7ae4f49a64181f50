// Keys for the tests of the library: the example of the tabled values, and random ones.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "tcb/spline/window_segments.hpp"

namespace tcb::spline {

using Key = std::array<double, 5>;  // t, x, tension, continuity, bias

inline const std::vector<Key> example{
    {0, 0, .2, -.3, .4}, {1, 2, 0, .5, -.25}, {3, -1, -.5, .25, .5}, {4, 3, .3, -.6, -.2}, {6, 1, .1, .4, .3}};

inline Keys<double> keys_of(const std::vector<Key>& table) {
  Keys<double> keys;
  keys.channels = 1;
  for (const auto& [t, x, tension, continuity, bias] : table) {
    keys.times.emplace_back(t);
    keys.positions.push_back(x);
    keys.tcbs.push_back({tension, continuity, bias});
  }
  return keys;
}

inline double at(const Segments<double>& curve, double t, std::size_t channel = 0) {
  std::size_t i = 0;
  while (i + 1 < curve.size() && curve.times[i + 1].hi <= t) ++i;
  return position(curve[i][channel], TimeMap<double>(curve.times[i], curve.times[i + 1])({t}));
}

inline Keys<double> random_keys(std::mt19937_64& random, std::size_t count, std::size_t channels) {
  std::uniform_real_distribution<double> place(-10, 10), step(0.01, 3), parameter(-1.5, 1.5);
  Keys<double> keys;
  keys.channels = channels;
  double t = place(random);
  for (std::size_t i = 0; i < count; ++i, t += step(random)) {
    keys.times.emplace_back(t);
    keys.tcbs.push_back({parameter(random), parameter(random), parameter(random)});
    for (std::size_t c = 0; c < channels; ++c) keys.positions.push_back(place(random));
  }
  return keys;
}

}  // namespace tcb::spline
