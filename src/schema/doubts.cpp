// Doubts: what an input may mean besides what was found in it, as one list.
#include "schema/doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "numbers/time_notation.hpp"
#include "option_names.hpp"
#include "schema/near_misses.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// What the rows of the list ask.

bool is_requested(const FoundColumns& found, Role role) {
  return std::ranges::count(found.requested.roles, role, &RoleRequest::role) > 0;
}

/// A column as it can be requested: its name, or the number from 1 of one without a name.
std::string request_of(const FoundColumns& found, std::size_t cell) {
  const bool is_named = cell < found.names.size() && !found.names[cell].empty() &&
                        std::ranges::count(found.names, found.names[cell]) == 1;
  return is_named ? found.names[cell] : fmt::format("{}", cell + 1);
}

/// A column as messages show it.
std::string shown(const FoundColumns& found, std::size_t cell) {
  return found.names.empty() ? fmt::format("column {}", cell + 1) : in_quotes(found.names[cell]);
}

/// A value of --columns with the role and all these columns.
std::string roles_of(const FoundColumns& found, std::string_view role, const std::vector<std::size_t>& cells) {
  std::vector<std::string> names;
  for (const std::size_t cell : cells) names.push_back(request_of(found, cell));
  return in_shell(fmt::format("{}={}", role, fmt::join(names, ":")));
}

double number_in(const FoundColumns& found, const std::vector<std::string_view>& row, std::size_t cell) {
  return cell < row.size() ? Decimals(found.marks).number(row[cell]).value_or(nan) : nan;
}

std::vector<std::size_t> cells_with(const FoundColumns& found, Role role) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < found.columns.cells.size(); ++cell) {
    if (found.columns.cells[cell].role == role) cells.push_back(cell);
  }
  return cells;
}

/// The columns of numbers that are no time: all that may be positions.
std::vector<std::size_t> possible_positions(const FoundColumns& found) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < found.columns.cells.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    const bool is_other = role == Role::time || role == Role::nanoseconds || role == Role::clock ||
                          role == Role::group || role == Role::carry || role == Role::ignored;
    if (found.numeric[cell] && !is_other) cells.push_back(cell);
  }
  return cells;
}

/// A value of --columns with all columns that may be positions, or how to give it where these are many.
std::string positions_of(const FoundColumns& found) {
  constexpr std::size_t most = 12;
  const std::vector<std::size_t> cells = possible_positions(found);
  return cells.size() <= most ? roles_of(found, "position", cells) : "position=NAME:NAME";
}

constexpr std::array tcb_roles{Role::tension, Role::continuity, Role::bias};

/// What a row of the list says.
struct Doubt {
  bool is_error = false;
  std::string text = {};
};
using Found = std::optional<Doubt>;

template <class... Arguments>
Doubt note(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  return {false, fmt::format(text, std::forward<Arguments>(arguments)...)};
}

template <class... Arguments>
Doubt error(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  return {true, fmt::format(text, std::forward<Arguments>(arguments)...)};
}

// The rows about columns.

Found near_miss_of_role(const FoundColumns& found) {
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    const std::string& name = found.names[cell];
    if (role != Role::position && (role != Role::ignored || !found.numeric[cell])) continue;
    if (std::ranges::count(found.meant, name) > 0) continue;
    const auto near = near_miss(name, found.columns, found.requested.roles, found.requested.timeless);
    if (!near) continue;
    return error(
        "column {} would be a channel, but its name is close to the role {}; expected {}, or a name that is not close "
        "to it; rename the column, or give {} {} if it has this role, or {} {} if it has not",
        in_quotes(name), *near, *near, option::columns, roles_of(found, *near, {cell}), option::columns,
        positions_of(found));
  }
  return std::nullopt;
}

/// Columns such as x^0 and x^1 beside a duration, as --emit poly and the format crazyswarm write pieces.
Found coefficients_of_pieces(const FoundColumns& found) {
  const auto is_of_power = [&](std::string_view power) {
    return std::ranges::any_of(found.names, [&](const std::string& name) { return name.ends_with(power); });
  };
  if (std::ranges::count(found.names, "duration") == 0 || !is_of_power("^0") || !is_of_power("^1")) return std::nullopt;
  if (is_requested(found, Role::position)) return std::nullopt;
  return error(
      "the columns are coefficients of pieces, which {} poly writes; expected keys; give the keys that the pieces were "
      "made of, pieces that {} hermite writes, or {} for keys with these channels",
      option::emit, option::emit, option::columns);
}

Found letters_that_are_data(const FoundColumns& found) {
  if (is_requested(found, Role::position) || found.names.empty()) return std::nullopt;
  std::vector<std::string> letters;
  for (const std::string& channel : found.columns.channels) {
    if (std::ranges::count(tcb_roles, role_of_name(channel)) > 0) letters.push_back(channel);
  }
  if (letters.empty()) return std::nullopt;
  return note(
      "positions by a single letter: {}; only T, C and B together are tension, continuity and bias; {} {}={} gives the "
      "role",
      listed(letters), option::columns, role_name(role_of_name(letters[0])), letters[0]);
}

/// Columns that are parameters by their names.
std::vector<std::size_t> parameters_by_name(const FoundColumns& found) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    const bool is_parameter = std::ranges::count(tcb_roles, role) > 0 || role == Role::channel_tension ||
                              role == Role::channel_continuity || role == Role::channel_bias;
    const bool is_by_request =
        std::ranges::any_of(found.requested.roles, [&](const RoleRequest& request) { return request.role == role; });
    const bool is_meant = std::ranges::count(found.meant, found.names[cell]) > 0;
    if (is_parameter && !is_by_request && !is_meant) cells.push_back(cell);
  }
  return cells;
}

Found parameters_that_are_data(const FoundColumns& found) {
  if (found.has_tcb_scale || found.columns.are_segments) return std::nullopt;
  const std::vector<std::size_t> cells = parameters_by_name(found);
  if (cells.empty() || (cells.size() != 1 && cells.size() != 3)) return std::nullopt;
  const bool are_letters = std::ranges::all_of(cells, [&](std::size_t cell) { return found.names[cell].size() == 1; });
  std::size_t all = 0, beyond = 0;
  std::optional<std::pair<std::size_t, double>> first;
  for (const std::size_t cell : cells) {
    for (const auto& row : found.rows) {
      const double number = number_in(found, row, cell);
      if (std::isnan(number)) continue;
      const bool is_from_0_to_50 = number >= 0 && number <= 50;
      if (cells.size() == 3 && !are_letters && !is_from_0_to_50) return std::nullopt;
      ++all;
      if (std::abs(number) <= 1) continue;
      ++beyond;
      if (!first) first.emplace(cell, number);
    }
  }
  const bool is_doubt = cells.size() == 3 && are_letters ? beyond > 0 : 2 * beyond > all;
  if (!is_doubt) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t cell : cells) names.push_back(found.names[cell]);
  return error(
      "{} would shape the curve as {}, but {} is {}; expected parameters, which are usually from -1 to 1; give {} {} "
      "for channels, {} none for parameters as they are, or {} 3dsmax for parameters from 0 to 50",
      listed(names), cells.size() == 1 ? "a parameter" : "tension, continuity and bias",
      in_quotes(found.names[first->first]), first->second, option::columns, positions_of(found), option::tcb_scale,
      option::tcb_scale);
}

Found column_numbers_above_rows(const FoundColumns& found) {
  if (!found.names.empty() || found.has_header || found.rows.size() < 2 || found.rows[0].size() < 3) {
    return std::nullopt;
  }
  const double begin = number_in(found, found.rows[0], 0);
  if (begin != 0 && begin != 1) return std::nullopt;
  for (std::size_t cell = 0; cell < found.rows[0].size(); ++cell) {
    if (number_in(found, found.rows[0], cell) != begin + static_cast<double>(cell)) return std::nullopt;
  }
  bool has_fraction = false;
  for (std::size_t cell = 0; cell < found.rows[1].size(); ++cell) {
    const double number = number_in(found, found.rows[1], cell);
    has_fraction = has_fraction || number != std::floor(number);
  }
  const double step = number_in(found, found.rows[1], 0) - begin;
  if (!has_fraction && step == 1) return std::nullopt;
  return note("the first line counts the columns; {} takes it as their names, not as a key", option::header);
}

/// A column without a role whose cells are times: dates, times of day or timecode, or numbers by its name.
bool holds_times(const FoundColumns& found, std::size_t cell) {
  const bool has_notation = !found.rows.empty() && cell < found.rows[0].size() && find_notation(found.rows[0][cell]);
  return has_notation || (cell < found.names.size() && found.numeric[cell] && is_usual_time(found.names[cell]) &&
                          !is_usual_counter(found.names[cell]));
}

Found times_without_role(const FoundColumns& found) {
  if (found.requested.timeless || found.columns.has(Role::time) || found.requested.samples) return std::nullopt;
  for (std::size_t cell = 0; cell < found.columns.cells.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    if (role != Role::ignored || !holds_times(found, cell)) continue;
    return error(
        "column {} seems to have the times, but no column is the time; expected a time; give {} {}, or {} uniform if "
        "the keys have no times",
        shown(found, cell), option::columns, roles_of(found, "time", {cell}), option::parameter);
  }
  return std::nullopt;
}

Found time_in_two_numbers(const FoundColumns& found) {
  constexpr double in_2000 = 946'684'800, in_2100 = 4'102'444'800, second = 1e9;
  if (!found.names.empty() || !found.requested.roles.empty() || found.requested.timeless || found.rows.size() < 2) {
    return std::nullopt;
  }
  bool repeats = false, is_large = false;
  double before = nan;
  for (const auto& row : found.rows) {
    const double seconds = number_in(found, row, 0), nanoseconds = number_in(found, row, 1);
    const bool are_whole = seconds == std::floor(seconds) && nanoseconds == std::floor(nanoseconds);
    if (!are_whole || seconds < in_2000 || seconds >= in_2100 || nanoseconds < 0 || nanoseconds >= second) {
      return std::nullopt;
    }
    repeats = repeats || seconds == before;
    is_large = is_large || nanoseconds >= 1e6;
    before = seconds;
  }
  if (!is_large && !repeats) return std::nullopt;
  return error(
      "columns 1 and 2 seem to be the seconds and the nanoseconds of a time; expected names, or roles; give {} "
      "time=1,nanoseconds=2 if they are, or {} time=1 if column 2 is a position",
      option::columns, option::columns);
}

/// Whether four columns have the norm 1 in all of the first records.
bool are_units(const FoundColumns& found, const std::array<std::size_t, 4>& cells) {
  if (found.rows.empty()) return false;
  return std::ranges::all_of(found.rows, [&](const auto& row) {
    double sum = 0;
    for (const std::size_t cell : cells) {
      const double number = number_in(found, row, cell);
      sum += number * number;
    }
    return std::abs(std::sqrt(sum) - 1) <= 1e-3;
  });
}

Found quaternion_called_wxyz(const FoundColumns& found) {
  if (found.has_rotations || is_requested(found, Role::position)) return std::nullopt;
  constexpr std::array<std::string_view, 4> letters{"x", "y", "z", "w"};
  std::array<std::size_t, 4> cells{};
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const auto at =
        std::ranges::find_if(found.names, [&](const auto& name) { return same_in_any_case(name, letters[i]); });
    if (at == found.names.end()) return std::nullopt;
    cells[i] = static_cast<std::size_t>(at - found.names.begin());
    if (found.columns.cells[cells[i]].role != Role::position) return std::nullopt;
  }
  if (!are_units(found, cells)) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t cell : cells) names.push_back(found.names[cell]);
  return error(
      "columns {} have the norm 1, as quaternions do; expected the rotation to be named; give {} {} for a rotation, or "
      "{} none for plain channels",
      listed(names), option::rotation, in_shell(fmt::format("quaternion={}", fmt::join(names, ":"))), option::rotation);
}

/// Whether the numbers of a record without names are a matrix of three rows, each followed by one of the position.
bool is_pose_matrix(const FoundColumns& found) {
  if (found.rows.empty() || found.columns.cells.size() != 12) return false;
  constexpr double tolerance = 1e-3;
  return std::ranges::all_of(found.rows, [&](const auto& row) {
    const auto product = [&](std::size_t a, std::size_t b) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += number_in(found, row, a + i) * number_in(found, row, b + i);
      return sum;
    };
    for (std::size_t at = 0; at < 12; at += 4) {
      const bool is_unit = std::abs(std::sqrt(product(at, at)) - 1) <= tolerance;
      if (!is_unit || !(std::abs(product(at, (at + 4) % 12)) <= tolerance)) return false;
    }
    return true;
  });
}

Found rotation_without_names(const FoundColumns& found) {
  if (!found.names.empty() || found.has_rotations || !found.requested.roles.empty() || found.rows.size() < 2) {
    return std::nullopt;
  }
  if (is_pose_matrix(found)) {
    return note(
        "the columns may be poses, matrices of 3 rows and 4 columns; {0} uniform {1} matrix=1:2:3:5:6:7:9:10:11 "
        "resamples them as poses, {1} none leaves out this note",
        option::parameter, option::rotation);
  }
  const std::vector<std::size_t> cells = cells_with(found, Role::position);
  for (std::size_t i = 0; i + 4 <= cells.size(); ++i) {
    const std::array four{cells[i], cells[i + 1], cells[i + 2], cells[i + 3]};
    if (four[3] != four[0] + 3 || !are_units(found, four)) continue;
    const std::size_t first = four[0] + 1;
    return note(
        "columns {0} to {3} may be a quaternion; {4} quaternion={0}:{1}:{2}:{3} resamples them as a rotation, {4} none "
        "leaves out this note",
        first, first + 1, first + 2, first + 3, option::rotation);
  }
  return std::nullopt;
}

Found minutes_and_seconds(const FoundColumns& found) {
  const std::vector<std::size_t> times = cells_with(found, Role::time);
  if (found.rows.empty() || times.empty() || times[0] >= found.rows[0].size()) return std::nullopt;
  const std::string_view time = found.rows[0][times[0]];
  if (find_notation(time) != TimeNotation::clock || std::ranges::count(time, ':') != 1) return std::nullopt;
  return note("times such as {} are taken as minutes and seconds", in_quotes(time));
}

/// The list. The first error is the one that is shown.
struct DoubtAboutColumns {
  std::string_view name;
  Found (*find)(const FoundColumns& found);
};
constexpr std::array about_columns{
    DoubtAboutColumns{"coefficients of pieces", coefficients_of_pieces},
    DoubtAboutColumns{"near miss of a role", near_miss_of_role},
    DoubtAboutColumns{"letters that are data", letters_that_are_data},
    DoubtAboutColumns{"parameters that are data", parameters_that_are_data},
    DoubtAboutColumns{"column numbers above rows", column_numbers_above_rows},
    DoubtAboutColumns{"times without a role", times_without_role},
    DoubtAboutColumns{"time in two numbers", time_in_two_numbers},
    DoubtAboutColumns{"quaternion called w, x, y, z", quaternion_called_wxyz},
    DoubtAboutColumns{"rotation without names", rotation_without_names},
    DoubtAboutColumns{"minutes and seconds", minutes_and_seconds},
};

// The rows about a request.

std::vector<std::string> names_of(const std::vector<std::string>& channels, const std::vector<std::size_t>& chosen) {
  std::vector<std::string> names;
  for (const std::size_t channel : chosen) names.push_back(channels[channel]);
  return names;
}

/// Channels that lengths may measure: no numbers of rotations, and no angles.
std::vector<std::size_t> plain_channels(const Schema& schema) {
  std::vector<std::size_t> plain;
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    const bool is_of_rotation =
        std::ranges::any_of(schema.rotations, [i](const RotationSchema& rotation) { return rotation.columns.has(i); });
    if (!is_of_rotation && std::ranges::count(schema.angles, i, &AngleColumn::channel) == 0) plain.push_back(i);
  }
  return plain;
}

Found lengths_of_degrees(const Schema& schema, const RequestNeeds& needs) {
  if (!needs.lengths || needs.chooses_metric || !spatial_channels(schema.channels).empty()) return std::nullopt;
  constexpr std::array<std::string_view, 2> latitudes{"lat", "latitude"};
  constexpr std::array<std::string_view, 4> longitudes{"lon", "lng", "long", "longitude"};
  const auto find = [&](std::span<const std::string_view> names) {
    return std::ranges::find_if(schema.channels, [&](const std::string& channel) {
      return std::ranges::any_of(names, [&](auto name) { return same_in_any_case(without_unit(channel), name); });
    });
  };
  const auto latitude = find(latitudes), longitude = find(longitudes);
  if (latitude == schema.channels.end() || longitude == schema.channels.end()) return std::nullopt;
  std::vector<std::string> names = names_of(schema.channels, plain_channels(schema));
  return error(
      "{} and {} are degrees, which are not lengths; expected coordinates in one unit of length; convert them, or give "
      "{} {} to measure these numbers as they are",
      in_quotes(*latitude), in_quotes(*longitude), option::metric, in_shell(fmt::format("{}", fmt::join(names, ","))));
}

Found lengths_of_space(const Schema& schema, const RequestNeeds& needs) {
  if (!needs.lengths || needs.chooses_metric) return std::nullopt;
  const std::vector<std::size_t> space = spatial_channels(schema.channels), plain = plain_channels(schema);
  if (space.empty()) return std::nullopt;
  std::vector<std::string> others;
  for (const std::size_t channel : plain) {
    if (std::ranges::count(space, channel) == 0) others.push_back(schema.channels[channel]);
  }
  if (others.empty()) return std::nullopt;
  return note("lengths and speeds measure {}, without {}; {} all measures all channels",
              listed(names_of(schema.channels, space)), listed(others), option::metric);
}

Found lengths_of_unlike_things(const Schema& schema, const RequestNeeds& needs) {
  if (!needs.lengths || needs.chooses_metric || !schema.named) return std::nullopt;
  const std::vector<std::size_t> plain = plain_channels(schema);
  if (!spatial_channels(schema.channels).empty() || plain.size() < 2) return std::nullopt;
  const std::string& first = schema.channels[plain[0]];
  const auto other = std::ranges::find_if(
      plain, [&](std::size_t channel) { return !are_of_one_kind(first, schema.channels[channel]); });
  if (other == plain.end()) return std::nullopt;
  return note("lengths and speeds measure all channels together, also {} and {}; {} NAME,... chooses some",
              in_quotes(first), in_quotes(schema.channels[*other]), option::metric);
}

Found time_by_its_place(const Schema& schema, const RequestNeeds& needs) {
  if (!needs.by_length || schema.named || !schema.time.is_given || needs.chooses_columns) return std::nullopt;
  return note("the first column is taken as the time; {} uniform takes it as a position", option::parameter);
}

/// Times without a unit are taken as seconds.
Found seconds_of_unknown_times(const Schema& schema, const RequestNeeds& needs) {
  constexpr double most = 1000;
  if (!needs.step || !needs.time_gap || schema.time.unit || schema.time.epoch_unit) return std::nullopt;
  const double rows = *needs.time_gap / *needs.step;
  if (!(rows > most)) return std::nullopt;
  const std::string_view unit = rows <= most * 1e3 ? "ms" : rows <= most * 1e6 ? "us" : "ns";
  return error(
      "the unit of the times in column {} is unknown, and as seconds they give {:.0f} rows for each key; expected "
      "their "
      "unit; give {} {} if they are in {}, or {} s if they are seconds",
      in_quotes(schema.time.name), rows, option::time_unit, unit, unit, option::time_unit);
}

struct DoubtAboutRequest {
  std::string_view name;
  Found (*find)(const Schema& schema, const RequestNeeds& needs);
};
constexpr std::array about_requests{
    DoubtAboutRequest{"lengths of degrees", lengths_of_degrees},
    DoubtAboutRequest{"lengths of space", lengths_of_space},
    DoubtAboutRequest{"lengths of unlike things", lengths_of_unlike_things},
    DoubtAboutRequest{"time by its place", time_by_its_place},
    DoubtAboutRequest{"seconds of unknown times", seconds_of_unknown_times},
};

/// Appends a note, or throws the error of a doubt.
void take(std::vector<std::string>& notes, Found found) {
  if (!found) return;
  if (found->is_error) throw Error(Exit::data, found->text);
  notes.push_back(std::move(found->text));
}

}  // namespace

std::vector<std::string> doubts_of_columns(const FoundColumns& found) {
  std::vector<std::string> notes;
  for (const DoubtAboutColumns& row : about_columns) take(notes, row.find(found));
  return notes;
}

std::vector<std::string> doubts_of_request(const Schema& schema, const RequestNeeds& needs) {
  std::vector<std::string> notes;
  for (const DoubtAboutRequest& row : about_requests) take(notes, row.find(schema, needs));
  return notes;
}

std::vector<std::size_t> spatial_channels(const std::vector<std::string>& channels) {
  const auto find = [&](std::string_view before, char letter) -> std::optional<std::size_t> {
    const auto at = std::ranges::find_if(channels, [&](const std::string& channel) {
      const std::string_view name = without_unit(channel);
      return name.size() == before.size() + 1 && same_in_any_case(name.substr(0, before.size()), before) &&
             lower(name.back()) == letter;
    });
    return at == channels.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - channels.begin()));
  };
  // As written before the letter of an axis, in the order in which one is chosen.
  constexpr std::array<std::string_view, 14> stems{"",          "p",         "pos_",         "pos.",        "pos",
                                                   "position_", "position.", "position ",    "loc_",        "location_",
                                                   "location.", "t",         "translation_", "translation."};
  for (const std::string_view stem : stems) {
    const auto x = find(stem, 'x'), y = find(stem, 'y'), z = find(stem, 'z');
    if (!x || !y) continue;
    std::vector<std::size_t> space{*x, *y};
    if (z) space.push_back(*z);
    return space.size() < channels.size() ? space : std::vector<std::size_t>{};
  }
  return {};
}

}  // namespace tcb
