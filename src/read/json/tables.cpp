// Tables in JSON: the lists of records in a text of any shape, however these are laid out.
#include "read/json/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "read/other_files.hpp"
#include "schema/key_rules.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

/// Whether a name may be an index of rows: a number, or a time in words.
bool is_index(std::string_view name) { return parse_number(name) || find_notation(name); }

/// Whether an array or object is not empty, and its values are all of a kind.
bool has_only(const JsonTape& tape, std::size_t value, Kind kind) {
  const auto all = tape.inside(value);
  return !all.empty() &&
         std::ranges::all_of(all, [&](std::size_t inner) { return tape.kind(tape.value_of(inner)) == kind; });
}

/// Whether an array begins with an object, and the others are objects, or null, which breaks curves.
bool is_list_of_objects(const JsonTape& tape, std::size_t array) {
  const auto is_key_or_break = [&](std::size_t value) {
    return tape.kind(value) == Kind::object || tape.kind(value) == Kind::null;
  };
  const auto all = tape.inside(array);
  return !all.empty() && tape.kind(*all.begin()) == Kind::object && std::ranges::all_of(all, is_key_or_break);
}

/// The array of rows of an object that has the names of their columns beside it, as pandas and InfluxDB write tables.
std::optional<std::size_t> rows_beside_columns(const JsonTape& tape, std::size_t object) {
  const auto columns = tape.member(object, "columns");
  if (!columns || tape.kind(*columns) != Kind::array || tape.holds(*columns, Kind::object)) return std::nullopt;
  for (const std::string_view name : {"data", "values", "rows"}) {
    const auto rows = tape.member(object, name);
    if (rows && has_only(tape, *rows, Kind::array)) return rows;
  }
  return std::nullopt;
}

/// Whether f holds for a member of an object or of one within it; what is in arrays does not count.
template <class F>
bool any_inside(const JsonTape& tape, std::size_t object, const F& f) {
  return std::ranges::any_of(tape.inside(object), [&](std::size_t name) {
    const std::size_t value = name + 1;
    return f(tape.text(name), value) || (tape.kind(value) == Kind::object && any_inside(tape, value, f));
  });
}

bool has_number(const JsonTape& tape, std::size_t object) {
  return any_inside(tape, object, [&](std::string_view, std::size_t value) {
    const bool is_array = tape.kind(value) == Kind::array && tape[value].next > value + 1;
    return is_number(tape, is_array ? value + 1 : value);
  });
}

bool has_time(const JsonTape& tape, std::size_t object) {
  return any_inside(tape, object, [&](std::string_view name, std::size_t value) {
    return !tape[value].is_nested() && (is_usual_time(name) || time_part_of(name));
  });
}

/// Whether the members of an object are records with times, all with the same members, under names that mean nothing,
/// as Firebase writes lists.
bool are_records(const JsonTape& tape, std::size_t object) {
  if (tape.count(object) < 2 || !has_only(tape, object, Kind::object)) return false;
  const std::size_t first = object + 2;
  const auto has_names_of_first = [&](std::size_t name) {
    const auto same = [&](std::size_t one, std::size_t other) { return tape.text(one) == tape.text(other); };
    return std::ranges::equal(tape.inside(name + 1), tape.inside(first), same);
  };
  return has_time(tape, first) && has_number(tape, first) &&
         std::ranges::all_of(tape.inside(object), has_names_of_first);
}

}  // namespace

bool is_number(const JsonTape& tape, std::size_t value) {
  const Kind kind = tape.kind(value);
  return kind == Kind::number || (kind == Kind::string && parse_number(tape.text(value)));
}

std::vector<std::string> usual_names(std::size_t columns, bool is_timeless) {
  if (is_timeless || columns == 0) return default_channel_names(columns);
  std::vector<std::string> names = default_channel_names(columns - 1);
  names.insert(names.begin(), "t");
  return names;
}

Error row_of_other_size(std::size_t row, std::size_t cells, std::size_t columns) {
  return data_error("row {} of the table has {}; expected {}, one for each column; correct it", row,
                    how_many(cells, "cell"), columns);
}

JsonTable::JsonTable(const JsonTape& tape, std::vector<std::uint32_t> values, std::vector<std::string> columns,
                     std::string path, std::size_t first)
    : tape_(&tape),
      path_(std::move(path)),
      first_(first),
      size_(values.size()),
      are_rows_(!columns.empty()),
      has_names_(columns.empty()),
      names_(std::move(columns)),
      rows_(std::move(values)) {}

std::optional<JsonTable> JsonTable::find(const JsonTape& tape, std::size_t value, std::string path, bool is_root,
                                         bool is_timeless) {
  JsonTable table(tape, {}, {}, std::move(path), 0);
  table.value_ = value;
  if (!table.find_layout(value, is_root, is_timeless)) return std::nullopt;
  table.decide_index();
  return table;
}

bool JsonTable::find_layout(std::size_t table, bool is_root, bool is_timeless) {
  const JsonTape& tape = *tape_;
  if (tape.kind(table) == Kind::array) {
    const bool is_list = is_list_of_objects(tape, table);
    if (!is_list && !has_only(tape, table, Kind::array)) return false;
    rows_ = tape.elements(table);
    size_ = rows_.size();
    if (is_list) return true;
    names_ = usual_names(tape.count(rows_[0]), is_timeless);
    has_names_ = false;
    return read_rows(), true;
  }
  if (tape.kind(table) != Kind::object || tape[table].next == table + 1) return false;
  const std::string_view first = tape.text(table + 1);
  const std::size_t inner = table + 2;
  if (tape.kind(inner) == Kind::object) {
    if (is_root && first == "schema" && tape.member(table, "data")) return read_schema(table), true;
    if (tape[inner].next == inner + 1) return false;
    if (!has_only(tape, table, Kind::object)) return false;
    if (is_index(first) || are_records(tape, table)) return read_index(table), true;
    return is_index(tape.text(inner + 1)) ? (read_columns(table), true) : false;
  }
  if (is_index(first) && has_only(tape, table, Kind::array)) return read_index(table), true;
  if (const auto rows = rows_beside_columns(tape, table)) return read_split(table, *rows), true;
  for (const std::size_t name : tape.inside(table)) {
    const std::size_t value = name + 1;
    const std::string_view text = tape.text(name);
    const bool is_empty = value + 1 == tape[value].next;
    const bool begins_with_object = !is_empty && tape.kind(value + 1) == Kind::object;
    if (tape.kind(value) == Kind::array && !begins_with_object) {
      const bool are_times = is_usual_time(text) && (is_empty || tape.kind(value + 1) != Kind::array);
      if (are_times || !is_root) return read_lists(table), true;
      if (is_root && tape.holds(value, Kind::object)) return false;
    } else if (is_root) {
      return false;
    }
  }
  return false;
}

namespace {

/// An array that may be the values of a column.
struct ColumnArray {
  std::size_t place, value;  ///< its name on the tape, and itself
  std::size_t object;        ///< around it
  std::string_view name;
};

/// The text that says what the values of an object are; empty: there is none.
std::string_view label_of(const JsonTape& tape, std::size_t object) {
  for (const std::string_view label : {"type", "name", "id", "key", "label"}) {
    const auto value = tape.member(object, label);
    if (value && tape.kind(*value) == Kind::string) return tape.text(*value);
  }
  return "";
}

/// Whether a value is an array of numbers, or of arrays of as many numbers.
bool may_be_column(const JsonTape& tape, std::size_t value) {
  if (tape.kind(value) != Kind::array || tape.count(value) < 2) return false;
  const bool are_arrays = has_only(tape, value, Kind::array);
  const std::size_t size = are_arrays ? tape.count(value + 1) : 0;
  return std::ranges::all_of(tape.inside(value), [&](std::size_t inner) {
    if (!are_arrays)
      return is_number(tape, inner) || tape.kind(inner) == Kind::null ||
             (tape.kind(inner) == Kind::string && find_notation(tape.text(inner)));
    return tape.count(inner) == size && has_only(tape, inner, Kind::number);
  });
}

/// Finds the arrays of columns. Values without a name of their own are called as the object says, or as it is called.
void find_arrays(const JsonTape& tape, std::size_t object, std::string_view name, std::vector<ColumnArray>& found) {
  for (const std::size_t inner : tape.inside(object)) {
    const std::size_t value = tape.value_of(inner);
    const bool is_member = tape.kind(inner) == Kind::name;
    if (is_member && may_be_column(tape, value)) {
      const std::string_view own = tape.text(inner), label = label_of(tape, object);
      const bool is_nameless = own == "data" || own == "values";
      found.push_back({inner, value, object, !is_nameless ? own : label.empty() ? name : label});
    } else if (tape[value].is_nested()) {
      find_arrays(tape, value, is_member ? tape.text(inner) : name, found);
    }
  }
}

}  // namespace

std::optional<JsonTable> JsonTable::of_arrays(const JsonTape& tape) {
  std::vector<ColumnArray> arrays;
  find_arrays(tape, 0, "", arrays);
  const auto is_time = [](const ColumnArray& array) { return is_usual_time(array.name); };
  const auto time = std::ranges::find_if(arrays, is_time);
  if (std::ranges::count_if(arrays, is_time) != 1) return std::nullopt;
  JsonTable table(tape, {}, {}, "", 0);
  table.is_beside_settings_ = true;
  table.own_names_ = std::make_shared<std::deque<std::string>>();
  table.cells_.resize(table.size_ = tape.count(time->value));
  std::unordered_set<std::string_view> names;
  for (const ColumnArray& array : arrays) {
    const bool are_columns = tape.kind(array.value + 1) == Kind::array && tape.count(array.value + 1) == table.size_;
    if (tape.count(array.value) != table.size_ && !are_columns) {
      table.others_.emplace_back(array.name);
      continue;
    }
    if (!names.insert(array.name).second) return std::nullopt;
    table.joins_arrays_ = table.joins_arrays_ || array.object != time->object || tape.count(array.value) != table.size_;
    if (tape.count(array.value) == table.size_) {
      table.add_columns(array.name, array.value);
      continue;
    }
    std::size_t index = 0;
    for (const std::size_t column : tape.inside(array.value)) {
      table.add_columns(fmt::format("{}[{}]", array.name, index++), column);
    }
  }
  return table.joins_arrays_ ? std::optional(std::move(table)) : std::nullopt;
}

/// Adds a column of the values in an array, or one for each number of those that are arrays.
void JsonTable::add_columns(std::string_view name, std::size_t values) {
  const JsonTape& tape = *tape_;
  const bool are_arrays = tape.kind(values + 1) == Kind::array;
  const std::size_t first = names_.size(), count = are_arrays ? tape.count(values + 1) : 1;
  for (std::size_t i = 0; i < count; ++i) {
    names_.push_back(are_arrays ? fmt::format("{}[{}]", name, i) : std::string(name));
    own_names_->push_back(names_.back());
  }
  std::size_t row = 0;
  for (const std::size_t value : tape.inside(values)) {
    std::size_t column = first;
    const auto add = [&](std::size_t number) { cells_[row].push_back({(*own_names_)[column++], number, number}); };
    if (are_arrays) {
      std::ranges::for_each(tape.inside(value), add);
    } else {
      add(value);
    }
    ++row;
  }
}

/// Rows that are arrays. Throws: Error (data) for one of another size.
void JsonTable::read_rows() {
  are_rows_ = true;
  size_ = rows_.size();
  for (std::size_t row = 0; row < size_; ++row) {
    const bool is_row = tape_->kind(rows_[row]) == Kind::array;
    const std::size_t cells = is_row ? tape_->count(rows_[row]) : 0;
    if (cells != names_.size()) throw row_of_other_size(row, cells, names_.size()).at(tape_->position(rows_[row]));
  }
}

void JsonTable::read_split(std::size_t table, std::size_t rows) {
  const JsonTape& tape = *tape_;
  is_beside_settings_ = true;
  for (const std::size_t name : tape.inside(*tape.member(table, "columns"))) {
    names_.emplace_back(tape.kind(name) == Kind::string ? tape.text(name) : tape.written(name));
  }
  rows_ = tape.elements(rows);
  read_rows();
  const auto index = tape.member(table, "index");
  if (!index) return;
  if (tape.kind(*index) == Kind::array) index_ = tape.elements(*index);
  if (index_.size() != size_) {
    throw data_error("the index of the table has {}; expected {}, one for each row; correct it",
                     how_many(index_.size(), "value"), size_)
        .at(tape.position(*index));
  }
}

/// The objects of "data", without the index that counts them.
void JsonTable::read_schema(std::size_t table) {
  const JsonTape& tape = *tape_;
  const std::size_t data = *tape.member(table, "data");
  const bool is_list = tape.kind(data) == Kind::array && has_only(tape, data, Kind::object);
  if (!is_list) {
    throw data_error(
        "\"data\" is not a list of rows; expected an object for each row, as pandas writes them; correct it")
        .at(tape.position(data));
  }
  is_beside_settings_ = true;
  rows_ = tape.elements(data);
  size_ = rows_.size();
  has_index_member_ = tape.count(rows_[0]) > 0 && tape.text(rows_[0] + 1) == "index";
  if (!has_index_member_) return;
  for (const std::uint32_t row : rows_) {
    index_.push_back(static_cast<std::uint32_t>(tape.member(row, "index").value_or(row)));
  }
}

/// An array for each column, as long as the first one.
void JsonTable::read_lists(std::size_t table) {
  const JsonTape& tape = *tape_;
  is_beside_settings_ = true;
  for (const std::size_t name : tape.inside(table)) {
    const std::size_t values = name + 1;
    if (tape.kind(values) != Kind::array) continue;
    const std::size_t count = tape.count(values);
    if (names_.empty()) cells_.resize(size_ = count);
    names_.emplace_back(tape.text(name));
    if (count != size_) {
      throw data_error("the column {} has {}; expected {}, as many as {}; correct it", in_quotes(names_.back()),
                       how_many(count, "value"), size_, in_quotes(names_[0]))
          .at(tape.position(name));
    }
    std::size_t row = 0;
    for (const std::size_t value : tape.inside(values)) cells_[row++].push_back({tape.text(name), value, value});
  }
  for (const std::size_t name : tape.inside(table)) read_lists_inside(name);
}

/// Arrays in an object beside the columns that are as long are columns, too, such as tcb.t.
void JsonTable::read_lists_inside(std::size_t object) {
  const JsonTape& tape = *tape_;
  const auto is_column = [&](std::size_t name) {
    return tape.kind(name + 1) == Kind::array && tape.count(name + 1) == size_;
  };
  if (tape.kind(object + 1) != Kind::object || !std::ranges::all_of(tape.inside(object + 1), is_column)) return;
  if (own_names_ == nullptr) own_names_ = std::make_shared<std::deque<std::string>>();
  for (const std::size_t name : tape.inside(object + 1)) {
    names_.push_back(own_names_->emplace_back(fmt::format("{}.{}", tape.text(object), tape.text(name))));
    std::size_t row = 0;
    for (const std::size_t value : tape.inside(name + 1)) cells_[row++].push_back({own_names_->back(), value, value});
  }
}

/// A row for each member, whose name is its index.
void JsonTable::read_index(std::size_t table) {
  const JsonTape& tape = *tape_;
  std::unordered_set<std::string_view> names;
  for (const std::size_t row : tape.inside(table)) {
    index_.push_back(static_cast<std::uint32_t>(row));
    rows_.push_back(static_cast<std::uint32_t>(row + 1));
    if (tape.kind(row + 1) != Kind::object) continue;
    for (const std::size_t name : tape.inside(row + 1)) {
      const bool is_number = tape.kind(name + 1) == Kind::number || tape.kind(name + 1) == Kind::null;
      const std::string_view text = tape.text(name);
      if (names.insert(text).second && rows_.size() > 1 && is_number) names_.emplace_back(text);
    }
  }
  size_ = rows_.size();
  if (tape.kind(rows_[0]) != Kind::array) return;
  names_ = default_channel_names(tape.count(rows_[0]));
  read_rows();
}

/// Members of each column by the index of their row. The rows come in the order in which they are found.
void JsonTable::read_columns(std::size_t table) {
  const JsonTape& tape = *tape_;
  std::unordered_map<std::string_view, std::size_t> rows;
  for (const std::size_t column : tape.inside(table)) {
    if (tape.inside(column + 1).empty()) continue;
    for (const std::size_t name : tape.inside(column + 1)) {
      const auto [row, is_new] = rows.emplace(tape.text(name), rows.size());
      if (is_new) index_.push_back(static_cast<std::uint32_t>(name));
      if (is_new) cells_.emplace_back();
      cells_[row->second].push_back({tape.text(column), name + 1, name + 1});
    }
    names_.emplace_back(tape.text(column));
  }
  size_ = rows.size();
}

/// The index is the time where no column is, unless it counts the rows from 0, as it does where it is not given.
void JsonTable::decide_index() {
  if (index_.empty()) return;
  const auto is_time = [](std::string_view name) { return is_usual_time(name); };
  bool has_time = std::ranges::any_of(names_, is_time);
  JsonCells first;
  get_cells(0, first);
  for (const JsonCell& cell : first) has_time = has_time || is_time(cell.name);
  bool counts_rows = true;
  for (std::size_t row = 0; row < index_.size() && counts_rows; ++row) {
    const bool is_name = tape_->kind(index_[row]) == Kind::name;
    counts_rows = (is_name ? tape_->text(index_[row]) : tape_->written(index_[row])) == fmt::format("{}", row);
  }
  takes_index_ = !has_time && !counts_rows;
}

std::string JsonTable::first_path() const { return fmt::format("{}[{}]", path_.empty() ? "keys" : path_, first_); }

void JsonTable::get_cells(std::size_t row, JsonCells& cells) const {
  cells.clear();
  if (takes_index_) cells.push_back({"time", index_[row], index_[row]});
  if (!cells_.empty()) {
    cells.insert(cells.end(), cells_[row].begin(), cells_[row].end());
    return;
  }
  std::size_t column = 0;
  for (const std::size_t inner : tape_->inside(rows_[row])) {
    if (!are_rows_) {
      const std::string_view name = tape_->text(inner);
      if (!has_index_member_ || name != "index") cells.push_back({name, inner + 1, inner});
    } else if (column < names_.size()) {
      cells.push_back({names_[column++], inner, inner});
    }
  }
}

JsonCells JsonTable::first_cells() const {
  JsonCells found;
  get_cells(0, found);
  if (are_rows_) return found;
  std::unordered_set<std::string_view> there;
  for (const JsonCell& cell : found) there.insert(cell.name);
  std::size_t next = cells_.empty() ? found.size() : takes_index_ ? 1 : 0;
  JsonCells all(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(next));
  for (const std::string& name : names_) {
    if (there.insert(name).second) {
      all.push_back({name});
    } else if (next < found.size() && found[next].name == name) {
      all.push_back(found[next++]);
    }
  }
  return all;
}

namespace {

/// How well a value serves as keys.
enum class Fit { none, without_times, with_times };

/// A list of rows of numbers, which may follow a time in words, all of one size, or of objects with numbers.
Fit fit_of_array(const JsonTape& tape, std::size_t array) {
  if (is_list_of_objects(tape, array)) {
    const std::size_t first = array + 1;
    if (tape[first].next == tape[array].next || !has_number(tape, first)) return Fit::none;
    return has_time(tape, first) ? Fit::with_times : Fit::without_times;
  }
  if (!has_only(tape, array, Kind::array)) return Fit::none;
  const std::vector<std::uint32_t> rows = tape.elements(array);
  const std::size_t columns = tape.count(rows[0]);
  if (rows.size() < 2 || columns < 2) return Fit::none;
  std::optional<double> before;
  bool rises = true;
  for (const std::uint32_t row : rows) {
    const std::size_t first = row + 1;
    const bool is_string = tape.kind(first) == Kind::string;
    const bool is_in_words = is_string && find_notation(tape.text(first));
    const auto is_missing = [&](std::size_t value) {
      return tape.kind(value) == Kind::null ||
             (tape.kind(value) == Kind::string && is_missing_sign(tape.text(value), {}));
    };
    const auto is_cell = [&](std::size_t value) {
      return is_number(tape, value) || is_missing(value) || (value == first && is_in_words);
    };
    if (tape.count(row) != columns || !std::ranges::all_of(tape.inside(row), is_cell)) return Fit::none;
    if (is_in_words || is_missing(first)) continue;
    const auto number = parse_number(is_string ? tape.text(first) : tape.written(first));
    rises = rises && (!before || *number > *before);
    before = number;
  }
  return rises ? Fit::with_times : Fit::without_times;
}

/// An object whose members are rows by their times, records with times, or columns of one size with a time among them.
Fit fit_of_object(const JsonTape& tape, std::size_t object) {
  if (tape.count(object) < 2) return Fit::none;
  if (rows_beside_columns(tape, object)) return Fit::with_times;
  bool are_times = true, has_lists = false, has_times = false, are_equal = true;
  std::optional<std::size_t> size;
  for (const std::size_t name : tape.inside(object)) {
    const std::size_t value = name + 1;
    are_times = are_times && is_index(tape.text(name)) && tape[value].is_nested() && tape[value].next > value + 1;
    if (tape.kind(value) != Kind::array) continue;
    const bool is_flat = !tape.holds(value, Kind::object);
    const std::size_t count = tape.count(value);
    are_equal = are_equal && is_flat && count >= 2 && count == size.value_or(count);
    size = count;
    (is_usual_time(tape.text(name)) ? has_times : has_lists) = true;
  }
  const bool are_rows = has_only(tape, object, Kind::array) || has_only(tape, object, Kind::object);
  if (are_times && are_rows) return Fit::with_times;
  return (has_lists && are_equal && has_times) || are_records(tape, object) ? Fit::with_times : Fit::none;
}

Fit fit_of(const JsonTape& tape, std::size_t value) {
  if (tape.kind(value) == Kind::array) return fit_of_array(tape, value);
  return tape.kind(value) == Kind::object ? fit_of_object(tape, value) : Fit::none;
}

/// Whether a list of objects with numbers is somewhere below a value.
bool holds_list(const JsonTape& tape, std::size_t value) {
  for (std::size_t at = value + 1; at < tape[value].next; ++at) {
    const bool is_list = tape.kind(at) == Kind::array && tape.count(at) > 1 && is_list_of_objects(tape, at);
    if (is_list && fit_of_array(tape, at) != Fit::none) return true;
  }
  return false;
}

/// A value with its path.
struct Place {
  std::size_t value;
  std::string path;
};

/// A path with a step to a member, by its name, or to an element, for as long as this lives.
class Step {
 public:
  Step(std::string& path, const JsonTape& tape, std::size_t inner, std::size_t index)
      : path_(path), size_(path.size()) {
    if (tape.kind(inner) != Kind::name) {
      path += fmt::format("[{}]", index);
    } else {
      if (!path.empty()) path += '.';
      path += tape.text(inner);
    }
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;
  ~Step() { path_.resize(size_); }

 private:
  std::string& path_;
  std::size_t size_;
};

/// Finds the values that fit, of which none holds another one. A list of objects without times that hold lists
/// themselves is none: these are the keys.
template <class F>
void find_fits(const JsonTape& tape, std::size_t value, std::string& path, const F& found) {
  const Fit fit = fit_of(tape, value);
  const bool holds_lists = fit == Fit::without_times && tape.kind(value) == Kind::array && holds_list(tape, value);
  if (fit != Fit::none && !holds_lists) return found(value, fit);
  std::size_t index = 0;
  for (const std::size_t inner : tape.inside(value)) {
    const std::size_t of_inner = tape.value_of(inner);
    if (tape[of_inner].is_nested()) {
      const Step step(path, tape, inner, index);
      find_fits(tape, of_inner, path, found);
    }
    ++index;
  }
}

/// The rest of a path after a step, if the path begins with it.
std::optional<std::string_view> after_step(std::string_view path, std::string_view step) {
  for (const std::string_view known : {step, std::string_view("*")}) {
    if (!path.starts_with(known)) continue;
    const std::string_view rest = path.substr(known.size());
    if (rest.empty() || rest[0] == '[') return rest;
    if (rest[0] == '.') return rest.substr(1);
  }
  return std::nullopt;
}

/// Finds the values at the end of a path, of which `path` was followed to this value.
template <class F>
void follow(const JsonTape& tape, std::size_t value, std::string& path, std::string_view left, const F& found) {
  if (left.empty()) return found(value);
  std::size_t index = 0;
  for (const std::size_t inner : tape.inside(value)) {
    const bool is_name = tape.kind(inner) == Kind::name;
    auto rest = after_step(left, is_name ? std::string(tape.text(inner)) : fmt::format("[{}]", index));
    if (!rest && !is_name && left.starts_with("[*]")) rest = after_step(left, "[*]");
    if (rest) {
      const Step step(path, tape, inner, index);
      follow(tape, tape.value_of(inner), path, *rest, found);
    }
    ++index;
  }
}

std::string listed_paths(const std::vector<Place>& places) {
  std::vector<std::string> paths;
  for (const Place& place : places) paths.push_back(place.path.empty() ? "the whole text" : place.path);
  return listed(paths);
}

/// The names of the first record of a list, or how many numbers it has.
std::vector<std::string_view> names_of_record(const JsonTape& tape, std::size_t list) {
  std::vector<std::string_view> names;
  for (const std::size_t inner : tape.inside(list + 1)) {
    names.push_back(tape.kind(inner) == Kind::name ? tape.text(inner) : "");
  }
  return names;
}

/// The path of the first place with * for the one step in which those of the others differ; empty where they differ in
/// more, or their records do.
std::string path_of_all(const JsonTape& tape, const std::vector<Place>& places) {
  const auto are_alike = [&](const Place& place) {
    return tape.kind(place.value) == Kind::array &&
           names_of_record(tape, place.value) == names_of_record(tape, places[0].value);
  };
  if (!std::ranges::all_of(places, are_alike)) return "";
  const std::string& path = places[0].path;
  for (std::size_t begin = 0; begin < path.size();) {
    const bool is_index = path[begin] == '[';
    const std::size_t end = std::min(path.find_first_of(".[", begin + 1), path.size());
    const std::string all = path.substr(0, begin) + (is_index ? "[*]" : "*") + path.substr(end);
    std::vector<std::size_t> found;
    std::string current;
    follow(tape, 0, current, all, [&](std::size_t value) { found.push_back(value); });
    if (std::ranges::equal(found, places, {}, {}, &Place::value)) return all;
    begin = end < path.size() && path[end] == '.' ? end + 1 : end;
  }
  return "";
}

}  // namespace

void refuse_other_json(const JsonTape& tape, const ColumnOptions& requested, std::string_view list) {
  if (requested.timeless || !requested.roles.empty()) return;
  std::unordered_set<std::string_view> names;
  for (std::size_t at = 0; at < tape.size(); ++at) {
    if (tape.kind(at) == Kind::name) names.insert(tape.text(at));
  }
  const std::string records = list.empty() ? "" : fmt::format("--records {} ", in_shell(list));
  const std::size_t outer = tape.kind(0) == Kind::array && tape.size() > 1 ? 1 : 0;
  std::string_view type;
  for (const std::size_t name : tape.inside(outer)) {
    if (tape.kind(name) == Kind::name && tape.text(name) == "type") type = tape.shown(name + 1);
  }
  if (const std::optional<Error> error = other_json(names, type, records)) throw error->at({"", 1, 1});
}

bool holds_table(const JsonTape& tape, std::size_t value) {
  bool found = false;
  std::string path;
  find_fits(tape, value, path, [&](std::size_t, Fit) { found = true; });
  return found;
}

std::vector<JsonTable> find_tables(const JsonTape& tape, const InputOptions& options) {
  const std::string_view path = options.records;
  std::vector<Place> with_times, others, requested;
  MemoryUse paths(options.max_memory);
  std::string current;
  const auto add = [&](std::vector<Place>& places, std::size_t value) {
    paths.add(current.size());
    places.push_back({value, current});
  };
  find_fits(tape, 0, current,
            [&](std::size_t value, Fit fit) { add(fit == Fit::with_times ? with_times : others, value); });
  const std::vector<Place>& fitting = with_times.empty() ? others : with_times;
  const bool has_records =
      std::ranges::any_of(with_times, [&](const Place& place) { return !has_only(tape, place.value, Kind::array); });
  if (path.empty() && !has_records) {
    if (auto table = JsonTable::of_arrays(tape)) return {*std::move(table)};
  }
  if (!path.empty()) {
    follow(tape, 0, current, path, [&](std::size_t value) { add(requested, value); });
    if (requested.empty()) {
      throw usage_error("--records {}: there is no such value; expected the path of a list of records{}{}; correct it",
                        path, fitting.empty() ? "" : ", such as ", listed_paths(fitting));
    }
  } else {
    // Numbers without names may be times as they rise, or anything else.
    const bool are_named = with_times.size() == 1 && !has_only(tape, with_times[0].value, Kind::array);
    ColumnOptions requested_columns = options.columns;
    requested_columns.timeless = options.columns.timeless && fitting.size() < 2;
    if (!are_named) refuse_other_json(tape, requested_columns, fitting.empty() ? "" : fitting[0].path);
  }
  if (path.empty() && fitting.size() > 1) {
    const std::string all = path_of_all(tape, fitting);
    throw data_error(
        "{} lists may be the keys: {}; expected one; give --records {}, another one of these, or {} a curve "
        "of each list",
        fitting.size(), listed_paths(fitting), in_shell(fitting[0].path),
        all.empty() ? "a path with * for any name or number, which makes"
                    : fmt::format("--records {}, which makes", in_shell(all)))
        .at({"", 1, 1});
  }
  std::vector<JsonTable> tables;
  for (const Place& place : path.empty() ? fitting : requested) {
    auto table = JsonTable::find(tape, place.value, place.path, false, options.columns.timeless);
    if (table && table->size() > 0) {
      tables.push_back(*std::move(table));
    } else if (!path.empty()) {
      throw data_error(
          "{}: this is not a list of records; expected an array of objects or of rows, or an object of columns; give "
          "another path",
          place.path)
          .at(tape.position(place.value));
    }
  }
  return tables;
}

}  // namespace tcb
