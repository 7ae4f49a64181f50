// Columns: the meaning of the cells of all records of an input.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "error.hpp"
#include "schema/roles.hpp"

namespace tcb {

struct Renaming {
  std::string from, to;
};

/// The names that samples of a curve are expected to have.
struct SampleNames {
  std::string time;                      ///< of the time column, if it is not one of the usual names
  std::vector<std::string> groups = {};  ///< of the group columns, if they are there
  std::vector<std::string> labels = {};  ///< of columns to ignore
  std::size_t time_place = 0;            ///< where columns have no names: how many are before the time, without groups
  std::vector<Renaming> maps = {};       ///< of columns of the samples
  std::string_view times_only = {};      ///< nothing is read but the groups and `time`, which this option names
};

/// Which columns of records are read, and in which roles.
struct ColumnOptions {
  std::vector<RoleRequest> roles = {};
  bool timeless = false;                    ///< no column is the time, unless by its name
  bool times_only = false;                  ///< only the time is read, and the groups if they are there
  std::optional<SampleNames> samples = {};  ///< the records are samples of a curve, not keys

  bool has(Role role) const { return std::ranges::count(roles, role, &RoleRequest::role) > 0; }
  bool has(std::string_view column) const {
    return std::ranges::any_of(roles, [&](const auto& role) { return std::ranges::count(role.columns, column) > 0; });
  }
};

/// A column as options request it: by its name, or by its number from 1 if it has none, one that another column has
/// too, or one that a list would divide.
std::string requested_as(std::span<const std::string> names, std::size_t cell);
std::string requested_as(std::string_view name, std::size_t cell);

/// The columns of a table as options request them, for many of them. Requires: the names outlive it.
class ColumnRequests {
 public:
  explicit ColumnRequests(std::span<const std::string> names);
  std::string operator[](std::size_t cell) const;

 private:
  std::span<const std::string> names_;
  std::unordered_map<std::string_view, std::size_t> counts_;  ///< of each name
};

/// A value of --columns such as time=NAME, or position=NAME:NAME.
std::string requested_as(std::string_view role, std::span<const std::string> names, std::span<const std::size_t> cells);

/// Whether a column is a number in an array or an object, as q[0] and q.x are in q.
inline bool is_element_of(std::string_view outer, std::string_view column) {
  return column.size() > outer.size() && column.starts_with(outer) &&
         (column[outer.size()] == '[' || column[outer.size()] == '.');
}

/// The meaning of the cells of all records of an input.
struct Columns {
  struct Column {
    Role role = Role::ignored;
    std::size_t channel = 0;  ///< of positions and of roles in one; of groups and labels, the index among the texts of
                              ///< a key; of clocks, among these
    bool is_text = false;     ///< it has no role because it holds texts,
    bool is_empty = false;    ///< or because its first cells have no number; another one with a number is a fault
  };
  std::vector<Column> cells;             ///< one per cell of a record
  bool named = false;                    ///< the input names its columns
  std::string time = "t";                ///< name of the time column
  bool has_time_by_place = false;        ///< the first column is the time, as none has a name
  std::vector<std::string> channels;     ///< names of the position channels
  std::vector<std::string> groups;       ///< names of the group columns
  std::vector<std::string> labels;       ///< names of the columns of labels
  std::vector<std::string> ignored;      ///< names of the columns without a role
  std::string likely_time = {};          ///< the first channel as it can be requested, if it may be the time
  std::vector<std::string> doubts = {};  ///< notes: what the columns may mean besides
  std::optional<double> time_gap = {};   ///< the mean of the first gaps between times that are whole
  std::string label = {};                ///< the ignored column, as it can be requested, that may be one of labels

  bool has(Role role) const;
  /// The cells that make the time of a record, in this order.
  std::vector<std::size_t> time_cells() const;
  /// The names of the roles that shape a curve, such as tension and tension_x, and that a column has.
  std::vector<std::string> shape_roles() const;
  std::size_t texts() const { return groups.size() + labels.size(); }  ///< of each key
  /// The name of a column that has a role.
  std::string name_of(const Column& column) const;
};

/// The columns of records. `header` is empty where the input has no names; numeric[i]: column i holds numbers.
/// Without a header the first column is the time, unless `timeless`. Where no column has a name such as "time", one
/// with another usual name of times is it.
/// Throws: Error (data) for a column that does not exist, that has two roles, or whose role another column has.
Columns find_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                     std::span<const RoleRequest> requests, bool timeless = false);

/// The column of times of records that are found as those of keys, and the groups that are requested, if all are there.
/// Throws: Error (data) where no column, or another one, may be the time.
Columns find_time_column(std::span<const std::string> header, const std::vector<bool>& numeric,
                         std::span<const RoleRequest> requests);

/// The columns that are requested, without any other. Throws: Error (data) as find_columns.
Columns requested_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                          std::span<const RoleRequest> requests);

/// A column of times in words.
struct TimesInWords {
  std::size_t cell;
  bool are_dates;
};

/// The only cell of a record with a date, or else with another time in words; nothing where there are several.
std::optional<TimesInWords> only_times_in_words(std::span<const std::string_view> record);

// Notes about such columns, `shown` as messages show them.
std::string times_in_words_are_taken(const TimesInWords& times, std::string_view shown);
std::string only_time_is_taken(std::string_view shown);

// Errors about names of columns. `columns`: the names that exist.
Error same_column_names(std::string_view name);
Error no_such_column(std::string_view name, std::span<const std::string> columns);
Error no_such_column_number(std::string_view number, std::size_t column_count);
Error two_columns_for_role(std::string_view role, std::string_view second_column);

/// Names for channels without any: x, y, z, or p1, p2, … for more than three.
std::vector<std::string> default_channel_names(std::size_t channels);

/// The columns of samples: the time, the groups, and every other column of numbers as a channel, whatever its name.
/// Throws: Error (data) as find_columns.
Columns find_sample_columns(std::span<const std::string> given, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless);

}  // namespace tcb
