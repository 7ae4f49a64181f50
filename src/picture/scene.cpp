// Scene: the curves of a picture with their samples and names, and the extent of each channel.
#include "picture/scene.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "sample/build.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/angle.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/segment.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Cubic = spline::Cubic<double>;

/// Includes the largest and the smallest value of a cubic besides those at its ends.
void include_extremes(Interval& interval, const Cubic& given) {
  const double third = given.p0 + given.out / 3, two_thirds = given.p1 - given.in / 3;
  const auto [low, high] = std::minmax(given.p0, given.p1);
  if (std::min(third, two_thirds) >= low && std::max(third, two_thirds) <= high) return;  // control points
  int exponent = 0;  // products of numbers below 1 do not overflow
  (void)std::frexp(std::max({std::abs(given.p0), std::abs(given.p1), std::abs(given.out), std::abs(given.in)}),
                   &exponent);
  const auto scaled = [exponent](double number) { return std::ldexp(number, -exponent); };
  const Cubic x = spline::cubic<double>(scaled(given.p0), scaled(given.p1), {scaled(given.out)}, {scaled(given.in)});
  const double root = x.c * x.c - 3 * x.d * x.out;
  if (!(root >= 0)) return;
  const double q = -(x.c + (x.c < 0 ? -std::sqrt(root) : std::sqrt(root)));
  for (const double u : {q / (3 * x.d), x.out / q}) {
    if (u > 0 && u < 1) interval.include(Time(std::ldexp(spline::position(x, {u, u - 1}), exponent)));
  }
}

void include_cubic(Interval& interval, const Cubic& x) {
  interval.include(Time(x.p0));
  interval.include(Time(x.p1));
  include_extremes(interval, x);
}

void include_block(SceneExtent& extent, const SegmentBlock& block, const Scene& scene) {
  const spline::Segments<double>& segments = block.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto cubics = segments[i];
    extent.time.include(segments.times[i]);
    extent.time.include(segments.times[i + 1]);
    for (std::size_t channel = 0; channel < cubics.size(); ++channel) {
      const Cubic& x = cubics[channel];
      include_cubic(extent.channels[channel], x);
      for (const double control : {x.p0 + x.out / 3, x.p1 - x.in / 3}) {
        if (!std::isfinite(control)) {
          throw data_error(
              "a curve has a number beyond the range of doubles; expected less than 1.8e308 in size; scale the keys "
              "down");
        }
        extent.with_tangents[channel].include(Time(control));
      }
    }
    for (std::size_t axis = 0; scene.path && axis < 2; ++axis) {
      const Cubic& x = cubics[(*scene.path)[axis]];
      extent.path[axis].include(Time(x.p0 + x.out / 3));
      extent.path[axis].include(Time(x.p1 - x.in / 3));
    }
  }
  extent.segments += segments.size();
}

/// The four numbers of a rotation at a place, and their derivatives by its local parameter.
std::array<std::pair<double, double>, 4> numbers_of(const spline::RotationSegment<double>& rotation,
                                                    const spline::LocalParameter<double>& at) {
  const auto q = rotation.at(at);
  const auto [x, y, z] = rotation.rate(at);
  const auto slope = spline::Quaternion<double>{0.5 * x, 0.5 * y, 0.5 * z, 0} * q;
  return {{{q.x, slope.x}, {q.y, slope.y}, {q.z, slope.z}, {q.w, slope.w}}};
}

using Ends = std::vector<std::pair<double, double>>;  // position and derivative of each channel

/// The angle of a rotation from the first one in degrees, from 0 to 360, with its derivative: where that jumps, as from
/// there on.
template <class At>
std::pair<double, double> angle_and_derivative(const FirstRotation& first, const At& at) {
  const auto& [x, y, z, w] = first.channels;
  const spline::Quaternion<double> q{at(x).first, at(y).first, at(z).first, at(w).first};
  const spline::Quaternion<double> slope{at(x).second, at(y).second, at(z).second, at(w).second};
  const spline::Quaternion<double> turn = spline::conjugate(first.rotation) * q;
  const double sine = std::sqrt(turn.x * turn.x + (turn.y * turn.y + turn.z * turn.z));
  const double size = std::sqrt(spline::dot(slope, slope));
  constexpr double degrees = 2 * 57.29577951308232;  // of half the angle
  const double rate = sine < 1e-6 ? std::copysign(size, turn.w) : -spline::dot(first.rotation, slope) / sine;
  return {degrees * spline::angle_of(sine, turn.w), degrees * rate};
}

/// Gives the two halves of the cubics of angles the same turn.
void join_angles(spline::Segments<double>& segments, const std::vector<AngleColumn>& angles) {
  for (const AngleColumn& angle : angles) {
    for (std::size_t i = angle.channel; i < segments.cubics.size(); i += segments.channels) {
      Cubic& x = segments.cubics[i];
      x.p1 = x.p0 + (x.c + 2 * x.out + x.in) / 3;
    }
  }
}

/// Each segment as short ones without ease, whose cubics have the positions and velocities of the curve at their ends.
SegmentBlock cubic_parts(const SegmentBlock& block, const std::vector<RotationColumns>& rotations,
                         const std::vector<FirstRotation>& firsts) {
  constexpr int parts = 16;
  const spline::Segments<double>& whole = block.segments;
  SegmentBlock result{{whole.channels + firsts.size(), {}, {}, {}}, {}, block.last, block.closes};
  const auto ends_at = [&](std::size_t i, int part) {
    const double u = static_cast<double>(part) / parts;
    const spline::Warp<double> warp = whole.warp(i);
    const auto at = warp.at(spline::DoubleDouble(u), spline::DoubleDouble(1 - u));
    Ends ends;
    for (const Cubic& x : whole[i]) ends.emplace_back(spline::position(x, at), spline::first_derivative(x, at));
    for (std::size_t rotation = 0; rotation < rotations.size(); ++rotation) {
      const auto numbers = numbers_of(whole.rotations_of(i)[rotation], at);
      for (std::size_t k = 0; k < numbers.size(); ++k) ends[rotations[rotation].channels[k]] = numbers[k];
    }
    for (const FirstRotation& first : firsts) {
      ends.push_back(angle_and_derivative(first, [&](std::size_t channel) { return ends[channel]; }));
    }
    for (auto& [position, derivative] : ends) derivative *= warp.first_derivative(u) / parts;
    return ends;
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Ends before = ends_at(i, 0);
    const Time duration = whole.times[i + 1] - whole.times[i];
    for (int part = 0; part < parts; ++part) {
      Ends after = ends_at(i, part + 1);
      result.segments.times.push_back(whole.times[i] + duration * (static_cast<double>(part) / parts));
      for (std::size_t k = 0; k < after.size(); ++k) {
        const bool jumps = k >= whole.channels && std::abs(after[k].first - 180) > 180 - 1e-4;
        const double in = jumps ? -after[k].second : after[k].second;
        result.segments.cubics.push_back(spline::cubic<double>(before[k].first, after[k].first, before[k].second, in));
      }
      before = std::move(after);
    }
  }
  result.segments.times.push_back(whole.times.back());
  return result;
}

/// Whether channels are numbered, as the joints j1 and j2 of a robot are, which are no two axes of space; x1 and x2, or
/// p1 and p2 as channels without names are called, may be.
bool are_joints(std::string_view one, std::string_view other) {
  const auto stem_of = [](std::string_view name) {
    while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
    return name;
  };
  const std::string_view stem = stem_of(one);
  return stem.size() < one.size() && stem == stem_of(other) && stem != "p" && stem != "x" && stem != "pos";
}

/// How a picture writes the times of a schema.
TimeScale time_scale_of(const Schema& schema) {
  const TimeSchema& time = schema.time;
  TimeScale scale{time.notation, time.frame_rate.value_or(1), time.dates};
  const std::optional<TimeUnit> unit = time.unit ? time.unit : time.epoch_unit;
  if (unit == TimeUnit::ms || unit == TimeUnit::us || unit == TimeUnit::ns) {
    scale.units_per_second = units_per_second(*unit);
  }
  return scale;
}

void require_finite(const Interval& interval) {
  if (std::isfinite(interval.length())) return;
  throw data_error(
      "the numbers of a channel are too far apart to be drawn; expected differences below 1.8e308; scale the keys "
      "down");
}

}  // namespace

std::uint64_t Scene::keys() const {
  std::uint64_t sum = 0;
  for (const SceneCurve& curve : curves) sum += curve.is_polyline ? 0 : curve.keys.size();
  return sum;
}

std::uint64_t Scene::dots() const {
  std::uint64_t sum = 0;
  for (const SceneCurve& curve : curves) sum += curve.is_polyline ? curve.keys.size() : 0;
  return sum;
}

std::uint64_t Scene::rows() const {
  std::uint64_t sum = 0;
  for (const SceneCurve& curve : curves) sum += curve.rows;
  return sum;
}

bool Scene::has_samples() const {
  return std::ranges::all_of(curves, [](const SceneCurve& curve) { return curve.samples.size() == curve.rows; });
}

void Scene::begin(const Schema& schema, std::vector<std::string> of_channels, const std::vector<std::string>& axes,
                  const std::vector<std::size_t>& metric, bool lacks_metric) {
  time = schema.time.name;
  time_scale = time_scale_of(schema);
  channels = std::move(of_channels);
  is_path_requested = !axes.empty();
  if (is_path_requested || !lacks_metric) path = path_axes(channels, axes, metric);
}

void Scene::require_few_strips() const {
  if (strip_count() <= most_strips) return;
  throw usage_error(
      "the picture would have {} strips over time; expected at most {}; choose channels with --columns "
      "position=NAME:NAME",
      strip_count(), most_strips);
}

std::optional<std::array<std::size_t, 2>> path_axes(const std::vector<std::string>& channels,
                                                    const std::vector<std::string>& requested,
                                                    const std::vector<std::size_t>& metric) {
  std::vector<std::size_t> axes = metric;
  const bool is_chosen = !requested.empty() || axes.size() > 1;
  for (std::size_t i = 0; axes.size() == i && i < channels.size(); ++i) axes.push_back(i);
  if (!is_chosen && axes.size() > 1) {
    const std::string &first = channels[axes[0]], &second = channels[axes[1]];
    if (!are_of_one_kind(first, second) || are_joints(first, second)) return std::nullopt;
  }
  if (!requested.empty()) axes.clear();
  for (const std::string& name : requested) {
    const auto channel = find_channel(name, channels);
    if (!channel) {
      throw usage_error("there is no channel {}; expected two of {}, by name or by number from 1{}", in_quotes(name),
                        listed(channels), did_you_mean(name, channels))
          .about("--axes");
    }
    if (!axes.empty() && axes[0] == *channel) {
      throw usage_error("both axes are the channel {}; expected two different channels; replace one", in_quotes(name))
          .about("--axes");
    }
    axes.push_back(*channel);
  }
  return axes.size() < 2 ? std::nullopt : std::optional(std::array{axes[0], axes[1]});
}

std::vector<FirstRotation> first_rotations(const KeyStore& keys, const std::vector<RotationColumns>& columns) {
  std::vector<FirstRotation> firsts;
  for (const RotationColumns& rotation : columns) {
    std::size_t key = 0;
    while (std::isnan(keys.key(key).positions[rotation.channels[0]])) ++key;
    firsts.push_back({rotation.channels, spline::rotation_of<double>(keys.key(key).position(0), rotation.channels)});
  }
  return firsts;
}

std::function<Source<SegmentBlock>()> with_rotations_as_cubics(std::function<Source<SegmentBlock>()> segments,
                                                               CurveChannels channels,
                                                               std::vector<FirstRotation> firsts) {
  return [segments = std::move(segments), channels = std::move(channels), firsts = std::move(firsts)] {
    return mapped(segments(), [channels, firsts](SegmentBlock block) {
      join_angles(block.segments, channels.angles);
      return block.segments.rotations.empty() ? std::move(block) : cubic_parts(block, channels.rotations, firsts);
    });
  };
}

KeyStore with_angles(const KeyStore& keys, const std::vector<FirstRotation>& firsts) {
  if (firsts.empty()) return keys;
  const Keys all = keys.all();
  Keys result{all.channels + firsts.size(), all.times, {}, {}, {}, {}};
  for (std::size_t key = 0; key < all.size(); ++key) {
    const auto position = all.position(key);
    result.positions.insert(result.positions.end(), position.begin(), position.end());
    for (const FirstRotation& first : firsts) {
      const auto at = [&](std::size_t channel) { return std::pair(position[channel], 0.0); };
      result.positions.push_back(angle_and_derivative(first, at).first);
    }
  }
  return KeyStore(result);
}

void add_angles(SceneSample& sample, const std::vector<FirstRotation>& firsts) {
  for (const FirstRotation& first : firsts) {
    const auto at = [&](std::size_t channel) { return std::pair(sample.position[channel], sample.velocity[channel]); };
    const auto [angle, velocity] = angle_and_derivative(first, at);
    sample.position.push_back(angle);
    sample.velocity.push_back(velocity);
  }
}

SceneExtent extent_of(const Scene& scene) {
  SceneExtent extent;
  extent.channels.resize(scene.channels.size());
  extent.with_tangents.resize(scene.channels.size());
  for (const SceneCurve& curve : scene.curves) {
    const Source<SegmentBlock> blocks = curve.segments();
    while (const std::optional<SegmentBlock> block = blocks()) include_block(extent, *block, scene);
    for (const auto& [t, position, velocity] : curve.samples) {
      extent.time.include(t);
      for (std::size_t i = 0; i < position.size(); ++i) extent.channels[i].include(Time(position[i]));
    }
  }
  for (std::size_t axis = 0; scene.path && axis < 2; ++axis) {
    const Interval& curve = extent.channels[(*scene.path)[axis]];
    extent.path[axis].include(curve.low);
    extent.path[axis].include(curve.high);
    require_finite(extent.path[axis]);
  }
  for (std::size_t channel = 0; channel < extent.channels.size(); ++channel) {
    extent.with_tangents[channel].include(extent.channels[channel].low);
    extent.with_tangents[channel].include(extent.channels[channel].high);
  }
  require_finite(extent.time);
  std::ranges::for_each(extent.channels, require_finite);
  std::ranges::for_each(extent.with_tangents, require_finite);
  return extent;
}

void remove_flat_path(Scene& scene, const SceneExtent& extent) {
  if (!scene.path || scene.is_path_requested) return;
  constexpr double least_ratio = 0.05;
  const double right = extent.channels[(*scene.path)[0]].length(), up = extent.channels[(*scene.path)[1]].length();
  if (std::min(right, up) >= least_ratio * std::max(right, up)) return;
  scene.path.reset();
  scene.frame.reset();
}

}  // namespace tcb
