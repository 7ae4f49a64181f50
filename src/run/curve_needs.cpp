// Curve needs: what a request needs of a curve before its first row, decided once.
#include "run/curve_needs.hpp"

#include <algorithm>

#include "sample/table.hpp"

namespace tcb {
namespace {

/// Rows come in any order, or depend on more than one segment.
bool is_anywhere(const SamplingRequest& request, const CurveSpec& spec) {
  return request.mode == Mode::at || request.mode == Mode::arc_at || request.mode == Mode::tolerance ||
         spec.extrapolations.extend_curve();
}

/// There is one row, for which a curve may have a single key.
bool is_one_row(const SamplingRequest& request) {
  const bool is_count = request.mode == Mode::count || request.mode == Mode::arc_count;
  return (is_count && request.count == 1) || request.places.size() == 1;
}

bool needs_lengths(const SamplingRequest& request, std::span<const std::size_t> fields) {
  return by_length(request.mode) ||
         std::ranges::any_of(fields, [](std::size_t field) { return tcb::fields()[field].needs_lengths; });
}

MetricUse metric_use(const SamplingRequest& request, std::span<const std::size_t> fields, bool times_of_distances) {
  const auto is_of_path = [](std::size_t field) {
    return tcb::fields()[field].over_metric && !tcb::fields()[field].needs_lengths;
  };
  const bool is_near_path = request.mode == Mode::tolerance && request.tolerance.limits_distance();
  if (std::ranges::any_of(fields, is_of_path) || times_of_distances || is_near_path) return MetricUse::path;
  return needs_lengths(request, fields) ? MetricUse::lengths : MetricUse::nothing;
}

}  // namespace

CurveNeeds curve_needs(const SamplingRequest& request, std::span<const std::size_t> fields, const CurveSpec& spec,
                       const KeyFacts& keys, bool exact) {
  CurveNeeds needs;
  needs.random_access = is_anywhere(request, spec);
  needs.all_keys = spec.closed || needs.random_access || keys.may_miss || exact || needs_end(request);
  needs.lengths = needs_lengths(request, fields);
  needs.whole_length = needs.all_keys && !needs.random_access && by_length(request.mode);
  needs.single_key = is_one_row(request);
  needs.angle_signs = !spec.angles.empty();
  needs.metric = metric_use(request, fields, !keys.timed && spec.parameter.value_or(0) != 0);
  return needs;
}

std::string in_words(const CurveNeeds& needs) {
  if (needs.whole_length) return "all keys and the length of the curve before the first row";
  std::string words = needs.all_keys || needs.angle_signs ? "all keys before the first row" : "a few keys at a time";
  if (needs.random_access) words += ", segments in any order";
  if (needs.lengths) words += ", the length of each segment";
  return words;
}

}  // namespace tcb
