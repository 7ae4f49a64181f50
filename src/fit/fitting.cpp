// Fitting: from the samples of a recording to the rows of its keys, and how well they fit.
#include "fit/fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "error.hpp"
#include "fit/fit.hpp"
#include "keys/prepare.hpp"
#include "keys/rotations.hpp"
#include "sample/build.hpp"
#include "sample/grid.hpp"
#include "stream/ordered_map.hpp"
#include "tcb/spline/angle.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// The limit of a rotation with these channels of an input, of which some are fitted.
FitGroup rotation_group(const std::vector<std::size_t>& fitted, const spline::RotationChannels& channels, double angle,
                        FitKeys keys) {
  const double share = keys == FitKeys::tcb ? 0.85 : 0.98;  // the curve of the keys differs from the fitted cubics
  constexpr double most = 1.5;
  FitGroup group{{}, share * spline::sine_cosine(std::min(angle / 2, most)).sine, angle};
  for (const std::size_t channel : channels) {
    const auto found = std::ranges::find(fitted, channel);
    group.channels.push_back(static_cast<std::size_t>(found - fitted.begin()));
  }
  return group;
}

/// By what a channel is limited: with others, alone, or as a number of a rotation.
enum class LimitKind { distance, own, rotation };

std::vector<std::string> without_rotations(const std::vector<std::string>& channels,
                                           const std::vector<LimitKind>& kinds) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (kinds[i] != LimitKind::rotation) names.push_back(channels[i]);
  }
  return names;
}

/// The limits of channels that are no rotations: one for the distance over those of the metric without a limit of their
/// own, and these.
std::vector<FitGroup> groups_of(const std::vector<std::string>& channels, const std::vector<LimitKind>& kinds,
                                const FitOptions& options) {
  std::vector<FitGroup> groups;
  FitGroup others;
  std::vector<bool> named(channels.size());
  for (const Tolerance& tolerance : options.tolerances) {
    if (tolerance.column.empty()) {
      others.tolerance = tolerance.most;
      continue;
    }
    const auto channel = find_channel(tolerance.column, channels);
    if (!channel || kinds[*channel] == LimitKind::rotation) {
      const auto known = without_rotations(channels, kinds);
      throw data_error("there is no channel {} for a tolerance; expected one of {}{}", in_quotes(tolerance.column),
                       listed(known), did_you_mean(tolerance.column, known))
          .about("--fit");
    }
    named[*channel] = true;
    groups.push_back({{*channel}, tolerance.most});
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (named[i] || kinds[i] == LimitKind::rotation) continue;
    const bool has_limit = others.tolerance > 0 && kinds[i] == LimitKind::distance;
    if (!has_limit) {
      throw data_error(
          "channel \"{0}\" has no tolerance; the distance D is only for the channels of --metric; add {0}=D to --fit",
          channels[i]);
    }
    others.channels.push_back(i);
  }
  if (!others.channels.empty()) groups.push_back(others);
  return groups;
}

/// A column of what keys carry besides positions.
struct SlopeColumn {
  std::string name;
  std::size_t channel;
  double (*number)(const Keys&, std::size_t);  ///< by the number of a key's channel, counted through all keys
};

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
        throw data_error(
            "the numbers of channel \"{0}\" or its tolerance cannot be squared as doubles; expected numbers below "
            "1e150 and a tolerance above 1e-150; give --scale {0}=FACTOR",
            channels[channel]);
      }
      if (group.tolerance < largest * spacing) {
        throw data_error(
            "the tolerance {} is near the spacing of doubles in channel \"{}\", whose numbers reach {}; expected at "
            "least {}; give a larger tolerance",
            group.angle.value_or(group.tolerance), channels[channel], largest, largest * spacing)
            .about("--fit");
      }
    }
  }
}

/// The samples of a curve, whose rotations and angles are checked.
Source<KeyBlock> checked_samples(Source<KeyBlock> blocks, const Schema& schema, const FitOptions& options) {
  TurnsOfKeys turns{.rotations = {}, .sources = schema.sources, .angles = schema.angles, .channels = schema.channels};
  if (options.angle) turns.rotations = schema.rotations;
  return with_clear_turns(std::move(blocks), turns);
}

/// Makes an angle go the shorter way from sample to sample.
void unwrap(Recording& recording, std::size_t channel, bool degrees) {
  for (std::size_t i = channel + recording.channels; i < recording.positions.size(); i += recording.channels) {
    double& angle = recording.positions[i];
    const auto step = spline::exact_difference(angle, recording.positions[i - recording.channels]);
    angle -= spline::nearest_turns<double>(step, degrees).hi;
  }
}

const std::vector<Rational>& kept_times_of(const InputCurve& curve, const Schema& schema, const FitOptions& options) {
  if (options.grouped_kept_times.empty()) return options.kept_times;
  return places_of_group(options.grouped_kept_times, "--keep-times", curve, schema);
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
    if (found == samples.end()) {
      throw data_error("there is no sample at time {}; expected times of samples", text(place)).about("--keep-times");
    }
    kept.push_back(static_cast<std::size_t>(found - samples.begin()));
  }
  return kept;
}

}  // namespace

FittedChannels fitted_channels(const Schema& schema, const CurveSettings& rules, const FitOptions& options) {
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  const auto metric = make_spec(rules, schema.channels, rotations, schema.angles).rules.metric;
  FittedChannels fitted;
  std::vector<LimitKind> kinds;
  const std::vector<bool> are_of_rotations = spline::in_rotations(rotations, schema.channels.size());
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    const bool is_of_rotation = are_of_rotations[i];
    if (is_of_rotation && !options.angle) continue;
    const bool is_metric = metric.empty() || std::ranges::count(metric, i) > 0;
    kinds.push_back(is_of_rotation ? LimitKind::rotation : is_metric ? LimitKind::distance : LimitKind::own);
    fitted.numbers.push_back(i);
    fitted.names.push_back(schema.channels[i]);
  }
  fitted.groups = groups_of(fitted.names, kinds, options);
  if (!options.angle) return fitted;
  if (rotations.empty()) {
    throw data_error(
        "the tolerance has an angle, but there is no rotation; give the distance alone, or name a rotation with "
        "--rotation")
        .about("--fit");
  }
  for (const auto& [columns, given, names] : schema.rotations) {
    if (!given.notation.is_quaternion()) {
      throw data_error(
          "column \"{}\" belongs to a rotation that is not a quaternion; --fit needs quaternions; convert the samples "
          "first with --rotation-output quaternion",
          given.columns[0]);
    }
    fitted.groups.push_back(rotation_group(fitted.numbers, columns.channels, *options.angle, options.keys));
  }
  return fitted;
}

Schema curve_of_fit(const Input& samples, const CurveSettings& rules, const FitOptions& options) {
  if (!samples.schema.time.is_given) {
    throw data_error(
        "there is no time column; --fit needs samples with times; name the column with --columns time=NAME");
  }
  if (!samples.facts.roles.empty()) {
    throw data_error(
        "there is a column of {}, which only keys have; --fit needs samples; leave the column out with --columns "
        "ignore=NAME",
        samples.facts.roles[0]);
  }
  const FittedChannels fitted = fitted_channels(samples.schema, rules, options);
  if (fitted.names.empty()) {
    throw data_error(
        "there are only rotations, which have no distances; expected a position; give an angle, as in --fit 0.5deg, or "
        "--rotation none to take the numbers as positions");
  }
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

Samples recorded_samples(const InputCurve& curve, const Schema& schema, const CurveSettings& rules,
                         const FitOptions& options) {
  if (curve.curve_info != nullptr && !curve.curve_info->places.empty()) {
    const auto& [name, place] = curve.curve_info->places[0];
    throw data_error(
        "\"{}\" is a setting of a curve of keys; --fit makes keys for the default rules; remove the setting", name)
        .at(place);
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
        throw data_error(
            "channel \"{}\" has no number; --fit needs a number in every sample; fill it in, or give --missing "
            "skip-row",
            schema.channels[channel])
            .at({"", block->line(key), 0});
      }
    }
  }
  for (const AngleColumn& angle : schema.angles) {
    const auto found = std::ranges::find(channels, angle.channel);
    unwrap(recording, static_cast<std::size_t>(found - channels.begin()), angle.degrees);
  }
  if (samples.times.size() < 2) {
    const std::uint64_t line = samples.lines.empty() ? 0 : samples.lines[0];
    throw data_error("the curve has fewer than two samples; --fit needs at least two; add samples").at({"", line, 0});
  }
  if (!std::isfinite(recording.times.back())) {
    throw data_error(
        "the time from the first sample to the last is beyond the range of doubles; expected less than 1.8e308; scale "
        "the samples down");
  }
  require_resolution(recording, names);
  samples.kept = kept_samples(samples.times, kept_times_of(curve, schema, options));
  return samples;
}

FitResult fitted(const Samples& samples, const FitOptions& options, const SamplesDone& done, unsigned threads) {
  const auto result =
      fit(samples.recording, samples.times, {options.keys, samples.kept, options.corner, done, threads});
  if (!result) {
    throw data_error(
        "no tension, continuity and bias keep the curve within the tolerance of --fit; this happens if the numbers "
        "have too few digits for the tolerance, or if positions repeat; give a larger tolerance, numbers with more "
        "digits, or --fit-keys hermite");
  }
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

std::vector<Note> notes_of_columns(const Schema& schema, const FitOptions& options) {
  std::vector<Note> notes;
  if (!schema.labels.empty()) {
    notes.push_back({fmt::format("ignored: {}; the keys of a fit have no labels", listed(schema.labels)), true});
  }
  std::vector<std::string> names;
  for (const RotationSchema& rotation : schema.rotations) {
    names.insert(names.end(), rotation.given.columns.begin(), rotation.given.columns.end());
  }
  if (!options.angle && !names.empty()) {
    notes.push_back({fmt::format("rotations not fitted: {}; --fit D,0.5deg fits them", listed(names)), true});
  }
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
