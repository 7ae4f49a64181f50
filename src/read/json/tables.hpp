// Tables in JSON: the lists of records in a text of any shape, however these are laid out.
//
// Source: pandas, DataFrame.to_json() with orient "split", "table", "columns" and "index"; and a list for each column,
// as DataFrame.to_dict("list") has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read/json/columns.hpp"
#include "read/json/splitter.hpp"
#include "read/json/tape.hpp"

namespace tcb {

/// A text that is read whole.
struct WholeJson {
  explicit WholeJson(JsonPart whole, std::uint64_t max_memory = default_max_memory)
      : part(std::move(whole)), tape(part, max_memory) {}
  JsonPart part;
  JsonTape tape;
};

/// A list of records: objects, rows that are arrays, or columns. Cells that no record has take no memory.
class JsonTable {
 public:
  /// The table that a value is by its layout; nothing for other values. `is_root`: it is the whole text, so names of
  /// pandas count. Throws: Error (data) for a table whose rows, columns or index differ in length.
  static std::optional<JsonTable> find(std::shared_ptr<const WholeJson> text, std::size_t value, std::string path,
                                       bool is_root, bool is_timeless);

  const JsonTape& tape() const { return text_->tape; }
  /// As in "trajectory.points"; empty for the whole text.
  const std::string& path() const { return path_; }
  /// The value that the table is.
  std::size_t value() const { return value_; }
  std::size_t size() const { return size_; }
  bool has_times_in_index() const { return takes_index_; }
  /// It is an array of objects.
  bool is_list() const { return layout_ == Layout::objects && index_.empty(); }

  /// The cells of a row, with the time from the index; of the first one, also those that only other rows have.
  JsonCells cells(std::size_t row) const;
  /// Where a row begins, on the tape.
  std::size_t place(std::size_t row) const;

  FirstRecords first_records() const;

 private:
  enum class Layout {
    objects,  ///< [{"t":0,"x":1},…]
    rows,     ///< [[0,1],…]
    lists,    ///< {"t":[0,1],"x":[1,2]}
    columns,  ///< {"t":{"0":0,"1":1},"x":{"0":1,"1":2}}
  };
  struct Cell {
    std::uint32_t row, column, value;
  };

  JsonTable(std::shared_ptr<const WholeJson> text, std::size_t value, std::string path, bool is_timeless)
      : text_(std::move(text)), path_(std::move(path)), value_(value), is_timeless_(is_timeless) {}

  bool find_layout(bool is_root);
  bool is_array_of(std::size_t value, JsonNode::Kind kind) const;
  void read_rows(std::size_t rows);
  void read_split();
  void read_schema();
  void read_lists();
  void read_index();
  void read_columns();
  void decide_index();

  std::shared_ptr<const WholeJson> text_;
  std::string path_;
  std::size_t value_ = 0;
  bool is_timeless_ = false;
  std::size_t size_ = 0;
  Layout layout_ = Layout::objects;
  bool takes_index_ = false;                       ///< the index is the time
  bool has_index_member_ = false;                  ///< the index is the member "index" of rows
  std::vector<std::string> names_;                 ///< of columns; of objects, those that the first one does not have
  std::vector<std::uint32_t> rows_;                ///< objects, or arrays
  std::vector<std::uint32_t> index_;               ///< a name or a value for each row; empty: none
  std::vector<std::vector<std::uint32_t>> lists_;  ///< the values of each column
  std::vector<Cell> cells_;                        ///< in the order of rows
  std::vector<std::uint32_t> row_begins_;          ///< among the cells; and the end
};

/// The lists of records in a text that can be keys: those at the path that is requested, or all where none is. An
/// asterisk in a path stands for any name or number. Throws: Error (data).
std::vector<JsonTable> find_tables(const std::shared_ptr<const WholeJson>& text, const InputOptions& options);

/// The names of columns of which none is given, as of text without a header.
std::vector<std::string> usual_names(std::size_t columns, bool is_timeless);

/// Throws: Error (data) for a file of another product, by its members.
void refuse_other_json(const JsonTape& tape);

/// Whether a value holds a list of records.
bool holds_table(const JsonTape& tape, std::size_t value);

}  // namespace tcb
