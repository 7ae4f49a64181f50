// Columns: which cell of a record is time, position, tension, continuity, bias, or a text that goes with the key.
#include "input/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_set>

#include "error.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Names in a message, which a hundred thousand of them would not make clearer.
std::string listed(std::span<const std::string> names) {
  constexpr std::size_t most = 20;
  const auto first = names.first(std::min(names.size(), most));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     names.size() > most ? fmt::format(" and {} more", names.size() - most) : "");
}

[[noreturn]] void refuse_same_names(const std::string& name) {
  throw Error(Exit::data, fmt::format("two columns are called \"{}\"; expected different names; rename one, or choose "
                                      "by number with --columns",
                                      name));
}

/// The cell that a name or number asks for.
std::size_t find_cell(const std::string& wanted, std::string_view option, std::span<const std::string> header,
                      std::size_t cells) {
  if (std::ranges::count(header, wanted) > 1) refuse_same_names(wanted);
  const auto exact = std::ranges::find(header, wanted);
  if (exact != header.end()) return static_cast<std::size_t>(exact - header.begin());
  const auto close = std::ranges::find_if(header, [&](const auto& name) { return same_in_any_case(name, wanted); });
  if (close != header.end()) return static_cast<std::size_t>(close - header.begin());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = error == std::errc() && end == wanted.data() + wanted.size();
  if (is_number && number >= 1 && number <= cells) return number - 1;
  throw Error(
      Exit::data,
      header.empty()
          ? fmt::format("no column {}; there are {}, without names; give numbers from 1 to {}", wanted, cells, cells)
          : fmt::format("no column \"{}\"; the columns are {}; correct {}", wanted, listed(header), option));
}

/// Sets the role of a cell, which must not have another.
void assign(Columns& columns, std::size_t cell, Role role, const std::string& name) {
  if (columns.cells[cell].role != Role::left_out) {
    throw Error(Exit::data, fmt::format("column \"{}\" has two roles; expected one; correct --columns", name));
  }
  std::vector<std::string>* const several = role == Role::position ? &columns.channels
                                            : role == Role::group  ? &columns.groups
                                            : role == Role::carry  ? &columns.carried
                                                                   : nullptr;
  if (several == nullptr && columns.has(role)) {
    throw Error(Exit::data, fmt::format("two columns could be the {} column, the second is \"{}\"; expected one; "
                                        "choose with --columns",
                                        role_name(role), name));
  }
  columns.cells[cell] = {role, several == nullptr ? 0 : several->size()};
  if (several != nullptr) several->push_back(name);
  if (role == Role::time) columns.time = name;
}

/// The texts of a key are what groups it, then its labels.
void number_texts(Columns& columns) {
  for (Columns::Column& column : columns.cells) {
    if (column.role == Role::carry) column.channel += columns.groups.size();
  }
}

/// Roles by name, or without a header time first; positions only where none were asked for.
void assign_the_rest(Columns& columns, std::span<const std::string> header, const std::vector<bool>& numeric,
                     bool timeless) {
  const bool positions_given = columns.has(Role::position);
  const auto asked = columns.cells;
  std::array<bool, role_count> is_asked{};
  for (const Columns::Column& column : asked) is_asked[static_cast<std::size_t>(column.role)] = true;
  const auto is_text = [](const auto& column) { return column.role == Role::group || column.role == Role::carry; };
  const auto front = static_cast<std::size_t>(std::ranges::find_if_not(asked, is_text) - asked.begin());
  std::unordered_set<std::string_view> names;
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    if (asked[cell].role != Role::left_out) continue;
    const bool first = cell == front && !timeless && !columns.has(Role::time);
    const Role role = !header.empty() ? role_of_name(header[cell]) : first ? Role::time : Role::position;
    const bool asked_for = is_asked[static_cast<std::size_t>(role)];
    if (role == Role::position ? positions_given || !numeric[cell] : asked_for) continue;
    if (role == Role::position && !header.empty() && !names.insert(header[cell]).second) {
      refuse_same_names(header[cell]);
    }
    assign(columns, cell, role, header.empty() ? fmt::format("{}", cell + 1) : header[cell]);
  }
}

}  // namespace

bool Columns::has(Role role) const {
  return std::ranges::any_of(cells, [&](const Column& column) { return column.role == role; });
}

std::vector<Role> Columns::shape_roles() const {
  std::vector<Role> roles;
  for (const Role role : {Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out}) {
    if (has(role)) roles.push_back(role);
  }
  return roles;
}

std::vector<RoleRequest> parse_roles(std::string_view text) {
  std::vector<RoleRequest> requests;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view name = part.substr(0, equals);
    const std::optional<Role> known = find_role(name);
    if (equals == std::string::npos || equals + 1 == part.size() || !known) {
      throw Error(Exit::usage,
                  fmt::format("--columns: \"{}\" is no role with its columns; expected "
                              "time=NAME, position=NAME:NAME…, tension=, continuity=, bias=, ease_in=, "
                              "ease_out=, group= or carry=; for example --columns time=frame,position=px:py",
                              part));
    }
    const auto columns = split(part.substr(equals + 1), ':');
    requests.push_back({*known, {columns.begin(), columns.end()}});
  }
  return requests;
}

Columns find_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                     std::span<const RoleRequest> requests, bool timeless) {
  Columns columns;
  columns.cells.resize(numeric.size());
  columns.named = !header.empty();
  for (const RoleRequest& request : requests) {
    for (const std::string& name : request.columns) {
      const std::size_t cell = find_cell(name, request.option, header, numeric.size());
      const bool is_text = request.role == Role::group || request.role == Role::carry;
      assign(columns, cell, request.role,
             !header.empty() ? header[cell] : fmt::format("{}{}", is_text ? "column" : "", cell + 1));
    }
  }
  assign_the_rest(columns, header, numeric, timeless);
  number_texts(columns);
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (columns.cells[cell].role == Role::left_out) columns.left_out.push_back(header[cell]);
  }
  if (columns.channels.empty()) {
    throw Error(Exit::data,
                "no position column; expected at least one column of numbers beside the time; "
                "name it with --columns position=NAME");
  }
  if (header.empty()) {
    columns.time = "t";
    columns.channels = default_channel_names(columns.channels.size());
  }
  return columns;
}

Columns find_sample_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless) {
  const auto place = [&](const auto& is_it) { return std::ranges::find_if(header, is_it) - header.begin(); };
  std::vector<RoleRequest> requests;
  std::vector<std::ptrdiff_t> taken;
  const auto request = [&](Role role, std::ptrdiff_t cell) {
    taken.push_back(cell);
    requests.push_back({role, {fmt::format("{}", cell + 1)}});
  };
  const auto cells = static_cast<std::ptrdiff_t>(numeric.size());
  std::vector<std::ptrdiff_t> groups;
  for (const std::string& name : names.groups) {
    groups.push_back(header.empty() ? std::ssize(groups) : place([&](const auto& other) { return other == name; }));
  }
  if (std::ranges::all_of(groups, [&](std::ptrdiff_t cell) { return cell < cells; })) {
    for (const std::ptrdiff_t cell : groups) request(Role::group, cell);
  }
  if (header.empty()) return find_columns(header, numeric, requests, timeless);
  std::ptrdiff_t time = place([&](const auto& name) { return name == names.time; });
  if (time == cells) time = place([](const auto& name) { return role_of_name(name) == Role::time; });
  if (time < cells) request(Role::time, time);
  for (std::ptrdiff_t cell = 0; cell < cells; ++cell) {
    const auto at = static_cast<std::size_t>(cell);
    const bool is_label = std::ranges::count(names.labels, header[at]) > 0;
    if (numeric[at] && !is_label && std::ranges::count(taken, cell) == 0) request(Role::position, cell);
  }
  return find_columns(header, numeric, requests, true);
}

std::optional<std::string> slip(const std::string& name, const Columns& columns, std::span<const RoleRequest> requests,
                                bool timeless) {
  const std::optional<Role> meant = role_missed(name);
  if (!meant || columns.has(*meant) || (timeless && *meant == Role::time)) return std::nullopt;
  if (std::ranges::count(requests, Role::position, &RoleRequest::role) > 0) return std::nullopt;
  return fmt::format(
      "nearly \"{0}\", but a channel by its name; expected {0}, or another name; rename it, or give "
      "--columns {0}={1} or position=NAME:NAME",
      role_name(*meant), name);
}

void require_no_slip(std::span<const std::string> header, const Columns& columns, std::span<const RoleRequest> requests,
                     bool timeless) {
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (columns.cells[cell].role != Role::position) continue;
    const auto what = slip(header[cell], columns, requests, timeless);
    if (what) throw Error(Exit::data, fmt::format("column \"{}\" is {}", header[cell], *what));
  }
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

}  // namespace tcb
