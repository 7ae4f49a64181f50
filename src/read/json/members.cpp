// Members of JSON keys: their meaning, by the names and the values in the first key.
#include "read/json/members.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "read/json/errors.hpp"
#include "read/json/first_key.hpp"
#include "schema/near_misses.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Found = FoundMember;
using Member = JsonColumns::Member;

/// Whether the name gives a member another role than position.
bool has_role(const std::string& name) { return holds_tcb(name) || role_of_name(name) != Role::position; }

/// The members that are arrays of positions: those that are requested, else "position"; and the names of its numbers.
struct Arrays {
  std::vector<std::string> members;
  std::vector<std::string> channels;

  bool rotation = false;  ///< and the members of a quaternion

  bool is_rotation(const Found& member) const { return rotation && is_of_rotation(member); }
  bool has(const Found& member) const {
    const bool is_one = member.array && !member.nested && std::ranges::count(members, member.name) > 0;
    return is_one || is_rotation(member);
  }
};

Arrays arrays_of(const std::vector<Found>& members, const InputOptions& options,
                 const std::vector<std::string>& channels) {
  Arrays arrays{{}, channels};
  for (const RoleRequest& request : options.columns.roles) {
    if (request.role != Role::position) continue;
    for (const std::string& name : request.columns) {
      const auto array = std::ranges::find_if(
          members, [&](const auto& member) { return member.array && same_in_any_case(member.name, name); });
      if (array != members.end()) arrays.members.push_back(array->name);
    }
  }
  if (arrays.members.empty()) {
    arrays.members = {"position"};
    arrays.rotation = !options.rotation.none && has_quaternion(members);
  }
  return arrays;
}

/// The names of the numbers in an array, which are those of other members in front of none.
std::vector<std::string> names_in(const Found& array, const Arrays& arrays, const std::vector<Found>& members) {
  if (arrays.is_rotation(array)) return quaternion_columns(array);
  const bool is_alone = arrays.members.size() == 1;
  if (is_alone && !arrays.channels.empty()) return arrays.channels;
  std::vector<std::string> names = default_channel_names(array.numbers);
  const auto is_member = [&](const auto& name) { return std::ranges::count(members, name, &Found::name) > 0; };
  if (array.name == "position" || (is_alone && std::ranges::none_of(names, is_member))) return names;
  for (std::string& name : names) name.insert(0, array.name + "_");
  return names;
}

/// The arrays of velocities next to an array of positions, and the ends of the names of their numbers.
struct VelocityArray {
  std::string_view name, ending;
};
constexpr std::array velocity_arrays{VelocityArray{"velocity", "_v"}, VelocityArray{"velocity_in", "_vin"},
                                     VelocityArray{"velocity_out", "_vout"}};

/// The names of the numbers in an array of velocities; empty for others, and without an array of positions.
std::vector<std::string> velocity_names(const Found& array, const Arrays& arrays, const std::vector<Found>& members) {
  const auto known = std::ranges::find(velocity_arrays, array.name, &VelocityArray::name);
  if (known == velocity_arrays.end()) return {};
  const auto positions = std::ranges::find_if(
      members, [&](const Found& member) { return arrays.has(member) && !arrays.is_rotation(member); });
  if (positions == members.end() || array.nested) return {};
  if (array.numbers != positions->numbers) {
    throw json::velocity_count(array.numbers, positions->numbers).about(array.path).at(array.position);
  }
  std::vector<std::string> names = names_in(*positions, arrays, members);
  for (std::string& name : names) name += known->ending;
  return names;
}

/// The names of a member's cells, as a table would have them.
std::vector<std::string> cell_names(const Found& member, const Arrays& arrays, const std::vector<Found>& members) {
  if (member.text) return {member.name};
  if (arrays.has(member)) return names_in(member, arrays, members);
  if (!member.array) return std::vector<std::string>(member.numbers, member.name);
  std::vector<std::string> names;
  for (const Role role : {Role::tension, Role::continuity, Role::bias}) names.emplace_back(role_name(role));
  if (member.name == "tcb") return names;
  if (!holds_tcb(member.name)) return velocity_names(member, arrays, members);
  for (std::string& name : names) name += member.name.substr(3).replace(0, 1, "_");
  return names;
}

/// The requests with the names of an array's numbers in the place of its own.
std::vector<RoleRequest> requests_of(const std::vector<Found>& members, const Arrays& arrays,
                                     const ColumnOptions& options) {
  std::vector<RoleRequest> requests = options.roles;
  for (RoleRequest& request : requests) {
    if (request.role != Role::position) continue;
    std::vector<std::string> columns;
    for (const std::string& name : request.columns) {
      const auto array =
          std::ranges::find_if(members, [&](const auto& m) { return same_in_any_case(m.name, name) && arrays.has(m); });
      const auto names = array == members.end() ? std::vector{name} : names_in(*array, arrays, members);
      columns.insert(columns.end(), names.begin(), names.end());
    }
    request.columns = std::move(columns);
  }
  return requests;
}

void require_count(std::size_t names, std::size_t numbers) {
  if (names != numbers) throw json::channel_count(names, numbers);
}

/// Tension, continuity and bias may be in any key, even if the first has none, each alone or in "tcb", unless the
/// velocities of all channels are given.
void add_optional_members(JsonColumns& columns) {
  constexpr std::array roles{std::pair{"tension", Role::tension}, std::pair{"continuity", Role::continuity},
                             std::pair{"bias", Role::bias}};
  const auto is_there = [&](std::string_view name) {
    return std::ranges::find(columns.members, name, &Member::name) != columns.members.end();
  };
  const auto& given = columns.columns.cells;
  const auto is_given = [&](std::size_t channel) {
    return std::ranges::any_of(given, [&](const auto& cell) {
      return cell.channel == channel && (cell.role == Role::velocity || cell.role == Role::velocity_in);
    });
  };
  std::size_t channel = columns.columns.are_segments ? columns.columns.channels.size() : 0;
  while (channel < columns.columns.channels.size() && is_given(channel)) ++channel;
  if (channel == columns.columns.channels.size()) return;  // no tangent depends on them
  const bool tcb = is_there("tcb");
  const std::size_t first = columns.columns.cells.size();
  for (const auto& [name, role] : roles) {
    if (tcb || !columns.columns.has(role)) columns.members.push_back({name, false, columns.columns.cells.size(), 1});
    columns.columns.cells.push_back({role, 0});
  }
  if (!tcb) columns.members.push_back({"tcb", true, first, roles.size()});
}

/// Throws: Error (data) for a member that is an array where a number was expected, or the reverse, unless its role is
/// requested.
void require_shape(const Found& member, const ColumnOptions& options) {
  const bool is_array = holds_tcb(member.name);
  if (!has_role(member.name) || (is_array == member.array && !member.text)) return;
  const auto names_it = [&](const RoleRequest& role) { return std::ranges::count(role.columns, member.name) > 0; };
  if (std::ranges::any_of(options.roles, names_it)) return;
  if (!is_array && member.numbers == 1 && !member.array) return;  // it may be null
  const Error fault = is_array ? json::tcb_array_expected() : json::single_number_expected();
  throw fault.about(member.path).at(member.position);
}

/// Throws: Error (data) for a number whose name is a near miss of a role's.
void require_no_near_miss(const Found& member, const Columns& columns, const ColumnOptions& options) {
  if (member.array || member.text || member.numbers == 0) return;
  const auto near = near_miss(member.name, columns, options.roles, options.timeless);
  if (near) throw json::nearly_role(member.name, *near).about(member.path).at(member.position);
}

bool is_required(const JsonColumns& columns, const Member& member) {
  return std::any_of(columns.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell),
                     columns.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell + member.cells),
                     [&](const auto& cell) {
                       if (columns.columns.are_segments && cell.role != Role::ignored) return true;
                       return cell.role == Role::time || cell.role == Role::position || cell.role == Role::group;
                     });
}

/// Throws: Error (data) where an array or an object is not used and may be the position, for single numbers are, or the
/// time.
void require_no_lost_arrays(const std::vector<Found>& members, const Arrays& arrays, const ColumnOptions& options) {
  const auto is_requested = [&](Role role) { return std::ranges::count(options.roles, role, &RoleRequest::role) > 0; };
  const auto is_used = [&](const Found& member) { return arrays.has(member); };
  const auto is_time = [](const Found& member) { return is_usual_time(member.name); };
  const auto is_velocity = [&](const Found& member) { return !velocity_names(member, arrays, members).empty(); };
  const bool has_position = is_requested(Role::position) || std::ranges::any_of(members, is_used);
  const bool has_time =
      options.timeless || is_requested(Role::time) || std::ranges::any_of(members, [&](const auto& m) {
        return m.numbers == 1 && !m.array && (role_of_name(m.name) == Role::time || is_time(m));
      });
  for (const Found& member : members) {
    const bool is_array = member.array && !member.nested;
    if (is_used(member) || has_role(member.name) || is_velocity(member) || !(is_array || member.deep_numbers)) continue;
    const bool is_position = !has_position && (is_array || is_usual_position(member.name));
    if (!is_position && (has_time || !is_time(member))) continue;
    const Error fault = is_array ? json::array_unused(member.name) : json::object_unused();
    throw fault.about(member.path).at(member.position);
  }
}

/// Throws: Error (data) where there is an array of positions, no time, and a number that may be it.
void require_no_lost_time(const std::vector<Found>& members, const Columns& columns) {
  for (const Found& member : members) {
    const bool is_number = !member.array && !member.text && member.numbers > 0;
    if (!is_number || std::ranges::count(columns.ignored, member.name) == 0 || is_coordinate(member.name)) continue;
    throw json::no_time(member.name).at(member.position);
  }
}

/// Whether the name is that of a role in a channel of this name.
bool is_of_channel_in(const std::string& name, const std::vector<std::string>& header) {
  const auto role = channel_role_of(name);
  return role && std::ranges::any_of(header, [&](const auto& other) { return same_in_any_case(other, role->channel); });
}

/// For each cell, whether it holds a number that may have a role or be a position.
std::vector<bool> numeric_cells(const std::vector<Found>& found, const std::vector<Member>& members,
                                const std::vector<std::string>& header, const Arrays& arrays) {
  const bool has_array =
      std::ranges::any_of(found, [&](const auto& member) { return arrays.has(member) && !arrays.is_rotation(member); });
  std::vector<bool> numeric;
  for (std::size_t i = 0; i < found.size(); ++i) {
    // Where there is an array of positions, no other number is a position.
    const bool is_single = !found[i].array && !arrays.has(found[i]);
    const bool is_other = has_array && is_single && role_of_name(found[i].name) == Role::position;
    const bool is_number = !found[i].text && (!is_other || is_of_channel_in(found[i].name, header));
    numeric.resize(members[i].cell + members[i].cells, is_number);
  }
  return numeric;
}

/// What the members of the first key mean.
JsonColumns columns_of(const std::vector<Found>& members, const InputOptions& options,
                       const std::vector<std::string>& channels) {
  const ColumnOptions& requested = options.columns;
  const Arrays arrays = arrays_of(members, options, channels);
  const bool has_array = std::ranges::any_of(members, [&](const auto& member) { return arrays.has(member); });
  JsonColumns result;
  std::vector<std::string> header, unused;
  for (const auto& found : members) {
    const auto names = cell_names(found, arrays, members);
    if (arrays.has(found)) require_count(names.size(), found.numbers);
    result.members.push_back({found.name, found.array, header.size(), names.size()});
    header.insert(header.end(), names.begin(), names.end());
    if (names.empty() && !found.empty) unused.push_back(found.name);
  }
  const auto numeric = numeric_cells(members, result.members, header, arrays);
  const bool is_chosen = std::ranges::count(requested.roles, Role::position, &RoleRequest::role) > 0;
  if (!requested.samples && !options.rotation.none && !is_chosen) require_quaternion(members);
  if (!requested.samples) require_no_lost_arrays(members, arrays, requested);
  result.columns = requested.samples
                       ? find_sample_columns(header, numeric, *requested.samples, requested.timeless)
                       : find_columns(header, numeric, requests_of(members, arrays, requested), requested.timeless);
  result.columns.may_be_timed = result.columns.may_be_timed && !has_array;
  for (const auto& found : members) {
    if (requested.samples) break;  // their names may be any
    require_shape(found, requested);
    require_no_near_miss(found, result.columns, requested);
  }
  const bool lacks_time = !result.columns.has(Role::time) && !requested.timeless && !requested.samples;
  if (has_array && lacks_time) require_no_lost_time(members, result.columns);
  result.columns.ignored.insert(result.columns.ignored.end(), unused.begin(), unused.end());
  result.found = result.columns.cells.size();
  add_optional_members(result);
  for (Member& member : result.members) member.required = is_required(result, member);
  result.rules = options.keys;
  const auto is_time = [&](const Member& member) {
    return member.cells == 1 && result.columns.cells[member.cell].role == Role::time;
  };
  const auto time = std::ranges::find_if(result.members, is_time);
  const auto index = static_cast<std::size_t>(time - result.members.begin());
  result.units = units_of_keys(options.units, result.columns, index < members.size() ? members[index].value : "");
  return result;
}

}  // namespace

JsonColumns find_members(const JsonPart& part, const InputOptions& options, const std::vector<std::string>& channels) {
  const FirstKey first = read_first_key(part, options.columns.roles, options.keys.signs);
  return at_position(first.position, [&] { return columns_of(first.members, options, channels); });
}

void name_channels(JsonColumns& columns, const std::vector<std::string>& channels) {
  const auto is_array = [&](const Member& m) {
    return m.array && m.cells > 0 && columns.columns.cells[m.cell].role == Role::position;
  };
  const auto member = std::ranges::find_if(columns.members, is_array);
  if (member == columns.members.end() || channels.empty()) return;
  require_count(channels.size(), member->cells);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Columns::Column column = columns.columns.cells[member->cell + i];
    if (column.role == Role::position) columns.columns.channels[column.channel] = channels[i];
  }
}

}  // namespace tcb
