// Tables in JSON: rows that are arrays, and values by column, as pandas and NumPy users write them.
#include "read/json/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "read/json/errors.hpp"
#include "read/json/scanner.hpp"
#include "schema/usual_names.hpp"

namespace tcb {
namespace {

/// How a text holds a table.
enum class TableForm {
  none,     ///< not at all
  unknown,  ///< more of the text is needed
  rows,     ///< [[0,1],[1,2]]
  split,    ///< {"columns":["t","x"],"index":[0,1],"data":[[0,1],[1,2]]}
  table,    ///< {"schema":{...},"data":[{"index":0,"t":0,"x":1},...]}
  columns,  ///< {"t":{"0":0,"1":1},"x":{"0":1,"1":2}}
  index,    ///< {"0":{"t":0,"x":1},"1":{"t":1,"x":2}}
  lists,    ///< {"t":[0,1],"x":[1,2]}
};

/// Whether a name may be an index of rows: a number, or a time in words.
bool is_index(std::string_view name) { return parse_number(name) || find_notation(name); }

/// The beginning of a text, for its form.
class TableBeginning {
 public:
  explicit TableBeginning(std::string_view text) : text_(text) {}

  TableForm form() {
    const char outer = next();
    if (outer == '[') return next() == '[' ? TableForm::rows : at_end_ ? TableForm::unknown : TableForm::none;
    if (outer != '{') return at_end_ ? TableForm::unknown : TableForm::none;
    for (bool first = true;; first = false) {
      const std::string_view name = next_name();
      const char value = next();
      if (at_end_) return TableForm::unknown;
      if (value == '{' && first) return form_of_objects(name);
      if (value != '[') return TableForm::none;
      if (name == "columns" || name == "index" || name == "data")
        return next() != '{' ? TableForm::split : TableForm::none;
      if (is_usual_time(name)) return next() != '{' ? TableForm::lists : TableForm::none;
      if (!skip_array()) return at_end_ ? TableForm::unknown : TableForm::none;
      if (next() != ',') return at_end_ ? TableForm::unknown : TableForm::none;
    }
  }

 private:
  TableForm form_of_objects(std::string_view name) {
    if (name == "schema") return TableForm::table;
    if (next() != '"') return at_end_ ? TableForm::unknown : TableForm::none;
    --at_;
    const std::string_view inner = next_name();
    if (at_end_) return TableForm::unknown;
    return is_index(name) ? TableForm::index : is_index(inner) ? TableForm::columns : TableForm::none;
  }

  /// The next character that is not blank, which is passed.
  char next() {
    while (at_ < text_.size() && is_json_blank(text_[at_])) ++at_;
    at_end_ = at_ == text_.size();
    return at_end_ ? '\0' : text_[at_++];
  }

  /// A name, up to its colon; empty where there is none.
  std::string_view next_name() {
    if (next() != '"') return {};
    const std::string_view name = rest_of_string();
    return next() == ':' ? name : std::string_view();
  }

  /// Passes the rest of an array; false if it holds objects, or if the text ends.
  bool skip_array() {
    for (std::size_t depth = 1; depth > 0;) {
      const char c = next();
      if (at_end_ || c == '{') return false;
      if (c == '"') rest_of_string();
      depth += c == '[' ? 1 : 0;
      depth -= c == ']' ? 1 : 0;
    }
    return true;
  }

  /// The characters up to the closing quote, which is passed.
  std::string_view rest_of_string() {
    bool escaped = false;
    const char* const begin = text_.data() + at_;
    const char* const end = find_closing_quote(begin, text_.data() + text_.size(), escaped);
    at_ = std::min(static_cast<std::size_t>(end - text_.data()) + 1, text_.size());
    return {begin, static_cast<std::size_t>(end - begin)};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool at_end_ = false;
};

/// A value; numbers and strings are as written.
struct JsonValue {
  std::string text = {};  ///< of a number, a string, or a word
  bool is_array = false, is_object = false;
  std::vector<JsonValue> elements = {};  ///< of an array, or of the members of an object
  std::vector<std::string> names = {};

  const JsonValue* member(std::string_view name) const {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? nullptr : &elements[static_cast<std::size_t>(found - names.begin())];
  }

  std::string json() const {
    if (!is_array && !is_object) return text;
    std::string all;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (i > 0) all += ',';
      if (is_object) all += nlohmann::json(names[i]).dump() + ":";
      all += elements[i].json();
    }
    return (is_array ? "[" : "{") + all + (is_array ? "]" : "}");
  }
};

/// Builds a value from the events of nlohmann-json, whose names it has.
class ValueBuilder {
 public:
  using Json = nlohmann::json;
  bool null() { return add({"null"}); }
  bool boolean(bool value) { return add({value ? "true" : "false"}); }
  bool number_integer(Json::number_integer_t value) { return add({fmt::format("{}", value)}); }
  bool number_unsigned(Json::number_unsigned_t value) { return add({fmt::format("{}", value)}); }
  bool number_float(Json::number_float_t, const std::string& text) { return add({text}); }
  bool string(const std::string& text) { return add({Json(text).dump()}); }
  bool binary(const Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open({.text = {}, .is_object = true}); }
  bool start_array(std::size_t) { return open({.text = {}, .is_array = true}); }
  bool key(const std::string& name) {
    open_.back()->names.push_back(name);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) { return false; }

  JsonValue take() { return std::move(root_); }

 private:
  JsonValue& place(JsonValue value) {
    if (open_.empty()) return root_ = std::move(value);
    return open_.back()->elements.emplace_back(std::move(value));
  }
  bool add(JsonValue value) {
    place(std::move(value));
    return true;
  }
  bool open(JsonValue value) {
    constexpr std::size_t most_depth = 8;  // of a table with arrays in its cells, and more
    if (open_.size() == most_depth) return false;
    open_.push_back(&place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  JsonValue root_;
  std::vector<JsonValue*> open_;  ///< arrays and objects around the next value
};

/// Rows of cells with the names of their columns.
struct TableRows {
  std::vector<std::string> names;
  std::vector<std::string> index = {};  ///< of each row, as JSON; empty: none
  std::vector<std::vector<std::string>> rows = {};
};

std::vector<std::string> texts_of(const JsonValue& array) {
  std::vector<std::string> all;
  for (const JsonValue& value : array.elements) all.push_back(value.json());
  return all;
}

std::string json_string(const std::string& text) { return nlohmann::json(text).dump(); }

/// The names of columns of which none is given, as of text without a header.
std::vector<std::string> usual_names(std::size_t columns) {
  std::vector<std::string> names{json_string("t")};
  for (std::size_t i = 1; i < columns; ++i) {
    names.push_back(columns <= 4 ? json_string(std::string(1, "xyz"[i - 1])) : json_string(fmt::format("p{}", i)));
  }
  return names;
}

TableRows table_of_rows(const JsonValue& rows, std::vector<std::string> names) {
  TableRows table{std::move(names)};
  if (table.names.empty() && !rows.elements.empty()) table.names = usual_names(rows.elements[0].elements.size());
  for (const JsonValue& row : rows.elements) {
    table.rows.push_back(texts_of(row));
    if (table.rows.back().size() != table.names.size()) {
      throw json::row_of_other_size(table.rows.size() - 1, table.rows.back().size(), table.names.size());
    }
  }
  return table;
}

TableRows split_table(const JsonValue& text) {
  const JsonValue *const columns = text.member("columns"), *const data = text.member("data"),
                         *index = text.member("index");
  if (columns == nullptr || data == nullptr) throw json::table_incomplete();
  TableRows table = table_of_rows(*data, texts_of(*columns));
  if (index != nullptr) table.index = texts_of(*index);
  return table;
}

/// The objects of "data", without the index that counts them.
TableRows schema_table(const JsonValue& text) {
  const JsonValue* const data = text.member("data");
  if (data == nullptr) throw json::table_incomplete();
  TableRows table;
  for (const JsonValue& row : data->elements) {
    if (table.names.empty()) std::ranges::transform(row.names, std::back_inserter(table.names), json_string);
    if (row.elements.size() != table.names.size()) {
      throw json::row_of_other_size(table.rows.size(), row.elements.size(), table.names.size());
    }
    table.rows.push_back(texts_of(row));
  }
  if (table.names.empty() || table.names[0] != json_string("index")) return table;
  table.names.erase(table.names.begin());
  for (auto& row : table.rows) {
    table.index.push_back(std::move(row.front()));
    row.erase(row.begin());
  }
  return table;
}

/// The members of objects: those of each column by the index of the row, or the other way round.
TableRows table_of_objects(const JsonValue& text, bool by_column) {
  TableRows table;
  std::map<std::string, std::size_t, std::less<>> rows, columns;
  const auto number_in = [](auto& numbers, const std::string& name) {
    return numbers.emplace(name, numbers.size()).first->second;
  };
  const auto set = [&](const std::string& row, const std::string& column, const JsonValue& value) {
    const std::size_t r = number_in(rows, row), c = number_in(columns, column);
    if (c == table.names.size()) table.names.push_back(json_string(column));
    if (r == table.rows.size()) {
      table.rows.emplace_back();
      table.index.push_back(parse_number(row) ? row : json_string(row));
    }
    table.rows[r].resize(std::max(c + 1, table.rows[r].size()), "null");
    table.rows[r][c] = value.json();
  };
  for (std::size_t i = 0; i < text.names.size(); ++i) {
    const JsonValue& members = text.elements[i];
    for (std::size_t j = 0; j < members.names.size(); ++j) {
      set(by_column ? members.names[j] : text.names[i], by_column ? text.names[i] : members.names[j],
          members.elements[j]);
    }
  }
  for (auto& row : table.rows) row.resize(table.names.size(), "null");
  return table;
}

TableRows table_of_lists(const JsonValue& text) {
  TableRows table;
  for (std::size_t i = 0; i < text.names.size(); ++i) {
    const JsonValue& list = text.elements[i];
    table.names.push_back(json_string(text.names[i]));
    if (i == 0) table.rows.resize(list.elements.size());
    if (!list.is_array || list.elements.size() != table.rows.size()) {
      throw json::columns_differ_in_length(text.names[i], list.elements.size(), text.names[0], table.rows.size());
    }
    for (std::size_t row = 0; row < table.rows.size(); ++row) table.rows[row].push_back(list.elements[row].json());
  }
  return table;
}

TableRows table_of(TableForm form, const JsonValue& text) {
  switch (form) {
    case TableForm::rows: return table_of_rows(text, {});
    case TableForm::split: return split_table(text);
    case TableForm::table: return schema_table(text);
    case TableForm::columns: return table_of_objects(text, true);
    case TableForm::index: return table_of_objects(text, false);
    default: return table_of_lists(text);
  }
}

/// Whether the index counts the rows from 0, as it does unless it is given.
bool counts_rows(const std::vector<std::string>& index) {
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] != fmt::format("{}", i)) return false;
  }
  return true;
}

JsonTable list_of(TableRows table) {
  const bool has_time = std::ranges::any_of(
      table.names, [](std::string_view name) { return is_usual_time(name.substr(1, name.size() - 2)); });
  const bool takes_index = !has_time && !counts_rows(table.index);
  std::string list = "[";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    list += row == 0 ? "{" : ",{";
    if (takes_index) list += "\"time\":" + table.index[row] + ",";
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      list += (i == 0 ? "" : ",") + table.names[i] + ":" + table.rows[row][i];
    }
    list += "}";
  }
  return {list + "]", takes_index};
}

}  // namespace

std::optional<JsonTable> take_table(Source<std::string>& bytes) {
  constexpr std::size_t longest_beginning = std::size_t{1} << 16;
  std::string text;
  TableForm form = TableForm::unknown;
  while (form == TableForm::unknown && text.size() < longest_beginning) {
    auto more = bytes();
    if (!more) break;
    text += *more;
    form = TableBeginning(text).form();
  }
  if (form == TableForm::unknown || form == TableForm::none) {
    bytes = preceded_by(std::move(text), std::move(bytes));
    return std::nullopt;
  }
  while (const std::optional<std::string> more = bytes()) text += *more;
  ValueBuilder builder;
  if (!nlohmann::json::sax_parse(text, &builder)) {  // whose errors the reader of lists explains
    bytes = [text = std::optional(std::move(text))]() mutable { return std::exchange(text, std::nullopt); };
    return std::nullopt;
  }
  return list_of(table_of(form, builder.take()));
}

}  // namespace tcb
