// Columns of JSON: what the members of keys mean, by the names and the values in the first key.
//
// FirstKey goes through these steps; FoundMember is what they know of a member:
//   read            the members of the first key: numbers, arrays of numbers, texts, and what is nested
//   spread          numbers deeper in it become members of their own, where they are requested or nothing else may be
//                   the position or the time; their names are their paths
//   name_columns    each member gets the names of its cells: an array of positions those of channels
//   find_columns()  gives the cells roles, as of a table with these names
//   require_…       refuse what would be lost or misread; find_doubts gives the notes
// Then the members stand in JsonColumns as a tree, by which keys.cpp reads all records.
#include "read/json/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <iterator>
#include <span>
#include <unordered_set>
#include <utility>

#include "numbers/dates.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "schema/doubts.hpp"
#include "schema/key_rules.hpp"
#include "schema/parameter_names.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;
using Member = JsonColumns::Member;
using Rows = std::vector<std::vector<std::string_view>>;  ///< the cells of the first records

/// A member of the first key, or a number deeper in it.
struct FoundMember {
  std::string name;
  std::vector<std::string> route;         ///< the names of the members that lead to it; "[2]" for an element
  std::string path;                       ///< as in "keys[0].x"
  std::size_t node = JsonCell::missing;   ///< its value
  std::size_t place = JsonCell::missing;  ///< of its name on the tape
  bool array = false;                     ///< it is an array with numbers
  bool text = false;                      ///< it is one text, or true or false,
  bool is_empty = false;                  ///< or has no value in the first keys
  bool nested = false;                    ///< it is an object, or an array with arrays or objects
  std::size_t numbers = 0;                ///< the count of its numbers, also missing ones
  bool is_of_whole = false;               ///< all numbers around it are columns
  bool is_position = false;               ///< it is an array of positions,
  bool is_rotation = false;               ///< or a quaternion or a number of one
  bool is_parameter = false;              ///< it is tension, continuity or bias by its name
  std::vector<std::string> columns = {};  ///< the names of its cells, as a table would have them
  std::size_t cell = 0;                   ///< the first of these among all

  bool is_number_array() const { return array && !nested && numbers > 0; }
  bool is_of_positions() const { return is_position || is_rotation; }
};

/// Whether a name is that of an array [T,C,B], or of [T,B,C].
bool is_tcb(std::string_view name) { return same_in_any_case(name, "tcb") || same_in_any_case(name, "tbc"); }

/// Whether a member is such an array, of the key or of one channel as "tcb.x", or a number in an object "tcb".
bool holds_tcb(std::string_view name) { return is_tcb(name) || name.starts_with("tcb."); }

/// Whether the members of an object with this name are members of the key.
bool is_spread_always(std::string_view name) { return name == "tcb" || name == "rotation"; }

/// Whether the name gives a member another role than position.
bool has_role(const std::string& name) { return holds_tcb(name) || role_of_name(name) != Role::position; }

/// Whether a member is the array "rotation", or a member of an object "rotation", as "rotation.x".
bool is_of_rotation(const FoundMember& member) {
  return member.name.starts_with("rotation.") || (member.name == "rotation" && (member.array || member.nested));
}

constexpr std::array quaternion_members{std::pair{"rotation.x", "qx"}, std::pair{"rotation.y", "qy"},
                                        std::pair{"rotation.z", "qz"}, std::pair{"rotation.w", "qw"}};

/// Whether the members of rotations are the four numbers of a quaternion: an array, or an object of x, y, z and w.
bool has_quaternion(const std::vector<FoundMember>& members) {
  const auto is_array = [](const FoundMember& member) {
    return member.name == "rotation" && member.is_number_array() && member.numbers == quaternion_members.size();
  };
  const auto is_number = [&](const auto& number) {
    return std::ranges::any_of(members, [&](const FoundMember& member) {
      return member.name == number.first && !member.array && !member.nested && member.numbers == 1;
    });
  };
  return std::ranges::any_of(members, is_array) ||
         (std::ranges::all_of(quaternion_members, is_number) &&
          std::ranges::count_if(members, is_of_rotation) == std::ssize(quaternion_members));
}

/// The arrays of velocities next to an array of positions, and the ends of the names of their numbers.
struct VelocityArray {
  std::string_view name, ending;
};
constexpr std::array velocity_arrays{VelocityArray{"velocity", "_v"}, VelocityArray{"velocity_in", "_vin"},
                                     VelocityArray{"velocity_out", "_vout"}};

bool has_time_name(const FoundMember& member) {
  return !member.is_parameter && (role_of_name(member.name) == Role::time || is_usual_time(member.name));
}

/// Whether a member may be a position by its place: one number without another role.
bool is_plain_number(const FoundMember& member) {
  return member.numbers == 1 && !member.array && !member.text && !member.nested && !member.is_rotation &&
         !member.is_parameter && !has_role(member.name) && !is_usual_time(member.name) &&
         !is_usual_counter(member.name) && !time_part_of(member.name);
}

bool is_object_of_positions(const FoundMember& member) { return member.is_of_whole && member.route[0] == "position"; }

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
    return std::ranges::any_of(columns.key.inner,
                               [&](const Member& member) { return member.name == name && !member.is_nested(); });
  };
  const auto& given = columns.columns.cells;
  const auto is_given = [&](std::size_t channel) {
    return std::ranges::any_of(given, [&](const auto& cell) {
      return cell.channel == channel && (cell.role == Role::velocity || cell.role == Role::velocity_in);
    });
  };
  std::size_t channel = 0;
  while (channel < columns.columns.channels.size() && is_given(channel)) ++channel;
  if (channel == columns.columns.channels.size()) return;  // no tangent depends on them
  const bool tcb = is_there("tcb");
  const std::size_t first = columns.columns.cells.size();
  const auto add = [&](const char* name, bool array, std::size_t cell, std::size_t cells) {
    columns.key.add({.name = name, .title = name, .array = array, .cell = cell, .cells = cells});
  };
  for (const auto& [name, role] : roles) {
    if (tcb || !columns.columns.has(role)) add(name, false, columns.columns.cells.size(), 1);
    columns.columns.cells.push_back({role, 0});
  }
  if (!tcb) add("tcb", true, first, roles.size());
}

/// Adds a member at the end of its route.
void add_member(Member& key, const FoundMember& found) {
  Member* outer = &key;
  for (std::size_t step = 0; step + 1 < found.route.size(); ++step) {
    const auto next = std::ranges::find_if(
        outer->inner, [&](const Member& member) { return member.name == found.route[step] && member.is_nested(); });
    Member& member = next == outer->inner.end() ? outer->add({.name = found.route[step]}) : *next;
    member.is_whole = member.is_whole || found.is_of_whole || is_spread_always(found.route[0]);
    outer = &member;
  }
  outer->add({.name = found.route.back(),
              .title = found.name,
              .array = found.array,
              .cell = found.cell,
              .cells = found.columns.size()});
}

/// Numbers the members of one, and finds which of them keys need.
void complete(JsonColumns& columns, Member& outer) {
  const auto is_required = [&](const Columns::Column& column) {
    const Role role = column.role;
    return role == Role::time || role == Role::position || role == Role::group;
  };
  for (Member& member : outer.inner) {
    member.number = columns.all_members++;
    const auto cells = std::span(columns.columns.cells).subspan(member.cell, member.cells);
    member.required = std::ranges::any_of(cells, is_required);
    complete(columns, member);
  }
}

/// Takes a member of a record, and what is in it, as texts in a row of cells.
void take_cells(std::vector<std::string_view>& row, const JsonTape& tape, const Member& outer, std::string_view name,
                std::size_t value) {
  const Member* const member = value == JsonCell::missing ? nullptr : outer.find(name, tape.kind(value));
  if (member == nullptr) return;
  const auto text = [&](std::size_t scalar) {
    const Kind kind = tape.kind(scalar);
    return kind == Kind::null ? "" : tape.shown(scalar);
  };
  std::size_t index = 0;
  if (!tape[value].is_nested() && member->cells > 0) row[member->cell] = text(value);
  for (const std::size_t inner : tape.inside(value)) {
    if (tape.kind(inner) == Kind::name) {
      take_cells(row, tape, *member, tape.text(inner), inner + 1);
    } else if (member->is_nested()) {
      take_cells(row, tape, *member, fmt::format("[{}]", index++), inner);
    } else if (index < member->cells && !tape[inner].is_nested()) {
      row[member->cell + index++] = text(inner);
    }
  }
}

/// Finds the columns of the members of the first key.
class FirstKey {
 public:
  FirstKey(const JsonTable& records, const InputOptions& options, const std::vector<std::string>& channels)
      : records_(records),
        tape_(records.tape()),
        options_(options),
        requested_(options.columns),
        signs_(options.keys.signs),
        channels_(channels) {
    read();
  }

  JsonColumns find() {
    if (!requested_.samples) find_parameters();
    if (!requested_.samples) spread();
    name_columns();
    JsonColumns result;
    std::vector<std::string> header;
    std::vector<bool> numeric;
    for (FoundMember& member : members_) {
      member.cell = header.size();
      header.insert(header.end(), member.columns.begin(), member.columns.end());
      numeric.insert(numeric.end(), member.columns.size(), !member.text);
      add_member(result.key, member);
      if (member.columns.empty() && !is_empty(member)) unused_.push_back(member.name);
    }
    const Rows rows = first_rows(result.key, header.size());
    std::vector<std::string> notes;
    if (requested_.samples) {
      result.columns = find_sample_columns(header, numeric, *requested_.samples, requested_.timeless);
    } else if (requested_.times_only) {
      std::vector<RoleRequest> roles = requests();
      if (!rows.empty()) add_roles_by_cells(header, rows, roles, notes);
      result.columns = find_time_column(header, numeric, roles);
    } else {
      if (!options_.rotation.none && !requested_.has(Role::position)) require_quaternion();
      require_no_lost_arrays();
      require_no_vectors();
      std::vector<RoleRequest> roles = requests();
      std::ranges::copy(parameters_by_name(header, may_be_parameters(numeric), requested_), std::back_inserter(roles));
      if (!rows.empty()) add_roles_by_cells(header, rows, roles, notes);
      result.columns = find_columns(header, numeric, roles, requested_.timeless);
      if (result.columns.has(Role::clock))
        throw data_error(
            "the time of a record is one member, and cannot be joined from several; expected one; join them")
            .about("--columns");
      for (const FoundMember& member : members_) {
        if (member.is_empty) result.columns.cells[member.cell].is_empty = result.columns.cells[member.cell].is_text;
      }
      const bool is_requested = requested_.has(Role::time) || requested_.timeless;
      result.columns.has_time_by_place = !records_.has_names() && !is_requested && result.columns.has(Role::time);
      std::ranges::for_each(members_, [&](const FoundMember& member) { require_shape(member); });
    }
    const bool has_array = has_any(&FoundMember::is_of_positions);
    if (has_array) result.columns.likely_time.clear();
    const bool are_keys = !requested_.samples && !requested_.times_only;
    const bool lacks_time = !result.columns.has(Role::time) && !requested_.timeless && are_keys;
    if (has_array && lacks_time) require_no_lost_time(result.columns);
    result.columns.ignored.insert(result.columns.ignored.end(), unused_.begin(), unused_.end());
    result.found = result.columns.cells.size();
    result.columns.doubts = std::move(notes);
    if (are_keys) find_doubts(result, header, numeric, rows);
    if (are_keys) find_unused_rotation(result.columns.doubts);
    if (are_keys && !requested_.has(Role::position)) find_unused_numbers(result.columns);
    add_optional_members(result);
    complete(result, result.key);
    result.rules = options_.keys;
    result.max_memory = options_.max_memory;
    const auto time = std::ranges::find_if(members_, [&](const FoundMember& member) {
      return member.columns.size() == 1 && result.columns.cells[member.cell].role == Role::time;
    });
    const bool has_text = time != members_.end() && time->node != JsonCell::missing && !tape_[time->node].is_nested();
    std::vector<std::string> times{has_text ? std::string(tape_.shown(time->node)) : ""};
    for (std::size_t row = 1; has_text && row < rows.size(); ++row) times.emplace_back(rows[row][time->cell]);
    const UnitOptions units = with_date_order(options_.units, result.columns.time, times, result.columns.doubts);
    result.units = units_of_keys(units, result.columns, times[0]);
    return result;
  }

 private:
  /// Finds what the first record holds.
  void read() {
    for (const RoleRequest& role : requested_.roles) {
      for (const std::string& name : role.columns) requested_names_.insert(in_lower_case(name));
      if (role.role == Role::position) {
        positions_.insert(role.columns.begin(), role.columns.end());
        requested_positions_.insert(role.columns.begin(), role.columns.end());
      }
      if (role.role == Role::group || role.role == Role::carry || role.role == Role::unused) {
        texts_.insert(role.columns.begin(), role.columns.end());
      }
    }
    for (const GivenRotation& rotation : options_.rotation.requests) {
      positions_.insert(rotation.columns.begin(), rotation.columns.end());
    }
    for (const JsonCell& cell : records_.first_cells()) {
      const bool is_object = cell.value != JsonCell::missing && tape_.kind(cell.value) == Kind::object;
      if (!is_object || !is_spread_always(cell.name)) {
        add(std::string(cell.name), {std::string(cell.name)}, cell);
        continue;
      }
      for (const std::size_t name : tape_.inside(cell.value)) {
        const std::string inner(tape_.text(name));
        add(fmt::format("{}.{}", cell.name, inner), {std::string(cell.name), inner}, {inner, name + 1, name});
      }
    }
    find_missing_numbers();
  }

  void add(std::string name, std::vector<std::string> route, const JsonCell& cell) {
    FoundMember& member = members_.emplace_back();
    member.path = fmt::format("{}.{}", records_.first_path(), name);
    member.name = std::move(name);
    member.route = std::move(route);
    member.node = cell.value;
    member.place = cell.place == JsonCell::missing ? records_.place(0) : cell.place;
    if (!names_.insert(member.name).second) throw at(member, twice_in("key"));
    if (cell.value == JsonCell::missing) {
      member.numbers = 1;
    } else if (tape_.kind(cell.value) != Kind::array) {
      add_value(member, cell.value, false);
    } else {
      for (const std::size_t element : tape_.inside(cell.value)) add_value(member, element, true);
    }
  }

  bool takes_nested(const std::string& name) const {
    const Role role = role_of_name(name);
    return role == Role::position || role == Role::time || texts_.contains(name);
  }

  void add_value(FoundMember& member, std::size_t value, bool in_array) {
    const bool is_nested = tape_[value].is_nested();
    if (is_nested && !in_array && !takes_nested(member.name)) {
      throw at_value(member, data_error("this is not a number; expected one; correct it"));
    }
    const bool is_number = !is_nested && (in_array ? is_element(member, value) : is_one_number(member, value));
    const bool is_refused_later = in_array && (member.name == "position" || holds_tcb(member.name));
    member.nested = member.nested || is_nested;
    member.text = !is_number && !is_nested && !in_array;
    if (!is_number && !is_refused_later) return;
    member.array = in_array;
    ++member.numbers;
  }

  /// Whether an element of an array is a number, or a missing one.
  bool is_element(const FoundMember& member, std::size_t value) const {
    const Kind kind = tape_.kind(value);
    if (kind == Kind::number || kind == Kind::null) return true;
    return positions_.contains(member.name) && is_number(tape_, value) && !is_missing_sign(tape_.text(value), signs_);
  }

  /// Whether a member is a number, a missing one, or a time in words. Throws: Error (data) for a text where a number is
  /// expected.
  bool is_one_number(const FoundMember& member, std::size_t value) const {
    const Kind kind = tape_.kind(value);
    if (kind == Kind::number || kind == Kind::null) return true;
    const bool is_quoted = kind != Kind::boolean;
    const std::string_view text = tape_.shown(value);
    const Role role = role_of_name(member.name);
    if (is_quoted && role == Role::time && find_notation(text)) return true;
    if (texts_.contains(member.name)) return false;
    if (is_quoted && is_missing_sign(text, signs_)) return role != Role::position;
    if (is_quoted && parse_number(text)) return true;
    if (role == Role::position && !looks_numeric(text)) return false;
    if (const std::string date = role == Role::time ? date_in_known_form(text) : ""; !date.empty()) {
      throw at_value(member, data_error("{} is a date in a form that is not read; expected it as {}; write it so",
                                        in_quotes(text), date));
    }
    throw at_value(member, data_error("{} is not a number; expected a number; correct it, or give --columns {}",
                                      in_quotes(text), in_shell("ignore=" + member.name)));
  }

  /// Whether a member is missing in the first key, and need not be a position.
  bool may_be_empty(const FoundMember& member) const {
    const bool is_null = member.node == JsonCell::missing || tape_.kind(member.node) == Kind::null;
    return is_null && !requested_.samples && role_of_name(member.name) == Role::position &&
           !requested_.has(member.name);
  }

  /// Members that are texts in the first key may hold numbers; those that are missing in it may hold nothing.
  void find_missing_numbers() {
    const auto is_open = [&](const FoundMember& member) { return member.text || may_be_empty(member); };
    if (std::ranges::none_of(members_, is_open)) return;
    constexpr std::size_t most_records = 1000;
    std::unordered_set<std::string_view> numbers, missing, texts;
    JsonCells cells;
    for (std::size_t record = 0; record < std::min(records_.size(), most_records); ++record) {
      records_.get_cells(record, cells);
      for (const JsonCell& cell : cells) {
        const Kind kind = tape_.kind(cell.value);
        if (kind == Kind::number) numbers.insert(cell.name);
        if (kind == Kind::boolean) texts.insert(cell.name);
        if (kind != Kind::string || tape_.text(cell.value).empty()) continue;
        (is_missing_sign(tape_.text(cell.value), signs_) ? missing : texts).insert(cell.name);
      }
    }
    for (FoundMember& member : members_) {
      const bool is_empty = !numbers.contains(member.name) && !texts.contains(member.name);
      if (is_empty && may_be_empty(member)) member.text = member.is_empty = true;
      const bool has_numbers =
          numbers.contains(member.name) || (missing.contains(member.name) && !texts.contains(member.name));
      if (!member.text || !has_numbers) continue;
      member.text = false;
      member.numbers = 1;
    }
    const auto is_other = [](const FoundMember& member) {
      return !member.text && member.numbers > 0 && !has_time_name(member);
    };
    if (std::ranges::any_of(members_, is_other)) return;
    for (FoundMember& member : members_) {  // something has to be the position
      if (std::exchange(member.is_empty, false)) member.text = false;
    }
  }

  /// Whether a member is [] or {}.
  bool is_empty(const FoundMember& member) const {
    return member.node != JsonCell::missing && tape_[member.node].is_nested() &&
           tape_[member.node].next == member.node + 1;
  }
  /// Whether numbers are in an object, or in the objects and arrays of an array.
  bool holds_numbers(const FoundMember& member) const {
    const auto holds_one = [&](std::size_t inner) {
      const std::size_t value = tape_.value_of(inner);
      return (value != inner || tape_[value].is_nested()) && tape_.holds(value, Kind::number);
    };
    return member.nested && std::ranges::any_of(tape_.inside(member.node), holds_one);
  }

  template <class F>
  bool has_any(const F& f) const {
    return std::ranges::any_of(members_, [&](const FoundMember& member) { return std::invoke(f, member); });
  }
  /// Whether a request names a member, in any case of its letters, or the array that it is in.
  bool is_requested(const FoundMember& member) const {
    if (requested_names_.contains(in_lower_case(member.name)) || is_position_in_object(member)) return true;
    return member.route.size() > 2 && std::ranges::any_of(requested_.roles, [&](const RoleRequest& role) {
             return std::ranges::any_of(role.columns,
                                        [&](const std::string& name) { return is_vector_at(name, member); });
           });
  }
  /// Whether positions are requested by the name of the object that a number is in, or by that of the number in an
  /// object "position".
  bool is_position_in_object(const FoundMember& member) const {
    return is_number_in_object(member) && (requested_positions_.contains(member.route[0]) ||
                                           (is_named_alone(member) && requested_positions_.contains(member.route[1])));
  }
  static bool is_number_in_object(const FoundMember& member) {
    return member.route.size() == 2 && !member.route[1].starts_with('[') && member.numbers == 1 && !member.is_rotation;
  }
  /// Whether the last step of its path names a number in an object "position", and no other member.
  bool is_named_alone(const FoundMember& member) const {
    return member.route[0] == "position" && !names_.contains(member.route[1]);
  }
  /// Whether a member is a number in the array of this name, which is not itself a member of a key.
  static bool is_vector_at(const std::string& name, const FoundMember& member) {
    return member.route.size() > 2 && member.name == name + member.route.back() && member.route.back().starts_with('[');
  }
  /// Whether a rotation is requested by the name of a member, or of an array that it is in.
  bool is_in_rotation(std::string_view member) const {
    return is_any_in_rotations([&](std::string_view name) { return name == member || is_element_of(name, member); });
  }
  /// Whether a rotation is requested by the name of an array, or of a number in it.
  bool has_rotation(std::string_view array) const {
    return is_any_in_rotations([&](std::string_view name) { return name == array || is_element_of(array, name); });
  }
  template <class F>
  bool is_any_in_rotations(const F& is_it) const {
    return std::ranges::any_of(options_.rotation.requests, [&](const GivenRotation& rotation) {
      return std::ranges::any_of(rotation.columns, is_it);
    });
  }
  Error at(const FoundMember& member, const Error& error) const {
    return error.about(member.path).at(tape_.position(member.place));
  }
  /// An error at the value of a member, which is outside of the record in a table of columns.
  Error at_value(const FoundMember& member, const Error& error) const {
    const std::size_t first = records_.place(0);
    const bool is_inside = first < member.node && member.node < tape_[first].next;
    return error.about(is_inside ? records_.first_path() + tape_.path(first, member.node) : member.path)
        .at(tape_.position(member.node));
  }

  /// Adds the numbers, times and texts in an object or an array, whose names are their paths.
  void add_inside(std::vector<FoundMember>& members, const FoundMember& outer) {
    std::size_t index = 0;
    for (const std::size_t place : tape_.inside(outer.node)) {
      const bool is_name = tape_.kind(place) == Kind::name;
      const std::string step = is_name ? std::string(tape_.text(place)) : fmt::format("[{}]", index++);
      const std::string end = is_name ? "." + step : step;
      const std::size_t value = tape_.value_of(place);
      FoundMember inner{
          .name = outer.name + end, .route = outer.route, .path = outer.path + end, .node = value, .place = place};
      inner.route.push_back(step);
      constexpr std::size_t copies = 8;  // of the names around a number, which may be long
      paths_.add(copies * inner.path.size());
      if (tape_[value].is_nested()) {
        add_inside(members, inner);
        continue;
      }
      const bool is_string = tape_.kind(value) == Kind::string;
      const std::string_view text = tape_.shown(value);
      inner.text = tape_.kind(value) == Kind::boolean ||
                   (is_string && !parse_number(text) && !(find_notation(text) && has_time_name(inner)));
      inner.numbers = inner.text ? 0 : 1;
      members.push_back(std::move(inner));
    }
  }

  /// Finds the members that may be tension, continuity and bias by their names, also those that are deeper in the key.
  void find_parameters() {
    std::vector<std::string> names;
    std::vector<FoundMember*> places;
    std::deque<std::vector<FoundMember>> deeper;
    for (FoundMember& member : members_) {
      const bool is_number = member.numbers == 1 && !member.array && !member.text && !member.nested;
      if (!is_number && !member.nested) continue;
      deeper.emplace_back();
      if (member.nested) add_inside(deeper.back(), member);
      if (is_number) deeper.back().push_back(member);
      for (FoundMember& one : deeper.back()) {
        if (one.text || is_requested(one)) continue;
        names.push_back(one.name);
        places.push_back(is_number ? &member : &one);
      }
    }
    for (const ParameterSet& set : parameter_sets(names, std::vector<bool>(names.size(), true), requested_)) {
      const bool is_open = set.is_doubtful() && set.rest == ParameterSet::Rest::of_keys;
      for (const auto& cell : set.cells) {
        if (!cell || (!set.is_clear() && !is_open)) continue;
        places[*cell]->is_parameter = set.is_clear();
        if (places[*cell]->route.size() > 1) deeper_parameters_.insert(names[*cell]);
      }
    }
  }

  /// For each column, whether its name may say that it is a parameter: it holds one number, and no option names it.
  std::vector<bool> may_be_parameters(const std::vector<bool>& numeric) const {
    std::vector<bool> usable(numeric.size());
    for (const FoundMember& member : members_) {
      const bool is_number = member.columns.size() == 1 && !member.array && !is_requested(member);
      if (is_number) usable[member.cell] = numeric[member.cell];
    }
    return usable;
  }

  /// Makes the numbers in objects members of their own: those that are requested, and, where the key has no other
  /// position or no time, those that may be it.
  void spread() {
    const auto is_one_time = [](const FoundMember& m) { return has_time_name(m) && !m.nested && !m.array; };
    const auto may_be_positions = [&](const FoundMember& m) {
      return is_plain_number(m) || (m.is_number_array() && !has_role(m.name) && !has_rotation(m.name));
    };
    const bool lacks_position = !requested_.has(Role::position) && !has_any(may_be_positions);
    const bool lacks_time = !requested_.timeless && !requested_.has(Role::time) && !has_any(is_one_time);
    const bool has_position_array = has_any([](const FoundMember& m) { return m.name == "position" && m.array; });
    const bool has_position_object = has_any([](const FoundMember& m) { return m.name == "position" && m.nested; });
    const bool has_request = !requested_.roles.empty() || !options_.rotation.requests.empty();
    const bool has_parameters = !deeper_parameters_.empty();
    if (!has_request && !lacks_position && !lacks_time && !has_position_object && !has_parameters) return;
    std::vector<FoundMember> kept, deeper;
    for (FoundMember& outer : members_) {
      std::vector<std::string> rest;
      if (!add_spread(outer, lacks_position, lacks_time, has_position_array, deeper, rest)) {
        kept.push_back(std::move(outer));
      } else {
        unused_.insert(unused_.end(), rest.begin(), rest.end());
      }
    }
    for (const FoundMember& member : deeper) names_.insert(member.name);
    members_ = std::move(kept);
    std::ranges::move(deeper, std::back_inserter(members_));
  }

  /// Adds those of the numbers in a member that are members of their own, and what else it holds to `rest`. Returns
  /// whether there are any.
  bool add_spread(const FoundMember& outer, bool lacks_position, bool lacks_time, bool has_position_array,
                  std::vector<FoundMember>& members, std::vector<std::string>& rest) {
    const bool is_rotation = is_of_rotation(outer) && !has_rotation(outer.name);
    const bool is_nested = (outer.nested || outer.array) && outer.node != JsonCell::missing;
    if (!is_nested || (holds_tcb(outer.name) && outer.array) || is_rotation) return false;
    const bool is_position = outer.nested && !outer.array && outer.name == "position" &&
                             !requested_.has(Role::position) && !has_position_array && holds_numbers(outer);
    std::vector<FoundMember> inside;
    add_inside(inside, outer);
    const bool is_position_array =
        outer.name == "position" && std::ranges::any_of(inside, [&](const auto& one) { return is_requested(one); });
    const std::size_t before = members.size();
    for (FoundMember& inner : inside) {
      const auto is_element = [](const std::string& step) { return step.starts_with('['); };
      const auto elements = std::ranges::count_if(inner.route, is_element);
      const bool in_vector = elements == 1 && !is_element(inner.route[1]) && is_element(inner.route.back());
      const bool may_be_position = lacks_position && (elements == 0 || in_vector);
      const bool is_time = !inner.text && (has_time_name(inner) || time_part_of(inner.name));
      const bool may_be_time = lacks_time && elements == 0 && is_time;
      const bool is_of_positions = is_position || is_position_array || may_be_position;
      inner.is_rotation = is_in_rotation(inner.name);
      inner.is_parameter = deeper_parameters_.contains(inner.name);
      if (!is_of_positions && !may_be_time && !inner.is_rotation && !inner.is_parameter && !is_requested(inner)) {
        std::string whole = inner.name.substr(0, inner.name.find('[', outer.name.size()));
        if (rest.empty() || rest.back() != whole) rest.push_back(std::move(whole));
        continue;
      }
      if (is_position && inner.route.size() == 2) inner.name = inner.route[1];
      inner.is_of_whole = is_of_positions || inner.is_rotation;
      members.push_back(std::move(inner));
    }
    // An object is whole where no number in it is left out, or all are positions.
    for (FoundMember& inner : std::span(members).subspan(before)) {
      inner.is_of_whole = inner.is_of_whole && (rest.empty() || !inner.is_rotation);
    }
    return members.size() > before;
  }

  /// The name of the array of positions that nothing names: the only array, or the only one with a usual name.
  std::string lone_array() const {
    std::vector<std::string> all, usual;
    for (const FoundMember& member : members_) {
      if (is_plain_number(member)) return "";
      const bool is_velocity = std::ranges::count(velocity_arrays, member.name, &VelocityArray::name) > 0;
      if (!member.is_number_array() || has_role(member.name) || is_of_rotation(member) || is_velocity) continue;
      all.push_back(member.name);
      std::string_view one = member.name;
      if (one.ends_with('s')) one.remove_suffix(1);
      if (is_usual_position(member.name) || is_usual_position(one)) usual.push_back(member.name);
    }
    return all.size() == 1 ? all[0] : usual.size() == 1 ? usual[0] : "";
  }

  /// Finds the arrays of positions: those that are requested, else "position", else the only one; and the members of a
  /// quaternion. Returns the names of the arrays.
  std::vector<std::string> find_arrays() {
    std::vector<std::string> arrays;
    for (const RoleRequest& request : requested_.roles) {
      if (request.role != Role::position) continue;
      for (const std::string& name : request.columns) {
        const auto array = std::ranges::find_if(
            members_, [&](const FoundMember& member) { return member.array && same_in_any_case(member.name, name); });
        if (array != members_.end()) arrays.push_back(array->name);
      }
    }
    bool has_quaternions = false;
    if (arrays.empty()) {
      const auto position = std::ranges::find(members_, "position", &FoundMember::name);
      const bool has_position = position != members_.end() && position->is_number_array();
      const bool is_known = requested_.has(Role::position) || has_position || requested_.samples;
      const std::string lone = is_known ? "" : lone_array();
      arrays = {lone.empty() ? "position" : lone};
      has_quaternions = !options_.rotation.none && !has_rotation("rotation") && has_quaternion(members_);
    }
    for (FoundMember& member : members_) {
      const bool is_array = member.array && !member.nested;
      const bool is_number = !member.array && member.numbers == 1;
      const bool is_whole = is_of_rotation(member) && (has_quaternions || (is_number && is_in_rotation(member.name)));
      member.is_rotation = member.is_rotation || is_whole;
      member.is_position = !member.is_rotation && is_array && std::ranges::count(arrays, member.name) > 0;
    }
    return arrays;
  }

  /// Names the cells of members. Throws: Error (data) where an array has another number of them.
  void name_columns() {
    const bool is_alone = find_arrays().size() == 1;
    for (FoundMember& member : members_) {
      if (member.is_position) member.columns = position_columns(member, is_alone);
    }
    const auto positions = std::ranges::find_if(members_, &FoundMember::is_position);
    for (FoundMember& member : members_) {
      if (member.text) {
        member.columns = {member.name};
      } else if (member.is_rotation && is_of_rotation(member) && !is_in_rotation(member.name)) {
        for (const auto& [name, column] : quaternion_members) {
          if (member.array || member.name == name) member.columns.emplace_back(column);
        }
      } else if (!member.array) {
        member.columns.assign(member.numbers, member.name);
      } else if (holds_tcb(member.name)) {
        const std::string channel = member.name.size() > 3 ? "_" + member.name.substr(4) : "";
        const bool is_tbc = same_in_any_case(member.name, "tbc");
        for (const Role role :
             {Role::tension, is_tbc ? Role::bias : Role::continuity, is_tbc ? Role::continuity : Role::bias}) {
          member.columns.push_back(std::string(role_name(role)) + channel);
        }
      } else if (!member.is_position) {
        member.columns = velocity_columns(member, positions == members_.end() ? nullptr : &*positions);
      }
      if (member.is_of_positions() && member.columns.size() != member.numbers) {
        throw channel_count(member.columns.size(), member.numbers);
      }
    }
  }

  /// The names of the numbers in an array, which are those of other members in front of none.
  std::vector<std::string> position_columns(const FoundMember& array, bool is_alone) const {
    if (is_alone && !channels_.empty()) return channels_;
    std::vector<std::string> columns = default_channel_names(array.numbers);
    const bool is_free = std::ranges::none_of(columns, [&](const auto& column) { return names_.contains(column); });
    if (array.name == "position" || (is_alone && is_free)) return columns;
    for (std::string& column : columns) column.insert(0, array.name + "_");
    return columns;
  }

  /// The names of the numbers in an array of velocities; empty for others, and without an array of positions.
  std::vector<std::string> velocity_columns(const FoundMember& array, const FoundMember* positions) const {
    const auto known = std::ranges::find(velocity_arrays, array.name, &VelocityArray::name);
    if (known == velocity_arrays.end() || positions == nullptr || array.nested) return {};
    if (array.numbers != positions->numbers) {
      throw at(array, data_error("the array has {}; expected {}, as in the array of positions; correct it",
                                 how_many(array.numbers, "number"), positions->numbers));
    }
    std::vector<std::string> columns = positions->columns;
    for (std::string& column : columns) column += known->ending;
    return columns;
  }

  /// The cells of the first records.
  Rows first_rows(const Member& key, std::size_t columns) const {
    constexpr std::size_t most = 100;
    Rows rows(std::min(records_.size(), most));
    JsonCells cells;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].resize(columns);
      records_.get_cells(i, cells);
      for (const JsonCell& cell : cells) take_cells(rows[i], tape_, key, cell.name, cell.value);
    }
    return rows;
  }

  /// Adds the roles that follow from cells, as in delimited text: the only dates are the time where no member is by its
  /// name, and members that count the records are no positions beside others.
  void add_roles_by_cells(const std::vector<std::string>& header, const Rows& rows, std::vector<RoleRequest>& roles,
                          std::vector<std::string>& notes) const {
    const bool lacks_time = !requested_.has(Role::time) && !requested_.timeless && !has_any(has_time_name);
    const auto times = lacks_time ? only_times_in_words(rows[0]) : std::nullopt;
    const auto request = [&](Role role, std::size_t cell) { roles.push_back({role, {requested_as(header, cell)}}); };
    const auto only = lacks_time && !times ? find_only_time(header, rows) : std::nullopt;
    if (only && !requested_.has(header[*only])) {
      request(Role::time, *only);
      notes.push_back(only_time_is_taken(in_quotes(header[*only])));
    }
    std::vector<std::size_t> counters;
    bool has_others = false;
    for (const FoundMember& member : members_) {
      if (member.columns.empty() || is_requested(member)) continue;
      if (times && member.cell == times->cell && member.text) {
        request(Role::time, member.cell);
        notes.push_back(times_in_words_are_taken(*times, in_quotes(member.name)));
      } else if (is_plain_number(member)) {
        const bool is_counter = counts_records(member.name, rows, member.cell);
        has_others = has_others || !is_counter;
        if (is_counter) counters.push_back(member.cell);
      }
    }
    if (!has_others || counters.empty() || requested_.has(Role::position) || has_any(&FoundMember::is_of_positions))
      return;
    std::vector<std::string> left;
    for (const std::size_t cell : counters) {
      request(Role::unused, cell);
      left.push_back(in_quotes(header[cell]));
    }
    notes.push_back(counters_are_left(left));
  }

  /// The requests with the names of cells in the place of those of arrays at any depth.
  std::vector<RoleRequest> requests() const {
    std::vector<RoleRequest> requests = requested_.roles;
    std::vector<const FoundMember*> deeper;  // that other names may request than their own
    for (const FoundMember& member : members_) {
      if (member.is_of_positions() || member.is_rotation || member.route.size() > 1) deeper.push_back(&member);
    }
    for (RoleRequest& request : requests) {
      std::vector<std::string> columns;
      for (const std::string& name : request.columns) {
        std::vector<std::string> names{name};
        for (const FoundMember* const member : deeper) {
          const bool is_array = member->is_of_positions();
          if (is_array && request.role == Role::position && same_in_any_case(member->name, name)) {
            names = member->columns;
            break;
          }
          const bool is_path = member->route.size() == 2 && name == member->route[0] + "." + member->route[1];
          if (is_path && !is_spread_always(member->route[0])) names = {member->name};
          const bool is_of_rotation = member->is_rotation && is_element_of(name, member->name);
          const bool is_of_object = request.role == Role::position && is_number_in_object(*member) &&
                                    (name == member->route[0] || (name == member->route[1] && is_named_alone(*member)));
          if (!is_vector_at(name, *member) && !is_of_rotation && !is_of_object) continue;
          if (names.size() == 1 && names[0] == name) names.clear();
          names.push_back(member->name);
        }
        columns.insert(columns.end(), names.begin(), names.end());
      }
      request.columns = std::move(columns);
    }
    if (requested_.has(Role::position)) return requests;
    // Where there is an array of positions, no other number is a position.
    const auto is_position = [](const FoundMember& m) { return m.is_position || is_object_of_positions(m); };
    RoleRequest positions{.role = Role::position, .option = "", .unless_taken = true};
    for (const FoundMember& member : members_) {
      const bool is_taken = !member.text && (is_position(member) || member.is_rotation);
      if (is_taken) positions.columns.insert(positions.columns.end(), member.columns.begin(), member.columns.end());
    }
    if (has_any(is_position)) requests.push_back(std::move(positions));
    return requests;
  }

  /// Throws: Error (data) for members of rotations that are something else than a quaternion and are not requested, but
  /// for arrays of one or two numbers.
  void require_quaternion() const {
    const auto is_named = [&](const FoundMember& m) {
      return m.is_rotation && is_any_in_rotations([&](std::string_view name) { return name == m.name; });
    };
    const auto first =
        std::ranges::find_if(members_, [&](const FoundMember& m) { return is_of_rotation(m) && !is_named(m); });
    const auto is_deeper = [](const FoundMember& m) { return is_of_rotation(m) && m.route.size() > 2; };
    if (first == members_.end() || has_any(is_deeper) || has_quaternion(members_)) return;
    const bool is_array = first->array && !first->nested;
    const bool has_position = has_any([](const FoundMember& m) { return m.name == "position"; });
    if (is_array && first->numbers < 3) return;  // too few for a rotation in any form
    throw at(*first,
             is_array ? data_error("the array has {}; expected four, x, y, z, w of a quaternion; correct it, or give "
                                   "--rotation axis-angle=rotation or euler=rotation,order=XYZ for another form, or "
                                   "--columns position={}rotation for plain channels",
                                   how_many(first->numbers, "number"), has_position ? "position:" : "")
                      : data_error(
                            "\"rotation\" has members other than x, y, z and w; expected the four numbers of a "
                            "quaternion; correct them, or give --columns position=NAME:NAME for the members to take"));
  }

  /// Throws: Error (data) for a member that is an array where a number was expected, or the reverse, unless its role is
  /// requested.
  void require_shape(const FoundMember& member) const {
    const bool is_array = holds_tcb(member.name);
    if (!has_role(member.name) || member.is_parameter || (is_array == member.array && !member.text)) return;
    const bool is_named = requested_.has(member.name);
    if (is_named || (!is_array && member.numbers == 1 && !member.array)) return;  // it may be null
    throw at(member, is_array ? data_error("this is not an array; expected [T,C,B]; correct it")
                              : data_error("this is not a number; expected one; correct it"));
  }

  /// Throws: Error (data) where an array or an object is not used and may be the position, for single numbers are, or
  /// the time.
  void require_no_lost_arrays() const {
    const bool has_position = requested_.has(Role::position) || has_any(&FoundMember::is_of_positions);
    const bool has_time = requested_.timeless || requested_.has(Role::time) ||
                          has_any([](const FoundMember& m) { return m.numbers == 1 && !m.array && has_time_name(m); });
    const bool lacks_numbers = !has_position && records_.size() > 1 && !has_any(is_plain_number);
    for (const FoundMember& member : members_) {
      const bool is_array = member.array && !member.nested;
      const bool is_used = member.is_of_positions() || (is_array && !member.columns.empty());
      if (is_used || may_be_rotation(member) || has_role(member.name)) continue;
      if (!is_array && !holds_numbers(member) && (!lacks_numbers || path_of_number(member) == member.name)) continue;
      const bool is_position = !has_position && (is_array || lacks_numbers || is_usual_position(member.name));
      if (!is_position && (has_time || !is_usual_time(member.name))) continue;
      if (is_position) require_no_poses();
      throw at(member,
               is_array
                   ? data_error("this array is not used; expected \"position\" as the name of an array of positions; "
                                "rename it, or give --columns {}, or position=NAME:NAME for the members to take",
                                in_shell("position=" + member.name))
                   : data_error("the numbers in this value are not used, as they are in an object, or in arrays in an "
                                "array; expected an array of numbers, or a member for each number; give --columns "
                                "position=NAME:NAME for the members to take, with their paths, such as {}",
                                path_of_number(member)));
    }
  }

  /// The options that take the numbers in a member as poses, if they are such; empty for others.
  std::string pose_options(const FoundMember& member) const {
    constexpr std::size_t most_records = 50, most = 16;
    std::vector<std::string> names;
    std::vector<std::vector<std::string_view>> rows(std::min(records_.size(), most_records));
    JsonCells cells;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      records_.get_cells(i, cells);
      const auto cell = std::ranges::find(cells, member.name, &JsonCell::name);
      if (cell == cells.end() || cell->value == JsonCell::missing) return "";
      for (std::size_t node = cell->value; node < tape_[cell->value].next && rows[i].size() <= most; ++node) {
        if (tape_.kind(node) != Kind::number) continue;
        rows[i].push_back(tape_.written(node));
        if (i == 0) names.push_back(member.name + tape_.path(cell->value, node));
      }
    }
    const Columns columns;
    const FoundColumns found{.names = names, .rows = rows, .numeric = {}, .columns = columns, .requested = requested_};
    return names.size() == most || names.size() == 12 ? options_of_poses(found, 0, names.size()) : "";
  }

  /// Throws: Error (data) where an array that is not used holds poses, or several are not used.
  void require_no_poses() const {
    constexpr std::array<std::string_view, 6> tangents{"to", "ti", "in", "out", "i", "o"};
    std::vector<std::string> arrays;
    std::string poses, likely;
    bool are_alike = true;  // in size
    const FoundMember* first = nullptr;
    for (const FoundMember& member : members_) {
      if (member.node == JsonCell::missing || may_be_rotation(member) || has_role(member.name)) continue;
      const std::string options = member.array || member.nested ? pose_options(member) : "";
      if (options.empty() && !member.is_number_array()) continue;
      if (first == nullptr) first = &member;
      arrays.push_back(in_quotes(member.name));
      if (member.array) arrays.back() += fmt::format(" of {}", how_many(member.numbers, "number"));
      if (!options.empty()) poses = fmt::format("{} for the poses in {}", options, in_quotes(member.name));
      const bool is_tangent = std::ranges::count(tangents, member.name) > 0;
      if (likely.empty() && member.is_number_array() && !is_tangent) likely = member.name;
      are_alike = are_alike && member.numbers == first->numbers;
    }
    if (poses.empty() && arrays.size() < 2) return;
    throw at(*first, data_error("these arrays are not used: {}; expected \"position\" as the name of an array of "
                                "positions; rename one, or give {}",
                                listed(arrays),
                                !poses.empty() ? poses
                                : likely.empty() || !are_alike
                                    ? "--columns position=NAME for the one that has the positions"
                                    : fmt::format("--columns {}, or the name of another one that has the positions",
                                                  in_shell("position=" + likely))));
  }

  /// Throws: Error (data) where there are no numbers but in texts such as "(1, 2, 3)".
  void require_no_vectors() const {
    if (has_any(is_plain_number) || has_any(&FoundMember::is_number_array)) return;
    for (const FoundMember& member : members_) {
      if (!member.text || member.node == JsonCell::missing || texts_.contains(member.name)) continue;
      const std::string_view text = tape_.shown(member.node);
      if (!text.starts_with('(') || text.find(',') == std::string_view::npos || !text.ends_with(')')) continue;
      throw at_value(member,
                     data_error("{} is a text of several numbers; expected an array of numbers; write it as one",
                                in_quotes(text)));
    }
  }

  /// The path of the first number in a value, also in quotes; the name of the member where there is none.
  std::string path_of_number(const FoundMember& member) const {
    if (member.node == JsonCell::missing) return member.name;
    std::size_t node = member.node;
    while (node < tape_[member.node].next && !is_number(tape_, node)) ++node;
    return node == tape_[member.node].next ? member.name : member.name + tape_.path(member.node, node);
  }

  /// Throws: Error (data) where there is an array of positions, no time, and a number that may be it.
  void require_no_lost_time(const Columns& columns) const {
    for (const FoundMember& member : members_) {
      const bool is_number = !member.array && !member.text && member.numbers > 0;
      if (!is_number || std::ranges::count(columns.ignored, member.name) == 0 || is_coordinate(member.name)) continue;
      throw data_error(
          "no member is the time, but {} may be; expected one called time; give --columns {}, or --parameter uniform "
          "if the keys have no times",
          in_quotes(member.name), in_shell("time=" + member.name))
          .at(tape_.position(member.place));
    }
  }

  /// Whether the numbers of an array, or of an object of x, y, z and w, are a rotation vector or a quaternion by their
  /// name.
  bool may_be_rotation(const FoundMember& member) const {
    if (member.nested && !member.array && rotation_stem_of(member.name + "x") && member.node != JsonCell::missing) {
      return tape_.count(member.node) == 4 && std::ranges::all_of(std::array{"x", "y", "z", "w"}, [&](auto name) {
               return tape_.kind(member.node) == Kind::object && tape_.member(member.node, name);
             });
    }
    if (!member.is_number_array()) return false;
    return (member.numbers == 3 && is_of_rotation_vector(member.name + "x")) ||
           (member.numbers == 4 && rotation_stem_of(member.name + "x"));
  }

  /// Adds a note where the numbers of an array that is not used are a rotation by its name.
  void find_unused_rotation(std::vector<std::string>& notes) const {
    if (options_.rotation.none || !options_.rotation.requests.empty() || requested_.has(Role::position)) return;
    for (const FoundMember& member : members_) {
      if (!member.columns.empty() || !may_be_rotation(member)) continue;
      const bool is_vector = member.numbers == 3;
      notes.push_back(
          fmt::format("the numbers of {} may be a rotation; --rotation {} resamples them as one{}, "
                      "--rotation none leaves out this note",
                      in_quotes(member.name), in_shell((is_vector ? "axis-angle=" : "quaternion=") + member.name),
                      is_vector ? "" : " whose last number is w"));
      return;
    }
  }

  /// Notes the numbers beside an array of positions, which are ignored, and how to take them.
  void find_unused_numbers(Columns& columns) const {
    const auto is_position = [](const FoundMember& member) {
      return member.name == "position" && member.is_number_array();
    };
    if (!has_any(is_position)) return;
    std::unordered_set<std::string_view> numbers;
    for (const FoundMember& member : members_) {
      const bool is_of_numbers = member.is_number_array() || is_plain_number(member);
      if (is_of_numbers && !may_be_rotation(member)) numbers.insert(member.name);
    }
    std::vector<std::string> names;
    std::ranges::copy_if(columns.ignored, std::back_inserter(names),
                         [&](auto& name) { return numbers.contains(name); });
    if (names.empty()) return;
    std::erase_if(columns.ignored, [&](auto& name) { return numbers.contains(name); });
    constexpr std::size_t most = 8;  // names in a command
    const std::string others = names.size() > most ? "NAME" : fmt::format("{}", fmt::join(names, ":"));
    columns.doubts.push_back(fmt::format("numbers beside \"position\" are left out: {}; --columns {} takes them, too",
                                         listed(names), in_shell("position=position:" + others)));
  }

  /// Finds the notes of the doubts about the columns. Throws: Error (data) for one that the request has to decide.
  void find_doubts(JsonColumns& columns, const std::vector<std::string>& header, const std::vector<bool>& numeric,
                   const Rows& rows) const {
    std::vector<std::string> meant, arrays;
    for (const FoundMember& member : members_) {
      if (member.array) meant.insert(meant.end(), member.columns.begin(), member.columns.end());
      if (member.is_position) arrays.push_back(member.name);
    }
    const FoundColumns found{
        .names = header,
        .rows = rows,
        .numeric = numeric,
        .columns = columns.columns,
        .requested = requested_,
        .parameters = parameter_sets(header, numeric, requested_),
        .has_rotations = options_.rotation.none || !options_.rotation.requests.empty(),
        .has_tcb_scale = options_.keys.tcb_scale != TcbScale::unknown || options_.has_shown_tcb_scale,
        .has_header = true,
        .has_time_unit = options_.units.time.has_value(),
        .meant = std::move(meant),
        .array = arrays.size() == 1 ? arrays[0] : ""};
    std::ranges::move(doubts_of_columns(found), std::back_inserter(columns.columns.doubts));
    columns.columns.time_gap = first_time_gap(found);
  }

  const JsonTable& records_;
  const JsonTape& tape_;
  const InputOptions& options_;
  const ColumnOptions& requested_;
  const std::vector<std::string>& signs_;
  const std::vector<std::string>& channels_;
  std::unordered_set<std::string> requested_names_;        ///< of members, in lower case
  std::unordered_set<std::string> requested_positions_;    ///< names that are requested as positions
  std::unordered_set<std::string> texts_;                  ///< members that are requested as texts
  std::unordered_set<std::string> positions_{"position"};  ///< those that may be arrays of positions
  std::unordered_set<std::string> names_;                  ///< of members
  std::unordered_set<std::string> deeper_parameters_;      ///< paths of numbers in members, which are parameters
  MemoryUse paths_{options_.max_memory};
  std::vector<FoundMember> members_;
  std::vector<std::string> unused_;  ///< members, and what is in others of which a part is used
};

}  // namespace

Member& Member::add(Member member) {
  places.emplace(member.name, inner.size());
  return inner.emplace_back(std::move(member));
}

const Member* Member::find(std::string_view wanted, Kind kind) const {
  const auto [first, last] = places.equal_range(wanted);
  const auto has_kind = [&](const auto& place) { return inner[place.second].is_nested() == (kind == Kind::object); };
  const auto match = std::find_if(first, last, has_kind);
  if (first == last) return nullptr;
  return &inner[(match == last ? first : match)->second];
}

JsonColumns find_members(const JsonTable& records, const InputOptions& options,
                         const std::vector<std::string>& channels) {
  FirstKey first(records, options, channels);
  try {
    return first.find();
  } catch (const Error& error) {
    throw error.at(records.tape().position(records.place(0)));  // which takes time to count
  }
}

void name_channels(JsonColumns& columns, const std::vector<std::string>& channels) {
  const auto is_array = [&](const Member& m) {
    return m.array && m.cells > 0 && columns.columns.cells[m.cell].role == Role::position;
  };
  const auto member = std::ranges::find_if(columns.key.inner, is_array);
  if (member == columns.key.inner.end() || channels.empty()) return;
  if (channels.size() != member->cells) throw channel_count(channels.size(), member->cells);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Columns::Column column = columns.columns.cells[member->cell + i];
    if (column.role == Role::position) columns.columns.channels[column.channel] = channels[i];
  }
}

}  // namespace tcb
