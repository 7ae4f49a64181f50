// Pictures of differences: samples over a curve, their differences from it over time, and the largest of these.
#include "picture/differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sample/build.hpp"

namespace tcb {
namespace {

/// The cubics of some channels, and as many that are 0.
SegmentBlock with_zeros(const SegmentBlock& block, const std::vector<std::size_t>& channels) {
  SegmentBlock result{
      {2 * channels.size(), block.segments.times, {}, block.segments.warps}, {}, block.last, block.closes};
  for (std::size_t i = 0; i < block.segments.size(); ++i) {
    for (const std::size_t channel : channels) result.segments.cubics.push_back(block.segments[i][channel]);
    result.segments.cubics.resize((i + 1) * 2 * channels.size());
  }
  return result;
}

SegmentBlock polyline(const Keys& keys) {
  SegmentBlock block{{keys.channels, keys.times, {}, {}}, {}, true, false};
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    for (std::size_t channel = 0; channel < keys.channels; ++channel) {
      const double a = keys.position(i)[channel], b = keys.position(i + 1)[channel];
      block.segments.cubics.push_back(spline::cubic<double>(a, b, {b - a}, {b - a}));
    }
  }
  return block;
}

/// Sets differences to 0 where they are below the rounding of the largest position of their channel. Positions of a
/// sample are those of the channels and then their differences.
void remove_rounding(Keys& samples) {
  const std::size_t channels = samples.channels / 2;
  for (std::size_t channel = 0; channel < channels; ++channel) {
    double largest = 0;
    for (std::size_t i = channel; i < samples.positions.size(); i += samples.channels) {
      largest = std::max(largest, std::abs(samples.positions[i]));
    }
    for (std::size_t i = channels + channel; i < samples.positions.size(); i += samples.channels) {
      if (std::abs(samples.positions[i]) <= 0x1p-51 * largest) samples.positions[i] = 0;
    }
  }
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

DifferencePicture::DifferencePicture(const PictureOptions& options, const std::string& curves,
                                     const std::string& samples)
    : options_(options), curves_(file_name(curves)), samples_(file_name(samples)) {}

void DifferencePicture::begin(const Schema& keys, std::vector<std::size_t> channels) {
  channels_ = std::move(channels);
  std::vector<std::string> names;
  for (const std::size_t channel : channels_) names.push_back(keys.channels[channel]);
  scene_.begin(keys, names, options_.axes);
  for (const std::string& name : names) scene_.channels.push_back(name + ", difference");
  scene_.require_few_strips();
  scene_.names = {curves_, samples_};
}

void DifferencePicture::add(const StreamedCurve& curve, const CurveChannels& channels,
                            std::vector<ComparedSample> samples) {
  if (is_full()) return;
  add_curve(curve, channels);
  add_samples(std::move(samples));
}

void DifferencePicture::add_curve(const StreamedCurve& curve, const CurveChannels& channels) {
  const Keys all = curve.keys.all();
  Keys keys{2 * channels_.size(), all.times, {}, {}, {}, {}};
  for (std::size_t key = 0; key < all.size(); ++key) {
    for (const std::size_t channel : channels_) keys.positions.push_back(all.position(key)[channel]);
    keys.positions.resize((key + 1) * keys.channels, std::numeric_limits<double>::quiet_NaN());
  }
  const auto segments = with_rotations_as_cubics([curve] { return curve.segments(); }, channels);
  const auto drawn = [segments, channels = channels_] {
    return mapped(segments(), [channels](const SegmentBlock& block) { return with_zeros(block, channels); });
  };
  scene_.curves.push_back({0, KeyStore(keys), drawn, curve.extent.closed});
}

void DifferencePicture::add_samples(std::vector<ComparedSample> samples) {
  const auto is_missing = [](double x) { return !std::isfinite(x); };
  std::erase_if(samples, [&](const ComparedSample& sample) {
    return std::ranges::any_of(sample.given, is_missing) || std::ranges::any_of(sample.computed, is_missing);
  });
  if (samples.empty()) return;
  std::ranges::stable_sort(samples, {}, &ComparedSample::t);
  const std::size_t size = channels_.size();
  Keys keys{2 * size, {}, {}, {}, {}, {}};
  for (const auto& [t, given, computed] : samples) {
    keys.times.push_back(t);
    keys.positions.insert(keys.positions.end(), given.begin(), given.end());
    for (std::size_t i = 0; i < size; ++i) keys.positions.push_back(given[i] - computed[i]);
  }
  remove_rounding(keys);
  for (std::size_t sample = 0; sample < keys.size(); ++sample) {
    const auto position = keys.position(sample);
    for (std::size_t i = size; i < 2 * size; ++i) {
      if (std::abs(position[i]) <= largest_) continue;
      largest_ = std::abs(position[i]);
      scene_.worst = SceneMark{keys.times[sample], {position.begin(), position.end()}, {i - size, i}};
    }
  }
  const KeyStore store(keys);
  const auto segments = [store]() -> Source<SegmentBlock> {
    return [block = std::optional(polyline(store.all()))]() mutable { return std::exchange(block, std::nullopt); };
  };
  scene_.curves.push_back({1, store, segments, false, 0, {}, true, size});
}

std::string DifferencePicture::svg(const std::string& result) {
  scene_.title = options_.title.value_or(fmt::format("{} against {}", samples_, curves_));
  scene_.subtitle = fmt::format("{} · largest difference {:.4g}", result, largest_);
  return picture(std::move(scene_), options_.size);
}

}  // namespace tcb
