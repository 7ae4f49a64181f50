// Members of JSON keys: columns by the names in the first key.
#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include "error.hpp"
#include "input/json/json_input.hpp"
#include "input/json/object_reader.hpp"
#include "text/parse_number.hpp"

namespace tcb {
namespace {

using Member = JsonColumns::Member;

/// The name gives a member another role than position.
bool has_role(const std::string& name) { return name == "tcb" || role_of_name(name) != Role::position; }

/// Collects the members of the first key, then stops.
class FirstKey : public JsonObjectReader {
 public:
  struct Found {
    std::string name;
    bool array = false;
    bool text = false;           ///< it is one text, or true or false
    std::size_t numbers = 0;     ///< that it has, or that are missing there
    std::string path = "";       ///< of one whose name is that of a role or a near miss,
    TextPosition position = {};  ///< and its position
  };
  /// `texts` are the members that are requested as texts.
  FirstKey(const Chunk& chunk, std::vector<std::string> texts) : JsonObjectReader(chunk), texts_(std::move(texts)) {}
  std::vector<Found> members;

  /// Where the key begins.
  const TextPosition& position() const { return position_; }

 private:
  bool on_member(const std::string& name) override {
    if (!names_.insert(name).second) throw value_error(ErrorCode::json_member_repeats);
    members.push_back({name});
    if (!near_role(name) && !has_role(name)) return true;
    members.back().path = path();
    members.back().position = value_position();
    return true;
  }
  bool on_number(const spline::Time<double>&) override { return count(); }
  bool on_null() override { return count(); }  // refused later, as a number that is missing
  bool on_nested() override {
    if (!in_array() && !is_requested_text() && role_of_name(members.back().name) != Role::position) {
      throw value_error(ErrorCode::json_single_number_expected);
    }
    return note(false);
  }
  bool on_text(std::string_view text) override {
    const Found& member = members.back();
    const bool needs_number = role_of_name(member.name) != Role::position || (!text.empty() && looks_numeric(text));
    if (!in_array() && !is_requested_text() && needs_number)
      throw value_error(ErrorCode::json_not_a_number, {std::string(text)});
    return note(true);
  }
  bool on_key_start() override {
    const LinePosition key = key_position();
    position_ = {"", key.line, key.column};
    return true;
  }
  bool on_key_end() override { return false; }
  bool on_break() override { return true; }

  bool is_requested_text() const { return std::ranges::find(texts_, members.back().name) != texts_.end(); }

  /// A value that is not a number.
  bool note(bool text) {
    Found& member = members.back();
    if (in_array() && (member.name == "position" || member.name == "tcb")) return count();  // refused later too
    member.text = text && !in_array();
    return true;
  }

  bool count() {
    members.back().array = in_array();
    ++members.back().numbers;
    return true;
  }

  std::vector<std::string> texts_;
  std::unordered_set<std::string> names_;
  TextPosition position_;
};

/// The names of a member's cells, as a table would have them.
std::vector<std::string> cell_names(const FirstKey::Found& member, const std::vector<std::string>& channels) {
  if (member.text) return {member.name};
  if (!member.array) return std::vector<std::string>(member.numbers, member.name);
  if (member.name == "tcb") return {"tension", "continuity", "bias"};
  if (member.name != "position") return {};
  return channels.empty() ? default_channel_names(member.numbers) : channels;
}

void require_count(std::size_t names, std::size_t numbers) {
  if (names == numbers) return;
  throw Error(Exit::data, ErrorCode::json_channel_count, {std::uint64_t{names}, std::uint64_t{numbers}});
}

/// Tension, continuity and bias may come in any key, also where the first has none, and alone or as "tcb".
void add_optional_members(JsonColumns& columns) {
  constexpr std::array roles{std::pair{"tension", Role::tension}, std::pair{"continuity", Role::continuity},
                             std::pair{"bias", Role::bias}};
  const auto is_there = [&](std::string_view name) {
    return std::ranges::find(columns.members, name, &Member::name) != columns.members.end();
  };
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
void require_shape(const FirstKey::Found& member, const InputOptions& options) {
  const bool is_array = member.name == "tcb";
  if (!has_role(member.name) || (is_array == member.array && !member.text)) return;
  const auto names_it = [&](const RoleRequest& role) { return std::ranges::count(role.columns, member.name) > 0; };
  if (std::ranges::any_of(options.roles, names_it)) return;
  if (member.numbers == 1 && !member.array) return;  // it may be null
  const ErrorCode code = is_array ? ErrorCode::json_tcb_array_expected : ErrorCode::json_single_number_expected;
  throw Error(Exit::data, code, {member.path}).at(member.position);
}

/// Throws: Error (data) for a number whose name is a near miss of a role's.
void require_no_near_miss(const FirstKey::Found& member, const Columns& columns, const InputOptions& options) {
  if (member.array || member.text || member.numbers == 0) return;
  const auto near = near_miss(member.name, columns, options.roles, options.timeless);
  if (!near) return;
  throw Error(Exit::data, ErrorCode::json_member_nearly_role, {member.path, std::string(role_name(*near)), member.name})
      .at(member.position);
}

bool is_required(const JsonColumns& columns, const Member& member) {
  return std::any_of(columns.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell),
                     columns.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell + member.cells),
                     [](const auto& cell) {
                       return cell.role == Role::time || cell.role == Role::position || cell.role == Role::group;
                     });
}

/// What the members of the first key mean.
JsonColumns columns_of(const std::vector<FirstKey::Found>& members, const InputOptions& options,
                       const std::vector<std::string>& channels) {
  const bool has_array = std::ranges::any_of(members, [](const auto& m) { return m.array && m.name == "position"; });
  JsonColumns result;
  std::vector<std::string> header;
  std::vector<bool> numeric;
  for (const auto& found : members) {
    const auto names = cell_names(found, channels);
    if (found.array && found.name == "position") require_count(names.size(), found.numbers);
    result.members.push_back({found.name, found.array, header.size(), names.size()});
    header.insert(header.end(), names.begin(), names.end());
    // Where there is an array of positions, no other number is a position.
    const bool is_other = has_array && !found.array && role_of_name(found.name) == Role::position;
    numeric.resize(header.size(), !is_other && !found.text);
  }
  result.columns = options.samples ? find_sample_columns(header, numeric, *options.samples, options.timeless)
                                   : find_columns(header, numeric, options.roles, options.timeless);
  for (const auto& found : members) {
    if (options.samples) break;  // their names are free
    require_shape(found, options);
    require_no_near_miss(found, result.columns, options);
  }
  result.found = result.columns.cells.size();
  add_optional_members(result);
  for (Member& member : result.members) member.required = is_required(result, member);
  result.rules = options.key_rules();
  return result;
}

}  // namespace

JsonColumns find_members(const Chunk& chunk, const InputOptions& options, const std::vector<std::string>& channels) {
  std::vector<std::string> texts;
  for (const RoleRequest& role : options.roles) {
    if (role.role == Role::group || role.role == Role::carry) {
      texts.insert(texts.end(), role.columns.begin(), role.columns.end());
    }
  }
  FirstKey first(chunk, std::move(texts));
  first.parse();
  return at_position(first.position(), [&] { return columns_of(first.members, options, channels); });
}

void name_channels(JsonColumns& columns, const std::vector<std::string>& channels) {
  const auto member =
      std::ranges::find_if(columns.members, [](const Member& m) { return m.array && m.name == "position"; });
  if (member == columns.members.end() || channels.empty()) return;
  require_count(channels.size(), member->cells);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Columns::Column column = columns.columns.cells[member->cell + i];
    if (column.role == Role::position) columns.columns.channels[column.channel] = channels[i];
  }
}

}  // namespace tcb
