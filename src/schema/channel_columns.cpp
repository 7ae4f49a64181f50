// Channel columns: the columns with the tension or a velocity of one channel, and those of segments.
#include "schema/channel_columns.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error segment_column_missing(std::string_view column, std::string_view missing_column) {
  return data_error(
      "the rows are segments and have a column {}, but no {}; expected both; add the missing "
      "column, or give {} {}",
      in_quotes(column), in_quotes(missing_column), option::columns, in_shell(fmt::format("ignore={}", column)));
}

Error velocity_column_missing(std::string_view column, std::string_view missing_column) {
  return data_error(
      "column {} gives the velocity on one side of a key, but there is no {} for the other "
      "side; expected both, or one column for both sides; add it, or give {} {}",
      in_quotes(column), in_quotes(missing_column), option::columns, in_shell(fmt::format("ignore={}", column)));
}

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

/// The columns with roles in one channel.
class RolesOfChannel {
 public:
  explicit RolesOfChannel(std::string_view channel) : channel_(channel) {}
  void add(Role role) { roles_.push_back(role); }

  /// Throws: Error (data) for a velocity of one side alone, or two of one side, or with tension, continuity or bias.
  void require_whole_velocities() const {
    const auto both = name(Role::velocity), in = name(Role::velocity_in), out = name(Role::velocity_out);
    if (both && (in || out))
      throw data_error(
          "columns {} and {} both give the velocity on the same side of a key; expected {} for "
          "both sides, or a column for each side; remove one, or give {} ignore=NAME",
          in_quotes(*both), in_quotes(in ? *in : *out), *both, option::columns);
    if (in && !out) throw velocity_column_missing(*in, with_role(Role::velocity_out));
    if (out && !in) throw velocity_column_missing(*out, with_role(Role::velocity_in));
    for (const Role role : {Role::channel_tension, Role::channel_continuity, Role::channel_bias}) {
      if (has_velocity() && name(role))
        throw data_error(
            "column {} gives velocities, so {} has no effect; expected velocities, or tension, "
            "continuity and bias; remove one of the columns, or give {} ignore=NAME",
            in_quotes(both ? *both : *in), in_quotes(*name(role)), option::columns);
    }
  }
  bool has_velocity() const { return name(Role::velocity) || name(Role::velocity_in); }

 private:
  std::string with_role(Role role) const { return role_name(ChannelRole{role, std::string(channel_)}); }
  std::optional<std::string> name(Role role) const {
    return std::ranges::count(roles_, role) > 0 ? std::optional(with_role(role)) : std::nullopt;
  }

  std::string_view channel_;
  std::vector<Role> roles_;
};

/// Throws: Error (data) for velocities that are not whole, and for tension, continuity or bias with the velocities of
/// all channels.
void require_whole_velocities(const Columns& columns) {
  const bool has_any = std::ranges::any_of(columns.cells, [](const auto& column) { return is_velocity(column.role); });
  if (!has_any) return;
  std::vector<RolesOfChannel> channels(columns.channels.begin(), columns.channels.end());
  for (const Columns::Column& column : columns.cells) {
    if (is_of_channel(column.role)) channels[column.channel].add(column.role);
  }
  bool has_all = true;
  for (const RolesOfChannel& channel : channels) {
    channel.require_whole_velocities();
    has_all = has_all && channel.has_velocity();
  }
  for (const Role role : {Role::tension, Role::continuity, Role::bias}) {
    if (has_all && columns.has(role))
      throw data_error(
          "all channels have velocities, so the column of {} has no effect; expected velocities, "
          "or tension, continuity and bias; remove the column, or give {} ignore=NAME",
          role_name(role), option::columns);
  }
}

/// For each column, its role in one channel, if its name has one: that of a column that may be a channel. `chosen`: the
/// channels were requested. Throws: Error (data) for a name such as "tension_q" where there is no q, unless `chosen`;
/// but "q_v" is then any other name.
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
    throw data_error(
        "column {} names a channel {}, which does not exist; expected one of "
        "{}; correct the name, or name the channels with {} position=NAME:NAME",
        in_quotes(header[cell]), in_quotes(named[cell]->channel), listed(channels), option::columns);
  }
  return roles;
}

}  // namespace

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
      throw data_error(
          "the role {} names a channel {}, which does not exist; expected one of the "
          "channels {}; correct the role",
          role_name(role), in_quotes(role.channel), listed(columns.channels))
          .about(option::columns);
    }
    const std::string known = role_name(ChannelRole{role.role, columns.channels[*channel]});
    const auto [other, is_first] = taken.emplace(known, requested);
    if (!is_first && (requested || !other->second)) throw two_columns_for_role(known, name);
    columns.cells[cell] = {is_first ? role.role : Role::ignored, *channel};
  }
  if (!found.empty()) require_whole_velocities(columns);
}

bool assign_segments(Columns& columns, std::span<const std::string> header) {
  constexpr std::array endings{std::pair{"_p0", Role::position}, std::pair{"_v0", Role::velocity_out},
                               std::pair{"_p1", Role::end_position}, std::pair{"_v1", Role::end_velocity}};
  const auto start = std::ranges::find(header, "start"), duration = std::ranges::find(header, "duration");
  const bool are_named = start != header.end() && duration != header.end();
  if (!are_named || columns.has(Role::time) || columns.has(Role::position)) return false;
  const NameIndex names(header);
  std::vector<std::string> channels, incomplete;
  std::unordered_set<std::string> seen;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (!header[cell].ends_with(endings[0].first) || columns.cells[cell].role == Role::unused) continue;
    const std::string channel = header[cell].substr(0, header[cell].size() - 3);
    const auto lacks = std::ranges::find_if(endings, [&](const auto& one) { return !names.find(channel + one.first); });
    if (!seen.insert(channel).second) throw same_column_names(header[cell]);
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

}  // namespace tcb
