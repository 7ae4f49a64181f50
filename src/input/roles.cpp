// Roles: what a column or a member of a key can be, and the names that say so.
#include "input/roles.hpp"

#include <algorithm>
#include <array>

namespace tcb {
namespace {

struct RoleName {
  std::string_view name;
  Role role;
  bool any_case;
  bool in_header = true;  ///< a column of that name has that role
};

/// Names that give a column its role; the first name of each role is also its name in --columns.
constexpr std::array role_names{
    RoleName{"time", Role::time, true},          RoleName{"position", Role::position, true},
    RoleName{"tension", Role::tension, true},    RoleName{"continuity", Role::continuity, true},
    RoleName{"bias", Role::bias, true},          RoleName{"ease_in", Role::ease_in, true},
    RoleName{"ease_out", Role::ease_out, true},  RoleName{"group", Role::group, true, false},
    RoleName{"carry", Role::carry, true, false}, RoleName{"t", Role::time, false},
    RoleName{"frame", Role::time, true},         RoleName{"timestamp", Role::time, true},
    RoleName{"seconds", Role::time, true},       RoleName{"T", Role::tension, false},
    RoleName{"C", Role::continuity, false},      RoleName{"B", Role::bias, false},
};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }
bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// A name such as "timestamp [ns]" or "time (s)" without its unit.
std::string_view without_unit(std::string_view name) {
  const std::size_t begin = name.ends_with(']') ? name.rfind('[') : name.ends_with(')') ? name.rfind('(') : 0;
  if (begin == 0 || begin == std::string_view::npos) return name;
  return name.substr(0, name.find_last_not_of(' ', begin - 1) + 1);
}

/// Whether `longer` is `shorter` with one letter more.
bool is_with_a_letter(std::string_view longer, std::string_view shorter) {
  if (longer.size() != shorter.size() + 1) return false;
  std::size_t at = 0;
  while (at < shorter.size() && lower(longer[at]) == lower(shorter[at])) ++at;
  return is_letter(longer[at]) && same_in_any_case(longer.substr(at + 1), shorter.substr(at));
}

/// Whether somebody wrote `name` who meant `known`.
bool is_slip(std::string_view name, std::string_view known) {
  if (is_with_a_letter(name, known) || is_with_a_letter(known, name)) return true;
  if (name.size() != known.size()) return false;
  std::size_t at = 0;
  while (at < name.size() && lower(name[at]) == lower(known[at])) ++at;
  if (at + 1 >= name.size()) return at < name.size() && known.size() > 4;
  const bool changed = same_in_any_case(name.substr(at + 1), known.substr(at + 1));
  const bool swapped = lower(name[at]) == lower(known[at + 1]) && lower(name[at + 1]) == lower(known[at]) &&
                       same_in_any_case(name.substr(at + 2), known.substr(at + 2));
  return swapped || (changed && known.size() > 4);
}

}  // namespace

bool same_in_any_case(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

std::string_view role_name(Role role) { return role_names[static_cast<std::size_t>(role) - 1].name; }

std::optional<Role> find_role(std::string_view name) {
  const auto known = std::ranges::find(role_names, name, &RoleName::name);
  return known == role_names.end() ? std::nullopt : std::optional(known->role);
}

Role role_of_name(std::string_view name) {
  const auto role_of = [](std::string_view written) {
    const auto row = std::ranges::find_if(role_names, [&](const RoleName& known) {
      return known.in_header && (known.any_case ? same_in_any_case(written, known.name) : written == known.name);
    });
    return row == role_names.end() ? Role::position : row->role;
  };
  const std::string_view alone = without_unit(name);
  return alone.size() < name.size() && role_of(alone) == Role::time ? Role::time : role_of(name);
}

std::optional<Role> role_missed(std::string_view name) {
  if (role_of_name(name) != Role::position) return std::nullopt;
  const auto meant = std::ranges::find_if(role_names, [&](const RoleName& known) {
    const bool counts = known.any_case && known.in_header && known.role != Role::position;
    return counts && is_slip(without_unit(name), known.name);
  });
  return meant == role_names.end() ? std::nullopt : std::optional(meant->role);
}

}  // namespace tcb
