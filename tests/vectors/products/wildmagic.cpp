// Positions of Wild Magic's TCBSpline3.
#include "Wm5TCBSpline3.h"
#include "curve.hpp"

int main() {
  const Curve curve = read_curve();
  const int n = static_cast<int>(curve.keys.size());
  if (curve.closed || n < 4) return unsupported;
  auto *times = new double[n], *tension = new double[n], *continuity = new double[n], *bias = new double[n];
  auto* points = new Wm5::Vector3<double>[n];
  for (int i = 0; i < n; ++i) {
    const Key& key = curve.keys[i];
    times[i] = key.time, tension[i] = key.tension, continuity[i] = key.continuity, bias[i] = key.bias;
    points[i] = Wm5::Vector3<double>(key.position, 0, 0);
  }
  const Wm5::TCBSpline3<double> spline(n - 1, times, points, tension, continuity, bias);
  for (const double time : curve.times) std::cout << spline.GetPosition(time)[0] << '\n';
}
