// A test of a spline in C++: every row of reference.csv against the function below, in place of yours.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

struct Key {
  double time, position, tension, continuity, bias;
};

/// The spline under test: one channel, velocities averaged, the end's neighbour missing (preset gte).
double spline(const std::vector<Key>& keys, double t) {
  std::size_t k = 0;
  while (k + 2 < keys.size() && keys[k + 1].time <= t) ++k;
  const double h = keys[k + 1].time - keys[k].time, u = (t - keys[k].time) / h;
  const auto slope = [&](std::size_t i) {
    return (keys[i + 1].position - keys[i].position) / (keys[i + 1].time - keys[i].time);
  };
  const auto tangent = [&](std::size_t i, double side) {  // side 1: outgoing, -1: incoming
    const Key& key = keys[i];
    const double before = i == 0 ? 0 : slope(i - 1), behind = i + 1 == keys.size() ? 0 : slope(i);
    return h * (1 - key.tension) / 2 *
           ((1 + side * key.continuity) * (1 + key.bias) * before +
            (1 - side * key.continuity) * (1 - key.bias) * behind);
  };
  const double p0 = keys[k].position, p1 = keys[k + 1].position, m0 = tangent(k, 1), m1 = tangent(k + 1, -1);
  return p0 + u * (m0 + u * (3 * (p1 - p0) - 2 * m0 - m1 + u * (2 * (p0 - p1) + m0 + m1)));
}

/// The rows of numbers of a CSV file; lines of provenance and names are passed over.
std::vector<std::vector<double>> rows(const char* path) {
  std::vector<std::vector<double>> all;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.find_first_not_of("0123456789.,-+e") != std::string::npos) continue;
    all.emplace_back();
    for (std::size_t at = 0, size = 0; at <= line.size(); at += size + 1) {
      all.back().push_back(std::stod(line.substr(at), &size));
    }
  }
  return all;
}

int main() {
  const auto keys = rows("keys.csv"), reference = rows("reference.csv");
  double largest = 0;
  for (std::size_t channel = 1; channel <= 2; ++channel) {
    std::vector<Key> curve;
    for (const auto& key : keys) curve.push_back({key[0], key[channel], key[3], key[4], key[5]});
    for (const auto& row : reference) {
      const double error = std::abs(spline(curve, row[0]) - row[channel]);
      if (!(error <= largest)) largest = error;
      if (error <= 1e-14) continue;
      std::printf("time %.17g, channel %zu: %.17g; expected %.17g\n", row[0], channel, spline(curve, row[0]),
                  row[channel]);
      return 1;
    }
  }
  std::printf("%zu rows, no error above 1e-14\n", reference.size());
  return reference.empty() || largest > 1e-14 ? 1 : 0;
}
