// Columns: the meaning of the cells of all records of an input.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "schema/roles.hpp"
#include "tcb/spline/rotation_notation.hpp"

namespace tcb {

/// A column without a role, whose cells may distinguish curves.
struct Mark {
  std::string column;    ///< as it can be requested
  bool is_text = false;  ///< it holds texts
};

/// The largest number of columns without a role that are compared.
inline constexpr std::size_t most_marks = 4;

/// The meaning of the cells of all records of an input.
struct Columns {
  struct Column {
    Role role = Role::ignored;
    std::size_t channel = 0;  ///< of positions and of roles in one; of groups and labels, the index among the texts of
                              ///< a key; of others, among the marks
    bool is_text = false;     ///< it has no role because it holds texts
  };
  std::vector<Column> cells;          ///< one per cell of a record
  bool named = false;                 ///< the input names its columns
  std::string time = "t";             ///< name of the time column
  std::vector<std::string> channels;  ///< names of the position channels
  std::vector<std::string> groups;    ///< names of the group columns
  std::vector<std::string> labels;    ///< names of the columns of labels
  std::vector<std::string> ignored;   ///< names of the columns without a role
  std::vector<Mark> marks;            ///< the first ignored columns
  bool may_be_timed = false;          ///< the first channel may be the time, by its place and its name
  std::optional<spline::RotationForm> likely_rotation = {};  ///< that columns without names may be by their numbers
  bool are_segments = false;  ///< each record is a segment: start, duration, positions and velocities of its ends

  bool has(Role role) const;
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

/// The columns that are requested, without any other. Throws: Error (data) as find_columns.
Columns requested_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                          std::span<const RoleRequest> requests);

/// Another name for a column.
struct Renaming {
  std::string from, to;
};

/// Names for channels without any: x, y, z, or p1, p2, … for more than three.
std::vector<std::string> default_channel_names(std::size_t channels);

}  // namespace tcb
