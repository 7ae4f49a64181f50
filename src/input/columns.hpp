// Columns: which cell of a record is time, position, tension, continuity, bias, or a text that goes with the key.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/roles.hpp"

namespace tcb {

/// Roles given by hand: each with the columns that have it, by name or by number from 1.
struct RoleRequest {
  Role role;
  std::vector<std::string> columns;
  std::string_view option = "--columns";  ///< which gave it
};

/// "time=frame,position=px:py:pz". Throws: Error (usage).
std::vector<RoleRequest> parse_roles(std::string_view text);

/// What the records of an input mean.
struct Columns {
  struct Column {
    Role role = Role::left_out;
    std::size_t channel = 0;  ///< for positions; for groups and labels, which text of a key
  };
  std::vector<Column> cells;          ///< one a cell of a record
  bool named = false;                 ///< the input names its columns
  std::string time = "t";             ///< name of the time column
  std::vector<std::string> channels;  ///< names of the position channels
  std::vector<std::string> groups;    ///< names of the columns that tell curves apart
  std::vector<std::string> carried;   ///< names of the columns of labels
  std::vector<std::string> left_out;  ///< names of the columns that are nothing

  bool has(Role role) const;
  /// Those of tension to ease_out that a column has.
  std::vector<Role> shape_roles() const;
  std::size_t texts() const { return groups.size() + carried.size(); }  ///< of each key
};

/// The columns of delimited records. `header` is empty where the input has none; `numeric` says of
/// each cell whether its column holds numbers. Without a header the first column is the time, unless `timeless`.
/// Throws: Error (data) for a column that is not there, that has two roles, or whose role another has.
Columns find_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                     std::span<const RoleRequest> requests, bool timeless = false);

/// What is known of the rows of samples of a curve before they are read.
struct SampleNames {
  std::string time;                      ///< of the time column, if it is not one of the usual names
  std::vector<std::string> groups = {};  ///< of the columns that tell curves apart, if they are there
  std::vector<std::string> labels = {};  ///< of columns that are passed over
};

/// The columns of samples: the time, what tells curves apart, and every other column of numbers as a channel,
/// whatever its name. Throws: Error (data) as find_columns.
Columns find_sample_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless);

/// What is said of a channel whose name is that of a role but for a slip, where no column has that role, and no
/// channels were asked for; nothing of others.
std::optional<std::string> slip(const std::string& name, const Columns& columns, std::span<const RoleRequest> requests,
                                bool timeless);

/// Throws: Error (data) for the first channel of which slip() says something.
void require_no_slip(std::span<const std::string> header, const Columns& columns, std::span<const RoleRequest> requests,
                     bool timeless);

/// Names for channels without any: x, y, z, or p1, p2, … for more than three.
std::vector<std::string> default_channel_names(std::size_t channels);

}  // namespace tcb
