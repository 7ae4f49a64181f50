// JSON inputs: an array of keys, an object with "keys", one with "curves", JSON Lines, a table, or a list in another
// shape. Keys of an object are held until its settings are known.
//
// Source: RFC 8259.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>

#include "numbers/time_notation.hpp"
#include "read/input.hpp"
#include "read/json/columns.hpp"
#include "read/json/keys.hpp"
#include "read/json/splitter.hpp"
#include "read/json/tables.hpp"
#include "read/memory_use.hpp"
#include "schema/texts.hpp"
#include "schema/usual_names.hpp"
#include "stream/ordered_map.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;
using SharedColumns = std::shared_ptr<const JsonColumns>;

Error no_text() { return data_error("the input has no keys; expected a JSON object for each key; see --help"); }

/// A text that is read whole.
struct WholeJson {
  explicit WholeJson(JsonPart whole, std::uint64_t max_memory) : part(std::move(whole)), tape(part, max_memory) {}
  JsonPart part;
  JsonTape tape;
};

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
Parsed parse_part(const Task& task, const InputOptions& options) {
  if (task.part.kind == JsonPart::Kind::object) return {{}, read_curve_info(task.part, options), task.columns};
  return {parse_json(task.part, *task.columns), {}, task.columns};
}

/// Of keys that have none, until the members behind them are known.
constexpr spline::Tcb<double> unknown_tcb{std::numeric_limits<double>::quiet_NaN(),
                                          std::numeric_limits<double>::quiet_NaN(),
                                          std::numeric_limits<double>::quiet_NaN()};

/// The options with those settings of a file that keys are read by.
InputOptions with_settings(InputOptions options, const FileSettings& settings) {
  if (!options.keys.tcb) options.keys.tcb = settings.tcb;
  if (settings.frame_rate.empty() || options.units.time || options.units.frame_rate) return options;
  options.units.frame_rate = frame_rate_in(settings.frame_rate);
  options.units.are_optional = true;
  return options;
}

/// The values on the tape that are in the place of keys, in the first part of a list or of several values.
std::vector<std::uint32_t> first_values(JsonTape& tape) {
  if (tape.part().kind == JsonPart::Kind::list) return tape.elements(0);
  std::vector<std::uint32_t> values;
  try {
    for (std::size_t next = 0; tape.read_next(true); next = tape.size()) {
      values.push_back(static_cast<std::uint32_t>(next));
    }
  } catch (const Error&) {
    if (values.empty()) throw;  // others are thrown again when the keys are read
  }
  return values;
}

/// The meaning of the members of the first keys of a part.
JsonColumns columns_of(const JsonPart& part, bool are_rows, const InputOptions& options,
                       const std::vector<std::string>& channels) {
  JsonTape tape(part);
  std::vector<std::uint32_t> values = first_values(tape);
  const auto is_key = [&](std::size_t value) { return tape.kind(value) == (are_rows ? Kind::array : Kind::object); };
  const auto first = std::ranges::find_if(values, [&](std::size_t value) { return tape.kind(value) != Kind::null; });
  if (values.empty()) throw no_key_at_comma().at(tape.position_at(1));
  const std::size_t begin = first == values.end() ? values[0] : *first;
  if (!is_key(begin)) {
    if (tape[begin].is_nested()) throw not_a_record(tape, begin, are_rows);
    throw data_error(
        "found {} in the place of a key; expected an object, or an array of numbers, for each key; give a list of "
        "these",
        tape.kind(begin) == Kind::string ? in_quotes(tape.text(begin)) : tape.written(begin))
        .at(tape.position(begin));
  }
  const std::uint64_t number = part.chunk.first + static_cast<std::uint64_t>(first - values.begin());
  const std::vector<std::string> names =
      are_rows ? usual_names(tape.count(begin), options.columns.timeless) : std::vector<std::string>{};
  std::erase_if(values, [&](std::size_t value) { return !is_key(value); });
  JsonColumns columns =
      find_members(JsonTable(tape, std::move(values), names, part.chunk.path, number), options, channels);
  columns.row_names = names;
  return columns;
}

/// The parts of the text with the meaning of their keys, which the first key of each list determines. `first`: the
/// first part, and `columns` those of its keys if they are known.
Source<Task> tasks(JsonPart first, SharedColumns columns, const std::shared_ptr<JsonSplitter>& splitter,
                   const InputOptions& options) {
  return [splitter, options, first = std::optional(std::move(first)),
          columns = std::move(columns)]() mutable -> std::optional<Task> {
    std::optional<JsonPart> part = first ? std::exchange(first, std::nullopt) : splitter->next();
    if (!part) return std::nullopt;
    if (part->kind == JsonPart::Kind::object) return Task{std::move(*part), std::exchange(columns, nullptr)};
    if (columns == nullptr) {
      FileSettings settings = settings_before_keys(splitter->before_keys(), options);
      const JsonShape shape = splitter->shape();
      const bool are_rows = shape == JsonShape::table;
      if (shape == JsonShape::object || shape == JsonShape::curves) settings.tcb = unknown_tcb;
      columns = std::make_shared<const JsonColumns>(
          columns_of(*part, are_rows, with_settings(options, settings), settings.channels));
    }
    return Task{std::move(*part), columns};
  };
}

/// All keys of a list, and the members around them.
struct Curve {
  std::deque<KeyBlock> blocks;
  JsonCurveInfo members;
  JsonColumns columns;
};

TextPosition position_of_channels(const JsonCurveInfo& members) {
  const auto& places = members.settings.curve_info.places;
  const auto found = std::ranges::find_if(places, [](const auto& named) { return named.first.ends_with("channels"); });
  return found == places.end() ? members.position : found->second;
}

/// The memory of the numbers and the places of keys.
std::uint64_t bytes_of(const KeyBlock& block) {
  constexpr std::uint64_t of_places = 20;
  const std::uint64_t numbers = block.keys.positions.size() + 2 * block.keys.times.size() + 3 * block.keys.tcbs.size() +
                                2 * block.keys.velocities.size();
  return numbers * sizeof(double) + block.size() * of_places;
}

/// Sets the tension, continuity and bias of keys that have none.
void set_parameters(Curve& curve) {
  const spline::Tcb<double> all = curve.members.settings.tcb.value_or(spline::Tcb<double>{});
  const auto set = [&](spline::Tcb<double>& tcb) {
    if (std::isnan(tcb.tension)) tcb.tension = all.tension;
    if (std::isnan(tcb.continuity)) tcb.continuity = all.continuity;
    if (std::isnan(tcb.bias)) tcb.bias = all.bias;
  };
  for (KeyBlock& block : curve.blocks) {
    set(block.keys.common_tcb);
    std::ranges::for_each(block.keys.tcbs, set);
  }
}

/// Reads to the end of a list of keys and of the object around it; nothing at the end of the input.
/// Throws: Error (data) for more memory than is allowed, in bytes.
std::optional<Curve> read_curve(const Source<Parsed>& parts, const InputOptions& options) {
  MemoryUse memory(options.max_memory);
  Curve curve;
  SharedColumns columns;
  while (std::optional<Parsed> part = parts()) {
    if (part->columns != nullptr) columns = part->columns;
    if (part->members) {
      curve.members = std::move(*part->members);
      if (columns == nullptr) return curve;
      curve.columns = *columns;
      const FileSettings& settings = curve.members.settings;
      at_position(position_of_channels(curve.members), [&] { name_channels(curve.columns, settings.channels); });
      set_parameters(curve);
      return curve;
    }
    const bool unreadable = part->keys.faults.unreadable;
    memory.add(bytes_of(part->keys));
    curve.blocks.push_back(std::move(part->keys));
    if (!unreadable) continue;
    curve.columns = *columns;
    set_parameters(curve);
    return curve;
  }
  return std::nullopt;
}

std::string columns_in_words(const Columns& columns) {
  return fmt::format("{} and {}", in_quotes(columns.time), listed(columns.channels));
}

void require_same_columns(const Columns& first, const Columns& columns, const std::string& path) {
  if (columns.channels == first.channels && columns.time == first.time &&
      columns.has(Role::time) == first.has(Role::time))
    return;
  throw data_error("the keys have {}; expected {}, as in the first curve; give all curves the same members",
                   columns_in_words(columns), columns_in_words(first))
      .about(path);
}

/// It is the object around all curves, which comes last. Throws: Error (data) for settings there.
bool is_around_curves(const Curve& curve) {
  if (!curve.blocks.empty() || !curve.members.path.empty()) return false;
  const FileSettings& settings = curve.members.settings;
  if (settings.tcb) {
    throw data_error(
        "the object around the curves sets tension, continuity or bias; expected them in each curve; move them there, "
        "or give --tcb 0,0,0 to leave them out")
        .at(curve.members.position);
  }
  const auto& places = settings.curve_info.places;
  if (places.empty()) return true;
  throw data_error("this setting is outside the curves; expected it in each curve; move it there")
      .about(places[0].first)
      .at(places[0].second);
}

Error no_keys(const JsonCurveInfo& members) {
  if (members.path.empty()) return data_error("found no keys; expected at least two; add them").at(members.position);
  return data_error(
             "found no keys; expected at least two in \"keys\"; add them, remove the curve, or give their path to "
             "--records")
      .about(members.path)
      .at(members.position);
}

/// The ids of curves so far, each with the path of its last curve.
class CurveIds {
 public:
  explicit CurveIds(std::uint64_t max_memory) : memory_(max_memory) {}

  /// Throws: Error (data) where others are between this curve and one with the same id, whose rows would be one group.
  void add(const JsonCurveInfo& curve) {
    if (curve.path.empty()) return;  // it cannot be read
    const std::string& id = curve.settings.curve_info.id;
    const auto [found, is_new] = last_.try_emplace(id);
    if (is_new) {
      constexpr std::uint64_t of_entry = 128;
      memory_.add(of_entry + id.size() + curve.path.size());
    } else if (id != before_) {
      throw data_error(
          "this curve has {}, as {} has, but others are between them; expected the curves of one id one after "
          "another; give it another id, or move it behind {}",
          id.empty() ? "no id" : "the id " + in_quotes(content(id)), found->second, found->second)
          .about(curve.path)
          .at(curve.position);
    }
    found->second = curve.path;
    before_ = id;
  }

 private:
  MemoryUse memory_;
  std::unordered_map<std::string, std::string> last_;
  std::string before_;
};

/// The blocks of a curve with its information.
std::deque<KeyBlock> marked(Curve curve) {
  auto first = std::ranges::find_if(curve.blocks, [](const KeyBlock& block) { return !block.empty(); });
  if (first != curve.blocks.end()) {
    first->curve_info = std::make_shared<const CurveInfo>(std::move(curve.members.settings.curve_info));
  } else if (curve.blocks.empty()) {
    curve.blocks.emplace_back().faults.errors.push_back(no_keys(curve.members));
  }
  return std::move(curve.blocks);
}

/// The keys of all curves, each held until the members around them are known.
Source<KeyBlock> keys_of_curves(Source<Parsed> parts, Curve first, const InputOptions& options) {
  const Columns columns = first.columns.columns;
  CurveIds ids(options.max_memory);
  ids.add(first.members);
  return [parts = std::move(parts), ids = std::move(ids), blocks = each_of(marked(std::move(first))), columns,
          options]() mutable -> std::optional<KeyBlock> {
    for (;;) {
      if (std::optional<KeyBlock> block = blocks()) return block;
      std::optional<Curve> curve = read_curve(parts, options);
      if (!curve || is_around_curves(*curve)) return std::nullopt;
      ids.add(curve->members);
      if (!curve->blocks.empty()) {
        require_same_columns(columns, curve->columns.columns, curve->blocks.back().text_positions.path);
      }
      blocks = each_of(marked(std::move(*curve)));
    }
  };
}

Records records_of(const JsonColumns& meaning, JsonShape shape) {
  Records records{meaning.columns, meaning.units};
  records.columns.cells.resize(meaning.found);
  records.columns.named = true;
  records.facts.shape = shape;
  records.keys.traits.may_break = true;  // also at null in place of a key
  return records;
}

Records open_list(Source<Task> source, JsonShape shape, unsigned threads) {
  std::optional<Task> first = source();
  if (!first) throw no_text();
  Records records = records_of(*first->columns, shape);
  const auto parse = [](const Task& task) { return parse_json(task.part, *task.columns); };
  records.keys.blocks = ordered_map(preceded_by(std::move(*first), std::move(source)), parse, threads);
  return records;
}

void require_no_groups(const Columns& columns) {
  if (columns.groups.empty()) return;
  throw data_error(
      "the curves of \"curves\" are separate already; expected keys of several curves in one list; remove --group");
}

/// Adds what is told of settings, and of members that are none.
void add_notes(Records& records, const FileSettings& settings) {
  std::ranges::copy(settings.notes, std::back_inserter(records.columns.doubts));
  if (!settings.unused.empty()) {
    records.columns.doubts.push_back(fmt::format(
        "members beside the keys are not used: {}; settings are options, as in --preset NAME or --tcb T,C,B",
        listed(settings.unused)));
  }
  if (settings.tcb) records.facts.tcb = settings.tcb;
}

/// Notes the frame rate of the file: the times are frames at it, or it is not used.
void take_rate(FileSettings& settings, const UnitOptions& units, Records& records) {
  const std::string& rate = settings.frame_rate;
  if (rate.empty() || units.time || units.frame_rate) return;
  Columns& columns = records.columns;
  const bool counts = unit_of_time(columns.time) == TimeUnit::frames || counts_frames(records.units.notation);
  if (records.units.frame_rate && records.columns.has(Role::time) && counts) {
    records.frame_rate = records.units.frame_rate;
    const std::string exact =
        broadcast_rate(rate) ? fmt::format(", which is {},", ratio_text(*broadcast_rate(rate))) : ",";
    columns.doubts.push_back(
        fmt::format("the file sets {} to {}{} by which the times in column {} are frames; --time-unit frames undoes it",
                    settings.rate_name, rate, exact, in_quotes(columns.time)));
    return;
  }
  records.facts.shown_rate = rate;
  if (!columns.time_gap || unit_of_time(columns.time)) {
    settings.unused.push_back(settings.rate_name);
  } else {
    columns.doubts.push_back(fmt::format("{} is {}, and is not used; --input-fps {} takes the times as frames at it",
                                         in_quotes(settings.rate_name), rate, rate));
  }
}

/// An object with keys, or with curves. Keys are held until the members around them are known.
Records open_objects(Source<Task> source, JsonShape shape, const InputOptions& options) {
  const auto parse = [options](const Task& task) { return parse_part(task, options); };
  Source<Parsed> parts = ordered_map(std::move(source), parse, options.threads);
  std::optional<Curve> curve = read_curve(parts, options);
  if (!curve) throw no_text();
  if (curve->columns.key.inner.empty()) throw no_keys(curve->members);
  Records records = records_of(curve->columns, shape);
  FileSettings& settings = curve->members.settings;
  take_rate(settings, options.units, records);
  add_notes(records, settings);
  if (shape == JsonShape::object) {
    records.keys.curve_info = std::move(settings.curve_info);
    records.keys.blocks = each_of(std::move(curve->blocks));
    return records;
  }
  require_no_groups(records.columns);
  records.columns.groups = {"id"};
  records.keys.traits.own_curves = true;
  records.keys.blocks = keys_of_curves(std::move(parts), std::move(*curve), options);
  return records;
}

/// The keys of tables in blocks. Of several tables each is a curve, whose id is its path.
class TableKeys {
 public:
  TableKeys(std::shared_ptr<const WholeJson> text, std::vector<JsonTable> tables, JsonColumns columns,
            FileSettings settings, const InputOptions& options)
      : text_(std::move(text)),
        tables_(std::move(tables)),
        columns_(std::move(columns)),
        settings_(std::move(settings)),
        options_(options) {}

  std::optional<KeyBlock> operator()() {
    if (row_ >= tables_[table_].size()) {
      if (table_ + 1 == tables_.size()) return std::nullopt;
      begin_next();
    }
    const JsonTable& table = tables_[table_];
    constexpr std::size_t rows_of_block = 1000;
    const std::size_t end = std::min(row_ + rows_of_block, table.size());
    KeyBlock block = parse_table(table, row_, end, columns_, lines_);
    if (row_ == 0 && tables_.size() > 1) {
      CurveInfo info = settings_.curve_info;
      info.id = '"' + table.path();
      block.curve_info = std::make_shared<const CurveInfo>(std::move(info));
    }
    const bool is_read = block.faults.unreadable || block.faults.errors.size() >= most_faults;
    row_ = is_read ? table.size() : end;
    return block;
  }

 private:
  void begin_next() {
    const JsonTable& table = tables_[++table_];
    settings_ = settings_around(text_->tape, table, options_);
    JsonColumns columns = find_members(table, with_settings(options_, settings_), settings_.channels);
    require_same_columns(columns_.columns, columns.columns, table.path());
    columns_ = std::move(columns);
    row_ = 0;
    lines_ = begin();
  }
  LineCounter begin() const {
    const TextPosition begin = text_->tape.position_at(0);
    return LineCounter({begin.line, begin.column});
  }

  std::shared_ptr<const WholeJson> text_;
  std::vector<JsonTable> tables_;
  JsonColumns columns_;    ///< of the current table
  FileSettings settings_;  ///< around it
  InputOptions options_;
  std::size_t table_ = 0, row_ = 0;
  LineCounter lines_ = begin();
};

Records open_tables(std::shared_ptr<const WholeJson> text, std::vector<JsonTable> tables, const InputOptions& options,
                    JsonShape shape = JsonShape::any) {
  FileSettings settings = settings_around(text->tape, tables[0], options);
  JsonColumns columns = find_members(tables[0], with_settings(options, settings), settings.channels);
  Records records = records_of(columns, shape);
  std::ranges::copy(tables[0].others(), std::back_inserter(settings.unused));
  take_rate(settings, options.units, records);
  add_notes(records, settings);
  if (tables[0].joins_arrays()) {
    records.columns.doubts.emplace_back("the keys are the arrays that are as long as the one of times, a column each");
  }
  if (tables.size() > 1) {
    require_no_groups(records.columns);
    records.columns.groups = {"id"};
    records.keys.traits.own_curves = true;
  }
  records.facts.records = tables.size() > 1 ? options.records : tables[0].path();
  if (tables.size() == 1) records.keys.curve_info = settings.curve_info;
  records.keys.blocks = TableKeys(std::move(text), std::move(tables), std::move(columns), std::move(settings), options);
  return records;
}

/// A text that is one object, if its members are those of a key; else the reason.
std::optional<Records> open_one_key(const Chunk& text, const InputOptions& options, std::optional<Error>& reason) {
  JsonPart part{JsonPart::Kind::values, text};
  part.chunk.path = "keys";
  try {
    const auto columns = std::make_shared<const JsonColumns>(columns_of(part, false, options, {}));
    return open_list(each_of(std::deque{Task{std::move(part), columns}}), JsonShape::lines, options.threads);
  } catch (const Error& error) {
    reason = error;
    return std::nullopt;
  }
}

/// A text of any shape: a table, one key, or the lists in it.
Records open_whole(JsonPart part, const InputOptions& options) {
  const auto text = std::make_shared<const WholeJson>(std::move(part), options.max_memory);
  const JsonTape& tape = text->tape;
  if (!options.records.empty()) return open_tables(text, find_tables(tape, options), options);
  const bool is_object = tape.kind(0) == Kind::object;
  if (is_object) {
    std::optional<JsonTable> table;
    try {
      table = JsonTable::find(tape, 0, "", true, options.columns.timeless);
    } catch (const Error&) {  // columns differ in length
      table = JsonTable::of_arrays(tape);
      if (!table) throw;
    }
    if (table && table->size() > 0) {
      const bool has_times = table->has_times_in_index();
      return open_tables(text, {*table}, options, has_times ? JsonShape::table_by_index : JsonShape::table);
    }
  }
  std::vector<JsonTable> tables = find_tables(tape, options);
  if (!tables.empty()) return open_tables(text, std::move(tables), options);
  std::optional<Error> reason;
  std::optional<Records> key;
  if (is_object) key = open_one_key(text->part.chunk, options, reason);
  const bool has_time = key && key->columns.has(Role::time) && tape.member(0, key->columns.time);
  if (key && (has_time || options.columns.timeless)) return *std::move(key);
  if (reason) throw *reason;
  throw data_error(
      "found no list of keys; expected an array of objects or of rows, or an object of columns; give --records if it "
      "is there")
      .at({"", 1, 1});
}

/// Whether the first element of a list is an object that holds a list of records, or values of one column.
bool holds_table_in_first(const JsonPart& part) {
  try {
    const JsonTape tape(part);
    if (tape.size() < 2 || tape.kind(1) != Kind::object) return false;
    const auto values = tape.member(1, "data");
    return holds_table(tape, 1) || (values && tape.kind(*values) == Kind::array && tape.member(1, "type"));
  } catch (const Error&) {
    return false;
  }
}

JsonPart whole_text(Source<std::string> bytes, std::uint64_t max_memory) {
  JsonSplitter splitter(std::move(bytes), max_memory);
  return splitter.whole({JsonPart::Kind::list, {"]"}});
}

/// Where cells may be skipped all keys are kept, and numbers that no record has take memory, too.
Source<KeyBlock> within_memory(Source<KeyBlock> blocks, std::uint64_t max_memory) {
  return mapped(std::move(blocks), [memory = MemoryUse(max_memory)](KeyBlock block) mutable {
    const auto missing = std::ranges::count_if(block.keys.positions, [](double number) { return std::isnan(number); });
    memory.add(static_cast<std::uint64_t>(missing) * bytes_of_missing_number);
    return block;
  });
}

Records open_any_shape(Source<std::string> bytes, const InputOptions& options) {
  if (!options.records.empty()) return open_whole(whole_text(std::move(bytes), options.max_memory), options);
  const auto splitter = std::make_shared<JsonSplitter>(std::move(bytes), options.max_memory);
  std::optional<JsonPart> first = splitter->next();
  if (!first) throw no_text();
  const JsonShape shape = splitter->shape();
  if (first->kind == JsonPart::Kind::whole) return open_whole(*std::move(first), options);
  SharedColumns columns;
  if (shape == JsonShape::list) {
    std::optional<Error> fault;
    try {
      columns = std::make_shared<const JsonColumns>(columns_of(*first, false, options, {}));
    } catch (const Error& error) {
      fault = error;
    }
    const bool has_time = columns != nullptr && columns->columns.has(Role::time);
    if (!has_time) refuse_other_json(JsonTape(*first), options.columns, "");
    const bool may_be_series = fault || (options.columns.roles.empty() && !has_time);
    if (may_be_series && holds_table_in_first(*first)) return open_whole(splitter->whole(*std::move(first)), options);
    if (fault) throw Error(*fault);
  }
  Source<Task> source = tasks(*std::move(first), std::move(columns), splitter, options);
  const bool is_object = shape == JsonShape::object || shape == JsonShape::curves;
  return is_object ? open_objects(std::move(source), shape, options)
                   : open_list(std::move(source), shape, options.threads);
}

Records open_json(const Format&, Source<std::string> bytes, InputOptions options) {
  Records records = open_any_shape(std::move(bytes), options);
  if (options.keys.missing == Missing::skip_cell) {
    records.keys.blocks = within_memory(std::move(records.keys.blocks), options.max_memory);
  }
  return records;
}

std::optional<int> fit_of_json(std::string_view beginning) {
  const std::size_t at = beginning.find_first_not_of(" \t\r\n");
  if (at == std::string_view::npos || (beginning[at] != '[' && beginning[at] != '{')) return 0;
  const char next = at + 1 < beginning.size() ? lower(beginning[at + 1]) : '\0';
  const std::size_t end = std::min(beginning.find_first_of(",]\n", at), beginning.size());
  const bool is_stamp = beginning[at] == '[' && find_notation(beginning.substr(at + 1, end - at - 1));  // of a log
  const bool is_section = beginning[at] == '[' && next >= 'a' && next <= 'z' && next != 't' && next != 'f' &&
                          next != 'n' && next != 'i';  // of a text such as [Header], as no value begins so
  const std::size_t blank = beginning.find_first_of(" \t:\"\n", at + 1);
  const bool is_row = beginning[at] == '{' && next >= 'a' && next <= 'z' && blank != std::string_view::npos &&
                      beginning[blank] == ' ';  // as {X 10.5, Y 2}
  return is_section || is_stamp || is_row ? 0 : 2;
}

}  // namespace

extern const InputFormat json_input{.open = open_json, .fit = fit_of_json, .takes_delimiters = false};

}  // namespace tcb
