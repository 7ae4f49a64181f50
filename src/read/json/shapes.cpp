// Shapes of JSON inputs: lists of keys, objects with keys, objects with curves.
#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "error.hpp"
#include "option_names.hpp"
#include "read/json/json_input.hpp"
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
  if (task.part.is_object) return {{}, read_curve_info(task.part), task.columns};
  return {parse_json(task.part.chunk, *task.columns), {}, task.columns};
}

/// The parts of the text with the meaning of their keys, which the first key of each list determines.
Source<Task> tasks(const std::shared_ptr<JsonSplitter>& splitter, const InputOptions& options) {
  return [splitter, options, columns = SharedColumns()]() mutable -> std::optional<Task> {
    std::optional<JsonPart> part = splitter->next();
    if (!part) return std::nullopt;
    if (part->is_object) return Task{std::move(*part), std::exchange(columns, nullptr)};
    if (columns == nullptr) {
      const auto channels = channels_before_keys(splitter->before_keys());
      columns = std::make_shared<const JsonColumns>(find_members(part->chunk, options, channels));
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
    const bool unreadable = part->keys.unreadable;
    curve.path = part->keys.path;
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
  throw Error(Exit::data, ErrorCode::json_curves_differ,
              {curve.path, columns.time, columns.channels, first.time, first.channels});
}

/// It is the object around all curves, which comes last. Throws: Error (data) for settings there.
bool is_around_curves(const Curve& curve) {
  if (!curve.blocks.empty() || !curve.members.path.empty()) return false;
  const auto& places = curve.members.curve_info.places;
  if (places.empty()) return true;
  throw Error(Exit::data, ErrorCode::setting_outside_curves, {places[0].first}).at(places[0].second);
}

Error no_keys(const JsonCurveInfo& members) {
  if (members.path.empty()) return Error(Exit::data, ErrorCode::json_without_keys).at(members.position);
  return Error(Exit::data, ErrorCode::json_curve_without_keys, {members.path}).at(members.position);
}

/// The blocks of a curve with its information.
std::deque<KeyBlock> marked(Curve curve) {
  auto first = std::ranges::find_if(curve.blocks, [](const KeyBlock& block) { return !block.lines.empty(); });
  if (first != curve.blocks.end()) {
    first->curve_info = std::make_shared<const CurveInfo>(std::move(curve.members.curve_info));
  } else if (curve.blocks.empty()) {
    curve.blocks.emplace_back().faults.push_back(no_keys(curve.members));
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

[[noreturn]] void refuse_empty() { throw Error(Exit::data, ErrorCode::empty_json); }

void describe(Input& input, const JsonColumns& meaning, JsonShape shape) {
  Columns columns = meaning.columns;
  columns.cells.resize(meaning.found);
  columns.named = true;
  input.set_columns(columns);
  input.time_notation = meaning.rules.notation;
  input.facts.shape = shape;
}

Input open_list(Source<Task> source, JsonShape shape, unsigned threads) {
  std::optional<Task> first = source();
  if (!first) refuse_empty();
  Input input;
  describe(input, *first->columns, shape);
  const auto parse = [](const Task& task) { return parse_json(task.part.chunk, *task.columns); };
  input.keys = ordered_map(preceded_by(std::move(*first), std::move(source)), parse, threads);
  return input;
}

}  // namespace

Input open_json(Source<std::string> bytes, const InputOptions& options) {
  if (options.delimiter || options.header || options.decimal != '.' || options.comment != "#") {
    throw Error(Exit::usage, ErrorCode::text_options_on_json);
  }
  const auto splitter = std::make_shared<JsonSplitter>(std::move(bytes));
  Source<Task> source = tasks(splitter, options);
  std::optional<Task> first = source();
  if (!first) refuse_empty();
  const JsonShape shape = splitter->shape();
  source = preceded_by(std::move(*first), std::move(source));
  const bool curves = shape == JsonShape::curves;
  Input input;
  if (!curves && shape != JsonShape::object) {
    input = open_list(std::move(source), shape, options.threads);
  } else {
    Source<Parsed> parts = ordered_map(std::move(source), parse_part, options.threads);
    std::optional<Curve> curve = read_curve(parts);
    if (!curve) refuse_empty();
    if (curve->columns.members.empty()) throw no_keys(curve->members);
    describe(input, curve->columns, shape);
    input.ignored.insert(input.ignored.end(), curve->members.unused.begin(), curve->members.unused.end());
    if (!curves) {
      input.curve_info = std::move(curve->members.curve_info);
      input.keys = blocks_of(std::move(curve->blocks));
    } else {
      if (!input.groups.empty()) throw Error(Exit::data, ErrorCode::groups_of_curves).about(option::group);
      input.groups = {"id"};
      input.own_curves = true;
      input.keys = keys_of_curves(std::move(parts), std::move(*curve));
    }
  }
  input.may_miss = options.missing == Missing::skip_cell;
  input.may_break = true;  // also at null in place of a key
  return input;
}

}  // namespace tcb
