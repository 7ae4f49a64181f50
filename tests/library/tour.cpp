// A program that uses the installed library: a camera goes round a closed tour at constant speed and turns with it,
// from a kept curve, which is compiled once for the program, and from a stream of keys. It prints what is wrong.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <tcb/spline/spline.hpp>

namespace {

using namespace tcb::spline;

int faults = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("wrong: %s\n", what);
  ++faults;
}

/// Places x, y on a circle of radius 2 around the origin, and a turn around z that follows it, at unequal times.
template <class S>
Keys<S> tour() {
  Keys<S> keys;
  keys.channels = 6;
  for (const double turn : {0.0, 0.5, 1.0, 1.75, 2.5, 3.25, 4.0, 5.0, 5.75}) {
    keys.times.emplace_back(static_cast<S>(turn));
    for (const double x : {2 * std::cos(turn), 2 * std::sin(turn), 0.0, 0.0, std::sin(turn / 2), std::cos(turn / 2)}) {
      keys.positions.push_back(static_cast<S>(x));
    }
  }
  return keys;
}

template <class S>
CurveRules<S> rules() {
  CurveRules<S> rules = rules_of<S>(Preset::splines);
  rules.rotations = {{.channels = {2, 3, 4, 5}}};
  return rules;
}

template <class S>
void follow(S tolerance) {
  const S period = static_cast<S>(6.283185307179586);
  const S near = static_cast<S>(0.1);  // of a circle, by nine keys
  const auto curve = Curve<S>::build_closed(tour<S>(), rules<S>(), period);
  if (!curve) return expect(false, curve.error().message().c_str());
  expect(curve->is_closed() && curve->segment_count() == 9, "a segment for each key");
  expect(std::abs(curve->length().value - 2 * period) < near, "the length of the circle");
  for (int part = 0; part < 32; ++part) {
    std::array<S, 6> at{}, later{};
    const S s = curve->length().value * static_cast<S>(part) / 32;
    const S t = curve->at_length(s, at);
    expect(std::abs(std::hypot(at[0], at[1]) - 2) < near, "on the circle");
    expect(std::abs(curve->length_to(t).value - s) < tolerance, "the length to the time of a length");
    curve->position(t + period, later);
    expect(std::abs(later[0] - at[0]) < tolerance, "once more after a period");
    const Quaternion<S> q = curve->rotation(t);
    expect(std::abs(q.w - std::cos(t / 2)) < near, "turned by the angle");
    expect(std::abs(curve->angular_velocity(t)[2] - 1) < near, "turning as the angle grows");
    const Segment<S> segment = curve->segment(curve->find_length(s));
    expect(segment.length_start <= working_t<S>(s) && working_t<S>(s) <= segment.length_end, "found by length");
    expect(curve->segment(curve->find_time(t)).start <= Time<S>(t), "found by time");
  }
}

/// The same curve from a stream of single keys, which measures its segments.
void stream() {
  const Keys<double> keys = tour<double>();
  const auto whole = Curve<double>::build_closed(keys, rules<double>(), 6.5);
  Keys<double> last;
  append(last, keys, keys.size() - 1, keys.size());
  CurveStream<double> stream(last, 6.5);
  Curve<double> kept(rules<double>(), true);
  const auto take = [&](const Window<double>& window) {
    const Segments<double> next = segments(window, rules<double>());
    kept.append(next, lengths_of<double>(next, metric_of(rules<double>(), keys.channels)));
  };
  for (std::size_t key = 0; key < keys.size(); ++key) {
    Keys<double> one;
    append(one, keys, key, key + 1);
    take(stream.push(one));
  }
  take(stream.finish());
  for (double t = -1; t < 8; t += 0.125) {
    std::array<double, 6> a{}, b{};
    whole->position(t, a);
    kept.position(t, b);
    expect(a == b && whole->length_to(t).value == kept.length_to(t).value, "the same from a stream");
    expect(whole->at_length(t) == kept.at_length(t), "the same lengths from a stream");
  }
}

}  // namespace

int main() {
  follow<double>(1e-13);
  follow<float>(1e-4F);
  stream();
  return faults == 0 ? 0 : 1;
}
