// Pictures of comparisons: the samples over the curve, their differences over time, and the worst place.
//
// The scene has the compared channels, and after them a channel for each of their differences, in which the curve is
// 0. The samples are a curve of their own: a polyline through them.
#include "check/check_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "check/errors.hpp"
#include "error.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

/// A sample with its differences as further positions.
struct CheckedSample {
  Time t;
  std::vector<double> position;
};

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

/// A polyline through keys.
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

/// Sets differences to 0 where they are below the rounding of the largest position of their channel.
void remove_rounding(std::vector<CheckedSample>& samples, std::size_t channels) {
  for (std::size_t i = 0; i < channels; ++i) {
    double largest = 0;
    for (const CheckedSample& sample : samples) largest = std::max(largest, std::abs(sample.position[i]));
    for (CheckedSample& sample : samples) {
      double& difference = sample.position[channels + i];
      if (std::abs(difference) <= 0x1p-51 * largest) difference = 0;
    }
  }
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

void CheckPicture::begin(const ComparisonInputs& inputs) {
  const std::vector<std::string>& channels = inputs.kept.schema.channels;
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    const auto column = std::ranges::find(inputs.columns.compared, channels[channel], &MatchedColumn::name);
    if (column == inputs.columns.compared.end()) continue;
    channels_.push_back(channel);
    given_.push_back(column->given);
    scene_.channels.push_back(channels[channel]);
  }
  if (channels_.empty()) throw no_position_column(channels);
  scene_.path = path_axes(scene_.channels, options_.axes);
  scene_.is_path_requested = !options_.axes.empty();
  for (std::size_t i = 0; i < channels_.size(); ++i) scene_.channels.push_back(scene_.channels[i] + ", difference");
  scene_.require_few_strips();
  scene_.time = inputs.kept.schema.time.name;
  scene_.time_scale = time_scale_of(inputs.kept.schema);
  scene_.names = {file_name(inputs.keys), file_name(inputs.file)};
}

void CheckPicture::add(const CheckedPair& pair) {
  if (channels_.empty()) begin(pair.inputs);
  if (scene_.curves.size() + 2 > Scene::most_curves) return;
  add_curve(pair);
  add_samples(pair);
}

void CheckPicture::add_curve(const CheckedPair& pair) {
  CurvePipeline pipeline = pair.pipeline;
  const StoredCurve stored = pipeline.stored(pair.curve.keys(), false);
  const Keys all = stored.keys.all();
  Keys keys{2 * channels_.size(), all.times, {}, {}, {}, {}};
  for (std::size_t key = 0; key < all.size(); ++key) {
    for (const std::size_t channel : channels_) keys.positions.push_back(all.position(key)[channel]);
    keys.positions.resize((key + 1) * keys.channels, std::numeric_limits<double>::quiet_NaN());
  }
  const auto segments = [segments = with_rotations_as_cubics(stored.segments, pipeline.facts().spec.channels()),
                         channels = channels_] {
    return mapped(segments(), [channels](const SegmentBlock& block) { return with_zeros(block, channels); });
  };
  scene_.curves.push_back({0, KeyStore(keys), segments, stored.closed});
}

void CheckPicture::add_samples(const CheckedPair& pair) {
  MatchedColumns columns = pair.inputs.columns;
  columns.fields = {field_of("time"), field_of("position")};
  const std::vector<std::string>& names = pair.inputs.kept.schema.channels;
  for (MatchedColumn& column : columns.compared) {
    column.computed = 1 + static_cast<std::size_t>(std::ranges::find(names, column.name) - names.begin());
  }
  const std::size_t width = pair.inputs.table.columns.size(), size = channels_.size();
  std::vector<CheckedSample> samples;
  for_each_row(pair.rows, pair.places, columns, pair.indexed, pair.side, pair.inputs.threads,
               [&](std::size_t row, std::span<const Cell> cells) {
                 CheckedSample sample{cells[0], std::vector<double>(2 * size)};
                 for (std::size_t i = 0; i < size; ++i) {
                   sample.position[i] = pair.rows.numbers[row * width + given_[i]];
                   sample.position[size + i] = sample.position[i] - cells[1 + channels_[i]].hi;
                 }
                 const bool whole = std::ranges::all_of(sample.position, [](double x) { return std::isfinite(x); });
                 if (whole) samples.push_back(std::move(sample));
               });
  std::ranges::stable_sort(samples, {}, &CheckedSample::t);
  if (samples.empty()) return;
  remove_rounding(samples, size);
  Keys keys{2 * size, {}, {}, {}, {}, {}};
  for (const CheckedSample& sample : samples) {
    keys.times.push_back(sample.t);
    keys.positions.insert(keys.positions.end(), sample.position.begin(), sample.position.end());
    for (std::size_t i = size; i < 2 * size; ++i) {
      if (std::abs(sample.position[i]) <= largest_) continue;
      largest_ = std::abs(sample.position[i]);
      scene_.worst = SceneMark{sample.t, sample.position, {i - size, i}};
    }
  }
  const KeyStore store(keys);
  const auto segments = [store]() -> Source<SegmentBlock> {
    return [block = std::optional(polyline(store.all()))]() mutable { return std::exchange(block, std::nullopt); };
  };
  scene_.curves.push_back({1, store, segments, false, 0, {}, true, size});
}

std::string CheckPicture::svg(const ComparisonSummary& files, const std::string& result) {
  scene_.title = options_.title.value_or(fmt::format("{} against {}", file_name(files.file), file_name(files.keys)));
  scene_.subtitle = fmt::format("{} · largest difference {:.4g}", result, largest_);
  return picture(std::move(scene_), options_.size);
}

}  // namespace tcb
