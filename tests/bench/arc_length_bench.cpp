// Microbenchmarks of arc length: the length of a segment, and its inverse with 1 to 100 samples on it.
//
// Length/SHAPE/CHANNELS: an item is a segment. Inverse/SHAPE/CHANNELS/SAMPLES: an item is a sample; the setup for the
// samples of a segment is included, the computation of its length is not. Shows items per second, and ns per item.
// Choose some with --benchmark_filter=Inverse/cusped/3.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/window_segments.hpp"

namespace {

using tcb::spline::Cubic;
using Segment = std::vector<Cubic<double>>;  ///< a cubic per channel
using Length = tcb::spline::ArcLength<double>;

// The only two uses of the interface of arc lengths.

/// Sets `length` to a segment, and returns its length.
double measure(Length& length, const Segment& segment) {
  length.assign(segment, {});
  return length.total().value;
}

/// Finds the places of samples at equal lengths; returns the sum of their u, so that the compiler keeps the work.
double find_places(const Length& length, std::int64_t samples) {
  const double total = length.total().value;
  const double step = total / static_cast<double>(samples);
  static std::vector<tcb::spline::DoubleDouble> lengths;
  static std::vector<tcb::spline::LocalParameter<double>> places;
  lengths.clear();
  for (std::int64_t i = 0; i < samples; ++i) lengths.emplace_back((static_cast<double>(i) + 0.5) * step);
  places.resize(lengths.size());
  tcb::spline::ArcInverse<double>(length, 0.0, total).at(lengths, places);
  double sum = 0;
  for (const auto& place : places) sum += place.u;
  return sum;
}

using Random = std::mt19937_64;

/// A number in (-1, 1), the same with every standard library.
double uniform(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; }

/// A channel whose derivative is (u - u0) bend + (u - u0)^2 twist + drift.
Cubic<double> by_derivative(double u0, double bend, double twist, double drift) {
  const auto value = [&](double v) { return v * (drift + v * (bend / 2 + v * twist / 3)); };
  const auto slope = [&](double v) { return drift + v * (bend + v * twist); };
  return tcb::spline::cubic<double>(value(-u0), value(1 - u0), slope(-u0), slope(1 - u0));
}

/// A segment with a place where the speed is `slowest` times the speed elsewhere; 0: a cusp.
Segment cusped(Random& random, std::size_t channels, double slowest) {
  const double u0 = 0.5 + 0.4 * uniform(random);
  Segment segment;
  for (std::size_t c = 0; c < channels; ++c) {
    segment.push_back(by_derivative(u0, uniform(random), uniform(random), slowest * uniform(random)));
  }
  return segment;
}

/// A segment between the middle two of four keys, with the tangents of tension, continuity and bias 0.
Segment between(const std::vector<std::array<double, 4>>& keys) {
  Segment segment;
  for (const auto& [before, from, to, after] : keys) {
    segment.push_back(tcb::spline::cubic<double>(from, to, (to - before) / 2, (after - from) / 2));
  }
  return segment;
}

/// Keys in nearly one direction, like those of a camera.
Segment smooth(Random& random, std::size_t channels) {
  std::vector<std::array<double, 4>> keys(channels);
  for (auto& channel : keys) {
    double velocity = uniform(random);
    double position = uniform(random);
    for (double& key : channel) {
      key = position;
      position += velocity += 0.3 * uniform(random);
    }
  }
  return between(keys);
}

Segment random_keys(Random& random, std::size_t channels) {
  std::vector<std::array<double, 4>> keys(channels);
  for (auto& channel : keys) {
    for (double& key : channel) key = uniform(random);
  }
  return between(keys);
}

/// Two equal keys between others: with tangents that lead out and back in, or with none.
Segment hold(Random& random, std::size_t channels, bool at_rest) {
  Segment segment;
  for (std::size_t c = 0; c < channels; ++c) {
    const double key = uniform(random);
    const double out = at_rest ? 0 : uniform(random);
    const double in = at_rest ? 0 : uniform(random);
    segment.push_back(tcb::spline::cubic<double>(key, key, out, in));
  }
  return segment;
}

/// Faster and faster, or slower and slower, along a line.
Segment straight(Random& random, std::size_t channels) {
  const double growth = 0.9 * uniform(random);
  Segment segment;
  for (std::size_t c = 0; c < channels; ++c) {
    const double direction = uniform(random);
    segment.push_back(by_derivative(0, direction * growth, 0, direction));
  }
  return segment;
}

struct Shape {
  std::string name;
  std::function<Segment(Random&, std::size_t)> make;
};

std::vector<Shape> shapes() {
  const auto nearly = [](double slowest) {
    return [slowest](Random& random, std::size_t channels) { return cusped(random, channels, slowest); };
  };
  const auto held = [](bool at_rest) {
    return [at_rest](Random& random, std::size_t channels) { return hold(random, channels, at_rest); };
  };
  return {{"smooth", smooth},
          {"random", random_keys},
          {"nearly_cusped_1e-3", nearly(1e-3)},
          {"nearly_cusped_1e-8", nearly(1e-8)},
          {"cusped", nearly(0)},
          {"straight", straight},
          {"hold", held(false)},
          {"degenerate", held(true)}};
}

/// So many segments that the processor cannot learn the branches of one pass for the next.
constexpr std::size_t segments_at_once = 512;

std::vector<Segment> make_segments(const Shape& shape, std::size_t channels) {
  Random random(1984);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < segments_at_once; ++i) segments.push_back(shape.make(random, channels));
  return segments;
}

/// Items per second, and nanoseconds per item.
void report_items(benchmark::State& state, std::int64_t items) {
  using benchmark::Counter;
  state.SetItemsProcessed(state.iterations() * items);
  state.counters["s_per_item"] =
      Counter(static_cast<double>(items), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void run_lengths(benchmark::State& state, const Shape& shape, std::size_t channels) {
  const std::vector<Segment> segments = make_segments(shape, channels);
  Length length;
  for (auto _ : state) {
    for (const Segment& segment : segments) benchmark::DoNotOptimize(measure(length, segment));
  }
  report_items(state, segments_at_once);
}

void run_inverses(benchmark::State& state, const Shape& shape, std::size_t channels, std::int64_t samples) {
  const std::vector<Segment> segments = make_segments(shape, channels);
  std::vector<Length> lengths(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) measure(lengths[i], segments[i]);
  for (auto _ : state) {
    for (const Length& length : lengths) benchmark::DoNotOptimize(find_places(length, samples));
  }
  report_items(state, static_cast<std::int64_t>(segments_at_once) * samples);
}

void register_all() {
  for (const Shape& shape : shapes()) {
    for (std::size_t channels = 1; channels <= 6; ++channels) {
      const std::string name = shape.name + "/" + std::to_string(channels);
      benchmark::RegisterBenchmark(("Length/" + name).c_str(), run_lengths, shape, channels);
      for (const std::int64_t samples : {1, 3, 10, 100}) {
        const std::string inverse = "Inverse/" + name + "/" + std::to_string(samples);
        benchmark::RegisterBenchmark(inverse.c_str(), run_inverses, shape, channels, samples);
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
