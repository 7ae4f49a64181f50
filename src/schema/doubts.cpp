// Doubts: what an input may mean besides what was found in it, as one list.
#include "schema/doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "numbers/dates.hpp"
#include "numbers/time_notation.hpp"
#include "schema/units.hpp"
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

/// A column as messages show it.
std::string shown(const FoundColumns& found, std::size_t cell) {
  const std::string number = fmt::format("column {}", cell + 1);
  return found.names.empty() || found.names[cell] == number ? number : in_quotes(found.names[cell]);
}

std::string column_in_words(const FoundColumns& found, std::size_t cell) {
  const std::string name = shown(found, cell);
  return name.starts_with('"') ? "column " + name : name;
}

/// A value of --columns or --rotation with the role and all these columns.
std::string roles_of(const FoundColumns& found, std::string_view role, std::span<const std::size_t> cells) {
  return in_shell(requested_as(role, found.names, cells));
}

std::vector<std::string> names_of(std::span<const std::string> names, std::span<const std::size_t> chosen) {
  std::vector<std::string> result;
  for (const std::size_t i : chosen) result.push_back(names[i]);
  return result;
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

/// A value of --columns with all columns that may be positions, and others, or how to give it where these are many.
std::string positions_of(const FoundColumns& found, std::span<const std::size_t> others = {}) {
  constexpr std::size_t most = 12;
  std::vector<std::size_t> cells = possible_positions(found);
  for (const std::size_t cell : others) {
    if (std::ranges::count(cells, cell) == 0) cells.push_back(cell);
  }
  if (cells.size() > most) return "position=NAME:NAME";
  if (found.array.empty()) return roles_of(found, "position", cells);
  std::erase_if(cells, [&](std::size_t cell) { return std::ranges::count(found.meant, found.names[cell]) > 0; });
  return in_shell(fmt::format("position={}{}{}", found.array, cells.empty() ? "" : ":",
                              cells.empty() ? "" : requested_as("", found.names, cells).substr(1)));
}

constexpr std::array tcb_roles{Role::tension, Role::continuity, Role::bias};

bool is_parameter(Role role) {
  return std::ranges::count(tcb_roles, role) > 0 || role == Role::channel_tension || role == Role::channel_continuity ||
         role == Role::channel_bias;
}

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

// Names that are nearly those of roles.

}  // namespace

std::optional<Role> near_role(std::string_view name) {
  if (role_of_name(name) != Role::position) return std::nullopt;
  const std::string_view alone = without_unit(name);
  const auto meant = std::ranges::find_if(role_names, [&](const RoleName& known) {
    const bool counts = known.name.size() > 1 && known.in_header && known.role != Role::position &&
                        std::ranges::count(tcb_roles, known.role) == 0;
    return counts && is_near(alone, known.name);
  });
  return meant == role_names.end() ? std::nullopt : std::optional(meant->role);
}

namespace {

/// The name of the role of which a channel's name is a near miss, unless a column has that role or channels were
/// requested.
std::optional<std::string> near_miss(const std::string& name, const Columns& columns,
                                     std::span<const RoleRequest> requests, bool timeless) {
  if (std::ranges::count(requests, Role::position, &RoleRequest::role) > 0) return std::nullopt;
  const std::optional<Role> near = near_role(name);
  if (!near || columns.has(*near) || (timeless && *near == Role::time)) return std::nullopt;
  return std::string(role_name(*near));
}

// The rows about columns.

Found near_miss_of_role(const FoundColumns& found) {
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    const std::string& name = found.names[cell];
    if (role != Role::position && (role != Role::ignored || !found.numeric[cell])) continue;
    const auto near = near_miss(name, found.columns, found.requested.roles, found.requested.timeless);
    if (!near || std::ranges::count(found.meant, name) > 0) continue;
    return error(
        "column {} would be a channel, but its name is close to the role {}; expected {}, or a name that is not close "
        "to it; rename the column, or give --columns {} if it has this role, or --columns {} if it has not",
        in_quotes(name), *near, *near, roles_of(found, *near, {&cell, 1}), positions_of(found));
  }
  return std::nullopt;
}

// Rows that are pieces of a curve, as --emit writes them.

/// Whether a channel has all four columns of a form of --emit. Names such as x_b0 may also be others, but with
/// `duration`, a column of that name or one whose numbers are durations.
bool are_named_as_pieces(std::span<const std::string> names, bool duration) {
  constexpr std::array<std::array<std::string_view, 4>, 3> forms{
      {{"^0", "^1", "^2", "^3"}, {"_p0", "_v0", "_p1", "_v1"}, {"_b0", "_b1", "_b2", "_b3"}}};
  const std::unordered_set<std::string_view> all(names.begin(), names.end());
  return std::ranges::any_of(std::span(forms).first(duration ? forms.size() : 1), [&](const auto& endings) {
    return std::ranges::any_of(names, [&](std::string_view name) {
      if (!name.ends_with(endings[0])) return false;
      const std::string channel(name.substr(0, name.size() - endings[0].size()));
      return std::ranges::all_of(endings, [&](auto ending) { return all.contains(channel + std::string(ending)); });
    });
  });
}

/// The numbers of columns in the first rows; none where one has another cell.
std::vector<std::vector<double>> numbers_in(const FoundColumns& found, std::span<const std::size_t> cells,
                                            std::size_t most_rows) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : found.rows.first(std::min(found.rows.size(), most_rows))) {
    std::vector<double>& numbers = rows.emplace_back();
    for (const std::size_t cell : cells) numbers.push_back(number_in(found, row, cell));
    if (std::ranges::any_of(numbers, [](double number) { return std::isnan(number); })) return {};
  }
  return rows;
}

/// How many rows begin where the one before them ends, by a column of starts and one of durations; 0 if any does not,
/// unless it begins again with an earlier start.
std::size_t following_rows(const std::vector<std::vector<double>>& rows, std::size_t start, std::size_t duration) {
  std::size_t following = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!(rows[i][duration] > 0)) return 0;
    if (i == 0 || rows[i][start] < rows[i - 1][start]) continue;
    const double end = rows[i - 1][start] + rows[i - 1][duration];
    const double most_off = 1e-3 * rows[i - 1][duration] + 1e-15 * std::abs(end);
    if (!(std::abs(rows[i][start] - end) <= most_off)) return 0;
    ++following;
  }
  return following;
}

/// Whether four columns are a cubic in one form, which ends where that of the next row begins, at several values.
bool are_joined(const std::vector<std::vector<double>>& rows, std::size_t start, std::size_t duration,
                std::size_t first) {
  const auto ends_of = [&](const std::vector<double>& row) {
    const double h = row[duration], *const x = &row[first];
    return std::array{x[2], x[3], x[0] + h * (x[1] + h * (x[2] + h * x[3]))};  // hermite, bezier, poly
  };
  std::array<bool, 3> joins{true, true, true};
  bool changes = false;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][start] < rows[i - 1][start]) continue;
    const double begin = rows[i][first], before = rows[i - 1][first];
    const std::array ends = ends_of(rows[i - 1]);
    for (std::size_t form = 0; form < ends.size(); ++form) {
      const double most_off = 1e-9 * std::max(std::abs(begin), std::abs(before));
      joins[form] = joins[form] && std::abs(ends[form] - begin) <= most_off;
    }
    changes = changes || begin != before;
  }
  return changes && std::ranges::count(joins, true) > 0;
}

struct NumbersOfPieces {
  bool duration = false;  ///< a column holds the durations of the rows
  bool cubics = false;    ///< and others hold cubics that join
};

/// What the numbers of the first columns are, whatever their names are. Few rows tell little.
NumbersOfPieces numbers_of_pieces(const FoundColumns& found) {
  constexpr std::size_t most = 16, enough = 2;
  if (std::ranges::any_of(tcb_roles, [&](Role role) { return found.columns.has(role); })) return {};  // of keys
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < found.numeric.size() && cells.size() < most; ++cell) {
    if (found.numeric[cell]) cells.push_back(cell);
  }
  const auto first_rows = numbers_in(found, cells, enough + 1);
  NumbersOfPieces result;
  for (std::size_t start = 0; start < cells.size(); ++start) {
    for (std::size_t duration = 0; duration < cells.size(); ++duration) {
      if (start == duration || following_rows(first_rows, start, duration) == 0) continue;
      const auto rows = numbers_in(found, cells, found.rows.size());
      if (following_rows(rows, start, duration) < enough) continue;
      result.duration = true;
      for (std::size_t first = 0; first + 4 <= cells.size(); ++first) {
        const auto is_other = [&](std::size_t column) { return column < first || column >= first + 4; };
        const bool may_be_cubic = is_other(start) && is_other(duration);
        result.cubics = result.cubics || (may_be_cubic && are_joined(rows, start, duration, first));
      }
    }
  }
  return result;
}

Found pieces_of_curve(const FoundColumns& found) {
  if (found.requested.samples || is_requested(found, Role::position)) return std::nullopt;
  const NumbersOfPieces numbers = numbers_of_pieces(found);
  const bool duration = numbers.duration || std::ranges::any_of(found.names, [](const std::string& name) {
                          return same_in_any_case(name, "duration");
                        });
  if (!numbers.cubics && !are_named_as_pieces(found.names, duration)) return std::nullopt;
  return error(
      "the rows are pieces of a curve, as --emit writes them; expected keys; give the keys that the pieces were made "
      "of, or --columns position=NAME:NAME for keys with these channels");
}

/// The time t beside c and b, which may be tension, unless it comes first and rises, or the names are other letters.
Found letter_of_time(const FoundColumns& found) {
  const auto cell_of = [&](std::string_view name) {
    return std::ranges::find(found.names, name) - found.names.begin();
  };
  const auto is_there = [&](std::string_view name) { return cell_of(name) < std::ssize(found.names); };
  const auto t = static_cast<std::size_t>(cell_of("t"));
  const bool has_letters = is_there("t") && is_there("c") && is_there("b") && !is_there("a") && !is_there("g");
  const bool is_given = found.requested.timeless || is_requested(found, Role::time);
  if (!has_letters || is_given || found.columns.cells[t].role != Role::time) return std::nullopt;
  const auto falls = [&](const auto& one, const auto& next) {
    return !(number_in(found, one, t) < number_in(found, next, t));
  };
  if (t == 0 && std::ranges::adjacent_find(found.rows, falls) == found.rows.end()) return std::nullopt;
  return error(
      "column t may be the time, or the tension beside continuity c and bias b; expected one of the two; give "
      "--parameter uniform for the tension of keys without times, or --columns time=t");
}

Found letters_that_are_data(const FoundColumns& found) {
  if (is_requested(found, Role::position) || found.names.empty()) return std::nullopt;
  constexpr std::array<std::string_view, 3> known{"T", "C", "B"};
  std::vector<std::string> letters;
  std::ranges::copy_if(found.columns.channels, std::back_inserter(letters),
                       [&](const std::string& name) { return std::ranges::count(known, name) > 0; });
  if (letters.empty()) return std::nullopt;
  std::vector<std::string> roles;
  for (const std::string& letter : letters) {
    const auto place = static_cast<std::size_t>(std::ranges::find(known, letter) - known.begin());
    roles.push_back(fmt::format("{}={}", role_name(tcb_roles[place]), letter));
  }
  return note(
      "positions by a single letter: {}; only T, C and B together are tension, continuity and bias; --columns {} "
      "gives the role{}",
      listed(letters), fmt::join(roles, ","), roles.size() > 1 ? "s" : "");
}

/// Whether the request or the file says what a column is.
bool is_known(const FoundColumns& found, std::size_t cell) {
  const std::string& name = found.names[cell];
  const auto is_it = [&](const std::string& column) {
    return same_in_any_case(column, name) || column == fmt::format("{}", cell + 1);
  };
  return std::ranges::count(found.meant, name) > 0 ||
         std::ranges::any_of(found.requested.roles,
                             [&](const RoleRequest& request) { return std::ranges::any_of(request.columns, is_it); });
}

/// The columns that are, or may be, parameters by their names.
std::vector<ParameterSet> sets_of_parameters(const FoundColumns& found) {
  std::vector<ParameterSet> sets = found.parameters;
  std::erase_if(sets, [&](const ParameterSet& set) {
    return std::ranges::any_of(set.cells, [&](const auto& cell) { return cell && is_known(found, *cell); });
  });
  return sets;
}

std::vector<std::size_t> cells_of(const ParameterSet& set) {
  std::vector<std::size_t> cells;
  for (const auto& cell : set.cells) {
    if (cell) cells.push_back(*cell);
  }
  return cells;
}

/// The option that takes the columns of a set without its roles, and what it does with them.
std::string without_roles(const FoundColumns& found, const ParameterSet& set) {
  constexpr std::size_t most = 12;
  const bool is_one = set.count() == 1;
  if (possible_positions(found).size() > most) {
    return fmt::format("--columns {} to leave {} out", roles_of(found, "ignore", cells_of(set)),
                       is_one ? "it" : "them");
  }
  std::vector<std::size_t> cells = possible_positions(found);
  std::erase_if(cells, [&](std::size_t cell) {
    return is_parameter(found.columns.cells[cell].role) && std::ranges::count(cells_of(set), cell) == 0;
  });
  return fmt::format("--columns {} to take {}",
                     set.completes ? roles_of(found, "position", cells) : positions_of(found, cells_of(set)),
                     is_one ? "it as a channel" : "them as channels");
}

/// The columns of a set and what they are, as in "columns tens, bias" and "tension, bias".
std::pair<std::string, std::string> in_words(const FoundColumns& found, const ParameterSet& set) {
  std::vector<std::string> columns, roles;
  for (std::size_t i = 0; i < set.cells.size(); ++i) {
    if (!set.cells[i]) continue;
    columns.push_back(requested_as(found.names, *set.cells[i]));
    roles.emplace_back(role_name(tcb_roles[i]));
  }
  const std::string of_channel = set.channel.empty() ? "" : " of " + set.channel;
  return {fmt::format("column{} {}", columns.size() > 1 ? "s" : "", listed(columns)), listed(roles) + of_channel};
}

Found parameters_by_other_names(const FoundColumns& found) {
  constexpr std::size_t most = 6;
  std::size_t others = 0;
  std::vector<std::string> taken;
  const ParameterSet* first = nullptr;
  const std::vector<ParameterSet> sets = sets_of_parameters(found);
  for (const ParameterSet& set : sets) {
    const auto is_taken = [&](const auto& cell) { return !cell || is_parameter(found.columns.cells[*cell].role); };
    if (!set.is_clear() || set.has_whole_names(found.names) || !std::ranges::all_of(set.cells, is_taken)) continue;
    if (taken.size() >= most) {
      ++others;
      continue;
    }
    const auto [columns, roles] = in_words(found, set);
    taken.push_back(fmt::format("{} {} taken as {}", columns, set.count() > 1 ? "are" : "is", roles));
    if (set.time) taken.push_back(fmt::format("column {} as the time", requested_as(found.names, *set.time)));
    if (first == nullptr) first = &set;
  }
  if (taken.empty()) return std::nullopt;
  const std::string further = others > 0 ? fmt::format(", and those of {} others likewise", others) : "";
  return note("by their names, {}{}; give {}", fmt::join(taken, ", and "), further, without_roles(found, *first));
}

Found parameters_in_short(const FoundColumns& found) {
  const auto is_tcb = [&](Role role) { return is_requested(found, role); };
  if (is_requested(found, Role::position) || std::ranges::any_of(tcb_roles, is_tcb)) return std::nullopt;
  const ParameterSet* of_all = nullptr;
  const std::vector<ParameterSet> sets = sets_of_parameters(found);
  for (const ParameterSet& set : sets) {
    const bool is_of_all = set.is_clear() && set.channel.empty() && !set.completes;
    if (!set.is_doubtful() && !(is_of_all && of_all != nullptr)) {
      if (is_of_all) of_all = &set;
      continue;
    }
    const auto [columns, roles] = in_words(found, set);
    const auto request = [&](const ParameterSet& one, const ParameterSet& other) {
      return in_shell(one.request(found.names) + "," + requested_as("ignore", found.names, cells_of(other)));
    };
    if (set.is_doubtful()) {
      return error(
          "{} may be {}; expected the words tension, continuity and bias, or all three in short; give --columns {} if "
          "that is so, or {}",
          columns, roles, in_shell(set.request(found.names)), without_roles(found, set));
    }
    return error("{} and {} may be {}; expected one of the two; give --columns {}, or --columns {}",
                 in_words(found, *of_all).first, columns, roles, request(*of_all, set), request(set, *of_all));
  }
  return std::nullopt;
}

/// The ease of keys by other names than ease_in and ease_out, as "Ease To", beside tension, continuity and bias.
Found ease_in_other_words(const FoundColumns& found) {
  const bool has_tcb = std::ranges::any_of(found.columns.cells, [](auto& column) { return is_parameter(column.role); });
  if (!has_tcb || is_requested(found, Role::position)) return std::nullopt;
  std::vector<std::size_t> cells;
  std::vector<std::string> roles;
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    const std::vector<std::string> words = words_of(found.names[cell]);
    const std::string word = fmt::format("{}", fmt::join(words, ""));
    const bool is_in = word == "easein" || word == "easeto", is_out = word == "easeout" || word == "easefrom";
    if ((!is_in && !is_out) || found.columns.cells[cell].role != Role::position) continue;
    cells.push_back(cell);
    roles.push_back(requested_as(is_in ? "ease_in" : "ease_out", found.names, {&cell, 1}));
  }
  if (cells.empty()) return std::nullopt;
  return error(
      "{} may be the ease at the keys; expected ease_in and ease_out in this spelling; give --columns {} if that is "
      "so, or --columns {} to leave {} out",
      listed(names_of(found.names, cells)), in_shell(fmt::format("{}", fmt::join(roles, ","))),
      roles_of(found, "ignore", cells), cells.size() == 1 ? "it" : "them");
}

/// Texts in a column of the three parameters.
Found parameters_as_text(const FoundColumns& found) {
  for (std::size_t cell = 0; cell < found.names.size() && !found.rows.empty(); ++cell) {
    const std::string& name = found.names[cell];
    const bool is_tcb = same_in_any_case(name, "tcb") || same_in_any_case(name, "tbc");
    if (!is_tcb || !found.columns.cells[cell].is_text || is_known(found, cell)) continue;
    return error(
        "column {} has texts such as {}, not three numbers; expected (0, 0.5, 0), or columns tension, continuity and "
        "bias; write the numbers alone, or give --columns {} to leave the column out",
        shown(found, cell), in_quotes(found.rows[0][cell]), roles_of(found, "ignore", {&cell, 1}));
  }
  return std::nullopt;
}

/// Columns that are parameters by their names.
std::vector<std::size_t> parameters_of(const FoundColumns& found) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    if (!is_parameter(role) || is_requested(found, role)) continue;
    if (std::ranges::count(found.meant, found.names[cell]) == 0) cells.push_back(cell);
  }
  return cells;
}

Found parameters_that_are_data(const FoundColumns& found) {
  if (found.has_tcb_scale) return std::nullopt;
  const std::vector<std::size_t> cells = parameters_of(found);
  if (cells.empty() || (cells.size() != 1 && cells.size() != 3)) return std::nullopt;
  const bool are_letters = std::ranges::any_of(sets_of_parameters(found), [&](const ParameterSet& set) {
    return std::ranges::count(set.cells, cells[0]) > 0 && set.count(ParameterSet::Kind::letter) == cells.size();
  });
  std::size_t all = 0, beyond = 0;
  bool is_from_0_to_50 = true, is_beyond_likely = false;
  std::optional<std::pair<std::size_t, double>> first;
  for (const std::size_t cell : cells) {
    for (const auto& row : found.rows) {
      const double number = number_in(found, row, cell);
      if (std::isnan(number)) continue;
      constexpr double most = 50, likely = 10;
      is_beyond_likely = is_beyond_likely || std::abs(number) > likely;
      is_from_0_to_50 = is_from_0_to_50 && number >= 0 && number <= most;
      ++all;
      if (std::abs(number) <= 1) continue;
      ++beyond;
      if (!first) first.emplace(cell, number);
    }
  }
  const bool are_words = cells.size() == 3 && !are_letters;
  const bool is_doubt = cells.size() == 3 && are_letters ? beyond > 0 : 2 * beyond > all;
  if (are_words && !is_from_0_to_50 && is_beyond_likely) {
    return error(
        "{} would shape the curve, but {} is {}; expected numbers that are usually from -1 to 1; divide them by 100 if "
        "they are in percent, or give --tcb-scale none to take them unchanged, or --columns {} for channels",
        listed(names_of(found.names, cells)), in_quotes(found.names[first->first]), first->second, positions_of(found));
  }
  if (!is_doubt || (are_words && !is_from_0_to_50)) return std::nullopt;
  return error(
      "{} would shape the curve as {}, but {} is {}; expected parameters, which are usually from -1 to 1; give "
      "--columns {} for channels, --tcb-scale none for parameters as they are, or --tcb-scale 3dsmax for parameters "
      "from 0 to 50",
      listed(names_of(found.names, cells)), cells.size() == 1 ? "a parameter" : "tension, continuity and bias",
      in_quotes(found.names[first->first]), first->second, positions_of(found));
}

/// A column without a role whose cells are times: dates, times of day or timecode, or numbers by its name.
bool holds_times(const FoundColumns& found, std::size_t cell) {
  const bool has_notation = !found.rows.empty() && cell < found.rows[0].size() && find_notation(found.rows[0][cell]);
  return has_notation || (cell < found.names.size() && found.numeric[cell] && is_usual_time(found.names[cell]) &&
                          !is_usual_counter(found.names[cell]));
}

Found times_without_role(const FoundColumns& found) {
  if (found.requested.timeless || found.columns.has(Role::time) || found.requested.samples) return std::nullopt;
  const bool chooses_positions = is_requested(found, Role::position);
  for (std::size_t cell = 0; cell < found.columns.cells.size(); ++cell) {
    const Role role = found.columns.cells[cell].role;
    const bool is_channel =
        role == Role::position && !chooses_positions && cell < found.names.size() && ends_like_time(found.names[cell]);
    if (!is_channel && (role != Role::ignored || !holds_times(found, cell))) continue;
    return error(
        "{} seems to have the times, but no column is the time; expected a time; give --columns {}, or --parameter "
        "uniform if the keys have no times",
        column_in_words(found, cell), roles_of(found, "time", {&cell, 1}));
  }
  return std::nullopt;
}

/// Texts that seem to name the curves of rows without times, which nothing else tells apart.
Found labels_of_curves(const FoundColumns& found) {
  if (found.columns.has(Role::time) || !found.columns.groups.empty() || found.rows.size() < 2) return std::nullopt;
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    if (!found.columns.cells[cell].is_text || !is_usual_label(found.names[cell])) continue;
    std::vector<std::string_view> runs;
    for (const auto& row : found.rows) {
      const std::string_view text = cell < row.size() ? row[cell] : "";
      if (runs.empty() || runs.back() != text) runs.push_back(text);
    }
    const std::string first(runs[0]), column = requested_as(found.names, cell);
    if (runs.size() == 1) continue;
    const std::string second(runs[1]);
    std::ranges::sort(runs);
    if (runs.size() == found.rows.size() || std::ranges::adjacent_find(runs) != runs.end()) continue;
    return error(
        "column {} is {} in the first rows, and {} in the next ones, as labels of curves are; expected its role; give "
        "--group {} for one curve per value, or --columns {} to leave it out",
        shown(found, cell), in_quotes(first), in_quotes(second), in_shell(column), in_shell("ignore=" + column));
  }
  return std::nullopt;
}

/// Two numbers of which the second one counts the time since 1970, and the first one does not.
Found time_in_second_number(const FoundColumns& found) {
  if (!found.columns.has_time_by_place || found.numeric.size() != 2 || found.rows.size() < 2) return std::nullopt;
  double before = 0;
  for (const auto& row : found.rows) {
    const double time = number_in(found, row, 1);
    if (!(time > before) || !unit_since_1970(row[1]) || unit_since_1970(row[0])) return std::nullopt;
    before = time;
  }
  return error(
      "the first column would be the time, but the second one seems to be a time since 1970; expected the time; give "
      "--columns time=2,position=1 for the second one, or --columns time=1 for the first");
}

/// Whether 14 digits are a date and a time of day.
bool are_date_and_clock(std::string_view digits) {
  constexpr std::size_t size = 14;
  if (digits.size() != size || digits.find_first_not_of("0123456789") != std::string_view::npos) return false;
  const auto part = [&](std::size_t at) { return (digits[at] - '0') * 10 + (digits[at + 1] - '0'); };
  return part(0) >= 19 && part(0) <= 21 && part(4) >= 1 && part(4) <= 12 && part(6) >= 1 && part(6) <= 31 &&
         part(8) < 24 && part(10) < 60 && part(12) < 60;
}

/// Numbers in a column of dates that count no unit, such as 20240301, and times such as 20240301120000.
Found dates_as_numbers(const FoundColumns& found) {
  constexpr double least = 1e7;
  if (found.has_time_unit || found.requested.timeless || is_requested(found, Role::time) || found.rows.empty()) {
    return std::nullopt;
  }
  for (std::size_t cell = 0; cell < std::min(found.names.size(), found.rows[0].size()); ++cell) {
    const std::string_view date = found.rows[0][cell];
    if (found.columns.cells[cell].role == Role::time && are_date_and_clock(date)) {
      return error(
          "the times in column {}, such as {}, seem to be dates; expected dates such as 2024-03-01 12:00:00, or "
          "numbers in a unit of time; write the dates so, or give --time-unit s if they are such numbers",
          shown(found, cell), date);
    }
    if (!names_dates(found.names[cell]) || !(number_in(found, found.rows[0], cell) >= least)) continue;
    if (unit_since_1970(date)) continue;
    return error(
        "column {} has dates by its name, but numbers such as {}; expected dates such as 2024-03-01, or numbers in a "
        "unit of time; write the dates so, or give --time-unit if they are such numbers",
        shown(found, cell), date);
  }
  return std::nullopt;
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

/// Whether nine columns are a rotation matrix, row after row, in all of the first records.
bool are_rotation_matrix(const FoundColumns& found, const std::array<std::size_t, 9>& cells) {
  constexpr double tolerance = 1e-3;
  return !found.rows.empty() && std::ranges::all_of(found.rows, [&](const auto& row) {
    const auto product = [&](std::size_t a, std::size_t b) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += number_in(found, row, cells[a + i]) * number_in(found, row, cells[b + i]);
      return sum;
    };
    for (std::size_t at = 0; at < cells.size(); at += 3) {
      const bool is_unit = std::abs(std::sqrt(product(at, at)) - 1) <= tolerance;
      if (!is_unit || !(std::abs(product(at, (at + 3) % cells.size())) <= tolerance)) return false;
    }
    return true;
  });
}

/// Positions, after the first column where that is the time by its place: then the time may be part of a pose.
std::vector<std::size_t> possible_poses(const FoundColumns& found) {
  std::vector<std::size_t> cells = cells_with(found, Role::position);
  if (found.columns.has_time_by_place) cells.insert(cells.begin(), cells_with(found, Role::time)[0]);
  return cells;
}

/// The options that take neighbours, from a cell on, as poses: a matrix of three rows of four, or of four rows or
/// columns whose last one is 0, 0, 0, 1, in all rows. Empty for others.
std::string options_of_poses(const FoundColumns& found, std::size_t begin, std::size_t size) {
  for (const bool by_rows : {true, false}) {
    const auto at = [&](std::size_t row, std::size_t column) {
      return begin + (by_rows ? 4 * row + column : 4 * column + row);
    };
    const bool ends = size == 12 ? by_rows : std::ranges::all_of(found.rows, [&](const auto& row) {
      return number_in(found, row, at(3, 0)) == 0 && number_in(found, row, at(3, 1)) == 0 &&
             number_in(found, row, at(3, 2)) == 0 && number_in(found, row, at(3, 3)) == 1;
    });
    std::array<std::size_t, 9> matrix{};
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] = at(i / 3, i % 3);
    if (!ends || !are_rotation_matrix(found, matrix)) continue;
    std::vector<std::string> names(found.names.begin(), found.names.end());
    for (std::size_t i = 0; i < size && !found.array.empty(); ++i) {
      names[begin + i] = fmt::format("{}[{}]", found.array, i);
    }
    if (found.columns.has_time_by_place) names.clear();
    std::string columns = requested_as("position", names, std::array{at(0, 3), at(1, 3), at(2, 3)});
    for (const RoleRequest& request : found.requested.roles) {
      if (request.role == Role::time) columns.insert(0, fmt::format("time={},", fmt::join(request.columns, ":")));
    }
    return fmt::format("--rotation {} --columns {}", in_shell(requested_as("matrix", names, matrix)),
                       in_shell(columns));
  }
  return "";
}

/// The first columns that are a matrix.
Found poses_as_matrices(const FoundColumns& found) {
  if (found.has_rotations || (is_requested(found, Role::position) && found.array.empty())) return std::nullopt;
  const std::vector<std::size_t> cells = possible_poses(found);
  const bool by_place = found.columns.has_time_by_place;
  const std::size_t most = std::min<std::size_t>(cells.size(), by_place ? 2 : 1);
  for (const std::size_t size : {16U, 12U}) {
    for (std::size_t first = 0; first < most && first + size <= cells.size(); ++first) {
      const bool are_neighbours = cells[first + size - 1] == cells[first] + size - 1;
      const std::string options = are_neighbours ? options_of_poses(found, cells[first], size) : "";
      if (options.empty()) continue;
      const auto shown_name = [&](std::size_t i) {
        return by_place || found.names.empty() ? fmt::format("{}", cells[i] + 1) : shown(found, cells[i]);
      };
      return note(
          "columns {} to {} may be poses, matrices of {} rows; {}{} resamples them as such, --rotation none leaves out "
          "this note",
          shown_name(first), shown_name(first + size - 1), size / 4,
          by_place && first == 0 ? "--parameter uniform " : "", options);
    }
  }
  return std::nullopt;
}

Found rotation_vector_by_name(const FoundColumns& found) {
  if (found.has_rotations || is_requested(found, Role::position)) return std::nullopt;
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    if (found.columns.cells[cell].role == Role::position && is_of_rotation_vector(found.names[cell])) {
      cells.push_back(cell);
    }
  }
  if (cells.size() != 3) return std::nullopt;
  return note(
      "columns {} may be a rotation vector; --rotation {} resamples them as a rotation, --rotation none leaves out "
      "this note",
      listed(std::vector{shown(found, cells[0]), shown(found, cells[1]), shown(found, cells[2])}),
      roles_of(found, "axis-angle", cells));
}

/// The same columns in the order x, y, z, w, if these letters end their names.
std::array<std::size_t, 4> by_letters(const FoundColumns& found, const std::array<std::size_t, 4>& cells) {
  std::array<std::size_t, 4> ordered{};
  for (std::size_t i = 0; i < ordered.size() && !found.names.empty(); ++i) {
    const auto cell = std::ranges::find_if(cells, [&](std::size_t one) {
      const std::string_view name = without_unit(found.names[one]);
      return !name.empty() && lower(name.back()) == "xyzw"[i];
    });
    if (cell == cells.end()) return cells;
    ordered[i] = *cell;
  }
  return found.names.empty() ? cells : ordered;
}

/// Four neighbours of norm 1, without names, or with names that are not those of rotations.
Found quaternion_by_norm(const FoundColumns& found) {
  if (found.has_rotations || found.rows.size() < 2 || poses_as_matrices(found)) return std::nullopt;
  const std::vector<std::size_t> cells = possible_poses(found);
  const bool may_be_first = found.columns.has_time_by_place, is_named = !found.names.empty() && !may_be_first;
  for (std::size_t i = 0; i + 4 <= cells.size(); ++i) {
    const std::array four{cells[i], cells[i + 1], cells[i + 2], cells[i + 3]};
    if (four[3] != four[0] + 3 || !are_units(found, four)) continue;
    const auto is_whole = [&](const auto& row) {
      return std::ranges::all_of(four, [&](std::size_t cell) {
        const double number = number_in(found, row, cell);
        return number == std::floor(number);
      });
    };
    const std::array ordered = by_letters(found, four);
    const bool is_time = may_be_first && i == 0;
    const auto is_letter = [&](std::size_t cell) { return found.names[cell].size() == 1; };
    const bool are_letters = is_named && std::ranges::all_of(four, is_letter) &&
                             lower(found.names[ordered[0]][0]) == 'x' && lower(found.names[ordered[3]][0]) == 'w';
    if (!are_letters && (is_time || is_named) && std::ranges::all_of(found.rows, is_whole)) continue;
    if (is_named && rotation_stem_of(found.names[four[0]])) continue;
    if (is_time) {
      return error(
          "the first column would be the time, but columns 1 to 4 have the norm 1, as quaternions do; expected times; "
          "give --parameter uniform --rotation quaternion=1:2:3:4 for poses without times, or --columns time=1 if it "
          "is the time");
    }
    const bool is_by_name = ordered != four && in_lower_case(found.names[four[0]]).find('q') != std::string::npos;
    if (is_by_name) return std::nullopt;
    std::vector<std::string> names;
    for (const std::size_t cell : four) names.push_back(requested_as(found.names, cell));
    if (are_letters) {
      return error(
          "columns {} have the norm 1, as quaternions do; expected the rotation to be named; give --rotation {} for a "
          "rotation, or --rotation none for plain channels",
          listed(names), roles_of(found, "quaternion", ordered));
    }
    return note(
        "columns {} may be a quaternion; --rotation {} resamples them as a rotation whose last number is w, --rotation "
        "none leaves out this note",
        listed(names), roles_of(found, "quaternion", ordered));
  }
  return std::nullopt;
}

/// Durations where nothing is the time.
Found durations_without_times(const FoundColumns& found) {
  constexpr std::array<std::string_view, 5> names{"duration", "dt", "delta_t", "deltat", "delay"};
  const bool is_decided = found.requested.timeless || is_requested(found, Role::position);
  if (is_decided || found.columns.has(Role::time) || found.requested.samples) return std::nullopt;
  const auto is_duration = [&](std::string_view name) {
    return std::ranges::any_of(names, [&](auto known) { return same_in_any_case(without_unit(name), known); });
  };
  const auto column = std::ranges::find_if(found.names, is_duration);
  if (column == found.names.end()) return std::nullopt;
  return error(
      "column {} seems to have durations, and no column is the time; expected times; add the durations up, or give "
      "--parameter uniform if the keys have no times",
      in_quotes(*column));
}

Found minutes_and_seconds(const FoundColumns& found) {
  const std::vector<std::size_t> times = cells_with(found, Role::time);
  if (found.rows.empty() || times.empty() || times[0] >= found.rows[0].size()) return std::nullopt;
  const std::string_view time = found.rows[0][times[0]];
  const bool is_short = find_notation(time) == TimeNotation::clock && std::ranges::count(time, ':') == 1;
  if (!is_short || !half_of_day(time).empty() || found.has_time_unit) return std::nullopt;
  return note("times such as {} are taken as minutes and seconds; --time-unit min takes them as hours and minutes",
              in_quotes(time));
}

/// Texts that tell how keys of other programs are interpolated.
Found other_interpolation_of_keys(const FoundColumns& found) {
  if (found.is_plain || found.has_tangents) return std::nullopt;
  constexpr std::string_view known = "interpolation interpolationtype interpolationmode interp interptype interpmode";
  for (std::size_t cell = 0; cell < found.names.size(); ++cell) {
    const bool is_told = found.columns.cells[cell].role == Role::ignored && !found.numeric[cell] &&
                         lists_word(known, fmt::format("{}", fmt::join(words_of(found.names[cell]), "")));
    for (const auto& row : found.rows) {
      if (!is_told || cell >= row.size() || !names_other_spline(row[cell])) continue;
      return note("{}", other_interpolation(fmt::format("column {} has", shown(found, cell)), row[cell]));
    }
  }
  return std::nullopt;
}

/// The list. The first error is the one that is shown.
constexpr std::array about_columns{letter_of_time,
                                   ease_in_other_words,
                                   parameters_as_text,
                                   pieces_of_curve,
                                   labels_of_curves,
                                   parameters_in_short,
                                   near_miss_of_role,
                                   letters_that_are_data,
                                   parameters_by_other_names,
                                   parameters_that_are_data,
                                   times_without_role,
                                   durations_without_times,
                                   time_in_second_number,
                                   dates_as_numbers,
                                   rotation_vector_by_name,
                                   poses_as_matrices,
                                   quaternion_by_norm,
                                   minutes_and_seconds,
                                   other_interpolation_of_keys};

// The rows about a request.

/// Channels that lengths may measure: no numbers of rotations, and no angles.
std::vector<std::size_t> measurable_channels(const Schema& schema) {
  std::vector<std::size_t> plain;
  const std::vector<bool> are_plain = plain_channels(schema);
  for (std::size_t i = 0; i < schema.channels.size(); ++i) {
    if (are_plain[i]) plain.push_back(i);
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
  std::vector<std::string> names = names_of(schema.channels, measurable_channels(schema));
  return error(
      "{} and {} are degrees, which are not lengths; expected coordinates in one unit of length; convert them, or give "
      "--metric {} to measure these numbers as they are",
      in_quotes(*latitude), in_quotes(*longitude), in_shell(fmt::format("{}", fmt::join(names, ","))));
}

Found lengths_of_space(const Schema& schema, const RequestNeeds& needs) {
  if (!needs.lengths || needs.chooses_metric) return std::nullopt;
  const std::vector<std::size_t> space = spatial_channels(schema.channels), plain = measurable_channels(schema);
  if (space.empty()) return std::nullopt;
  std::vector<std::string> others;
  for (const std::size_t channel : plain) {
    if (std::ranges::count(space, channel) == 0) others.push_back(schema.channels[channel]);
  }
  if (others.empty()) return std::nullopt;
  return note("lengths and speeds measure {}, without {}; --metric all measures all channels",
              listed(names_of(schema.channels, space)), listed(others));
}

/// Channels without names, of which nothing tells whether they are coordinates.
Found lengths_without_names(const Schema& schema, const RequestNeeds& needs) {
  const std::size_t channels = measurable_channels(schema).size();
  if (!needs.lengths || needs.chooses_metric || schema.named || channels < 2) return std::nullopt;
  return note("lengths and speeds measure all {} channels together; --metric 1{} chooses some by their numbers",
              channels, channels == 2 ? "" : ",2");
}

Found lengths_of_unlike_things(const Schema& schema, const RequestNeeds& needs) {
  if (!needs.lengths || needs.chooses_metric || !schema.named) return std::nullopt;
  const std::vector<std::size_t> plain = measurable_channels(schema);
  if (!spatial_channels(schema.channels).empty() || plain.size() < 2) return std::nullopt;
  const std::string& first = schema.channels[plain[0]];
  const auto other = std::ranges::find_if(
      plain, [&](std::size_t channel) { return !are_of_one_kind(first, schema.channels[channel]); });
  if (other == plain.end()) return std::nullopt;
  return note("lengths and speeds measure all channels together, also {} and {}; --metric NAME,... chooses some",
              in_quotes(first), in_quotes(schema.channels[*other]));
}

/// A time of day or a date is no position.
Found time_by_its_place(const Schema& schema, const RequestNeeds&) {
  if (!schema.time.is_by_place || schema.time.notation != TimeNotation::seconds) return std::nullopt;
  return note(
      "the first column is taken as the time; --columns time=1 says so, and --parameter uniform takes it as a "
      "position");
}

/// Times without a unit are taken as seconds.
Found seconds_of_unknown_times(const Schema& schema, const RequestNeeds& needs) {
  constexpr double most = 1000, many = 100;
  if (!needs.step || !needs.time_gap || schema.time.unit) return std::nullopt;
  const double rows = *needs.time_gap / *needs.step;
  const std::string column = schema.named ? in_quotes(schema.time.name) : "1";
  if (rows * most < 1) {
    return error(
        "the unit of the times in column {} is unknown, and as seconds they give a row for each {:.0f} keys; expected "
        "their unit; give --time-unit d, h or min if it is one of these, or --time-unit s if they are seconds",
        column, 1 / rows);
  }
  constexpr double several = 10;
  if (!schema.named && *needs.time_gap == 1 && rows >= several && rows <= many) {
    return note(
        "the times in column 1 count 1, 2, 3, ..., and are taken as seconds; --input-fps 24 takes them as frames");
  }
  if (!(rows > many)) return std::nullopt;
  if (!(rows > most)) {
    return note(
        "the unit of the times in column {} is unknown; as seconds they give {:.0f} rows for each key; --time-unit ms "
        "or --input-fps 24 gives another one",
        column, rows);
  }
  if (schema.time.epoch_unit) {
    return error(
        "the times in column {} seem to be {} since 1970, and as seconds they give {:.0f} rows for each key; expected "
        "their unit; give --time-unit {} if it is this one, or --time-unit s if they are seconds",
        column, row_of(*schema.time.epoch_unit).name, rows, row_of(*schema.time.epoch_unit).name);
  }
  return error(
      "the unit of the times in column {} is unknown, and as seconds they give {:.0f} rows for each key; expected "
      "their unit; give --time-unit ms, us or ns if it is one of these, --input-fps HZ if they count frames, or "
      "--time-unit s if they are seconds",
      column, rows);
}

/// Steps without a unit have that of the times, which may be small or unknown.
Found step_in_small_units(const Schema& schema, const RequestNeeds& needs) {
  constexpr double most_of_fractions = 1000, most = 100'000, many = 100;
  constexpr std::array units{TimeUnit::ms, TimeUnit::us, TimeUnit::ns};
  if (!needs.plain_step || !needs.time_gap) return std::nullopt;
  const double rows = *needs.time_gap / *needs.plain_step;
  const double most_of_unknown = *needs.plain_step < 1 ? most_of_fractions : most;  // the times are whole
  if (!schema.time.unit && rows >= most_of_unknown && *needs.time_gap > most_of_fractions && std::isfinite(rows)) {
    return error(
        "the step and the times in column {} are in an unknown unit, which gives {:.0f} rows for each key; expected "
        "their unit; give --time-unit {} if it is {}, or --time-unit s if it is seconds",
        schema.named ? in_quotes(schema.time.name) : "1", rows,
        schema.time.epoch_unit ? row_of(*schema.time.epoch_unit).name : "ms, us or ns",
        schema.time.epoch_unit ? "this one" : "one of these");
  }
  const bool is_small = schema.time.unit && std::ranges::count(units, *schema.time.unit) > 0;
  if (!is_small || !(rows > many)) return std::nullopt;
  if (rows >= most) {
    return error(
        "the step is in {0}, as the times in column {1} are, which gives {2:.0f} rows for each key; expected a unit "
        "with such a step; give --step {3}s if it is in seconds, or --step {3}{0}",
        row_of(*schema.time.unit).name, in_quotes(schema.time.name), rows, *needs.plain_step);
  }
  return note(
      "the step is in {}, as the times in column {} are, which gives {:.0f} rows for each key; a step such as 0.1s is "
      "in seconds",
      row_of(*schema.time.unit).name, in_quotes(schema.time.name), rows);
}

/// Rates and durations are in seconds; times that count frames have none.
Found rate_of_frames(const Schema& schema, const RequestNeeds& needs) {
  if (schema.time.unit != TimeUnit::frames) return std::nullopt;
  if (needs.step && !needs.shown_rate.empty()) {
    return error(
        "the times in column {} count frames, and the step is in seconds; expected the frame rate of the times; give "
        "--input-fps {}, as the file says",
        in_quotes(schema.time.name), needs.shown_rate);
  }
  if (!needs.is_rate) return std::nullopt;
  const std::string rate =
      needs.shown_rate.empty() ? "HZ, as in --input-fps 24" : fmt::format("{}, as the file says", needs.shown_rate);
  return error(
      "the times in column {} count frames, and the rate of rows is in seconds; expected the frame rate of the times; "
      "give --input-fps {}; for a row at each frame, --step 1 takes the place of the rate",
      in_quotes(schema.time.name), rate);
}

/// A range such as 10:20:30 beside times of day.
Found range_beside_clock(const Schema& schema, const RequestNeeds& needs) {
  if (needs.range_like_clock.empty() || schema.time.notation != TimeNotation::clock) return std::nullopt;
  return error(
      "{0} may be a range, in seconds, or a time of day, as those in column {1}; expected one of the two; give {2}s "
      "for the time of day, or {0}.0 for the range",
      needs.range_like_clock, in_quotes(schema.time.name),
      whole_text(*read_time(needs.range_like_clock, TimeNotation::clock, 1, DateOrder::ymd)));
}

constexpr std::array about_requests{lengths_of_degrees,       lengths_of_space,    lengths_without_names,
                                    lengths_of_unlike_things, time_by_its_place,   rate_of_frames,
                                    seconds_of_unknown_times, step_in_small_units, range_beside_clock};

/// Appends a note, or throws the error of a doubt.
void take(std::vector<std::string>& notes, Found found) {
  if (!found) return;
  if (found->is_error) throw Error(Exit::data, found->text);
  notes.push_back(std::move(found->text));
}

}  // namespace

std::vector<std::string> doubts_of_columns(const FoundColumns& found) {
  std::vector<std::string> notes;
  for (const auto doubt : about_columns) take(notes, doubt(found));
  return notes;
}

std::string label_of_curves(const Columns& columns, std::span<const std::string> names,
                            std::span<const std::vector<std::string_view>> rows, std::span<const double> times) {
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    const Columns::Column& column = columns.cells[cell];
    if (column.role != Role::ignored || !column.is_text) continue;
    std::unordered_map<std::string_view, double> last;  // times, by the text beside them
    bool rise = true, rise_in_each = true;
    double before = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const double time = times[row];
      const auto [same, is_first] = last.emplace(cell < rows[row].size() ? rows[row][cell] : "", time);
      rise = rise && time > before;
      rise_in_each = rise_in_each && (is_first || time > same->second);
      before = same->second = time;
    }
    if (!rise && rise_in_each && last.size() > 1 && last.size() < rows.size()) return requested_as(names, cell);
  }
  return "";
}

std::vector<std::size_t> parts_of_date(std::span<const std::string> names,
                                       std::span<const std::vector<std::string_view>> rows) {
  struct Part {
    std::array<std::string_view, 4> names;
    double least, most;
  };
  constexpr std::size_t needed = 3;
  constexpr std::array<Part, 6> parts{
      Part{{"year", "yyyy", "yy", "yr"}, 0, 2100}, Part{{"month", "mo", "mm", "mon"}, 1, 12},
      Part{{"day", "dd", "dy", "da"}, 1, 31},      Part{{"hour", "hh", "hr", "hours"}, 0, 23},
      Part{{"minute", "mm", "mn", "min"}, 0, 59},  Part{{"second", "ss", "sec", "seconds"}, 0, 60}};
  std::vector<std::size_t> cells;
  for (const Part& part : parts) {
    // The minute may have the name of the month, and follows the hour.
    const std::size_t first = cells.size() <= needed ? 0 : cells.back() + 1;
    std::size_t cell = first;
    for (; cell < names.size(); ++cell) {
      std::string_view name = names[cell];
      if (name.starts_with('#')) name.remove_prefix(1);
      if (std::ranges::any_of(part.names, [&](auto known) { return same_in_any_case(name, known); })) break;
    }
    const bool fits = std::ranges::all_of(rows, [&](const auto& row) {
      const double number = cell < row.size() ? parse_number(row[cell]).value_or(-1) : -1;
      return number >= part.least && number <= part.most && (number == std::floor(number) || &part == &parts.back());
    });
    if (!fits || cell == names.size()) break;
    cells.push_back(cell);
  }
  return cells.size() >= needed ? cells : std::vector<std::size_t>();
}

std::optional<std::size_t> find_only_time(std::span<const std::string> names,
                                          std::span<const std::vector<std::string_view>> rows) {
  constexpr std::size_t enough = 3;
  const auto number = [&](std::size_t row, std::size_t cell) {
    return cell < rows[row].size() ? parse_number(rows[row][cell]).value_or(nan) : nan;
  };
  std::optional<std::size_t> found;
  for (std::size_t cell = 0; cell < names.size(); ++cell) {
    if (!names_calendar(names[cell]) && !ends_like_time(names[cell])) continue;
    if (found || rows.size() < 2) return std::nullopt;
    found = cell;
    for (std::size_t row = 1; row < std::min(rows.size(), enough); ++row) {
      if (!(number(row, cell) > number(row - 1, cell))) return std::nullopt;
    }
  }
  return found;
}

std::optional<double> first_time_gap(const FoundColumns& found) {
  const std::vector<std::size_t> cells = found.columns.time_cells();
  if (cells.size() != 1 || found.rows.size() < 2 || found.columns.has(Role::nanoseconds)) return std::nullopt;
  double first = nan, last = nan;
  std::size_t gaps = 0;  // without those between equal times
  for (const auto& row : found.rows) {
    const double time = number_in(found, row, cells[0]);
    if (!(time == std::floor(time)) || time < last) return std::nullopt;
    if (std::isnan(first)) first = time;
    if (time > last) ++gaps;
    last = time;
  }
  return gaps == 0 ? std::nullopt : std::optional((last - first) / static_cast<double>(gaps));
}

std::vector<std::string> doubts_of_request(const Schema& schema, const RequestNeeds& needs) {
  std::vector<std::string> notes;
  for (const auto doubt : about_requests) take(notes, doubt(schema, needs));
  return notes;
}

}  // namespace tcb
