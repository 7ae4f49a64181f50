// Tables in JSON: the lists of records in a text of any shape, however these are laid out.
//
// Source: pandas, DataFrame.to_json() with orient "split", "table", "columns" and "index"; InfluxDB (columns and
//   values); Firebase (records under names); three.js (values of several numbers beside their times).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "read/input_options.hpp"
#include "read/json/text.hpp"

namespace tcb {

/// A list of records, which are objects or arrays, or of the cells of columns.
struct JsonTable {
  /// An object on the way to it, with the member there, and the size of the path to the object within that of the
  /// table.
  struct Outer {
    std::uint32_t object, member, path_size;
  };

  std::size_t value = 0;                    ///< that holds it
  std::string path = {};                    ///< as in "trajectory.points"; empty for the whole text
  std::vector<Outer> around = {};           ///< from the outermost one
  bool has_times = false;                   ///< so that it is taken before others
  std::vector<std::uint32_t> members = {};  ///< of an object that is the table, which has settings beside these
  bool is_own = false;                      ///< keys or rows as the program writes them
  bool are_scattered = false;               ///< its columns are in several objects
  bool are_lists = false;                   ///< its columns are lists without names
  bool has_names = true;                    ///< the text names its columns
  std::vector<std::string> names = {};      ///< of the cells of records that are arrays, or of columns
  /// Of columns that are numbers of an array of their name, which number it is; of_member for others.
  static constexpr std::uint32_t of_member = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> elements = {};
  std::vector<std::uint32_t> records = {};               ///< objects, arrays, or null, which ends a curve
  std::uint64_t number = 0;                              ///< of the first record in its list
  std::vector<std::vector<std::uint32_t>> columns = {};  ///< in place of records; 0 for a missing value
  std::vector<std::uint32_t> index = {};                 ///< names or values of rows, the times; empty: none are
  std::vector<std::string> others = {};                  ///< names of arrays of other sizes, which are not read

  std::size_t size() const { return columns.empty() ? records.size() : columns[0].size(); }
  bool has_header() const { return has_names || !index.empty(); }  ///< at least the index has a name
  bool are_rows() const { return !has_names || (columns.empty() && !names.empty()); }
  /// Where a record begins.
  std::size_t place(std::size_t row) const {
    std::size_t column = 0;
    while (column + 1 < columns.size() && columns[column][row] == 0) ++column;
    return columns.empty() ? records[row] : columns[column][row];
  }
  /// As messages call its records.
  std::string list() const { return path.empty() ? "keys" : path; }
};

/// The tables at the path that is requested, in which * stands for any name or number; or, without one, those that are
/// likely to be keys. Requires: the text has a value. Throws: Error (usage) where there is no such value, and Error
/// (data) where several tables may be the keys.
std::vector<JsonTable> find_tables(const Json& json, const InputOptions& options);

/// Whether a record ends a curve. Others without a value, such as NaN, are faults.
bool ends_curve(const Json& json, std::size_t record);

/// The values in an array without the provenance that the program writes among them.
std::vector<std::uint32_t> records_in(const Json& json, std::size_t array);

/// The table of several values that follow one another.
JsonTable table_of_values(const Json& json, std::uint64_t max_memory);

}  // namespace tcb
