// Schema: what a record means: its time, its channels, the rotations and angles among these, its groups and labels.
#include "schema/schema.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "schema/columns.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

std::vector<std::string*> names_of(Schema& schema) {
  std::vector<std::string*> names;
  if (schema.time.is_given) names.push_back(&schema.time.name);
  std::vector<RotationColumns> others;  // whose numbers are shown in place of their channels
  std::ranges::copy_if(rotation_columns(schema), std::back_inserter(others),
                       [](const RotationColumns& rotation) { return !rotation.shown.is_quaternion(); });
  const std::vector<bool> are_hidden = spline::in_rotations(others, schema.channels.size());
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    if (!are_hidden[i]) names.push_back(&schema.channels[i]);
  }
  for (RotationSchema& rotation : schema.rotations) {
    for (std::string& name : rotation.names) names.push_back(&name);
  }
  for (auto* const list : {&schema.groups, &schema.labels}) {
    for (std::string& name : *list) names.push_back(&name);
  }
  return names;
}

}  // namespace

std::vector<std::string> moving_channels(const Schema& schema) {
  std::vector<std::string> channels;
  const std::vector<bool> are_in_rotations = spline::in_rotations(rotation_columns(schema), schema.channels.size());
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    if (!are_in_rotations[i]) channels.push_back(schema.channels[i]);
  }
  return channels;
}

std::vector<RotationColumns> rotation_columns(const Schema& schema) {
  std::vector<RotationColumns> columns;
  for (const RotationSchema& rotation : schema.rotations) columns.push_back(rotation.columns);
  return columns;
}

std::vector<bool> plain_channels(const Schema& schema) {
  return spline::plain_channels(rotation_columns(schema), schema.angles, schema.channels.size());
}

Schema schema_of(const Columns& columns, TimeNotation notation, const DateFormat& dates) {
  Schema schema;
  schema.named = columns.named;
  schema.time = {.is_given = columns.has(Role::time),
                 .is_by_place = columns.has_time_by_place,
                 .name = columns.time,
                 .notation = notation,
                 .dates = dates,
                 .unit = columns.has(Role::nanoseconds) ? std::optional(TimeUnit::s) : std::nullopt,
                 .likely = columns.likely_time};
  schema.channels = columns.channels;
  schema.groups = columns.groups;
  schema.labels = columns.labels;
  return schema;
}

Schema with_channels(const Schema& schema, std::vector<std::string> channels) {
  Schema result;
  result.named = true;
  result.time = schema.time;
  result.channels = std::move(channels);
  result.groups = schema.groups;
  return result;
}

void require_distinct_names(Schema schema, std::string_view option) {
  std::unordered_set<std::string_view> known;
  for (const std::string* name : names_of(schema)) {
    if (!known.insert(*name).second)
      throw data_error(
          "two columns of the output would be called {}; expected different names; choose another name, or rename the "
          "column in the input",
          in_quotes(*name))
          .about(option);
  }
}

Schema renamed(Schema schema, const std::vector<Renaming>& renamings) {
  const std::vector<std::string*> names = names_of(schema);
  std::vector<std::string> before;
  before.reserve(names.size());
  for (const std::string* name : names) before.push_back(*name);
  for (const Renaming& renaming : renamings) {
    const auto found = std::ranges::find(before, renaming.from);
    if (found == before.end()) throw no_such_column(renaming.from, before).about("--rename");
    *names[static_cast<std::size_t>(found - before.begin())] = renaming.to;
  }
  if (!renamings.empty()) require_distinct_names(schema, "--rename");
  return schema;
}

}  // namespace tcb
