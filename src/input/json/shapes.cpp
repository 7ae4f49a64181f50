// JSON: the shapes that an input may have, and the curves in it.
#include "input/json/shapes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "error.hpp"
#include "input/json/key_parser.hpp"
#include "input/json/members.hpp"
#include "input/json/settings.hpp"
#include "input/json/splitter.hpp"

namespace tcb {
namespace {

using SharedColumns = std::shared_ptr<const JsonColumns>;

/// A part of the text, and what the members of its keys mean.
struct Task {
  JsonPart part;
  SharedColumns columns;
};

/// Keys, or what stands beside those before.
struct Parsed {
  KeyBlock keys;
  std::optional<JsonCurveInfo> beside;
  SharedColumns columns;
};

/// A pure function. Throws: Error (data) for what stands beside keys.
Parsed parse_part(const Task& task) {
  if (task.part.curve_info) return {{}, read_beside(task.part), task.columns};
  return {parse_json(task.part.chunk, *task.columns), {}, task.columns};
}

/// The parts of the text with the meaning of their keys, which the first key of each list tells.
Source<Task> tasks(const std::shared_ptr<JsonSplitter>& splitter, const InputOptions& options) {
  return [splitter, options, columns = SharedColumns()]() mutable -> std::optional<Task> {
    std::optional<JsonPart> part = splitter->next();
    if (!part) return std::nullopt;
    if (part->curve_info) return Task{std::move(*part), std::exchange(columns, nullptr)};
    if (columns == nullptr) {
      const auto channels = channels_before_keys(splitter->before_keys());
      columns = std::make_shared<const JsonColumns>(find_members(part->chunk, options, channels));
    }
    return Task{std::move(*part), columns};
  };
}

/// All keys of a list, and what stands beside them.
struct Curve {
  std::deque<KeyBlock> blocks;
  JsonCurveInfo beside;
  JsonColumns columns;
  std::string path;
};

TextPosition place_of_channels(const JsonCurveInfo& beside) {
  const auto found = std::ranges::find(beside.keys.places, "channels", [](const auto& named) { return named.first; });
  return found == beside.keys.places.end() ? beside.place : found->second;
}

/// Reads on to the end of a list of keys and of the object around it; nothing at the end of the input.
std::optional<Curve> read_curve(const Source<Parsed>& parts) {
  Curve curve;
  SharedColumns columns;
  while (std::optional<Parsed> part = parts()) {
    if (part->columns != nullptr) columns = part->columns;
    if (part->beside) {
      curve.beside = std::move(*part->beside);
      if (columns == nullptr) return curve;
      curve.columns = *columns;
      at_position(place_of_channels(curve.beside), [&] { name_channels(curve.columns, curve.beside.channels); });
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
  throw Error(Exit::data, fmt::format("{}: keys with {}, {}; expected {}, {}, as in the first curve; correct them",
                                      curve.path, columns.time, fmt::join(columns.channels, ", "), first.time,
                                      fmt::join(first.channels, ", ")));
}

/// It is no curve but the object around all of them, which comes last. Throws: Error (data) for settings there.
bool is_around_curves(const Curve& curve) {
  if (!curve.blocks.empty() || !curve.beside.path.empty()) return false;
  const auto& places = curve.beside.keys.places;
  if (places.empty()) return true;
  throw Error(Exit::data, places[0].second,
              fmt::format("{}: beside the curves; expected in each of them; move it there", places[0].first));
}

Error no_keys(const JsonCurveInfo& beside) {
  return {Exit::data, beside.place,
          fmt::format("{}{}no keys; expected two at least; add them{}", beside.path, beside.path.empty() ? "" : ": ",
                      beside.path.empty() ? "" : ", or take the curve out")};
}

/// The blocks of a curve with what stands beside its keys.
std::deque<KeyBlock> marked(Curve curve) {
  auto first = std::ranges::find_if(curve.blocks, [](const KeyBlock& block) { return !block.lines.empty(); });
  if (first != curve.blocks.end()) {
    first->curve_info = std::make_shared<const CurveInfo>(std::move(curve.beside.keys));
  } else if (curve.blocks.empty()) {
    curve.blocks.emplace_back().faults.push_back(no_keys(curve.beside));
  }
  return std::move(curve.blocks);
}

/// The keys of all curves, each kept until what stands beside them is known.
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

[[noreturn]] void refuse_empty() {
  throw Error(Exit::data, "no keys: the input is empty; expected an object for each key; see --help");
}

JsonShape shape_of(JsonSplitter::Shape shape) {
  switch (shape) {
    case JsonSplitter::Shape::list: return JsonShape::list;
    case JsonSplitter::Shape::wrapped: return JsonShape::object;
    case JsonSplitter::Shape::curves: return JsonShape::curves;
    default: return JsonShape::lines;
  }
}

void describe(Input& input, const JsonColumns& meaning, JsonSplitter::Shape shape) {
  Columns columns = meaning.columns;
  columns.cells.resize(meaning.found);
  input.named = true;
  input.timed = columns.has(Role::time);
  input.time = columns.time;
  input.channels = columns.channels;
  input.groups = columns.groups;
  input.carried = columns.carried;
  input.ignored = columns.left_out;
  input.facts.roles = columns.shape_roles();
  input.facts.shape = shape_of(shape);
}

Input open_list(Source<Task> source, JsonSplitter::Shape shape, unsigned threads) {
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
    throw Error(Exit::usage,
                "--delimiter, --header, --no-header, --comment and --decimal have no effect on JSON; take them out, or "
                "give the format with -i");
  }
  const auto splitter = std::make_shared<JsonSplitter>(std::move(bytes));
  Source<Task> source = tasks(splitter, options);
  std::optional<Task> first = source();
  if (!first) refuse_empty();
  const JsonSplitter::Shape shape = splitter->shape();
  source = preceded_by(std::move(*first), std::move(source));
  const bool wrapped = shape == JsonSplitter::Shape::wrapped, curves = shape == JsonSplitter::Shape::curves;
  Input input;
  if (!wrapped && !curves) {
    input = open_list(std::move(source), shape, options.threads);
  } else {
    Source<Parsed> parts = ordered_map(std::move(source), parse_part, options.threads);
    std::optional<Curve> curve = read_curve(parts);
    if (!curve) refuse_empty();
    if (curve->columns.members.empty()) throw no_keys(curve->beside);
    describe(input, curve->columns, shape);
    if (wrapped) {
      input.curve_info = std::move(curve->beside.keys);
      input.keys = blocks_of(std::move(curve->blocks));
    } else {
      if (!input.groups.empty()) {
        throw Error(Exit::data,
                    "--group has no meaning for an object with curves, which are told apart already; take "
                    "it out");
      }
      input.groups = {"id"};
      input.own_curves = true;
      input.keys = keys_of_curves(std::move(parts), std::move(*curve));
    }
  }
  input.may_miss = options.missing == Missing::skip_cell;
  input.may_break = true;  // at null in the place of a key, too
  return input;
}

}  // namespace tcb
