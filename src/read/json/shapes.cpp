// Shapes of JSON inputs: lists of keys, objects with keys, objects with curves, JSON Lines, tables.
#include "read/json/shapes.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "option_names.hpp"
#include "read/json/errors.hpp"
#include "read/json/key_reader.hpp"
#include "read/json/members.hpp"
#include "read/json/settings.hpp"
#include "read/json/splitter.hpp"
#include "read/json/tables.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {
namespace {

using SharedColumns = std::shared_ptr<const JsonColumns>;

/// A part of the text, and the meaning of the members of its keys.
struct Task {
  JsonPart part;
  SharedColumns columns;
};

/// Keys, or the members around the previous keys.
struct Parsed {
  KeyBlock keys;
  std::optional<JsonCurveInfo> members;
  SharedColumns columns;
};

/// A pure function. Throws: Error (data) for the members around keys.
Parsed parse_part(const Task& task) {
  if (task.part.kind == JsonPart::Kind::object) return {{}, read_curve_info(task.part), task.columns};
  return {parse_json(task.part, *task.columns), {}, task.columns};
}

/// The parts of the text with the meaning of their keys, which the first key of each list determines.
Source<Task> tasks(const std::shared_ptr<JsonSplitter>& splitter, const InputOptions& options) {
  return [splitter, options, columns = SharedColumns()]() mutable -> std::optional<Task> {
    std::optional<JsonPart> part = splitter->next();
    if (!part) return std::nullopt;
    if (part->kind == JsonPart::Kind::object) return Task{std::move(*part), std::exchange(columns, nullptr)};
    if (columns == nullptr) {
      const auto channels = channels_before_keys(splitter->before_keys());
      columns = std::make_shared<const JsonColumns>(find_members(*part, options, channels));
    }
    return Task{std::move(*part), columns};
  };
}

/// All keys of a list, and the members around them.
struct Curve {
  std::deque<KeyBlock> blocks;
  JsonCurveInfo members;
  JsonColumns columns;
  std::string path;
};

TextPosition position_of_channels(const JsonCurveInfo& members) {
  const auto& places = members.curve_info.places;
  const auto found = std::ranges::find(places, "channels", [](const auto& named) { return named.first; });
  return found == places.end() ? members.position : found->second;
}

/// Reads to the end of a list of keys and of the object around it; nothing at the end of the input.
std::optional<Curve> read_curve(const Source<Parsed>& parts) {
  Curve curve;
  SharedColumns columns;
  while (std::optional<Parsed> part = parts()) {
    if (part->columns != nullptr) columns = part->columns;
    if (part->members) {
      curve.members = std::move(*part->members);
      if (columns == nullptr) return curve;
      curve.columns = *columns;
      at_position(position_of_channels(curve.members), [&] { name_channels(curve.columns, curve.members.channels); });
      return curve;
    }
    const bool unreadable = part->keys.faults.unreadable;
    curve.path = part->keys.text_positions.path;
    curve.blocks.push_back(std::move(part->keys));
    if (!unreadable) continue;
    curve.columns = *columns;
    return curve;
  }
  return std::nullopt;
}

Source<KeyBlock> blocks_of(std::deque<KeyBlock> blocks) {
  return [blocks = std::move(blocks)]() mutable -> std::optional<KeyBlock> {
    if (blocks.empty()) return std::nullopt;
    KeyBlock block = std::move(blocks.front());
    blocks.pop_front();
    return block;
  };
}

void require_same_columns(const Columns& first, const Curve& curve) {
  const Columns& columns = curve.columns.columns;
  if (columns.channels == first.channels && columns.time == first.time &&
      columns.has(Role::time) == first.has(Role::time))
    return;
  throw json::curves_differ(columns.time, columns.channels, first.time, first.channels).about(curve.path);
}

/// It is the object around all curves, which comes last. Throws: Error (data) for settings there.
bool is_around_curves(const Curve& curve) {
  if (!curve.blocks.empty() || !curve.members.path.empty()) return false;
  const auto& places = curve.members.curve_info.places;
  if (places.empty()) return true;
  throw json::setting_outside_curves().about(places[0].first).at(places[0].second);
}

Error no_keys(const JsonCurveInfo& members) {
  if (members.path.empty()) return json::no_keys().at(members.position);
  return json::curve_without_keys().about(members.path).at(members.position);
}

/// The blocks of a curve with its information.
std::deque<KeyBlock> marked(Curve curve) {
  auto first = std::ranges::find_if(curve.blocks, [](const KeyBlock& block) { return !block.empty(); });
  if (first != curve.blocks.end()) {
    first->curve_info = std::make_shared<const CurveInfo>(std::move(curve.members.curve_info));
  } else if (curve.blocks.empty()) {
    curve.blocks.emplace_back().faults.errors.push_back(no_keys(curve.members));
  }
  return std::move(curve.blocks);
}

/// The keys of all curves, each held until the members around them are known.
Source<KeyBlock> keys_of_curves(Source<Parsed> parts, Curve first) {
  const Columns columns = first.columns.columns;
  return [parts = std::move(parts), left = marked(std::move(first)), columns]() mutable -> std::optional<KeyBlock> {
    while (left.empty()) {
      std::optional<Curve> curve = read_curve(parts);
      if (!curve || is_around_curves(*curve)) return std::nullopt;
      if (!curve->blocks.empty()) require_same_columns(columns, *curve);
      left = marked(std::move(*curve));
    }
    KeyBlock block = std::move(left.front());
    left.pop_front();
    return block;
  };
}

Records records_of(const JsonColumns& meaning, JsonShape shape) {
  Records records{meaning.columns, meaning.units.notation, meaning.units.dates, meaning.units.epoch_unit};
  records.columns.cells.resize(meaning.found);
  records.columns.named = true;
  records.facts.shape = shape;
  return records;
}

Records open_list(Source<Task> source, JsonShape shape, unsigned threads) {
  std::optional<Task> first = source();
  if (!first) throw json::no_text();
  Records records = records_of(*first->columns, shape);
  const auto parse = [](const Task& task) { return parse_json(task.part, *task.columns); };
  records.keys.blocks = ordered_map(preceded_by(std::move(*first), std::move(source)), parse, threads);
  return records;
}

Records open_text(Source<std::string> bytes, const InputOptions& options) {
  const auto splitter = std::make_shared<JsonSplitter>(std::move(bytes));
  Source<Task> source = tasks(splitter, options);
  std::optional<Task> first = source();
  if (!first) throw json::no_text();
  const JsonShape shape = splitter->shape();
  source = preceded_by(std::move(*first), std::move(source));
  const bool curves = shape == JsonShape::curves;
  Records records;
  if (!curves && shape != JsonShape::object) {
    records = open_list(std::move(source), shape, options.threads);
  } else {
    Source<Parsed> parts = ordered_map(std::move(source), parse_part, options.threads);
    std::optional<Curve> curve = read_curve(parts);
    if (!curve) throw json::no_text();
    if (curve->columns.members.empty()) throw no_keys(curve->members);
    records = records_of(curve->columns, shape);
    std::vector<std::string>& ignored = records.columns.ignored;
    ignored.insert(ignored.end(), curve->members.unused.begin(), curve->members.unused.end());
    if (!curves) {
      records.keys.curve_info = std::move(curve->members.curve_info);
      records.keys.blocks = blocks_of(std::move(curve->blocks));
    } else {
      if (!records.columns.groups.empty()) throw json::groups_of_curves();
      records.columns.groups = {"id"};
      records.keys.traits.own_curves = true;
      records.keys.blocks = keys_of_curves(std::move(parts), std::move(*curve));
    }
  }
  records.keys.traits.may_break = true;  // also at null in place of a key
  return records;
}

/// The same keys without text positions.
KeyBlock without_positions(KeyBlock block) {
  std::ranges::fill(block.text_positions.lines, 0);
  std::ranges::fill(block.text_positions.columns, 0);
  for (Error& fault : block.faults.errors) fault = fault.without_position();
  return block;
}

/// The keys of a table. Its text is not that of the input, so errors have paths such as "[3].x", but no positions.
Records open_table(JsonTable table, const InputOptions& options) {
  Source<std::string> list = [text = std::optional(std::move(table.list))]() mutable {
    return std::exchange(text, std::nullopt);
  };
  try {
    Records records = open_text(std::move(list), options);
    records.facts.shape = table.has_times_in_index ? JsonShape::table_by_index : JsonShape::table;
    records.keys.blocks = mapped(std::move(records.keys.blocks), without_positions);
    return records;
  } catch (const Error& error) {
    throw error.without_position();
  }
}

}  // namespace

Records open_json(Source<std::string> bytes, const InputOptions& options) {
  if (options.delimited != DelimitedOptions{}) throw json::options_of_delimited_text();
  std::optional<JsonTable> table = take_table(bytes);
  return table ? open_table(*std::move(table), options) : open_text(std::move(bytes), options);
}

}  // namespace tcb
