// Cells of JSON: the records of a table as rows of named cells, as delimited text has them.
//
// A value deeper in a record is a cell whose name is its path, as pose.x and values[0]. Then the cells of arrays and
// objects that have a meaning get the names that a header would have: those of positions are called as channels, those
// of "tcb" tension, continuity and bias.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "read/input_options.hpp"
#include "read/json/tables.hpp"
#include "read/json/text.hpp"
#include "read/settings.hpp"

namespace tcb {

/// A cell of each record, as the first records have it.
struct JsonColumn {
  std::string path;               ///< as in pose.x
  std::string name;               ///< in the header
  std::string stem = {};          ///< the path without its last step; empty for members of records
  std::size_t depth = 0;          ///< the number of steps behind the first one
  std::uint32_t value = 0;        ///< its first value
  std::size_t row = 0, rows = 0;  ///< the first record with it, and how many of the first records have it
  bool has_number = false, has_text = false;
  bool is_parameter = false, may_be_parameter = false;  ///< tension, continuity or bias by its name
  bool is_used = false, is_requested = false;           ///< it is part of the table
  std::size_t target = 0;  ///< the column that has its cells: itself, or another one of this name

  std::string_view last_step() const { return std::string_view(path).substr(stem.size()); }
  bool is_in_array() const { return path.ends_with(']'); }
};

/// The paths of cells as a tree of steps.
class JsonPaths {
 public:
  static constexpr std::uint32_t of_member = static_cast<std::uint32_t>(-1);
  struct Step {
    std::uint32_t parent = 0;          ///< 0: the record
    std::uint32_t number = of_member;  ///< of an element
    std::string_view name = {};        ///< of a member
    auto operator<=>(const Step&) const = default;
  };
  static constexpr std::size_t no_column = static_cast<std::size_t>(-1);

  /// The number of a step, from 1; 0 if it is not known.
  std::uint32_t find(const Step& step) const {
    const auto found = ids_.find(step);
    return found == ids_.end() ? 0 : found->second;
  }
  std::uint32_t find_member(std::string_view name) const { return find({0, of_member, name}); }
  std::uint32_t add(const Step& step);
  const Step& step(std::uint32_t id) const { return nodes_[id].step; }
  std::size_t size() const { return nodes_.size(); }
  std::size_t column(std::uint32_t id) const { return nodes_[id].column; }
  void set_column(std::uint32_t id, std::size_t column) { nodes_[id].column = column; }
  std::uint32_t elements(std::uint32_t id) const { return nodes_[id].elements; }  ///< of an array; 0 for others
  void set_elements(std::uint32_t id, std::uint32_t count) { nodes_[id].elements = count; }
  void set_elements_around(std::uint32_t id);                          ///< of the arrays that a step is in, up to it
  bool is_used(std::uint32_t id) const { return nodes_[id].is_used; }  ///< a cell that is used is there
  void set_used(std::uint32_t id);
  void set_unused(std::uint32_t id) { nodes_[id].is_used = false; }
  std::string path(std::uint32_t id) const;

 private:
  struct Node {
    Step step;
    std::size_t column = no_column;
    std::uint32_t elements = 0;
    bool is_used = false;
  };
  std::map<Step, std::uint32_t> ids_;
  std::vector<Node> nodes_{Node{{}, no_column, 0, true}};
};

/// What the cells of a table are. Requires: the text of the first records outlives it.
struct JsonLayout {
  JsonPaths paths = {};
  std::vector<JsonColumn> columns = {};
  std::vector<std::string> usual_names = {};  ///< of the cells of records that have no names
  std::vector<std::string> notes = {};
  std::vector<std::string> ignored = {};  ///< names of what is not part of the table
  std::vector<std::string> meant = {};    ///< names in the header of numbers in arrays
  std::string array = {};                 ///< the name of the only array of positions; empty: there is none
  MemoryUse memory;                       ///< of paths
};

/// The layout of a table by its first records. `settings`: those around it.
/// Throws: Error (data) for records that are none, and where it is not clear which numbers are positions.
JsonLayout find_layout(const Json& json, const JsonTable& table, const InputOptions& options,
                       const FileSettings& settings);

/// Adds tension, continuity and bias, alone and in "tcb", as any record may have them. They are the last columns.
void add_parameters(JsonLayout& layout);

/// The options in which the names of arrays and objects stand for the columns in them.
InputOptions with_columns_of_layout(InputOptions options, const JsonLayout& layout);

/// Goes through the records of a table.
class JsonRows {
 public:
  JsonRows(const Json& json, const JsonTable& table, const JsonLayout& layout)
      : json_(json), table_(table), layout_(layout) {}

  /// Sets `cells` to the values of a record, by columns; 0 where there is none. False for null, which ends a curve.
  /// Throws: Error (data).
  bool get(std::size_t row, std::vector<std::uint32_t>& cells);

  /// Finds the columns of a record, which are added where they are not known.
  void add_columns(std::size_t row, JsonLayout& layout);

 private:
  template <class F>
  void read(std::size_t row, const F& found);
  template <class F>
  void read_member(std::string_view name, std::uint32_t value, const F& found) {
    read_value({0, JsonPaths::of_member, name}, value, found);
  }
  template <class F>
  void read_value(const JsonPaths::Step& step, std::uint32_t value, const F& found);
  std::uint32_t without_type(std::uint32_t value) const;
  std::uint32_t find(const JsonPaths::Step& step);
  std::uint32_t first_value(std::size_t column) const;
  bool is_value_in_earlier_record(std::uint32_t step) const;
  void require_shape(std::uint32_t id, std::uint32_t value) const;
  Error at(std::string_view path, std::size_t value, const Error& error) const;
  void refuse_unknown(const JsonPaths::Step& step, std::uint32_t value) const;

  const Json& json_;
  const JsonTable& table_;
  const JsonLayout& layout_;
  JsonLayout* grows_ = nullptr;       ///< unknown steps are added to it
  std::size_t row_ = 0;               ///< that is read
  std::vector<std::uint32_t> after_;  ///< of each step, that which came after it in the record before
  std::uint32_t last_ = 0;            ///< the last step
};

}  // namespace tcb
