// Positions of a cubic track of Godot 4, by the formula of its documentation and source,
// Math::cubic_interpolate_in_time: the pyramid of Barry and Goldman over four keys. At an end the end key stands for
// the missing one, and where two keys have the same time the pyramid takes its inner key.
#include "curve.hpp"

int main() {
  const Curve curve = read_curve();
  for (const Key& key : curve.keys) {
    if (key.tension != 0 || key.continuity != 0 || key.bias != 0) return unsupported;
  }
  if (curve.closed) return unsupported;
  const auto between = [](const Key& a, const Key& b, double time, bool takes_second) {
    const double part = a.time == b.time ? (takes_second ? 1 : 0) : (time - a.time) / (b.time - a.time);
    return a.position + (b.position - a.position) * part;
  };
  for (const double time : curve.times) {
    std::size_t i = 0;
    while (i + 2 < curve.keys.size() && curve.keys[i + 1].time <= time) ++i;
    const Key &p1 = curve.keys[i], &p2 = curve.keys[i + 1];
    const Key &p0 = i == 0 ? p1 : curve.keys[i - 1], &p3 = i + 2 < curve.keys.size() ? curve.keys[i + 2] : p2;
    const double a1 = between(p0, p1, time, true), a2 = between(p1, p2, time, true), a3 = between(p2, p3, time, true);
    const auto at = [](double from, double position) { return Key{from, position, 0, 0, 0}; };
    const double b1 = between(at(p0.time, a1), at(p2.time, a2), time, false);
    const double b2 = between(at(p1.time, a2), at(p3.time, a3), time, true);
    std::cout << between(at(p1.time, b1), at(p2.time, b2), time, true) << '\n';
  }
}
