// Tables in JSON: lists of records, however these are laid out, and where they are in a text of any shape.
//
// Source: pandas, DataFrame.to_json() with orient "split", "table", "columns" and "index"; and a list for each column,
// as DataFrame.to_dict("list") has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/input_options.hpp"
#include "read/json/splitter.hpp"
#include "read/json/tape.hpp"

namespace tcb {

/// A member of a key, or a cell of a row.
struct JsonCell {
  static constexpr std::size_t missing = static_cast<std::size_t>(-1);
  std::string_view name;
  std::size_t value = missing;  ///< on the tape
  std::size_t place = missing;  ///< the name on the tape, or the value
};
using JsonCells = std::vector<JsonCell>;

/// A row has another number of cells than there are columns.
Error row_of_other_size(std::size_t row, std::size_t cells, std::size_t columns);

/// A list of records, which are objects, rows that are arrays, or cells of columns. Cells that no record has take no
/// memory. Requires: the tape outlives it.
class JsonTable {
 public:
  /// Values on a tape, in the list at `path` from number `first` on; rows have the names of their columns.
  JsonTable(const JsonTape& tape, std::vector<std::uint32_t> values, std::vector<std::string> columns, std::string path,
            std::size_t first);

  /// The table that a value is by its layout; nothing for other values. `is_root`: it is the whole text, so names of
  /// pandas count. Throws: Error (data) for a table whose rows, columns or index differ in length.
  static std::optional<JsonTable> find(const JsonTape& tape, std::size_t value, std::string path, bool is_root,
                                       bool is_timeless);

  /// Arrays as long as the only one of times, in other objects than it or within an array: a column each. Nothing where
  /// there are none.
  static std::optional<JsonTable> of_arrays(const JsonTape& tape);

  const JsonTape& tape() const { return *tape_; }
  /// As in "trajectory.points"; empty for the whole text.
  const std::string& path() const { return path_; }
  std::size_t first() const { return first_; }  ///< the number of the first record
  std::size_t size() const { return size_; }
  bool has_times_in_index() const { return takes_index_; }
  bool joins_arrays() const { return joins_arrays_; }  ///< its columns are in several objects
  bool has_names() const { return has_names_; }        ///< the text names its columns
  /// Arrays of other lengths than those of its columns.
  const std::vector<std::string>& others() const { return others_; }
  /// The value on the tape that is the table.
  std::size_t value() const { return value_; }
  /// Its members beside the columns may be settings.
  bool is_beside_settings() const { return is_beside_settings_; }
  /// Of columns; for objects, those that the first one does not have.
  const std::vector<std::string>& names() const { return names_; }

  /// The number of cells of a record that is a row; 0 of others.
  std::size_t columns() const { return are_rows_ ? names_.size() : 0; }
  /// Where a record begins, on the tape.
  std::size_t place(std::size_t row) const { return cells_.empty() ? rows_[row] : cells_[row].front().value; }
  /// Whether the value in the place of a record is one.
  bool is_record(std::size_t row) const {
    return !cells_.empty() || tape_->kind(rows_[row]) == (are_rows_ ? JsonNode::Kind::array : JsonNode::Kind::object);
  }
  /// The path of the first record, as in "keys[0]".
  std::string first_path() const;

  /// Sets `cells` to those of a record, with the time from the index.
  void get_cells(std::size_t row, JsonCells& cells) const;
  /// The cells of the first record, and without a value those that only others have.
  JsonCells first_cells() const;

 private:
  bool find_layout(std::size_t table, bool is_root, bool is_timeless);
  void read_rows();
  void read_lists_inside(std::size_t object);
  void add_columns(std::string_view name, std::size_t values);
  void read_split(std::size_t table, std::size_t rows);
  void read_schema(std::size_t table);
  void read_lists(std::size_t table);
  void read_index(std::size_t table);
  void read_columns(std::size_t table);
  void decide_index();

  const JsonTape* tape_;
  std::string path_;
  std::size_t first_ = 0, size_ = 0;
  bool are_rows_ = false, has_names_ = true;
  bool joins_arrays_ = false;      ///< as of_arrays() finds them
  bool takes_index_ = false;       ///< the index is the time
  bool has_index_member_ = false;  ///< the index is the member "index" of objects
  bool is_beside_settings_ = false;
  std::size_t value_ = 0;
  std::vector<std::string> others_;
  std::vector<std::string> names_;                      ///< as in names()
  std::vector<std::uint32_t> rows_;                     ///< objects, or arrays
  std::vector<std::uint32_t> index_;                    ///< a name or a value for each record; empty: none
  std::shared_ptr<std::deque<std::string>> own_names_;  ///< of cells, where the text has none for each
  std::vector<JsonCells> cells_;                        ///< of each record of a table of columns; empty: it has rows
};

/// The lists of records in a text that can be keys: those at the path that is requested, or all where none is. An
/// asterisk in a path stands for any name or number. Throws: Error (data).
std::vector<JsonTable> find_tables(const JsonTape& tape, const InputOptions& options);

/// The names of columns of which none is given, as of text without a header.
std::vector<std::string> usual_names(std::size_t columns, bool is_timeless);

/// Throws: Error (data) for a file of another product, by its members, unless columns are requested. `list`: the path
/// of a list in it, or empty.
void refuse_other_json(const JsonTape& tape, const ColumnOptions& requested, std::string_view list);

/// Whether a value holds a list of records.
bool holds_table(const JsonTape& tape, std::size_t value);

/// Whether a value is a number, also in quotes.
bool is_number(const JsonTape& tape, std::size_t value);

}  // namespace tcb
