// Sample columns: the columns of samples of a curve, which have the names that the program gives them.
#include "schema/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "schema/usual_names.hpp"

namespace tcb {

Columns find_sample_columns(std::span<const std::string> given, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless) {
  std::vector<std::string> header(given.begin(), given.end());
  for (const auto& [theirs, ours] : names.maps) {
    const auto found = std::ranges::find(given, theirs);
    if (found == given.end()) throw no_such_column(theirs, header).about("--map");
    header[static_cast<std::size_t>(found - given.begin())] = ours;
  }
  const std::size_t cells = numeric.size();
  std::unordered_map<std::string_view, std::size_t> named;  // how many columns have a name
  for (const std::string& name : header) ++named[name];
  std::vector<RoleRequest> requests;
  std::vector<bool> taken(cells);
  const auto request = [&](Role role, std::size_t cell) {
    taken[cell] = true;
    const bool by_name = cell < header.size() && named[header[cell]] == 1;  // as another name may be this one's number
    requests.push_back({role, {by_name ? header[cell] : fmt::format("{}", cell + 1)}});
  };
  const auto cell_where = [&](auto is_it) {  // the first one with such a name; `cells` where there is none
    return static_cast<std::size_t>(std::ranges::find_if(header, is_it) - header.begin());
  };

  std::vector<std::size_t> groups;
  for (const std::string& name : names.groups) {
    groups.push_back(header.empty() ? groups.size() : cell_where([&](const auto& other) { return other == name; }));
  }
  if (std::ranges::all_of(groups, [&](std::size_t cell) { return cell < cells; })) {
    for (const std::size_t cell : groups) request(Role::group, cell);
  }
  if (!names.times_only.empty()) {
    requests.push_back({Role::time, {names.time}, names.times_only});
    return requested_columns(header, numeric, requests);
  }
  if (header.empty()) {
    const std::size_t time = requests.size() + names.time_place;
    if (!timeless && time < cells) request(Role::time, time);
    return find_columns(header, numeric, requests, timeless);
  }
  std::size_t time = cell_where([&](const auto& name) { return name == names.time; });
  if (time == cells) time = cell_where([](const auto& name) { return role_of_name(name) == Role::time; });
  if (time == cells && named.count("s") == 0) {
    for (time = 0; time < cells && !(numeric[time] && is_usual_time(header[time])); ++time) {
    }
  }
  if (time < cells) request(Role::time, time);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const bool is_label = std::ranges::count(names.labels, header[cell]) > 0;
    if (numeric[cell] && !is_label && !taken[cell]) request(Role::position, cell);
  }
  return find_columns(header, numeric, requests, true);
}

}  // namespace tcb
