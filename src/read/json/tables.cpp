// Tables in JSON: the lists of records in a text of any shape, however these are laid out.
#include "read/json/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
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

using Kind = Json::Kind;
using Values = std::vector<std::uint32_t>;

/// Whether a name may be an index of rows: a number, or a time in words.
bool is_index(std::string_view name) { return parse_number(name) || find_notation(name); }

/// Whether a name is x, y or z.
bool is_axis(std::string_view name) { return name.size() == 1 && lists_word("x y z", in_lower_case(name)); }

/// The first value of an array that is not null; its first one if all are. Requires: it is not empty.
std::size_t first_record(const Json& json, std::size_t array) {
  for (const std::size_t value : json.inside(array)) {
    if (!ends_curve(json, value)) return value;
  }
  return json.first(array);
}

/// Throws: Error (data) at another member with the name of one.
void require_once(const Json& json, std::size_t object, std::size_t member) {
  for (const std::size_t other : json.inside(object)) {
    const bool is_second = other != member && json.name(other) == json.name(member);
    if (is_second) throw twice_in("object").about(json.name(member)).at(json.position(other - 1));
  }
}

/// Finds the layout of tables.
class Layouts {
 public:
  Layouts(const Json& json, std::uint64_t max_memory, const ColumnOptions& columns = {})
      : json_(json), has_time_(columns.timeless || columns.has(Role::time)), memory_(max_memory) {
    for (const RoleRequest& request : columns.roles) {
      if (request.role == Role::time && request.columns.size() == 1) time_ = request.columns[0];
    }
  }

  /// A list of one record with a time is a table, too.
  void take_single_records() { least_records_ = 1; }

  /// The table that a value is. `is_wanted`: by a path, so that nothing has to tell it from other lists.
  std::optional<JsonTable> table_of(std::size_t value, bool is_wanted) {
    JsonTable table{.value = value};
    const MemoryUse before = memory_;
    const bool is_one = json_.is(value, Kind::array)    ? take_list(table, is_wanted)
                        : json_.is(value, Kind::object) ? take_object(table, is_wanted)
                                                        : false;
    if (!is_one || table.size() == 0) {
      memory_ = before;
      return std::nullopt;
    }
    take_index(table);
    return table;
  }
  /// Whether a name is that of the time: the requested one, or else a usual one.
  bool is_time(std::string_view name) const { return time_.empty() ? is_usual_time(name) : name == time_; }

  /// Why an object is none: its columns differ in size, or have a row twice.
  const std::optional<Error>& fault() const { return fault_; }

  bool is_number(std::size_t value) const {
    return json_.is(value, Kind::number) || (json_.is(value, Kind::string) && parse_number(json_.text(value)));
  }
  bool is_missing(std::size_t value) const {
    return json_.is(value, Kind::null) || (json_.is(value, Kind::string) && is_missing_sign(json_.text(value), {}));
  }
  bool is_in_words(std::size_t value) const {
    return json_.is(value, Kind::string) && find_notation(json_.text(value));
  }
  /// Whether a value may be in a column.
  bool is_cell(std::size_t value) const { return is_number(value) || is_missing(value) || is_in_words(value); }

  /// Whether an array may have the times by its values: numbers that rise, or times in words.
  bool may_be_times(std::size_t array) const {
    return rises(array) || std::ranges::all_of(json_.inside(array), [&](auto value) { return is_in_words(value); });
  }
  /// Whether an array has numbers alone, of which each is greater than the one before.
  bool rises(std::size_t array) const {
    std::optional<double> before;
    return std::ranges::all_of(json_.inside(array), [&](std::size_t value) {
      const auto number = json_.is(value, Kind::number) ? parse_number(json_.text(value)) : std::nullopt;
      const bool is_next = number && (!before || *number > *before);
      before = number;
      return is_next;
    });
  }
  bool are_cells(std::size_t array) const {
    return std::ranges::all_of(json_.inside(array), [&](std::size_t value) { return is_cell(value); });
  }

  bool has_number(std::size_t object) const {
    return any_inside(object, [&](std::size_t value) {
      const bool is_array = json_.is(value, Kind::array) && !json_.is_empty(value);
      return is_number(is_array ? json_.first(value) : value);
    });
  }
  /// Whether an array has objects alone, or also null, which ends a curve.
  bool is_list_of_objects(std::size_t array) const {
    return !json_.is_empty(array) && json_.is(first_record(json_, array), Kind::object) &&
           std::ranges::all_of(json_.inside(array), [&](std::size_t value) {
             return json_.is(value, Kind::object) || json_.is(value, Kind::null);
           });
  }
  /// Whether arrays or objects have as many values as the first of them, of the same names.
  bool are_alike(const Values& values) const {
    const auto has_names_of_first = [&](std::size_t value) {
      return std::ranges::equal(json_.inside(value), json_.inside(values[0]),
                                [&](auto one, auto other) { return json_.name(one) == json_.name(other); });
    };
    return std::ranges::all_of(values, has_names_of_first);
  }

 private:
  /// Whether f holds for the value of a member of an object, or of one within it.
  template <class F>
  bool any_inside(std::size_t object, const F& f) const {
    return std::ranges::any_of(json_.inside(object), [&](std::size_t value) {
      return f(value) || (json_.is(value, Kind::object) && any_inside(value, f));
    });
  }
  bool has_time(std::size_t object) const {
    return any_inside(object, [&](std::size_t value) {
      return !json_.is_nested(value) && (is_usual_time(json_.name(value)) || time_part_of(json_.name(value)));
    });
  }
  /// Whether a row has a number, a time in words or no value in each cell, which may be a vector.
  bool is_row(std::size_t row) const {
    const auto is_cell_or_vector = [&](std::size_t cell) {
      return is_number(cell) || is_missing(cell) || (cell == json_.first(row) && is_in_words(cell)) ||
             (cell != json_.first(row) && json_.has_only(cell, Kind::number));
    };
    return json_.is(row, Kind::array) && std::ranges::all_of(json_.inside(row), is_cell_or_vector);
  }

  /// Takes the names of columns from a first row of different texts that are no cells. Behind it are rows as long.
  bool take_row_of_names(JsonTable& table, bool is_wanted) const {
    const std::size_t first = table.records[0];
    const auto is_name = [&](std::size_t value) { return json_.is(value, Kind::string) && !is_cell(value); };
    const std::size_t count = json_.count(first);
    if (table.records.size() < 3 || count < 2 || !json_.is(first, Kind::array)) return false;
    std::unordered_set<std::string_view> names;
    for (const std::size_t value : json_.inside(first)) {
      if (!is_name(value) || !names.insert(json_.text(value)).second) return false;
    }
    const auto is_row_below = [&](std::size_t row) {
      return json_.is(row, Kind::array) && (is_wanted || (json_.count(row) == count && has_number(row)));
    };
    if (!std::all_of(table.records.begin() + 1, table.records.end(), is_row_below)) return false;
    for (const std::size_t value : json_.inside(first)) table.names.emplace_back(json_.text(value));
    table.records.erase(table.records.begin());
    ++table.number;
    table.has_times = std::ranges::any_of(table.names, [](auto& name) { return is_usual_time(name); });
    return true;
  }

  /// The records of a list from the first that is not null.
  void take_records(JsonTable& table, std::size_t list) const {
    Values records = records_in(json_, list);
    const auto first = std::ranges::find_if(records, [&](std::size_t record) { return !ends_curve(json_, record); });
    table.number = static_cast<std::uint64_t>(first - records.begin());
    table.records.assign(first, records.end());
  }

  bool take_list(JsonTable& table, bool is_wanted) {
    const bool is_root = table.value <= 1;
    take_records(table, table.value);
    if (table.records.empty()) return false;
    if (is_wanted && json_.has_only(table.value, Kind::number)) {
      add_column(table, "value", table.records.size()) = table.records;
      return true;
    }
    if (is_list_of_objects(table.value) || (is_wanted && json_.is(table.records[0], Kind::object))) {
      table.has_times = has_time(table.records[0]);
      const bool has_enough = table.records.size() > 1 || is_root || (least_records_ == 1 && table.has_times);
      return is_wanted || (has_enough && has_number(table.records[0]));
    }
    if (take_row_of_names(table, is_wanted)) return true;
    table.has_names = false;
    const bool is_whole_text = table.value <= 1 && json_.is(table.records[0], Kind::array) &&
                               table.records.size() > 1 && json_.count(table.records[0]) > 1 &&
                               is_row(table.records[0]);
    if (is_whole_text) is_wanted = true;
    if (!is_wanted && !json_.has_only(table.value, Kind::array)) return false;
    table.has_times = table.records.size() > 1;
    std::optional<double> before;
    for (const std::size_t row : table.records) {
      if (!is_wanted && (json_.count(row) < 2 || !is_row(row))) return false;
      if (!json_.is(row, Kind::array) || json_.is_empty(row) || !is_number(json_.first(row))) continue;
      const double time = parse_number(json_.text(json_.first(row))).value_or(0);
      table.has_times = table.has_times && (!before || time > *before);
      before = time;
    }
    if (!table.has_times && are_lists_of_columns(table.records)) return take_lists(table);
    return is_wanted || ((table.records.size() > 1 || is_root) && are_alike(table.records));
  }

  /// Whether few lists have many cells each, and the numbers of the first one rise: a list of times, and of others.
  bool are_lists_of_columns(const Values& lists) const {
    return !has_time_ && lists.size() > 1 && 2 * lists.size() <= json_.count(lists[0]) && rises(lists[0]) &&
           are_alike(lists) &&
           std::ranges::all_of(lists, [&](std::size_t list) { return json_.is(list, Kind::array) && are_cells(list); });
  }

  /// Takes each list as a column.
  bool take_lists(JsonTable& table) {
    const Values lists = std::move(table.records);
    table.records.clear();
    std::vector<std::string> names = default_channel_names(lists.size() - 1);
    names.insert(names.begin(), "time");
    for (std::size_t i = 0; i < lists.size(); ++i) {
      add_column(table, names[i], json_.count(lists[i])) = json_.values(lists[i]);
    }
    table.number = 0;
    return table.has_names = table.has_times = table.are_lists = true;
  }

  bool take_object(JsonTable& table, bool is_wanted) {
    table.has_times = true;
    const Values members = json_.values(table.value);
    if (members.empty()) return false;
    if (take_rows_beside_columns(table) || take_records_beside_schema(table)) return true;
    const auto is_row_of_index = [&](std::size_t member) {
      return is_index(json_.name(member)) && json_.is_nested(member) && !json_.is_empty(member);
    };
    const auto is_cell_of_index = [&](std::size_t member) { return is_index(json_.name(member)) && is_cell(member); };
    const bool may_be_cells = members.size() > 1 && (is_wanted || table.value <= 1);
    if (may_be_cells && std::ranges::all_of(members, is_cell_of_index)) {
      add_column(table, "value", members.size()) = members;
      for (const std::uint32_t member : members) table.index.push_back(member - 1);
      return true;
    }
    const bool are_objects = json_.has_only(table.value, Kind::object);
    const bool are_arrays = json_.has_only(table.value, Kind::array);
    if ((are_objects || are_arrays) && std::ranges::all_of(members, is_row_of_index)) {
      table.records = members;
      for (const std::uint32_t member : members) table.index.push_back(member - 1);
      table.has_names = are_objects;
      return true;
    }
    const bool has_index = are_objects && !json_.is_empty(members[0]) && is_index(json_.name(json_.first(members[0])));
    const bool may_be_rows = has_index && members.size() == 1 && json_.is_nested(json_.first(members[0]));
    if (has_index && !may_be_rows) return take_columns_by_index(table, members, is_wanted);
    if (are_objects && members.size() > 1 && has_time(members[0]) && has_number(members[0]) && are_alike(members)) {
      table.records = members;
      return true;
    }
    return take_arrays(table, members, is_wanted);
  }

  /// Rows beside the names of their columns, with an index if there is one.
  bool take_rows_beside_columns(JsonTable& table) const {
    const auto columns = member_of_texts(table.value, {"columns", "names", "header", "headers", "fields"});
    const auto index = json_.member(table.value, "index");
    if (!columns || json_.is_empty(*columns)) return false;
    for (const std::string_view name : {"data", "values", "rows"}) {
      const auto rows = json_.member(table.value, name);
      if (!rows || !json_.has_only(*rows, Kind::array)) continue;
      table.records = json_.values(*rows);
      require_once(json_, table.value, *columns);
      for (const std::size_t column : json_.inside(*columns)) table.names.emplace_back(json_.text(column));
      if (index && json_.is(*index, Kind::array)) table.index = json_.values(*index);
      if (index && table.index.size() != table.records.size()) {
        throw data_error("the index of the table has {}; expected {}, one for each row",
                         how_many(table.index.size(), "value"), table.records.size())
            .at(json_.position(*index));
      }
      for (const std::size_t member : {*columns, *rows, index.value_or(*rows)}) add_member(table, member);
      return true;
    }
    return false;
  }
  static void add_member(JsonTable& table, std::size_t member) {
    table.members.push_back(static_cast<std::uint32_t>(member));
  }

  /// The records of a table of pandas, whose index is the member "index".
  bool take_records_beside_schema(JsonTable& table) const {
    const auto schema = json_.member(table.value, "schema"), data = json_.member(table.value, "data");
    const bool are_records = schema && json_.is(*schema, Kind::object) && data && json_.is(*data, Kind::array);
    if (!are_records || !is_list_of_objects(*data)) return false;
    take_records(table, *data);
    for (const std::size_t record : table.records) {
      const auto index = json_.member(record, "index");
      if (!index) break;
      table.index.push_back(static_cast<std::uint32_t>(*index));
    }
    if (table.index.size() < table.records.size()) table.index.clear();
    add_member(table, *schema);
    add_member(table, *data);
    return true;
  }

  /// The first member of one of these names that is an array without objects and arrays.
  std::optional<std::size_t> member_of_texts(std::size_t object, std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
      const auto member = json_.member(object, name);
      const bool is_list = member && json_.is(*member, Kind::array);
      if (is_list && std::ranges::none_of(json_.inside(*member), [&](auto value) { return json_.is_nested(value); })) {
        return member;
      }
    }
    return std::nullopt;
  }

  /// Members of each column by the index of their row. The rows come in the order in which they are found.
  bool take_columns_by_index(JsonTable& table, const Values& members, bool is_wanted) {
    constexpr std::uint64_t bytes_of_row = 96;
    std::unordered_map<std::string_view, std::size_t> rows;
    for (const std::size_t column : members) {
      for (const std::uint32_t cell : json_.inside(column)) {
        if (!rows.emplace(json_.name(cell), rows.size()).second) continue;
        memory_.add(bytes_of_row);
        table.index.push_back(cell - 1);
      }
    }
    for (const std::size_t column : members) {
      if (json_.is_empty(column)) continue;
      Values& cells = add_column(table, std::string(json_.name(column)), rows.size());
      for (const std::uint32_t cell : json_.inside(column)) {
        if (std::exchange(cells[rows[json_.name(cell)]], cell) == 0) continue;
        fault_ = twice_in("object")
                     .about(fmt::format("{}.{}", json_.name(column), json_.name(cell)))
                     .at(json_.position(cell - 1));
        if (is_wanted) throw Error(*fault_);
        return false;
      }
    }
    return true;
  }

  /// A column without values, whose memory is counted before it is kept.
  Values& add_column(JsonTable& table, std::string name, std::size_t rows,
                     std::uint32_t element = JsonTable::of_member) {
    constexpr std::uint64_t bytes_of_column = 64;
    memory_.add(name.size() + bytes_of_column + rows * sizeof(std::uint32_t));
    table.names.push_back(std::move(name));
    table.elements.push_back(element);
    return table.columns.emplace_back(rows);
  }

  /// An array for each column, all of the size of the times, or of several numbers for each time; also in objects.
  bool take_arrays(JsonTable& table, const Values& members, bool is_wanted) {
    Values arrays;
    std::optional<std::size_t> times;
    bool are_coordinates = true;  // which need no times
    for (const std::size_t member : members) {
      if (!json_.is(member, Kind::array) || json_.has_only(member, Kind::object)) continue;
      const bool are_times = is_time(json_.name(member)) && !json_.has_only(member, Kind::array);
      if (are_times && !times) times = member;
      arrays.push_back(static_cast<std::uint32_t>(member));
      are_coordinates = are_coordinates && is_axis(json_.name(member)) && json_.count(member) > 1 &&
                        json_.has_only(member, Kind::number) && !rises(member);  // as one that rises may be the time
    }
    if (arrays.empty() || (!is_wanted && ((!times && !are_coordinates) || arrays.size() < 2))) return false;
    table.has_times = times.has_value();
    const std::size_t rows = json_.count(times.value_or(arrays[0]));
    for (const std::size_t array : arrays) {
      if (take_array(table, std::string(json_.name(array)), array, times ? rows : 0, rows)) {
        add_member(table, array);
        continue;
      }
      const std::size_t first = times.value_or(arrays[0]);
      fault_ = data_error("the column {} has {}; expected {}, as many as {}", in_quotes(json_.name(array)),
                          how_many(json_.count(array), "value"), rows, in_quotes(json_.name(first)))
                   .at(json_.position(array - 1));
      if (is_wanted) throw Error(*fault_);
      return false;
    }
    const auto is_column = [&](std::size_t member) {
      return json_.is(member, Kind::array) && json_.count(member) == rows;
    };
    for (const std::size_t object : members) {
      if (!json_.is(object, Kind::object) || !std::ranges::all_of(json_.inside(object), is_column)) continue;
      add_member(table, object);
      for (const std::size_t array : json_.inside(object)) {
        take_array(table, fmt::format("{}.{}", json_.name(object), json_.name(array)), array, 0, rows);
      }
    }
    return rows > 0;
  }

  /// Adds an array as a column if it has as many values as there are rows, or as several columns if it has a multiple
  /// of `vectors`, the number of vectors.
  bool take_array(JsonTable& table, std::string name, std::size_t array, std::size_t vectors, std::size_t rows) {
    const std::size_t count = json_.count(array);
    const bool are_vectors = vectors > 1 && count > vectors && count % vectors == 0;
    if (are_vectors && json_.has_only(array, Kind::number)) {
      add_flat_vectors(table, name, json_.values(array), vectors);
      return true;
    }
    if (count != rows) return false;
    add_column(table, std::move(name), rows) = json_.values(array);
    return true;
  }

  /// A column for each number of vectors that are written one after another.
  void add_flat_vectors(JsonTable& table, const std::string& name, const Values& cells, std::size_t rows) {
    const std::size_t size = cells.size() / rows;
    for (std::size_t number = 0; number < size; ++number) {
      Values& column = add_column(table, name, rows, static_cast<std::uint32_t>(number));
      for (std::size_t row = 0; row < rows; ++row) column[row] = cells[row * size + number];
    }
  }

  /// The index is the time where no column is, unless it counts the rows from 0, as it does where it is not given.
  void take_index(JsonTable& table) const {
    if (table.index.empty()) return;
    bool is_time = std::ranges::none_of(table.names, [](auto& name) { return is_usual_time(name); });
    if (table.names.empty() && table.has_names) {
      for (const std::size_t member : json_.inside(table.records[0])) {
        is_time = is_time && !is_usual_time(json_.name(member));
      }
    }
    bool counts = true;
    for (std::size_t row = 0; row < table.index.size() && counts; ++row) {
      counts = json_.text(table.index[row]) == fmt::format("{}", row);
    }
    if (!is_time || counts) table.index.clear();
  }

  const Json& json_;
  const bool has_time_;            ///< it is requested, or none is
  std::string time_ = {};          ///< the name of the time, if it is requested
  std::size_t least_records_ = 2;  ///< of a list of objects that no path leads to
  std::optional<Error> fault_;
  MemoryUse memory_;  ///< of the index of rows, and of columns
};

/// Whether a list of objects is somewhere below a value, which are the keys then.
bool holds_list(const Json& json, const Layouts& layouts, std::size_t value) {
  for (std::size_t at = value + 1; at < json.next(value); ++at) {
    if (!json.is(at, Kind::array) || json.is_empty(at) || json.next(json.first(at)) == json.next(at)) continue;
    if (layouts.is_list_of_objects(at) && layouts.has_number(first_record(json, at))) return true;
  }
  return false;
}

/// The way to a value.
struct Way {
  std::string path = {};
  std::vector<JsonTable::Outer> around = {};
};

/// A step of a way to a value, for as long as this lives.
class Step {
 public:
  Step(Way& way, const Json& json, std::size_t outer, std::size_t inner, std::size_t number)
      : way_(way), path_size_(way.path.size()), depth_(way.around.size()) {
    std::string& path = way.path;
    if (!json.is_member(inner)) {
      path += fmt::format("[{}]", number);
    } else {
      way.around.push_back({static_cast<std::uint32_t>(outer), static_cast<std::uint32_t>(inner),
                            static_cast<std::uint32_t>(path_size_)});
      if (!path.empty()) path += '.';
      path += json.name(inner);
    }
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;
  ~Step() {
    way_.path.resize(path_size_);
    way_.around.resize(depth_);
  }

 private:
  Way& way_;
  std::size_t path_size_, depth_;
};

std::string in_quotes_and_brackets(std::string_view name) { return fmt::format("[\"{}\"]", name); }

/// A name as a path has it, so that it is no other step.
std::string step_of(std::string_view name) {
  const bool is_plain = !name.empty() && name != "*" && name.find_first_of(".[") == name.npos;
  return is_plain ? std::string(name) : in_quotes_and_brackets(name);
}

/// The rest of a path behind a step, if it begins with one of its forms.
std::optional<std::string_view> behind_step(std::string_view path, std::initializer_list<std::string_view> forms) {
  for (const std::string_view form : forms) {
    if (form.empty() || !path.starts_with(form)) continue;
    const std::string_view rest = path.substr(form.size());
    if (rest.empty() || rest[0] == '[') return rest;
    if (rest[0] == '.' && rest.size() > 1) return rest.substr(1);
  }
  return std::nullopt;
}

/// Finds the values at the end of a path, to one of which the way is. `in_any_form`: names need no quotes.
template <class F>
void follow(const Json& json, std::size_t value, Way& way, std::string_view left, bool in_any_form, const F& found) {
  if (left.empty()) return found(value);
  std::size_t number = 0;
  for (const std::size_t inner : json.inside(value)) {
    const std::string_view name = json.name(inner);
    const auto rest = !json.is_member(inner) ? behind_step(left, {fmt::format("[{}]", number), "[*]"})
                      : in_any_form          ? behind_step(left, {in_quotes_and_brackets(name), name, "*"})
                                             : behind_step(left, {step_of(name), "*"});
    if (rest) {
      const Step step(way, json, value, inner, number);
      follow(json, inner, way, *rest, in_any_form, found);
    }
    ++number;
  }
}

/// Finds the tables of a text.
class TableSearch {
 public:
  TableSearch(const Json& json, const InputOptions& options)
      : json_(json),
        options_(options),
        layouts_(json, options.max_memory, options.columns),
        paths_(options.max_memory) {}

  std::vector<JsonTable> find() {
    constexpr std::size_t root = 1;
    const bool is_at_path = !options_.records.empty();
    if (is_at_path && take_path(root)) return std::move(tables_);
    if (!is_at_path && (take_requested_list(root) || take_own_curves(root))) return std::move(tables_);
    search(root);
    if (tables_.empty()) {
      layouts_.take_single_records();
      search(root);
    }
    const bool has_times = std::ranges::any_of(tables_, &JsonTable::has_times);
    if (has_times) std::erase_if(tables_, [](const JsonTable& table) { return !table.has_times; });
    if (is_at_path) {
      throw usage_error("--records {}: there is no such value; expected the path of a list of records{}{}",
                        options_.records, tables_.empty() ? "" : ", such as ", listed_paths());
    }
    const auto is_named = [](const JsonTable& table) { return table.has_times && table.has_names; };
    const bool is_one = tables_.size() == 1 && is_named(tables_[0]);
    const bool are_columns = is_one && !tables_[0].columns.empty();
    const auto table = std::ranges::find_if(tables_, is_named);
    const bool may_be_scattered =
        std::ranges::count_if(tables_, is_named) == 1 && !table->columns.empty() && has_vectors_beside(*table);
    if (may_be_scattered || std::ranges::none_of(tables_, is_named)) {
      if (auto scattered = scattered_arrays()) return {*std::move(scattered)};
      if (!has_times && !is_at_path) require_no_unnamed_times();
    }
    if (!is_one || are_columns) refuse_other_files(root);
    if (tables_.empty() && layouts_.fault()) throw Error(*layouts_.fault());
    require_each_once();
    if (tables_.size() > 1) refuse_several();
    if (tables_.size() == 1) require_no_times_beside(tables_[0]);
    return std::move(tables_);
  }

 private:
  /// Takes an array of times beside a list of objects without such, one for each, as their times.
  void take_times_beside(JsonTable& table) const {
    const bool may_be = table.has_names && table.columns.empty() && table.names.empty() && table.index.empty();
    if (!may_be || table.has_times || table.number > 0 || way_.around.empty()) return;
    const JsonTable::Outer& outer = way_.around.back();
    if (outer.member != table.value) return;
    for (const std::size_t member : json_.inside(outer.object)) {
      const bool are_times = is_usual_time(json_.name(member)) && json_.is(member, Kind::array) &&
                             json_.count(member) == table.records.size();
      if (!are_times || !layouts_.are_cells(member)) continue;
      table.index = json_.values(member);
      table.members.push_back(static_cast<std::uint32_t>(member));
      table.has_times = true;
      return;
    }
  }

  /// Throws: Error (data) for rows beside an array of rising numbers, one for each, which may be the times.
  void require_no_times_beside(const JsonTable& table) const {
    const ColumnOptions& columns = options_.columns;
    if (table.has_names || table.around.empty() || columns.timeless || columns.has(Role::time)) return;
    const JsonTable::Outer& outer = table.around.back();
    if (outer.member != table.value) return;
    for (const std::size_t member : json_.inside(outer.object)) {
      const bool may_be = json_.is(member, Kind::array) && json_.count(member) == table.records.size();
      if (!may_be || !layouts_.rises(member)) continue;
      const std::string_view name = json_.name(member), list = json_.name(outer.member);
      throw data_error(
          "the array {} has a rising number for each row of {}; expected the times in the rows; give --columns {} if "
          "the array has the times, or --columns time=1 if the first number of each row is one",
          in_quotes(name), in_quotes(list), in_shell(fmt::format("time={},position={}", name, list)))
          .at(json_.position(member - 1));
    }
  }

  void add(JsonTable table) {
    take_times_beside(table);
    paths_.add(way_.path.size() + way_.around.size() * sizeof(JsonTable::Outer));
    table.path = way_.path;
    table.around = way_.around;
    tables_.push_back(std::move(table));
  }

  bool take_path(std::size_t root) {
    const auto found = [&](std::size_t value) {
      auto table = layouts_.table_of(value, true);
      if (table) return add(*std::move(table));
      throw data_error(
          "{}: this is not a list of records; expected an array of objects or of rows, or an object of columns; give "
          "another path",
          way_.path)
          .at(json_.position(value));
    };
    follow(json_, root, way_, options_.records, false, found);
    if (tables_.empty()) follow(json_, root, way_, options_.records, true, found);
    require_each_once();
    return !tables_.empty();
  }

  /// A list is the keys where its first record has a column that is requested.
  bool take_requested_list(std::size_t root) {
    if (!json_.is(root, Kind::array) || json_.is_empty(root)) return false;
    const std::size_t first = first_record(json_, root);
    const auto is_there = [&](std::string_view column) {
      return json_.member(first, column) || json_.member(first, column.substr(0, column.find_first_of(".[")));
    };
    const bool is_requested = std::ranges::any_of(
        options_.columns.roles, [&](const RoleRequest& role) { return std::ranges::any_of(role.columns, is_there); });
    if (!is_requested) return false;
    auto table = layouts_.table_of(root, true);
    if (table) add(*std::move(table));
    return !tables_.empty();
  }

  /// "keys" or "rows" in an object, or in each of "curves", as the program writes them.
  bool take_own_curves(std::size_t root) {
    const auto curves = json_.member(root, "curves");
    if (!curves || !json_.is(*curves, Kind::array)) return take_own_keys(root);
    const auto has_list = [&](std::size_t curve) { return json_.member(curve, "keys") || json_.member(curve, "rows"); };
    if (std::ranges::none_of(json_.inside(*curves), has_list)) return false;
    require_once(json_, root, *curves);
    const Step to_curves(way_, json_, root, *curves, 0);
    std::size_t number = 0;
    for (const std::size_t curve : json_.inside(*curves)) {
      const Step step(way_, json_, *curves, curve, number++);
      if (!json_.is(curve, Kind::object)) {
        throw data_error("no curve here; expected an object with \"keys\"").at(json_.position(curve));
      }
      if (take_own_keys(curve)) continue;
      if (number == 1 && !has_list(curve)) return false;
      add({.value = curve, .is_own = true});
    }
    return !tables_.empty();
  }

  bool take_own_keys(std::size_t object) {
    for (const std::string_view name : {"keys", "rows"}) {
      const auto keys = json_.member(object, name);
      if (!keys || !json_.is(*keys, Kind::array)) continue;
      if (json_.is_empty(*keys)) {
        if (!way_.path.empty()) return false;
        throw data_error("found no keys; expected at least two").at(json_.position(object));
      }
      if (!json_.is(first_record(json_, *keys), Kind::object)) continue;
      auto table = layouts_.table_of(*keys, true);
      if (!table) continue;
      const Step step(way_, json_, object, *keys, 0);
      require_once(json_, object, *keys);
      table->is_own = true;
      add(*std::move(table));
      return true;
    }
    return false;
  }

  /// Finds tables, of which none holds another one. A list of objects without times that hold lists is none: these
  /// are the keys.
  void search(std::size_t value) {
    auto table = layouts_.table_of(value, false);
    const auto has_lists = [&] {
      if (table->has_times || !json_.is(value, Kind::array)) return false;
      const auto first = layouts_.table_of(table->records[0], false);
      return (first && first->has_times) || holds_list(json_, layouts_, value);
    };
    if (table && !has_lists()) return add(*std::move(table));
    std::size_t number = 0;
    for (const std::size_t inner : json_.inside(value)) {
      if (json_.is_nested(inner)) {
        const Step step(way_, json_, value, inner, number);
        search(inner);
      }
      ++number;
    }
  }

  /// An array of numbers, or of vectors, with the name that it or the object around it has.
  struct Array {
    std::size_t value;
    std::string_view name;
    std::size_t object;  ///< that it is in
    bool is_of_object;   ///< it is called data or values, and its name is that of the object
  };

  /// Whether a value is an array of cells, or of vectors of one size.
  bool may_be_column(std::size_t value) const {
    if (!json_.is(value, Kind::array) || json_.is_empty(value) || json_.count(value) < 2) return false;
    const bool are_vectors = json_.has_only(value, Kind::array);
    const std::size_t size = are_vectors ? json_.count(json_.first(value)) : 0;
    return std::ranges::all_of(json_.inside(value), [&](std::size_t inner) {
      return are_vectors ? json_.has_only(inner, Kind::number) && json_.count(inner) == size : layouts_.is_cell(inner);
    });
  }

  std::vector<Array> arrays_by_name() const {
    std::vector<Array> arrays;
    for (std::size_t value = 1; value < json_.size(); ++value) {
      if (!json_.is(value, Kind::object)) continue;
      std::optional<std::string_view> label;
      for (const std::size_t member : json_.inside(value)) {
        if (!may_be_column(member)) continue;
        const std::string_view name = json_.name(member);
        if (name != "data" && name != "values") {
          arrays.push_back({member, name, value, false});
          continue;
        }
        if (!label) label = label_of(value);
        arrays.push_back({member, label->empty() ? name : *label, value, !label->empty()});
      }
    }
    return arrays;
  }

  /// The text that says what the values of an object are.
  std::string_view label_of(std::size_t object) const {
    for (const std::string_view name : {"name", "label", "type", "id", "key"}) {
      const auto member = json_.member(object, name);
      if (member && json_.is(*member, Kind::string)) return json_.text(*member);
    }
    return json_.name(object);
  }

  /// Arrays as long as the only one of times, wherever they are: a column each.
  std::optional<JsonTable> scattered_arrays() const {
    const std::vector<Array> arrays = arrays_by_name();
    const auto is_time = [&](const Array& array) { return layouts_.is_time(array.name); };
    if (std::ranges::count_if(arrays, is_time) != 1) return std::nullopt;
    JsonTable table{.value = 1, .has_times = true, .are_scattered = true};
    const std::size_t rows = json_.count(std::ranges::find_if(arrays, is_time)->value);
    std::unordered_set<std::string_view> names;
    for (const auto& [value, name, object, is_of_object] : arrays) {
      Values cells = json_.values(value);
      const bool are_places = name == "coordinates";  // of GeoJSON, each with its numbers
      const bool are_columns =
          cells.size() != rows && !are_places && json_.is_nested(cells[0]) && json_.count(cells[0]) == rows;
      table.members.push_back(static_cast<std::uint32_t>(value));
      if (cells.size() != rows && !are_columns) {
        table.others.emplace_back(name);
        continue;
      }
      if (!names.insert(name).second) return std::nullopt;
      if (!are_columns) {
        table.names.emplace_back(name);
        table.columns.push_back(std::move(cells));
        continue;
      }
      for (std::size_t number = 0; number < cells.size(); ++number) {
        table.names.push_back(fmt::format("{}[{}]", name, number));
        table.columns.push_back(json_.values(cells[number]));
      }
    }
    return table.columns.size() > 1 ? std::optional(std::move(table)) : std::nullopt;
  }

  /// Throws: Error (data) for an array that may have the times of others by its values: of those beside it, or of those
  /// that are called data or values, as charts have them.
  void require_no_unnamed_times() const {
    if (options_.columns.timeless || !options_.columns.roles.empty()) return;
    std::vector<Array> arrays = arrays_by_name();
    std::erase_if(arrays, [&](const Array& array) {  // as vectors of records are no columns
      return !array.is_of_object && std::ranges::any_of(tables_, [&](const JsonTable& table) {
        return array.value > table.value && array.value < json_.next(table.value) && table.columns.empty();
      });
    });
    const auto is_of = [&](const Array& times, const Array& other) {
      const bool is_near = other.object == times.object || other.is_of_object;
      return is_near && other.value != times.value && json_.count(other.value) == json_.count(times.value);
    };
    const Array *found = nullptr, *first = nullptr;
    for (const Array& times : arrays) {
      const auto other = std::ranges::find_if(arrays, [&](const Array& one) { return is_of(times, one); });
      const bool may_be = other != arrays.end() && layouts_.may_be_times(times.value);
      if (!may_be || (found != nullptr && !(found->is_of_object && !times.is_of_object))) continue;
      found = &times;
      first = &*other;
    }
    if (found == nullptr) return;
    throw data_error(
        "no array is called time, but {} rises, and {} has as many values; expected one called time; give --columns {} "
        "if it has the times, or --records {} --parameter uniform for keys without times",
        in_quotes(found->name), in_quotes(first->name), in_shell(fmt::format("time={}", found->name)),
        in_shell(json_.path(1, first->value)))
        .at(json_.position(found->value - 1));
  }

  /// Whether an array outside of a table has a vector for each of its rows.
  bool has_vectors_beside(const JsonTable& table) const {
    for (std::size_t value = 1; value < json_.size(); ++value) {
      if (value >= table.value && value < json_.next(table.value)) continue;
      const bool are_vectors = json_.has_only(value, Kind::array) && json_.count(value) == table.size();
      if (are_vectors && may_be_column(value)) return true;
    }
    return false;
  }

  /// Throws: Error (data) for a file of another product, by its members, unless columns are requested.
  void refuse_other_files(std::size_t root) const {
    if ((options_.columns.timeless && tables_.size() < 2) || !options_.columns.roles.empty()) return;
    std::unordered_set<std::string_view> names;
    for (std::size_t at = 0; at < json_.size(); ++at) {
      if (json_.is_name(at)) names.insert(json_.text(at));
    }
    const bool is_list = json_.is(root, Kind::array) && !json_.is_empty(root);
    const auto type = json_.member(is_list ? first_record(json_, root) : root, "type");
    const std::string path = path_for_rest(root);
    const std::string records = path.empty() ? "" : fmt::format("--records {} ", in_shell(path));
    const auto error = other_json(names, type ? json_.text(*type) : "", records);
    if (error) throw error->at({"", 1, 1});
  }

  /// The path to all lists; to the first one where there is none; beside columns, to the first array of vectors.
  std::string path_for_rest(std::size_t root) const {
    if (tables_.empty()) return "";
    if (tables_.size() > 1) {
      const std::string all = path_of_all();
      if (!all.empty()) return all;
    }
    if (tables_[0].columns.empty()) {
      const std::string path = path_of(tables_[0]);
      return path.ends_with(']') ? path.substr(0, path.rfind('[')) + "[*]" : path;  // as there may be more lists
    }
    for (std::size_t value = root; value < json_.size(); ++value) {
      const bool is_place = json_.is_member(value) && json_.name(value) == "coordinates";
      if (is_place && json_.has_only(value, Kind::array)) return json_.path(root, value);
    }
    return path_of(tables_[0]);
  }

  std::string listed_paths() const {
    std::vector<std::string> paths;
    for (const JsonTable& table : tables_) {
      const std::string path = path_of(table);
      paths.push_back(path.empty() ? "the whole text" : path);
    }
    return listed(paths);
  }

  /// The steps of the path of a table, each of which leads to one value, unless an object has a member twice.
  std::vector<std::string> steps_of(const JsonTable& table) const {
    std::vector<std::string> steps;
    const auto add_elements = [&](std::string_view elements) {
      for (const std::string_view element : split(elements, ']')) {
        if (!element.empty()) steps.push_back(fmt::format("{}]", element));
      }
    };
    std::size_t at = 0;
    for (const JsonTable::Outer& outer : table.around) {
      add_elements(std::string_view(table.path).substr(at, outer.path_size - at));
      const std::string_view name = json_.name(outer.member);
      steps.push_back(step_of(name));
      at = outer.path_size + (outer.path_size > 0 ? 1 : 0) + name.size();
    }
    add_elements(std::string_view(table.path).substr(at));
    return steps;
  }
  static std::string joined(const std::vector<std::string>& steps) {
    std::string path;
    for (const std::string& step : steps) path += (path.empty() || step[0] == '[' ? "" : ".") + step;
    return path;
  }
  /// The path of a table as --records takes it.
  std::string path_of(const JsonTable& table) const { return joined(steps_of(table)); }

  /// Throws: Error (data) for tables of one path, as an object has a member twice.
  void require_each_once() const {
    std::unordered_map<std::string, const JsonTable*> tables;
    for (const JsonTable& table : tables_) {
      const auto [other, is_new] = tables.try_emplace(path_of(table), &table);
      if (is_new) continue;
      std::size_t step = 0;
      while (table.around[step].member == other->second->around[step].member) ++step;
      const std::size_t second = table.around[step].member;
      throw twice_in("object").about(json_.name(second)).at(json_.position(second - 1));
    }
  }

  /// The path of the first table with * for the one step in which those of the others differ; empty where they differ
  /// in more, or their records do.
  std::string path_of_all() const {
    Values firsts;  // records, or objects of columns
    for (const JsonTable& table : tables_) {
      const bool is_list = json_.is(table.value, Kind::array);
      firsts.push_back(static_cast<std::uint32_t>(is_list ? first_record(json_, table.value) : table.value));
    }
    if (!layouts_.are_alike(firsts)) return "";
    std::vector<std::string> steps = steps_of(tables_[0]);
    for (std::string& step : steps) {
      const bool is_name = step[0] != '[' || step.starts_with("[\"");
      const std::string one = std::exchange(step, is_name ? "*" : "[*]"), all = joined(steps);
      std::vector<std::size_t> found;
      Way current;
      follow(json_, 1, current, all, false, [&](std::size_t value) { found.push_back(value); });
      if (std::ranges::equal(found, tables_, {}, {}, &JsonTable::value)) return all;
      step = one;
    }
    return "";
  }

  [[noreturn]] void refuse_several() const {
    const std::string all = path_of_all();
    throw data_error(
        "{} lists may be the keys: {}; expected one; give --records {}, another one of these, or {} a curve of each "
        "list",
        tables_.size(), listed_paths(), in_shell(path_of(tables_[0])),
        all.empty() ? "a path with * for any name or number, which makes"
                    : fmt::format("--records {}, which makes", in_shell(all)))
        .at({"", 1, 1});
  }

  const Json& json_;
  const InputOptions& options_;
  Layouts layouts_;
  MemoryUse paths_;  ///< of the paths of tables
  std::vector<JsonTable> tables_;
  Way way_;  ///< to the current value
};

}  // namespace

std::vector<JsonTable> find_tables(const Json& json, const InputOptions& options) {
  return TableSearch(json, options).find();
}

bool ends_curve(const Json& json, std::size_t record) {
  return json.is(record, Kind::null) && json.text(record) == "null";
}

std::vector<std::uint32_t> records_in(const Json& json, std::size_t array) {
  std::vector<std::uint32_t> records = json.values(array);
  std::erase_if(records, [&](std::size_t record) {  // the provenance of an output
    return json.is(record, Kind::object) && !json.is_empty(record) && json.name(json.first(record)) == "meta" &&
           json.count(record) == 1;
  });
  return records;
}

JsonTable table_of_values(const Json& json, std::uint64_t max_memory) {
  auto table = Layouts(json, max_memory).table_of(0, true);
  if (table) return *std::move(table);
  if (records_in(json, 0).empty()) {
    throw data_error("found no keys; expected an object, or an array of numbers, for each key").at(json.position(1));
  }
  throw data_error(
      "found {} in the place of a key; expected an object, or an array of numbers, for each key; give a list of these",
      json.shown(1))
      .at(json.position(1));
}

}  // namespace tcb
