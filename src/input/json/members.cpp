// What the members of JSON keys mean: columns by the names in the first key.
#include "input/json/members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include "error.hpp"
#include "input/json/events.hpp"
#include "text/number.hpp"
#include "text/refusal.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Member = JsonColumns::Member;

/// The name says what a member other than the position is.
bool is_known(const std::string& name) { return name == "tcb" || role_of_name(name) != Role::position; }

/// Collects the members of the first key, then stops.
class FirstKey : public JsonEvents {
 public:
  struct Found {
    std::string name;
    bool array = false;
    bool text = false;        ///< it is one text, or true or false
    std::size_t numbers = 0;  ///< that it has, or that are missing there
    std::string path = "";    ///< of one whose name is a role's, or is but for a slip,
    TextPosition place = {};  ///< and its place
  };
  /// `texts` are the members that are asked for as texts.
  FirstKey(const Chunk& chunk, std::vector<std::string> texts) : JsonEvents(chunk), texts_(std::move(texts)) {}
  std::vector<Found> members;

  /// Where the key is.
  const TextPosition& place() const { return place_; }

 private:
  bool on_member(const std::string& name) override {
    if (!names_.insert(name).second) {
      fail(fmt::format("{}: a second time in one key; expected once; take one out", path()));
    }
    members.push_back({name});
    if (!role_missed(name) && !is_known(name)) return true;
    members.back().path = path();
    members.back().place = here();
    return true;
  }
  bool on_number(const spline::Time<double>&) override { return count(); }
  bool on_other(std::string_view text) override {
    if (text == "null" && !is_quoted()) return count();  // refused later, as a number that is missing
    Found& member = members.back();
    const bool has_role = role_of_name(member.name) != Role::position;
    const bool is_text = std::ranges::any_of(texts_, [&](const std::string& name) { return name == member.name; });
    if (!in_array() && !is_text && (has_role || (!text.empty() && looks_numeric(text)))) {
      fail(fmt::format("{}: {} is not a number; expected one without quotes; correct it", path(), shown(text)));
    }
    if (in_array() && (member.name == "position" || member.name == "tcb")) return count();  // refused later too
    member.text = !in_array() && text != "an object";
    return true;
  }
  bool on_key_start() override {
    const LinePosition key = place_of_key();
    place_ = {"", key.line, key.column};
    return true;
  }
  bool on_key_end() override { return false; }
  bool on_break() override { return true; }

  bool count() {
    members.back().array = in_array();
    ++members.back().numbers;
    return true;
  }

  std::vector<std::string> texts_;
  std::unordered_set<std::string> names_;
  TextPosition place_;
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
  throw Error(Exit::data, fmt::format("\"channels\" names {}; expected {}, one for each number of \"position\"; "
                                      "correct it",
                                      names, numbers));
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

/// Throws: Error (data) for a member that is an array where a number was expected, or the other way round, unless
/// --columns says what it is.
void require_shape(const FirstKey::Found& member, const InputOptions& options) {
  const bool is_array = member.name == "tcb";
  if (!is_known(member.name) || (is_array == member.array && !member.text)) return;
  const auto names_it = [&](const RoleRequest& role) { return std::ranges::count(role.columns, member.name) > 0; };
  if (std::ranges::any_of(options.roles, names_it)) return;
  if (member.numbers == 1 && !member.array) return;  // it may be null
  throw Error(Exit::data, member.place,
              fmt::format("{}: expected {}; correct it", member.path, is_array ? "an array [T,C,B]" : "a number"));
}

/// Throws: Error (data) for a number that seems to be meant for something else, by its name.
void require_no_slip(const FirstKey::Found& member, const Columns& columns, const InputOptions& options) {
  if (member.array || member.text || member.numbers == 0) return;
  const auto what = slip(member.name, columns, options.roles, options.timeless);
  if (what) throw Error(Exit::data, member.place, fmt::format("{}: {}", member.path, *what));
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
    // Beside an array of positions, a number that is nothing else is not a position.
    const bool beside = has_array && !found.array && role_of_name(found.name) == Role::position;
    numeric.resize(header.size(), !beside && !found.text);
  }
  result.columns = options.samples ? find_sample_columns(header, numeric, *options.samples, options.timeless)
                                   : find_columns(header, numeric, options.roles, options.timeless);
  for (const auto& found : members) {
    if (options.samples) break;  // of somebody else, whose names are their own
    require_shape(found, options);
    require_no_slip(found, result.columns, options);
  }
  result.found = result.columns.cells.size();
  add_optional_members(result);
  for (Member& member : result.members) member.required = is_required(result, member);
  result.tcb = options.tcb;
  result.missing = options.missing;
  result.keeps_decimals = options.keeps_decimals;
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
  return at_position(first.place(), [&] { return columns_of(first.members, options, channels); });
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
