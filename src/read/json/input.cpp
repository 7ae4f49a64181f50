// JSON inputs: the tables of a text become delimited text with commas, part by part, which is read as such; faults and
// keys get their places in JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <unordered_map>
#include <utility>

#include "numbers/time_notation.hpp"
#include "read/csv/csv_reader.hpp"
#include "read/input.hpp"
#include "read/json/cells.hpp"
#include "read/json/settings.hpp"
#include "read/json/tables.hpp"
#include "read/json/text.hpp"
#include "read/memory_use.hpp"
#include "schema/texts.hpp"
#include "schema/usual_names.hpp"
#include "stream/ordered_map.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using std::string_literals::operator""s;
using Kind = Json::Kind;
using SharedJson = std::shared_ptr<const Json>;

/// The meaning of the records of a table.
struct Meaning {
  SharedJson first;                        ///< whose text has the names in the layout
  std::shared_ptr<const JsonTable> table;  ///< whose columns have such names
  JsonLayout layout;
  DelimitedHead head = {};
  Columns columns = {};  ///< those that the first records have
};

/// Successive records of a table, and what their cells are.
struct TablePart {
  SharedJson json;
  std::shared_ptr<const JsonTable> table;
  std::shared_ptr<const Meaning> meaning;
  std::size_t first = 0, last = 0;
  std::shared_ptr<const CurveInfo> curve_info = {};  ///< of a curve that begins here
  std::vector<Error> faults = {};                    ///< of values that are not among the records
};

/// Records as delimited text.
struct PlainText {
  std::string text = {};
  std::vector<std::size_t> rows = {}, begins = {};  ///< the record of each line or lines, and their offset
  std::vector<std::uint64_t> lines = {};            ///< and their first line
  std::uint64_t next_line = 1;
};

/// Adds a record as one row, or an empty line for null.
void add_row(PlainText& plain, const Json& json, const JsonLayout& layout, JsonRows& rows, std::size_t row,
             std::vector<std::uint32_t>& cells) {
  const bool is_record = rows.get(row, cells);
  std::string& text = plain.text;
  const std::size_t begin = text.size();
  std::size_t count = 0;
  for (std::size_t i = 0; is_record && i < cells.size(); ++i) {
    if (!layout.columns[i].is_used) continue;
    if (count++ > 0) text += ',';
    if (cells[i] == 0) continue;
    const bool is_text = json.is(cells[i], Kind::string) || json.is_name(cells[i]);
    is_text ? add_quoted(text, json.text(cells[i])) : void(text += json.text(cells[i]));
  }
  if (is_record && text.size() == begin) text += "\"\"";  // a cell alone, so that the line is not empty
  text += '\n';
  plain.rows.push_back(row);
  plain.begins.push_back(begin);
  plain.lines.push_back(plain.next_line);
  plain.next_line +=
      static_cast<std::uint64_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), '\n'));
}

/// Puts the places in JSON into keys and faults.
class Places {
 public:
  Places(const TablePart& part, const PlainText& plain)
      : part_(part), json_(*part.json), table_(*part.table), plain_(plain) {}

  void restore(KeyBlock& block) {
    KeyTextPositions& places = block.text_positions;
    places.path = table_.list();
    places.numbers.clear();
    for (std::size_t key = 0; key < places.lines.size(); ++key) {
      const std::size_t row = plain_.rows[line_of(places.lines[key])];
      mark_ = json_.mark_at(json_.offset(table_.place(row)), mark_);
      places.numbers.push_back(table_.number + row);
      places.lines[key] = mark_.at.line;
      places.columns[key] = static_cast<std::uint32_t>(mark_.at.column);
    }
    for (Error& fault : block.faults.errors) fault = restored(fault);
  }

  /// A fault with the place of its cell in JSON; one of the names is at the first record.
  Error restored(const Error& fault) const {
    const TextPosition& at = fault.position();
    const Error plain = Error(fault.exit(), fault.message());
    if (at.line == 0) return plain.at(json_.position(table_.place(part_.first)));
    const auto& columns = part_.meaning->layout.columns;
    if (columns.empty() || plain_.lines.empty() || at.line < plain_.lines.front() || at.column == 0) {
      return plain.at(json_.position(table_.place(part_.first)));
    }
    const std::size_t line = line_of(at.line), row = plain_.rows[line];
    std::vector<std::uint32_t> cells;
    JsonRows rows(json_, table_, part_.meaning->layout);
    rows.get(row, cells);
    std::size_t left = cell_at(line, at), column = 0;
    while (column + 1 < columns.size() && (!columns[column].is_used || left-- > 0)) ++column;
    return of_cell(fault, row, columns[column], cells[column]);
  }

 private:
  Error of_cell(const Error& fault, std::size_t row, const JsonColumn& column, std::uint32_t value) const {
    std::string message = fault.message();
    for (const std::string& name : {column.name, fmt::format("column {}", in_quotes(column.name)), "time"s}) {
      if (message.starts_with(name + ": ")) message.erase(0, name.size() + 2);
    }
    constexpr std::string_view empty = "found an empty cell; expected ";
    if (value == 0 && message.starts_with(empty)) {
      message.resize(std::min(message.find(", or --columns"), message.size()));
      message =
          fmt::format("the key has no member {}; expected the members of the first key; add it{}",
                      in_quotes(column.path), message.substr(std::min(message.find(", or give"), message.size())));
      return Error(fault.exit(), message).at(json_.position(table_.place(row)));
    }
    const bool is_null = value != 0 && json_.is(value, Kind::null);
    for (const std::string_view found : {"found \"null\"", "found an empty cell"}) {
      if (is_null && message.starts_with(found)) message.replace(0, found.size(), "found null");
    }
    const std::size_t place = value != 0 ? value : table_.place(row);
    return Error(fault.exit(), message)
        .about(fmt::format("{}[{}].{}", table_.list(), table_.number + row, column.path))
        .at(json_.position(place));
  }

  std::size_t line_of(std::uint64_t line) const {
    const auto after = std::upper_bound(plain_.lines.begin(), plain_.lines.end(), line);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - plain_.lines.begin(), 1) - 1);
  }

  /// The number of the cell at a place of a row.
  std::size_t cell_at(std::size_t line, const TextPosition& wanted) const {
    const std::string_view text = plain_.text;
    LinePosition at{plain_.lines[line], 1};
    std::size_t cell = 0;
    bool is_quoted = false;
    for (std::size_t i = plain_.begins[line]; i < text.size(); ++i) {
      if (at.line > wanted.line || (at.line == wanted.line && at.column >= wanted.column)) break;
      if (text[i] == '"') is_quoted = !is_quoted;
      if (text[i] == ',' && !is_quoted) ++cell;
      at = position_after(text.substr(i, 1), at);
    }
    return cell;
  }

  const TablePart& part_;
  const Json& json_;
  const JsonTable& table_;
  const PlainText& plain_;
  Json::Mark mark_ = {0, {0, 0}};  ///< the last record; line 0: there is none
};

/// The keys of records. A pure function.
KeyBlock keys_of(const TablePart& part) {
  const Json& json = *part.json;
  const JsonLayout& layout = part.meaning->layout;
  JsonRows rows(json, *part.table, layout);
  PlainText plain{.next_line = part.table->number + part.first + 2};
  const std::uint64_t line = plain.next_line;
  std::vector<std::uint32_t> cells;
  std::vector<Error> faults = part.faults;
  for (std::size_t row = part.first; row < part.last; ++row) {
    try {
      add_row(plain, json, layout, rows, row, cells);
    } catch (const Error& error) {
      faults.push_back(error);
      if (faults.size() == most_faults) break;
    }
  }
  Chunk chunk{std::move(plain.text), line};
  KeyBlock block = parse_delimited(chunk, part.meaning->head);
  plain.text = std::move(chunk.text);
  Places(part, plain).restore(block);
  auto& errors = block.faults.errors;
  errors.insert(errors.end(), faults.begin(), faults.end());
  std::ranges::stable_sort(
      errors, {}, [](const Error& error) { return std::pair(error.position().line, error.position().column); });
  block.curve_info = part.curve_info;
  return block;
}

/// The options for the delimited text of a table.
InputOptions options_of_text(const InputOptions& options, const JsonLayout& layout, const JsonTable& table) {
  InputOptions of_text = with_columns_of_layout(options, layout);
  of_text.delimited = {.delimiter = ',',
                       .header = table.has_header(),
                       .comment = "",
                       .is_plain = true,
                       .meant = layout.meant,
                       .array = layout.array,
                       .has_decimal = true};
  return of_text;
}

/// Members without a role may have any value in later records.
void leave_ignored_members(Meaning& meaning) {
  JsonLayout& layout = meaning.layout;
  std::size_t cell = 0;
  std::vector<bool> are_ignored(layout.columns.size());
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const JsonColumn& column = layout.columns[i];
    if (column.is_used) are_ignored[i] = meaning.head.columns.cells[cell++].role == Role::ignored && column.depth == 0;
  }
  for (std::uint32_t step = 1; step < layout.paths.size(); ++step) {
    const std::size_t column = layout.paths.column(step);
    if (column != JsonPaths::no_column && are_ignored[column]) layout.paths.set_unused(step);
  }
}

/// Tension, continuity and bias may be in any key, even if the first ones have none, unless no tangent depends on them.
void add_optional_parameters(Meaning& meaning) {
  Columns& columns = meaning.head.columns;
  const auto is_given = [&](std::size_t channel) {
    return std::ranges::any_of(columns.cells, [&](const Columns::Column& cell) {
      return cell.channel == channel && (cell.role == Role::velocity || cell.role == Role::velocity_in);
    });
  };
  std::size_t channel = 0;
  while (channel < columns.channels.size() && is_given(channel)) ++channel;
  const bool has_parameters = columns.has(Role::tension) || columns.has(Role::continuity) || columns.has(Role::bias);
  if (channel == columns.channels.size() || has_parameters || meaning.layout.paths.find_member("tcb") != 0) return;
  add_parameters(meaning.layout);
  for (const Role role : {Role::tension, Role::continuity, Role::bias}) columns.cells.push_back({role, 0});
}

/// The options with those settings of a file that keys are read by.
InputOptions with_settings(InputOptions options, const FileSettings& settings) {
  if (!options.keys.tcb) options.keys.tcb = settings.tcb;
  if (settings.frame_rate.empty() || options.units.time || options.units.frame_rate) return options;
  options.units.frame_rate = frame_rate_in(settings.frame_rate);
  options.units.are_optional = true;
  options.keys.counts_rows = options.keys.missing == Missing::skip_row;
  return options;
}

/// The meaning of the records of a table, by the first of them.
std::shared_ptr<const Meaning> meaning_of(const SharedJson& json, const std::shared_ptr<const JsonTable>& table,
                                          const InputOptions& given, const FileSettings& settings) {
  const InputOptions options = with_settings(given, settings);
  auto meaning = std::make_shared<Meaning>(Meaning{json, table, find_layout(*json, *table, options, settings)});
  const JsonLayout& layout = meaning->layout;
  PlainText plain;
  if (table->has_header()) {
    for (const JsonColumn& column : layout.columns) {
      if (!column.is_used) continue;
      if (!plain.text.empty()) plain.text += ',';
      add_quoted(plain.text, column.name);
    }
    plain.text += '\n';
    plain.next_line += static_cast<std::uint64_t>(std::ranges::count(plain.text, '\n'));
  }
  JsonRows rows(*json, *table, layout);
  std::vector<std::uint32_t> cells;
  for (std::size_t row = 0; row < std::min(table->size(), most_first_records); ++row) {
    try {
      add_row(plain, *json, layout, rows, row, cells);
    } catch (const Error&) {
      if (row == 0) throw;
      break;  // thrown again when the keys are read
    }
  }
  const InputOptions of_text = options_of_text(options, layout, *table);
  const Dialect dialect{',', "", true};
  const TablePart part{json, table, meaning, 0, table->size()};
  try {
    std::vector<Chunk> rest;
    meaning->head = read_head(each_of(std::deque{Chunk{plain.text}}), dialect, of_text, rest);
  } catch (const Error& error) {
    throw Places(part, plain).restored(error);
  }
  leave_ignored_members(*meaning);
  meaning->columns = meaning->head.columns;
  add_optional_parameters(*meaning);
  return meaning;
}

Records records_of(const Meaning& meaning, const JsonTable& table) {
  Records records{meaning.columns, meaning.head.units};
  records.facts = meaning.head.facts;
  records.facts.comment.clear();
  records.time_unit = meaning.head.time_unit;
  records.columns.named = true;
  Columns& columns = records.columns;
  columns.ignored.insert(columns.ignored.end(), meaning.layout.ignored.begin(), meaning.layout.ignored.end());
  columns.doubts.insert(columns.doubts.begin(), meaning.layout.notes.begin(), meaning.layout.notes.end());
  if (table.are_scattered) {
    columns.doubts.emplace_back("the keys are the arrays that are as long as the one of times, a column each");
  }
  if (table.are_lists) {
    columns.doubts.emplace_back(
        "each list is taken as a column, the first one as the times, as its numbers rise; --parameter uniform takes "
        "each list as a key");
  }
  records.keys.traits.may_break = true;  // also at null in place of a key
  return records;
}

/// The parts of a table, in order.
Source<TablePart> parts_of(TablePart whole) {
  return [whole = std::move(whole)]() mutable -> std::optional<TablePart> {
    constexpr std::size_t most_records = 1000, most_cells = 50'000;
    const std::size_t columns = whole.meaning->layout.columns.size();
    const std::size_t records_of_part = std::clamp(most_cells / (columns + 1), std::size_t{1}, most_records);
    const std::size_t end = whole.last;
    if (whole.first >= end) return std::nullopt;
    TablePart part = whole;
    part.last = std::min(part.first + records_of_part, end);
    whole.first = part.last;
    whole.curve_info = nullptr;
    return part;
  };
}

/// A table with the settings around it.
struct Opened {
  TablePart part;
  FileSettings settings;
};

Opened open_table(const SharedJson& json, JsonTable found, const InputOptions& options, JsonSettings& settings) {
  const auto table = std::make_shared<const JsonTable>(std::move(found));
  Opened opened{{}, settings.around(*table, options)};
  opened.part = {json, table, meaning_of(json, table, options, opened.settings), 0, table->size()};
  return opened;
}

std::string columns_in_words(const Columns& columns) {
  return fmt::format("{} and {}", in_quotes(columns.time), listed(columns.channels));
}

void require_same_columns(const Columns& first, const Columns& columns, const std::string& path) {
  const bool are_same = columns.channels == first.channels && columns.time == first.time &&
                        columns.has(Role::time) == first.has(Role::time);
  if (are_same) return;
  throw data_error("the keys have {}; expected {}, as in the first curve; give all curves the same members",
                   columns_in_words(columns), columns_in_words(first))
      .about(path);
}

/// The ids of curves so far, each with the path of its last curve.
class CurveIds {
 public:
  explicit CurveIds(std::uint64_t max_memory) : memory_(max_memory) {}

  /// Throws: Error (data) where others are between this curve and one with the same id, whose rows would be one group.
  void add(const std::string& id, const std::string& path, const TextPosition& position) {
    const auto [found, is_new] = last_.try_emplace(id);
    if (is_new) {
      constexpr std::uint64_t of_entry = 128;
      memory_.add(of_entry + id.size() + path.size());
    } else if (id != before_) {
      throw data_error(
          "this curve has {}, as {} has, but others are between them; expected the curves of one id one after "
          "another; give it another id, or move it behind {}",
          id.empty() ? "no id" : "the id " + in_quotes(content(id)), found->second, found->second)
          .about(path)
          .at(position);
    }
    found->second = path;
    before_ = id;
  }

 private:
  MemoryUse memory_;
  std::unordered_map<std::string, std::string> last_;
  std::string before_;
};

/// `curve`: an object without keys in its place.
Error no_keys(const Json& json, const JsonTable& curve) {
  return data_error(
             "found no keys; expected at least two in \"keys\"; add them, remove the curve, or give their path to "
             "--records")
      .about(curve.path)
      .at(json.position(curve.value));
}

/// The parts of several tables, each of which is a curve.
class Curves {
 public:
  Curves(SharedJson json, std::vector<JsonTable> tables, JsonSettings settings, const InputOptions& options,
         Opened first)
      : json_(std::move(json)),
        tables_(std::move(tables)),
        settings_(std::move(settings)),
        options_(options),
        meaning_(first.part.meaning),
        columns_(meaning_->columns),
        ids_(options.max_memory) {
    begin(std::move(first));
  }

  std::optional<TablePart> operator()() {
    for (;;) {
      if (std::optional<TablePart> part = parts_()) return part;
      if (++table_ >= tables_.size()) return std::nullopt;
      if (tables_[table_].size() == 0) return without_keys(tables_[table_]);
      Opened next = open_table(json_, std::move(tables_[table_]), options_, settings_);
      require_same_columns(columns_, next.part.meaning->columns, next.part.table->list());
      begin(std::move(next));
    }
  }

 private:
  void begin(Opened opened) {
    const JsonTable& table = *opened.part.table;
    CurveInfo info = std::move(opened.settings.curve_info);
    if (!table.is_own) {
      info.id = '"' + table.path;
    } else {
      const JsonTable::Outer& curve = table.around.back();
      ids_.add(info.id, table.path.substr(0, curve.path_size), json_->position(curve.object));
    }
    opened.part.curve_info = std::make_shared<const CurveInfo>(std::move(info));
    parts_ = parts_of(std::move(opened.part));
  }

  TablePart without_keys(const JsonTable& curve) const {
    return {json_, std::make_shared<const JsonTable>(curve), meaning_, 0, 0, nullptr, {no_keys(*json_, curve)}};
  }

  SharedJson json_;
  std::vector<JsonTable> tables_;
  JsonSettings settings_;
  InputOptions options_;
  std::shared_ptr<const Meaning> meaning_;  ///< of the first curve, with its columns
  Columns columns_;
  CurveIds ids_;
  std::size_t table_ = 0;
  Source<TablePart> parts_;
};

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

/// Notes the frame rate of the file: the times are frames at it, or rows without times are at it, or it is not used.
void take_rate(FileSettings& settings, const InputOptions& options, Records& records) {
  const std::string& rate = settings.frame_rate;
  if (rate.empty() || options.units.time || options.units.frame_rate) return;
  Columns& columns = records.columns;
  const bool has_times = columns.has(Role::time);
  const bool counts = unit_of_time(columns.time) == TimeUnit::frames || counts_frames(records.units.notation);
  const bool are_rows = !has_times && !options.columns.timeless && !options.columns.samples;
  if (are_rows || (has_times && records.units.frame_rate && counts)) {
    records.frame_rate = frame_rate_in(rate);
    const std::string exact =
        broadcast_rate(rate) ? fmt::format(", which is {},", ratio_text(*broadcast_rate(rate))) : ",";
    const std::string effect = are_rows ? "rows have times; --parameter uniform undoes it"
                                        : fmt::format("the times in column {} are frames; --time-unit frames undoes it",
                                                      in_quotes(columns.time));
    columns.doubts.push_back(fmt::format("the file sets {}{} by which {}", settings.shown_rate, exact, effect));
    return;
  }
  records.facts.shown_rate = rate;
  const bool may_be_frames = !has_times || (columns.time_gap && !unit_of_time(columns.time));
  if (!may_be_frames && !columns.has_time_by_place) {
    settings.unused.push_back(settings.rate_name);
    return;
  }
  std::vector<std::string> remedies;
  if (may_be_frames) {
    remedies.push_back(fmt::format("--input-fps {} takes the {} as frames at it", rate, has_times ? "times" : "keys"));
  }
  if (columns.has_time_by_place) {
    remedies.push_back(fmt::format("--parameter uniform --input-fps {} takes rows without times at it", rate));
  }
  columns.doubts.push_back(
      fmt::format("the file sets {}, which is not used; {}", settings.shown_rate, fmt::join(remedies, ", and ")));
}

/// Throws: Error (data) for settings in the object around curves as the program writes them.
void require_no_settings(const FileSettings& settings, const TextPosition& object) {
  if (settings.tcb) {
    throw data_error(
        "the object around the curves sets tension, continuity or bias; expected them in each curve; move them there, "
        "or give --tcb 0,0,0 to leave them out")
        .at(object);
  }
  const auto& places = settings.curve_info.places;
  if (places.empty()) return;
  throw data_error("this setting is outside the curves; expected it in each curve; move it there")
      .about(places[0].first)
      .at(places[0].second);
}

JsonShape shape_of(const JsonTable& table, bool are_curves) {
  if (table.is_own) return are_curves ? JsonShape::curves : JsonShape::object;
  if (!table.path.empty() || table.are_scattered) return JsonShape::any;
  if (!table.index.empty()) return JsonShape::table_by_index;
  return table.has_names && table.columns.empty() && table.names.empty() ? JsonShape::list : JsonShape::table;
}

void require_no_groups(const Columns& columns) {
  if (columns.groups.empty()) return;
  throw data_error(
      "the curves of \"curves\" are separate already; expected keys of several curves in one list; remove --group");
}

/// There are more values than the one that holds the keys.
Error unlike_list(const Json& json) {
  const std::size_t second = json.next(1);
  const bool are_lists = json.is(1, Kind::array) && json.is(second, Kind::array);
  return (are_lists
              ? data_error("another array follows the first one; expected one array of all keys; put the keys into one")
              : data_error("found {} behind the keys; expected nothing; remove it", json.shown(second)))
      .at(json.position(second));
}

/// Whether an object has a time, or an arc length in a row without a time, as the only key of a text has.
bool may_be_key(const Json& json, std::size_t object) {
  return json.is(object, Kind::object) && std::ranges::any_of(json.inside(object), [&](std::size_t value) {
           return !json.is_nested(value) && (is_usual_time(json.name(value)) || json.name(value) == "s");
         });
}

/// The path of the only array of numbers, at least two; empty for several, and for none.
std::string path_of_numbers(const Json& json) {
  std::string path;
  for (std::size_t value = 1; value < json.size(); ++value) {
    if (!json.is(value, Kind::array) || !json.has_only(value, Kind::number) || json.count(value) < 2) continue;
    if (!path.empty()) return "";
    path = json.path(1, value);
  }
  return path;
}

/// One value, whose tables are the keys.
Records open_value(const SharedJson& json, const InputOptions& options) {
  if (json->next(1) < json->size()) throw unlike_list(*json);
  std::vector<JsonTable> tables = find_tables(*json, options);
  if (tables.empty() && may_be_key(*json, 1)) tables.push_back({.value = 0, .records = {1}});
  if (tables.empty()) {
    const std::string numbers = path_of_numbers(*json);
    throw data_error("found no list of keys; expected an array of objects or of rows, or an object of columns; give {}",
                     numbers.empty()
                         ? "--records if it is there"
                         : fmt::format("--records {} for the numbers there, without times", in_shell(numbers)))
        .at({"", 1, 1});
  }
  const bool are_own = tables[0].is_own;
  if (tables[0].size() == 0) throw no_keys(*json, tables[0]);
  const bool are_curves = tables.size() > 1 || (are_own && tables[0].around.size() > 1);
  JsonSettings settings(*json, tables);
  if (are_own && are_curves) {
    require_no_settings(settings.around_curves(tables[0], options), json->position(tables[0].around[0].object));
  }
  Opened first = open_table(json, tables[0], options, settings);
  Records records = records_of(*first.part.meaning, tables[0]);
  records.facts.shape = shape_of(tables[0], are_curves);
  FileSettings& around = first.settings;
  std::ranges::copy(tables[0].others, std::back_inserter(around.unused));
  take_rate(around, options, records);
  add_notes(records, around);
  if (!are_own) records.facts.records = are_curves ? options.records : tables[0].path;
  if (!are_curves) {
    records.keys.curve_info = std::move(around.curve_info);
    records.keys.blocks = ordered_map(parts_of(std::move(first.part)), keys_of, options.threads);
    return records;
  }
  require_no_groups(records.columns);
  records.columns.groups = {"id"};
  records.keys.traits.own_curves = true;
  Curves curves(json, std::move(tables), std::move(settings), options, std::move(first));
  records.keys.blocks = ordered_map(Source<TablePart>(std::move(curves)), keys_of, options.threads);
  return records;
}

/// The values of a block of lines. A line that is no JSON is a fault, and in the place of no key from then on.
SharedJson json_of_lines(JsonBlock block, std::vector<Error>& faults) {
  for (;;) {
    try {
      return std::make_shared<const Json>(block.text, block.begin, block.nodes);
    } catch (const Error& error) {
      faults.push_back(error);
      std::size_t begin = 0;
      for (std::uint64_t line = block.begin.line; line < error.position().line; ++line) {
        begin = std::min(block.text.find('\n', begin), block.text.size() - 1) + 1;
      }
      const std::size_t end = std::min(block.text.find('\n', begin), block.text.size());
      const bool is_blank = block.text.find_first_not_of(" \t\r", begin) >= end;
      if (faults.size() > most_faults || is_blank) throw Error(faults.front());
      constexpr std::string_view no_key = "null";
      const bool is_counted = begin > 0 && end - begin >= no_key.size();
      const auto first = block.text.begin() + static_cast<std::ptrdiff_t>(begin);
      std::fill(first, first + static_cast<std::ptrdiff_t>(end - begin), ' ');
      if (is_counted) std::ranges::copy(no_key, first);
    }
  }
}

/// Whether the first record is an object of other members than the second one, which has a time.
bool begins_with_settings(const Json& json, const JsonTable& table) {
  if (!table.has_names || !table.columns.empty() || table.records.size() < 2) return false;
  const std::size_t first = table.records[0], second = table.records[1];
  const auto has_member = [&](std::size_t value) { return json.member(second, json.name(value)).has_value(); };
  return json.is(first, Kind::object) && !may_be_key(json, first) && may_be_key(json, second) &&
         std::ranges::none_of(json.inside(first), has_member);
}

/// Several values, each a key.
Records open_values(JsonBlock block, const std::shared_ptr<JsonBlocks>& blocks, const InputOptions& options) {
  std::vector<Error> faults;
  SharedJson first = json_of_lines(std::move(block), faults);
  std::uint64_t skipped = 0;  // null, which ends a curve, before the first key
  while (std::ranges::all_of(first->inside(0), [&](std::size_t value) { return ends_curve(*first, value); })) {
    std::optional<JsonBlock> next = faults.empty() ? blocks->next() : std::nullopt;
    if (!next) break;
    skipped += first->count(0);
    first = json_of_lines(*std::move(next), faults);
  }
  if (first->size() < 2) throw Error(faults.front());
  const bool is_list = first->is(1, Kind::array) && !first->is_empty(1) && first->is_nested(first->first(1));
  if (is_list && first->next(1) < first->size()) throw unlike_list(*first);
  JsonTable found = table_of_values(*first, options.max_memory);
  found.number += skipped;
  FileSettings settings;
  if (begins_with_settings(*first, found)) {
    settings = JsonSettings(*first, {}).of_object(found.records[0], options);
    found.records.erase(found.records.begin());
    ++found.number;
  }
  const auto table = std::make_shared<const JsonTable>(std::move(found));
  TablePart part{first, table, meaning_of(first, table, options, settings), 0, table->size()};
  part.faults = std::move(faults);
  Records records = records_of(*part.meaning, *table);
  take_rate(settings, options, records);
  add_notes(records, settings);
  records.keys.curve_info = std::move(settings.curve_info);
  records.facts.shape = table->has_names ? JsonShape::lines : JsonShape::table;
  Source<TablePart> parts = [blocks, meaning = part.meaning, number = table->number + table->size(),
                             has_names = table->has_names, names = table->names]() mutable -> std::optional<TablePart> {
    std::optional<JsonBlock> block = blocks->next();
    if (!block) return std::nullopt;
    TablePart next{nullptr, nullptr, meaning, 0, 0};
    next.json = json_of_lines(*std::move(block), next.faults);
    next.table = std::make_shared<const JsonTable>(
        JsonTable{.has_names = has_names, .names = names, .records = records_in(*next.json, 0), .number = number});
    next.last = next.table->size();
    number += next.last;
    return next;
  };
  records.keys.blocks = ordered_map(preceded_by(part, std::move(parts)), keys_of, options.threads);
  return records;
}

/// Where cells may be skipped all keys are kept, and numbers that no record has take memory, too.
Source<KeyBlock> within_memory(Source<KeyBlock> blocks, std::uint64_t max_memory) {
  return mapped(std::move(blocks), [memory = MemoryUse(max_memory)](KeyBlock block) mutable {
    constexpr std::uint64_t bytes_of_missing_number = 96;
    const auto missing = std::ranges::count_if(block.keys.positions, [](double number) { return std::isnan(number); });
    memory.add(static_cast<std::uint64_t>(missing) * bytes_of_missing_number);
    return block;
  });
}

/// Whether a text is one value, and not one after another: it begins with an array or an object that ends with it.
bool is_one_value(const JsonBlock& block, JsonBlocks& blocks) { return block.values < 2 && blocks.is_at_end(); }

Records open_json(const Format&, Source<std::string> bytes, InputOptions options) {
  const auto blocks = std::make_shared<JsonBlocks>(std::move(bytes), options.max_memory);
  std::optional<JsonBlock> block = options.records.empty() ? blocks->next() : blocks->whole();
  if (!block) throw data_error("the input has no keys; expected a JSON object for each key; see --help");
  Records records =
      is_one_value(*block, *blocks) || !options.records.empty()
          ? open_value(std::make_shared<const Json>(std::move(block->text), block->begin, block->nodes), options)
          : open_values(*std::move(block), blocks, options);
  if (options.keys.missing == Missing::skip_cell) {
    records.keys.blocks = within_memory(std::move(records.keys.blocks), options.max_memory);
  }
  return records;
}

/// A text begins with an array or an object; one of a log or of another product may, too.
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

extern const InputFormat json_input{.open = open_json, .fit = fit_of_json};

}  // namespace tcb
