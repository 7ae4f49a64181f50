// Columns: the meaning of the cells of all records of an input.
//
// find_columns() gives roles in this order, and none takes a column from one before: those that are requested; a
// time in two columns; roles in one channel, by names such as x_v; all others by name, and the rest as positions. Then
// it numbers the texts and names what is ignored.
#include "schema/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <iterator>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

std::string request_of(std::string_view role, std::span<const std::string> header, std::size_t cell) {
  return requested_as(role, header, {&cell, 1});
}

Error two_times(std::string_view column, std::string_view other_column, std::string_view request,
                std::string_view other_request) {
  return data_error("both {} and {} may be the time; expected one column of times; give --columns {} or --columns {}",
                    in_quotes(column), in_quotes(other_column), in_shell(request), in_shell(other_request));
}

/// Finds names: exactly, or else in another case.
class NameIndex {
 public:
  explicit NameIndex(std::span<const std::string> names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!exact_.emplace(names[i], i).second) repeated_.insert(names[i]);
      other_.emplace(in_lower_case(names[i]), i);
    }
  }

  std::optional<std::size_t> find(const std::string& name) const {
    if (const auto found = exact_.find(name); found != exact_.end()) return found->second;
    const auto found = other_.find(in_lower_case(name));
    return found == other_.end() ? std::nullopt : std::optional(found->second);
  }
  bool repeats(const std::string& name) const { return repeated_.contains(name); }

 private:
  std::unordered_map<std::string, std::size_t> exact_, other_;
  std::unordered_set<std::string> repeated_;
};

/// The cell of a requested column, by name or number.
std::size_t find_cell(const std::string& wanted, std::string_view option, std::span<const std::string> header,
                      const NameIndex& named, std::size_t cells) {
  if (named.repeats(wanted)) throw same_column_names(wanted);
  if (const auto cell = named.find(wanted)) return *cell;
  const std::size_t number = in_digits<std::size_t>(wanted).value_or(0);
  if (number >= 1 && number <= cells) return number - 1;
  if (const auto cell = find_without_unit(header, wanted)) return *cell;
  if (header.empty()) throw no_such_column_number(wanted, cells).about(option);
  throw no_such_column(wanted, header).about(option);
}

/// The cells of requested columns: of one, or of a range of numbers such as "2-4" that is no name.
std::vector<std::size_t> find_cells(const std::string& wanted, std::string_view option,
                                    std::span<const std::string> header, const NameIndex& named, std::size_t cells) {
  const std::size_t dash = wanted.find('-');
  if (dash != std::string::npos && !named.find(wanted)) {
    const std::size_t first = in_digits<std::size_t>(wanted.substr(0, dash)).value_or(0);
    const std::size_t last = in_digits<std::size_t>(wanted.substr(dash + 1)).value_or(0);
    if (first >= 1 && first <= last && last <= cells) {
      std::vector<std::size_t> range(last - first + 1);
      std::iota(range.begin(), range.end(), first - 1);
      return range;
    }
  }
  return {find_cell(wanted, option, header, named, cells)};
}

/// Sets the role of a cell. Throws: Error if it has another.
void assign(Columns& columns, std::size_t cell, Role role, const std::string& name) {
  if (columns.cells[cell].role != Role::ignored)
    throw data_error("column {} has two roles; expected one; correct --columns", in_quotes(name));
  std::vector<std::string>* const several = role == Role::position ? &columns.channels
                                            : role == Role::group  ? &columns.groups
                                            : role == Role::carry  ? &columns.labels
                                                                   : nullptr;
  const bool may_repeat = is_of_channel(role) || role == Role::unused || role == Role::clock;
  if (several == nullptr && !may_repeat && columns.has(role)) {
    throw two_columns_for_role(role_name(role), name);
  }
  const std::size_t clocks = role == Role::clock ? columns.time_cells().size() : 0;  // with the date
  constexpr std::size_t most = 5;                                                    // below a year
  if (clocks > most)
    throw data_error(
        "the time has more than six columns; expected a date and a time of day, or a year, a month and a day, with an "
        "hour, a minute and a second if there are such; correct --columns time=");
  columns.cells[cell] = {role, several == nullptr ? clocks : several->size()};
  if (several != nullptr) several->push_back(name);
  if (role == Role::time) columns.time = name;
  if (clocks > 1) columns.time = "time";  // and no longer the year
}

/// The texts of a key are those of its groups, then its labels.
void number_texts(Columns& columns) {
  for (Columns::Column& column : columns.cells) {
    if (column.role == Role::carry) column.channel += columns.groups.size();
  }
}

/// Throws: Error (data) for a velocity of one side of a key alone, two of one side, and for tension, continuity or bias
/// with the velocities of a channel, or of all channels.
void require_whole_velocities(const Columns& columns) {
  std::vector<std::bitset<role_count>> roles(columns.channels.size());  // of each channel
  bool has_any = false;
  for (const Columns::Column& column : columns.cells) {
    if (is_of_channel(column.role)) roles[column.channel].set(static_cast<std::size_t>(column.role));
    has_any = has_any || is_velocity(column.role);
  }
  if (!has_any) return;
  bool have_all = true;
  for (std::size_t channel = 0; channel < roles.size(); ++channel) {
    const auto has = [&](Role role) { return roles[channel][static_cast<std::size_t>(role)]; };
    const auto name = [&](Role role) { return role_name(ChannelRole{role, columns.channels[channel]}); };
    const auto require_both = [&](Role role, Role other) {
      if (!has(role) || has(other)) return;
      throw data_error(
          "column {} gives the velocity on one side of a key, but there is no {} for the other side; expected both, or "
          "one column for both sides; add it, or give --columns {}",
          in_quotes(name(role)), in_quotes(name(other)), in_shell(fmt::format("ignore={}", name(role))));
    };
    const bool has_both = has(Role::velocity), has_in = has(Role::velocity_in);
    if (has_both && (has_in || has(Role::velocity_out)))
      throw data_error(
          "columns {} and {} both give the velocity on the same side of a key; expected {} for both sides, or a column "
          "for each side; remove one, or give --columns ignore=NAME",
          in_quotes(name(Role::velocity)), in_quotes(name(has_in ? Role::velocity_in : Role::velocity_out)),
          name(Role::velocity));
    require_both(Role::velocity_in, Role::velocity_out);
    require_both(Role::velocity_out, Role::velocity_in);
    have_all = have_all && (has_both || has_in);
    for (const Role role : {Role::channel_tension, Role::channel_continuity, Role::channel_bias}) {
      if ((has_both || has_in) && has(role))
        throw data_error(
            "column {} gives velocities, so {} has no effect; expected velocities, or tension, continuity and bias; "
            "remove one of the columns, or give --columns ignore=NAME",
            in_quotes(name(has_both ? Role::velocity : Role::velocity_in)), in_quotes(name(role)));
    }
  }
  for (const Role role : {Role::tension, Role::continuity, Role::bias}) {
    if (have_all && columns.has(role))
      throw data_error(
          "all channels have velocities, so the column of {} has no effect; expected velocities, or tension, "
          "continuity and bias; remove the column, or give --columns ignore=NAME",
          role_name(role));
  }
}

/// A column with a role in one channel, which is known once all channels are.
struct ColumnOfChannel {
  std::size_t cell;
  ChannelRole role;
  std::string name;
  bool requested;
};

/// The name of the role of all channels that corresponds to one of a channel.
std::string_view common_role(Role role) {
  return role_name(role == Role::channel_tension      ? Role::tension
                   : role == Role::channel_continuity ? Role::continuity
                                                      : Role::bias);
}

/// The columns that have such a role by their names: in a column that may be a channel. `times`: for each column,
/// whether it is the time by its name; `chosen`: the positions are requested by an option. Throws: Error (data) for a
/// name such as "tension_q" where there is no q, unless `chosen`; but "q_v" is then any other name.
std::vector<ColumnOfChannel> columns_of_channels(const Columns& columns, std::span<const std::string> header,
                                                 const std::vector<bool>& numeric, const std::vector<bool>& times,
                                                 bool chosen) {
  std::vector<std::optional<ChannelRole>> named;
  std::ranges::transform(header, std::back_inserter(named), channel_role_of);
  if (std::ranges::none_of(named, [](const auto& role) { return role.has_value(); })) return {};
  std::vector<bool> may_be_channel(header.size());
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const Role role = columns.cells[cell].role;
    const bool by_name = !chosen && role == Role::ignored && !times[cell] && numeric[cell];
    may_be_channel[cell] = role == Role::position || (by_name && role_of_name(header[cell]) == Role::position);
  }
  const NameIndex names(header);
  std::vector<std::size_t> cells(header.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  // The column of a channel has a shorter name than those with a role in it.
  std::ranges::stable_sort(cells, {}, [&](std::size_t cell) { return header[cell].size(); });
  std::vector<std::optional<std::size_t>> channels(header.size());  // the cell of the channel of each
  for (const std::size_t cell : cells) {
    if (!named[cell] || (named[cell]->role == Role::velocity && !may_be_channel[cell])) continue;
    const auto channel = names.find(named[cell]->channel);
    if (channel && may_be_channel[*channel] && !channels[*channel]) channels[cell] = channel;
  }
  std::vector<ColumnOfChannel> found;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    if (!named[cell] || columns.cells[cell].role != Role::ignored) continue;
    if (channels[cell]) {
      found.push_back({cell, {named[cell]->role, header[*channels[cell]]}, header[cell], false});
    } else if (!chosen && named[cell]->role != Role::velocity) {
      constexpr std::size_t most = 12;
      std::vector<std::string> possible;
      std::vector<std::size_t> all;  // the column may be a channel of its own
      std::vector<std::string> roles;
      for (std::size_t i = 0; i < header.size(); ++i) {
        const bool is_alike = named[i] && named[i]->channel == named[cell]->channel && !is_velocity(named[i]->role);
        if (is_alike) roles.push_back(requested_as(common_role(named[i]->role), header, {&i, 1}));
        if (may_be_channel[i] && !named[i]) possible.push_back(header[i]);
        if (may_be_channel[i] && !channels[i]) all.push_back(i);
      }
      throw data_error(
          "column {} names a channel {}, which does not exist; expected {}; correct the name, {}or name the channels "
          "with --columns {}",
          in_quotes(header[cell]), in_quotes(named[cell]->channel),
          possible.empty() ? "a column of that name" : "one of " + listed(possible),
          roles.empty()
              ? ""
              : fmt::format("give --columns {} for all channels, ", in_shell(fmt::format("{}", fmt::join(roles, ",")))),
          all.size() > most ? "position=NAME:NAME" : in_shell(requested_as("position", header, all)));
    }
  }
  return found;
}

/// Sets the channels of columns with a role in one. A requested column has priority over others. Throws: Error (data)
/// for two columns with one role, for an unknown channel, and for velocities of one side alone or with tension.
void assign_channels(Columns& columns, const std::vector<ColumnOfChannel>& found) {
  const NameIndex channels(columns.channels);
  std::unordered_map<std::string, bool> taken;  // whether it was requested
  for (const auto& [cell, role, name, requested] : found) {
    const auto channel = channels.find(role.channel);
    if (!channel) {
      throw data_error(
          "the role {} names a channel {}, which does not exist; expected one of the channels {}; correct the role",
          role_name(role), in_quotes(role.channel), listed(columns.channels))
          .about("--columns");
    }
    const std::string known = role_name(ChannelRole{role.role, columns.channels[*channel]});
    const auto [other, is_first] = taken.emplace(known, requested);
    if (!is_first && (requested || !other->second)) throw two_columns_for_role(known, name);
    columns.cells[cell] = {is_first ? role.role : Role::ignored, *channel};
  }
  if (!found.empty()) require_whole_velocities(columns);
}

/// The cells of a time in two columns.
struct SplitTime {
  std::size_t seconds, nanoseconds;
  std::string stem;  ///< of their names
};

/// The times whose whole seconds and nanoseconds are columns of numbers, as in header.stamp.sec and
/// header.stamp.nanosec.
std::vector<SplitTime> split_times(std::span<const std::string> header, const std::vector<bool>& numeric) {
  std::unordered_map<std::string_view, std::size_t> seconds;  // by the stem of their names
  std::vector<SplitTime> times;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const auto part = time_part_of(header[cell]);
    if (part && part->part == TimePart::seconds) seconds.emplace(part->stem, cell);
    if (part && part->part == TimePart::nanoseconds && numeric[cell])
      times.push_back({0, cell, std::string(part->stem)});
  }
  std::erase_if(times, [&](SplitTime& time) {
    const auto found = seconds.find(time.stem);
    if (found != seconds.end()) time.seconds = found->second;
    return found == seconds.end() || !numeric[found->second];
  });
  return times;
}

/// Takes the time that is in two columns. Throws: Error (data) if another column may be the time as well. If a time is
/// requested, these columns are ignored, unless they have roles.
void assign_split_time(Columns& columns, std::span<const std::string> header, const std::vector<bool>& numeric,
                       bool timeless) {
  const std::vector<SplitTime> times = split_times(header, numeric);
  if (times.empty()) return;
  const auto is_part = [&](std::size_t cell) {
    return std::ranges::any_of(times, [&](const auto& t) { return t.seconds == cell || t.nanoseconds == cell; });
  };
  if (columns.has(Role::time) || timeless) {
    for (const auto& [seconds, nanoseconds, stem] : times) {
      for (const std::size_t cell : {seconds, nanoseconds}) {
        if (columns.cells[cell].role == Role::ignored) columns.cells[cell].role = Role::unused;
      }
    }
    return;
  }
  const auto both_of = [&](const SplitTime& time) {
    return request_of("time", header, time.seconds) + "," + request_of("nanoseconds", header, time.nanoseconds);
  };
  if (times.size() > 1) {
    throw two_times(header[times[0].seconds], header[times[1].seconds], both_of(times[0]), both_of(times[1]));
  }
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const std::string& name = header[cell];
    const bool is_usual = numeric[cell] && is_usual_time(name) && !is_usual_counter(name);
    const bool may_be_time =
        columns.cells[cell].role == Role::ignored && (is_usual || role_of_name(name) == Role::time);
    if (!may_be_time || is_part(cell)) continue;
    throw two_times(name, header[times[0].seconds], request_of("time", header, cell), both_of(times[0]));
  }
  assign(columns, times[0].seconds, Role::time, times[0].stem.empty() ? "time" : times[0].stem);
  assign(columns, times[0].nanoseconds, Role::nanoseconds, header[times[0].nanoseconds]);
}

/// For each column, whether it is the time by one of the usual names, among which those of columns of numbers come
/// first. None is where a time is requested, or a column has a name such as "time".
std::vector<bool> usual_times(const Columns& columns, std::span<const std::string> header,
                              const std::vector<bool>& numeric) {
  std::vector<bool> numbers(header.size()), texts(header.size());
  bool any_numbers = false;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const Role role = columns.cells[cell].role;
    if (role == Role::time || (role == Role::ignored && role_of_name(header[cell]) == Role::time))
      return std::vector<bool>(header.size());
    texts[cell] = role == Role::ignored && is_usual_time(header[cell]);
    numbers[cell] = texts[cell] && numeric[cell];
    any_numbers = any_numbers || numbers[cell];
  }
  return any_numbers ? numbers : texts;
}

/// The first channel, as it can be requested, if it comes first among the columns of numbers and might be the time: by
/// any name but those of coordinates, or as x beside a single y.
std::string likely_time(const Columns& columns, std::span<const std::string> header) {
  if (header.empty() || columns.has(Role::time) || columns.channels.size() < 2) return "";
  const auto first = std::ranges::find_if(columns.cells, [](const auto& column) {
    return column.role != Role::ignored && column.role != Role::group && column.role != Role::carry;
  });
  const bool are_x_and_y = columns.channels == std::vector<std::string>{"x", "y"};
  const bool is_likely = first->role == Role::position && (are_x_and_y || !is_coordinate(columns.channels[0]));
  return is_likely ? requested_as(columns.channels[0], static_cast<std::size_t>(first - columns.cells.begin())) : "";
}

/// The columns of a header in which names are repeated, by their numbers, as a request: parameters that follow each
/// channel are those of this channel.
std::string request_by_numbers(const Columns& columns, std::span<const std::string> header,
                               const std::vector<bool>& numeric, const std::vector<bool>& usual) {
  std::string roles, positions, channel;
  for (std::size_t cell = 0; cell < header.size(); ++cell) {
    const Role role = usual[cell] ? Role::time : role_of_name(header[cell]);
    const std::string number = fmt::format("{}", cell + 1);
    const bool is_tcb = role == Role::tension || role == Role::continuity || role == Role::bias;
    if (!numeric[cell] || columns.cells[cell].role == Role::unused || is_usual_counter(header[cell])) continue;
    if (role == Role::position) {
      channel = header[cell];
      positions += (positions.empty() ? "position=" : ":") + number;
    } else if (!channel.empty() || !is_tcb) {
      const std::string name(role_name(role));
      roles += fmt::format(",{}={}", is_tcb ? fmt::format("{}_{}", name, channel) : name, number);
    }
  }
  return in_shell(positions + roles);
}

/// Roles by name, or without a header time first; positions only where none were requested. `times_only`: no other one.
void assign_the_rest(Columns& columns, std::span<const std::string> header, const std::vector<bool>& numeric,
                     const std::vector<bool>& usual, bool timeless, bool times_only = false) {
  const bool positions_given = columns.has(Role::position);
  const auto requested = columns.cells;
  std::array<bool, role_count> is_requested{};
  for (const Columns::Column& column : requested) is_requested[static_cast<std::size_t>(column.role)] = true;
  const auto is_text = [](const auto& column) {
    return column.role == Role::group || column.role == Role::carry || column.role == Role::unused;
  };
  const auto front = static_cast<std::size_t>(std::ranges::find_if_not(requested, is_text) - requested.begin());
  std::unordered_set<std::string_view> names;
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    if (requested[cell].role != Role::ignored) continue;
    const bool first = cell == front && !timeless && !columns.has(Role::time);
    const bool is_time = header.empty() ? first : usual[cell];
    columns.has_time_by_place = columns.has_time_by_place || (header.empty() && first);
    const Role role = is_time ? Role::time : header.empty() ? Role::position : role_of_name(header[cell]);
    if (times_only && role != Role::time) continue;
    const bool has_request = is_requested[static_cast<std::size_t>(role)];
    columns.cells[cell].is_text = role == Role::position && !positions_given && !numeric[cell];
    if (role == Role::position ? positions_given || !numeric[cell] : has_request) continue;
    if (role == Role::position && !header.empty() && is_usual_counter(header[cell])) continue;
    if (role == Role::position && !header.empty() && tells_curves_apart(header[cell])) {
      throw data_error(
          "column {} looks like a label, not a position; expected its role; give --group {} for one curve per value, "
          "--columns {} to keep it in the rows, or --columns {} to leave it out; --columns position=NAME:NAME takes it "
          "as a position, and --angle NAME=degrees as an angle",
          in_quotes(header[cell]), in_shell(requested_as(header, cell)), in_shell(request_of("carry", header, cell)),
          in_shell(request_of("ignore", header, cell)));
    }
    if (role == Role::time && columns.has(Role::time)) {
      const auto other = std::ranges::find(columns.cells, Role::time, &Columns::Column::role);
      throw two_times(columns.time, header[cell],
                      request_of("time", header, static_cast<std::size_t>(other - columns.cells.begin())),
                      request_of("time", header, cell));
    }
    const bool is_second = role != Role::time && !header.empty() && !names.insert(header[cell]).second;
    if (is_second && !times_only) {
      throw data_error(
          "two columns are called {}; expected different names; rename one, or give --columns {} for columns by number",
          in_quotes(header[cell]), request_by_numbers(columns, header, numeric, usual));
    }
    assign(columns, cell, role, header.empty() ? fmt::format("{}", cell + 1) : header[cell]);
  }
}

}  // namespace

bool Columns::has(Role role) const {
  return std::ranges::any_of(cells, [&](const Column& column) { return column.role == role; });
}

std::vector<std::string> Columns::shape_roles() const {
  std::vector<std::string> roles;
  for (const Role role : {Role::tension, Role::continuity, Role::bias, Role::ease_in, Role::ease_out}) {
    if (has(role)) roles.emplace_back(role_name(role));
  }
  for (const Column& column : cells) {
    if (is_of_channel(column.role)) roles.push_back(name_of(column));
  }
  return roles;
}

std::string Columns::name_of(const Column& column) const {
  switch (column.role) {
    case Role::time: return time;
    case Role::position: return channels[column.channel];
    case Role::group: return groups[column.channel];
    case Role::carry: return labels[column.channel - groups.size()];
    default:
      if (is_of_channel(column.role)) return role_name(ChannelRole{column.role, channels[column.channel]});
      return std::string(role_name(column.role));
  }
}

namespace {

/// The columns with the requested roles; those in one channel are also added to `of_channels`.
Columns requested_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                          std::span<const RoleRequest> requests, std::vector<ColumnOfChannel>& of_channels) {
  Columns columns;
  columns.cells.resize(numeric.size());
  columns.named = !header.empty();
  const NameIndex named(requests.empty() ? std::span<const std::string>{} : header);
  for (const RoleRequest& request : requests) {
    std::size_t before = 0;  // columns of the request
    for (const std::string& name : request.columns) {
      for (const std::size_t cell : find_cells(name, request.option, header, named, numeric.size())) {
        const bool is_first = before++ == 0;
        const Role role = columns.cells[cell].role;
        if (request.unless_taken && (request.option.empty() ? role != Role::ignored : role == request.role)) continue;
        if (is_of_channel(request.role)) of_channels.push_back({cell, {request.role, request.channel}, name, true});
        const bool is_text = request.role == Role::group || request.role == Role::carry;
        assign(columns, cell, request.role == Role::time && !is_first ? Role::clock : request.role,
               !header.empty() ? header[cell] : fmt::format("{}{}", is_text ? "column" : "", cell + 1));
      }
    }
  }
  return columns;
}

}  // namespace

Columns find_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                     std::span<const RoleRequest> requests, bool timeless) {
  std::vector<ColumnOfChannel> of_channels;
  Columns columns = requested_columns(header, numeric, requests, of_channels);
  std::vector<bool> is_unused;  // on request
  for (const Columns::Column& column : columns.cells) is_unused.push_back(column.role == Role::unused);
  assign_split_time(columns, header, numeric, timeless);
  const auto usual = timeless ? std::vector<bool>(header.size()) : usual_times(columns, header, numeric);
  const bool chosen = std::ranges::any_of(
      requests, [](const RoleRequest& request) { return request.role == Role::position && !request.option.empty(); });
  for (ColumnOfChannel& column : columns_of_channels(columns, header, numeric, usual, chosen)) {
    columns.cells[column.cell].role = column.role.role;
    of_channels.push_back(std::move(column));
  }
  assign_the_rest(columns, header, numeric, usual, timeless);
  number_texts(columns);
  for (Columns::Column& column : columns.cells) {
    if (column.role == Role::unused) column.role = Role::ignored;
  }
  const bool positions_given = std::ranges::count(requests, Role::position, &RoleRequest::role) > 0;
  if (!timeless && !positions_given) columns.likely_time = likely_time(columns, header);
  if (header.empty() && !columns.channels.empty()) {
    columns.time = "t";
    columns.channels = default_channel_names(columns.channels.size());
  }
  assign_channels(columns, of_channels);
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    if (columns.cells[cell].role != Role::ignored) continue;
    if (is_unused[cell]) continue;
    columns.ignored.push_back(header.empty() ? fmt::format("column {}", cell + 1) : header[cell]);
  }
  if (columns.channels.empty()) {
    std::vector<std::string> texts;
    bool has_other_numbers = false;
    for (std::size_t cell = 0; cell < numeric.size(); ++cell) {
      has_other_numbers = has_other_numbers || (numeric[cell] && columns.cells[cell].role != Role::time);
      if (columns.cells[cell].is_text && !header.empty()) texts.push_back(header[cell]);
    }
    const bool has_numbers = std::ranges::count(numeric, true) > 0;
    throw data_error(
        "there is no position column; expected at least one column of numbers besides the time; {}",
        has_other_numbers               ? std::string("name it with --columns position=NAME")
        : has_numbers && !texts.empty() ? fmt::format("there are none in {}; correct the first cells", listed(texts))
        : has_numbers && numeric.size() == 1
            ? fmt::format(
                  "give {}--parameter uniform if the only column is a position",
                  header.empty() ? "" : fmt::format("--columns {} ", in_shell(request_of("position", header, 0))))
            : std::string("write the numbers alone, with delimiters between them"));
  }
  return columns;
}

Columns find_time_column(std::span<const std::string> header, const std::vector<bool>& numeric,
                         std::span<const RoleRequest> requests) {
  const NameIndex named(header);
  const auto is_there = [&](const std::string& name) {
    const std::size_t number = header.empty() ? in_digits<std::size_t>(name).value_or(0) : 0;
    return named.find(name) || (number >= 1 && number <= numeric.size());
  };
  std::vector<RoleRequest> present;
  std::ranges::copy_if(requests, std::back_inserter(present), [&](const RoleRequest& request) {
    return request.role != Role::group || std::ranges::all_of(request.columns, is_there);
  });
  Columns columns = requested_columns(header, numeric, present);
  assign_split_time(columns, header, numeric, false);
  assign_the_rest(columns, header, numeric, usual_times(columns, header, numeric), false, true);
  if (!columns.has(Role::time)) throw data_error("no column is the time by its name; expected one called time");
  for (Columns::Column& column : columns.cells) {
    if (column.role == Role::ignored || column.role == Role::unused) column = {};
  }
  return columns;
}

Columns requested_columns(std::span<const std::string> header, const std::vector<bool>& numeric,
                          std::span<const RoleRequest> requests) {
  std::vector<ColumnOfChannel> none;
  return requested_columns(header, numeric, requests, none);
}

std::string requested_as(std::span<const std::string> names, std::size_t cell) {
  const bool is_named = cell < names.size() && std::ranges::count(names, names[cell]) == 1;
  return requested_as(is_named ? std::string_view(names[cell]) : "", cell);
}

ColumnRequests::ColumnRequests(std::span<const std::string> names) : names_(names) {
  for (const std::string& name : names) ++counts_[name];
}

std::string ColumnRequests::operator[](std::size_t cell) const {
  const bool is_named = cell < names_.size() && counts_.at(names_[cell]) == 1;
  return requested_as(is_named ? std::string_view(names_[cell]) : "", cell);
}

std::vector<std::size_t> Columns::time_cells() const {
  std::vector<std::size_t> found;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (cells[cell].role == Role::time || cells[cell].role == Role::clock) found.push_back(cell);
  }
  const auto place = [&](std::size_t cell) { return cells[cell].role == Role::time ? 0 : cells[cell].channel + 1; };
  std::ranges::sort(found, {}, place);
  return found;
}

std::string requested_as(std::string_view role, std::span<const std::string> names,
                         std::span<const std::size_t> cells) {
  const ColumnRequests requests(names);
  std::vector<std::string> columns;
  for (const std::size_t cell : cells) columns.push_back(requests[cell]);
  return fmt::format("{}={}", role, fmt::join(columns, ":"));
}

std::string requested_as(std::string_view name, std::size_t cell) {
  std::string number = fmt::format("{}", cell + 1);
  const bool is_clear =
      !name.empty() && name.find_first_of(":,") == std::string_view::npos && name != "column " + number;
  return is_clear ? std::string(name) : number;
}

std::vector<std::string> default_channel_names(std::size_t channels) {
  if (channels <= 3) {
    const std::vector<std::string> names{"x", "y", "z"};
    return {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(channels)};
  }
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= channels; ++i) names.push_back(fmt::format("p{}", i));
  return names;
}

std::optional<TimesInWords> only_times_in_words(std::span<const std::string_view> record) {
  std::vector<std::size_t> dates, others;
  for (std::size_t cell = 0; cell < record.size(); ++cell) {
    if (const auto found = find_notation(record[cell])) (is_date(*found) ? dates : others).push_back(cell);
  }
  const std::vector<std::size_t>& times = dates.empty() ? others : dates;
  return times.size() == 1 ? std::optional(TimesInWords{times[0], !dates.empty()}) : std::nullopt;
}

std::string times_in_words_are_taken(const TimesInWords& times, std::string_view shown) {
  return fmt::format("the {} in column {} are taken as the times", times.are_dates ? "dates" : "texts", shown);
}

std::string only_time_is_taken(std::string_view shown) {
  return fmt::format("column {} is taken as the time, as no other one is", shown);
}

Error same_column_names(std::string_view name) {
  return data_error(
      "two columns are called {}; expected different names; rename one, or choose columns by number with --columns",
      in_quotes(name));
}

Error no_such_column(std::string_view name, std::span<const std::string> columns) {
  return data_error("there is no column {}; expected one of {}", in_quotes(name), listed(columns));
}

Error no_such_column_number(std::string_view number, std::size_t column_count) {
  return data_error("there is no column {}; the columns have no names; expected a number from 1 to {}",
                    in_quotes(number), column_count);
}

Error two_columns_for_role(std::string_view role, std::string_view second_column) {
  return data_error(
      "a second column, {}, has the role {}; expected one column with it; choose one with --columns {}=NAME",
      in_quotes(second_column), role, role);
}

}  // namespace tcb
