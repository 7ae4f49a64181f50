// A curve of one channel from standard input: numbers of keys and of times, whether it is closed; keys; times.
#pragma once

#include <iostream>
#include <vector>

struct Key {
  double time, position, tension, continuity, bias;
};

struct Curve {
  std::vector<Key> keys;  ///< of a closed curve, the last is the first again
  std::vector<double> times;
  bool closed = false;
};

inline Curve read_curve() {
  Curve curve;
  std::size_t keys = 0, times = 0;
  std::cin >> keys >> times >> curve.closed;
  curve.keys.resize(keys);
  curve.times.resize(times);
  for (Key& k : curve.keys) std::cin >> k.time >> k.position >> k.tension >> k.continuity >> k.bias;
  for (double& time : curve.times) std::cin >> time;
  std::cout.precision(17);
  return curve;
}

constexpr int unsupported = 3;  ///< the exit code where the product has no such curves
