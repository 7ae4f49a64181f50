// Pace profiles: files of keys whose curve tells where rows are on another one.
#include "run/pace_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/formats.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "read/input.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/fields.hpp"
#include "sample/rows.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::string_view part_of_length = "fraction";

/// The channel of the distances. Throws: Error (data) where its name does not tell it.
std::size_t distance_channel(const Schema& schema, const PaceFile& file) {
  if (!file.column.empty()) return 0;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    const std::string_view name = schema.channels[i];
    if (same_in_any_case(name, "s") || same_in_any_case(name, part_of_length)) found.push_back(i);
  }
  if (found.size() == 1) return found[0];
  throw data_error(
      "{}; expected one column of arc lengths, or of parts of the length from 0 to 1; name it, as in --pace "
      "@FILE:COLUMN",
      found.empty() ? "a profile has no column s or fraction" : "a profile has several columns s or fraction");
}

/// What the rules of the keys are for a single open channel.
CurveSettings rules_of(CurveSettings rules) {
  rules.closed.reset();
  rules.period.reset();
  rules.extrapolate.reset();
  rules.metric.reset();
  rules.parameter.reset();
  if (rules.ends && !(rules.ends->value.first.velocity.empty() && rules.ends->value.last.velocity.empty())) {
    rules.ends.reset();  // whose velocities are those of the channels of the keys
  }
  rules.no_overshoot = rules.tangents != spline::TangentRule::linear;
  return rules;
}

/// Notes the largest distance of the keys. Throws: Error (data) for a distance that no curve has.
void observe(PaceProfile& profile, const KeyBlock& block, std::size_t channel) {
  for (std::size_t key = 0; key < block.keys.size(); ++key) {
    const double distance = block.keys.position(key)[channel];
    const TextPosition place{"", block.text_positions.lines[key], 0};
    if (distance < 0 || (profile.are_parts && distance > 1)) {
      throw data_error("the distance {} is not on the curve; expected {}", distance,
                       profile.are_parts ? "a part of the length from 0 to 1" : "an arc length of 0 or more")
          .at(place);
    }
    if (distance <= profile.largest) continue;
    profile.largest = distance;
    profile.largest_place = place;
  }
}

/// The error without a remedy by options of the keys, which do not apply to a profile.
Error of_profile(const Error& error) {
  const std::string_view message = error.message();
  const std::size_t remedy = message.rfind("; ");
  const bool is_by_option = remedy != std::string_view::npos && message.find("--", remedy) != std::string_view::npos &&
                            message.find("--pace", remedy) == std::string_view::npos;
  if (!is_by_option) return error;
  return Error(error.exit(), fmt::format("{}; correct the profile, to which options of the keys do not apply",
                                         message.substr(0, remedy)))
      .at(error.position());
}

PaceProfile read(const PaceFile& file, const SamplingRequest& request, const KeyOptions& keys) {
  InputOptions options;
  options.units = {
      .frame_rate = keys.input.units.frame_rate, .date_order = keys.input.units.date_order, .are_optional = true};
  options.keys.tcb = keys.input.keys.tcb;
  options.rotation.none = true;
  if (!file.column.empty()) {
    options.columns.roles = {{.role = Role::position, .columns = {file.column}, .option = "--pace"}};
  }
  const Input input = open_input(file.path, keys.bytes_of(file.path).bytes, options);
  const std::size_t channel = distance_channel(input.schema, file);
  if (!input.schema.time.is_given) {
    throw data_error("a profile has no column of times; expected one; name it time, or correct the profile");
  }
  const CurveRequest samples{
      .samples = request,
      .rules = rules_of(keys.rules),
      .fields = {field_of("time"), field_of("position"), field_of("velocity"), field_of("acceleration")}};
  PaceProfile profile{.are_parts = same_in_any_case(input.schema.channels[channel], part_of_length),
                      .notation = input.schema.time.notation,
                      .unit = input.schema.time.unit};
  Curves curves(input.schema, input.keys, {});
  std::optional<InputCurve> curve = curves.next();
  if (!curve) throw data_error("found no keys; expected at least two");
  CurvePipeline pipeline(samples, input.schema, input.keys.traits, *curve->curve_info);
  const CurveSamples rows = pipeline.samples(
      observed(std::move(curve->keys), [&](const KeyBlock& block) { observe(profile, block, channel); }));
  const std::size_t channels = input.schema.channels.size();
  while (const std::optional<SampleBlock> block = rows.blocks()) {
    const Table table = rows.evaluate(*block, samples.fields);
    const std::size_t width = 1 + 3 * channels;
    for (std::size_t row = 0; row < table.cells.size(); row += width) {
      const auto value = [&](std::size_t field) { return table.cells[row + 1 + field * channels + channel].hi; };
      profile.rows.push_back({{table.cells[row], value(1), value(2)}, value(0)});
    }
  }
  if (curves.next()) throw data_error("a profile has several curves; expected one; remove the others");
  return profile;
}

}  // namespace

std::shared_ptr<const PaceProfile> read_pace_profile(const PaceFile& file, const SamplingRequest& request,
                                                     const KeyOptions& keys) {
  const std::string name = shown_name(file.path);
  PaceProfile profile = in_file(name, [&] {
    try {
      return read(file, request, keys);
    } catch (const Error& error) {
      throw of_profile(error);
    }
  });
  profile.largest_place.file = name;
  return std::make_shared<const PaceProfile>(std::move(profile));
}

}  // namespace tcb
