// Channel roles: columns with the tension or a velocity of one channel, by name or on request, and near misses.
#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <unordered_map>

#include "option_names.hpp"
#include "schema/columns.hpp"
#include "schema/errors.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// The text before or after the name of a channel in the names of its columns.
struct Affix {
  std::string_view text;
  Role role;
  bool is_prefix;
};

constexpr std::array affixes{
    Affix{"tension_", Role::channel_tension, true},
    Affix{"continuity_", Role::channel_continuity, true},
    Affix{"bias_", Role::channel_bias, true},
    Affix{"_v", Role::velocity, false},
    Affix{"_vin", Role::velocity_in, false},
    Affix{"_vout", Role::velocity_out, false},
    // Of segments only:
    Affix{"_p1", Role::end_position, false},
    Affix{"_v1", Role::end_velocity, false},
};

/// Finds names: exactly, or else in another case.
class NameIndex {
 public:
  explicit NameIndex(std::span<const std::string> names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      exact_.emplace(names[i], i);
      other_.emplace(in_lower_case(names[i]), i);
    }
  }

  std::optional<std::size_t> find(const std::string& name) const {
    if (const auto found = exact_.find(name); found != exact_.end()) return found->second;
    const auto found = other_.find(in_lower_case(name));
    return found == other_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::unordered_map<std::string, std::size_t> exact_, other_;
};

/// Tension, continuity or bias, if a text is the name of one or a near miss; not as in x_T, which may be anything.
std::optional<Role> tcb_role(std::string_view text) {
  const Role role = near_role(text).value_or(role_of_name(text));
  const bool is_tcb = role == Role::tension || role == Role::continuity || role == Role::bias;
  return is_tcb && text.size() > 1 ? std::optional(role) : std::nullopt;
}

/// The columns with roles in one channel.
class RolesOfChannel {
 public:
  RolesOfChannel(const Columns& columns, std::size_t channel) : columns_(columns), channel_(channel) {}

  /// Throws: Error (data) for a velocity of one side alone, or two of one side, or with tension, continuity or bias.
  void require_whole_velocities() const {
    const auto both = name(Role::velocity), in = name(Role::velocity_in), out = name(Role::velocity_out);
    if (both && (in || out)) throw velocity_columns_overlap(*both, in ? *in : *out);
    if (in && !out) throw velocity_column_missing(*in, with_role(Role::velocity_out));
    if (out && !in) throw velocity_column_missing(*out, with_role(Role::velocity_in));
    for (const Role role : {Role::channel_tension, Role::channel_continuity, Role::channel_bias}) {
      if (has_velocity() && name(role)) throw velocity_with_tcb(both ? *both : *in, *name(role));
    }
  }
  bool has_velocity() const { return name(Role::velocity) || name(Role::velocity_in); }

 private:
  std::string with_role(Role role) const { return role_name(ChannelRole{role, columns_.channels[channel_]}); }
  std::optional<std::string> name(Role role) const {
    const bool is_there = std::ranges::any_of(columns_.cells, [&](const Columns::Column& column) {
      return column.role == role && column.channel == channel_;
    });
    return is_there ? std::optional(with_role(role)) : std::nullopt;
  }

  const Columns& columns_;
  std::size_t channel_;
};

/// Throws: Error (data) for velocities that are not whole, and for tension, continuity or bias with the velocities of
/// all channels.
void require_whole_velocities(const Columns& columns) {
  const bool has_any = std::ranges::any_of(columns.cells, [](const auto& column) { return is_velocity(column.role); });
  if (!has_any) return;
  bool has_all = true;
  for (std::size_t i = 0; i < columns.channels.size(); ++i) {
    const RolesOfChannel channel(columns, i);
    channel.require_whole_velocities();
    has_all = has_all && channel.has_velocity();
  }
  for (const Role role : {Role::tension, Role::continuity, Role::bias}) {
    if (has_all && columns.has(role)) throw tcb_with_all_velocities(role_name(role));
  }
}

}  // namespace

std::string role_name(const ChannelRole& role) {
  const auto affix = std::ranges::find(affixes, role.role, &Affix::role);
  const std::string text(affix->text);
  return affix->is_prefix ? text + role.channel : role.channel + text;
}

std::optional<ChannelRole> channel_role_of(std::string_view name) {
  for (const auto& [text, role, is_prefix] : affixes) {
    if (name.size() <= text.size() || role > Role::velocity_out) continue;
    const std::size_t rest = name.size() - text.size();
    if (!same_in_any_case(is_prefix ? name.substr(0, text.size()) : name.substr(rest), text)) continue;
    return ChannelRole{role, std::string(is_prefix ? name.substr(text.size()) : name.substr(0, rest))};
  }
  return std::nullopt;
}

std::vector<std::optional<ChannelRole>> channel_roles(std::span<const std::string> header,
                                                      const std::vector<bool>& may_be_channel, bool chosen) {
  std::vector<std::optional<ChannelRole>> named, roles(header.size());
  std::ranges::transform(header, std::back_inserter(named), channel_role_of);
  if (std::ranges::none_of(named, [](const auto& role) { return role.has_value(); })) return roles;
  const NameIndex names(header);
  std::vector<std::size_t> cells(header.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  // The column of a channel has a shorter name than those with a role in it.
  std::ranges::stable_sort(cells, {}, [&](std::size_t cell) { return header[cell].size(); });
  for (const std::size_t cell : cells) {
    if (!named[cell]) continue;
    if (named[cell]->role == Role::velocity && !may_be_channel[cell]) continue;
    const auto channel = names.find(named[cell]->channel);
    if (channel && may_be_channel[*channel] && !roles[*channel]) {
      roles[cell] = {named[cell]->role, header[*channel]};
    }
  }
  for (std::size_t cell = 0; cell < header.size() && !chosen; ++cell) {
    if (!named[cell] || roles[cell] || named[cell]->role == Role::velocity) continue;
    std::vector<std::string> channels;
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (may_be_channel[i] && !named[i]) channels.push_back(header[i]);
    }
    throw column_of_unknown_channel(header[cell], named[cell]->channel, channels);
  }
  return roles;
}

std::vector<ColumnOfChannel> columns_of_channels(const Columns& columns, std::span<const std::string> header,
                                                 const std::vector<bool>& numeric, const std::vector<bool>& times) {
  const bool chosen = columns.has(Role::position);
  std::vector<bool> may_be_channel(header.size());
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const Role role = columns.cells[cell].role;
    const bool by_name = !chosen && role == Role::ignored && !times[cell] && numeric[cell];
    may_be_channel[cell] = role == Role::position || (by_name && role_of_name(header[cell]) == Role::position);
  }
  const auto roles = channel_roles(header, may_be_channel, chosen);
  std::vector<ColumnOfChannel> found;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (!roles[cell] || columns.cells[cell].role != Role::ignored) continue;
    found.push_back({cell, *roles[cell], header[cell], false});
  }
  return found;
}

void assign_channels(Columns& columns, const std::vector<ColumnOfChannel>& found) {
  const NameIndex channels(columns.channels);
  std::unordered_map<std::string, bool> taken;  // whether it was requested
  for (const auto& [cell, role, name, requested] : found) {
    const auto channel = channels.find(role.channel);
    if (!channel) {
      throw role_of_unknown_channel(role_name(role), role.channel, columns.channels).about(option::columns);
    }
    const std::string known = role_name(ChannelRole{role.role, columns.channels[*channel]});
    const auto [other, is_first] = taken.emplace(known, requested);
    if (!is_first && (requested || !other->second)) throw two_columns_for_role(known, name);
    columns.cells[cell] = {is_first ? role.role : Role::ignored, *channel};
  }
  if (!found.empty()) require_whole_velocities(columns);
}

std::optional<ChannelRole> near_channel_role(std::string_view name, const std::vector<std::string>& channels) {
  for (std::size_t at = name.find('_'); at != std::string_view::npos; at = name.find('_', at + 1)) {
    const std::string_view first = name.substr(0, at), second = name.substr(at + 1);
    for (const auto& [role, channel] : {std::pair{first, second}, std::pair{second, first}}) {
      const std::optional<Role> meant = tcb_role(role);
      if (!meant) continue;
      const auto found = std::ranges::find_if(
          channels, [&, &text = channel](const std::string& known) { return same_in_any_case(known, text); });
      if (found != channels.end()) return channel_role_of(std::string(role_name(*meant)) + "_" + *found);
    }
  }
  return std::nullopt;
}

bool assign_segments(Columns& columns, std::span<const std::string> header) {
  constexpr std::array endings{std::pair{"_p0", Role::position}, std::pair{"_v0", Role::velocity_out},
                               std::pair{"_p1", Role::end_position}, std::pair{"_v1", Role::end_velocity}};
  const auto start = std::ranges::find(header, "start"), duration = std::ranges::find(header, "duration");
  const bool are_named = start != header.end() && duration != header.end();
  if (!are_named || columns.has(Role::time) || columns.has(Role::position)) return false;
  const NameIndex names(header);
  std::vector<std::string> channels, incomplete;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (!header[cell].ends_with(endings[0].first) || columns.cells[cell].role == Role::unused) continue;
    const std::string channel = header[cell].substr(0, header[cell].size() - 3);
    const auto lacks = std::ranges::find_if(endings, [&](const auto& one) { return !names.find(channel + one.first); });
    if (std::ranges::count(channels, channel) > 0) throw same_column_names(header[cell]);
    (lacks == endings.end() ? channels : incomplete).push_back(channel);
    if (lacks != endings.end()) incomplete.push_back(channel + lacks->first);
  }
  if (channels.empty()) return false;
  if (!incomplete.empty()) throw segment_column_missing(incomplete[0] + endings[0].first, incomplete[1]);
  for (const std::string& channel : channels) {
    for (const auto& ending : endings) {
      columns.cells[*names.find(channel + ending.first)] = {ending.second, columns.channels.size()};
    }
    columns.channels.push_back(channel);
  }
  columns.cells[static_cast<std::size_t>(start - header.begin())].role = Role::time;
  columns.cells[static_cast<std::size_t>(duration - header.begin())].role = Role::duration;
  columns.time = "time";
  return columns.are_segments = true;
}

std::vector<RoleRequest> parse_roles(std::string_view text) {
  std::vector<RoleRequest> requests;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view name = part.substr(0, equals);
    const std::optional<Role> known = find_role(name);
    const std::optional<ChannelRole> of_channel = known ? std::nullopt : channel_role_of(name);
    if (equals == std::string::npos || equals + 1 == part.size() || !(known || of_channel)) {
      throw not_a_role_with_columns(part);
    }
    const auto columns = split(part.substr(equals + 1), ':');
    requests.push_back({known ? *known : of_channel->role, {columns.begin(), columns.end()}});
    if (of_channel) requests.back().channel = of_channel->channel;
  }
  return requests;
}

std::optional<std::string> near_miss(const std::string& name, const Columns& columns,
                                     std::span<const RoleRequest> requests, bool timeless) {
  if (std::ranges::count(requests, Role::position, &RoleRequest::role) > 0) return std::nullopt;
  if (const auto near = near_channel_role(name, columns.channels)) {
    const auto channel = std::ranges::find(columns.channels, near->channel);
    const auto index = static_cast<std::size_t>(channel - columns.channels.begin());
    const bool is_taken = std::ranges::any_of(columns.cells, [&](const Columns::Column& column) {
      return column.role == near->role && column.channel == index;
    });
    if (!is_taken) return role_name(*near);
  }
  const std::optional<Role> near = near_role(name);
  if (!near || columns.has(*near) || (timeless && *near == Role::time)) return std::nullopt;
  return std::string(role_name(*near));
}

void require_no_near_miss(std::span<const std::string> header, const Columns& columns,
                          std::span<const RoleRequest> requests, bool timeless) {
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (columns.cells[cell].role != Role::position) continue;
    const auto near = near_miss(header[cell], columns, requests, timeless);
    if (!near) continue;
    throw column_nearly_role(header[cell], *near);
  }
}

}  // namespace tcb
