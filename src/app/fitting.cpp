// Fitting: the keys of a recording as rows, in place of the samples of a curve.
#include "app/fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/build.hpp"
#include "error.hpp"
#include "fit/fit.hpp"
#include "text/print_number.hpp"

namespace tcb {
namespace {

/// The channels that are fitted: all but those of rotations.
std::vector<std::size_t> fitted_channels(const Input& input) {
  std::vector<std::size_t> channels;
  for (std::size_t i = 0; i < input.channels.size(); ++i) {
    const auto has = [&](const auto& rotation) { return std::ranges::count(rotation.channels, i) > 0; };
    if (std::ranges::none_of(input.rotations, has)) channels.push_back(i);
  }
  return channels;
}

/// What the keys carry besides positions: the roles of the columns of a channel.
std::vector<std::string> names_of_slopes(const std::vector<std::string>& channels, const FitOptions& options) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view before, std::string_view after) {
    for (const std::string& channel : channels) names.push_back(fmt::format("{}{}{}", before, channel, after));
  };
  if (options.keys == FitKeys::hermite && options.corner) {
    add("", "_vin");
    add("", "_vout");
  } else if (options.keys == FitKeys::hermite) {
    add("", "_v");
  } else if (channels.size() == 1) {
    names = {"tension", "continuity", "bias"};
  } else {
    add("tension_", "");
    add("continuity_", "");
    add("bias_", "");
  }
  const auto is_of_corner = [](const std::string& name) { return name.starts_with("continuity"); };
  if (!options.corner) std::erase_if(names, is_of_corner);
  return names;
}

/// The numbers of a key in the order of names_of_slopes().
std::vector<double> numbers_of_slopes(const Keys& keys, std::size_t key, const FitOptions& options) {
  std::vector<double> numbers;
  const auto add = [&](const auto& all, auto member) {
    for (std::size_t i = 0; i < keys.channels; ++i) numbers.push_back(all[key * keys.channels + i].*member);
  };
  if (options.keys == FitKeys::hermite) {
    add(keys.velocities, &spline::Velocity<double>::in);
    if (options.corner) add(keys.velocities, &spline::Velocity<double>::out);
    return numbers;
  }
  add(keys.tcbs, &spline::Tcb<double>::tension);
  if (options.corner) add(keys.tcbs, &spline::Tcb<double>::continuity);
  add(keys.tcbs, &spline::Tcb<double>::bias);
  return numbers;
}

/// The limits of the channels: one for the distance over those without a limit of their own, and these.
std::vector<FitGroup> groups_of(const std::vector<std::string>& channels, const FitOptions& options) {
  std::vector<FitGroup> groups;
  FitGroup others;
  std::vector<bool> named(channels.size());
  for (const Tolerance& tolerance : options.tolerances) {
    if (tolerance.column.empty()) {
      others.tolerance = tolerance.most;
      continue;
    }
    const auto channel = find_channel(tolerance.column, channels);
    if (!channel) throw Error(Exit::data, ErrorCode::unknown_name, {tolerance.column, channels}).about(Option::fit);
    named[*channel] = true;
    groups.push_back({{*channel}, tolerance.most});
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!named[i]) others.channels.push_back(i);
  }
  if (others.channels.empty()) return groups;
  if (others.tolerance == 0) {
    throw Error(Exit::data, ErrorCode::fit_without_tolerance, {channels[others.channels[0]]});
  }
  groups.push_back(others);
  return groups;
}

/// Throws: Error (data) for a tolerance below the spacing of doubles at the size of the positions.
void require_resolution(const Recording& recording, const std::vector<std::string>& channels) {
  for (const FitGroup& group : recording.groups) {
    for (const std::size_t channel : group.channels) {
      double largest = 0;
      for (std::size_t i = 0; i < recording.size(); ++i) {
        largest = std::max(largest, std::abs(recording.position(i, channel)));
      }
      if (group.tolerance < largest * 0x1p-46) {
        throw Error(Exit::data, ErrorCode::fit_below_doubles, {group.tolerance, channels[channel], largest})
            .about(Option::fit);
      }
    }
  }
}

/// The samples at the times that are to have keys.
std::vector<std::size_t> kept_samples(const std::vector<Time>& samples, const std::vector<Rational>& places) {
  std::vector<std::size_t> kept;
  for (const Rational& place : places) {
    const Time time = nearest_time(place);
    const auto found = std::ranges::lower_bound(samples, time);
    if (found == samples.end() || *found != time) {
      throw Error(Exit::data, ErrorCode::kept_time_without_sample, {time_text(time)}).about(Option::keep_times);
    }
    kept.push_back(static_cast<std::size_t>(found - samples.begin()));
  }
  return kept;
}

}  // namespace

Input columns_of_fit(const Input& samples, const Job& job) {
  if (!samples.timed) throw Error(Exit::data, ErrorCode::fit_without_times).about(Option::fit);
  if (!samples.facts.roles.empty()) throw Error(Exit::data, ErrorCode::fit_of_keys, {samples.facts.roles[0]});
  Input result = samples;
  result.channels.clear();
  for (const std::size_t channel : fitted_channels(samples)) result.channels.push_back(samples.channels[channel]);
  if (result.channels.empty()) throw Error(Exit::data, ErrorCode::only_rotations);
  (void)groups_of(result.channels, job.fit);
  const std::vector<std::string> names = names_of_slopes(result.channels, job.fit);
  result.channels.insert(result.channels.end(), names.begin(), names.end());
  result.rotations.clear();
  result.given_rotations.clear();
  result.rotation_names.clear();
  result.carried.clear();
  return result;
}

Samples recorded_samples(const CurveKeys& curve, const Input& input, const std::vector<Rational>& kept_times,
                         const Job& job) {
  const std::vector<std::size_t> channels = fitted_channels(input);
  std::vector<std::string> names;
  for (const std::size_t channel : channels) names.push_back(input.channels[channel]);
  Samples samples{curve.group, {}, {}, {}, {}};
  Recording& recording = samples.recording;
  recording.channels = channels.size();
  recording.groups = groups_of(names, job.fit);
  while (const std::optional<KeyBlock> block = curve.keys()) {
    for (std::size_t key = 0; key < block->size(); ++key) {
      samples.times.push_back(block->keys.times[key]);
      samples.lines.push_back(block->lines[key]);
      recording.times.push_back((samples.times.back() - samples.times.front()).hi);
      for (const std::size_t channel : channels) {
        recording.positions.push_back(block->keys.position(key)[channel]);
        if (!std::isnan(recording.positions.back())) continue;
        throw Error(Exit::data, ErrorCode::fit_of_missing, {input.channels[channel]}).at({"", block->lines[key], 0});
      }
    }
  }
  if (samples.times.size() < 2) throw Error(Exit::data, ErrorCode::fit_of_single_sample).about(Option::fit);
  require_resolution(recording, names);
  samples.kept = kept_samples(samples.times, kept_times);
  return samples;
}

FitResult fitted(const Samples& samples, const FitOptions& options) {
  const auto result = fit(samples.recording, samples.times, {options.keys, samples.kept, options.corner});
  if (!result) throw Error(Exit::data, ErrorCode::fit_impossible).about(Option::fit);
  return *result;
}

FittedRows rows_of(const Samples& samples, const FitResult& result, const FitOptions& options) {
  FittedRows rows{samples.group, {}, {}};
  rows.report = {samples.times.size(), result.keys.size(), result.least_keys, result.largest,
                 samples.lines[result.sample]};
  for (std::size_t key = 0; key < result.keys.size(); ++key) {
    rows.table.cells.push_back(result.keys.times[key]);
    for (const double position : result.keys.position(key)) rows.table.cells.emplace_back(position);
    for (const double number : numbers_of_slopes(result.keys, key, options)) rows.table.cells.emplace_back(number);
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

Note note_of(const FitReport& report, const FitOptions& options) {
  const bool is_distance = options.tolerances.size() == 1 && options.tolerances[0].column.empty();
  const std::string largest = is_distance ? fmt::format("{:.4g}", report.largest * options.tolerances[0].most)
                                          : fmt::format("{:.4g} of the tolerance", report.largest);
  const double ratio = static_cast<double>(report.samples) / static_cast<double>(report.keys);
  return {NoteCode::fitted,
          {report.samples, report.keys, fmt::format("{:.3g}", ratio), largest, report.line, report.least_keys}};
}

}  // namespace tcb
