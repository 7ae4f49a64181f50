// What the members of JSON keys mean: columns by the names in the first key.
#include "format/json_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "error.hpp"
#include "format/json_events.hpp"
#include "format/number.hpp"

namespace tcb::format {
namespace {

using Member = JsonColumns::Member;

/// Collects the members of the first key, then stops.
class FirstKey : public JsonEvents {
 public:
  struct Found {
    std::string name;
    bool array = false;
    std::size_t numbers = 0;
  };
  using JsonEvents::JsonEvents;
  std::vector<Found> members;

 private:
  bool on_member(const std::string& name) override {
    if (std::ranges::find(members, name, &Found::name) != members.end()) {
      fail(fmt::format("{}: a second time in one key; expected once; take one out", path()));
    }
    members.push_back({name});
    return true;
  }
  bool on_number(const spline::Time<double>&) override {
    members.back().array = in_array();
    ++members.back().numbers;
    return true;
  }
  bool on_other(std::string_view text) override {
    if (text == "null") members.back().numbers = 1;  // refused later, as a number that is missing
    const bool has_role = role_of_name(members.back().name) != Role::position;
    if (text != "null" && !in_array() && (has_role || (!text.empty() && looks_numeric(text)))) {
      fail(fmt::format("{}: \"{}\" is not a number; expected one without quotes; correct it", path(), text));
    }
    return true;
  }
  bool on_key_end() override { return false; }
};

/// The names of a member's cells, as a table would have them.
std::vector<std::string> cell_names(const FirstKey::Found& member, const std::vector<std::string>& channels) {
  if (!member.array) return std::vector<std::string>(member.numbers, member.name);
  if (member.name == "tcb") return {"tension", "continuity", "bias"};
  if (member.name != "position") return {};
  return channels.empty() ? default_channel_names(member.numbers) : channels;
}

/// Tension, continuity and bias may come in any key, also where the first has none.
void add_optional_members(JsonColumns& columns) {
  constexpr std::array roles{std::pair{"tension", Role::tension}, std::pair{"continuity", Role::continuity},
                             std::pair{"bias", Role::bias}};
  const bool none = std::ranges::none_of(roles, [&](const auto& role) { return columns.columns.has(role.second); });
  const std::size_t cell = columns.columns.cells.size();
  for (const auto& [name, role] : roles) {
    if (columns.columns.has(role)) continue;
    columns.members.push_back({name, false, columns.columns.cells.size(), 1});
    columns.columns.cells.push_back({role, 0});
  }
  if (none) columns.members.push_back({"tcb", true, cell, roles.size()});
}

bool is_required(const JsonColumns& columns, const Member& member) {
  return std::any_of(columns.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell),
                     columns.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell + member.cells),
                     [](const auto& cell) { return cell.role == Role::time || cell.role == Role::position; });
}

}  // namespace

JsonColumns find_members(const Chunk& chunk, const InputOptions& options, const std::vector<std::string>& channels) {
  FirstKey first(chunk);
  first.parse();
  const bool has_array =
      std::ranges::any_of(first.members, [](const auto& m) { return m.array && m.name == "position"; });
  JsonColumns result;
  std::vector<std::string> header;
  std::vector<bool> numeric;
  for (const auto& found : first.members) {
    const auto names = cell_names(found, channels);
    if (found.array && found.name == "position" && names.size() != found.numbers) {
      throw Error(Exit::data,
                  fmt::format("\"channels\" has {} names; expected {}, one for each number of \"position\"; "
                              "correct it",
                              names.size(), found.numbers));
    }
    result.members.push_back({found.name, found.array, header.size(), names.size()});
    header.insert(header.end(), names.begin(), names.end());
    // Beside an array of positions, a number that is nothing else is not a position.
    const bool beside = has_array && !found.array && role_of_name(found.name) == Role::position;
    numeric.resize(header.size(), !beside);
  }
  result.columns = find_columns(header, numeric, options.roles, options.timeless);
  add_optional_members(result);
  for (Member& member : result.members) member.required = is_required(result, member);
  return result;
}

}  // namespace tcb::format
