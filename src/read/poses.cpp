// Poses: options by which lines of poses are read as delimited text.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read/csv/csv_reader.hpp"
#include "read/csv/splitter.hpp"
#include "read/input_format.hpp"
#include "schema/pose_formats.hpp"

namespace tcb {
namespace {

/// The first line that is neither blank nor a comment; as much of it as there is, up to the longest record.
std::string first_record(Source<std::string>& bytes) {
  std::string text, line;
  for (std::size_t begin = 0, searched = 0;;) {
    const std::size_t end = text.find('\n', searched);
    const bool is_complete = end != std::string::npos;
    if (is_complete) {
      line = text.substr(begin, end - begin);
      const std::size_t at = line.find_first_not_of(" \t\r");
      if (at != std::string::npos && line[at] != '#') break;
      begin = searched = end + 1;
      continue;
    }
    searched = text.size();
    std::optional<std::string> more = text.size() <= longest_record ? bytes() : std::nullopt;
    if (!more) {
      line = text.substr(begin);
      break;
    }
    text += *more;
  }
  bytes = preceded_by(std::move(text), std::move(bytes));
  return line;
}

std::size_t columns_in(std::string_view record, char delimiter) {
  if (delimiter != ' ') return static_cast<std::size_t>(std::ranges::count(record, delimiter)) + 1;
  std::size_t columns = 0;
  for (bool blank = true; const char c : record) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r';
    columns += blank && !is_blank ? 1 : 0;
    blank = is_blank;
  }
  return columns;
}

/// The options with the columns of a format of poses, its rotation and its unit of times, unless others are requested.
InputOptions options_of_poses(const Format& format, Source<std::string>& bytes, InputOptions options) {
  const PoseFormat& poses = *format.poses;
  const char delimiter = format.delimiter;
  std::vector<std::string> names(poses.columns.begin(), poses.columns.end());
  const std::size_t columns = columns_in(first_record(bytes), delimiter);
  const std::size_t more = columns > names.size() ? std::min(columns - names.size(), poses.others.size()) : 0;
  std::vector<RoleRequest>& roles = options.columns.roles;
  RoleRequest unused{Role::unused, {}};
  for (const std::string_view name : poses.others.first(more)) {
    names.emplace_back(name);
    const auto is_requested = [&](const RoleRequest& role) { return std::ranges::count(role.columns, name) > 0; };
    if (std::ranges::none_of(roles, is_requested)) unused.columns.emplace_back(name);
  }
  if (!unused.columns.empty()) roles.push_back(std::move(unused));
  options.delimited.head = fmt::format("{}", fmt::join(names, std::string(1, delimiter)));
  options.delimited.delimiter = delimiter;
  options.delimited.header = true;
  if (poses.form == spline::RotationForm::matrix && options.rotation.requests.empty() && !options.rotation.none) {
    options.rotation.requests.push_back(rotation_of(poses));
  }
  if (poses.unit && !options.units.time && !options.units.frame_rate) options.units.time = poses.unit;
  if (!poses.unit) options.columns.timeless = true;
  return options;
}

}  // namespace

extern const InputFormat poses_input{.open = open_lines, .options = options_of_poses, .has_own_columns = true};

}  // namespace tcb
