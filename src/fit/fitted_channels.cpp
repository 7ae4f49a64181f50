// Fitted channels: what is fitted of an input, and within which limits.
#include "fit/fitted_channels.hpp"

#include <algorithm>

#include "error.hpp"
#include "fit/errors.hpp"
#include "option_names.hpp"
#include "sample/build.hpp"
#include "sample/errors.hpp"
#include "tcb/spline/angle.hpp"

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
      throw tolerance_of_unknown_channel(tolerance.column, without_rotations(channels, kinds)).about(option::fit);
    }
    named[*channel] = true;
    groups.push_back({{*channel}, tolerance.most});
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (named[i] || kinds[i] == LimitKind::rotation) continue;
    const bool has_limit = others.tolerance > 0 && kinds[i] == LimitKind::distance;
    if (!has_limit) throw channel_without_tolerance(channels[i]);
    others.channels.push_back(i);
  }
  if (!others.channels.empty()) groups.push_back(others);
  return groups;
}

}  // namespace

FittedChannels fitted_channels(const Schema& schema, const CurveSettings& rules, const FitOptions& options) {
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  const auto metric = make_spec(rules, schema.channels, rotations, schema.angles).rules.metric;
  FittedChannels fitted;
  std::vector<LimitKind> kinds;
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    const bool is_of_rotation = spline::is_in_rotation(rotations, i);
    if (is_of_rotation && !options.angle) continue;
    const bool is_metric = metric.empty() || std::ranges::count(metric, i) > 0;
    kinds.push_back(is_of_rotation ? LimitKind::rotation : is_metric ? LimitKind::distance : LimitKind::own);
    fitted.numbers.push_back(i);
    fitted.names.push_back(schema.channels[i]);
  }
  fitted.groups = groups_of(fitted.names, kinds, options);
  if (!options.angle) return fitted;
  if (rotations.empty()) throw tolerance_without_rotation().about(option::fit);
  for (const auto& [columns, given, names] : schema.rotations) {
    if (!given.notation.is_quaternion()) {
      throw fit_of_other_form(given.columns[0]);
    }
    fitted.groups.push_back(rotation_group(fitted.numbers, columns.channels, *options.angle, options.keys));
  }
  return fitted;
}

}  // namespace tcb
