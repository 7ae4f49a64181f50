// Columns: the meaning of the cells of all records of an input.
#include "schema/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "option_names.hpp"
#include "schema/channel_columns.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error two_times(std::string_view column, std::string_view other_column, std::string_view request,
                std::string_view other_request) {
  return data_error("both {} and {} may be the time; expected one column of times; give {} {} or {} {}",
                    in_quotes(column), in_quotes(other_column), option::columns, in_shell(request), option::columns,
                    in_shell(other_request));
}

/// For each name of a header its first cell, and whether another cell has the name.
struct NamedCell {
  std::size_t cell;
  bool repeats = false;
};
using NamedCells = std::unordered_map<std::string_view, NamedCell>;

NamedCells named_cells(std::span<const std::string> header) {
  NamedCells named;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const auto [found, is_new] = named.try_emplace(header[cell], NamedCell{cell});
    found->second.repeats = !is_new;
  }
  return named;
}

/// The cell of a requested column, by name or number.
std::size_t find_cell(const std::string& wanted, std::string_view option, std::span<const std::string> header,
                      const NamedCells& named, std::size_t cells) {
  if (const auto exact = named.find(wanted); exact != named.end()) {
    if (exact->second.repeats) throw same_column_names(wanted);
    return exact->second.cell;
  }
  const auto close = std::ranges::find_if(header, [&](const auto& name) { return same_in_any_case(name, wanted); });
  if (close != header.end()) return static_cast<std::size_t>(close - header.begin());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = error == std::errc() && end == wanted.data() + wanted.size();
  if (is_number && number >= 1 && number <= cells) return number - 1;
  if (header.empty()) throw no_such_column_number(wanted, cells).about(option);
  throw no_such_column(wanted, header).about(option);
}

/// Sets the role of a cell. Throws: Error if it has another.
void assign(Columns& columns, std::size_t cell, Role role, const std::string& name) {
  if (columns.cells[cell].role != Role::ignored)
    throw data_error("column {} has two roles; expected one; correct {}", in_quotes(name), option::columns);
  std::vector<std::string>* const several = role == Role::position ? &columns.channels
                                            : role == Role::group  ? &columns.groups
                                            : role == Role::carry  ? &columns.labels
                                                                   : nullptr;
  if (several == nullptr && !is_of_channel(role) && role != Role::unused && columns.has(role)) {
    throw two_columns_for_role(role_name(role), name);
  }
  columns.cells[cell] = {role, several == nullptr ? 0 : several->size()};
  if (several != nullptr) several->push_back(name);
  if (role == Role::time) columns.time = name;
}

/// The texts of a key are those of its groups, then its labels.
void number_texts(Columns& columns) {
  for (Columns::Column& column : columns.cells) {
    if (column.role == Role::carry) column.channel += columns.groups.size();
  }
}

/// The roles that columns have by their names. T, C and B by themselves are parameters only beside the two others.
class RolesByName {
 public:
  explicit RolesByName(std::span<const std::string> header)
      : has_all_letters_(std::ranges::all_of(std::array{"T", "C", "B"}, [&](std::string_view letter) {
          return std::ranges::count(header, letter) > 0;
        })) {}

  Role operator()(std::string_view name) const {
    const Role role = role_of_name(name);
    const bool is_letter = name == "T" || name == "C" || name == "B";
    return is_letter && !has_all_letters_ ? Role::position : role;
  }

 private:
  bool has_all_letters_;
};

/// The cells of a time in two columns.
struct SplitTime {
  std::size_t seconds, nanoseconds;
  std::string stem;  ///< of their names
};

/// The times whose whole seconds and nanoseconds are columns of numbers, as in header.stamp.sec and
/// header.stamp.nanosec.
std::vector<SplitTime> split_times(std::span<const std::string> header, const std::vector<bool>& numeric) {
  std::vector<SplitTime> times;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const auto part = time_part_of(header[cell]);
    if (!part || part->part != TimePart::nanoseconds || !numeric[cell]) continue;
    const auto seconds = std::ranges::find_if(header, [&](const std::string& name) {
      const auto other = time_part_of(name);
      return other && other->part == TimePart::seconds && other->stem == part->stem;
    });
    const auto other = static_cast<std::size_t>(seconds - header.begin());
    if (other < header.size() && numeric[other]) times.push_back({other, cell, std::string(part->stem)});
  }
  return times;
}

/// Takes the time that is in two columns. Throws: Error (data) if another column may be the time as well. If a time is
/// requested, these columns are ignored, unless they have roles.
void assign_split_time(Columns& columns, std::span<const std::string> header, const std::vector<bool>& numeric,
                       bool timeless) {
  const std::vector<SplitTime> times = split_times(header, numeric);
  if (times.empty()) return;
  const auto is_part = [&](std::size_t cell) {
    return std::ranges::any_of(times, [&](const auto& t) { return t.seconds == cell || t.nanoseconds == cell; });
  };
  if (columns.has(Role::time) || timeless) {
    for (const auto& [seconds, nanoseconds, stem] : times) {
      for (const std::size_t cell : {seconds, nanoseconds}) {
        if (columns.cells[cell].role == Role::ignored) columns.cells[cell].role = Role::unused;
      }
    }
    return;
  }
  const auto request_of = [&](const SplitTime& time) {
    return fmt::format("time={},nanoseconds={}", header[time.seconds], header[time.nanoseconds]);
  };
  if (times.size() > 1) {
    throw two_times(header[times[0].seconds], header[times[1].seconds], request_of(times[0]), request_of(times[1]));
  }
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const std::string& name = header[cell];
    const bool is_usual = numeric[cell] && is_usual_time(name) && !is_usual_counter(name);
    const bool may_be_time =
        columns.cells[cell].role == Role::ignored && (is_usual || role_of_name(name) == Role::time);
    if (!may_be_time || is_part(cell)) continue;
    throw two_times(name, header[times[0].seconds], "time=" + name, request_of(times[0]));
  }
  assign(columns, times[0].seconds, Role::time, times[0].stem.empty() ? "time" : times[0].stem);
  assign(columns, times[0].nanoseconds, Role::nanoseconds, header[times[0].nanoseconds]);
}

/// For each column, whether it is the time by one of the usual names, among which those of columns of numbers come
/// first. None is where a time is requested, or a column has a name such as "time".
std::vector<bool> usual_times(const Columns& columns, std::span<const std::string> header,
                              const std::vector<bool>& numeric) {
  std::vector<bool> numbers(header.size()), texts(header.size());
  bool any_numbers = false;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const Role role = columns.cells[cell].role;
    if (role == Role::time || (role != Role::unused && role_of_name(header[cell]) == Role::time))
      return std::vector<bool>(header.size());
    texts[cell] = role == Role::ignored && is_usual_time(header[cell]);
    numbers[cell] = texts[cell] && numeric[cell];
    any_numbers = any_numbers || numbers[cell];
  }
  return any_numbers ? numbers : texts;
}

/// Whether the first channel comes first among the columns of numbers, and might be the time.
bool may_be_timed(const Columns& columns, std::span<const std::string> header) {
  if (header.empty() || columns.has(Role::time) || columns.channels.size() < 2) return false;
  const auto first = std::ranges::find_if(columns.cells, [](const auto& column) {
    return column.role != Role::ignored && column.role != Role::group && column.role != Role::carry;
  });
  return first->role == Role::position && !is_coordinate(columns.channels[0]);
}

/// Roles by name, or without a header time first; positions only where none were requested.
void assign_the_rest(Columns& columns, std::span<const std::string> header, const std::vector<bool>& numeric,
                     const std::vector<bool>& usual, bool timeless) {
  const bool positions_given = columns.has(Role::position);
  const auto requested = columns.cells;
  const RolesByName named_role(header);
  std::array<bool, role_count> is_requested{};
  for (const Columns::Column& column : requested) is_requested[static_cast<std::size_t>(column.role)] = true;
  const auto is_text = [](const auto& column) {
    return column.role == Role::group || column.role == Role::carry || column.role == Role::unused;
  };
  const auto front = static_cast<std::size_t>(std::ranges::find_if_not(requested, is_text) - requested.begin());
  std::unordered_set<std::string_view> names;
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    if (requested[cell].role != Role::ignored) continue;
    const bool first = cell == front && !timeless && !columns.has(Role::time);
    const bool is_time = header.empty() ? first : usual[cell];
    const Role role = is_time ? Role::time : header.empty() ? Role::position : named_role(header[cell]);
    const bool has_request = is_requested[static_cast<std::size_t>(role)];
    columns.cells[cell].is_text = role == Role::position && !positions_given && !numeric[cell];
    if (role == Role::position ? positions_given || !numeric[cell] : has_request) continue;
    if (role == Role::position && !header.empty() && is_usual_counter(header[cell])) continue;
    if (role == Role::position && !header.empty() && tells_curves_apart(header[cell])) {
      throw data_error(
          "column {} looks like a label, not a position; expected its role; give {} {} for "
          "one curve per value, {} {} to keep it in the rows, or {} {} to leave it out",
          in_quotes(header[cell]), option::group, in_shell(header[cell]), option::columns,
          in_shell(fmt::format("carry={}", header[cell])), option::columns,
          in_shell(fmt::format("ignore={}", header[cell])));
    }
    if (role == Role::time && columns.has(Role::time)) {
      throw two_times(columns.time, header[cell], "time=" + columns.time, "time=" + header[cell]);
    }
    if (role == Role::position && !header.empty() && !names.insert(header[cell]).second) {
      throw same_column_names(header[cell]);
    }
    assign(columns, cell, role, header.empty() ? fmt::format("{}", cell + 1) : header[cell]);
  }
}

}  // namespace

bool Columns::has(Role role) const {
  return std::ranges::any_of(cells, [&](const Column& column) { return column.role == role; });
}

std::vector<std::string> Columns::shape_roles() const {
  std::vector<std::string> roles;
  for (const Role role : {Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out}) {
    if (has(role)) roles.emplace_back(role_name(role));
  }
  if (are_segments) roles.emplace_back("duration");
  for (const Column& column : cells) {
    if (is_of_channel(column.role)) roles.push_back(name_of(column));
  }
  return roles;
}

std::string Columns::name_of(const Column& column) const {
  switch (column.role) {
    case Role::time: return time;
    case Role::position: return channels[column.channel];
    case Role::group: return groups[column.channel];
    case Role::carry: return labels[column.channel - groups.size()];
    case Role::duration: return "duration";
    default:
      if (are_segments && column.role == Role::velocity_out) return channels[column.channel] + "_v0";
      if (is_of_channel(column.role)) return role_name(ChannelRole{column.role, channels[column.channel]});
      return std::string(role_name(column.role));
  }
}

namespace {

/// The columns with the requested roles; those in one channel are also added to `of_channels`.
Columns requested_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                          std::span<const RoleRequest> requests, std::vector<ColumnOfChannel>& of_channels) {
  Columns columns;
  columns.cells.resize(numeric.size());
  columns.named = !header.empty();
  const NamedCells named = requests.empty() ? NamedCells{} : named_cells(header);
  for (const RoleRequest& request : requests) {
    for (const std::string& name : request.columns) {
      const std::size_t cell = find_cell(name, request.option, header, named, numeric.size());
      if (request.unless_taken && columns.cells[cell].role == request.role) continue;
      if (is_of_channel(request.role)) of_channels.push_back({cell, {request.role, request.channel}, name, true});
      const bool is_text = request.role == Role::group || request.role == Role::carry;
      assign(columns, cell, request.role,
             !header.empty() ? header[cell] : fmt::format("{}{}", is_text ? "column" : "", cell + 1));
    }
  }
  return columns;
}

}  // namespace

Columns find_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                     std::span<const RoleRequest> requests, bool timeless) {
  std::vector<ColumnOfChannel> of_channels;
  Columns columns = requested_columns(header, numeric, requests, of_channels);
  std::vector<bool> is_unused;  // on request
  for (const Columns::Column& column : columns.cells) is_unused.push_back(column.role == Role::unused);
  if (!assign_segments(columns, header)) {
    assign_split_time(columns, header, numeric, timeless);
    const auto usual = timeless ? std::vector<bool>(header.size()) : usual_times(columns, header, numeric);
    for (ColumnOfChannel& column : columns_of_channels(columns, header, numeric, usual)) {
      columns.cells[column.cell].role = column.role.role;
      of_channels.push_back(std::move(column));
    }
    assign_the_rest(columns, header, numeric, usual, timeless);
  }
  number_texts(columns);
  for (Columns::Column& column : columns.cells) {
    if (column.role == Role::unused) column.role = Role::ignored;
  }
  const bool positions_given = std::ranges::count(requests, Role::position, &RoleRequest::role) > 0;
  columns.may_be_timed = !timeless && !positions_given && may_be_timed(columns, header);
  if (header.empty() && !columns.channels.empty()) {
    columns.time = "t";
    columns.channels = default_channel_names(columns.channels.size());
  }
  assign_channels(columns, of_channels);
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    if (columns.cells[cell].role != Role::ignored) continue;
    columns.cells[cell].channel = is_unused[cell] ? most_marks : columns.ignored.size();
    if (is_unused[cell]) continue;
    columns.ignored.push_back(header.empty() ? fmt::format("column {}", cell + 1) : header[cell]);
    if (columns.marks.size() == most_marks) continue;
    columns.marks.push_back({header.empty() ? fmt::format("{}", cell + 1) : header[cell], !numeric[cell]});
  }
  if (columns.channels.empty()) {
    bool has_other_numbers = false;
    for (std::size_t cell = 0; cell < numeric.size(); ++cell) {
      has_other_numbers = has_other_numbers || (numeric[cell] && columns.cells[cell].role != Role::time);
    }
    const bool has_numbers = std::ranges::count(numeric, true) > 0;
    throw data_error("there is no position column; expected at least one column of numbers besides the time; {}",
                     has_other_numbers ? fmt::format("name it with {} position=NAME", option::columns)
                     : has_numbers
                         ? fmt::format("give {} uniform if the only column is a position", option::parameter)
                         : fmt::format("give a table with numbers, or its delimiter with {}", option::delimiter));
  }
  return columns;
}

Columns requested_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                          std::span<const RoleRequest> requests) {
  std::vector<ColumnOfChannel> none;
  return requested_columns(header, numeric, requests, none);
}

std::vector<std::string> default_channel_names(std::size_t channels) {
  if (channels <= 3) {
    const std::vector<std::string> names{"x", "y", "z"};
    return {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(channels)};
  }
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= channels; ++i) names.push_back(fmt::format("p{}", i));
  return names;
}

Error same_column_names(std::string_view name) {
  return data_error(
      "two columns are called {}; expected different names; rename one, or choose columns "
      "by number with {}",
      in_quotes(name), option::columns);
}

Error no_such_column(std::string_view name, std::span<const std::string> columns) {
  return data_error("there is no column {}; expected one of {}; correct the name", in_quotes(name), listed(columns));
}

Error no_such_column_number(std::string_view number, std::size_t column_count) {
  return data_error(
      "there is no column {}; the columns have no names; expected a number from 1 to {}; "
      "correct it",
      in_quotes(number), column_count);
}

Error two_columns_for_role(std::string_view role, std::string_view second_column) {
  return data_error(
      "a second column, {}, has the role {}; expected one column with it; choose one with "
      "{} {}=NAME",
      in_quotes(second_column), role, option::columns, role);
}

}  // namespace tcb
