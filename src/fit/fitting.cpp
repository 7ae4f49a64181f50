// Fitting: from the samples of a recording to the rows of its keys, and how well they fit.
#include "fit/fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "error.hpp"
#include "fit/errors.hpp"
#include "fit/fit.hpp"
#include "keys/angles.hpp"
#include "keys/rotations.hpp"
#include "option_names.hpp"
#include "sample/errors.hpp"
#include "sample/grid.hpp"
#include "stream/ordered_map.hpp"
#include "tcb/spline/angle.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// A column of what keys carry besides positions.
struct SlopeColumn {
  std::string name;
  std::size_t channel;
  double (*number)(const Keys&, std::size_t);  ///< by the number of a key's channel, counted through all keys
};

/// The slope columns that the output has.
std::vector<SlopeColumn> slope_columns(const FittedChannels& fitted, const FitOptions& options) {
  std::vector<SlopeColumn> columns;
  const std::vector<std::string>& names = fitted.names;
  if (options.keys == FitKeys::hermite) {
    const auto add = [&](std::string_view role, auto number) {
      for (std::size_t i = 0; i < names.size(); ++i)
        columns.push_back({fmt::format("{}_{}", names[i], role), i, number});
    };
    add(options.corner ? "vin" : "v", [](const Keys& keys, std::size_t i) { return keys.velocities[i].in; });
    if (options.corner) add("vout", [](const Keys& keys, std::size_t i) { return keys.velocities[i].out; });
    return columns;
  }
  std::vector<std::size_t> plain(names.size()), turning;  // channels; of a rotation the first one
  std::iota(plain.begin(), plain.end(), std::size_t{0});
  for (const FitGroup& group : fitted.groups) {
    if (!group.angle) continue;
    turning.push_back(group.channels[0]);
    std::erase_if(plain, [&](std::size_t i) { return std::ranges::count(group.channels, i) > 0; });
  }
  const auto add = [&](std::string_view role, auto number) {
    const auto add_of = [&](const std::vector<std::size_t>& channels, bool is_single) {
      for (const std::size_t i : channels) {
        columns.push_back({is_single ? std::string(role) : fmt::format("{}_{}", role, names[i]), i, number});
      }
    };
    add_of(plain, turning.empty() && plain.size() == 1);
    add_of(turning, turning.size() == 1);
  };
  add("tension", [](const Keys& keys, std::size_t i) { return keys.tcbs[i].tension; });
  if (options.corner) add("continuity", [](const Keys& keys, std::size_t i) { return keys.tcbs[i].continuity; });
  add("bias", [](const Keys& keys, std::size_t i) { return keys.tcbs[i].bias; });
  return columns;
}

/// Throws: Error (data) for a tolerance below the spacing of doubles at the size of the positions, and for numbers
/// whose squares are not within the range of doubles.
void require_resolution(const Recording& recording, const std::vector<std::string>& channels) {
  for (const FitGroup& group : recording.groups) {
    for (const std::size_t channel : group.channels) {
      double largest = 0;
      for (std::size_t i = 0; i < recording.size(); ++i) {
        largest = std::max(largest, std::abs(recording.position(i, channel)));
      }
      constexpr double most = 1e150, spacing = 0x1p-46;
      if (largest > most || group.tolerance < 1 / most) {
        throw fit_beyond_doubles(channels[channel]);
      }
      if (group.tolerance < largest * spacing) {
        throw tolerance_below_doubles(group.angle.value_or(group.tolerance), channels[channel], largest,
                                      largest * spacing)
            .about(option::fit);
      }
    }
  }
}

/// The samples of a curve, whose rotations and angles are checked.
Source<KeyBlock> checked_samples(Source<KeyBlock> blocks, const Schema& schema, const FitOptions& options) {
  if (options.angle) {
    blocks = with_quaternions(std::move(blocks), {schema.rotations, schema.sources});
  }
  return with_clear_angles(std::move(blocks), schema.angles, schema.channels);
}

/// Makes an angle go the shorter way from sample to sample.
void unwrap(Recording& recording, std::size_t channel, bool degrees) {
  for (std::size_t i = channel + recording.channels; i < recording.positions.size(); i += recording.channels) {
    double& angle = recording.positions[i];
    const auto step = spline::exact_difference(angle, recording.positions[i - recording.channels]);
    angle -= spline::nearest_turns<double>(step, degrees).hi;
  }
}

/// The times of a curve that are to have keys.
const std::vector<Rational>& kept_times_of(const CurveKeys& curve, const Schema& schema, const FitOptions& options) {
  if (options.grouped_kept_times.empty()) return options.kept_times;
  return places_of_group(options.grouped_kept_times, option::keep_times, curve, schema);
}

/// The samples at the times that are to have keys.
std::vector<std::size_t> kept_samples(const std::vector<Time>& samples, const std::vector<Rational>& places) {
  const auto find = [&](const Time& time) {
    const auto found = std::ranges::lower_bound(samples, time);
    return found != samples.end() && *found == time ? found : samples.end();
  };
  constexpr int all_decimals = std::numeric_limits<int>::max();
  std::vector<std::size_t> kept;
  for (const Rational& place : places) {
    auto found = find(nearest_time(place));
    if (found == samples.end()) found = find(nearest_time(place, all_decimals));
    if (found == samples.end()) throw no_sample_to_keep(text(place)).about(option::keep_times);
    kept.push_back(static_cast<std::size_t>(found - samples.begin()));
  }
  return kept;
}

}  // namespace

Schema curve_of_fit(const Input& samples, const CurveSettings& rules, const FitOptions& options) {
  if (!samples.schema.time.is_given) throw fit_without_times();
  if (!samples.facts.roles.empty()) throw fit_of_keys(samples.facts.roles[0]);
  const FittedChannels fitted = fitted_channels(samples.schema, rules, options);
  if (fitted.names.empty()) throw only_rotations();
  Schema schema = with_channels(samples.schema, fitted.names);
  for (const FitGroup& group : fitted.groups) {
    if (!group.angle) continue;
    const GivenRotation& given = samples.schema.rotations[schema.rotations.size()].given;
    schema.rotations.push_back({{{group.rotation()}, {}, {}}, given, {}});
  }
  return schema;
}

Schema keys_of_fit(const Input& samples, const CurveSettings& rules, const FitOptions& options) {
  std::vector<std::string> channels = curve_of_fit(samples, rules, options).channels;
  for (const SlopeColumn& column : slope_columns(fitted_channels(samples.schema, rules, options), options)) {
    channels.push_back(column.name);
  }
  return with_channels(samples.schema, std::move(channels));
}

Samples recorded_samples(const CurveKeys& curve, const Schema& schema, const CurveSettings& rules,
                         const FitOptions& options) {
  if (curve.curve_info != nullptr && !curve.curve_info->places.empty()) {
    const auto& [name, place] = curve.curve_info->places[0];
    throw fit_of_setting(name).at(place);
  }
  Samples samples{curve.group, {}, {}, {}, {}, {}};
  samples.fitted = fitted_channels(schema, rules, options);
  const auto& [channels, names, groups] = samples.fitted;
  Recording& recording = samples.recording;
  recording.channels = channels.size();
  recording.groups = groups;
  const Source<KeyBlock> blocks = checked_samples(curve.keys, schema, options);
  while (const std::optional<KeyBlock> block = blocks()) {
    for (std::size_t key = 0; key < block->size(); ++key) {
      samples.times.push_back(block->keys.times[key]);
      samples.lines.push_back(block->line(key));
      recording.times.push_back((samples.times.back() - samples.times.front()).hi);
      for (const std::size_t channel : channels) {
        recording.positions.push_back(block->keys.position(key)[channel]);
        if (!std::isnan(recording.positions.back())) continue;
        throw sample_without_number(schema.channels[channel]).at({"", block->line(key), 0});
      }
    }
  }
  for (const AngleColumn& angle : schema.angles) {
    const auto found = std::ranges::find(channels, angle.channel);
    unwrap(recording, static_cast<std::size_t>(found - channels.begin()), angle.degrees);
  }
  if (samples.times.size() < 2) {
    const std::uint64_t line = samples.lines.empty() ? 0 : samples.lines[0];
    throw too_few_samples().at({"", line, 0});
  }
  require_resolution(recording, names);
  samples.kept = kept_samples(samples.times, kept_times_of(curve, schema, options));
  return samples;
}

FitResult fitted(const Samples& samples, const FitOptions& options, const SamplesDone& done, unsigned threads) {
  const auto result =
      fit(samples.recording, samples.times, {options.keys, samples.kept, options.corner, done, threads});
  if (!result) throw no_fit_found();
  return *result;
}

FittedRows rows_of(const Samples& samples, const FitResult& result, const FitOptions& options) {
  FittedRows rows{samples.group, {}, {}};
  rows.report = {samples.times.size(), result.keys.size(), result.least_keys, result.largest,
                 samples.lines[result.sample]};
  const std::vector<SlopeColumn> columns = slope_columns(samples.fitted, options);
  for (std::size_t key = 0; key < result.keys.size(); ++key) {
    rows.table.cells.push_back(result.keys.times[key]);
    for (const double position : result.keys.position(key)) rows.table.cells.emplace_back(position);
    for (const auto& [name, channel, number] : columns) {
      rows.table.cells.emplace_back(number(result.keys, key * result.keys.channels + channel));
    }
  }
  return rows;
}

void FitReport::add(const FitReport& other) {
  samples += other.samples;
  keys += other.keys;
  least_keys += other.least_keys;
  if (line != 0 && largest >= other.largest) return;
  largest = other.largest;
  line = other.line;
}

namespace {

Note labels_not_fitted(const std::vector<std::string>& names) {
  return {fmt::format("ignored: {}; the keys of a fit have no labels", listed(names)), true};
}

Note rotations_not_fitted(const std::vector<std::string>& names) {
  return {fmt::format("rotations not fitted: {}; {} D,0.5deg fits them", listed(names), option::fit), true};
}

}  // namespace

std::vector<Note> notes_of_columns(const Schema& schema, const FitOptions& options) {
  std::vector<Note> notes;
  if (!schema.labels.empty()) notes.push_back(labels_not_fitted(schema.labels));
  std::vector<std::string> names;
  for (const RotationSchema& rotation : schema.rotations) {
    names.insert(names.end(), rotation.given.columns.begin(), rotation.given.columns.end());
  }
  if (!options.angle && !names.empty()) notes.push_back(rotations_not_fitted(names));
  return notes;
}

Note note_of(const FitReport& report, const FitOptions& options) {
  const bool is_distance = options.tolerances.size() == 1 && options.tolerances[0].column.empty() && !options.angle;
  const std::string largest = is_distance ? fmt::format("{:.4g}", report.largest * options.tolerances[0].most)
                                          : fmt::format("{:.4g} of the tolerance", report.largest);
  const double ratio = static_cast<double>(report.samples) / static_cast<double>(report.keys);
  return {fmt::format(
              "{} samples, {} keys, {:.3g} times fewer; largest distance {}, on line {}; at least {} keys are needed",
              report.samples, report.keys, ratio, largest, report.line, report.least_keys),
          true};
}

}  // namespace tcb
