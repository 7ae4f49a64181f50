// Cells of JSON: the records of a table as rows of named cells, as delimited text has them.
#include "read/json/cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "schema/columns.hpp"
#include "schema/doubts.hpp"
#include "schema/key_rules.hpp"
#include "schema/parameter_names.hpp"
#include "schema/roles.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = Json::Kind;

bool is_time(const JsonColumn& column) {
  if (column.is_parameter) return false;
  return role_of_name(column.path) == Role::time || is_usual_time(column.path) || time_part_of(column.path).has_value();
}

/// Whether a name is that of a column, or of an array or object that it is in, in any case of its letters.
bool is_in(const JsonColumn& column, std::string_view name) {
  const std::string_view path = column.path;
  return path.size() >= name.size() && same_in_any_case(path.substr(0, name.size()), name) &&
         (path.size() == name.size() || path[name.size()] == '.' || path[name.size()] == '[');
}

bool ends_in_tcb(std::string_view path) {
  const std::string_view last = path.substr(path.find_last_of('.') + 1);
  return same_in_any_case(last, "tcb") || same_in_any_case(last, "tbc");
}

bool is_tbc(const JsonColumn& column) { return same_in_any_case(column.stem, "tbc"); }

/// Whether a number is in an array [T,C,B], of the key or of a channel, or in one of [T,B,C].
bool is_tcb(const JsonColumn& column) {
  return column.is_in_array() &&
         (same_in_any_case(column.stem, "tcb") || is_tbc(column) || column.stem.starts_with("tcb."));
}

/// A number of a record without another role by its name.
bool may_be_position(const JsonColumn& column) {
  return !column.has_text && !column.is_parameter && !column.may_be_parameter &&
         role_of_name(column.path) == Role::position && !is_time(column) && !is_usual_counter(column.path) &&
         !is_tcb(column);
}

/// The number of a cell in an array or in an object of x, y, z and w; 4 for others.
std::size_t number_in_quaternion(const JsonColumn& column) {
  constexpr std::array<std::string_view, 4> elements{"[0]", "[1]", "[2]", "[3]"}, members{".x", ".y", ".z", ".w"};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (column.last_step() == elements[i] || column.last_step() == members[i]) return i;
  }
  return elements.size();
}

constexpr std::array<std::string_view, 3> parameters{"tension", "continuity", "bias"};

/// Which of the parameters a number of an array [T,C,B] is; 3 for others.
std::size_t parameter_in_tcb(const JsonColumn& column) {
  constexpr std::array<std::size_t, 3> of_tcb{0, 1, 2}, of_tbc{0, 2, 1};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (column.last_step() == fmt::format("[{}]", i)) return (is_tbc(column) ? of_tbc : of_tcb)[i];
  }
  return parameters.size();
}

/// The arrays of velocities beside one of positions, and the ends of the names of their numbers.
constexpr std::array velocity_arrays{std::pair{"velocity", "_v"}, std::pair{"velocity_in", "_vin"},
                                     std::pair{"velocity_out", "_vout"}};

/// Finds which cells of the first records are part of the table, and what they are called.
class LayoutFinder {
 public:
  LayoutFinder(const Json& json, const JsonTable& table, const InputOptions& options, const FileSettings& settings)
      : json_(json),
        table_(table),
        options_(options),
        requested_(options.columns),
        places_(settings.curve_info.places),
        channels_(settings.channels),
        layout_{.memory = MemoryUse(options.max_memory)} {
    for (const RoleRequest& role : requested_.roles) {
      names_.insert(role.columns.begin(), role.columns.end());
      if (role.role == Role::position && !role.unless_taken) positions_ = role.columns;
    }
    for (const GivenRotation& rotation : options.rotation.requests) {
      names_.insert(rotation.columns.begin(), rotation.columns.end());
      rotations_.insert(rotation.columns.begin(), rotation.columns.end());
    }
  }

  JsonLayout find() {
    read_first_records();
    const bool chooses = !requested_.samples && !table_.are_scattered && table_.has_names;
    if (requested_.samples) {
      for (JsonColumn& column : columns_) column.is_used = column.depth == 0 || column.stem == "position";
      for (JsonColumn& column : columns_) {
        if (column.stem == "position" && column.is_in_array()) unnamed_.push_back(&column);
      }
    } else {
      find_requested();
      find_parameters();
      require_no_list_of_parameters();
      require_shapes();
      find_positions();
      chooses ? choose() : take_all();
    }
    name_columns();
    if (chooses) note_left_numbers();
    join_parameters();
    for (std::uint32_t step = 1; step < layout_.paths.size(); ++step) {
      const std::size_t column = layout_.paths.column(step);
      if (column != JsonPaths::no_column && columns_[column].is_used) layout_.paths.set_used(step);
    }
    for (JsonColumn& column : columns_) {
      const bool is_meant = column.is_used && column.is_in_array() && !column.is_parameter;
      if (is_meant) layout_.meant.push_back(column.name);
      column.is_used = column.is_used && column.target == static_cast<std::size_t>(&column - columns_.data());
    }
    return std::move(layout_);
  }

 private:
  std::size_t first_records() const { return std::min(table_.size(), most_first_records); }
  bool has_any(const auto& f) const { return std::ranges::any_of(columns_, f); }
  void take_all() {
    for (JsonColumn& column : columns_) column.is_used = true;
  }

  /// The member of its first record that a column is in.
  std::size_t member_of(const JsonColumn& column) const {
    const std::size_t record = table_.place(column.row);
    if (!json_.is(record, Kind::object) || column.value < record) return column.value;
    for (const std::size_t member : json_.inside(record)) {
      if (column.value < json_.next(member)) return member;
    }
    return column.value;
  }
  /// An error at the name of a member.
  Error at(const JsonColumn& column, std::string_view path, const Error& error) const {
    const std::size_t member = member_of(column);
    return of_record(column, path, error).at(json_.position(member - (json_.is_member(member) ? 1 : 0)));
  }
  Error of_record(const JsonColumn& column, std::string_view path, const Error& error) const {
    return error.about(fmt::format("{}[{}].{}", table_.list(), table_.number + column.row, path));
  }

  void read_first_records() {
    if (!table_.has_names) layout_.usual_names = usual_names();
    JsonRows rows(json_, table_, layout_);
    for (std::size_t row = 0; row < first_records(); ++row) rows.add_columns(row, layout_);
    std::vector<std::uint32_t> cells;
    for (std::size_t row = 0; row < first_records(); ++row) {
      if (!rows.get(row, cells)) continue;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != 0) add_content(columns_[i], cells[i]);
      }
    }
    for (JsonColumn& column : columns_) column.has_text = column.has_text && !column.has_number;
  }

  /// Names for the numbers of records that have none: the time, and those of channels.
  std::vector<std::string> usual_names() const {
    std::size_t cells = 0;
    for (const std::size_t value : json_.inside(table_.records[0])) {
      cells += json_.is_nested(value) ? json_.count(value) : 1;
    }
    const bool has_time = !requested_.timeless && table_.index.empty() && cells > 0;
    std::vector<std::string> names = default_channel_names(cells - (has_time ? 1 : 0));
    if (has_time) names.insert(names.begin(), "t");
    return names;
  }

  void add_content(JsonColumn& column, std::uint32_t value) const {
    ++column.rows;
    if (json_.is(value, Kind::null)) return;
    const std::string_view text = json_.text(value);
    const bool is_quoted = json_.is(value, Kind::string) || json_.is(value, Kind::name);
    const bool is_missing = is_quoted && is_missing_sign(text, options_.keys.signs);
    const bool is_number = json_.is(value, Kind::number) || (is_quoted && !is_missing && parse_number(text));
    column.has_number = column.has_number || is_number;
    const bool is_time_in_words = is_time(column) && find_notation(text);
    column.has_text = column.has_text || (!is_number && !is_missing && !is_time_in_words);
  }

  /// The last step of a column, without a point.
  static std::string own_name(const JsonColumn& column) {
    return std::string(column.last_step().substr(column.last_step().starts_with('.') ? 1 : 0));
  }

  void find_requested() {
    std::unordered_set<std::string_view> paths;
    for (const JsonColumn& column : columns_) paths.insert(column.path);
    for (JsonColumn& column : columns_) {
      column.is_requested = std::ranges::any_of(names_, [&](auto& name) { return is_in(column, name); });
      // The number of an object "position" may be requested by its own name.
      const bool is_alone = column.stem == "position" && !paths.contains(own_name(column));
      if (is_alone && std::ranges::count(positions_, own_name(column)) > 0) column.is_requested = true;
    }
    const auto is_requested_as = [&](const JsonColumn& column, const std::string& name) {
      return is_in(column, name) || (column.is_requested && own_name(column) == name);
    };
    lacks_positions_ = !requested_.has(Role::position) || std::ranges::any_of(positions_, [&](const std::string& name) {
      return !in_digits<std::size_t>(name) && !has_any([&](auto& column) { return is_requested_as(column, name); });
    });
  }

  /// Finds numbers that are, or may be, tension, continuity and bias by their names.
  void find_parameters() {
    std::vector<std::string> names;
    std::vector<JsonColumn*> places;
    for (JsonColumn& column : columns_) {
      const bool is_element = column.path.find('[') != std::string::npos;
      const bool is_in_tcb = column.depth > 1 && column.is_in_array() && ends_in_tcb(column.stem);
      if (column.has_text || column.is_requested || (is_element && !is_in_tcb)) continue;
      names.push_back(column.path);
      places.push_back(&column);
    }
    for (const ParameterSet& set : parameter_sets(names, std::vector<bool>(names.size(), true), requested_)) {
      for (const auto& cell : set.cells) {
        if (!cell) continue;
        JsonColumn& column = *places[*cell];
        column.is_parameter = set.is_clear();
        const double number = parse_number(json_.text(column.value)).value_or(0);
        const bool is_member = set.is_member && std::abs(number) <= 1;
        const bool is_plain = column.depth == 0 || set.rest == ParameterSet::Rest::of_keys || is_member;
        column.may_be_parameter = set.is_clear() || (set.is_doubtful() && is_plain);
      }
    }
  }

  /// Throws: Error (data) for tension, continuity or bias as a text beside its value, in a list of such.
  void require_no_list_of_parameters() const {
    std::unordered_map<std::string_view, const JsonColumn*> numbers;  // by their objects
    for (const JsonColumn& column : columns_) {
      if (column.has_number && column.stem.ends_with(']')) numbers.emplace(column.stem, &column);
    }
    const JsonColumn* first = nullptr;
    std::vector<std::string> requests;
    for (const JsonColumn& column : columns_) {
      const auto number = numbers.find(column.stem);
      if (!column.has_text || number == numbers.end() || number->second->is_requested) continue;
      const Role role = role_of_name(json_.text(column.value));
      if (role < Role::tension || role > Role::bias || requested_.has(role)) continue;
      if (first == nullptr) first = &column;
      requests.push_back(fmt::format("{}={}", role_name(role), number->second->path));
    }
    if (first == nullptr) return;
    const std::string_view list = outer(first->path);
    throw at(
        *first, list,
        data_error("a list of names and values has tension, continuity or bias; expected members of these names; "
                   "give --columns {} to take them, or --columns {} to leave them out",
                   in_shell(fmt::format("{}", fmt::join(requests, ","))), in_shell(fmt::format("ignore={}", list))));
  }

  /// Throws: Error (data) for an array or an object where a number was expected, or the reverse.
  void require_shapes() const {
    for (const JsonColumn& column : columns_) {
      if (column.is_requested || column.is_parameter) continue;
      const bool is_number_in_tcb = !column.is_in_array() && !column.has_text && same_in_any_case(column.stem, "tcb");
      const bool is_no_array =
          is_number_in_tcb || same_in_any_case(column.path, "tcb") || same_in_any_case(column.path, "tbc");
      if (is_no_array || (is_tcb(column) && parameter_in_tcb(column) == parameters.size())) {
        throw at(column, column.path, data_error("this is not an array; expected [T,C,B]"));
      }
      if (is_tcb(column) && column.has_text) require_number(column);
      const Role role = role_of_name(column.stem);
      const bool may_have_parts = role == Role::position || (role == Role::time && !column.is_in_array());
      if (column.depth > 0 && column.stem != "position" && !may_have_parts) {
        throw at(column, column.stem, data_error("this is not a number; expected one"));
      }
    }
  }

  /// Whether a number is in the array or object of the rotation.
  bool is_of_rotation(const JsonColumn& column) const {
    return column.path.starts_with(rotation_) && column.path.size() > rotation_.size() && is_in(column, rotation_);
  }
  std::ptrdiff_t rotation_cells() const {
    return std::ranges::count_if(columns_, [&](auto& column) { return is_of_rotation(column); });
  }

  /// Whether a number may be a position beside others: none of a rotation or a velocity.
  bool is_free_number(const JsonColumn& column) const {
    return may_be_position(column) && !(is_of_rotation(column) && has_quaternion_) &&
           !column.stem.starts_with("velocity") && !is_in_requested_rotation(column);
  }
  bool is_in_requested_rotation(const JsonColumn& column) const {
    return std::ranges::any_of(rotations_, [&](auto& name) { return is_in(column, name); });
  }

  /// Finds an object of x, y, z and w called orientation beside one of x, y and z called position, as ROS has them.
  void find_pose() {
    std::unordered_map<std::string_view, std::size_t> members;  // numbers in objects
    for (const JsonColumn& column : columns_) {
      if (column.has_number && !column.is_in_array() && number_in_quaternion(column) < 4) ++members[column.stem];
    }
    for (const JsonColumn& column : columns_) {
      constexpr std::string_view rotation = "orientation", position = "position";
      if (!column.stem.ends_with(rotation) || members[column.stem] != 4) continue;
      const std::string around = column.stem.substr(0, column.stem.size() - rotation.size());
      const auto found = members.find(around + std::string(position));
      if ((!around.empty() && !around.ends_with('.')) || found == members.end() || found->second != 3) continue;
      rotation_ = column.stem;
      position_ = found->first;
      return;
    }
  }

  /// Finds the array or object of positions, which "position" is, or the only array of numbers.
  void find_positions() {
    find_pose();
    const auto is_of_quaternion = [&](const JsonColumn& column) {
      return column.stem == rotation_ && number_in_quaternion(column) < 4 && !column.has_text;
    };
    const bool takes_array = has_any([&](const JsonColumn& column) {
      return column.is_in_array() && std::ranges::count(positions_, column.stem) > 0;
    });
    has_quaternion_ = !options_.rotation.none && !takes_array && rotation_cells() == 4 &&
                      std::ranges::count_if(columns_, is_of_quaternion) == 4;
    std::vector<std::string> usual;
    std::unordered_set<std::string_view> texts;
    for (const JsonColumn& column : columns_) {
      if (column.has_text) texts.insert(column.stem);
    }
    for (const JsonColumn& column : columns_) {
      if (column.depth == 0 && is_free_number(column) && column.has_number) has_plain_ = true;
      const bool is_array =
          column.depth == 1 && column.is_in_array() && is_free_number(column) && !texts.contains(column.stem);
      if (!is_array || sizes_[column.stem]++ > 0) continue;
      arrays_.push_back(column.stem);
      std::string_view one = column.stem;
      if (one.ends_with('s')) one.remove_suffix(1);
      if (is_usual_position(column.stem) || is_usual_position(one)) usual.push_back(column.stem);
    }
    find_objects(texts);
    find_object_of_time();
    if (!lacks_positions_) return;
    if (has_any([&](const JsonColumn& column) { return column.stem == position_ && !column.has_text; })) {
      stem_ = position_;
    } else if (!has_plain_) {
      stem_ = usual.size() == 1 ? usual[0] : arrays_.size() == 1 ? arrays_[0] : "";
    }
  }

  /// Finds objects of x, y and z that may be the positions, as no other number is a coordinate.
  void find_objects(const std::unordered_set<std::string_view>& texts) {
    const bool has_coordinate = has_any([&](const JsonColumn& column) {
      const bool is_known = is_coordinate(column.path) || is_usual_channel(column.path);
      return column.depth == 0 && is_free_number(column) && column.has_number && is_known;
    });
    if (!has_plain_ || has_coordinate || !arrays_.empty()) return;
    for (const JsonColumn& column : columns_) {
      const bool is_axis = lists_word(".x .y .z", in_lower_case(column.last_step()));
      const bool may_be = column.depth == 1 && is_axis && is_free_number(column) && !texts.contains(column.stem);
      if (may_be && sizes_[column.stem]++ == 1) arrays_.push_back(column.stem);
    }
    std::erase_if(sizes_, [](const auto& object) { return object.second < 2; });
  }

  /// Finds the object that has the only time and numbers, which are then the positions, as "_source" of a search.
  void find_object_of_time() {
    if (std::ranges::count_if(columns_, is_time) != 1 || requested_.has(Role::time)) return;
    const std::string& stem = std::ranges::find_if(columns_, is_time)->stem;
    const auto is_beside = [&](const JsonColumn& column) {
      return column.stem == stem && column.has_number && !column.is_in_array() && is_free_number(column);
    };
    const bool has_arrays = has_any([&](const auto& column) { return column.is_in_array() && is_free_number(column); });
    if (has_plain_ && !has_arrays && has_any(is_beside)) object_of_time_ = stem;
  }

  /// Whether a number is one of the positions that no request names.
  bool is_position(const JsonColumn& column) const {
    if (!lacks_positions_ || !is_free_number(column)) return false;
    if (!object_of_time_.empty()) return column.stem == object_of_time_ && !column.is_in_array();
    if (!stem_.empty()) return column.stem == stem_;
    const bool is_plain_rotation = options_.rotation.none && is_of_rotation(column) && !column.is_in_array();
    if (column.depth == 0 || is_plain_rotation) return true;
    const std::size_t bracket = column.path.find('[');
    const bool is_last =
        bracket == std::string::npos || column.path.find_first_of(".[", bracket + 1) == std::string::npos;
    const bool is_in_member = bracket == std::string::npos || column.path.find('.') < bracket || column.depth == 1;
    return !has_plain_ && arrays_.empty() && is_last && is_in_member;
  }

  /// Decides which columns are part of the table. Throws: Error (data) where numbers are not used and may be the
  /// positions, or the time.
  void choose() {
    const bool has_time = requested_.timeless || requested_.has(Role::time) ||
                          has_any([](const JsonColumn& column) { return column.depth == 0 && is_time(column); });
    bool has_positions = !lacks_positions_ || has_plain_;
    for (const JsonColumn& column : columns_) {
      if (column.row == 0 && column.is_in_array()) arrays_of_first_.insert(column.stem);
    }
    const bool may_be_partial = options_.keys.missing != Missing::skip_cell && has_full_position();
    for (JsonColumn& column : columns_) {
      const bool has_role = column.stem == "position" || is_tcb(column) || (is_of_rotation(column) && has_quaternion_);
      const bool may_be_time = column.depth == 0 || (!has_time && column.path.find('[') == std::string::npos);
      const bool is_left = column.may_be_parameter ? false
                           : is_time(column)       ? !may_be_time
                           : column.has_text       ? column.depth > 0 && !has_role
                           : role_of_name(column.path) != Role::position
                               ? column.depth > 0
                               : is_free_number(column) && !is_position(column) && !is_near_miss(column);
      const bool is_partial = column.depth == 0 && is_position(column) && column.row > 0 && may_be_partial;
      column.is_used = !is_beyond(column) && (column.is_requested || !(is_left || is_partial));
      has_positions = has_positions || is_position(column);
      if (column.is_used && (!stem_.empty() && column.stem == stem_)) unnamed_.push_back(&column);
    }
    if (!stem_.empty()) require_array_of_numbers();
    if (!has_time && lacks_positions_ && table_.index.empty() && !is_point(stem_) && are_keys(stem_)) {
      const JsonColumn& first = *std::ranges::find(columns_, stem_, &JsonColumn::stem);
      throw at(first, stem_,
               data_error("the first number of this array rises from key to key, as times do; expected a time; give "
                          "--columns {} if that is so, or --columns {} --parameter uniform if not",
                          in_shell(request_of(stem_)), in_shell("position=" + stem_)));
    }
    layout_.array = sizes_.contains(stem_) ? stem_ : positions_.size() == 1 ? positions_[0] : "";
    if (!sizes_.contains(layout_.array)) layout_.array.clear();
    require_no_lost_numbers(has_time, has_positions);
    require_quaternion();
    note_unused_rotation();
  }

  /// Whether a number is beyond the end of an array of the first record, which is a fault of its own record.
  bool is_beyond(const JsonColumn& column) const {
    return column.row > 0 && column.is_in_array() && arrays_of_first_.contains(column.stem);
  }

  /// Whether a position is in all of the first records, so that others need not be.
  bool has_full_position() const {
    return has_any(
        [&](const JsonColumn& column) { return column.row == 0 && column.has_number && is_position(column); });
  }

  void require_number(const JsonColumn& column) const {
    throw of_record(column, column.path,
                    data_error("{} is not a number; expected a number", in_quotes(json_.text(column.value))))
        .at(json_.position(column.value));
  }

  void require_array_of_numbers() const {
    for (const JsonColumn& column : columns_) {
      if (column.stem == stem_ && column.is_in_array() && column.has_text && !column.is_requested && !is_beyond(column))
        require_number(column);
      if (!column.path.starts_with(stem_ + '[') || column.stem == stem_) continue;
      throw at(column, column.path, data_error("this is not a number; expected one, as elsewhere in the array"));
    }
  }

  /// The array that a number is in, or itself, and the member of a record.
  static std::string_view outer(std::string_view path) { return path.substr(0, path.find('[')); }
  static std::string_view outermost(std::string_view path) { return path.substr(0, path.find_first_of(".[")); }

  /// Throws: Error (data) for numbers that are not used and may be the positions, or the time.
  void require_no_lost_numbers(bool has_time, bool has_positions) const {
    const JsonColumn* first = nullptr;
    for (const JsonColumn& column : columns_) {
      if (column.is_used || !is_free_number(column) || !column.has_number) continue;
      if (first == nullptr) first = &column;
      const bool is_array = sizes_.contains(column.stem) && !rotation_stem_of(column.stem + "x") &&
                            !is_of_rotation_vector(column.stem + "x");
      if (lacks_positions_ && stem_.empty() && is_array) refuse_arrays(column);
      if (!stem_.empty() && !has_time && column.depth == 0 && !is_coordinate(column.path)) {
        throw data_error(
            "no member is the time, but {} may be; expected one called time; give --columns {}, or --parameter uniform "
            "if the keys have no times",
            in_quotes(column.path), in_shell("time=" + column.path))
            .at(json_.position(column.value - (json_.is_member(column.value) ? 1 : 0)));
      }
    }
    if (has_positions || first == nullptr) return;
    throw at(*first, outermost(first->path),
             data_error("the numbers in this value are not used, as they are in an object, or in arrays in an array; "
                        "expected an array of numbers, or a member for each number; give --columns position=NAME:NAME "
                        "for the members to take, with their paths, such as {}",
                        first->path));
  }

  /// Whether an array of this name has coordinates, whatever its numbers are.
  static bool is_point(std::string_view array) {
    return is_usual_position(array) && !lists_word("value values", in_lower_case(array));
  }

  /// Whether an array has two numbers, of which the first one rises from key to key, as that of a time and a value
  /// does.
  bool are_keys(const std::string& array) const {
    const auto found = sizes_.find(array);
    if (found == sizes_.end() || found->second != 2 || table_.size() < 2 || table_.are_rows()) return false;
    std::optional<double> before;
    for (std::size_t row = 0; row < std::min(table_.size(), table_.records.size()); ++row) {
      const auto member = json_.member(table_.records[row], array);
      const bool has_number = member && json_.is(*member, Kind::array) && !json_.is_empty(*member);
      const auto number = has_number ? parse_number(json_.text(json_.first(*member))) : std::nullopt;
      if (!number || (before && *number <= *before)) return false;
      before = number;
    }
    return before.has_value();
  }

  /// The roles of an array of positions, or of a time and a value.
  std::string request_of(const std::string& array) const {
    const std::string time = request_of_time();
    const bool has_time = !time.empty() || requested_.has(Role::time) || requested_.timeless || has_any(is_time);
    return !has_time && are_keys(array) ? fmt::format("time={0}[0],position={0}[1]", array)
                                        : time + "position=" + array;
  }

  /// Whether a number has a name that is close to that of a role, which is an error of the table.
  bool is_near_miss(const JsonColumn& column) const {
    return column.depth == 0 && lacks_positions_ && near_role(column.path).has_value();
  }

  /// Throws: Error (data) for arrays of which one may be the positions.
  [[noreturn]] void refuse_arrays(const JsonColumn& column) const {
    std::vector<std::string> sizes;
    std::string likely;
    bool are_alike = true;  // in size
    constexpr std::array<std::string_view, 6> tangents{"to", "ti", "in", "out", "i", "o"};
    for (const std::string& array : arrays_) {
      sizes.push_back(fmt::format("{} of {}", in_quotes(array), how_many(sizes_.at(array), "number")));
      are_alike = are_alike && sizes_.at(array) == sizes_.at(arrays_[0]);
      if (likely.empty() && std::ranges::count(tangents, array) == 0) likely = array;
    }
    if (arrays_.size() == 1) {
      throw at(column, column.stem,
               data_error("this array is not used; expected \"position\" as the name of an array of positions; rename "
                          "it, or give --columns {}, or position=NAME:NAME for the members to take",
                          in_shell(request_of(arrays_[0]))));
    }
    throw at(column, column.stem,
             data_error("these arrays are not used: {}; expected \"position\" as the name of an array of positions; "
                        "rename one, or give {}",
                        listed(sizes),
                        likely.empty() || !are_alike
                            ? "--columns position=NAME for the one that has the positions"
                            : fmt::format("--columns {}, or the name of another one that has the positions",
                                          in_shell(request_of(likely)))));
  }

  /// The only number of the records themselves as the time, where there is no time; empty for others.
  std::string request_of_time() const {
    const auto is_number = [&](const JsonColumn& column) {
      return column.depth == 0 && column.has_number && is_free_number(column) && column.row == 0;
    };
    const auto number = std::ranges::find_if(columns_, is_number);
    const bool is_needed = !requested_.timeless && !requested_.has(Role::time) && !has_any(is_time);
    return is_needed && std::ranges::count_if(columns_, is_number) == 1 ? fmt::format("time={},", number->path) : "";
  }

  /// Throws: Error (data) for "rotation" that is something else than a quaternion and is not requested.
  void require_quaternion() const {
    if (has_quaternion_ || options_.rotation.none || requested_.has(Role::position)) return;
    const auto first = std::ranges::find_if(columns_, [&](auto& column) { return is_of_rotation(column); });
    const std::ptrdiff_t count = rotation_cells();
    if (first == columns_.end() || first->is_requested) return;
    const bool is_array = first->is_in_array() && first->depth == 1;
    if (is_array && count < 3) {  // too few for a rotation in any form
      if (stem_ == rotation_ && table_.columns.empty()) refuse_arrays(*first);
      return;
    }
    throw at(*first, "rotation",
             is_array
                 ? data_error("the array has {}; expected four, x, y, z, w of a quaternion; correct it, or give "
                              "--rotation axis-angle=rotation or euler=rotation,order=XYZ for another form, or "
                              "--columns position={}rotation for plain channels",
                              how_many(static_cast<std::size_t>(count), "number"), stem_.empty() ? "" : stem_ + ":")
                 : data_error("\"rotation\" has members other than x, y, z and w; expected the four numbers of a "
                              "quaternion; correct them, or give --columns position=NAME:NAME for the members to "
                              "take"));
  }

  /// Notes numbers of an array, or of an object of x, y, z and w, that are not used and a rotation by its name.
  void note_unused_rotation() {
    if (options_.rotation.none || !options_.rotation.requests.empty() || !lacks_positions_) return;
    std::unordered_map<std::string_view, std::size_t> counts;
    for (const JsonColumn& column : columns_) {
      const bool is_number = column.depth > 0 && !column.is_used && !column.has_text;
      if (is_number && number_in_quaternion(column) < 4) ++counts[column.stem];
    }
    for (const JsonColumn& column : columns_) {
      const std::size_t count = sizes_.contains(column.stem) ? sizes_.at(column.stem) : counts[column.stem];
      const bool is_vector = column.is_in_array() && count == 3 && is_of_rotation_vector(column.stem + "x");
      const bool is_quaternion = count == 4 && counts[column.stem] == 4 && rotation_stem_of(column.stem + "x");
      if (column.is_used || (!is_vector && !is_quaternion)) continue;
      layout_.notes.push_back(
          fmt::format("the numbers of {} may be a rotation; --rotation {} resamples them as one{}, "
                      "--rotation none leaves out this note",
                      in_quotes(column.stem), in_shell((is_vector ? "axis-angle=" : "quaternion=") + column.stem),
                      is_vector ? "" : " whose last number is w"));
      return;
    }
  }

  /// Notes the numbers beside the positions, and lists what else is not part of the table.
  void note_left_numbers() {
    std::vector<std::string> numbers;
    std::unordered_set<std::string_view> used, names;
    for (const JsonColumn& column : columns_) {
      if (column.is_used) used.insert(outermost(column.path));
    }
    for (const JsonColumn& column : columns_) {
      const bool is_apart = used.contains(outermost(column.path));
      const std::string_view name = is_apart ? outer(column.path) : outermost(column.path);
      if (column.is_used || is_beyond(column) || !names.insert(name).second) continue;
      const bool is_number = column.depth < 2 && (column.depth == 0 || column.is_in_array()) && is_free_number(column);
      const bool is_rotation = rotation_stem_of(column.stem + "x") || is_of_rotation_vector(column.stem + "x");
      const bool is_partial = column.row > 0;
      const std::string ending = fmt::format(" (in {} of {} records)", column.rows, first_records());
      std::vector<std::string>& left =
          stem_ == "position" && is_number && !is_rotation && !is_partial ? numbers : layout_.ignored;
      left.push_back(std::string(name) + (is_partial ? ending : ""));
    }
    if (numbers.empty()) return;
    constexpr std::size_t most = 8;  // names in a command
    const std::string others = numbers.size() > most ? "NAME" : fmt::format("{}", fmt::join(numbers, ":"));
    layout_.notes.push_back(fmt::format("numbers beside \"position\" are left out: {}; --columns {} takes them, too",
                                        listed(numbers), in_shell("position=position:" + others)));
  }

  /// Gives the cells of arrays and objects with a meaning the names that a header would have.
  void name_columns() {
    const std::vector<std::string> channels = name_positions();
    const std::unordered_set<std::string_view> names(channels.begin(), channels.end());
    require_velocities_of(channels.size());
    for (JsonColumn& column : columns_) {
      const auto role = column.depth == 0 ? channel_role_of(column.path) : std::nullopt;
      if (role && names.contains(role->channel)) column.is_used = true;
      const std::size_t number = number_in_quaternion(column);
      constexpr std::array<std::string_view, 4> quaternion{"qx", "qy", "qz", "qw"};
      if (has_quaternion_ && is_of_rotation(column) && !column.is_requested && !options_.rotation.none) {
        column.name = quaternion[number];
      } else if (is_tcb(column) && parameter_in_tcb(column) < parameters.size()) {
        const std::string channel = column.depth == 1 ? "" : "_" + column.stem.substr(4);
        column.name = std::string(parameters[parameter_in_tcb(column)]) + channel;
      }
      for (const auto& [array, ending] : velocity_arrays) {
        if (column.stem != array || !column.is_in_array()) continue;
        column.is_used = number < channels.size();
        if (column.is_used) column.name = channels[number] + ending;
      }
    }
  }

  /// Throws: Error (data) for an array of velocities that has not one for each number of positions.
  void require_velocities_of(std::size_t channels) const {
    std::unordered_map<std::string_view, std::size_t> sizes;
    for (const JsonColumn& column : columns_) sizes[column.stem] += column.is_in_array() ? 1 : 0;
    for (const JsonColumn& column : columns_) {
      const auto is_it = [&](const auto& row) { return row.first == column.stem; };
      if (std::ranges::none_of(velocity_arrays, is_it) || !column.is_in_array() || channels == 0) continue;
      if (sizes[column.stem] == channels) continue;
      throw at(column, column.stem,
               data_error("the array has {}; expected {}, as in the array of positions",
                          how_many(sizes[column.stem], "number"), channels));
    }
  }

  /// Names the positions, and returns these names.
  std::vector<std::string> name_positions() {
    for (const std::string& name : positions_) {
      std::vector<JsonColumn*> cells;
      for (JsonColumn& column : columns_) {
        if (same_in_any_case(column.stem, name) && column.is_in_array() && column.depth == 1) cells.push_back(&column);
      }
      if (positions_.size() == 1 && !lacks_positions_) unnamed_ = cells;
      if (positions_.size() == 1) break;
      const std::vector<std::string> names = default_channel_names(cells.size());
      for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i]->name = (name == "position" ? "" : cells[i]->stem + "_") + names[i];
      }
    }
    const std::vector<std::string> usual = channels_.empty() ? default_channel_names(unnamed_.size()) : channels_;
    const std::set<std::string_view> known(usual.begin(), usual.end());
    const bool is_free = !has_any([&](const JsonColumn& column) { return known.contains(column.path); });
    std::vector<std::string> names;
    for (JsonColumn* column : unnamed_) {
      if (!column->is_in_array()) {
        column->name = column->last_step().substr(1);
      } else {
        if (names.size() >= usual.size() || (!channels_.empty() && unnamed_.size() != usual.size())) {
          throw data_error("\"channels\" has {}; expected {}, one for each number of \"position\"",
                           how_many(usual.size(), "name"), unnamed_.size())
              .at(std::find_if(places_.rbegin(), places_.rend(), [](auto& place) {
                    return place.first.ends_with("channels");
                  })->second);
        }
        const bool is_prefixed = !is_free && column->stem != "position";
        column->name = (is_prefixed ? column->stem + "_" : "") + usual[names.size()];
      }
      names.push_back(column->name);
    }
    return names;
  }

  /// "tcb" in one key and "tension" in another one are one column.
  void join_parameters() {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      columns_[i].target = i;
      if (!columns_[i].is_used) continue;
      const std::size_t other = first.emplace(columns_[i].name, i).first->second;
      if (other != i && is_tcb(columns_[i]) != is_tcb(columns_[other])) columns_[i].target = other;
    }
  }

  const Json& json_;
  const JsonTable& table_;
  const InputOptions& options_;
  const ColumnOptions& requested_;
  const std::vector<std::pair<std::string, TextPosition>>& places_;  ///< of settings
  const std::vector<std::string>& channels_;                         ///< of those
  std::set<std::string> names_, rotations_;                          ///< of requested columns
  std::vector<std::string> positions_;                               ///< names that are requested as positions
  bool lacks_positions_ = false;  ///< none are requested, but for names that cells get here
  JsonLayout layout_;
  std::vector<JsonColumn>& columns_ = layout_.columns;
  std::unordered_set<std::string> arrays_of_first_;  ///< their names
  std::vector<std::string> arrays_;                  ///< names of those that may be positions, and their sizes
  std::unordered_map<std::string, std::size_t> sizes_;
  std::string rotation_ = "rotation", position_ = "position";  ///< stems that mean these
  std::string object_of_time_;                                 ///< with numbers; empty: the records themselves
  std::string stem_;                                           ///< of the positions; empty: they are members of records
  bool has_plain_ = false;                                     ///< a number of records may be a position
  bool has_quaternion_ = false;                                ///< "rotation" has four numbers
  std::vector<JsonColumn*> unnamed_;                           ///< positions that are called as channels
};

}  // namespace

std::uint32_t JsonPaths::add(const Step& step) {
  const auto [at, is_new] = ids_.emplace(step, static_cast<std::uint32_t>(nodes_.size()));
  if (is_new) nodes_.push_back({step});
  return at->second;
}

void JsonPaths::set_used(std::uint32_t id) {
  for (; !nodes_[id].is_used; id = nodes_[id].step.parent) nodes_[id].is_used = true;
}

void JsonPaths::set_elements_around(std::uint32_t id) {
  for (; id != 0; id = nodes_[id].step.parent) {
    const Step& step = nodes_[id].step;
    if (step.number != of_member) nodes_[step.parent].elements = step.number + 1;
  }
}

std::string JsonPaths::path(std::uint32_t id) const {
  std::vector<const Step*> steps;
  for (; id != 0; id = nodes_[id].step.parent) steps.push_back(&nodes_[id].step);
  std::string path;
  for (; !steps.empty(); steps.pop_back()) {
    const Step& step = *steps.back();
    const bool is_element = step.number != of_member;
    path += is_element ? fmt::format("[{}]", step.number) : fmt::format("{}{}", path.empty() ? "" : ".", step.name);
  }
  return path;
}

/// Most records go on like the one before.
std::uint32_t JsonRows::find(const JsonPaths::Step& step) {
  const JsonPaths& paths = layout_.paths;
  std::uint32_t id = last_ < after_.size() ? after_[last_] : 0;
  if (id == 0 || paths.step(id) != step) {
    id = grows_ != nullptr ? grows_->paths.add(step) : paths.find(step);
    if (id == 0) return 0;
    if (after_.size() < paths.size()) after_.resize(paths.size());
    after_[last_] = id;
  }
  last_ = id;
  return id;
}

/// Whether a step is a cell with a value, so that an array or an object in its place is a fault.
bool JsonRows::is_value_in_earlier_record(std::uint32_t step) const {
  const std::size_t column = layout_.paths.column(step);
  return column != JsonPaths::no_column && !json_.is(layout_.columns[column].value, Kind::null);
}

/// The value in an object that tells its type, such as {"$date":"2024-05-01"}; others are as they are.
std::uint32_t JsonRows::without_type(std::uint32_t value) const {
  while (json_.is(value, Kind::object) && !json_.is_empty(value)) {
    const std::size_t member = json_.first(value);
    if (json_.next(member) < json_.next(value) || !json_.name(member).starts_with('$')) break;
    value = static_cast<std::uint32_t>(member);
  }
  return value;
}

template <class F>
void JsonRows::read_value(const JsonPaths::Step& step, std::uint32_t value, const F& found) {
  value = without_type(value);
  const std::uint32_t id = find(step);
  if (id == 0) return refuse_unknown(step, value);
  if (grows_ == nullptr && layout_.paths.is_used(id)) require_shape(id, value);
  if (!json_.is_nested(value)) return found(id, value);
  if (grows_ != nullptr && is_value_in_earlier_record(id)) return;
  std::uint32_t index = 0;
  const bool is_object = json_.is(value, Kind::object);
  for (const std::uint32_t inner : json_.inside(value)) {
    read_value(is_object ? JsonPaths::Step{id, JsonPaths::of_member, json_.name(inner)} : JsonPaths::Step{id, index++},
               inner, found);
  }
}

template <class F>
void JsonRows::read(std::size_t row, const F& found) {
  row_ = row;
  last_ = 0;
  if (!table_.index.empty()) read_member("time", table_.index[row], found);
  for (std::size_t column = 0; column < table_.columns.size(); ++column) {
    const bool is_first = grows_ != nullptr && row == 0;
    const std::uint32_t value = is_first ? first_value(column) : table_.columns[column][row];
    if (value == 0) continue;
    const std::uint32_t element = column < table_.elements.size() ? table_.elements[column] : JsonTable::of_member;
    const JsonPaths::Step array{0, JsonPaths::of_member, table_.names[column]};
    read_value(element == JsonTable::of_member ? array : JsonPaths::Step{find(array), element}, value, found);
  }
  if (!table_.columns.empty()) return;
  const std::uint32_t record = table_.records[row];
  const bool is_row = table_.are_rows();
  if (!json_.is(record, is_row ? Kind::array : Kind::object)) {
    throw data_error("found {} as a key; expected {}", json_.shown(record), is_row ? "an array" : "an object")
        .at(json_.position(record));
  }
  std::uint32_t cell = 0;
  if (is_row) {
    const std::vector<std::string>& names = table_.names.empty() ? layout_.usual_names : table_.names;
    const auto add = [&](std::uint32_t value) {
      if (cell < names.size()) read_member(names[cell], value, found);
      ++cell;
    };
    for (const std::uint32_t value : json_.inside(record)) {
      const bool is_vector = table_.names.empty() && json_.is_nested(value);
      if (is_vector) std::ranges::for_each(json_.inside(value), add);
      if (!is_vector) add(value);
    }
    if (cell == names.size()) return;
    throw data_error("row {} of the table has {}; expected {}, one for each column", table_.number + row,
                     how_many(cell, "cell"), names.size())
        .at(json_.position(record));
  }
  for (const std::uint32_t value : json_.inside(record)) {
    if (json_.name(value) != "index" || table_.index.empty()) read_member(json_.name(value), value, found);
  }
}

/// The first value of a column, so that columns keep their order where the first record lacks one.
std::uint32_t JsonRows::first_value(std::size_t column) const {
  const std::vector<std::uint32_t>& values = table_.columns[column];
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(values.size(), most_first_records));
  const auto first = std::find_if(values.begin(), end, [](std::uint32_t value) { return value != 0; });
  return first == end ? 0 : *first;
}

void JsonRows::add_columns(std::size_t row, JsonLayout& layout) {
  grows_ = &layout;
  if (table_.columns.empty() && json_.is(table_.records[row], Kind::null)) return;
  read(row, [&](std::uint32_t id, std::uint32_t value) {
    if (layout.paths.column(id) != JsonPaths::no_column) return;
    layout.paths.set_column(id, layout.columns.size());
    JsonColumn& column = layout.columns.emplace_back();
    const JsonPaths::Step step = layout.paths.step(id);
    const std::uint32_t parent = step.parent;
    if (row == 0) layout.paths.set_elements_around(id);
    column.path = column.name = layout.paths.path(id);
    if (parent != 0) column.stem = layout.paths.path(parent);
    constexpr std::size_t copies = 8;  // of the names around a cell, which may be long
    layout.memory.add(copies * column.path.size());
    for (std::uint32_t at = parent; at != 0; at = layout.paths.step(at).parent) ++column.depth;
    column.value = value;
    column.row = row;
    column.target = layout.columns.size() - 1;
    if (is_tcb(column)) layout.paths.set_elements(parent, static_cast<std::uint32_t>(parameters.size()));
  });
  grows_ = nullptr;
}

bool JsonRows::get(std::size_t row, std::vector<std::uint32_t>& cells) {
  if (table_.columns.empty() && ends_curve(json_, table_.records[row])) return false;
  cells.assign(layout_.columns.size(), 0);
  read(row, [&](std::uint32_t id, std::uint32_t value) {
    const std::size_t number = layout_.paths.column(id);
    if (number == JsonPaths::no_column) return;
    const JsonColumn& column = layout_.columns[number];
    if (cells[column.target] == 0) {
      cells[column.target] = value;
    } else if (column.is_used || column.depth == 0 || column.target != number) {
      throw at(column.path, value - (json_.is_member(value) ? 1 : 0),
               column.target != number
                   ? data_error("this parameter is given twice, in \"tcb\" and alone; expected it once; remove one")
                   : twice_in("key"));
    }
  });
  return true;
}

Error JsonRows::at(std::string_view path, std::size_t value, const Error& error) const {
  return error.about(fmt::format("{}[{}].{}", table_.list(), table_.number + row_, path)).at(json_.position(value));
}

/// Throws: Error (data) for a value of another shape than it has in the first records.
void JsonRows::require_shape(std::uint32_t id, std::uint32_t value) const {
  const JsonPaths& paths = layout_.paths;
  const auto refuse = [&](const Error& error) { throw at(paths.path(id), value, error); };
  const bool is_cell = paths.column(id) != JsonPaths::no_column;
  if (json_.is(value, Kind::array) && paths.elements(id) > 0) {
    const std::size_t count = json_.count(value);
    if (count != paths.elements(id)) {
      refuse(data_error("the array has {}; expected {}, as in the first key", how_many(count, "element"),
                        paths.elements(id)));
    }
  } else if (json_.is_nested(value) && is_cell && paths.elements(id) == 0) {
    const bool is_text = layout_.columns[paths.column(id)].has_text;
    refuse(data_error("this is not a {}; expected one, as in the first key", is_text ? "text or a number" : "number"));
  } else if (!json_.is_nested(value) && !json_.is(value, Kind::null) && (!is_cell || paths.elements(id) > 0)) {
    refuse(paths.elements(id) > 0 ? data_error("this is not an array; expected one of numbers, as in the first key")
                                  : data_error("this is not an object; expected one, as in the first key"));
  }
}

/// Throws: Error (data) for a number that the first records do not have, unless it is in a value that is not used.
void JsonRows::refuse_unknown(const JsonPaths::Step& step, std::uint32_t value) const {
  if (!layout_.paths.is_used(step.parent)) return;
  const bool is_number =
      json_.holds(json_.is(value, Kind::array) && !json_.is_empty(value) ? json_.first(value) : value, Kind::number);
  if (!is_number) return;
  const std::string outer = layout_.paths.path(step.parent);
  const std::string path = step.number != JsonPaths::of_member
                               ? fmt::format("{}[{}]", outer, step.number)
                               : fmt::format("{}{}{}", outer, outer.empty() ? "" : ".", step.name);
  throw at(path, value,
           data_error("the first key has no such number; expected the same members in every key; add it there"));
}

JsonLayout find_layout(const Json& json, const JsonTable& table, const InputOptions& options,
                       const FileSettings& settings) {
  return LayoutFinder(json, table, options, settings).find();
}

void add_parameters(JsonLayout& layout) {
  const std::uint32_t array = layout.paths.add({0, JsonPaths::of_member, "tcb"});
  layout.paths.set_elements(array, static_cast<std::uint32_t>(parameters.size()));
  for (std::uint32_t i = 0; i < parameters.size(); ++i) {
    const std::size_t column = layout.columns.size();
    const JsonPaths::Step alone{0, JsonPaths::of_member, parameters[i]}, element{array, i};
    for (const JsonPaths::Step& step : {alone, element}) {
      if (layout.paths.find(step) != 0) continue;  // in another role, or an object
      const std::uint32_t id = layout.paths.add(step);
      layout.paths.set_column(id, layout.columns.size());
      layout.paths.set_used(id);
      const std::string path = layout.paths.path(id);
      layout.columns.push_back({.path = path, .name = std::string(parameters[i]), .target = column});
    }
    layout.columns[column].is_used = true;
  }
}

InputOptions with_columns_of_layout(InputOptions options, const JsonLayout& layout) {
  const auto expand = [&](std::vector<std::string>& names) {
    std::vector<std::string> all;
    for (const std::string& name : names) {
      const std::size_t before = all.size();
      for (const JsonColumn& column : layout.columns) {
        const bool is_named = is_in(column, name) && column.depth > 0;
        const bool is_last = column.stem == "position" && column.last_step() == "." + name;
        if (column.is_used && (is_named || is_last)) all.push_back(column.name);
      }
      if (all.size() == before) all.push_back(name);
    }
    names = std::move(all);
  };
  for (RoleRequest& role : options.columns.roles) expand(role.columns);
  for (GivenRotation& rotation : options.rotation.requests) expand(rotation.columns);
  return options;
}

}  // namespace tcb
