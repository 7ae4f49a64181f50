// Columns of JSON: what the members of keys mean, by the names and the values in the first key.
#include "read/json/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <unordered_set>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "option_names.hpp"
#include "schema/doubts.hpp"
#include "schema/key_rules.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;
using Member = JsonColumns::Member;

/// A member of the first key, or a number deeper in it.
struct Found {
  std::string name;
  std::vector<std::string> route;         ///< the names of the members that lead to it; "[2]" for an element
  bool array = false;                     ///< it is an array of numbers
  bool text = false;                      ///< it is one text, or true or false
  bool nested = false;                    ///< it is an object, or an array with arrays or objects,
  bool deep_numbers = false;              ///< with numbers in them
  bool empty = true;                      ///< it is [] or {}
  std::size_t numbers = 0;                ///< the count of its numbers, also missing ones
  std::string value = "";                 ///< the text, if it is a number or a time in words
  std::string path = "";                  ///< as in "keys[0].x"
  std::size_t node = JsonCell::missing;   ///< its value
  std::size_t place = JsonCell::missing;  ///< of its name on the tape
  bool is_spread = false;                 ///< its numbers are columns of their own
  bool is_of_whole = false;               ///< all numbers around it are columns
  const JsonTape* tape = nullptr;

  Error at(const Error& error) const { return error.about(path).at(tape->position(place)); }
};

std::string how_many(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Whether a member is an array [T,C,B]: of the key, or of one channel as "tcb.x".
bool holds_tcb(std::string_view name) { return name == "tcb" || name.starts_with("tcb."); }

/// Whether the members of an object with this name are members of the key.
bool is_spread_always(std::string_view name) { return name == "tcb" || name == "rotation"; }

/// Whether the name gives a member another role than position.
bool has_role(const std::string& name) { return holds_tcb(name) || role_of_name(name) != Role::position; }

/// Whether a member is the array "rotation", or a member of an object "rotation", as "rotation.x".
bool is_of_rotation(const Found& member) {
  return member.name.starts_with("rotation.") || (member.name == "rotation" && (member.array || member.nested));
}

constexpr std::array quaternion_members{std::pair{"rotation.x", "qx"}, std::pair{"rotation.y", "qy"},
                                        std::pair{"rotation.z", "qz"}, std::pair{"rotation.w", "qw"}};

/// Whether the members of rotations are the four numbers of a quaternion: an array, or an object of x, y, z and w.
bool has_quaternion(const std::vector<Found>& members) {
  const auto is_array = [](const Found& member) {
    return member.name == "rotation" && member.array && !member.nested && member.numbers == quaternion_members.size();
  };
  const auto is_number = [&](const auto& number) {
    return std::ranges::any_of(members, [&](const Found& member) {
      return member.name == number.first && !member.array && !member.nested && member.numbers == 1;
    });
  };
  return std::ranges::any_of(members, is_array) ||
         (std::ranges::all_of(quaternion_members, is_number) &&
          std::ranges::count_if(members, is_of_rotation) == std::ssize(quaternion_members));
}

/// Throws: Error (data) for members of rotations that are something else, but for arrays of one or two numbers.
void require_quaternion(const std::vector<Found>& members) {
  const auto first = std::ranges::find_if(members, is_of_rotation);
  if (first == members.end() || has_quaternion(members)) return;
  const bool is_array = first->array && !first->nested;
  if (is_array && first->numbers < 3) return;  // too few for a rotation in any form
  const Error fault = is_array
                          ? data_error(
                                "the array has {}; expected four, x, y, z, w of a quaternion; correct it, or give {} "
                                "position=NAME:NAME for the members to take",
                                how_many(first->numbers, "number"), option::columns)
                          : data_error(
                                "\"rotation\" has members other than x, y, z and w; expected the four numbers of a "
                                "quaternion; correct them, or give {} position=NAME:NAME for the members to take",
                                option::columns);
  throw first->at(fault);
}

/// Finds what the first record holds.
class FirstRecord {
 public:
  FirstRecord(const JsonTable& records, const InputOptions& options)
      : tape_(records.tape()), records_(records), signs_(options.keys.signs) {
    for (const RoleRequest& role : options.columns.roles) {
      if (role.role == Role::position) positions_.insert(role.columns.begin(), role.columns.end());
      if (role.role == Role::group || role.role == Role::carry || role.role == Role::unused) {
        texts_.insert(role.columns.begin(), role.columns.end());
      }
    }
  }

  std::vector<Found> read() {
    for (const JsonCell& cell : records_.first_cells()) {
      const bool is_object = cell.value != JsonCell::missing && tape_.kind(cell.value) == Kind::object;
      if (!is_object || !is_spread_always(cell.name)) {
        add(std::string(cell.name), {std::string(cell.name)}, cell);
        continue;
      }
      for (const JsonCell& inner : members_of(tape_, cell.value)) {
        add(fmt::format("{}.{}", cell.name, inner.name), {std::string(cell.name), std::string(inner.name)}, inner);
      }
    }
    find_missing_numbers();
    return std::move(members_);
  }

 private:
  /// `error` at a value of a member, which may be outside of the record in a table of columns.
  Error at(const Found& member, std::size_t value, const Error& error) const {
    const std::size_t first = records_.place(0);
    const bool is_inside = first < value && value < tape_[first].next;
    return error.about(is_inside ? records_.first_path() + tape_.path(first, value) : member.path)
        .at(tape_.position(value));
  }

  void add(std::string name, std::vector<std::string> route, const JsonCell& cell) {
    Found& member = members_.emplace_back();
    member.name = std::move(name);
    member.route = std::move(route);
    member.path = fmt::format("{}.{}", records_.first_path(), member.name);
    member.node = cell.value;
    member.place = cell.place == JsonCell::missing ? records_.place(0) : cell.place;
    member.tape = &tape_;
    if (!names_.insert(member.name).second) {
      throw member.at(data_error("the key has this member twice; expected it once; remove one"));
    }
    if (cell.value == JsonCell::missing) {
      count(member, false);
    } else if (tape_.kind(cell.value) == Kind::array) {
      add_elements(member);
    } else if (tape_.kind(cell.value) == Kind::object) {
      add_nested(member, cell.value, false);
    } else {
      add_scalar(member, cell.value, false);
    }
  }

  void add_elements(Found& member) {
    tape_.for_each_element(member.node, [&](std::size_t element) {
      if (tape_[element].is_nested()) {
        add_nested(member, element, true);
      } else {
        add_scalar(member, element, true);
      }
      return true;
    });
  }

  void add_nested(Found& member, std::size_t value, bool in_array) {
    const Role role = role_of_name(member.name);
    if (!in_array && !texts_.contains(member.name) && role != Role::position && role != Role::time) {
      throw at(member, value, data_error("this is not a number; expected one; correct it"));
    }
    member.nested = true;
    member.empty = member.empty && !in_array && tape_[value].next == value + 1;
    for (std::size_t at = value + 1; at < tape_[value].next; ++at) {
      member.deep_numbers = member.deep_numbers || tape_.kind(at) == Kind::number;
    }
    note(member, false, in_array);
  }

  void add_scalar(Found& member, std::size_t value, bool in_array) {
    const Kind kind = tape_.kind(value);
    const bool is_requested_text = texts_.contains(member.name);
    if (kind == Kind::number && !in_array) member.value = tape_.written(value);
    if (kind == Kind::number || kind == Kind::null) return count(member, in_array);
    member.empty = false;
    const bool is_quoted = kind != Kind::boolean;
    const std::string_view text = is_quoted ? tape_.text(value) : tape_.written(value);
    const Role role = role_of_name(member.name);
    const bool is_sign = is_quoted && is_missing_sign(text, signs_);
    if (!in_array && is_quoted && find_notation(text)) {
      member.value = text;
      if (role == Role::time) return count(member, in_array);
    }
    const bool is_number = is_quoted && !is_sign && parse_number(text);
    if (is_number && (in_array ? positions_.contains(member.name) : !is_requested_text)) {
      if (!in_array) member.value = text;
      return count(member, in_array);
    }
    if (role != Role::position && is_sign && !in_array && !is_requested_text) return count(member, in_array);
    const bool needs_number = role != Role::position || (!is_sign && looks_numeric(text));
    if (!in_array && !is_requested_text && needs_number) {
      throw at(member, value,
               data_error("{} is not a number; expected a number; correct it, or give {} {}", in_quotes(text),
                          option::columns, in_shell("ignore=" + member.name)));
    }
    note(member, true, in_array);
  }

  /// A value that is not a number.
  void note(Found& member, bool text, bool in_array) {
    if (in_array && (member.name == "position" || holds_tcb(member.name))) {
      return count(member, in_array);  // refused later too
    }
    member.text = text && !in_array;
  }

  void count(Found& member, bool in_array) {
    member.array = in_array;
    member.empty = false;
    ++member.numbers;
  }

  /// Members that are texts in the first key may hold numbers.
  void find_missing_numbers() {
    if (std::ranges::none_of(members_, &Found::text)) return;
    constexpr std::size_t most_records = 1000;
    std::unordered_set<std::string_view> numbers, missing, texts;
    for (std::size_t record = 0; record < std::min(records_.size(), most_records); ++record) {
      records_.for_each_cell(record, [&](const JsonCell& cell) {
        const Kind kind = tape_.kind(cell.value);
        if (kind == Kind::number) numbers.insert(cell.name);
        if (kind == Kind::boolean) texts.insert(cell.name);
        if (kind != Kind::string || tape_.text(cell.value).empty()) return;
        (is_missing_sign(tape_.text(cell.value), signs_) ? missing : texts).insert(cell.name);
      });
    }
    for (Found& member : members_) {
      const bool has_numbers =
          numbers.contains(member.name) || (missing.contains(member.name) && !texts.contains(member.name));
      if (!member.text || !has_numbers) continue;
      member.text = false;
      member.numbers = 1;
    }
  }

  const JsonTape& tape_;
  const JsonTable& records_;
  const std::vector<std::string>& signs_;
  std::unordered_set<std::string> texts_;                  ///< members that are requested as texts
  std::unordered_set<std::string> positions_{"position"};  ///< those that may be arrays of positions
  std::unordered_set<std::string> names_;
  std::vector<Found> members_;
};

/// Adds the numbers, times and texts in an object or an array, whose names are their paths.
void add_inside(std::vector<Found>& members, const Found& outer) {
  const JsonTape& tape = *outer.tape;
  const auto add = [&](const std::string& name, std::string step, std::size_t value, std::size_t place) {
    Found inner{.name = outer.name + name, .route = outer.route, .node = value, .place = place, .tape = &tape};
    inner.path = outer.path + name;
    inner.route.push_back(std::move(step));
    if (tape[value].is_nested()) return add_inside(members, inner);
    const bool is_string = tape.kind(value) == Kind::string;
    inner.value = is_string ? tape.text(value) : tape.written(value);
    inner.empty = false;
    inner.text =
        tape.kind(value) == Kind::boolean ||
        (is_string && !parse_number(inner.value) &&
         !(find_notation(inner.value) && (is_usual_time(inner.name) || role_of_name(inner.name) == Role::time)));
    inner.numbers = inner.text ? 0 : 1;
    members.push_back(std::move(inner));
  };
  if (tape.kind(outer.node) == Kind::object) {
    for (const JsonCell& cell : members_of(tape, outer.node)) {
      add(fmt::format(".{}", cell.name), std::string(cell.name), cell.value, cell.place);
    }
    return;
  }
  std::size_t index = 0;
  tape.for_each_element(outer.node, [&](std::size_t element) {
    const std::string step = fmt::format("[{}]", index++);
    add(step, step, element, element);
    return true;
  });
}

bool is_number_array(const Found& member) { return member.array && !member.nested && member.numbers > 0; }

/// The arrays of velocities next to an array of positions, and the ends of the names of their numbers.
struct VelocityArray {
  std::string_view name, ending;
};
constexpr std::array velocity_arrays{VelocityArray{"velocity", "_v"}, VelocityArray{"velocity_in", "_vin"},
                                     VelocityArray{"velocity_out", "_vout"}};

/// Whether a member may be a position by its place: one number without another role.
bool is_plain_number(const Found& member) {
  return member.numbers == 1 && !member.array && !member.text && !member.nested && !has_role(member.name) &&
         !is_usual_time(member.name) && !is_usual_counter(member.name) && !time_part_of(member.name);
}

/// The members that are arrays of positions: those that are requested, else "position", else the only one; and the
/// names of its numbers.
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

/// The name of the array of positions that nothing names: the only array, or the only one with a usual name.
std::string lone_array(const std::vector<Found>& members) {
  std::vector<std::string> all, usual;
  for (const Found& member : members) {
    if (is_plain_number(member)) return "";
    const bool is_velocity = std::ranges::count(velocity_arrays, member.name, &VelocityArray::name) > 0;
    if (!is_number_array(member) || has_role(member.name) || is_of_rotation(member) || is_velocity) continue;
    all.push_back(member.name);
    std::string_view one = member.name;
    if (one.ends_with('s')) one.remove_suffix(1);
    if (is_usual_position(member.name) || is_usual_position(one)) usual.push_back(member.name);
  }
  return all.size() == 1 ? all[0] : usual.size() == 1 ? usual[0] : "";
}

Arrays arrays_of(const std::vector<Found>& members, const InputOptions& options,
                 const std::vector<std::string>& channels) {
  Arrays arrays{{}, channels};
  bool is_requested = false;
  for (const RoleRequest& request : options.columns.roles) {
    if (request.role != Role::position) continue;
    is_requested = true;
    for (const std::string& name : request.columns) {
      const auto array = std::ranges::find_if(
          members, [&](const auto& member) { return member.array && same_in_any_case(member.name, name); });
      if (array != members.end()) arrays.members.push_back(array->name);
    }
  }
  if (arrays.members.empty()) {
    const auto position = std::ranges::find(members, "position", &Found::name);
    const bool has_position = position != members.end() && position->array && !position->nested;
    const std::string lone = is_requested || has_position || options.columns.samples ? "" : lone_array(members);
    arrays.members = {lone.empty() ? "position" : lone};
    arrays.rotation = !options.rotation.none && has_quaternion(members);
  }
  return arrays;
}

/// The columns of a member of a quaternion.
std::vector<std::string> quaternion_columns(const Found& member) {
  std::vector<std::string> names;
  for (const auto& [name, column] : quaternion_members) {
    if (member.array || member.name == name) names.emplace_back(column);
  }
  return names;
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

/// The names of the numbers in an array of velocities; empty for others, and without an array of positions.
std::vector<std::string> velocity_names(const Found& array, const Arrays& arrays, const std::vector<Found>& members) {
  const auto known = std::ranges::find(velocity_arrays, array.name, &VelocityArray::name);
  if (known == velocity_arrays.end()) return {};
  const auto positions = std::ranges::find_if(
      members, [&](const Found& member) { return arrays.has(member) && !arrays.is_rotation(member); });
  if (positions == members.end() || array.nested) return {};
  if (array.numbers != positions->numbers) {
    throw array.at(data_error("the array has {}; expected {}, as in the array of positions; correct it",
                              how_many(array.numbers, "number"), positions->numbers));
  }
  std::vector<std::string> names = names_in(*positions, arrays, members);
  for (std::string& name : names) name += known->ending;
  return names;
}

/// The names of a member's cells, as a table would have them.
std::vector<std::string> cell_names(const Found& member, const Arrays& arrays, const std::vector<Found>& members) {
  if (member.is_spread) return {};
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

/// The requests with the names of cells in the place of paths, such as position[0], and of arrays.
std::vector<RoleRequest> requests_of(const std::vector<Found>& members, const Arrays& arrays,
                                     const ColumnOptions& options) {
  std::vector<RoleRequest> requests = options.roles;
  for (RoleRequest& request : requests) {
    std::vector<std::string> columns;
    for (const std::string& name : request.columns) {
      std::vector<std::string> names{name};
      for (const Found& member : members) {
        const bool is_array = arrays.has(member);
        if (is_array && request.role == Role::position && same_in_any_case(member.name, name)) {
          names = names_in(member, arrays, members);
          break;
        }
        if (is_array && name.starts_with(member.name + "[") && name.ends_with(']')) {
          const auto of_array = names_in(member, arrays, members);
          const auto index = parse_number(name.substr(member.name.size() + 1, name.size() - member.name.size() - 2));
          const bool is_element = index && *index >= 0 && *index < static_cast<double>(of_array.size());
          if (is_element) names = {of_array[static_cast<std::size_t>(*index)]};
        }
        const bool is_path = member.route.size() == 2 && name == member.route[0] + "." + member.route[1];
        if (is_path && !is_spread_always(member.route[0])) names = {member.name};
      }
      columns.insert(columns.end(), names.begin(), names.end());
    }
    request.columns = std::move(columns);
  }
  return requests;
}

/// Makes the numbers in objects members of their own: those that are requested, and, where the key has no other
/// position or no time, those that may be it.
void spread(std::vector<Found>& members, const ColumnOptions& options) {
  if (options.samples) return;
  const auto is_requested = [&](Role role) { return std::ranges::count(options.roles, role, &RoleRequest::role) > 0; };
  const auto names_it = [&](const Found& member) {
    return std::ranges::any_of(options.roles, [&](const RoleRequest& role) {
      return std::ranges::any_of(role.columns, [&](const auto& name) { return same_in_any_case(name, member.name); });
    });
  };
  const auto has_time_name = [](const Found& member) {
    return role_of_name(member.name) == Role::time || is_usual_time(member.name);
  };
  const bool lacks_position = !is_requested(Role::position) && std::ranges::none_of(members, is_plain_number) &&
                              std::ranges::none_of(members, [](const Found& member) {
                                return is_number_array(member) && !has_role(member.name);
                              });
  const bool lacks_time =
      !options.timeless && !is_requested(Role::time) && std::ranges::none_of(members, [&](const Found& member) {
        return has_time_name(member) && !member.nested && !member.array;
      });
  const bool has_position_array =
      std::ranges::any_of(members, [](const Found& member) { return member.name == "position" && member.array; });
  const bool has_position_object =
      std::ranges::any_of(members, [](const Found& member) { return member.name == "position" && member.nested; });
  if (options.roles.empty() && !lacks_position && !lacks_time && !has_position_object) return;
  const std::size_t count = members.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!members[i].nested && !members[i].array) continue;
    if (holds_tcb(members[i].name) || is_of_rotation(members[i])) continue;
    const bool is_object = members[i].nested && !members[i].array && members[i].node != JsonCell::missing;
    const bool is_position = is_object && members[i].name == "position" && !is_requested(Role::position) &&
                             !has_position_array && members[i].deep_numbers;
    std::vector<Found> inside;
    if (members[i].node != JsonCell::missing) add_inside(inside, members[i]);
    for (Found& inner : inside) {
      const bool in_array = std::ranges::any_of(inner.route, [](const auto& step) { return step.starts_with('['); });
      const bool may_be_time = has_time_name(inner) || time_part_of(inner.name);
      const bool is_taken = (!in_array && lacks_position) || is_position || (!in_array && lacks_time && may_be_time);
      if (!names_it(inner) && !is_taken) continue;
      if (is_position && inner.route.size() == 2) inner.name = inner.route[1];
      members[i].is_spread = true;
      inner.is_of_whole = is_position || (!in_array && lacks_position);
      members.push_back(std::move(inner));
    }
  }
}

Error channel_count(std::size_t names, std::size_t numbers) {
  return data_error("\"channels\" has {}; expected {}, one for each number of \"position\"; correct it",
                    how_many(names, "name"), numbers);
}

/// Tension, continuity and bias may be in any key, even if the first has none, each alone or in "tcb", unless the
/// velocities of all channels are given.
void add_optional_members(JsonColumns& columns) {
  constexpr std::array roles{std::pair{"tension", Role::tension}, std::pair{"continuity", Role::continuity},
                             std::pair{"bias", Role::bias}};
  const auto is_there = [&](std::string_view name) {
    return std::ranges::any_of(columns.members,
                               [&](const Member& member) { return member.name == name && !member.is_nested(); });
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
  const auto add = [&](const char* name, bool array, std::size_t cell, std::size_t cells) {
    columns.members.push_back({.name = name, .title = name, .array = array, .cell = cell, .cells = cells});
  };
  for (const auto& [name, role] : roles) {
    if (tcb || !columns.columns.has(role)) add(name, false, columns.columns.cells.size(), 1);
    columns.columns.cells.push_back({role, 0});
  }
  if (!tcb) add("tcb", true, first, roles.size());
}

bool names_member(const ColumnOptions& options, const std::string& name) {
  return std::ranges::any_of(options.roles,
                             [&](const RoleRequest& role) { return std::ranges::count(role.columns, name) > 0; });
}

/// Throws: Error (data) for a member that is an array where a number was expected, or the reverse, unless its role is
/// requested.
void require_shape(const Found& member, const ColumnOptions& options) {
  const bool is_array = holds_tcb(member.name);
  if (member.is_spread || !has_role(member.name) || (is_array == member.array && !member.text)) return;
  if (names_member(options, member.name)) return;
  if (!is_array && member.numbers == 1 && !member.array) return;  // it may be null
  const Error fault = is_array ? data_error("this is not an array; expected [T,C,B]; correct it")
                               : data_error("this is not a number; expected one; correct it");
  throw member.at(fault);
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
    if (member.is_spread || is_used(member) || has_role(member.name) || is_velocity(member)) continue;
    if (!is_array && !member.deep_numbers) continue;
    const bool is_position = !has_position && (is_array || is_usual_position(member.name));
    if (!is_position && (has_time || !is_time(member))) continue;
    const Error fault =
        is_array ? data_error(
                       "this array is not used; expected \"position\" as the name of an array of positions; "
                       "rename it, or give {} {}, or position=NAME:NAME for the members to take",
                       option::columns, in_shell("position=" + member.name))
                 : data_error(
                       "the numbers in this value are not used, as they are in an object, or in arrays in an "
                       "array; expected an array of numbers, or a member for each number; give {} "
                       "position=NAME:NAME for the members to take, with their paths, such as {}.x",
                       option::columns, member.name);
    throw member.at(fault);
  }
}

/// Throws: Error (data) where there is an array of positions, no time, and a number that may be it.
void require_no_lost_time(const std::vector<Found>& members, const Columns& columns) {
  for (const Found& member : members) {
    const bool is_number = !member.array && !member.text && member.numbers > 0;
    if (!is_number || std::ranges::count(columns.ignored, member.name) == 0 || is_coordinate(member.name)) continue;
    throw data_error(
        "no member is the time, but {} may be; expected one called time; give {} {}, or {} uniform if the keys "
        "have no times",
        in_quotes(member.name), option::columns, in_shell("time=" + member.name), option::parameter)
        .at(member.tape->position(member.place));
  }
}

/// Whether the name is that of a role in a channel of this name.
bool is_of_channel_in(const std::string& name, const std::vector<std::string>& header) {
  const auto role = channel_role_of(name);
  return role && std::ranges::any_of(header, [&](const auto& other) { return same_in_any_case(other, role->channel); });
}

/// The cells of a member.
struct Cells {
  std::size_t cell, cells;
};

/// Whether a name is that of the seconds or of the nanoseconds of a time, and the other part is there too.
bool has_both_time_parts(const std::vector<Found>& found, std::string_view name) {
  const auto part = time_part_of(name);
  return part && std::ranges::any_of(found, [&](const Found& member) {
           const auto other = time_part_of(member.name);
           return other && other->stem == part->stem && other->part != part->part;
         });
}

/// For each cell, whether it holds a number that may have a role or be a position.
std::vector<bool> numeric_cells(const std::vector<Found>& found, const std::vector<Cells>& cells,
                                const std::vector<std::string>& header, const Arrays& arrays) {
  const auto is_in_position = [](const Found& member) { return member.is_of_whole && member.route[0] == "position"; };
  const bool has_array = std::ranges::any_of(found, [&](const auto& member) {
    return is_in_position(member) || (arrays.has(member) && !arrays.is_rotation(member));
  });
  const bool lacks_time = std::ranges::none_of(found, [](const Found& member) {
    return !time_part_of(member.name) && (role_of_name(member.name) == Role::time || is_usual_time(member.name));
  });
  std::vector<bool> numeric;
  for (std::size_t i = 0; i < found.size(); ++i) {
    // Where there is an array of positions, no other number is a position.
    const bool is_single = !found[i].array && !arrays.has(found[i]) && !is_in_position(found[i]);
    const bool is_time = lacks_time && has_both_time_parts(found, found[i].name);
    const bool is_other = has_array && is_single && !is_time && role_of_name(found[i].name) == Role::position;
    const bool is_number = !found[i].text && (!is_other || is_of_channel_in(found[i].name, header));
    numeric.resize(cells[i].cell + cells[i].cells, is_number);
  }
  return numeric;
}

bool is_required(const JsonColumns& columns, std::size_t cell) {
  const Role role = columns.columns.cells[cell].role;
  if (columns.columns.are_segments && role != Role::ignored) return true;
  return role == Role::time || role == Role::position || role == Role::group;
}

/// Adds a member at the end of its route.
void add_member(std::vector<Member>& members, const Found& found, const Cells& cells) {
  std::vector<Member>* level = &members;
  for (std::size_t step = 0; step + 1 < found.route.size(); ++step) {
    auto outer = std::ranges::find_if(
        *level, [&](const Member& member) { return member.name == found.route[step] && member.is_nested(); });
    if (outer == level->end()) {
      level->push_back({.name = found.route[step]});
      outer = level->end() - 1;
    }
    outer->is_whole = outer->is_whole || found.is_of_whole || is_spread_always(found.route[0]);
    level = &outer->inner;
  }
  level->push_back({.name = found.route.back(),
                    .title = found.name,
                    .array = found.array,
                    .cell = cells.cell,
                    .cells = cells.cells});
}

void complete(const JsonColumns& columns, std::vector<Member>& members, std::size_t& count) {
  for (Member& member : members) {
    member.number = count++;
    for (std::size_t i = 0; i < member.cells; ++i) {
      member.required = member.required || is_required(columns, member.cell + i);
    }
    complete(columns, member.inner, count);
  }
}

/// Takes a member of a record, and what is in it, as texts in a row of cells.
void take_cells(std::vector<std::string_view>& row, const JsonTape& tape, const std::vector<Member>& members,
                std::string_view name, std::size_t value) {
  const auto member = std::ranges::find(members, name, &Member::name);
  if (member == members.end() || value == JsonCell::missing) return;
  const auto text = [&](std::size_t scalar) {
    const Kind kind = tape.kind(scalar);
    return kind == Kind::string ? tape.text(scalar) : kind == Kind::null ? "" : tape.written(scalar);
  };
  std::size_t index = 0;
  switch (tape.kind(value)) {
    case Kind::object:
      tape.for_each_member(value, [&](std::size_t inner, std::size_t of_inner) {
        take_cells(row, tape, member->inner, tape.text(inner), of_inner);
        return true;
      });
      break;
    case Kind::array:
      tape.for_each_element(value, [&](std::size_t element) {
        if (member->is_nested()) {
          take_cells(row, tape, member->inner, fmt::format("[{}]", index++), element);
        } else if (index < member->cells && !tape[element].is_nested()) {
          row[member->cell + index++] = text(element);
        }
        return true;
      });
      break;
    default:
      if (member->cells > 0) row[member->cell] = text(value);
  }
}

/// The notes of the doubts about the columns. Throws: Error (data) for one that the request has to decide.
std::vector<std::string> doubts_of(const JsonColumns& columns, const std::vector<std::string>& header,
                                   const std::vector<bool>& numeric, std::vector<std::string> meant,
                                   const JsonTable& records, const InputOptions& options) {
  constexpr std::size_t most = 50;
  std::vector<std::vector<std::string_view>> rows(std::min(records.size(), most));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].resize(header.size());
    records.for_each_cell(
        i, [&](const JsonCell& cell) { take_cells(rows[i], records.tape(), columns.members, cell.name, cell.value); });
  }
  return doubts_of_columns({.names = header,
                            .rows = rows,
                            .numeric = numeric,
                            .columns = columns.columns,
                            .requested = options.columns,
                            .has_rotations = options.rotation.none || !options.rotation.requests.empty(),
                            .has_tcb_scale = options.keys.tcb_scale != TcbScale::unknown || options.has_shown_tcb_scale,
                            .has_header = true,
                            .meant = std::move(meant)});
}

/// What the members of the first key mean.
JsonColumns columns_of(const std::vector<Found>& members, const JsonTable& records, const InputOptions& options,
                       const std::vector<std::string>& channels) {
  const ColumnOptions& requested = options.columns;
  const Arrays arrays = arrays_of(members, options, channels);
  const bool has_array = std::ranges::any_of(members, [&](const auto& member) { return arrays.has(member); });
  JsonColumns result;
  std::vector<std::string> header, unused;
  std::vector<Cells> cells;
  for (const auto& found : members) {
    const auto names = cell_names(found, arrays, members);
    if (arrays.has(found) && names.size() != found.numbers) throw channel_count(names.size(), found.numbers);
    cells.push_back({header.size(), names.size()});
    if (!found.is_spread) add_member(result.members, found, cells.back());
    header.insert(header.end(), names.begin(), names.end());
    if (names.empty() && !found.empty && !found.is_spread) unused.push_back(found.name);
  }
  const auto numeric = numeric_cells(members, cells, header, arrays);
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
  }
  const bool lacks_time = !result.columns.has(Role::time) && !requested.timeless && !requested.samples;
  if (has_array && lacks_time) require_no_lost_time(members, result.columns);
  result.columns.ignored.insert(result.columns.ignored.end(), unused.begin(), unused.end());
  result.found = result.columns.cells.size();
  if (!requested.samples) {
    std::vector<bool> are_numbers;
    std::vector<std::string> meant;
    for (std::size_t i = 0; i < members.size(); ++i) {
      are_numbers.resize(cells[i].cell + cells[i].cells, !members[i].text);
      const auto names = std::span(header).subspan(cells[i].cell, cells[i].cells);
      if (members[i].array) meant.insert(meant.end(), names.begin(), names.end());
    }
    result.columns.doubts = doubts_of(result, header, are_numbers, std::move(meant), records, options);
  }
  add_optional_members(result);
  complete(result, result.members, result.all_members);
  result.rules = options.keys;
  result.max_memory = options.max_memory;
  std::string first_time;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool is_time = cells[i].cells == 1 && result.columns.cells[cells[i].cell].role == Role::time;
    if (is_time && first_time.empty()) first_time = members[i].value;
  }
  result.units = units_of_keys(options.units, result.columns, first_time);
  return result;
}

}  // namespace

JsonColumns find_members(const JsonTable& records, const InputOptions& options,
                         const std::vector<std::string>& channels) {
  std::vector<Found> members = FirstRecord(records, options).read();
  return at_position(records.tape().position(records.place(0)), [&] {
    spread(members, options.columns);
    return columns_of(members, records, options, channels);
  });
}

void name_channels(JsonColumns& columns, const std::vector<std::string>& channels) {
  const auto is_array = [&](const Member& m) {
    return m.array && m.cells > 0 && columns.columns.cells[m.cell].role == Role::position;
  };
  const auto member = std::ranges::find_if(columns.members, is_array);
  if (member == columns.members.end() || channels.empty()) return;
  if (channels.size() != member->cells) throw channel_count(channels.size(), member->cells);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Columns::Column column = columns.columns.cells[member->cell + i];
    if (column.role == Role::position) columns.columns.channels[column.channel] = channels[i];
  }
}

}  // namespace tcb
